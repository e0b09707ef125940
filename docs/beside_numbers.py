"""Numbers that the texts quote of studies beside standards, rules, surveys and space: see `study_numbers`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

import stayput as sp
import studies.three_dimensions_runs as shapes
import studies.tombstones_runs as cemetery
from stayput.everyday import CARPET
from studies.ac156 import passing
from studies.ac156_runs import LONG_PERIOD_RATIO, PIECES, SLIDING_FRICTION, TESTS
from studies.consumer_centre import GAPS, agreement
from studies.consumer_centre import TESTS as SHOWN
from studies.study import listed, span
from studies.three_dimensions import (
    PLANE,
    SPACE,
    STRONGER,
    STRONGEST,
    differing,
    less_space,
    points,
    pulses,
    slide_ratio,
)
from studies.tip_over import LIGHT_CHEST
from studies.tombstones import inside
from stayput.verification.notes import LONG

if TYPE_CHECKING:
    from studies import Study

Numbers = dict[str, Any]


def ac156(study: Study, motion: sp.Motion | None) -> Numbers:
    data = study.data
    often = list(study.tables.values())[1]
    pieces = often["piece"].tolist() if len(often) else []
    by_building = passing(data, TESTS[0].name).max(("sds", "height", "piece", "floor"))
    slid, formula = data["slide"].to_numpy().ravel(), data["slide_asce43"].to_numpy().ravel()
    known = np.isfinite(formula) & (slid > 0.005)
    return {
        "pieces": ", ".join(PIECES),
        "sites": listed(data["sds"]),
        "tests": data.attrs["tests"],
        "earthquakes": data.attrs["earthquakes"],
        "long_ratio": LONG_PERIOD_RATIO,
        "cases": data["passes"].size // len(TESTS),
        "often_cases": len(often),
        "often_pieces": ", ".join(dict.fromkeys(pieces)) or "none",
        "by_building": ", ".join(
            f"{name.item()} {100 * float(value):.0f} %"
            for name, value in zip(by_building["building"], by_building, strict=True)
        ),
        "friction": SLIDING_FRICTION,
        "sliding": span(formula[known] / slid[known], ".1f"),
    }


def tip_over(study: Study, motion: sp.Motion | None) -> Numbers:
    given = sp.Everyday()
    return {
        "load": given.load,
        "share": 100.0 * given.drawer_share,
        "extension": 100.0 * given.drawer_extension,
        "pull": given.pull,
        "height": given.pull_height,
        "carpet": 1e3 * CARPET,
        "light": f"{1e3 * LIGHT_CHEST.height:g} × {1e3 * LIGHT_CHEST.width:g} mm, {LIGHT_CHEST.mass:g} kg",
    }


def tombstones(study: Study, motion: sp.Motion | None) -> Numbers:
    data = study.data
    mean = 100.0 * data["share"].mean("place")
    names_of = data["setting"].to_numpy().tolist()
    alone = mean.isel(setting=slice(1, len(names_of) - 1))
    met = inside(data).sum("level").to_numpy()[1:-1]
    best = [name for name, count in zip(names_of[1:-1], met, strict=True) if count == met.max()]
    at_6_lower = alone.sel(level="6-lower")
    return {
        "motions": data.sizes["place"],
        "stones": data.attrs["stones"],
        "widths": listed(list(cemetery.WIDTHS)),
        "aspect": cemetery.ASPECT,
        "aspect_cov": 100.0 * cemetery.ASPECT_COV,
        "static": cemetery.FRICTION[0],
        "kinetic": cemetery.FRICTION[1],
        "restitution": cemetery.RESTITUTION,
        "family": cemetery.STATED.family,
        "middles": listed(data["intensity"]),
        "alone_most": met.max(),
        "alone_best": "; ".join(best),
        "alone_6_lower": float(at_6_lower.max()),
        "alone_6_lower_of": names_of[1 + int(at_6_lower.to_numpy().argmax())],
        "together": ", ".join(f"{float(share):.0f}" for share in mean[-1]),
        "together_name": names_of[-1].removeprefix("together: "),
        "together_met": int(inside(data).sum("level")[-1]),
        "in_space": cemetery.IN_SPACE,
        **{
            key: ", ".join(f"{float(share):.0f}" for share in mean.sel(setting=setting.name))
            for key, setting in zip(("plane", "either", "space"), cemetery.IDEALS, strict=True)
        },
    }


def consumer_centre(study: Study, motion: sp.Motion | None) -> Numbers:
    data = study.data
    agrees = [100.0 * agreement(data, place) for place in range(len(SHOWN))]
    bare = agrees[0]
    return {
        "motions": data.attrs["motions"],
        "samples": data.attrs["samples"],
        "gaps": listed(100.0 * np.array([gap for gap in GAPS if gap is not None])),
        "tests": len(SHOWN),
        "bare_walls": span(bare.isel(shaking=0, gap=slice(0, -1)), ".0f"),
        "bare_free": float(bare.isel(shaking=0, gap=-1)),
        "bare_most": float(bare.max()),
        "wedge": span(agrees[1], ".0f"),
        "moved": span(agrees[2], ".0f"),
        "poles": span(agrees[3], ".0f"),
        "strongest": span(agrees[4], ".0f"),
    }


def three_dimensions(study: Study, motion: sp.Motion | None) -> Numbers:
    data = study.data
    at = {level: data.sel(level=level) for level in shapes.LEVELS}
    strongest = at[STRONGEST]
    short, square, long, round_ = (
        strongest.sel(setting=data["kind"] == kind) for kind in ("short", "square", "long", "round")
    )
    shares = 100.0 * data["overturned"].mean(("heading", "motion"))
    gas = shares.sel(setting="gas cylinder", level="5-upper")
    rubber = {
        name: strongest.sel(setting=f"{name}, rubber feet") for name in ("square cabinet", "water heater")
    }
    held = strongest.sel(setting=data["setting"].str.startswith("bookcase, wall"))
    across = {kind: pulses(data, kind).isel(heading=-1) for kind in ("short", "square", "long")}
    return {
        "motions": data.attrs["motions"],
        "families": " and ".join(shapes.FAMILIES),
        "middles": listed(data["intensity"]),
        "headings": listed(data["heading"]),
        "flooring": listed(shapes.FLOORING),
        "rubber": listed(shapes.RUBBER),
        "wall": 100.0 * shapes.GAP,
        "long_from": LONG,
        "strongest": STRONGEST,
        "differ_short": f"{100.0 * differing(short, PLANE):.0f}",
        "differ_square": f"{100.0 * differing(square, PLANE):.0f}",
        "differ_long": f"{100.0 * differing(long, PLANE):.0f}",
        "differ_round": f"{100.0 * differing(round_, PLANE):.0f}",
        "short_plane": points(less_space(short, PLANE)),
        "short_lower": points(less_space(at["6-lower"].sel(setting=data["kind"] == "short"), PLANE)),
        "square_rubber": points(less_space(rubber["square cabinet"], PLANE)),
        "square_flooring": points(less_space(strongest.sel(setting="square cabinet"), PLANE)),
        "round_plane": points(less_space(round_, PLANE)),
        "heater": points(less_space(rubber["water heater"], PLANE)),
        "gas_plane": f"{float(gas.sel(engine=PLANE)):.0f}",
        "gas_space": f"{float(gas.sel(engine=SPACE)):.0f}",
        "long_plane": points(less_space(long, PLANE)),
        "long_stronger": points(less_space(long, STRONGER)),
        "bookcase": points(less_space(at["6-lower"].sel(setting="bookcase"), PLANE)),
        "held": "; ".join(
            f"{name.removeprefix('bookcase, wall').removeprefix(', ') or 'wall alone'} "
            f"{points(less_space(held.sel(setting=name), PLANE))}"
            for name in held["setting"].to_numpy().tolist()
        ),
        "across_short": points(less_space(across["short"], PLANE)),
        "across_square": points(less_space(across["square"], PLANE)),
        "across_long": points(less_space(across["long"], PLANE)),
        "across_stronger": points(less_space(across["long"], STRONGER)),
        "slide_ratio": f"{slide_ratio(strongest.sel(setting=data['kind'] != 'limited')):.1f}",
    }
