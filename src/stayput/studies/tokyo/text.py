"""What the study of the Tokyo test found, in words."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from stayput.studies.tokyo.devices import ALONE, MATS, POLES, STOPPERS, TOGETHER
from stayput.studies.tokyo.published import BODIES, FLOORING, LEVELS, ROOM
from stayput.studies.tokyo.tables import names
from stayput.studies.tokyo.variations import PIECE

if TYPE_CHECKING:
    import xarray as xr

    from stayput.motion import Motion
    from stayput.studies.tokyo.tables import Claim


def text_of(
    motion: Motion, runs: xr.Dataset, found: xr.Dataset, facing: str, said: list[Claim], varied: xr.Dataset
) -> str:
    """Return the study's paragraphs.

    Parameters
    ----------
    motion : Motion
        The record.
    runs, found, varied : xarray.Dataset
        The runs, their shares, and the shares of the variations.
    facing : str
        The severest facing.
    said : list of Claim
        The published results beside ours.
    """
    parts = [_what_was_done(motion, runs), _what_is_unknown(runs), _compared(motion, facing, said)]
    parts += [_order(found), _directions(found)]
    if varied.sizes["variation"] > 1:
        parts.append(_what_decides(varied))
    return "\n\n".join((*parts, _why()))


def _what_was_done(motion: Motion, runs: xr.Dataset) -> str:
    pieces = " and ".join(
        f"a {name} ({1e3 * body.height:g} mm high, {1e3 * body.width:g} mm deep, {body.mass:g} kg)"
        for name, body in BODIES.items()
    )
    synthetic = " (synthetic)" if motion.synthetic else ""
    acting = "with its vertical component" if motion.z is not None else "without a vertical component"
    levels = " and ".join(
        f"{100 * level:g} % (JMA intensity {motion.scaled(level).intensity:.1f})" for level in LEVELS
    )
    return (
        f"The Tokyo Metropolitan Government shook {pieces} on flooring in 2015 under the record of JMA Kobe "
        "of 1995, at 100 % and 60 %, with seven devices alone and with a stopper and a pole. Here the motion "
        f"is “{motion.name}”{synthetic}, {motion.duration:g} s, peaks {motion.pga:.3g} m/s² and "
        f"{100 * motion.pgv:.3g} cm/s along x, {acting}, at {levels}. The model is planar: it has the "
        "component along the depth of the piece and the vertical one; the intensity is that of all that are "
        f"given. Each device is run {runs.sizes['sample']} times a facing, with the common draws of "
        "friction, restitution, mass, height of the centre of gravity and strength of the devices, so that a "
        "share stands beside each published outcome."
    )


def _what_is_unknown(runs: xr.Dataset) -> str:
    floor, wall, ceiling = ROOM.floor, ROOM.left_wall, ROOM.ceiling
    assert wall is not None
    assert ceiling is not None
    facings = ", ".join(runs["facing"].to_numpy().tolist())
    return (
        "The products' properties, which device held which piece, which way it faced, its distance to a wall "
        "and the ceiling's strength are not published in what is used here. Stated: "
        f"{FLOORING} of friction {floor.static_friction:g} and {floor.kinetic_friction:g}, a wall "
        f"{100 * wall.gap:g} cm behind, a rigid ceiling at {ceiling.height:g} m; both pieces with every "
        f"device; the facings {facings} (+x: the record's x points from the wall into the room); devices "
        "over the usual ranges, in the last table. None was fitted to the outcome."
    )


def _compared(motion: Motion, facing: str, said: list[Claim]) -> str:
    verdicts = [claim.verdict for claim in said]
    counts = ", ".join(f"{verdicts.count(word)} {word}" for word in ("yes", "partly", "no"))
    kobe = (
        ""
        if "kobe" in motion.name.lower() or "kobe" in motion.source.lower()
        else " The published outcomes belong to JMA Kobe: beside another motion they stand for orientation."
    )
    parts = [
        f"At {100 * claim.level:g} %, published: {claim.published}. Ours: {claim.ours}. Comes out: "
        f"{claim.verdict}."
        for claim in said
    ]
    return (
        f"The published outcomes beside ours, in the facing {facing}, in which most overturn ({counts})."
        f"{kobe} {' '.join(parts)}"
    )


def _order(found: xr.Dataset) -> str:
    kinds = {"a stopper with poles": TOGETHER, "poles": POLES, "stoppers": STOPPERS, "mats": MATS}
    parts: list[str] = []
    for level in LEVELS:
        failed = found["failed"].sel(level=level).mean(("body", "facing"))
        share = {name: float(failed.sel(device=names(options)).mean()) for name, options in kinds.items()}
        ordered = sorted(share, key=lambda name: share[name])
        told = ", ".join(f"{name} ({100 * share[name]:.1f} %)" for name in ordered)
        parts.append(f"at {100 * level:g} % {told}")
    return (
        "The order of the kinds, by the share that overturns or moves 30 cm or more, over both pieces and "
        f"all facings, the best first: {'; '.join(parts)}. The Tokyo Fire Department ranks a pole with a "
        "stopper before a pole alone, and that before a stopper or a mat alone."
    )


def _directions(found: xr.Dataset) -> str:
    alone = found["overturned"].sel(device=names(ALONE), level=LEVELS[0]).mean(("device", "body"))
    told = ", ".join(
        f"{name} {100 * float(alone.sel(facing=name)):.0f} %" for name in alone["facing"].to_numpy()
    )
    return (
        f"With a device alone at {100 * LEVELS[0]:g} %, these shares overturn by facing: {told}. With a wall "
        "behind, the sense of the record's pulses matters, and so does the distance to the wall."
    )


def _what_decides(varied: xr.Dataset) -> str:
    mean = 100.0 * varied["overturned"].mean("facing")
    parts: list[str] = []
    for probe in mean["probe"].to_numpy():
        one = mean.sel(probe=probe, level=LEVELS[0]).to_numpy()
        known = np.flatnonzero(~np.isnan(one))
        low, high = known[one[known].argmin()], known[one[known].argmax()]
        label = mean["variation"].to_numpy()
        parts.append(
            f"{probe}: {one[0]:.0f} % as stated, {one[low]:.0f} % ({label[low]}) to {one[high]:.0f} % "
            f"({label[high]})"
        )
    poles = mean.sel(probe=names(POLES)[0], level=LEVELS[1]).to_numpy()
    most = int(np.nanargmax(poles))
    reduced = (
        f"With poles at 60 % no change overturns the {PIECE}"
        if float(poles[most]) == 0.0
        else f"With poles at 60 % the largest share is {poles[most]:.0f} % "
        f"({mean['variation'].to_numpy()[most]})"
    )
    return (
        f"What decides, by changing one stated value at a time for the {PIECE} at 100 %, over all facings: "
        f"{'; '.join(parts)}. {reduced}."
    )


def _why() -> str:
    return (
        "Where it does not come out, these are known to be missing: the test is three-dimensional (a piece "
        "also turns and rocks over a corner, and two components act at once), drawers and doors open, "
        "carcasses and ceilings are soft, poles stand on boards that bend and can shift sideways, and a "
        "stopper can be left behind by a piece that lifts. In the model a stopper stays under the edge, "
        "poles share their load, and torn mats keep the friction of rubber, so that a piece on them rocks "
        "where one in the test slid."
    )
