"""A verdict on several pieces as rows of texts, for terminal, Markdown and HTML."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from stayput.catalogue import phrase, say
from stayput.catalogue.names import PIECES
from stayput.measures import MEASURES
from stayput.model.parameters import GIVEN
from stayput.montecarlo.counting import DEVICE_FAILED, EVENTS, OVERTURNED
from stayput.report.verdict import numbers
from stayput.report.verdict.assumptions import (
    MODEL,
    Assumption,
    drawn_assumptions,
    room_assumptions,
    shaking_assumptions,
)
from stayput.report.verdict.tables import device_cells
from stayput.simulation.placing import JOINT, JOINT_LABEL
from stayput.verification.several_options import brief_label
from stayput.verification.several_words import is_own, reason_of_several, title_of_several

if TYPE_CHECKING:
    from collections.abc import Iterator

    from stayput.catalogue import Phrase
    from stayput.fragility import Probability
    from stayput.scenario import AssemblyScenario
    from stayput.scenario.pieces import StandingTable
    from stayput.verification import AssemblyOptionVerdict, AssemblyVerdict


@dataclass(frozen=True, slots=True)
class SeveralRow:
    """One option of several pieces as it is read: texts in one language.

    Parameters
    ----------
    result : AssemblyOptionVerdict
        The option.
    title, brief : str
        What it consists of, with the names of the pieces and without; a name of the user's own stands for it.
    shares : tuple of (str, Probability)
        Each event of any piece of furniture; there is none of a device's failure without devices.
    pieces : tuple of (str, Probability)
        Each piece, and how likely it overturns.
    slide, tilt : tuple of str
        Median and 90 % quantile of the peaks.
    reason : str
        Why it stands where it does.
    """

    result: AssemblyOptionVerdict
    title: str
    brief: str
    shares: tuple[tuple[str, Probability | None], ...]
    pieces: tuple[tuple[str, Probability], ...]
    slide: tuple[str, str]
    tilt: tuple[str, str]
    reason: str


def several_rows(verdict: AssemblyVerdict, language: str) -> list[SeveralRow]:
    """Return the options as they are read, the best first."""
    room = verdict.scenario.surroundings()
    return [
        SeveralRow(
            result,
            title_of_several(result, verdict, language),
            result.option.name if is_own(result, verdict) else say(brief_label(result.option), language),
            tuple(
                (event, result.probabilities[event] if event != DEVICE_FAILED or result.devices else None)
                for event in EVENTS
            ),
            tuple((piece.name, piece.probabilities[OVERTURNED]) for piece in result.pieces),
            numbers.slides(result.slide, room, language),
            numbers.angles(result.tilt, language),
            reason_of_several(result, verdict, language),
        )
        for result in verdict.options
    ]


def rejected_rows(verdict: AssemblyVerdict, language: str) -> list[tuple[str, str]]:
    """Return label and reason of each option that cannot be put in place."""
    return [(title_of_several(one, verdict, language), one.why(language)) for one in verdict.rejected]


def several_device_rows(result: AssemblyOptionVerdict, language: str) -> list[tuple[str, ...]]:
    """Return what each device and joint holds, and its results, as texts: see `device_cells`."""
    labels = {JOINT: JOINT_LABEL} | {kind: measure.label for kind, measure in MEASURES.items()}
    return [
        (
            (" – " if language == "en" else "と").join(device.pieces),
            *device_cells(device.summary, labels[device.summary.kind], language),
        )
        for device in result.devices
    ]


def simulations_of_several(verdict: AssemblyVerdict, language: str) -> str:
    """Return the number of simulations in words."""
    counts = {"runs": f"{verdict.runs:,}", "motions": verdict.motions, "samples": verdict.samples}
    return say("several.simulations", language, **counts)


def several_assumptions(verdict: AssemblyVerdict) -> list[Assumption]:
    """Return the assumptions of a verdict on several pieces."""
    scenario = verdict.scenario
    return [
        *piece_assumptions(scenario),
        *room_assumptions(scenario),
        *shaking_assumptions(scenario, verdict.motions),
        *drawn_assumptions(scenario.uncertainty),
        drawn_between(),
        Assumption((phrase("several.limit_body"), phrase("several.limit_body_text")), MODEL),
        *settlement_assumptions(scenario),
        *rolling_assumptions(scenario),
        *(
            Assumption((phrase(f"report.limit_{key}"), phrase(f"report.limit_{key}_text")), MODEL)
            for key in ("contacts", "devices")
        ),
    ]


def piece_assumptions(scenario: AssemblyScenario) -> Iterator[Assumption]:
    """Yield the pieces and the friction between them."""
    for piece in scenario.furniture:
        yield _piece(piece, scenario)
    friction = phrase(
        "report.frictions", surface="", static=scenario.static_friction, kinetic=scenario.kinetic_friction
    )
    yield Assumption((phrase("several.between"), friction), GIVEN)


def drawn_between() -> Assumption:
    """Return how what is between the pieces is drawn."""
    return Assumption((phrase("several.drawn_between"), phrase("several.drawn_between_text")), "low")


def settlement_assumptions(scenario: AssemblyScenario) -> Iterator[Assumption]:
    """Yield for which pieces the sinking into a soft floor is left out, or less than it may be."""
    if scenario.floor.settlement == 0.0:
        return
    pieces = scenario.furniture
    left_out = {
        "solids": any(piece.on is None and not piece.is_furniture for piece in pieces),
        "stacks": any(piece.on is not None for piece in pieces),
    }
    for key, applies in left_out.items():
        if applies:
            text = phrase(f"several.settlement_of_{key}")
            yield Assumption((phrase("several.limit_settlement"), text), MODEL)


def rolling_assumptions(scenario: AssemblyScenario) -> Iterator[Assumption]:
    """Yield how round pieces roll, where there are any."""
    if any(len(piece.solid(scenario.folder).rims) for piece in scenario.furniture):
        yield Assumption((phrase("several.rolling"), phrase("several.rolling_text")), MODEL)


def _piece(piece: StandingTable, scenario: AssemblyScenario) -> Assumption:
    solid = piece.solid(scenario.folder)
    width, length, height = (float(side) for side in solid.vertices.max(axis=0) - solid.vertices.min(axis=0))
    size = phrase("several.piece_box", width=width, length=length, height=height, mass=solid.mass)
    value: Phrase = size
    if piece.preset is not None:
        kind = PIECES[piece.preset]
        value = f"{kind[0]}: {size[0]}", f"{kind[1]}：{size[1]}"
    called = PIECES.get(piece.name, (piece.name, piece.name))
    return Assumption((called, value), GIVEN if piece.preset is None else "low")
