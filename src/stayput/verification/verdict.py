"""The results of a verification: for every option its probabilities, and its rank."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from stayput.catalogue import Phrase, phrase
from stayput.errors import InputError, shown
from stayput.montecarlo.counting import OVERTURNED, SLID, Member, Quantiles
from stayput.saved import InJson
from stayput.simulation.space_fate import MAY_FALL_FROM, Stability
from stayput.verification.people import DECIDING_EVENTS
from stayput.wording import check_language

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes

    from stayput.fragility.curve import Capacity, FragilityCurve
    from stayput.fragility.intensity_measures import IntensityMeasure
    from stayput.fragility.paired import Difference
    from stayput.fragility.probabilities import Probability
    from stayput.measures.measure import Grade
    from stayput.scenario import Scenario
    from stayput.scenario.measures import Option
    from stayput.verification.changes import Change
    from stayput.verification.contents import ContentsVerdict
    from stayput.verification.events import Zones
    from stayput.verification.meetings import Meeting
    from stayput.verification.notes import Estimates
    from stayput.verification.options import Impossible
    from stayput.verification.people import People


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
        Largest force that it bore, of pull or push and shear together [N]: until it failed, if it did.
    used : Quantiles
        Largest force over strength: below 1 there was a margin, where it failed it is at least 1; 0 for a
        device without a strength to reach.
    weakest : Phrase, optional
        What gave way in most of the runs in which it failed, or would first; none where nothing can.
    pieces : tuple of str
        The piece that it holds; of a joint the two that it joins.
    demand : Quantiles, optional
        Largest force on it if it cannot fail, over its strength; see `stayput.verification.demand`.
    """

    kind: str
    name: str
    failed: Probability
    failure_time: float
    peak: Quantiles
    used: Quantiles
    weakest: Phrase | None = None
    pieces: tuple[str, ...] = ()
    demand: Quantiles | None = None


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
class PieceVerdict:
    """What becomes of a piece with an option.

    Parameters
    ----------
    name : str
        The piece.
    probabilities : mapping of str to Probability
        Of each of `EVENTS`; that of a device's failure counts all devices.
    slide, tilt : Quantiles
        Peak slide [m] and tilt [rad].
    stability : Stability
        How firmly it stands.
    change : Difference, optional
        Probability that it overturns less that without anything; none of the latter itself.
    harm : float
        Energy with which it hits people in a room, on average over all runs and weighted by how long somebody
        is at each place [J].
    zones : Zones, optional
        Where it ends in a room as it is.
    """

    name: str
    probabilities: Mapping[str, Probability]
    slide: Quantiles
    tilt: Quantiles
    stability: Stability
    change: Difference | None = None
    harm: float = 0.0
    zones: Zones | None = None

    @property
    def falls(self) -> bool:
        """Whether it overturns so often that it is to be held, even where it hits nobody."""
        return self.probabilities[OVERTURNED].estimate >= MAY_FALL_FROM


@dataclass(frozen=True, slots=True, eq=False, repr=False, kw_only=True)
class OptionVerdict:
    """Results of one option: nothing, measures, joints.

    Parameters
    ----------
    option : Option
        What is in place.
    rank : int
        1 for the best; options whose differences are unclear share a rank, as in 1, 1, 3.
    runs : int
        How many runs there are of it.
    probabilities : mapping of str to Probability
        Of each of `EVENTS` for any of the pieces that count (`Scenario.counted`), at the scenario's shaking.
    change : Difference, optional
        Probability that any overturns less that without anything; none for the latter itself.
    slid : Difference, optional
        The same of a slide that is too far, as which one that overturns counts.
    slide, tilt : Quantiles
        Peak slide [m] and tilt [rad] of that which moves farthest.
    typical, worst : Member
        A run of median severity, and the worst.
    pieces : tuple of PieceVerdict
        Each of the pieces.
    devices : tuple of DeviceSummary
        Of each device that bears a force, and of each joint.
    curves : mapping of IntensityMeasure to FragilityCurve
        Probability of overturning against every intensity measure; of a lone piece.
    capacities : mapping of float to Capacity
        JMA intensity of the ground at which this share overturns: 0.1 and 0.5; of a lone piece.
    installed : AsInstalled, optional
        As people install it, where the scenario asks for that and it can be badly installed.
    contents : ContentsVerdict, optional
        What comes out of the furniture, where the scenario says what is in it.
    people : People, optional
        What happens to people, in a room with a plan.
    meetings : tuple of Meeting
        Pieces that run apart and come together: without anything, and with the best that helps.
    """

    option: Option
    rank: int
    runs: int
    probabilities: Mapping[str, Probability]
    change: Difference | None
    slide: Quantiles
    tilt: Quantiles
    typical: Member
    worst: Member
    pieces: tuple[PieceVerdict, ...]
    devices: tuple[DeviceSummary, ...]
    curves: Mapping[IntensityMeasure, FragilityCurve]
    capacities: Mapping[float, Capacity]
    installed: AsInstalled | None = None
    contents: ContentsVerdict | None = None
    people: People | None = None
    meetings: tuple[Meeting, ...] = ()
    slid: Difference | None = None

    @property
    def better(self) -> tuple[str, ...]:
        """What happens clearly less often.

        In a room with people some of "hit", "shut_in", "blocked" and "overturned"; else of "overturned",
        "contents_out" and "slid".
        """
        return self._clear(-1.0)

    @property
    def worse(self) -> tuple[str, ...]:
        """What happens clearly more often."""
        return self._clear(1.0)

    @property
    def helps(self) -> bool:
        """Whether something is clearly for the better, nothing clearly for the worse, and no more are hit.

        Without people overturning decides; only where it does not clearly change, what comes out and slides.
        """
        return self.standing < 0

    @property
    def standing(self) -> int:
        """Whether it stands before what is without it, −1, or behind, 1; 0 where no clear change decides."""
        if self.people is None and OVERTURNED in self.better:
            return -1
        if self.worse:
            return 1
        hit = None if self.people is None else self.people.hit.change
        return -int(bool(self.better) and (hit is None or hit.estimate <= 0.0))

    @property
    def differences(self) -> Iterator[tuple[str, Difference]]:
        """What differs from what is without it: of people and of each piece, else of what counts."""
        if self.people is None:
            contents = None if self.contents is None else self.contents.change
            each = {OVERTURNED: self.change, "contents_out": contents, SLID: self.slid}
            yield from ((name, change) for name, change in each.items() if change is not None)
            return
        for name in DECIDING_EVENTS:
            if (change := getattr(self.people, name).change) is not None:
                yield name, change
        for piece in self.pieces:
            if piece.change is not None:
                yield OVERTURNED, piece.change

    def _clear(self, sign: float) -> tuple[str, ...]:
        """Return what changes clearly in one direction, each once."""
        clear = (name for name, diff in self.differences if diff.clear and sign * diff.estimate > 0.0)
        return tuple(dict.fromkeys(clear))

    def __repr__(self) -> str:
        overturned = self.probabilities[OVERTURNED].text
        return f"OptionVerdict({self.option.name!r}, rank {self.rank}, overturned {overturned})"


@dataclass(frozen=True, slots=True, eq=False, repr=False, kw_only=True)
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
        The best first; exactly one of them has nothing in place, or is the scene as stated: it stands before
        those that do not clearly differ from it.
    motions : int
        Motions.
    runs : int
        Simulations that were made.
    seed : int
        Seed of the draws.
    seconds : float
        How long it took.
    estimates : Estimates, optional
        Quick estimates by formulas, to stand beside those of a lone piece; none before it is complete.
    levels : ndarray, shape (levels,)
        JMA intensities at which all options ran for the curves.
    precise : bool
        Whether the asked precision was reached.
    impossible : tuple of Impossible
        Options that cannot be put in place here, with the reason.
    complete : bool
        Whether it is final; else more samples or the curves are still to come.
    floor : str
        The upper floors that the motions were stated for; "" where they are of the ground.
    kinds : tuple of int
        Of each piece the number of its kind: pieces of one body share their runs.

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
    >>> verdict.motions, verdict.best.runs  # two draws under each motion
    (4, 8)
    >>> [option.option.name for option in verdict], float(verdict["l_bracket"].probabilities["overturned"])
    (['l_bracket', 'none'], 0.0)
    """

    scenario: Scenario
    intensity: float
    slide_limit: float
    options: tuple[OptionVerdict, ...]
    motions: int
    runs: int
    seed: int
    seconds: float
    estimates: Estimates | None = None
    levels: NDArray[np.float64] = field(default_factory=lambda: np.empty(0))
    precise: bool = False
    impossible: tuple[Impossible, ...] = ()
    complete: bool = True
    floor: str = ""
    kinds: tuple[int, ...] = ()

    def __repr__(self) -> str:
        ranked = ", ".join(
            f"{option.option.name} {option.probabilities[OVERTURNED].text}" for option in self.options[:3]
        )
        more = f", and {len(self.options) - 3} more" if len(self.options) > 3 else ""
        made = f"{self.runs_each[0]} runs each under {self.motions} motions"
        draft = "" if self.complete else "; not complete"
        return f"Verdict(JMA {self.intensity:.2f}; overturned: {ranked}{more}; {made}{draft})"

    @property
    def runs_each(self) -> Phrase:
        """How many runs there are of each option, in both languages: "40", "16 to 43"."""
        least, most = (pick(option.runs for option in self.options) for pick in (min, max))
        return phrase("fragility.ends", low=least, high=most) if least < most else (f"{least}", f"{least}")

    def __iter__(self) -> Iterator[OptionVerdict]:
        return iter(self.options)

    def __len__(self) -> int:
        return len(self.options)

    def __getitem__(self, option: str | int) -> OptionVerdict:
        """Return the verdict on an option, by its name or its place in the ranking from 0 on."""
        names = [result.option.name for result in self.options]
        try:
            return self.options[names.index(option) if isinstance(option, str) else option]
        except (ValueError, TypeError, IndexError):
            known = ", ".join(names)
            raise InputError("verification.no_option", "option", value=shown(option), allowed=known) from None

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
        from stayput.report.figures import plotted
        from stayput.report.fragility import draw_ranking

        return plotted(ax, draw_ranking, self, check_language(language))

    @property
    def best(self) -> OptionVerdict:
        """The option that stands first: that with nothing in place where none clearly helps."""
        return self.options[0]

    @property
    def without(self) -> OptionVerdict:
        """The option with nothing in place, or the scene as stated: what the others are compared with."""
        return next(option for option in self.options if option.change is None)

    @property
    def others(self) -> tuple[OptionVerdict, ...]:
        """The other options, the best first."""
        return tuple(option for option in self.options if option.change is not None)

    @property
    def helping(self) -> OptionVerdict | None:
        """The best of the others that clearly helps, or None where none does."""
        return next((option for option in self.others if option.helps), None)

    def changes(self, option: OptionVerdict) -> tuple[Change, ...]:
        """Return what an option changes of that which it is compared with."""
        from stayput.verification.changes import changes_in

        return changes_in(option.option, self.without.option, self.scenario.names)

    def report(self, path: str | Path, language: str = "en") -> Path:
        """Write the report, one HTML file with everything in it; see `stayput.report.verdict`.

        Parameters
        ----------
        path : str or Path
            The file, whose name ends in .html.
        language : str
            "en" or "ja".

        Returns
        -------
        Path
            The file written.

        Raises
        ------
        InputError
            Another language, a path that cannot be written, or a record that cannot be read any more.
        """
        from stayput.report.page import write_page
        from stayput.report.room.report import room_html
        from stayput.report.verdict.html import report_html

        html = report_html if self.scenario.plan is None else room_html
        return write_page(path, language, lambda: html(self, language))

    def sentence(self, language: str = "en") -> str:
        """Return the verdict in one sentence, in "en" or "ja"."""
        from stayput.catalogue import say
        from stayput.verification.notes import left_out_of_held
        from stayput.verification.room_words import sentence_of_room
        from stayput.verification.words import headline

        sentence = headline if self.scenario.plan is None else sentence_of_room
        said, left_out = sentence(self, check_language(language)), left_out_of_held(self)
        if left_out is None:
            return said
        return (" " if language == "en" else "").join((said, say(left_out, language)))

    def label(self, option: OptionVerdict, language: str = "en") -> str:
        """Return what an option consists of, in "en" or "ja": "Belts on the bookcase"."""
        from stayput.verification.room_words import option_label
        from stayput.verification.words import title

        if self.scenario.plan is None:
            return title(option.option, self, check_language(language))
        return option_label(option, self, check_language(language))

    def reason(self, option: OptionVerdict, language: str = "en") -> str:
        """Return why an option stands where it does, in one plain sentence, in "en" or "ja"."""
        from stayput.verification.room_words import change_sentence
        from stayput.verification.words import reason

        if self.scenario.plan is None or option.change is None:
            return reason(option, self, check_language(language))
        return change_sentence(option, self, check_language(language))

    def grade(self, option: OptionVerdict) -> Grade:
        """Return the grade of an option: that of its weakest input; see `stayput.verification.options`."""
        from stayput.verification.options import grade

        return grade(option.option, self.scenario)

    def notes(self, language: str = "en") -> tuple[str, ...]:
        """Return the notes beside the numbers, in "en" or "ja"; see `stayput.verification.notes`."""
        from stayput.catalogue import say
        from stayput.verification.notes import notes

        check_language(language)
        return tuple(say(note, language) for note in notes(self))

    def to_dataset(self) -> xr.Dataset:
        """Return probabilities and quantiles over ``option``, ``piece``, ``event``, with units in attrs."""
        from stayput.report.verdict.data import verdict_dataset

        return verdict_dataset(self)

    def to_json(self) -> str:
        """Return the verdict as JSON; keys carry their units."""
        from stayput.report.verdict.data import json_text, verdict_data

        return json_text(verdict_data(self))

    def to_markdown(self, language: str = "en") -> str:
        """Return the verdict as Markdown, in "en" or "ja"."""
        from stayput.report.room.report import room_markdown
        from stayput.report.verdict.tables import verdict_markdown

        written = verdict_markdown if self.scenario.plan is None else room_markdown
        return written(self, check_language(language))

    def to_csv(self) -> str:
        """Return the ranking as CSV, or of a room all probabilities."""
        from stayput.report.verdict.data import room_csv
        from stayput.report.verdict.tables import verdict_csv

        return (verdict_csv if self.scenario.plan is None else room_csv)(self)
