"""Which of the stated values decides: one is changed at a time."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from stayput.room import Floor, Room, Wall
from stayput.studies.tokyo.devices import MATS, NOTHING, POLES, STOPPERS
from stayput.studies.tokyo.published import BODIES, LEVELS, ROOM
from stayput.studies.tokyo.runs import facings, runs_of
from stayput.verification import Option

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from stayput.motion import Motion

PIECE = "cupboard"
"""The piece that is varied."""

PROBES = (
    NOTHING,
    MATS[1],
    STOPPERS[0],
    POLES[0],
    Option(f"{STOPPERS[0].name} + {POLES[0].name}", STOPPERS[0].measures + POLES[0].measures),
)
"""One device of each kind, the weaker stopper and poles, and these two together."""


@dataclass(frozen=True, slots=True)
class Variation:
    """One change.

    Parameters
    ----------
    name : str
        What is changed.
    room : Room
        The room.
    changes : dict
        Parameters of measures by their kind.
    vertical : bool
        Whether the vertical motion acts.
    """

    name: str
    room: Room = ROOM
    changes: dict[str, dict[str, Any]] = field(default_factory=dict[str, dict[str, Any]])
    vertical: bool = True

    def of(self, option: Option) -> Option:
        """Return an option with its measures changed."""
        measures = (replace(one, **self.changes.get(one.kind, {})) for one in option.measures)
        return Option(option.name, tuple(measures))

    def touches(self, option: Option) -> bool:
        """Whether the option is another than as stated."""
        return not self.changes or any(measure.kind in self.changes for measure in option.measures)


def _floor(static: float) -> Room:
    kinetic = static * ROOM.floor.kinetic_friction / ROOM.floor.static_friction
    return replace(ROOM, floor=Floor(static, kinetic))


def _wall(gap: float | None) -> Room:
    return replace(ROOM, left_wall=None if gap is None else Wall(gap))


def _pole(name: str, **values: float) -> Variation:
    return Variation(name, changes={"tension_pole": values})


VARIATIONS = (
    Variation("as stated"),
    Variation("no vertical motion", vertical=False),
    Variation("touching the wall", room=_wall(0.0)),
    Variation("5 cm from the wall", room=_wall(0.05)),
    Variation("10 cm from the wall", room=_wall(0.10)),
    Variation("no wall", room=_wall(None)),
    Variation("floor's friction 0.3", room=_floor(0.3)),
    Variation("floor's friction 0.6", room=_floor(0.6)),
    _pole("poles: preload 20 N", preload=20.0),
    _pole("poles: preload 200 N", preload=200.0),
    _pole("poles: ceiling bears 150 N", strength=150.0),
    _pole("poles: ceiling bears 1000 N", strength=1000.0),
    _pole("poles: one, not two", count=1),
    _pole("poles: 10 kN/m, not 40", stiffness=10e3),
    _pole("poles: friction 0.2 on the ceiling", friction=0.2),
    _pole("poles: at the front edge", setback=BODIES[PIECE].width - 0.05),
    _pole("poles: one, 50 N, ceiling bears 150 N", count=1, preload=50.0, strength=150.0),
    Variation(
        "mats: they slide like wood",
        changes={
            "gel_mats": {
                "static_friction": ROOM.floor.static_friction,
                "kinetic_friction": ROOM.floor.kinetic_friction,
            }
        },
    ),
    Variation("mats: 0.35 of the label, not 0.7", changes={"gel_mats": {"realism": 0.35}}),
    Variation("mats: all of the label", changes={"gel_mats": {"realism": 1.0}}),
)
"""All changes, the first none."""


def varied(
    motion: Motion,
    variations: Sequence[Variation],
    samples: int,
    seed: int,
    tell: Callable[[int], None],
) -> xr.Dataset:
    """Return the shares that overturn under each variation; NaN where it does not touch the device.

    Returns
    -------
    xarray.Dataset
        ``overturned`` over ``variation``, ``level``, ``device`` and ``facing``.
    """
    felt = facings(motion)
    found = np.full((len(variations), len(LEVELS), len(PROBES), len(felt)), np.nan)
    for v, variation in enumerate(variations):
        motions = [one if variation.vertical else replace(one, z=None) for one in felt.values()]
        touched = [p for p, option in enumerate(PROBES) if variation.touches(option)]
        options = [variation.of(PROBES[p]) for p in touched]
        for at, level in enumerate(LEVELS):
            runs = runs_of(BODIES[PIECE], variation.room, options, motions, level, samples, seed)
            for p, one in zip(touched, runs, strict=True):
                known = ~one.missing
                found[v, at, p] = (one.overturned & known).sum(axis=1) / np.maximum(known.sum(axis=1), 1)
            tell(len(options) * len(felt) * samples)
    return xr.Dataset(
        {
            "overturned": (
                ("variation", "level", "probe", "facing"),
                found,
                {"long_name": f"share of the draws in which the {PIECE} turns over"},
            )
        },
        {
            "variation": [variation.name for variation in variations],
            "level": list(LEVELS),
            "probe": [option.name for option in PROBES],
            "facing": list(felt),
        },
    )
