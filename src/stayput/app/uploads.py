"""An upload: one file in a form, kept in memory until it has been read."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

from starlette.datastructures import UploadFile
from starlette.formparsers import MultiPartException, MultiPartParser

from stayput.app.refusals import refused

if TYPE_CHECKING:
    from starlette.requests import Request

    from stayput.app.limits import Limits

LONGEST_FIELD = 200
"""Longest field besides the file [bytes]."""


class Upload(NamedTuple):
    """The fields of an upload's form."""

    data: bytes
    name: str | None
    unit: str | None
    dt: float | None
    component: str | None
    remove_mean: bool


async def read_upload(request: Request, limits: Limits) -> Upload:
    """Read the form of an upload.

    Raises
    ------
    RefusedError
        No form, no file, more than one, fields that are too long or not numbers.
    """
    if not request.headers.get("content-type", "").lower().startswith("multipart/form-data"):
        raise refused(422, "app.no_form", "file")
    parser = MultiPartParser(
        request.headers, request.stream(), max_files=1, max_fields=4, max_part_size=LONGEST_FIELD
    )
    parser.spool_max_size = 2 * limits.upload  # in memory, so that nothing is written under a foreign name
    try:
        form = await parser.parse()
    except MultiPartException as error:
        raise refused(422, "app.form_not_read", "file", message=error.message) from None
    except (KeyError, ValueError, UnicodeError):
        raise refused(422, "app.form_not_multipart", "file") from None
    try:
        file = form.get("file")
        if not isinstance(file, UploadFile):
            raise refused(422, "app.form_no_file", "file")
        unknown = sorted(set(form) - {"file", "unit", "dt", "component", "remove_mean"})
        if unknown:
            raise refused(422, "app.form_unknown_field", "file")
        data = await file.read()
        if not data:
            raise refused(422, "app.empty_file", "file")
        dt = _text(form.get("dt"))
        return Upload(
            data,
            file.filename,
            _text(form.get("unit")),
            None if dt is None else _step(dt),
            _text(form.get("component")),
            _text(form.get("remove_mean")) in ("true", "1", "yes", "on"),
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
        raise refused(422, "app.dt_not_a_number", "dt")
    return number
