"""Ranks: what clearly differs decides, ties share a rank, and what does not help is not first."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from verdict_cases import SCENARIO, made, option, shares

from stayput.fragility.paired import difference
from stayput.fragility.probabilities import probability
from stayput.measures import Belt, LBracket, TensionPole
from stayput.montecarlo.counting import Members, Outcomes, Quantiles
from stayput.verification.contents import ContentsVerdict
from stayput.verification.ranking import in_order, ranks_of
from stayput.verification.words import headline, reason

if TYPE_CHECKING:
    from stayput.verification.verdict import OptionVerdict

MEASURES = {"belt": (Belt(),), "l_bracket": (LBracket(),), "tension_pole": (TensionPole(),)}


def happened(count: int) -> Any:
    """Return that it happened in the first runs of 20 motions, one of each."""
    return np.arange(20)[:, np.newaxis] < count


def ranked(**counts: tuple[int, int, int]) -> dict[str, int]:
    """Return the ranks of options by how often of 20 they fall, slide and let an item out; in their order."""
    nothing = happened(0).ravel()
    runs = [
        Outcomes(
            Members.of_samples(20, 1),
            overturned=happened(fell).ravel(),
            missing=nothing,
            hit_wall=nothing,
            device_failed=nothing,
            slide=happened(slid).ravel().astype(float),
            tilt=np.zeros(20),
        )
        for fell, slid, _ in counts.values()
    ]
    falls = [happened(fell) for fell, _, _ in counts.values()]
    bare = next(iter(counts.values()))
    verdicts: list[OptionVerdict] = []
    for (name, (fell, slid, out)), fallen in zip(counts.items(), falls, strict=True):
        measures, few = MEASURES.get(name, ()), probability(happened(out))
        items = happened(out).astype(float)
        change = difference(happened(out), happened(bare[2])) if measures else None
        moves = [happened(max(pair)) for pair in ((fell, slid), bare[:2])]
        result = option(name, measures, 0, 0.0, bare=shares(0.6), middle=None)
        verdicts.append(
            replace(
                result,
                probabilities=result.probabilities | {"overturned": probability(fallen)},
                change=difference(fallen, falls[0]) if measures else None,
                slid=difference(*moves) if measures else None,
                contents=ContentsVerdict(few, 0.0, 0.0, few, few, None, None, items, change),
            )
        )
    order = in_order(verdicts)
    ranks = ranks_of([verdicts[i] for i in order], [runs[i] for i in order], 0.1)  # pyright: ignore
    return {verdicts[i].option.name: rank for i, rank in zip(order, ranks, strict=True)}


@pytest.mark.parametrize(
    ("counts", "ranks"),
    [
        # what helps, alike: a shared rank; doing nothing comes after both
        (
            {"none": (16, 0, 0), "belt": (0, 0, 0), "l_bracket": (1, 0, 0)},
            {"belt": 1, "l_bracket": 1, "none": 3},
        ),
        # one of them clearly better
        (
            {"none": (20, 0, 0), "l_bracket": (10, 0, 0), "belt": (0, 0, 0)},
            {"belt": 1, "l_bracket": 2, "none": 3},
        ),
        # nothing differs in overturning, but clearly more comes out, or slides, with one
        (
            {"none": (0, 2, 1), "tension_pole": (0, 0, 9), "belt": (0, 0, 0)},
            {"none": 1, "belt": 1, "tension_pole": 3},
        ),
        ({"none": (0, 1, 0), "belt": (0, 9, 0)}, {"none": 1, "belt": 2}),
        # clearly less slides, though all overturn alike
        ({"none": (1, 15, 0), "belt": (0, 1, 0)}, {"belt": 1, "none": 2}),
        # what falls has moved: that a held piece slides is not for the worse
        ({"none": (18, 0, 0), "belt": (0, 12, 0)}, {"belt": 1, "none": 2}),
    ],
)
def test_ties_share_a_rank_and_what_clearly_differs_decides(
    counts: dict[str, tuple[int, int, int]], ranks: dict[str, int]
) -> None:
    assert list(ranked(**counts).items()) == list(ranks.items())


@pytest.mark.parametrize("language", ["en", "ja"])
def test_what_does_not_help_is_not_sold_and_what_is_worse_says_so(language: str) -> None:
    verdict = made()
    belt, none, _ = verdict.options
    bare, more = probability(happened(0)), difference(happened(12), happened(0))
    none = replace(none, rank=1, probabilities=none.probabilities | {"overturned": bare})
    worse = replace(belt, change=difference(happened(0), happened(0)), slid=more, rank=2)
    alike = replace(verdict, options=(none, worse))
    assert (alike.best, alike.helping) == (none, None)
    assert worse.option.label()[0].lower() not in headline(alike, language).lower()
    told = {"en": "slides too far more often than without a measure", "ja": "移動する割合は対策なしより"}
    assert told[language] in reason(worse, alike, language)


@pytest.mark.parametrize("listed", [False, True])
@pytest.mark.parametrize(
    ("language", "told"), [("en", "slides by over 10 cm in"), ("ja", "10 cmを超えて移動する割合は")]
)
@pytest.mark.parametrize("falls", [0.0, 0.3])
def test_a_headline_says_what_helps_against_sliding_alone(
    falls: float, language: str, told: str, listed: bool
) -> None:
    """Whether all stay upright or nothing makes falls rarer: with both shares."""
    fallen, (much, little) = shares(falls), (probability(shares(share, 5)) for share in (0.8, 0.1))
    furniture = {"preset": "bookcase"}
    verdict = made({**SCENARIO, "furniture": [furniture] if listed else furniture})
    best, bare, _ = verdict.options
    events = {"overturned": probability(fallen)}
    best = replace(
        best,
        change=difference(fallen, fallen),
        slid=difference(shares(0.1, 5), shares(0.8, 5)),
        probabilities={**best.probabilities, **events, "slid": little},
    )
    bare = replace(bare, probabilities={**bare.probabilities, **events, "slid": much})
    assert best.helps
    sentence = headline(replace(verdict, options=(best, bare)), language)
    assert told in sentence
    for chance in (much, little):
        assert chance.share[language == "ja"] in sentence
    felt = replace(best, slid=best.change)
    assert told not in headline(replace(verdict, options=(felt, bare)), language)


@pytest.mark.parametrize("metres", [0.0101, 0.0949, 0.1033, 0.9912, 1.91, 2.0])
def test_what_is_told_as_at_most_is_rounded_up(metres: float) -> None:
    """A 90 % quantile of 10.33 cm is not "10 cm at most" where 20 % slide by over 10 cm."""
    for listed in (False, True):
        furniture = {"preset": "bookcase"}
        verdict = made({**SCENARIO, "furniture": [furniture] if listed else furniture})
        option = replace(verdict.without, slide=Quantiles(0.01, metres))
        for language, pattern in (
            ("en", r"by (?:over )?([\d.]+) (c?m)"),
            ("ja", r"移動が([\d.]+) (c?m)以内"),
        ):
            (told,) = re.findall(pattern, reason(option, verdict, language))
            value = float(told[0]) * {"m": 1.0, "cm": 0.01}[told[1]]
            assert metres - 1e-9 <= value <= metres * 1.15
