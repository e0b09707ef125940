"""Machine code on disk: made of LLVM's intermediate code, kept with checksums, and loaded without Numba.

LLVM aborts the process on a damaged object, and machine code of changed sources would give other results.
Each file therefore begins with the SHA-256 digest of the rest, which says of what sources and for which
processors it is made; a file that is damaged or stale counts as absent and is replaced. A wheel brings code
for the usual processors (`WITH_PACKAGE`), so that its users need not wait until it is compiled.
"""

from __future__ import annotations

import hashlib
import logging
import os
import platform
import secrets
import stat
import sys
import tempfile
from collections.abc import Callable, Generator, Iterable
from concurrent.futures import Future
from contextlib import suppress
from functools import cache
from pathlib import Path
from threading import Lock, Thread
from typing import Any, TypeVar

import llvmlite.binding

llvm: Any = llvmlite.binding  # it has no types
_LOG = logging.getLogger("stayput")
_DIGEST = 32  # bytes of SHA-256

WITH_PACKAGE = Path(__file__).parent / "code"
"""Folder of the code that comes with a wheel; it is only read."""

GENERIC = {
    ("x86_64", "amd64"): ("x86-64-v3", ("avx2", "bmi", "bmi2", "f16c", "fma", "lzcnt", "movbe")),
    ("aarch64", "arm64"): ("generic", ()),
}
"""The processors for which code is made, by their family, and what they need to have: code for one of them
alone is no faster. Others have code of their own.
"""
_one_at_a_time = Lock()
T = TypeVar("T")


class MachineCode:
    """The machine code of one compiled function, for arguments of some types.

    Parameters
    ----------
    name : str
        The function's name, with its module.
    kinds : tuple
        The types of its arguments.
    folders : tuple of Path
        Folders whose source files are compiled into it; the first is the function's own.
    """

    def __init__(self, name: str, kinds: tuple[Any, ...], folders: tuple[Path, ...]) -> None:
        self._folder = folders[0]
        what = name, kinds, sys.platform, platform.machine(), *_processor()
        key = hashlib.sha256(repr(what).encode()).hexdigest()[:16]
        # the processor is part of the file's name: machines of a cluster may share the folder
        self._file = f"{name.rsplit('.', 1)[-1]}-{key}.code"
        how = Path(__file__).parent
        sources = [_digest_of(folder.glob("*.py")) for folder in (how, *folders)]
        stamp = repr((what, sources))
        self._stamp = hashlib.sha256(stamp.encode()).hexdigest().encode()

    def load(self) -> int | None:
        """Load it from disk; return its address, or None where there is none that is whole and up to date."""
        for folder in (WITH_PACKAGE, *_folders(self._folder)):
            try:
                content = (folder / self._file).read_bytes()
            except OSError:
                continue
            if hashlib.sha256(content[_DIGEST:]).digest() != content[:_DIGEST]:
                continue
            stamp, _, content = content[_DIGEST:].partition(b"\0")
            if stamp == self._stamp:
                symbol, _, code = content.partition(b"\0")
                return _address(code, symbol.decode())
        return None

    def add(self, bitcode: bytes) -> int:
        """Make machine code of intermediate code, keep it on disk if that is possible, and load it.

        Parameters
        ----------
        bitcode : bytes
            A module with one external function.

        Returns
        -------
        int
            The function's address.
        """
        module = llvm.parse_bitcode(bitcode)
        symbol = _optimize(module)
        code = _machine().emit_object(module)
        packed = b"\0".join((self._stamp, symbol.encode(), code))
        self._save(hashlib.sha256(packed).digest() + packed)
        return _address(code, symbol)

    def _save(self, content: bytes) -> None:
        """Save a file whole or not at all; where it cannot be, warn: it will be compiled again next time."""
        why = ""
        for folder in _folders(self._folder):
            draft = folder / f".{self._file}-{secrets.token_hex(4)}"
            try:
                folder.mkdir(parents=True, exist_ok=True)
                draft.touch(exist_ok=False)
            except OSError:
                continue
            try:
                draft.write_bytes(content)
                draft.replace(folder / self._file)
            except OSError as error:  # as on a full disk; the next folder may be on another one
                draft.unlink(missing_ok=True)
                why = why or f" ({folder}: {(error.strerror or str(error)).lower()})"
                continue
            if folder == _temporary_folder():
                _warn_once(
                    f"Neither the folder of stayput nor your home can be written to{why}; "
                    f"compiled code is kept in {folder}."
                )
            return
        _warn_once(f"Compiled code cannot be kept on this machine{why}; every start compiles anew.")


def uninterrupted(work: Callable[[], T]) -> T:
    """Do work with LLVM on a thread of its own, and wait for it.

    Ctrl-C interrupts the wait, not the work: between a call of LLVM and what llvmlite notes of it, it would
    have memory freed twice. The thread ends before the process does.
    """
    done: Future[T] = Future()

    def run() -> None:
        with _one_at_a_time:
            try:
                done.set_result(work())
            except BaseException as error:  # it is raised where one waits
                done.set_exception(error)

    Thread(target=run).start()
    return done.result()


@cache
def _warn_once(line: str) -> None:
    _LOG.warning(line)


def _digest_of(files: Iterable[Path]) -> str:
    """Return a digest of source files."""
    digest = hashlib.sha256()
    for file in sorted(files):
        digest.update(hashlib.sha256(file.read_bytes()).digest())
    return digest.hexdigest()


def _folders(beside: Path) -> Generator[Path]:
    """Yield the folders in which code may be kept, the first that can be written to before the others."""
    if chosen := os.environ.get("NUMBA_CACHE_DIR"):
        # as Numba does it: one folder for all that is compiled on a machine
        yield Path(chosen) / f"{beside.name}-{hashlib.sha256(str(beside).encode()).hexdigest()[:16]}"
        return
    yield beside / "__pycache__"
    home = {"win32": os.environ.get("LOCALAPPDATA"), "darwin": "~/Library/Caches"}.get(
        sys.platform, os.environ.get("XDG_CACHE_HOME", "~/.cache")
    )
    with suppress(RuntimeError):  # a user without a home
        if home:
            yield Path(home).expanduser() / "stayput"
    if folder := _temporary_folder():
        yield folder


def _temporary_folder() -> Path | None:
    """Return a private temporary folder of this user, or None where it may belong to somebody else.

    Code that is kept there is run, so the folder must be the user's own, closed to others, and no link.
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


@cache
def _processor() -> tuple[str, str]:
    """Return LLVM's name of the processors for which code is made here, and their features beside it."""
    features = llvm.get_host_cpu_features()
    for machines, (name, needed) in GENERIC.items():
        if platform.machine().lower() in machines and all(features.get(each) for each in needed):
            return name, ""
    return llvm.get_host_cpu_name(), features.flatten()


@cache
def _machine() -> Any:
    """Return LLVM's description of this machine, with the options that loading into memory needs."""
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    x86 = platform.machine().lower() in ("x86_64", "amd64", "i686", "x86")
    cpu, features = _processor()
    return llvm.Target.from_default_triple().create_target_machine(
        cpu=cpu,
        features=features,
        opt=3,
        reloc="static" if x86 else "default",
        codemodel="jitdefault",
        jit=True,
    )


@cache
def _engine() -> Any:
    """Return the engine into which machine code is loaded; it lives as long as the process."""
    return llvm.create_mcjit_compiler(llvm.parse_assembly(""), _machine())


def _optimize(module: Any) -> str:
    """Optimize a module as a whole for its one external function; return the name of that.

    Numba lets every function be called from elsewhere; of internal ones those with one caller are inlined.

    Raises
    ------
    RuntimeError
        The module calls a function that is not to be found.
    """
    symbol = ""
    for function in module.functions:
        if function.is_declaration:
            if not _is_known(function.name):
                raise RuntimeError(f"The compiled code calls {function.name}, which is not to be found.")
        elif function.linkage == llvm.Linkage.external:
            symbol = function.name
        else:
            function.linkage = llvm.Linkage.internal
    options = llvm.create_pipeline_tuning_options(speed_level=3)
    # independent operations side by side, as Clang does; Numba does not since LLVM 11 miscompiled some
    options.slp_vectorization = True
    builder = llvm.create_pass_builder(_machine(), options)
    builder.getModulePassManager().run(module, builder)
    return symbol


def _is_known(name: str) -> bool:
    """Whether the linker finds a function: one of LLVM's own or of the C library; else a call would crash."""
    return name.startswith("llvm.") or llvm.address_of_symbol(name) is not None


def _address(code: bytes, symbol: str) -> int:
    """Load machine code into memory; return where its function is."""
    _engine().add_object_file(llvm.ObjectFileRef.from_data(code))
    _engine().finalize_object()
    return _engine().get_function_address(symbol)
