"""A verdict made by hand, without a run, for the tests of what is written of a verdict."""

from dataclasses import replace
from functools import cache

import numpy as np

import stayput as sp
from stayput.fragility.curve import FragilityCurve
from stayput.fragility.intensity_measures import INTENSITY_MEASURES
from stayput.fragility.paired import difference
from stayput.fragility.probabilities import probability
from stayput.fragility.trials import Trials
from stayput.measures import Belt, FeltGlides
from stayput.montecarlo.counting import EVENTS, Member, Quantiles
from stayput.report.verdict.html import report_html
from stayput.scenario.measures import Option
from stayput.simulation.space_fate import expected
from stayput.standards.equipment import equipment_loads
from stayput.verification.notes import Ac156Estimate, Estimates, SlidingShare
from stayput.verification.verdict import DeviceSummary, OptionVerdict, PieceVerdict, Verdict

SCENARIO = {
    "title": "Study",
    "furniture": {"preset": "bookcase"},
    "room": {"floor": "wood flooring", "left_wall": {"gap": 0.02}, "ceiling": {"height": 2.4}},
    "shaking": {"builtin": "near-fault", "scale": 0.6},
}
MOTIONS, SAMPLES = 10, 8
LEVELS = np.linspace(5.0, 7.0, 9)


def shares(share, seed=0):
    """Return whether it happened, run by run: in about this share of them."""
    return np.random.default_rng(seed).random((MOTIONS, SAMPLES)) < share


def curves(name, middle):
    """Return a curve over every measure; with no middle, of runs of which none fell."""
    found = {}
    for n, measure in enumerate(INTENSITY_MEASURES.values()):
        im = np.repeat(LEVELS[:, None], MOTIONS, axis=1)
        values = im if measure.is_logarithm else 10.0 ** (0.5 * im - 3.0 + 0.01 * n)
        chance = np.zeros_like(im) if middle is None else 1.0 / (1.0 + np.exp(-6.0 * (im - middle)))
        fallen = np.random.default_rng(n).random((*im.shape, SAMPLES)) < chance[..., None]
        found[measure] = FragilityCurve(name, Trials.from_runs(measure, values, fallen))
    return found


def option(name, measures, rank, share, *, bare, middle=6.0, slide=0.03, devices=()):
    fallen = shares(share)
    of = curves(name, middle)
    chances = {event: probability(shares(share, n)) for n, event in enumerate(EVENTS)}
    slides, tilts = Quantiles(slide, np.inf), Quantiles(0.02, np.inf)
    return OptionVerdict(
        option=Option(name, (measures,)),
        rank=rank,
        runs=MOTIONS * SAMPLES,
        pieces=(PieceVerdict("bookcase", chances, slides, tilts, expected(share, share)),),
        probabilities=chances,
        change=difference(fallen, bare) if measures else None,
        slide=slides,
        tilt=tilts,
        devices=devices,
        curves=of,
        capacities={p: next(iter(of.values())).capacity(p) for p in (0.1, 0.5)},
        typical=Member(0, 0),
        worst=Member(0, 1),
    )


def made(scenario=None, **changes):
    """Return a verdict of three options: belts, nothing, felt glides."""
    bare = shares(0.6)
    belt = DeviceSummary(
        "belt", "", probability(shares(0.1)), 12.3, Quantiles(900.0, 1800.0), Quantiles(0.45, 0.9)
    )
    options = (
        option("belt", (Belt(),), 1, 0.1, bare=bare, middle=None, slide=0.004, devices=(belt,)),
        option("none", (), 2, 0.6, bare=bare),
        option("felt_glides", (FeltGlides(),), 3, 0.7, bare=bare, middle=5.8, slide=np.inf),
    )
    verdict = Verdict(
        scenario=sp.Scenario.parse(SCENARIO if scenario is None else scenario),
        intensity=6.123,
        slide_limit=0.1,
        options=options,
        estimates=Estimates(
            1.63,
            0.23,
            1.0,
            0.94,
            equipment_loads(sp.Body(0.3, 1.8, 200.0), "ground"),
            Ac156Estimate.of(1.63, 0.0),
            SlidingShare(0.5, 0.12),
        ),
        levels=LEVELS,
        motions=MOTIONS,
        runs=2400,
        precise=True,
        seed=7,
        seconds=1.5,
    )
    return replace(verdict, **changes)


@cache
def page(language):
    """Return the report on the verdict of three options, which takes seconds to draw."""
    return report_html(made(), language)


def without_numbers():
    """Return a verdict without curves, all of whose runs were given up."""
    verdict = made()
    nothing = probability(np.zeros((2, 2), bool), np.ones((2, 2), bool))
    emptied = tuple(
        replace(
            one,
            probabilities=dict.fromkeys(EVENTS, nothing),
            slide=Quantiles(np.nan, np.nan),
            tilt=Quantiles(np.nan, np.nan),
            curves={},
            capacities={},
        )
        for one in verdict.options
    )
    return replace(verdict, options=emptied, levels=np.empty(0), precise=False)
