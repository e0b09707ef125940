"""The result of a verification: for every option its probabilities, capacity and rank."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from stayput.estimates import ishiyama_velocity, kaneko_hayashi, rocking_acceleration
from stayput.execution import Pool
from stayput.fragility import PFA, PFV
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.montecarlo.counting import OVERTURNED
from stayput.saved import InJson
from stayput.standards import ac156, asce43_sliding, equipment_loads, position_of
from stayput.standards.asce43 import VERTICAL_SHARE
from stayput.wording import check_language

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path
    from typing import Self

    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    from stayput.catalogue import Phrase
    from stayput.fragility import Capacity, Difference, FragilityCurve, IntensityMeasure, Probability
    from stayput.measures.parameters import Grade
    from stayput.model.body import Body
    from stayput.montecarlo.counting import Quantiles
    from stayput.montecarlo.hazard import FloorMotions
    from stayput.scenario import Scenario
    from stayput.standards import EquipmentLoad
    from stayput.verification.contents import ContentsVerdict
    from stayput.verification.options import Impossible, Option


@dataclass(frozen=True, slots=True)
class Ac156Estimate:
    """From which strength on a shake-table test by AC156 rocks a piece.

    Parameters
    ----------
    height_ratio : float
        z/h of the floor.
    sds : float
        S_DS at which the test's acceleration of a rigid body, A_rig, starts rocking [g].
    """

    height_ratio: float
    sds: float

    @classmethod
    def of(cls, rocking: float, height_ratio: float) -> Self:
        """Return it for an acceleration at which rocking starts [m/s²]; A_rig is proportional to S_DS."""
        required = ac156(1.0, height_ratio)
        return cls(height_ratio, rocking / (required.rigid * STANDARD_GRAVITY))


@dataclass(frozen=True, slots=True)
class SlidingShare:
    """How far the piece slides by ASCE 43, over the motions under it.

    Parameters
    ----------
    share : float
        Share of the motions that make it slide; those that the method says nothing of do not count.
    distance : float
        Median distance under those [m]; nan where there are none.
    """

    share: float
    distance: float

    @classmethod
    def of(cls, floors: FloorMotions, friction: float, gravity: float, threads: int | None) -> Self:
        """Return it for the motions of a level and the static friction of the floor."""

        def estimated(place: int) -> float:
            motion = floors.motions[place].scaled(float(floors.scales[place]))
            lifted = motion.z is not None and float(np.abs(motion.z).max()) >= gravity / VERTICAL_SHARE
            return math.nan if lifted else asce43_sliding(motion, friction, gravity).distance

        with Pool(threads) as pool:
            calls = (partial(estimated, place) for place in range(len(floors.motions)))
            distances = np.sort([distance for _, distance in pool.as_completed(calls)])
        slides = distances[np.isfinite(distances)]  # NaN where the spectrum nowhere reaches the friction
        return cls(len(slides) / len(distances), float(np.median(slides)) if len(slides) else math.nan)


@dataclass(frozen=True, slots=True)
class Estimates:
    """Quick estimates by formulas of the piece without a measure, on a floor on which it does not slide.

    Parameters
    ----------
    rocking_acceleration : float
        Floor acceleration at which rocking starts (West) [m/s²].
    overturning_velocity : float
        Floor velocity that overturning needs as well (Ishiyama 1982) [m/s].
    possible : float
        Share of the motions that reach both.
    overturning_ratio : float
        Share that overturns by Kaneko and Hayashi, on average over the motions.
    equipment : tuple of EquipmentLoad
        Static loads of the Japanese guideline for building equipment where the piece stands, class by class.
        None under motions of upper floors: it goes by the storeys of the building, which are not known then.
    shake_table : Ac156Estimate, optional
        The shake-table test of AC156 where the piece stands; likewise.
    sliding : SlidingShare
        Sliding by the approximate method of ASCE 43.
    """

    rocking_acceleration: float
    overturning_velocity: float
    possible: float
    overturning_ratio: float
    equipment: tuple[EquipmentLoad, ...]
    shake_table: Ac156Estimate | None
    sliding: SlidingShare

    @classmethod
    def of(cls, body: Body, floors: FloorMotions, scenario: Scenario, threads: int | None) -> Estimates:
        """Return the estimates of a scenario's body under the motions of a level."""
        gravity, shaking = scenario.gravity, scenario.shaking
        a, v = floors.measures[PFA], floors.measures[PFV]
        a0, v0 = rocking_acceleration(body, gravity), ishiyama_velocity(body, gravity)
        ratios = [kaneko_hayashi(body, float(x), float(y), gravity).ratio for x, y in zip(a, v, strict=True)]
        building = shaking.building
        storey, storeys = (1, 1) if building is None else (shaking.storey or 1, building.highest() - 1)
        return cls(
            a0,
            v0,
            float(np.mean((a >= a0) & (v >= v0))),
            float(np.mean(ratios)),
            () if floors.floor else equipment_loads(body, position_of(storey, storeys), gravity=gravity),
            None if floors.floor else Ac156Estimate.of(a0, (storey - 1) / storeys),
            SlidingShare.of(floors, scenario.room.room().floor.static_friction, gravity, threads),
        )


@dataclass(frozen=True, slots=True)
class DeviceSummary:
    """Summary of one device over all runs.

    Parameters
    ----------
    kind : str
        The measure that it belongs to, as in a scenario's ``type``.
    name : str
        Which of the measure's devices it is.
    failed : Probability
        Share of the runs in which it failed.
    failure_time : float
        Median time of failure of those runs [s]; nan where it never failed.
    peak : Quantiles
        Largest force, of pull or push and shear together [N].
    used : Quantiles
        Largest force over strength: below 1 there was a margin, where it failed it is at least 1; 0 for a
        device without a strength to reach.
    weakest : Phrase, optional
        What gave way in most of the runs in which it failed, or would first; none where nothing can.
    """

    kind: str
    name: str
    failed: Probability
    failure_time: float
    peak: Quantiles
    used: Quantiles
    weakest: Phrase | None = None


@dataclass(frozen=True, slots=True)
class AsInstalled:
    """An option as people install it: well, or in a share of the homes badly.

    Parameters
    ----------
    share : float
        Share that is badly installed.
    how : tuple of Phrase
        What is wrong with it then.
    badly : mapping of str to Probability
        Of each of `EVENTS` where it is badly installed, at the scenario's shaking and under the same draws.
    usual : mapping of str to float
        The same as people install it: (1 − share) times that when well installed + share times `badly`.
    """

    share: float
    how: tuple[Phrase, ...]
    badly: Mapping[str, Probability]
    usual: Mapping[str, float]


@dataclass(frozen=True, slots=True)
class Member:
    """A representative run: its place among motions and samples."""

    motion: int
    sample: int


@dataclass(frozen=True, slots=True, eq=False, repr=False)
class OptionVerdict:
    """Results of one option: no measure, or one or several of them.

    Parameters
    ----------
    option : Option
        The measures.
    rank : int
        1 for the best.
    probabilities : mapping of str to Probability
        Of each of `EVENTS`, at the scenario's shaking.
    change : Difference, optional
        Probability of overturning less that without a measure; none for the latter itself.
    slide, tilt : Quantiles
        Peak slide [m] and tilt [rad].
    devices : tuple of DeviceSummary
        Of each device that bears a force.
    curves : mapping of IntensityMeasure to FragilityCurve
        Probability of overturning against every intensity measure.
    capacities : mapping of float to Capacity
        JMA intensity of the ground at which this share overturns: 0.1 and 0.5.
    typical, worst : Member
        A run of median severity, and the worst.
    installed : AsInstalled, optional
        As people install it, where the scenario asks for that and it can be badly installed.
    contents : ContentsVerdict, optional
        What comes out of the furniture, where the scenario says what is in it.
    """

    option: Option
    rank: int
    probabilities: Mapping[str, Probability]
    change: Difference | None
    slide: Quantiles
    tilt: Quantiles
    devices: tuple[DeviceSummary, ...]
    curves: Mapping[IntensityMeasure, FragilityCurve]
    capacities: Mapping[float, Capacity]
    typical: Member
    worst: Member
    installed: AsInstalled | None = None
    contents: ContentsVerdict | None = None

    def __repr__(self) -> str:
        overturned = self.probabilities[OVERTURNED].text
        return f"OptionVerdict({self.option.name!r}, rank {self.rank}, overturned {overturned})"


@dataclass(frozen=True, slots=True, eq=False, repr=False)
class Verdict(InJson):
    """The outcome of a verification.

    Parameters
    ----------
    scenario : Scenario
        The scenario.
    intensity : float
        JMA intensity of the ground; of motions of upper floors what its formula gives for them.
    slide_limit : float
        Slide that counts as too far [m].
    options : tuple of OptionVerdict
        The best first; exactly one of them has no measure.
    estimates : Estimates
        Quick estimates by formulas, to stand beside.
    levels : ndarray, shape (levels,)
        JMA intensities of the fragility curves.
    motions, samples : int
        Motions, and Monte Carlo samples of each.
    runs : int
        Simulations that were made.
    settled : int
        Runs of the fragility curves that were not made: stronger shaking left the piece far from falling.
    precise : bool
        Whether the asked precision was reached.
    seed : int
        Seed of the draws.
    seconds : float
        How long it took.
    impossible : tuple of Impossible
        Options that cannot be put in place here, with the reason.
    complete : bool
        Whether it is final; else more samples or the curves are still to come.
    floor : str
        The upper floors that the motions were stated for; "" where they are of the ground.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import LBracket
    >>> body = sp.Body(width=0.3, height=1.8, mass=90.0)
    >>> room = sp.Room(left_wall=sp.Wall(0.02))
    >>> shaking = {"intensity": "6-upper", "suite": {"family": "near-fault", "count": 4}}
    >>> verdict = sp.verify(
    ...     body, room, shaking=shaking, measures=[LBracket()], samples=8, levels=[], progress=False
    ... )
    >>> verdict.best.option.name, verdict.best.probabilities["overturned"].estimate
    ('l_bracket', 0.0)
    """

    scenario: Scenario
    intensity: float
    slide_limit: float
    options: tuple[OptionVerdict, ...]
    estimates: Estimates
    levels: NDArray[np.float64]
    motions: int
    samples: int
    runs: int
    settled: int
    precise: bool
    seed: int
    seconds: float
    impossible: tuple[Impossible, ...] = ()
    complete: bool = True
    floor: str = ""

    def __repr__(self) -> str:
        ranked = ", ".join(
            f"{one.option.name} {one.probabilities[OVERTURNED].text}" for one in self.options[:3]
        )
        more = f", and {len(self.options) - 3} more" if len(self.options) > 3 else ""
        return f"Verdict(JMA {self.intensity:.2f}; overturned: {ranked}{more})"

    def _repr_html_(self) -> str:
        from stayput.report.notebook import verdict_html

        return verdict_html(self)

    def plot(self, ax: Axes | None = None, *, language: str = "en") -> Axes:
        """Draw the share that overturns with each option, with its 95 % interval, the best first.

        Parameters
        ----------
        ax : Axes, optional
            Where to draw; by default in a new figure of pyplot.
        language : str
            Language of the texts, "en" or "ja".
        """
        from stayput.report.figures import axes_of, drawn
        from stayput.report.verdict.ranking import draw_ranking

        axis = axes_of(ax)
        draw_ranking(axis, self, check_language(language))
        return drawn(axis)

    @property
    def without(self) -> OptionVerdict:
        """The option without a measure."""
        return next(option for option in self.options if not option.option.measures)

    @property
    def best(self) -> OptionVerdict:
        """The option that ranks first."""
        return self.options[0]

    def sentence(self, language: str = "en") -> str:
        """Return the verdict in one sentence, in "en" or "ja"."""
        from stayput.verification.words import headline

        return headline(self, language)

    def grade(self, option: OptionVerdict) -> Grade:
        """Return the grade of an option: that of its weakest input; see `stayput.verification.grades`."""
        from stayput.verification.grades import grade

        return grade(option.option, self.scenario)

    def notes(self, language: str = "en") -> tuple[str, ...]:
        """Return the notes beside the numbers, in "en" or "ja"; see `stayput.verification.notes`."""
        from stayput.catalogue import say
        from stayput.verification.notes import notes

        return tuple(say(note, language) for note in notes(self))

    def to_json(self) -> str:
        """Return the verdict as JSON; keys carry their units."""
        from stayput.report.verdict.data import verdict_json

        return verdict_json(self)

    def to_markdown(self, language: str = "en") -> str:
        """Return the verdict as Markdown, in "en" or "ja"."""
        from stayput.report.verdict.markdown import verdict_markdown

        return verdict_markdown(self, language)

    def to_csv(self) -> str:
        """Return the ranking as CSV."""
        from stayput.report.verdict.tables import verdict_csv

        return verdict_csv(self)

    def report(self, path: str | Path, language: str = "en") -> Path:
        """Write the report, one HTML file with everything in it; see `stayput.report.verdict`."""
        from stayput.report.verdict.html import write_report

        return write_report(self, path, language)
