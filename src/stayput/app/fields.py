"""Kinds of field that requests and replies share."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field, WithJsonSchema

STANDS_FOR = "x-stands-for"
"""Mark, in a schema, of what stands in the description of the API under a name of its own."""


class Reply(BaseModel):
    """An answer; what is not finite is null."""

    model_config = ConfigDict(ser_json_inf_nan="null")


class Request(BaseModel):
    """A body; unknown keys are refused."""

    model_config = ConfigDict(extra="forbid", strict=True, allow_inf_nan=False)


class Words(Reply):
    """A text in both languages."""

    en: str
    ja: str

    @classmethod
    def of(cls, pair: tuple[str, str]) -> Words:
        """Make it of a pair."""
        return cls(en=pair[0], ja=pair[1])


SceneData = Annotated[dict[str, Any], WithJsonSchema({STANDS_FOR: "Scenario"})]
"""A scene as it came: it is checked by `stayput.app.scenes`, off the event loop."""

MeasureData = Annotated[dict[str, Any], WithJsonSchema({STANDS_FOR: "Measure"})]
"""A measure as it came."""

Measures = Annotated[
    list[MeasureData], Field(default_factory=list, max_length=8, description="In place together.")
]
Pair = tuple[float, float]


class Problem(Reply):
    """Why a request was refused."""

    message: str = Field(description="One sentence.")
    message_ja: str | None = Field(default=None, description="The same in Japanese.")
    field: str | None = Field(default=None, description="Dotted name of what is wrong.")
