"""Notes beside a verdict's numbers: which inputs they rest on, and where a formula says otherwise."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from stayput.catalogue import phrase
from stayput.fragility.probabilities import percent
from stayput.measures.parameters import MEANINGS
from stayput.montecarlo.counting import OVERTURNED
from stayput.verification.grades import grade, weakest
from stayput.verification.words import length, share_text, slides_off, title
from stayput.wording import FAR

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from stayput.catalogue import Phrase
    from stayput.verification.options import Option
    from stayput.verification.verdict import Verdict

APART = 0.20
"""A quick estimate that is farther from the simulation than this is explained."""

LISTED = 4
"""Most inputs that a note names."""

_MAY_SLIDE = 1.5
"""Below so many times B/H the friction that is drawn may let a piece slide where the formula has it rock."""

_OFF_MIDDLE = 0.05
"""From so far off half the height, in heights, the centre of gravity is not the formula's."""


def notes(verdict: Verdict, graded: Option | None = None) -> tuple[Phrase, ...]:
    """Return the notes beside the numbers of a verdict, each in English and Japanese.

    Parameters
    ----------
    verdict : Verdict
        The verdict.
    graded : Option, optional
        The option whose grade is explained, by default the best.
    """
    return (
        *_estimate(verdict),
        *_grade(verdict.best.option if graded is None else graded, verdict),
        *_far(verdict),
        *_contents(verdict),
    )


def _listed(phrases: Iterable[Phrase]) -> Phrase:
    english, japanese = zip(*phrases, strict=True)
    return "; ".join(english), "、".join(japanese)


def _estimate(verdict: Verdict) -> Iterator[Phrase]:
    formula = verdict.estimates.overturning_ratio
    simulated = verdict.without.probabilities[OVERTURNED].estimate
    if not abs(formula - simulated) > APART:  # nor where the simulation has no result
        return
    yield phrase(
        "verification.estimate_differs",
        formula=percent(formula),
        simulated=percent(simulated),
        left_out=_listed(_left_out(verdict)),
    )


def _left_out(verdict: Verdict) -> Iterator[Phrase]:
    """Yield what the formula leaves out of this piece where it stands."""
    scenario = verdict.scenario
    body, room = scenario.furniture.body(), scenario.room.room()
    walls = ((room.left_wall, "verification.wall_behind"), (room.right_wall, "verification.wall_in_front"))
    for wall, key in walls:
        if wall is not None and wall.gap < body.height:
            yield phrase(key, gap=length(wall.gap))
    if room.ceiling is not None and room.ceiling.height < math.hypot(body.width, body.height):
        yield phrase("verification.ceiling")
    friction, slender = room.floor.static_friction, body.width / body.height
    if friction < _MAY_SLIDE * slender:
        yield phrase("verification.may_slide", friction=friction, slender=slender)
    up = body.centre_of_gravity[1] / body.height
    if abs(up - 0.5) > _OFF_MIDDLE:
        yield phrase("verification.centre_off_middle", percent=100.0 * up)
    yield phrase("verification.of_their_own")


def _grade(option: Option, verdict: Verdict) -> Iterator[Phrase]:
    scenario = verdict.scenario
    deciding = weakest(option, scenario)
    inputs = _listed(item.label for item in deciding[:LISTED])
    if len(deciding) > LISTED:
        more = phrase("verification.and_more", more=len(deciding) - LISTED)
        inputs = inputs[0] + more[0], inputs[1] + more[1]
    yield phrase(
        "verification.grade",
        option=(title(option, verdict, "en"), title(option, verdict, "ja")),
        letter=grade(option, scenario).value,
        meaning=MEANINGS[grade(option, scenario)],
        inputs=inputs,
    )


def _contents(verdict: Verdict) -> Iterator[Phrase]:
    contents = verdict.without.contents
    if contents is None or contents.rigid.runs == 0:
        return
    wide = contents.opened
    yield phrase(
        "verification.contents_bound",
        rigid=share_text(contents.rigid.estimate),
        emptied=share_text(contents.emptied.estimate),
        opened="" if wide is None else phrase("verification.drawers_open", share=share_text(wide.estimate)),
    )


def _far(verdict: Verdict) -> Iterator[Phrase]:
    if any(slides_off(option, verdict) for option in verdict.options):
        yield phrase("verification.slides_off", far=FAR)
