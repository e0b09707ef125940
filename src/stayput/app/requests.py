"""Request bodies of the API, and its description (OpenAPI 3.1) with the schemas of scenes and measures."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from functools import cache
from typing import Annotated, Any

from fastapi import FastAPI, UploadFile
from fastapi import Path as InPath
from pydantic import BaseModel, ConfigDict, Field, TypeAdapter, WithJsonSchema

from stayput.montecarlo.counting import SLIDE_LIMIT
from stayput.scenario import Scenario
from stayput.scenario.measures import MeasureTable, SingleChoice

STANDS_FOR = "x-stands-for"
"""Mark, in a schema, of what stands in the description of the API under a name of its own."""

SceneData = Annotated[dict[str, Any], WithJsonSchema({STANDS_FOR: "Scenario"})]
"""A scene as it came: it is checked by `stayput.app.scenes`, off the event loop."""

SlideLimit = Annotated[float, Field(ge=0.0, le=100.0, description="Slide that counts as too far.")]

Lease = Annotated[
    Annotated[float, Field(ge=1.0, le=3600.0)] | None,
    Field(description="The job ends when nobody has asked for it for so long; null: it goes on to its end."),
]

MeasureData = Annotated[dict[str, Any], WithJsonSchema({STANDS_FOR: "Measure"})]
"""A measure as it came."""

ID = "[0-9a-f]{32}(?:_floor_[0-9]+|_roof|_upper_floor)?"
"""Pattern of an uploaded motion's id, its file's name here, with the upper floor that the user's tells."""

Name = Annotated[str, InPath(pattern=f"^{ID}$", description="An id that this server gave.")]

Measures = Annotated[
    list[MeasureData], Field(default_factory=list, max_length=8, description="In place together.")
]


class Request(BaseModel):
    """A body; unknown keys are refused."""

    model_config = ConfigDict(extra="forbid", strict=True, allow_inf_nan=False)


class SceneRequest(Request):
    """A scene."""

    scene: SceneData


class MeasuredRequest(SceneRequest):
    """A scene, and the measures that hold its piece; what is of several pieces has its own."""

    measures: Measures


class RunRequest(MeasuredRequest):
    """A scene that is run once."""

    sample: Annotated[
        Annotated[int, Field(ge=0, le=1_000_000)] | None,
        Field(
            description="Of several pieces, the run of a verdict: that of this sample, from 0, of the "
            "motion; else what stands is run as it is stated."
        ),
    ] = None


class VerificationRequest(SceneRequest):
    """A scene to be verified as a job."""

    slide_limit_m: SlideLimit = SLIDE_LIMIT
    lease_s: Lease = None


class VerifyRequest(VerificationRequest, MeasuredRequest):
    """A piece to be verified."""

    compare_usual: bool = Field(default=True, description="Whether the usual measures are compared too.")
    curves: bool = Field(default=True, description="Whether fragility curves are made, which takes longer.")


class RoomRequest(VerificationRequest):
    """A room to be verified."""

    before: Annotated[
        SceneData | None,
        Field(
            description="The same room before the changes that are tried in it: a plan to buy and do begins "
            "there, and has them as steps."
        ),
    ] = None
    changes: bool = Field(default=True, description="Whether single changes are tried, which takes longer.")


class ReadRequest(Request):
    """A scenario file to be read as a scene."""

    toml: str = Field(description="The file's text.")
    name: str = Field(default="scenario.toml", max_length=255, description="What a refusal calls the file.")


class Upload(BaseModel):
    """The form of an upload."""

    model_config = ConfigDict(extra="forbid", allow_inf_nan=False, str_strip_whitespace=True)

    file: UploadFile = Field(description="A record's file.")
    unit: str | None = Field(default=None, max_length=20, description="Where the file states none.")
    dt: float | None = Field(default=None, description="Time step [s], where the file states none.")
    component: str | None = Field(default=None, max_length=60, description="Channel of x.")
    remove_mean: bool = Field(default=False, description="Whether the mean of each component is taken off.")


REFERENCE = "#/components/schemas/{model}"
"""Where a schema stands."""

_MARKED = re.compile(rf'{{[^{{}}]*"{STANDS_FOR}": "(\w+)"[^{{}}]*}}')
_REFERRED = r'{"$ref": "#/components/schemas/\1"}'

UNUSED = ("HTTPValidationError", "ValidationError")
"""FastAPI's own form of errors, which this server does not use."""


def described(app: FastAPI) -> Callable[[], dict[str, Any]]:
    """Return the function that makes the description of an app, once."""
    generate = app.openapi

    @cache
    def description() -> dict[str, Any]:
        document = generate()
        schemas = document["components"]["schemas"]
        scene = Scenario.schema(ref_template=REFERENCE)
        schemas |= {**scene.pop("$defs"), "Scenario": scene}
        measure = TypeAdapter[MeasureTable](SingleChoice).json_schema(ref_template=REFERENCE)
        measure.pop("$defs", None)
        schemas["Measure"] = measure
        for name in UNUSED:
            schemas.pop(name, None)
        return json.loads(_MARKED.sub(_REFERRED, json.dumps(document)))

    return description
