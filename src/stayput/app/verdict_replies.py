"""Replies about verifications: jobs and verdicts."""

from __future__ import annotations

from typing import Any, Literal

from pydantic import Field

from stayput.app.replies import Problem, Reply, Words
from stayput.app.room_replies import RoomVerdictReply  # noqa: TC001 - pydantic reads the annotations


class ChanceReply(Reply):
    """A probability with its 95 % interval."""

    estimate: float | None
    low: float
    high: float
    text: str


class ChangeReply(Reply):
    """A probability less that without a measure."""

    estimate: float | None
    low: float | None
    high: float | None
    clear: bool


class QuantilesReply(Reply):
    """Median and 90 % quantile; null where so many overturn."""

    median: float | None
    p90: float | None


class CapacityReply(Reply):
    """An intensity of the ground; null where the runs do not say.

    It lies above and below intensities that were run; low and high are the ends of its 95 % interval, of
    which there is none with one motion.
    """

    estimate: float | None
    low: float | None
    high: float | None
    above: float | None
    below: float | None
    one_motion: bool
    text: str


class CapacitiesReply(Reply):
    """Intensities at which a tenth and a half overturn."""

    p10: CapacityReply
    p50: CapacityReply


class ObservedReply(Reply):
    """Share that overturned at a level."""

    intensity: float
    estimate: float | None
    low: float
    high: float


class CurveReply(Reply):
    """Probability of overturning over the ground's JMA intensity; no band where there was one motion."""

    state: str
    method: str
    text: str
    intensity: list[float]
    probability: list[float] | None
    low: list[float] | None
    high: list[float] | None
    observed: list[ObservedReply]


class DeviceSummaryReply(Reply):
    """What became of one device over all runs."""

    kind: str
    name: str
    label: Words
    failed: ChanceReply
    peak_n: QuantilesReply


class ContentsReply(Reply):
    """What comes out of the furniture, and how often it overturns with its contents fixed and without."""

    contents_out_share: float | None
    contents_out_share_low: float | None
    contents_out_share_high: float | None
    contents_runs: int = Field(description="Runs in which the contents were followed.")
    contents_toppled_share: float | None
    contents_out_mass_kg: float | None
    contents_leaving_height_m_median: float | None = Field(description="Of what leaves a piece that stands.")
    contents_leaving_height_m_most: float | None
    contents_leaving_speed_m_s_median: float | None = Field(description="Horizontal, beside the floor.")
    contents_leaving_speed_m_s_p90: float | None
    overturned_contents_fixed: float | None
    overturned_contents_fixed_low: float | None
    overturned_contents_fixed_high: float | None
    overturned_without_contents: float | None
    overturned_without_contents_low: float | None
    overturned_without_contents_high: float | None
    overturned_drawers_open: float | None
    overturned_drawers_open_low: float | None
    overturned_drawers_open_high: float | None


class AsInstalledReply(Reply):
    """A measure as people install it: well, or in a share of the homes badly."""

    badly_share: float
    badly: dict[str, ChanceReply] = Field(description="Each event where it is badly installed.")
    usual: dict[str, float | None] = Field(description="Each event as people install it.")
    how: list[Words] = Field(description="What is wrong where it is badly installed.")


class OptionReply(Reply):
    """One of the things that may be done."""

    rank: int
    name: str
    label: Words
    measures: list[dict[str, Any]]
    reason: Words
    asides: list[Words] = Field(
        description="What comes out, and how often it overturns as people install it, where that is asked."
    )
    grade: str = Field(description="How well founded its numbers are: A, B or C; see grades.")
    weakest: list[Words] = Field(description="The inputs of that grade.")
    yours: bool
    overturned: ChanceReply
    slid: ChanceReply
    hit_wall: ChanceReply
    device_failed: ChanceReply
    change: ChangeReply | None
    slide_m: QuantilesReply
    tilt_rad: QuantilesReply
    devices: list[DeviceSummaryReply]
    as_installed: AsInstalledReply | None = Field(
        description="Where the scene asks for it, and it can be badly installed."
    )
    contents: ContentsReply | None = Field(description="Where the scene says what is in the furniture.")
    capacity: CapacitiesReply | None
    curve: CurveReply | None


class ImpossibleReply(Reply):
    """A set of measures that cannot be put in place: it has no numbers."""

    name: str
    label: Words
    reason: Words


class EquipmentLoadReply(Reply):
    """Static load of a class of the Japanese guideline for building equipment, and what it does."""

    equipment_class: str
    position: str
    k_h: float
    overturns: bool
    tie_force_n: float


class EstimateReply(Reply):
    """One formula or standard in words."""

    formula: Words
    says: Words
    beside: Words = Field(description="The simulation beside it.")


class EstimatesReply(Reply):
    """Quick estimates by formulas, for the piece without measures."""

    rows: list[EstimateReply] = Field(description="The same in words.")

    rocking_acceleration_m_s2: float
    overturning_velocity_m_s: float
    possible: float
    overturning_ratio: float
    equipment_loads: list[EquipmentLoadReply]
    ac156_height_ratio: float | None = Field(description="z/h of the floor where the piece stands.")
    ac156_rocking_s_ds_g: float | None = Field(
        description="S_DS from which on a shake-table test by AC156 rocks the piece."
    )
    asce43_sliding_share: float = Field(description="Share of the motions that make it slide by ASCE 43.")
    asce43_sliding_median_m: float | None = Field(
        description="Median distance under those; null where none does."
    )


class TipOverReply(Reply):
    """Moments about the front edge in one case without an earthquake."""

    case: str
    label: Words
    restoring_moment_n_m: float
    overturning_moment_n_m: float
    margin: float | None = Field(description="The one over the other; null where nothing overturns it.")
    tips_over: bool


class EverydayReply(Reply):
    """What the piece withstands without an earthquake."""

    sentence: Words = Field(description="The worst case.")
    cases: list[TipOverReply] = Field(description="The smallest margin first.")


class VerdictReply(Reply):
    """The outcome of a verification, the best option first."""

    complete: bool = Field(description="Whether it is final; else samples or curves are still to come.")
    headline: Words
    notes: list[Words] = Field(description="What must be said beside the numbers.")
    grades: dict[str, Words] = Field(description="What each grade of inputs means.")
    intensity: float | None
    intensity_class: str | None
    slide_limit_m: float
    motions: int
    samples: int
    runs: int
    settled_runs: int = Field(description="Runs that were not made: stronger shaking told their outcome.")
    precise: bool
    seed: int
    seconds: float
    options: list[OptionReply]
    not_possible: list[ImpossibleReply]
    estimates: EstimatesReply
    everyday: EverydayReply


class JobReply(Reply):
    """A verification that is under way or done."""

    id: str
    state: Literal["waiting", "running", "done", "cancelled", "failed"]
    done: int
    total: int
    progress: float
    seconds: float
    position: int | None = Field(description="How many jobs have their turn before it, while it waits.")
    error: Problem | None
    result: VerdictReply | RoomVerdictReply | None = Field(
        description="As far as it is known; final once it is `complete`."
    )
