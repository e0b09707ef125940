"""How the server refuses: one sentence in both languages, and the field that it is about."""

from __future__ import annotations

import json
from collections.abc import Generator, Mapping
from contextlib import contextmanager
from typing import Any

from starlette.exceptions import HTTPException
from starlette.responses import Response

from stayput.app.replies import Problem
from stayput.catalogue import phrase
from stayput.errors import LONGEST_SENTENCE, InputError, InputWarning, warnings_to
from stayput.motion.units import known_unit
from stayput.scenario.messages import shown

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
