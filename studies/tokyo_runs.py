"""Runs of the Tokyo study: furniture, devices and motions as published in 2015, or as stated here.

Tokyo Metropolitan Government, product test of devices against overturning, 2015: furniture on flooring on a
shaking table under JMA Kobe of 1995, three components, at 100 % and at 60 %. Seven devices were tested alone,
and a stopper together with a pole. What is used here is the published summary; the products, which piece each
device held, which way the pieces faced and how far the wall was are not part of it.

The devices are measures with values over the ranges of the literature, since the products' own values are
not published. A pad's sides and thickness, a wedge's thickness, a pole's preload and what the ceiling bears
go over the usual ranges (defaults, low confidence): nothing is fitted to the test.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from stayput.measures import GelMats, TensionPole, WedgeStopper
from stayput.model.body import Body
from stayput.model.gravity import STANDARD_GRAVITY
from stayput.model.room import Ceiling, Floor, Room, Wall
from stayput.montecarlo.hazard import FloorMotions
from stayput.montecarlo.runs import run_level
from stayput.montecarlo.sampling import draws, rows_of
from stayput.verification import Option

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import NDArray

    from stayput.montecarlo.runs import Runs
    from stayput.motion import Motion

BODIES = {"chest": Body(0.42, 1.365, 81.3), "cupboard": Body(0.40, 1.80, 100.4)}
"""The furniture of the test: a chest of drawers (tansu) and a cupboard; width is its depth."""

LEVELS = (1.0, 0.6)
"""Factors on the record."""

FLOORING = "wood flooring"
"""The floor, of which the friction is a default."""

ROOM = Room(Floor.of(FLOORING), left_wall=Wall(0.02), ceiling=Ceiling(2.4))
"""The room: distance to the wall and height of the ceiling are ours."""

FAR, SOME = 0.30, 0.10
"""Movements that the published result tells apart [m]."""


def _mats(side: float, thickness: float) -> Option:
    name = f"mats {1e3 * side:g} × {1e3 * side:g} × {1e3 * thickness:g} mm"
    return Option(name, (GelMats(area=side * side, thickness=thickness),))


def _stopper(thickness: float) -> Option:
    return Option(f"stopper {1e3 * thickness:g} mm", (WedgeStopper(thickness=thickness),))


def _poles(preload: float, strength: float) -> Option:
    name = f"poles {preload:g} N, ceiling {strength:g} N"
    return Option(name, (TensionPole(preload=preload, strength=strength),))


def _both(stopper: Option, poles: Option) -> Option:
    return Option(f"{stopper.name} + {poles.name}", stopper.measures + poles.measures)


NO_DEVICE = Option("no device")

MATS = (_mats(0.03, 0.003), _mats(0.04, 0.004), _mats(0.05, 0.005))
"""Four pads each; 100 kPa in tension and 50 kPa in shear on the label, of which 0.7 are reached."""

STOPPERS = (_stopper(0.005), _stopper(0.010))
"""About 0.7° and 1.4° of tilt for a cupboard."""

POLES = (_poles(100.0, 300.0), _poles(200.0, 1000.0))
"""Two poles each: the lower and the upper ends of the usual preload and of what a ceiling bears."""

ALONE = (*MATS, *STOPPERS, *POLES)
"""The seven devices that are tested alone."""

TOGETHER = tuple(_both(stopper, poles) for stopper in STOPPERS for poles in POLES)
"""A stopper with poles."""

OPTIONS = (NO_DEVICE, *ALONE, *TOGETHER)
"""All that is run."""

PIECE = "cupboard"
"""The piece that is varied."""

PROBES = (
    NO_DEVICE,
    MATS[1],
    STOPPERS[0],
    POLES[0],
    _both(STOPPERS[0], POLES[0]),
)
"""One device of each kind, the weaker stopper and poles, and these two together."""


def facings(motion: Motion) -> dict[str, Motion]:
    """Return the motion as a piece feels it that faces +x, −x and, where there is a y, +y and −y."""
    by_facing = {"+x": motion, "−x": motion.flipped()}
    if motion.y is not None:
        by_facing |= {"+y": motion.rotated(math.pi / 2.0), "−y": motion.rotated(-math.pi / 2.0)}
    return by_facing


def runs_of(
    body: Body,
    room: Room,
    options: Sequence[Option],
    motions: Sequence[Motion],
    level: float,
    samples: int,
    seed: int,
) -> list[Runs]:
    """Run all options at a level, under the same draws of the uncertain quantities."""
    drawn = draws(len(motions), samples, seed)
    rows = [rows_of(body, room, option.measures, drawn, STANDARD_GRAVITY) for option in options]
    return run_level(rows, FloorMotions(tuple(motions), np.full(len(motions), level), {}))


QUANTITIES: dict[str, tuple[Callable[[Runs], NDArray[np.generic]], dict[str, str]]] = {
    "overturned": (lambda runs: runs.overturned, {"long_name": "whether it turns over"}),
    "given_up": (lambda runs: runs.missing, {"long_name": "whether the run was given up"}),
    "device_failed": (lambda runs: runs.device_failed, {"long_name": "whether a device failed"}),
    "peak_slide": (lambda runs: runs.slide, {"units": "m", "long_name": "largest magnitude of the slide"}),
    "peak_tilt": (lambda runs: runs.tilt, {"units": "rad", "long_name": "largest magnitude of the tilt"}),
}
"""Results of the runs that the study keeps."""


def tested(
    motion: Motion, options: Sequence[Option], samples: int, seed: int, advance: Callable[[int], None]
) -> xr.Dataset:
    """Run the furniture of the test with each option, in each direction, at each level.

    Returns
    -------
    xarray.Dataset
        Over ``body``, ``level``, ``device``, ``facing`` and ``sample``: `QUANTITIES`.
    """
    by_facing = facings(motion)
    over = ("body", "level", "device", "facing", "sample")
    by_body: list[list[list[Runs]]] = []
    for body in BODIES.values():
        by_level: list[list[Runs]] = []
        for level in LEVELS:
            by_level.append(runs_of(body, ROOM, options, tuple(by_facing.values()), level, samples, seed))
            advance(len(options) * len(by_facing) * samples)
        by_body.append(by_level)
    return xr.Dataset(
        {
            name: (over, np.array([[[values_of(r) for r in row] for row in rows] for rows in by_body]), about)
            for name, (values_of, about) in QUANTITIES.items()
        },
        {
            "body": list(BODIES),
            "level": ("level", list(LEVELS), {"long_name": "factor on the record"}),
            "device": [option.name for option in options],
            "facing": list(by_facing),
        },
    )


def shares(runs: xr.Dataset) -> xr.Dataset:
    """Return shares of the draws in each facing, of those not given up.

    Returns
    -------
    xarray.Dataset
        Over ``body``, ``level``, ``device`` and ``facing``: ``overturned``; of those that stand, ``far`` that
        move 30 cm or more, ``some`` 10 to 30 cm and ``little`` less; ``failed``: overturned or far.
    """
    known = ~runs["given_up"]
    stands, slide = ~runs["overturned"], runs["peak_slide"]
    kinds = {
        "overturned": runs["overturned"],
        "far": stands & (slide >= FAR),
        "some": stands & (slide >= SOME) & (slide < FAR),
        "little": stands & (slide < SOME),
    }
    means = xr.Dataset({name: kind.where(known).mean("sample") for name, kind in kinds.items()})
    return means.assign(failed=means["overturned"] + means["far"])


def severest(outcomes: xr.Dataset, alone: Sequence[str]) -> str:
    """Return the facing in which most overturn, over both pieces and all devices alone at the first level."""
    mean = outcomes["overturned"].sel(device=list(alone)).isel(level=0).mean(("body", "device"))
    return str(mean["facing"].to_numpy()[int(np.argmax(mean.to_numpy()))])


@dataclass(frozen=True, slots=True)
class Variation:
    """A change of the stated conditions.

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
        measures = (replace(item, **self.changes.get(item.kind, {})) for item in option.measures)
        return Option(option.name, tuple(measures))

    def touches(self, option: Option) -> bool:
        """Whether the option is another than as stated."""
        return not self.changes or any(measure.kind in self.changes for measure in option.measures)


_WOOD = ROOM.floor.static_friction, ROOM.floor.kinetic_friction


def _floor(static: float) -> Room:
    kinetic = static * _WOOD[1] / _WOOD[0]
    return replace(ROOM, floor=Floor(static, kinetic))


def _wall(gap: float | None) -> Room:
    return replace(ROOM, left_wall=None if gap is None else Wall(gap))


def _pole(name: str, **values: float) -> Variation:
    return Variation(name, changes={"tension_pole": values})


def _mats_with(name: str, **values: float | None) -> Variation:
    return Variation(name, changes={"gel_mats": values})


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
    _pole("poles: pads of 25 cm, which do not lean", pad=0.25),
    _pole("poles: at the front edge", setback=BODIES[PIECE].width - 0.05),
    _pole("poles: one, 50 N, ceiling bears 150 N", count=1, preload=50.0, strength=150.0),
    _mats_with("mats: as large as the label asks for", area=None),
    _mats_with("mats: 0.35 of the label, not 0.7", realism=0.35),
    _mats_with("mats: all of the label", realism=1.0),
)
"""All changes, the first none."""


def varied(
    motion: Motion,
    variations: Sequence[Variation],
    samples: int,
    seed: int,
    advance: Callable[[int], None],
) -> xr.Dataset:
    """Return the shares that overturn under each variation; NaN where it does not touch the device.

    Returns
    -------
    xarray.Dataset
        ``overturned`` over ``variation``, ``level``, ``device`` and ``facing``.
    """
    by_facing = facings(motion)
    share = np.full((len(variations), len(LEVELS), len(PROBES), len(by_facing)), np.nan)
    for v, variation in enumerate(variations):
        motions = [motion if variation.vertical else replace(motion, z=None) for motion in by_facing.values()]
        touched = [p for p, option in enumerate(PROBES) if variation.touches(option)]
        options = [variation.of(PROBES[p]) for p in touched]
        for at, level in enumerate(LEVELS):
            runs = runs_of(BODIES[PIECE], variation.room, options, motions, level, samples, seed)
            for p, of_probe in zip(touched, runs, strict=True):
                known = ~of_probe.missing
                counts = (of_probe.overturned & known).sum(axis=1)
                share[v, at, p] = counts / np.maximum(known.sum(axis=1), 1)
            advance(len(options) * len(by_facing) * samples)
    over = ("variation", "level", "probe", "facing")
    about = {"long_name": f"share of the draws in which the {PIECE} turns over"}
    return xr.Dataset(
        {"overturned": (over, share, about)},
        {
            "variation": [variation.name for variation in variations],
            "level": list(LEVELS),
            "probe": [option.name for option in PROBES],
            "facing": list(by_facing),
        },
    )
