"""Replies about rooms: the verdict as plain data."""

from __future__ import annotations

from typing import Any

from pydantic import Field

from stayput.app.replies import Reply, Words


class ShareReply(Reply):
    """A probability with its 95 % interval, or a change of one."""

    estimate: float | None
    low: float | None
    high: float | None


class ZoneReply(Reply):
    """A share of the runs on each cell of the floor."""

    nx: int
    ny: int
    shares: str = Field(description="Base 64 of bytes, 255 being 1: all y of the first x, then the next.")


class SpreadReply(Reply):
    """Median and 90 % quantile; null where there is none."""

    median: float | None
    p90: float | None


class RoomHitReply(Reply):
    """How a piece hits the place of a person."""

    piece: str
    mass_kg: float
    probability: ShareReply
    speed_m_s: SpreadReply = Field(description="Of the part of the piece that comes into the place.")
    energy_J: SpreadReply = Field(description="Kinetic energy of the piece.")  # noqa: N815 - SI's letter


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
    peak_slide_m: SpreadReply
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


class PlanProgressReply(Reply):
    """How far a plan to buy and do has come."""

    made: bool = Field(description="Whether it is there, and comes at once.")
    runs: int = Field(description="Runs of pieces made for it so far.")
