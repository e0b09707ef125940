"""Fixtures of several files of tests."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

import stayput as sp
from stayput.errors import warnings_to

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    Read = Callable[..., tuple[sp.Motion, list[sp.InputWarning]]]


@pytest.fixture
def read(tmp_path: Path) -> Read:
    """Write a record's file and read it: the motion, and what is warned of."""

    def reader(
        content: str | bytes, name: str = "record", **options: Any
    ) -> tuple[sp.Motion, list[sp.InputWarning]]:
        file = tmp_path / name
        file.write_bytes(content if isinstance(content, bytes) else content.encode())
        warned: list[sp.InputWarning] = []
        with warnings_to(warned.append):
            motion = sp.read_motion(file, **options)
        for warning in warned:
            assert str(warning).startswith(f"{name} (")
            assert warning.told("ja").startswith(f"{name}（")
        return motion, warned

    return reader


@pytest.fixture
def refusal(read: Read) -> Callable[..., sp.InputError]:
    """Write a record's file that must be refused, and return the refusal."""

    def refused(content: str | bytes, name: str = "record", **options: Any) -> sp.InputError:
        with pytest.raises(sp.InputError) as caught:
            read(content, name, **options)
        assert caught.value.told("ja") != str(caught.value)
        return caught.value

    return refused
