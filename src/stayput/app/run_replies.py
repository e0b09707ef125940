"""Replies about runs, in the plane with histories as arrays, in space with the scene that the page draws."""

from __future__ import annotations

from typing import Any, Literal

from pydantic import Field

from stayput.app.replies import Reply, TwoNumbers, Words


class BodyReply(Reply):
    """The body that was simulated."""

    width_m: float
    height_m: float
    mass_kg: float
    inertia_kg_m2: float
    centre_of_gravity_m: TwoNumbers = Field(description="From the middle of the base.")
    corners_m: list[TwoNumbers] = Field(description="Base left, base right, top right, top left, from G.")
    base_heights_m: TwoNumbers
    resting_tilt_rad: float = Field(description="Tilt at rest, to which `tilt_rad` adds.")
    slenderness_rad: float


class RoomReply(Reply):
    """Where the faces of the room stand; x = 0 is the middle of the base at the start."""

    left_wall_x_m: float | None
    right_wall_x_m: float | None
    ceiling_z_m: float | None


class EventReply(Reply):
    """What happened at an instant."""

    time_s: float
    kind: str
    mode: str


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
    pull_n: list[float] = Field(description="At the run's times.")
    shear_n: list[float]


class ShapeReply(Reply):
    """A line or a filled outline of a device, points in the body's or the room's frame."""

    kind: Literal["line", "polygon"]
    points: list[tuple[Literal["body", "room"], float, float]]
    role: str
    device: int | None
    when: Literal["always", "whole", "broken"]


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
    residual_slide_m: TwoNumbers | None = Field(description="Along x and y, at the end.")
    residual_yaw_rad: float | None = Field(description="Turn about the vertical, at the end.")
    floor_impacts: int
    wall_impacts: int
    impacts_on_bodies: int


class PiecesReply(FateReply):
    """What became of the pieces of a run, and when the first one overturned."""

    sentence: Words
    pieces: list[PieceReply]


class RunReply(PiecesReply):
    """One run in the plane."""

    body: BodyReply
    room: RoomReply
    time_s: list[float]
    x_m: list[float] = Field(description="Centre of gravity in the room.")
    z_m: list[float]
    tilt_rad: list[float]
    slide_m: list[float]
    modes: list[tuple[float, str]] = Field(description="When each mode starts.")
    events: list[EventReply]
    events_total: int = Field(description="How many there were.")
    events_cut: bool = Field(description="Whether only the first ones and the last are listed.")
    devices: list[DeviceReply]
    shapes: list[ShapeReply]


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


class FloorReply(Reply):
    """How the floor moves in a picture, over the whole motion."""

    time_s: list[float]
    x_m: list[float] = Field(description="Displacement without its slow drift, times scale_shown.")
    acceleration_m_s2: list[float] = Field(description="The largest of each frame, with its sign.")
    scale_shown: float


class ViewReply(Reply):
    """What part of the room is worth showing, for all runs."""

    left_m: float
    right_m: float
    low_m: float
    high_m: float
    grid_m: float = Field(description="Distance of marks that stand still.")


class BuildingReply(Reply):
    """The building between the ground and the furniture."""

    storeys: int
    storey: int
    structure: str | None
    ground_x_m: list[float] = Field(description="Displacement of the ground, as the floor's.")
    roof_x_m: list[float] = Field(description="Displacement of the roof, as the floor's.")


class SimulateReply(Reply):
    """A scene run in the plane without and with measures."""

    dimensions: Literal[2] = 2
    motion: MotionOfRun
    floor: FloorReply
    view: ViewReply
    building: BuildingReply | None
    without: RunReply
    with_: RunReply | None = Field(serialization_alias="with")


class SpaceEventReply(Reply):
    """What happened to a piece at an instant."""

    time_s: float
    kind: str
    piece: int = Field(description="Its number, from 0 on.")


class SpaceRunReply(PiecesReply):
    """One run in space."""

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
