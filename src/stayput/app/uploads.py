"""An upload: one file in a form, kept in memory until it has been read."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

from starlette.datastructures import UploadFile
from starlette.formparsers import MultiPartException, MultiPartParser

from stayput.app.refusals import RefusedError

if TYPE_CHECKING:
    from starlette.requests import Request

    from stayput.app.limits import Limits

LONGEST_FIELD = 200
"""Longest field besides the file [bytes]."""


class Upload(NamedTuple):
    """What was sent."""

    data: bytes
    name: str | None
    unit: str | None
    dt: float | None
    component: str | None


async def read_upload(request: Request, limits: Limits) -> Upload:
    """Read the form of an upload.

    Raises
    ------
    RefusedError
        No form, no file, more than one, fields that are too long or not numbers.
    """
    if not request.headers.get("content-type", "").lower().startswith("multipart/form-data"):
        raise RefusedError(422, "An upload must be a form (multipart/form-data) with a file.", "file")
    parser = MultiPartParser(
        request.headers, request.stream(), max_files=1, max_fields=3, max_part_size=LONGEST_FIELD
    )
    parser.spool_max_size = 2 * limits.upload  # in memory, so that nothing is written under a foreign name
    try:
        form = await parser.parse()
    except MultiPartException as error:
        raise RefusedError(422, f"The form cannot be read: {error.message}", "file") from None
    except (KeyError, ValueError, UnicodeError):
        raise RefusedError(422, "The form cannot be read; it must be multipart/form-data.", "file") from None
    try:
        file = form.get("file")
        if not isinstance(file, UploadFile):
            raise RefusedError(422, "The form has no file; it must be sent as 'file'.", "file")
        unknown = sorted(set(form) - {"file", "unit", "dt", "component"})
        if unknown:
            raise RefusedError(
                422, "The form has an unknown field; it may have file, unit, dt, component.", "file"
            )
        data = await file.read()
        if not data:
            raise RefusedError(422, "The file is empty; it must hold a record.", "file")
        dt = _text(form.get("dt"))
        return Upload(
            data,
            file.filename,
            _text(form.get("unit")),
            None if dt is None else _step(dt),
            _text(form.get("component")),
        )
    finally:
        await form.close()


def _text(value: object) -> str | None:
    return value.strip() or None if isinstance(value, str) else None


def _step(text: str) -> float:
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        raise RefusedError(422, "dt must be a number [s].", "dt")
    return number
