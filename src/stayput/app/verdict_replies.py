"""Replies about verifications, of a piece and of a room: jobs and verdicts.

A verdict is sent as its JSON file has it. Described here is what a program needs first, and what only the
server says; the further keys of the file come with it.
"""

from __future__ import annotations

from typing import Any, Literal

from pydantic import ConfigDict, Field

from stayput.app.replies import Problem, Reply, Words


class PartReply(Reply):
    """A part of a verdict, with all that the verdict's JSON file says of it."""

    model_config = ConfigDict(extra="allow")


class ShareReply(PartReply):
    """A probability with its 95 % interval, or a change of one."""

    estimate: float | None
    low: float | None
    high: float | None


class CurveReply(Reply):
    """Probability of overturning over the ground's JMA intensity; no band where there was one motion."""

    state: str
    method: str
    text: str
    intensity: list[float]
    probability: list[float] | None
    low: list[float] | None
    high: list[float] | None
    observed: list[ShareReply] = Field(description="At the levels that were run, each an intensity `im`.")


class OptionReply(PartReply):
    """One of the things that may be done."""

    rank: int
    name: str
    label: Words
    measures: list[dict[str, Any]] = Field(description="As a scene has them.")
    reason: Words
    asides: list[Words] = Field(
        description="What comes out, and how often it overturns as people install it, where that is asked."
    )
    grade: str = Field(description="How well founded its numbers are: A, B or C; see grades.")
    weakest: list[Words] = Field(description="The inputs of that grade.")
    yours: bool
    probabilities: dict[str, ShareReply]
    overturned_change: ShareReply | None = Field(description="Less the probability without measures.")
    curve: CurveReply | None


class EverydayReply(Reply):
    """What the piece withstands without an earthquake."""

    sentence: Words = Field(description="The worst case.")
    cases: list[dict[str, Any]] = Field(description="Moments about the front edge, least margin first.")


class VerdictReply(PartReply):
    """The outcome of a verification, the best option first."""

    complete: bool = Field(description="Whether it is final; else samples or curves are still to come.")
    verdict: Words
    notes: list[Words] = Field(description="What must be said beside the numbers.")
    grades: dict[str, Words] = Field(description="What each grade of inputs means.")
    jma_intensity: float | None
    motions: int
    samples: int
    runs: int
    seconds: float
    options: list[OptionReply]
    not_possible: list[dict[str, Any]] = Field(description="Options that cannot be put in place, and why.")
    estimates: dict[str, Any] = Field(description="By formulas, without measures; `rows` are in words.")
    everyday: EverydayReply


class ZoneReply(Reply):
    """A share of the runs on each cell of the floor."""

    nx: int
    ny: int
    shares: str = Field(description="Base 64 of bytes, 255 being 1: all y of the first x, then the next.")


class RoomPieceReply(PartReply):
    """What becomes of a piece."""

    name: str
    probabilities: dict[str, ShareReply]
    falls: bool = Field(description="Whether it overturns so often that it is to be held.")
    stability: str = Field(description="How firmly it stands: stays, moves, may_fall or falls.")
    fell: ZoneReply = Field(description="Where it lies having overturned: its fall zone.")
    stood: ZoneReply = Field(description="Where it ends without having overturned: its slide zone.")


class RoomChangeReply(PartReply):
    """What a single change of the room brings."""

    what: str
    table: str = Field(description="Where it is in the scene: furniture or places.")
    label: Words
    sentence: Words
    measures: list[dict[str, Any]] | None = Field(description="What is put on the piece, as in a scene.")
    hit_change: ShareReply
    helps: bool


class TypicalRunReply(Reply):
    """A run in which what happens most often happens."""

    member: int = Field(description="Which of the motions, from 1 on.")
    direction_rad: float


class RoomVerdictReply(PartReply):
    """The verdict on a room."""

    complete: bool = Field(description="Whether it is final; else runs and changes are still to come.")
    verdict: Words
    best: Words
    motions: int
    samples: int
    runs: int
    hit: ShareReply
    shut_in: ShareReply
    places: list[dict[str, Any]] = Field(description="What happens at the places of people.")
    doors: list[dict[str, Any]] = Field(description="Whether each can be used afterwards.")
    pieces: list[RoomPieceReply]
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
