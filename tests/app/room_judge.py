"""A verdict on a room that a test makes up, and what answers for the server with it."""

from __future__ import annotations

import base64
from contextlib import contextmanager
from dataclasses import dataclass, field
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, cast

from browsing import opened
from serving import AS_BEFORE

from stayput.app.presets import ROOM_SCENE
from stayput.simulation.space_fate import MAY_FALL_FROM, expected
from stayput.verification.room_words import tags

if TYPE_CHECKING:
    from collections.abc import Callable, Generator

    from browsing import Opened
    from playwright.sync_api import Browser, Route
    from serving import Running

    from stayput.verification.verdict import OptionVerdict

QUEUED, ROUGH, COUNTED, DONE = "queued", "rough", "counted", "done"
CELLS = (72, 54)


def chance(estimate: float, low: float | None = None, high: float | None = None) -> dict[str, float | None]:
    return {
        "estimate": estimate,
        "low": max(-1.0, estimate - 0.1) if low is None else low,
        "high": min(1.0, estimate + 0.1) if high is None else high,
    }


def zone(share: float) -> dict[str, Any]:
    nx, ny = CELLS
    cells = bytes(round(255 * share) if i < 30 and j > 30 else 0 for i in range(nx) for j in range(ny))
    return {"nx": nx, "ny": ny, "shares": base64.b64encode(cells).decode()}


def words(english: str, japanese: str) -> dict[str, str]:
    return {"en": english, "ja": japanese}


def piece(name: str, overturned: float, harm: float) -> dict[str, Any]:
    slid, spread = chance(0.2), {"median": 0.1, "p90": 0.4}
    return {
        "name": name,
        "probabilities": {"overturned": chance(overturned), "slid": slid, "device_failed": chance(0.0)},
        "peak_slide_m": spread,
        "falls": overturned >= MAY_FALL_FROM,
        "stability": expected(overturned, 1.0),
        "harm_J": harm,
        "overturned_change": None,
        "outline_m": [(0.0, 1.5), (0.3, 1.5), (0.3, 2.3), (0.0, 2.3)],
        "fell": zone(overturned),
        "stood": zone(1.0 - overturned),
    }


def change(what: str, hit: float, **more: Any) -> dict[str, Any]:
    english, japanese = more.pop("label", (f"{what} moved", f"「{what}」を移動"))
    told = {
        "what": what,
        "table": "furniture",
        "label": words(english, japanese),
        "sentence": words(
            f"With {english}, somebody is hit less often.", f"{japanese}すると、人に当たる確率が減ります。"
        ),
        "drilled": False,
        "measures": None,
        "at_m": None,
        "heading_rad": None,
        "hit": chance(hit),
        "hit_change": chance(hit - 0.8),
        "shut_in": chance(0.1),
        "shut_in_change": chance(0.0),
        "risk": hit,
        "overturned": chance(hit) if more.get("table", "furniture") == "furniture" else None,
        "overturned_change": chance(hit - 0.8) if more.get("table", "furniture") == "furniture" else None,
        "helps": hit < 0.7,
        "better": ["hit"] if hit < 0.7 else [],
        "worse": [],
        **more,
    }
    clear = cast("OptionVerdict", SimpleNamespace(better=told["better"], worse=told["worse"]))
    return {**told, "tags": [words(*tag) for tag in tags(clear)]}


def made() -> dict[str, Any]:
    """Return a verdict on the room of examples/bedroom.toml."""
    by = {
        "piece": "bookcase",
        "mass_kg": 200.0,
        "by_falling": True,
        "probability": chance(0.8),
        "speed_m_s": {"median": 5.9, "p90": 6.0},
        "energy_J": {"median": 1310.0, "p90": 1670.0},
    }
    belt = {
        "drilled": True,
        "measures": [{"type": "belt"}],
        "label": ("belts on the bookcase", "「本棚」をベルトで固定"),
    }
    return {
        "complete": True,
        "verdict": words(
            "In about 80 % of earthquakes the bookcase falls on whoever is in bed "
            "(95 % interval: 60 to 90 %).",
            "「本棚」がベッドにいる人に当たります。",
        ),
        "left_out": None,
        "best": words("Best single change: bookcase moved.", "最も効果のある変更：「本棚」を移動。"),
        "jma_intensity": 6.25,
        "intensity_class": "6-upper",
        "motions": 20,
        "whole": 40,
        "runs": 360,
        "seed": 1,
        "seconds": 1.5,
        "crushed_from_J": 79.0,
        "crushed": chance(0.7),
        "hit": chance(0.8),
        "touched": chance(0.2),
        "shut_in": chance(0.1),
        "blocked": chance(0.3),
        "risk": 0.3,
        "harm_J": 330.0,
        "places": [
            {
                "name": "bed",
                "crushed": chance(0.7),
                "hit": chance(0.8),
                "touched": chance(0.2),
                "hit_by_day": 0.0,
                "hit_at_night": 0.8,
                "shut_in": chance(0.1),
                "by": [by],
            }
        ],
        "doors": [{"name": "door", "blocked": chance(0.3), "blocked_at_rest": False}],
        "pieces": [piece("bookcase", 0.8, 300.0), piece("chest", 0.1, 30.0), piece("wardrobe", 0.0, 0.0)],
        "cell_m": 0.05,
        "changes": [
            change("bookcase", 0.1, at_m=(0.17, 0.4), heading_rad=0.0),
            change("bookcase", 0.4, **belt),
            change("bed", 0.75, table="places", at_m=(1.6, 1.26), heading_rad=0.0),
        ],
        "typical": {"motion": 4, "sample": 1},
    }


PEOPLE = (
    "crushed_from_J",
    "crushed",
    "hit",
    "touched",
    "shut_in",
    "blocked",
    "risk",
    "harm_J",
    "places",
    "doors",
)
CHANGE = "what", "table", "measures", "drilled", "at_m", "heading_rad"


def as_sent(verdict: dict[str, Any]) -> dict[str, Any]:
    """Return what a page makes of a verdict as the server sends it: an option for each change."""
    apart = *PEOPLE, "pieces", "changes", "typical", "whole"
    told = {key: value for key, value in verdict.items() if key not in apart}
    people = {key: verdict[key] for key in PEOPLE if key in verdict}
    common = {
        "grade": "C",
        "weakest": [],
        "asides": [],
        "yours": False,
        "curve": None,
        "probabilities": {},
        "typical": verdict["typical"],
    }

    def option(rank: int, change: dict[str, Any] | None) -> dict[str, Any]:
        pieces = verdict["pieces"]
        if change is None:
            label, reason, clear = words("the room as it is", "今の部屋"), words("", ""), {}
        else:
            label, reason = change["label"], change["sentence"]
            clear = {key: change[key] for key in ("better", "worse", "tags")}
            falls = {"overturned_change": change["overturned_change"]}
            pieces = [
                {
                    **one,
                    **falls,
                    "probabilities": {**one["probabilities"], "overturned": change["overturned"]},
                }
                if one["name"] == change["what"]
                else one
                for one in pieces
            ]
        then = {key: change[key] for key in change if key.removesuffix("_change") in PEOPLE} if change else {}
        return {
            **common,
            **clear,
            "rank": rank,
            "runs": verdict["whole"],
            "name": "as stated" if change is None else label["en"],
            "label": label,
            "reason": reason,
            "measures": [] if change is None else change["measures"] or [],
            "overturned_change": None if change is None else chance(0.0),
            "pieces": pieces,
            "people": {**people, **then},
            "changes": [] if change is None else [{key: change[key] for key in CHANGE}],
            "helps": change is not None and change["helps"],
        }

    options = [option(rank, change) for rank, change in enumerate([*verdict["changes"], None], 1)]
    beside: dict[str, Any] = {
        "notes": [],
        "grades": {},
        "not_possible": [],
        "estimates": None,
        "everyday": None,
    }
    return {**told, **beside, "options": options}


@dataclass
class Judge:
    """Answers for the server about rooms.

    Attributes
    ----------
    stage : str
        How far its jobs are: waiting behind two others, with few runs, with all runs of the room but no
        changes yet, or at their end.
    asked : list of dict
        What was asked, in order.
    ended : list of int
        Which of these jobs the page has ended, by their places in ``asked``.
    forgotten : int
        How many questions came before those in ``asked``.
    """

    stage: str = DONE
    asked: list[dict[str, Any]] = field(default_factory=list)
    ended: list[int] = field(default_factory=list)
    forgotten: int = 0

    def begin_anew(self) -> None:
        """Forget all that was asked but the last question."""
        self.stage, self.ended = DONE, []
        self.forgotten += len(self.asked) - 1
        del self.asked[:-1]

    @property
    def routes(self) -> dict[str, Callable[[Route], None]]:
        return {"**/api/v1/room": self._start, "**/api/v1/jobs/*": self._job}

    @property
    def scene(self) -> dict[str, Any]:
        """The room that was asked about last."""
        return self.asked[-1]["scene"]

    def _start(self, route: Route) -> None:
        self.asked.append(route.request.post_data_json)
        route.fulfill(status=202, json=self._reply(len(self.asked) - 1, QUEUED))

    def _job(self, route: Route) -> None:
        place = max(0, int(route.request.url.rsplit("/", 1)[1], 16) - self.forgotten)
        if route.request.method == "DELETE":
            self.ended.append(place)
        route.fulfill(json=self._reply(place, self.stage))

    def _reply(self, place: int, stage: str) -> dict[str, Any]:
        verdict = made()
        if not self.asked[place]["changes"]:
            verdict["changes"] = []
        counted = {**verdict, "complete": False}
        rough = {**counted, "changes": [], "whole": 20, "runs": 24}
        results = {QUEUED: None, ROUGH: rough, COUNTED: counted, DONE: verdict}
        result = results[stage]
        return {
            "id": f"{place + self.forgotten:032x}",
            "state": {QUEUED: "waiting", ROUGH: "running", COUNTED: "running", DONE: "done"}[stage],
            "done": {QUEUED: 0, ROUGH: 24, COUNTED: 48, DONE: 360}[stage],
            "total": 360,
            "progress": {QUEUED: 0.0, ROUGH: 0.2, COUNTED: 0.4, DONE: 1.0}[stage],
            "seconds": 1.5,
            "position": 2 if stage == QUEUED else None,
            "error": None,
            "result": None if result is None else as_sent(result),
        }


@contextmanager
def room_page(
    browser: Browser, server: Running, judge: Judge, address: str = "", **more: Any
) -> Generator[Opened]:
    """Open the page of a room, about which the judge answers."""
    usual = {"routes": judge.routes, "headers": {AS_BEFORE: "1"}}
    with opened(browser, server, f"room/{address}", **usual, **more) as it:
        judged(it)
        yield it


ANEW = """async (first) => {
  const [room, scenes, screens] = await Promise.all(
    ["room/room", "room/scenes", "screens"].map((name) => import(`/${name}.js`)));
  localStorage.clear();
  sessionStorage.clear();
  scenes.leave();
  scenes.list();
  screens.goTo("scene", false);
  room.replace(first);
  for (let frame = 0; frame < 2; frame++) await new Promise(requestAnimationFrame);
}"""


def begin_anew(it: Opened, judge: Judge) -> None:
    """Put the room that the server proposes into the page as if it had just been opened."""
    judge.stage = DONE
    if it.page.get_attribute("html", "lang") != "en":
        it.speak("en")
    it.page.evaluate(ANEW, ROOM_SCENE)
    it.settle()
    judged(it)
    judge.begin_anew()


def judged(it: Opened) -> None:
    """Wait until the verdict is that on the room as it stands."""
    it.page.wait_for_selector("#answer[data-state=done][data-old=false]", state="attached")


def after(it: Opened, judge: Judge, act: Any) -> dict[str, Any]:
    """Do something that changes the room, and return the room that is asked about then."""
    before = len(judge.asked)
    act()
    it.wait("() => document.getElementById('answer').dataset.old === 'true'")
    judged(it)
    assert len(judge.asked) > before
    return judge.scene


IN_ADDRESS = """async ([table, wanted]) => {
  const { unpacked } = await import("/packing.js"), letters = /room=([^&]*)/.exec(location.hash)?.[1];
  return letters && JSON.stringify(JSON.parse(await unpacked(letters))[table]) === JSON.stringify(wanted);
}"""


def in_address(it: Opened, table: str, wanted: object) -> None:
    """Wait until the room in the page's address has this table: it is written a little later."""
    it.wait(IN_ADDRESS, [table, wanted])


def place_of(room: dict[str, Any], name: str) -> dict[str, Any]:
    (piece,) = (one for one in room["furniture"] if one["name"] == name)
    return {key: piece[key] for key in ("against", "along")}
