"""A scene as a program in Python that gives the numbers of the page, to the bit."""

from __future__ import annotations

from typing import TYPE_CHECKING

from stayput.app.running import own_measures
from stayput.scenario import AssemblyScenario
from stayput.scenario.room import RoomScenario

if TYPE_CHECKING:
    from stayput.scenario import Scenario

_ONE = '''\
"""A piece of furniture in an earthquake, as on the page of stayput {version}: the same numbers to the bit."""

import tomllib

import stayput as sp

{note}scenario = sp.Scenario.parse(tomllib.loads("""
{toml}"""))

without = scenario.case().run()
print("without measures:", without.outcome.value)
{held}
# How likely that is: many earthquakes and samples of what is not known, as in "Understand it".
verdict = sp.verify(scenario, levels=[], progress=False)
for option in verdict.options:
    chance = option.probabilities["overturned"]
    print(option.option.name, chance.estimate, chance.low, chance.high)
'''

_HELD = """
held = scenario.case(scenario.measures[0].measures).run()
print("with the measures:", held.outcome.value)
"""

_SEVERAL = '''\
"""Pieces in an earthquake, as on the page of stayput {version}: the same numbers to the bit."""

import tomllib

import stayput as sp

{note}scenario = sp.AssemblyScenario.parse(tomllib.loads("""
{toml}"""))

run = scenario.run()
print(run.outcome.value)
'''

_ROOM = '''\
"""A room in an earthquake, as on the page of stayput {version}: the same numbers to the bit."""

import tomllib

import stayput as sp

{note}scenario = sp.RoomScenario.parse(tomllib.loads("""
{toml}"""))

# As in "See it": one of the earthquakes, all as the scenario says.
run = scenario.run()
print(run.outcome.value)

# As in "What to do": many earthquakes and samples of what is not known.
verdict = sp.verify_room(scenario, progress=False)
print(verdict.sentence())
for place in verdict.places:
    print(place.place.name, place.hit.estimate, place.hit.low, place.hit.high)
for one in verdict.changes:
    print(verdict.label(one))
    print("  somebody is hit:", one.hit.estimate, one.hit.low, one.hit.high)
    print("  somebody is shut in:", one.shut_in.estimate, one.shut_in.low, one.shut_in.high)
    own = verdict.piece_changed(one)
    if own is not None:
        print("  the piece overturns:", own[0].estimate, own[0].low, own[0].high)
'''


def scene_python(scenario: Scenario | AssemblyScenario, toml: str, version: str) -> str:
    """Return the program.

    Parameters
    ----------
    scenario : Scenario or AssemblyScenario
        The scene, of a room too.
    toml : str
        Its scenario file, with a comment before it where a record's file must stand beside it.
    version : str
        The version of stayput.
    """
    comments = [line for line in toml.splitlines() if line.startswith("#")]
    table = toml.removeprefix("".join(f"{line}\n" for line in comments))
    parts = {
        "version": version,
        "note": "".join(f"{line}\n" for line in comments),
        "toml": table.replace("\\", "\\\\").replace('"""', '\\"\\"\\"'),
    }
    if isinstance(scenario, RoomScenario):
        return _ROOM.format(**parts)
    if isinstance(scenario, AssemblyScenario):
        return _SEVERAL.format(**parts)
    return _ONE.format(**parts, held=_HELD if own_measures(scenario) else "")
