"""How the server refuses: one sentence in both languages, and the field that it is about."""

from __future__ import annotations

import json
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from starlette.exceptions import HTTPException
from starlette.responses import Response

from stayput.app.replies import Problem
from stayput.errors import LONGEST_SENTENCE, InputError, warnings_to

if TYPE_CHECKING:
    from collections.abc import Generator, Mapping

    from stayput.errors import InputWarning


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

    def response(self) -> Response:
        """Return the answer."""
        return error_response(self.status_code, self.error, self.headers)


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
    return Problem(message=error.told("en"), message_ja=error.told("ja"), field=field)


def error_response(status: int, error: InputError, headers: Mapping[str, str] | None = None) -> Response:
    """Return an error as JSON; in ASCII, since the message may quote half a character of the input."""
    body = json.dumps(problem(error).model_dump()).encode("ascii")
    return Response(body, status, dict(headers or {}), "application/json")
