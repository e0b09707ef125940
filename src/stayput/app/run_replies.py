"""Replies about runs: what happens in them, and the scenes that the page draws."""

from __future__ import annotations

from typing import Any, Literal

from pydantic import Field

from stayput.app.replies import Reply, TwoNumbers, Words


class EventReply(Reply):
    """What happened to a piece at an instant."""

    time_s: float
    kind: str
    piece: int = Field(description="Its number, from 0 on.")


class DeviceReply(Reply):
    """What became of a device."""

    kind: str
    label: Words
    name: str
    peak_pull_n: float
    peak_push_n: float
    peak_shear_n: float
    utilisation: float | None
    failed: bool
    failure_time_s: float | None
    cause: str | None
    weakest: Words | None = Field(description="What gave way, or would first.")
    pull_n: list[float] = Field(description="At the poses.")
    shear_n: list[float]


class FateReply(Reply):
    """What became of a piece, or of the one that fared worst."""

    outcome: str
    overturned: bool | None
    overturn_time_s: float | None


class PieceReply(FateReply):
    """What became of one piece."""

    name: str
    fell_off: bool | None = Field(description="Whether it came off what it stood on.")
    fall_time_s: float | None
    peak_tilt_rad: float | None = Field(description="Largest angle to how it stood, in any direction.")
    peak_slide_m: float | None = Field(description="Farthest from where it stood, in plan.")
    residual_tilt_rad: float | None
    residual_slide_m: TwoNumbers | None = Field(description="Along x and y, until it fell.")
    residual_yaw_rad: float | None = Field(description="Turn about the vertical, at the end.")
    floor_impacts: int
    wall_impacts: int
    impacts_on_bodies: int


class RunReply(FateReply):
    """What became of the pieces of a run, and when the first one overturned."""

    sentence: Words
    pieces: list[PieceReply]
    events: list[EventReply] = Field(
        description="In the plane all; in space when each piece first slides, lifts an edge and overturns, "
        "and first hits on the room."
    )
    events_total: int = Field(description="How many there were.")
    events_cut: bool = Field(description="Whether only some are listed: in the plane the first and the last.")
    devices: list[DeviceReply]
    scene: dict[str, Any] = Field(
        description="Bodies and room, as the method `data` of `stayput.report.film.scene.FilmScene` "
        "describes them; long histories are the base 64 of 32-bit floating-point numbers, least byte first."
    )


class MotionOfRun(Reply):
    """The motion under the furniture, and the ground's intensity."""

    name: str
    synthetic: bool
    duration_s: float
    dt_s: float
    pga_m_s2: float
    pgv_m_s: float
    ground_intensity: float | None
    ground_class: str | None
    floor_intensity: float | None
    floor_class: str | None


class BuildingReply(Reply):
    """The building between the ground and the furniture."""

    storeys: int
    storey: int
    structure: str | None
    ground_x_m: list[float] = Field(description="Displacement of the ground, as the floor's.")
    roof_x_m: list[float] = Field(description="Displacement of the roof, as the floor's.")


class HitReply(Reply):
    """A piece that comes into the place of a person."""

    piece: str
    place: str


class RunInRoomReply(Reply):
    """What happens to people, doors and ways out in a run of a room."""

    hits: list[HitReply]
    blocked: list[str] = Field(description="Doors that are blocked at the end.")
    shut_in: list[str] = Field(description="Places from which no way leads out at the end.")


class SimulateReply(Reply):
    """A scene run without and with measures, or several pieces."""

    engine: Literal["plane", "space"]
    motion: MotionOfRun
    floor: dict[str, Any] = Field(description="How the floor moves, of the same form as the runs' scenes.")
    building: BuildingReply | None
    in_room: RunInRoomReply | None = Field(default=None, description="Of a room: what happens in it.")
    without: RunReply
    with_: RunReply | None = Field(default=None, serialization_alias="with")
