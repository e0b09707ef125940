"""Replies of the API: what all of them share, presets and motions."""

from __future__ import annotations

import re
from typing import Any, Literal, Self

from pydantic import BaseModel, ConfigDict, Field

TwoNumbers = tuple[float, float]

_UNIT = re.compile("_(bytes|count|kg|m|m_s|m_s2|n|rad|s)$")


class Reply(BaseModel):
    """An answer; what is not finite is null."""

    model_config = ConfigDict(ser_json_inf_nan="null")

    @classmethod
    def from_attributes(cls, source: object, **known: Any) -> Self:
        """Make it of an object's attributes, which are named like its fields, without their units.

        Parameters
        ----------
        source : object
            The object.
        **known
            Values of fields that are no such attributes.
        """
        others = [name for name in cls.model_fields if name not in known]
        return cls(**{name: getattr(source, _UNIT.sub("", name)) for name in others}, **known)


class Words(Reply):
    """A text in both languages."""

    en: str
    ja: str

    @classmethod
    def of(cls, pair: tuple[str, str]) -> Words:
        """Make it of a pair."""
        return cls(en=pair[0], ja=pair[1])


class Problem(Reply):
    """Why a request was refused, or what of an upload may not be as it was meant."""

    message: str = Field(description="One sentence.")
    message_ja: str | None = Field(default=None, description="The same in Japanese.")
    field: str | None = Field(default=None, description="Dotted name of what is wrong.")
    perhaps: str | None = Field(default=None, description="What the field may be, as its file hints.")
    also: list[str] = Field(default=[], description="Further fields that must be given with it.")


class PingReply(Reply):
    """Whether the server is there."""

    status: Literal["ok"] = "ok"
    ready: bool = Field(description="Whether everything is compiled.")
    version: str


class SceneReply(Reply):
    """A scenario file as a scene."""

    scene: dict[str, Any]
    pieces: list[str] = Field(description="What its pieces are called, where it is of several; else none.")


class NamedReply(Reply):
    """A name that is shown."""

    id: str
    label: Words


class FurnitureReply(NamedReply):
    """A preset of furniture."""

    width_m: float
    height_m: float
    length_m: float = Field(description="Across its depth.")
    mass_kg: float
    carcass_mass_kg: float | None
    shelves: int | None
    drawers: int = Field(description="Drawers that can be open at once.")
    base: str = Field(description="What bears on the floor; see `furniture.base` of the numbers.")
    centre_of_gravity_m: TwoNumbers


class SurfaceReply(NamedReply):
    """A preset of a surface."""

    static_friction: float
    kinetic_friction: float


class StructureReply(NamedReply):
    """A structure of buildings."""

    storey_height_m: float
    damping: float
    most_storeys: int


class FamilyReply(NamedReply):
    """A family of earthquakes."""

    about: Words


class IntensityReply(NamedReply):
    """A class of JMA's intensity."""

    from_: float | None = Field(serialization_alias="from", description="Where it begins.")
    middle: float
    about: Words = Field(description="What people meet.")
    furniture: Words = Field(description="What it does to furniture.")


class ParameterReply(Reply):
    """What is known of a field: a measure's parameter, or a number of a scene."""

    name: str
    default: float | int | str | None
    usual: float | None = Field(description="What it comes to in a usual room, where it has no default.")
    unit: str
    low: float
    high: float
    confidence: str
    label: Words
    choices: list[str]
    whole: bool


class MeasureReply(Reply):
    """A kind of measure."""

    type: str
    label: Words
    about: Words
    place: str | None = Field(description="Two measures of one place exclude each other.")
    needs: list[Literal["wall", "ceiling"]]
    usual: bool
    parameters: list[ParameterReply]


class LimitsReply(Reply):
    """What the server accepts."""

    body_bytes: int
    upload_bytes: int
    duration_s: float
    suite_count: int
    samples: int
    jobs_running: int
    jobs_waiting: int
    motions: int
    storeys: int


class PlaceReply(NamedReply):
    """A common place of a person in a room."""

    width_m: float
    length_m: float
    low_m: float = Field(description="Height above the floor from which the person is.")
    high_m: float
    day: float = Field(description="Share of the day in which somebody is there.")
    night: float
    blocks: bool = Field(description="Whether nobody walks there.")


class PresetsReply(Reply):
    """Everything that can be chosen."""

    version: str
    furniture: list[FurnitureReply]
    surfaces: list[SurfaceReply]
    contents: list[NamedReply]
    doors: list[NamedReply]
    structures: list[StructureReply]
    families: list[FamilyReply]
    intensities: list[IntensityReply]
    measures: list[MeasureReply]
    numbers: dict[str, ParameterReply] = Field(
        description="Numbers and words of a scene by their dotted names."
    )
    outcomes: list[NamedReply]
    events: list[NamedReply]
    scene: dict[str, Any] = Field(description="A scene to begin with.")
    measures_shown: list[dict[str, Any]]
    places: list[PlaceReply]
    room_scene: dict[str, Any] = Field(description="A room to begin with.")
    films: list[str] = Field(description="The kinds of films that this server can make.")
    limits: LimitsReply


class ChannelReply(Reply):
    """A channel of an uploaded file."""

    name: str = Field(description="What chooses it.")
    vertical: bool
    used: bool = Field(description="Whether it is the one along the shaking, x.")


class MotionReply(Reply):
    """An uploaded motion."""

    id: str
    name: str
    source: str
    synthetic: bool
    duration_s: float
    dt_s: float
    samples: int
    components: list[str]
    channels: list[ChannelReply]
    pga_m_s2: float
    pgv_m_s: float
    intensity: float | None
    intensity_class: str | None
    expires_in_s: float
    floor: str = Field(description="Upper floor of a building that it was recorded on; empty otherwise.")
    warnings: list[Problem] = Field(description="What is doubtful about the file.")
    shaking: dict[str, Any] = Field(description="What a scene's shaking says to use it.")


class PreviewReply(Reply):
    """A motion's outline: extremes of the acceleration in each piece of time."""

    time_s: list[float]
    low_m_s2: list[float]
    high_m_s2: list[float]


class ShakingReply(Reply):
    """How strongly the ground shakes in a scene: the motions as strong as a verification has them."""

    intensity: float = Field(description="Median JMA intensity of the motions.")
    deviation: float = Field(description="Standard deviation of their JMA intensities.")
    intensity_class: str | None
    sentence: Words = Field(description="The same in words.")
    about: Words | None = Field(description="What was stated, and the source of what it amounts to.")
