// The page of a room.

import * as api from "../api.js";
import { patiently } from "../connection.js";
import { part } from "../dom.js";
import { recalled } from "../memory.js";
import { preferredLanguage, speak } from "../words.js";
import * as editor from "./editor.js";
import { replace } from "./room.js";

async function begin() {
  speak(recalled("language") ?? preferredLanguage());
  const presets = await patiently(api.presets);
  editor.build(part("editor"), presets);
  replace(presets.room_scene);
  document.documentElement.dataset.ready = "true";
}

begin();
