"""Request bodies of the API, what its replies share, and how it refuses.

A refusal is one sentence in both languages, and the field that it is about. The description (OpenAPI 3.1) has
the schemas of scenes and measures.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Generator, Mapping
from contextlib import contextmanager
from functools import cache
from typing import Annotated, Any, Self

from fastapi import FastAPI, Query, UploadFile
from fastapi import Path as InPath
from pydantic import BaseModel, ConfigDict, Field, TypeAdapter, WithJsonSchema
from starlette.exceptions import HTTPException
from starlette.responses import Response

from stayput.catalogue import phrase
from stayput.errors import LONGEST_SENTENCE, InputError, InputWarning, warnings_to
from stayput.montecarlo.counting import SLIDE_LIMIT
from stayput.motion.units import known_unit
from stayput.report.summary import attribute
from stayput.scenario import Scenario
from stayput.scenario.measures import MeasureTable, SingleChoice
from stayput.scenario.toml import shown

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

FurtherName = Annotated[str | None, Query(pattern=f"^{ID}$", description="An upload of the same record.")]

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
    curves: bool = Field(
        default=True,
        description="Whether curves are made: two in five runs are then at shaking beside the stated.",
    )


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


ALLOWED = {
    "bool": "scenario.true_or_false",
    "dict": "scenario.table",
    "finite": "common.finite_number",
    "float": "common.number",
    "greater": "app.at_least",
    "int": "common.whole_number",
    "less": "app.at_most",
    "list": "common.list",
    "literal": "scenario.one_of",
    "model": "scenario.table",
    "string": "app.words",
    "string_too": "app.characters",
    "too": "app.items",
}
"""What is allowed in a request, by how the type of pydantic's error begins; see `refusal_of_request`."""


class RefusedError(HTTPException):
    """A request that is refused; also while its body is read, where FastAPI lets nothing else through.

    Parameters
    ----------
    status : int
        HTTP status.
    error : InputError
        What is said, and the field that is wrong.
    retry_after : int, optional
        When it may be tried again [s].
    """

    def __init__(self, status: int, error: InputError, retry_after: int | None = None) -> None:
        headers = {} if retry_after is None else {"Retry-After": str(retry_after)}
        super().__init__(status, str(error), headers)
        self.error = error


def refused(
    status: int, code: str, field: str | None = None, *, retry_after: int | None = None, **values: Any
) -> RefusedError:
    """Return a refusal by a sentence of the catalogue."""
    return RefusedError(status, InputError(code, field, **values), retry_after)


@contextmanager
def unprinted() -> Generator[None]:
    """Keep warnings of this thread out of the server's log: who sent a record is told by the reply."""
    with warnings_to(lambda _warning: None):
        yield


def problem(error: InputError | InputWarning) -> Problem:
    """Return an error or a warning as it is sent."""
    field = error.field and error.field[:LONGEST_SENTENCE]
    mentioned = error.values.get("mentioned") if field == "unit" else None
    return Problem(
        message=error.told("en"),
        message_ja=error.told("ja"),
        field=field,
        perhaps=mentioned and known_unit(mentioned),
        also=["dt"] if error.code == "motion.no_unit_nor_step" else [],
    )


def error_response(status: int, error: InputError, headers: Mapping[str, str] | None = None) -> Response:
    """Return an error as JSON; in ASCII, since the message may quote half a character of the input."""
    body = json.dumps(problem(error).model_dump()).encode("ascii")
    return Response(body, status, dict(headers or {}), "application/json")


def refusal_of_request(error: Mapping[str, Any]) -> InputError:
    """Return the refusal of a request by the first error that pydantic found in it."""
    field = ".".join(map(str, error["loc"][1:])) or None  # behind body or query
    name = field or phrase("app.the_body")
    if error["type"] == "missing":
        return InputError("app.field_missing", field, name=name)
    if error["type"] == "extra_forbidden":
        return InputError("app.field_unknown", field, name=name)
    begins = [start for start in ALLOWED if error["type"].startswith(f"{start}_")]
    if not begins:
        return InputError("app.not_valid", field, name=name, message=error["msg"])
    limits = error.get("ctx", {})
    names = limits.get("expected", "").replace(" or ", ", ")
    most = next((limits[key] for key in ("ge", "le", "max_length") if key in limits), 0)
    allowed = phrase(ALLOWED[max(begins, key=len)], names=names, limit=most)
    return InputError(
        "common.not_allowed", field, name=name, value=shown(error["input"]), hint="", allowed=allowed
    )
