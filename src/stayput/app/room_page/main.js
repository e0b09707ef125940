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
  replace(presets.room_scene ?? UNTIL);
  document.documentElement.dataset.ready = "true";
}

const UNTIL = {
  plan: { width: 3.6, length: 2.7 },
  furniture: [
    { name: "bookcase", preset: "bookcase", against: "left_wall", along: 1.9 },
    { name: "wardrobe", preset: "wardrobe", against: "far_side_wall", along: 2.9 },
    { name: "chest", preset: "chest", against: "near_side_wall", along: 1.6 },
  ],
  places: [{ kind: "bed", at: [1.4, 1.9], heading: Math.PI / 2, night: 1 }],
  doors: [{ wall: "right_wall", start: 0.3, width: 0.8, opens: "inwards" }],
  windows: [{ wall: "far_side_wall", start: 0.5, width: 1.6 }],
  room: { floor: "wood flooring", ceiling: { height: 2.4 } },
  shaking: { intensity: "6-upper", suite: { family: "mixed", count: 20 } },
  uncertainty: { samples: 40 },
};

begin();
