"""What the fields of a `Solid` may be: numbers as arrays that cannot be written to, or a refusal."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.catalogue import phrase
from stayput.errors import InputError, within
from stayput.model.body import MASS_RANGE, SIZE_RANGE
from stayput.model.polyhedron import TOLERANCE, size_of

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from stayput.catalogue import Phrase
    from stayput.model.polyhedron import Hull

MOST_FEET = 32
"""Most feet of a body."""

LARGEST = 1e12
"""Largest number that is accepted, of any unit."""

_IRREGULAR = ("irregular", "不規則")


class Copied:
    """An array of a frozen value, of which every reader has a copy.

    What is read-only is no input for the compiled code of other libraries, such as SciPy's rotations.
    """

    def __set_name__(self, owner: type, name: str) -> None:
        self._name = name

    def __get__(self, value: Any, owner: type) -> Any:
        if value is None:  # the class has no default
            raise AttributeError(self._name)
        array = value.__dict__[self._name]
        return None if array is None else array.copy()

    def __set__(self, value: Any, array: Any) -> None:
        value.__dict__[self._name] = array


def numbers(name: str, value: ArrayLike, shape: tuple[int | None, ...]) -> NDArray[np.float64]:
    """Return a copy of numbers as an array of a shape, None for any length, that cannot be written to."""
    called = phrase(f"solids.{name}")
    text = str(shape).replace("None", "n")
    try:
        array = np.array(value, np.float64)
    except (TypeError, ValueError, OverflowError):
        raise InputError("solids.wrong_shape", name, name=called, shape=text, given=_IRREGULAR) from None
    fits = array.ndim == len(shape) and all(
        side in (None, given) for side, given in zip(shape, array.shape, strict=True)
    )
    if not fits or not array.size:
        raise InputError("solids.wrong_shape", name, name=called, shape=text, given=str(array.shape))
    check_numbers(array, called, name)
    return read_only(array)


def check_numbers(array: NDArray[np.float64], called: Phrase, field: str) -> None:
    """Refuse numbers of which one is NaN, infinite, or so large that its square is of no use."""
    if not np.abs(array).max() <= LARGEST:
        raise InputError("solids.not_finite", field, name=called, largest=LARGEST)


def read_only(array: Any) -> Any:
    """Return an array after it was made read-only."""
    array.setflags(write=False)
    return array


def side(name: str, value: float) -> float:
    """Return a length of a body [m], or refuse one that is not possible."""
    return within(f"solids.{name}", value, *SIZE_RANGE, "m", name)


def checked_mass(value: float) -> float:
    """Return a mass [kg], or refuse one that is not possible."""
    return within("solids.mass", value, *MASS_RANGE, "kg", "mass")


def checked_centre(hull: Hull, value: ArrayLike) -> NDArray[np.float64]:
    """Return the centre of gravity, or refuse one outside the hull."""
    point = numbers("centre_of_gravity", value, (3,))
    depth = float((hull.planes[:, :3] @ point - hull.planes[:, 3]).max())
    if depth > TOLERANCE * size_of(hull.vertices):
        told = f"({', '.join(f'{x:.4g}' for x in point)})"
        raise InputError("solids.cg_outside", "centre_of_gravity", point=told, depth=depth)
    return point


def checked_inertia(
    hull: Hull, mass: float, usual: NDArray[np.float64], value: ArrayLike
) -> NDArray[np.float64]:
    """Return the inertia tensor, made symmetric to the bit, or refuse what no body of the shape has."""
    tensor = numbers("inertia", value, (3, 3))
    difference = float(np.abs(tensor - tensor.T).max())
    if difference > 1e-9 * np.abs(tensor).max():
        raise InputError("solids.inertia_not_symmetric", "inertia", difference=difference)
    tensor = (tensor + tensor.T) / 2.0
    moments = np.linalg.eigvalsh(tensor)
    told = ", ".join(f"{moment:.4g}" for moment in moments)
    if not (moments[0] > 0.0 and moments[2] <= (1.0 + 1e-9) * (moments[0] + moments[1])):
        raise InputError("solids.inertia_not_possible", "inertia", moments=told)
    # what other units would give: kg mm², g m²
    low = 1e-7 * float(np.linalg.eigvalsh(usual)[0])
    high = 4.0 * mass * float((np.ptp(hull.vertices, axis=0) ** 2).sum())
    if not low <= moments[0] <= moments[2] <= high:
        raise InputError("solids.inertia_size", "inertia", moments=told, low=low, high=high)
    return read_only(tensor)


def checked_feet(hull: Hull, value: ArrayLike) -> NDArray[np.float64]:
    """Return feet, shape (f, 3) [m], or refuse none, too many, or one that is not at the foot of the body."""
    feet = numbers("feet", value, (None, 3))
    within("solids.number_of_feet", len(feet), 1, MOST_FEET, "", "feet")
    low, high = hull.vertices.min(axis=0), hull.vertices.max(axis=0)
    reach = 0.5 * size_of(hull.vertices)
    most = np.array([*(high[:2] + reach), 0.5 * (low[2] + high[2])])
    astray = ((feet < low - reach) | (feet > most)).any(axis=1)
    if astray.any():
        told = f"({', '.join(f'{x:.4g}' for x in feet[astray][0])})"
        raise InputError("solids.foot_astray", "feet", point=told, reach=reach)
    return feet


def checked_rims(value: ArrayLike) -> NDArray[np.float64]:
    """Return circular edges, shape (r, 7), or refuse those that are no circles."""
    if not np.size(np.asarray(value)):
        return read_only(np.zeros((0, 7)))
    rims = numbers("rims", value, (None, 7))
    axes, radii = np.linalg.norm(rims[:, 3:6], axis=1), rims[:, 6]
    if np.abs(axes - 1.0).max() > 1e-9 or radii.min() <= 0.0:
        raise InputError("solids.rims_wrong", "rims")
    return rims
