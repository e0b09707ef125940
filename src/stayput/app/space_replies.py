"""Replies about runs in space: what became of each piece, and the scene that the page draws."""

from __future__ import annotations

from typing import Any, Literal

from pydantic import Field

from stayput.app.replies import Reply, TwoNumbers, Words
from stayput.app.run_replies import (  # noqa: TC001 - pydantic reads the annotations
    BuildingReply,
    DeviceReply,
    MotionOfRun,
)


class PieceReply(Reply):
    """What became of one piece."""

    name: str
    outcome: str
    overturned: bool
    overturn_time_s: float | None
    fell_off: bool = Field(description="Whether it came off what it stood on.")
    fall_time_s: float | None
    peak_tilt_rad: float | None = Field(description="Largest angle to how it stood, in any direction.")
    peak_slide_m: float | None = Field(description="Farthest from where it stood, in plan.")
    residual_slide_m: TwoNumbers | None = Field(description="Along x and y, at the end.")
    residual_yaw_rad: float | None = Field(description="Turn about the vertical, at the end.")
    floor_impacts: int
    wall_impacts: int
    impacts_on_bodies: int


class SpaceEventReply(Reply):
    """What happened to a piece at an instant."""

    time_s: float
    kind: str
    piece: int = Field(description="Its number, from 0 on.")


class SpaceRunReply(Reply):
    """One run in space."""

    outcome: str = Field(description="That of the piece that fared worst.")
    sentence: Words
    overturned: bool = Field(description="Whether any piece did.")
    overturn_time_s: float | None = Field(description="When the first one did.")
    pieces: list[PieceReply]
    events: list[SpaceEventReply] = Field(
        description="When each piece first slides, lifts an edge and overturns, and first hits on the room."
    )
    devices: list[DeviceReply] = Field(description="Their forces are at the times of the poses.")
    scene: dict[str, Any] = Field(
        description="Bodies and room, as the method `data` of `stayput.report.space.scene.SpaceScene` "
        "describes them; long histories are the base 64 of 32-bit floating-point numbers, least byte first."
    )


class HitReply(Reply):
    """A piece that comes into the place of a person."""

    piece: str
    place: str


class RunInRoomReply(Reply):
    """What happens to people, doors and ways out in a run of a room."""

    hits: list[HitReply]
    blocked: list[str] = Field(description="Doors that are blocked at the end.")
    shut_in: list[str] = Field(description="Places from which no way leads out at the end.")


class SpaceSimulateReply(Reply):
    """A scene run in space without and with measures, or several pieces."""

    dimensions: Literal[3] = 3
    motion: MotionOfRun
    floor: dict[str, Any] = Field(description="How the floor moves, of the same form as the runs' scenes.")
    building: BuildingReply | None
    in_room: RunInRoomReply | None = Field(default=None, description="Of a room: what happens in it.")
    without: SpaceRunReply
    with_: SpaceRunReply | None = Field(default=None, serialization_alias="with")
