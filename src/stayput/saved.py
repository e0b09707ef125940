"""Values of the package in files, and back to the same bits: JSON, or NetCDF where there are histories.

A file holds the values' own fields under the names of their classes, and the version that wrote it. Nothing
in it is run: only classes of the package are made anew, through the checks of their own. Digests of its
content tell a file that was changed afterwards.
"""

from __future__ import annotations

import base64
import dataclasses
import hashlib
import json
import math
import re
from abc import ABC, abstractmethod
from collections.abc import Callable, Generator, Mapping
from contextlib import contextmanager
from enum import Enum
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol, Self, TypeVar, cast, runtime_checkable

import numpy as np
from numpy.typing import NDArray

import stayput
from stayput.errors import InputError, instance_of, reason_of
from stayput.files import check_target, draft

if TYPE_CHECKING:
    import xarray as xr

T = TypeVar("T")

Keep = Callable[["NDArray[Any]"], Any]
"""What stands for an array in the data: the numbers themselves, or the name of a variable beside it."""

JSON, NETCDF = (".json",), (".nc",)
"""Endings of the files."""

_FORMAT = 2
"""The format that is written and read."""

_KINDS = re.compile(r"[<>|=]?([fiub][1248]|f16|[US]\d{1,3})")
"""The kinds of numbers and texts in arrays, as NumPy writes them."""

_PARTS = "stayput_parts"
"""The attribute of a dataset that holds everything but the arrays."""


@runtime_checkable
class Kept(Protocol):
    """A value that is no dataclass and says itself what is to be kept of it."""

    def kept(self) -> dict[str, Any]:
        """Return the parts that `of_kept` makes it of again."""
        ...

    @classmethod
    def of_kept(cls, parts: Mapping[str, Any]) -> Any:
        """Make it again."""
        ...


class InJson:
    """What is saved as JSON and loaded again."""

    __slots__ = ()

    def save(self, path: str | Path) -> Path:
        """Write it to a file (.json; .nc of a run) that `load` reads again, to the bit and with its inputs.

        Any program that knows NetCDF reads the histories in a run's file.

        Raises
        ------
        InputError
            A path that cannot be written, or a class of one's own in it, such as a measure.
        """
        target = check_target(path, JSON)
        text = json.dumps(_content(self, _numbers), ensure_ascii=False, allow_nan=False)
        with draft(target) as unfinished:
            unfinished.write_text(text, encoding="utf-8")
        return target

    @classmethod
    def load(cls, path: str | Path) -> Self:
        """Read what `save` wrote.

        Raises
        ------
        InputError
            No such file, or one of something else.
        """
        file = Path(instance_of("path", path, (str, Path)))
        with _refusing(file, cls):
            content = json.loads(file.read_text(encoding="utf-8"))
        return _read(cls, file, content, _of_numbers)


class InNetcdf(InJson, ABC):
    """What is saved as NetCDF, with a dataset that others can read, and loaded again."""

    __slots__ = ()

    @abstractmethod
    def to_dataset(self) -> xr.Dataset:
        """Return the histories and results; arrays of the value itself are variables there by their names."""

    def save(self, path: str | Path) -> Path:
        """Write it to a file (.nc); see `InJson.save`."""
        target, dataset = check_target(path, NETCDF), self.to_dataset()
        # arrays of fields live as long as the value, so that their ids stay theirs
        fields = [field.name for field in dataclasses.fields(cast("Any", self))]
        names = {id(getattr(self, name)): name for name in map(str, dataset.variables) if name in fields}
        added: dict[str, Any] = {}

        def keep(array: NDArray[Any]) -> Any:
            if id(array) not in names:
                # NetCDF 3 knows no tables, and takes a dimension without a length for one that grows
                if array.dtype.kind not in "fiub" or array.size == 0:
                    return _numbers(array)
                name = names[id(array)] = f"stayput_{len(added)}"
                added[name] = (tuple(f"{name}_{axis}" for axis in range(array.ndim)), array)
            return {"variable": names[id(array)], "dtype": array.dtype.str, "sha256": _array_digest(array)}

        content = json.dumps(_content(self, keep), allow_nan=False)
        attributes = {"stayput_version": stayput.__version__, _PARTS: content}
        with draft(target) as unfinished:
            dataset.assign(added).assign_attrs(attributes).to_netcdf(unfinished, engine="scipy")
        return target

    @classmethod
    def load(cls, path: str | Path) -> Self:
        """Read what `save` wrote; see `InJson.load`."""
        import xarray as xr

        file = Path(instance_of("path", path, (str, Path)))
        with _refusing(file, cls):
            with xr.open_dataset(file, engine="scipy", decode_times=False, decode_timedelta=False) as opened:
                dataset = opened.load()
            content = json.loads(dataset.attrs[_PARTS])

        def array_of(data: Mapping[str, Any]) -> NDArray[Any]:
            if "variable" not in data:
                return _of_numbers(data)
            values = cast("NDArray[Any]", dataset[data["variable"]].to_numpy()).astype(_kind(data["dtype"]))
            if _array_digest(values) != data["sha256"]:
                raise InputError("saved.changed", "path", file=str(file))
            return values

        return _read(cls, file, content, array_of)


def to_text(value: object) -> str:
    """Return a value as text with all its bits, from which `from_text` makes it again."""
    return json.dumps(_encoded(value, _numbers))


def from_text(text: str) -> Any:
    """Return the value that `to_text` made a text of."""
    return _decoded(json.loads(text), _of_numbers)


@contextmanager
def _refusing(file: Path, kind: type) -> Generator[None]:
    """Refuse a file that cannot be read, or that is of something else."""
    try:
        yield
    except OSError as error:
        raise InputError("common.unreadable", "path", file=str(file), reason=reason_of(error)) from None
    except Exception:  # SciPy, xarray and json fail at a file that is cut or of something else in many ways
        raise InputError("saved.another", "path", file=str(file), kind=kind.__name__) from None


def _read(
    kind: type[T], file: Path, content: Any, array_of: Callable[[Mapping[str, Any]], NDArray[Any]]
) -> T:
    with _refusing(file, kind):
        version, digest, data = str(content["stayput"]), content["sha256"], content["value"]
        written = int(content["format"])
    if written != _FORMAT:
        raise InputError("saved.other_version", "path", file=str(file), version=version)
    try:
        if _digest(version, data) != digest:
            raise InputError("saved.changed", "path", file=str(file))
        value = _decoded(data, array_of)
    except InputError:
        raise
    except Exception as error:  # whatever a file that was changed by hand makes of a class
        raise InputError("saved.other_version", "path", file=str(file), version=version) from error
    if not isinstance(value, kind):
        raise InputError("saved.another", "path", file=str(file), kind=kind.__name__)
    return value


def _content(value: object, keep: Keep) -> dict[str, Any]:
    """Return what a file holds of a value."""
    version, data = stayput.__version__, _encoded(value, keep)
    return {"stayput": version, "format": _FORMAT, "sha256": _digest(version, data), "value": data}


def _digest(version: str, data: Any) -> str:
    """Return the digest of encoded data and of the version that wrote them, however a file writes them."""
    text = json.dumps([version, data], sort_keys=True, separators=(",", ":"), allow_nan=False)
    return hashlib.sha256(text.encode("ascii")).hexdigest()


def _array_digest(array: NDArray[Any]) -> str:
    """Return the digest of an array's shape and bytes; all that is not a number counts as the same."""
    plain = np.where(np.isnan(array), np.nan, array) if array.dtype.kind == "f" else array
    return hashlib.sha256(f"{array.shape}".encode() + plain.tobytes()).hexdigest()


def _encoded(value: Any, keep: Keep) -> Any:
    """Return a value as JSON holds it; every object says in its first key what it stands for."""
    if isinstance(value, Enum):
        return {"enum": _name(type(value)), "value": value.value}
    if value is None or isinstance(value, bool | int | str):
        return value
    if isinstance(value, np.generic):
        return _encoded(cast("np.generic", value).item(), keep)
    if isinstance(value, float):
        return float(value) if math.isfinite(value) else {"float": repr(float(value))}
    if isinstance(value, np.ndarray):
        return {"array": keep(cast("NDArray[Any]", value))}
    if isinstance(value, InputError):
        parts = (value.code, value.field, value.context, value.values)
        return {"error": [_encoded(part, keep) for part in parts]}
    if isinstance(value, tuple):
        items = [_encoded(item, keep) for item in cast("tuple[Any, ...]", value)]
        kind: type = type(cast("object", value))
        return {"tuple": items} if kind is tuple else {"named": _name(kind), "items": items}
    if isinstance(value, list):
        return [_encoded(item, keep) for item in cast("list[Any]", value)]
    if isinstance(value, Mapping):
        pairs = cast("Mapping[Any, Any]", value).items()
        return {"mapping": [[_encoded(key, keep), _encoded(item, keep)] for key, item in pairs]}
    if isinstance(value, Path):
        return {"path": str(value)}
    if isinstance(value, Kept):
        return {"kept": _name(type(value)), "parts": _encoded(value.kept(), keep)}
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        names = [field.name for field in dataclasses.fields(value) if field.init]
        fields = {name: _encoded(getattr(value, name), keep) for name in names}
        return {"object": _name(type(value)), "fields": fields}
    raise InputError("saved.not_ours", value=type(value).__qualname__)


def _decoded(data: Any, array_of: Callable[[Mapping[str, Any]], NDArray[Any]]) -> Any:
    """Return the value that `_encoded` made this of."""

    def again(part: Any) -> Any:
        return _decoded(part, array_of)

    match data:
        case {"enum": name, "value": value}:
            return _class(name, Enum)(value)
        case {"float": text}:
            return float(text)
        case {"array": kept}:
            return array_of(kept)
        case {"error": [code, field, context, values]}:
            return InputError(code, field, context=again(context), **again(values))
        case {"tuple": items}:
            return tuple(again(item) for item in items)
        case {"named": name, "items": items}:
            return _class(name, tuple)(*(again(item) for item in items))
        case {"mapping": pairs}:
            return {again(key): again(item) for key, item in pairs}
        case {"path": text}:
            return Path(text)
        case {"kept": name, "parts": parts}:
            return _class(name, Kept).of_kept(again(parts))
        case {"object": name, "fields": fields}:
            return _class(name)(**{key: again(part) for key, part in fields.items()})
        case list():
            return [again(item) for item in cast("list[Any]", data)]
        case dict():
            raise ValueError(f"an object of unknown meaning: {list(cast('dict[str, Any]', data))}")
        case _:
            return data


def _name(kind: type) -> str:
    """Return the full name of a class of the package; a user's own cannot be made again from a file."""
    if kind.__module__.split(".")[0] != __package__:
        raise InputError("saved.not_ours", value=kind.__qualname__)
    return f"{kind.__module__}.{kind.__qualname__}"


def _class(name: str, parent: type | None = None) -> Any:
    """Return a class of the package by its full name: a dataclass, or one of a parent.

    Raises
    ------
    ValueError
        It is none of them.
    """
    module, _, class_name = name.rpartition(".")
    if module.split(".")[0] != __package__:
        raise ValueError(name)
    kind = getattr(import_module(module), class_name)
    fits = dataclasses.is_dataclass(kind) if parent is None else issubclass(kind, parent)
    if not isinstance(kind, type) or not fits:
        raise ValueError(name)
    return kind


def _numbers(array: NDArray[Any]) -> Any:
    shape = list(array.shape)
    if array.dtype.names is not None:  # a table of the engine, whose columns may be arrays themselves
        kinds = [list(column) for column in array.dtype.descr]
        return {"columns": kinds, "shape": shape, "bytes": base64.b64encode(array.tobytes()).decode("ascii")}
    values = [_encoded(value, _numbers) for value in array.ravel().tolist()]
    return {"dtype": _kind(array.dtype.str).str, "shape": shape, "values": values}


def _of_numbers(data: Mapping[str, Any]) -> NDArray[Any]:
    shape = data["shape"]
    if "columns" in data:
        kinds = np.dtype([(name, _kind(kind), *map(tuple, rest)) for name, kind, *rest in data["columns"]])
        return np.frombuffer(base64.b64decode(data["bytes"]), kinds).reshape(shape)
    kind, values = _kind(data["dtype"]), [_decoded(value, _of_numbers) for value in data["values"]]
    if len(values) != math.prod(shape):
        raise ValueError(f"{len(values)} values of shape {shape}")
    return np.array(values, kind).reshape(shape)


def _kind(text: str) -> np.dtype[Any]:
    """Return the kind of an array's values.

    Raises
    ------
    ValueError
        None that is saved.
    """
    if _KINDS.fullmatch(text) is None:
        raise ValueError(text)
    return np.dtype(text)
