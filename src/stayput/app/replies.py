"""What all replies of the API share: each stands beside what makes it."""

from __future__ import annotations

from typing import Any, Self

from pydantic import BaseModel, ConfigDict, Field

from stayput.report.summary import attribute

TwoNumbers = tuple[float, float]


class Reply(BaseModel):
    """An answer; what is not finite is null."""

    model_config = ConfigDict(ser_json_inf_nan="null")

    @classmethod
    def from_attributes(cls, source: object, **known: Any) -> Self:
        """Make it of an object's attributes, which are named like its fields; see `attribute`.

        Parameters
        ----------
        source : object
            The object.
        **known
            Values of fields that are no such attributes.
        """
        others = [name for name in cls.model_fields if name not in known]
        return cls(**{name: attribute(source, name) for name in others}, **known)


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
