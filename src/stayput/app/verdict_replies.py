"""Replies about verifications, of a piece and of a room: jobs and verdicts."""

from __future__ import annotations

from typing import Any, Literal

from pydantic import Field

from stayput.app.replies import Problem, Reply, Words


class ShareReply(Reply):
    """A probability with its 95 % interval, or a change of one."""

    estimate: float | None
    low: float | None
    high: float | None


class ChanceReply(ShareReply):
    """A probability, and its text."""

    text: str


class ChangeReply(ShareReply):
    """A probability less that without a measure."""

    clear: bool


class QuantilesReply(Reply):
    """Median and 90 % quantile; null where so many overturn."""

    median: float | None
    p90: float | None


class CapacityReply(ShareReply):
    """An intensity of the ground; null where the runs do not say.

    It lies above and below intensities that were run; low and high are the ends of its 95 % interval, of
    which there is none with one motion.
    """

    above: float | None
    below: float | None
    one_motion: bool
    text: str


class CapacitiesReply(Reply):
    """Intensities at which a tenth and a half overturn."""

    p10: CapacityReply
    p50: CapacityReply


class ObservedReply(ShareReply):
    """Share that overturned at a level."""

    intensity: float


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
    contents: dict[str, int | float | None] | None = Field(
        description="Where the scene says what is in the furniture: what comes out, and how often it "
        "overturns with its contents fixed and without, by the names of the table's columns."
    )
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


class ZoneReply(Reply):
    """A share of the runs on each cell of the floor."""

    nx: int
    ny: int
    shares: str = Field(description="Base 64 of bytes, 255 being 1: all y of the first x, then the next.")


class RoomHitReply(Reply):
    """How a piece hits the place of a person."""

    piece: str
    mass_kg: float
    probability: ShareReply
    speed_m_s: QuantilesReply = Field(description="Of the part of the piece that comes into the place.")
    energy_J: QuantilesReply = Field(description="Kinetic energy of the piece.")  # noqa: N815 - SI's letter


class RoomPlaceReply(Reply):
    """What happens at the place of a person."""

    name: str
    hit: ShareReply
    hit_by_day: float | None = Field(description="That somebody is there by day and is hit.")
    hit_at_night: float | None
    shut_in: ShareReply
    by: list[RoomHitReply]


class RoomDoorReply(Reply):
    """Whether a door can be used afterwards."""

    name: str
    blocked: ShareReply
    blocked_at_rest: bool


class RoomPieceReply(Reply):
    """What becomes of a piece."""

    name: str
    engine: str
    probabilities: dict[str, ShareReply]
    peak_slide_m: QuantilesReply
    falls: bool = Field(description="Whether it overturns so often that it is to be held.")
    risk: float | None
    outline_m: list[tuple[float, float]]
    fell: ZoneReply = Field(description="Where it lies having overturned: its fall zone.")
    stood: ZoneReply = Field(description="Where it ends without having overturned: its slide zone.")


class CollisionReply(Reply):
    """Two pieces that meet."""

    pieces: tuple[str, str]
    probability: ShareReply


class RoomChangeReply(Reply):
    """What a single change of the room brings."""

    what: str
    table: str = Field(description="Where it is in the scene: furniture or places.")
    label: Words
    sentence: Words
    measure: str | None
    drilled: bool = Field(description="Whether it takes holes in a wall.")
    measures: list[dict[str, Any]] | None = Field(description="What is put on the piece, as in a scene.")
    at_m: tuple[float, float] | None
    heading_rad: float | None
    hit: ShareReply
    hit_change: ShareReply
    shut_in: ShareReply
    shut_in_change: ShareReply
    overturned: ShareReply | None = Field(description="That the piece overturns with it; of a place, null.")
    overturned_change: ShareReply | None
    risk: float | None
    helps: bool
    better: list[str] = Field(description="What it clearly betters: hit, shut_in, blocked, overturned.")
    worse: list[str]
    tags: list[Words] = Field(description="The same in words; that nothing is clear, where nothing is.")


class TypicalRunReply(Reply):
    """A run in which what happens most often happens."""

    member: int = Field(description="Which of the motions, from 1 on.")
    direction_rad: float


class RoomVerdictReply(Reply):
    """The verdict on a room."""

    complete: bool = Field(description="Whether it is final; else runs and changes are still to come.")
    verdict: Words
    best: Words
    jma_intensity: float | None
    intensity_class: str | None
    motions: int
    samples: int
    runs: int
    seed: int
    seconds: float | None
    hit: ShareReply
    shut_in: ShareReply
    risk: float | None
    places: list[RoomPlaceReply]
    doors: list[RoomDoorReply]
    pieces: list[RoomPieceReply]
    cell_m: float
    collisions: list[CollisionReply]
    changes: list[RoomChangeReply]
    typical: TypicalRunReply | None = Field(description="A run to look at.")


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


class PlanProgressReply(Reply):
    """How far a plan to buy and do has come."""

    made: bool = Field(description="Whether it is there, and comes at once.")
    runs: int = Field(description="Runs of pieces made for it so far.")
