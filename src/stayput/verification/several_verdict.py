"""The result of a verification of several pieces: for every option its probabilities, and its rank."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

    from stayput.fragility import Difference, Probability
    from stayput.montecarlo.counting import Quantiles
    from stayput.scenario import AssemblyScenario
    from stayput.scenario.pieces import AssemblyOption
    from stayput.verification.several_options import RejectedOption
    from stayput.verification.verdict import DeviceSummary, Member


@dataclass(frozen=True, slots=True)
class PieceVerdict:
    """What becomes of one of several pieces with an option.

    Parameters
    ----------
    name : str
        The piece.
    probabilities : mapping of str to Probability
        Of each of `EVENTS`; that of a device's failure counts all devices.
    slide, tilt : Quantiles
        Peak slide [m] and tilt [rad].
    """

    name: str
    probabilities: Mapping[str, Probability]
    slide: Quantiles
    tilt: Quantiles


@dataclass(frozen=True, slots=True)
class DeviceOfSeveral:
    """Summary of a device or a joint: the piece that it holds, or the two that it joins."""

    pieces: tuple[str, ...]
    summary: DeviceSummary


@dataclass(frozen=True, slots=True, eq=False)
class AssemblyOptionVerdict:
    """Results of one option of several pieces.

    Parameters
    ----------
    option : AssemblyOption
        The joints and the measures.
    rank : int
        1 for the best.
    probabilities : mapping of str to Probability
        Of each of `EVENTS` for any of the pieces that count (`AssemblyScenario.counted`), at the
        scenario's shaking.
    change : Difference, optional
        Probability that any overturns less that without anything; none for the latter itself.
    slide, tilt : Quantiles
        Peak slide [m] and tilt [rad] of that which moves farthest.
    pieces : tuple of PieceVerdict
        Each of the pieces.
    devices : tuple of DeviceOfSeveral
        Each device and joint.
    typical, worst : Member
        A run of median severity, and the worst.
    """

    option: AssemblyOption
    rank: int
    probabilities: Mapping[str, Probability]
    change: Difference | None
    slide: Quantiles
    tilt: Quantiles
    pieces: tuple[PieceVerdict, ...]
    devices: tuple[DeviceOfSeveral, ...]
    typical: Member
    worst: Member


@dataclass(frozen=True, slots=True, eq=False, repr=False)
class AssemblyVerdict:
    """The outcome of a verification of several pieces.

    Parameters
    ----------
    scenario : AssemblyScenario
        The scenario.
    intensity : float
        JMA intensity of the ground.
    slide_limit : float
        Slide that counts as too far [m].
    options : tuple of AssemblyOptionVerdict
        The best first; exactly one of them has neither joints nor measures.
    motions, samples : int
        Motions, and Monte Carlo samples of each.
    runs : int
        Simulations that were made.
    precise : bool
        Whether the asked precision was reached.
    seed : int
        Seed of the draws.
    seconds : float
        How long it took.
    rejected : tuple of RejectedOption
        Options that cannot be put in place here, with the reason.
    """

    scenario: AssemblyScenario
    intensity: float
    slide_limit: float
    options: tuple[AssemblyOptionVerdict, ...]
    motions: int
    samples: int
    runs: int
    precise: bool
    seed: int
    seconds: float
    rejected: tuple[RejectedOption, ...] = ()
    floor: str = ""

    def __repr__(self) -> str:
        best, pieces = self.best, ", ".join(self.scenario.names)
        return f"AssemblyVerdict(JMA {self.intensity:.2f}; {pieces}; best: {best.option.name})"

    @property
    def without(self) -> AssemblyOptionVerdict:
        """The option without joints and measures."""
        return next(option for option in self.options if not option.option.count)

    @property
    def best(self) -> AssemblyOptionVerdict:
        """The option that ranks first."""
        return self.options[0]

    def sentence(self, language: str = "en") -> str:
        """Return the verdict in one sentence, in "en" or "ja"."""
        from stayput.verification.several_words import headline_of_several

        return headline_of_several(self, language)

    def to_json(self) -> str:
        """Return the verdict as JSON; keys carry their units."""
        from stayput.report.several.data import several_json

        return several_json(self)

    def to_markdown(self, language: str = "en") -> str:
        """Return the verdict as Markdown, in "en" or "ja"."""
        from stayput.report.several.markdown import several_markdown

        return several_markdown(self, language)

    def to_csv(self) -> str:
        """Return the ranking as CSV."""
        from stayput.report.several.data import several_csv

        return several_csv(self)

    def report(self, path: str | Path, language: str = "en") -> Path:
        """Write the report, one HTML file with everything in it; see `stayput.report.several`."""
        from stayput.report.several.html import write_several_report

        return write_several_report(self, path, language)
