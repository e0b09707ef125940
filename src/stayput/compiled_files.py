"""On-disk cache of compiled code: Numba's, with checksums and a stamp of all sources.

Numba loads a cache file without checks, and LLVM aborts the process on a damaged object. Here each file
begins with the SHA-256 digest of the rest; a file that is damaged or stale counts as absent, so the function
is recompiled and the file replaced. Numba also checks the source file of the entry point only; here the stamp
covers all sources that are compiled into it.
"""

from __future__ import annotations

import hashlib
import logging
import os
import pickle
import stat
import sys
import tempfile
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import llvmlite
import numba
from numba.core.caching import (
    CompileResultCacheImpl,
    FunctionCache,
    IndexDataCacheFile,
    UserProvidedCacheLocator,
)

if TYPE_CHECKING:
    from collections.abc import Iterable

_LOG = logging.getLogger("stayput")
_DIGEST = 32  # bytes of SHA-256
_MADE_BY = repr((numba.__version__, llvmlite.__version__, sys.version)).encode()


def cache_on_disk(compiled: Any, sources: Iterable[Path]) -> None:
    """Cache the code of a compiled function on disk, and load it from there.

    Parameters
    ----------
    compiled : Dispatcher
        The function as compiled by Numba.
    sources : iterable of Path
        Folders whose source files are compiled into it.
    """
    try:
        compiled._cache = _CheckedCache(compiled.py_func, tuple(sorted(map(_stamp, sources))))
    except RuntimeError:  # Numba finds no folder that it can write to
        _warn_once("Compiled code cannot be kept on this machine; every start compiles anew.")


def _digest(packed: bytes) -> bytes:
    """Return the digest of a file and the versions: pickles of other versions are not portable."""
    return hashlib.sha256(_MADE_BY + packed).digest()


@cache
def _stamp(folder: Path) -> str:
    """Return a digest of all source files of a folder."""
    digest = hashlib.sha256()
    for file in sorted(folder.glob("*.py")):
        digest.update(hashlib.sha256(file.read_bytes()).digest())
    return digest.hexdigest()


@cache
def _warn_once(line: str) -> None:
    _LOG.warning(line)


def _temporary_folder() -> Path | None:
    """Return a private temporary folder of this user, or None where it may belong to somebody else.

    Cached code is unpickled and run, so the folder must be the user's own, closed to others, and no link.
    """
    user = os.getuid() if hasattr(os, "getuid") else None
    folder = Path(tempfile.gettempdir()) / ("stayput" if user is None else f"stayput-{user}")
    try:
        folder.mkdir(mode=0o700, exist_ok=True)
        status = folder.lstat()
    except OSError:
        return None
    if not stat.S_ISDIR(status.st_mode):
        return None
    if user is not None and (status.st_uid != user or stat.S_IMODE(status.st_mode) & 0o077):
        return None
    return folder


class _TemporaryLocator(UserProvidedCacheLocator):
    """Cache locator of last resort: a temporary folder, where neither package nor home is writable."""

    def __init__(self, py_func: Any, py_file: str) -> None:
        super().__init__(py_func, py_file)
        folder = _temporary_folder()
        if folder is None:
            raise OSError
        self._cache_path = str(folder / self.get_suitable_cache_subpath(py_file))

    @classmethod
    def from_function(cls, py_func: Any, py_file: str) -> Any:
        try:
            locator = cls(py_func, py_file)
            locator.ensure_cache_path()
        except OSError:
            return None
        _warn_once(
            "Neither the folder of stayput nor your home can be written to; compiled code is kept in "
            f"{Path(locator.get_cache_path()).parent}."
        )
        return locator


class _Impl(CompileResultCacheImpl):
    _locator_classes = (*CompileResultCacheImpl._locator_classes, _TemporaryLocator)


class _CheckedCache(FunctionCache):
    """Cache of one function, in files that are checked when they are read."""

    _impl_class = _Impl
    _impl: Any
    _cache_path: str

    def __init__(self, py_func: Any, stamp: tuple[str, ...]) -> None:
        super().__init__(py_func)
        self._cache_file = _CheckedFiles(self._cache_path, self._impl.filename_base, stamp)

    def save_overload(self, sig: Any, data: Any) -> None:
        """Save code; where it cannot be written, warn: it will be compiled again the next time."""
        try:
            super().save_overload(sig, data)
        except OSError as error:
            _warn_once(f"Compiled code could not be kept: {(error.strerror or str(error)).lower()}.")


class _CheckedFiles(IndexDataCacheFile):
    """The index and code files of a function, each preceded by the digest of its content."""

    _cache_path: str
    _index_path: str

    def load(self, key: Any) -> Any:
        """Return the code of a key, or None.

        The file repeats the key, since two processes that save at once may write two keys to the same file.
        """
        name = self._load_index().get(key)
        content = None if name is None else self._content(self._data_path(name))
        return content[1] if content is not None and content[0] == key else None

    def save(self, key: Any, data: Any) -> None:
        """Save the code of a key."""
        super().save(key, (key, data))

    def _data_path(self, name: str) -> str:
        return str(Path(self._cache_path, name))

    def _load_index(self) -> dict[Any, str]:
        content = self._content(self._index_path)
        return content[1] if content is not None and content[0] == self._source_stamp else {}

    def _save_index(self, overloads: dict[Any, str]) -> None:
        self._write(self._index_path, (self._source_stamp, overloads))

    def _save_data(self, name: str, data: Any) -> None:
        self._write(self._data_path(name), data)

    def _content(self, path: str) -> Any:
        """Return the content of a file, or None where it is missing or damaged."""
        try:
            content = Path(path).read_bytes()
        except OSError:
            return None
        if _digest(content[_DIGEST:]) != content[:_DIGEST]:
            return None
        return pickle.loads(content[_DIGEST:])

    def _write(self, path: str, content: Any) -> None:
        packed = self._dump(content)
        with self._open_for_write(path) as file:
            file.write(_digest(packed) + packed)
