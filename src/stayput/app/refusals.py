"""How the server refuses: one sentence, and the field that it is about."""

from __future__ import annotations

import json
import re

from starlette.responses import Response

from stayput.app.japanese import wording_of

_PLACE = re.compile(
    r"In \[(?P<table>[a-z_.]+)\]:|(?P<name>[a-z_]+(?:\.[a-z_]+|\[\d+\])*) (?:is|follows|has|gives)\b"
)

LONGEST = 600
"""Longest sentence that is sent [characters]."""


class RefusedError(Exception):
    """A request that is refused.

    Parameters
    ----------
    status : int
        HTTP status.
    message : str
        One sentence.
    field : str, optional
        Dotted name of what is wrong.
    retry_after : int, optional
        When it may be tried again [s].
    """

    def __init__(
        self, status: int, message: str, field: str | None = None, retry_after: int | None = None
    ) -> None:
        super().__init__(message)
        self.status = status
        self.message = message
        self.field = field
        self.retry_after = retry_after

    def response(self) -> Response:
        """Return the answer."""
        headers = {} if self.retry_after is None else {"Retry-After": str(self.retry_after)}
        return error_response(self.status, self.message, self.field, headers)


def error_response(
    status: int, message: str, field: str | None = None, headers: dict[str, str] | None = None
) -> Response:
    """Return an error as JSON; in ASCII, since the message may quote half a character of the input."""
    japanese, _ = wording_of(message)
    told = {
        "message": _short(message),
        "message_ja": japanese and _short(japanese),
        "field": field and field[:LONGEST],
    }
    return Response(json.dumps(told).encode("ascii"), status, headers, "application/json")


def _short(text: str) -> str:
    return text if len(text) <= LONGEST else f"{text[:LONGEST]}…"


def field_of(sentence: str, tables: tuple[str, ...]) -> str | None:
    """Return the key of a scene that a sentence is about: "scene.room.left_wall.gap".

    Parameters
    ----------
    sentence : str
        What a scenario's check said.
    tables : tuple of str
        Names of a scenario's keys.
    """
    found = _PLACE.match(sentence)
    if found is None:
        return None
    place = found["table"] or found["name"]
    return f"scene.{place}" if re.split(r"[.\[]", place)[0] in tables else None
