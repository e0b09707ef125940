"""A page's modules as one script: in order of import, each once; what cannot be joined is refused."""

from __future__ import annotations

import pytest

from stayput.app.bundle import bundled, page_with

FILES = {
    "main.js": """\
// The page.
import * as dom from "./dom.js";
import {
  add as plus,
  Count,
} from "./lib/sum.js";
import "./lib/side.js";
/** Says
 * something. */
export function say() {
  return plus(dom.one, new Count().two); // not "import" at all
}
""",
    "dom.js": "export const one = 1;\nconst own = 3;\nexport { own, own as mine };\n",
    "lib/sum.js": """\
import { one } from "../dom.js";
export async function add(a, b) { return a + b + one; }
export class Count { two = 2; }
""",
    "lib/side.js": "globalThis.side = true;\n",
    "room/main.js": 'import { one } from "../dom.js";\nexport const two = 2 * one;\n',
}


def test_each_module_is_there_once_after_those_that_it_imports() -> None:
    text = bundled(FILES, "main.js")
    places = [text.index(f"const {name} =") for name in ("$dom", "$lib_sum", "$lib_side", "$main")]
    assert places == sorted(places)
    assert text.count("const one = 1;") == 1
    assert "const dom = $dom;" in text
    assert "const { add: plus, Count } = $lib_sum;" in text
    assert "return { one, own, mine: own };" in text
    assert "return { add, Count };" in text
    assert 'not "import" at all' in text  # a comment behind code stays
    assert "The page." not in text
    assert "Says" not in text


def test_any_module_can_be_the_page_s_own() -> None:
    assert bundled(FILES, "room/main.js").count("const $") == 2


@pytest.mark.parametrize(
    ("module", "why"),
    [
        ('import { two } from "./dom.js";', "does not export"),
        ('import sum from "./lib/sum.js";', "cannot be bundled"),
        ('import { one } from "./nowhere.js";', "main.js imports nowhere.js"),
        ('import { say } from "./main.js";', "main.js imports main.js"),
        ("export let changes = 1;", "cannot be bundled"),
        ('export * from "./dom.js";', "cannot be bundled"),
        ("export default 1;", "cannot be bundled"),
        ('const later = () => import("./dom.js");', "cannot be bundled"),
        ("const here = import.meta.url;", "cannot be bundled"),
    ],
)
def test_what_cannot_be_joined_is_refused(module: str, why: str) -> None:
    with pytest.raises(ValueError, match=why):
        bundled({**FILES, "main.js": module}, "main.js")


def test_a_page_has_its_styles_its_words_and_one_script() -> None:
    html = """<html lang="en">
<link rel="stylesheet" href="../style.css">
<link rel="stylesheet" href="room.css">
<link rel="modulepreload" href="../api.js">
<script type="module" src="main.js"></script>
<h1 class="top" data-t="claim">Will it stay?</h1><p data-t="empty"></p><p>as it is</p>
"""
    files = {"style.css": "a {}\n", "room/room.css": "b {}\n"}
    words = {"claim": "Bleibt <es>?", "empty": "leer & voll"}
    page = page_with(html, files, "room", "../room-1.js", "de", words)
    assert (
        page
        == """<html lang="de">
<style>
a {}

b {}
</style>
<script type="module" src="../room-1.js"></script>
<h1 class="top" data-t="claim">Bleibt &lt;es&gt;?</h1><p data-t="empty">leer &amp; voll</p><p>as it is</p>
"""
    )
