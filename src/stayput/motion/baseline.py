"""Acceleration records that cannot be the ground's as they are: an offset, gravity, a time step too long."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.errors import InputError, InputWarning, warn
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.motion.integrals import peak_velocity

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.motion.record import Motion

LONGEST_STEP = 0.1
"""Longest time step that is read without a warning [s]; a record shows nothing faster than 1/(2 dt)."""

_OVER_PEAK_VELOCITY = 5.0
_FEWEST_CROSSINGS = 10
_SHARE_OF_PEAK = 1e-3
_LATE_SHARE = 0.02
_GRAVITY_TOLERANCE = 0.05
_FASTEST_LEFT = 5.0
"""Velocity at a record's end that no floor is left with [m/s]."""
_MOST_OF_PEAK = 0.1


def oscillates_about_offset(a: NDArray[np.float64], dt: float) -> bool:
    """Return whether an acceleration oscillates about a value other than zero.

    The ground is at rest before and after an earthquake, so its mean acceleration is zero; a mean ā leaves it
    moving at ā T after the duration T. That is taken for an offset of the instrument where ā is at least a
    thousandth of the peak, ā T is more than five times the peak velocity of the record less ā, and the record
    crosses ā at least ten times. A pulse that leaves the floor at another velocity, half a sine, a rectangle
    or a constant acceleration, crosses its mean a few times at most and is none; records with the noise and
    the drift of an instrument stay below one peak velocity.

    Parameters
    ----------
    a : ndarray, shape (n,)
        Acceleration [m/s²].
    dt : float
        Time step [s].
    """
    mean = float(a.mean())
    if abs(mean) < _SHARE_OF_PEAK * max(float(a.max()), -float(a.min())):
        return False
    rest = a - mean
    crossings = int(np.count_nonzero(rest[:-1] * rest[1:] < 0.0))
    final_velocity = abs(mean) * dt * (len(a) - 1)
    return crossings >= _FEWEST_CROSSINGS and final_velocity > _OVER_PEAK_VELOCITY * peak_velocity(rest, dt)


def offset_begins(a: NDArray[np.float64], dt: float) -> int:
    """Return about where an offset begins that lasts to the end of an acceleration; 0 where none does.

    It is looked for in the last half, quarter and eighth. Its least size is larger than that of an offset of
    the whole record: shaking tilts instruments and leaves a thousandth of the peak behind in many of them.

    Parameters
    ----------
    a, dt
        As for `oscillates_about_offset`.
    """
    peak = float(np.abs(a).max())
    for part in (2, 4, 8):
        begin = len(a) - len(a) // part
        rest = a[begin:]
        if len(rest) and abs(rest.mean()) > _LATE_SHARE * peak and oscillates_about_offset(rest, dt):
            return begin
    return 0


def check_baseline(motion: Motion, *, recorded: bool = False) -> None:
    """Refuse or warn of a motion that cannot be the ground's, or a floor's, as it is.

    Parameters
    ----------
    motion : Motion
        The motion.
    recorded : bool
        Whether it comes from a record. One that was made of arrays may be any input, such as a fall: it is
        only warned of, and its time step is taken as it is.

    Raises
    ------
    InputError
        A component of a record whose mean is gravity, within 5 %, or the means of all together are; an offset
        of more than a tenth of the peak that would leave the floor moving faster than 5 m/s. The ground has
        moved at 3 to 4 m/s at most; of corrected records a mean is some thousandths of the peak at most.

    Warns
    -----
    InputWarning
        An offset, see `oscillates_about_offset` and `offset_begins`; gravity in z of a motion of
        arrays; a record whose time step is longer than 0.1 s.
    """
    if recorded and motion.dt > LONGEST_STEP:
        warn(InputWarning("motion.long_step", "dt", dt=motion.dt, frequency=0.5 / motion.dt))
    option = "remove_mean" if recorded else "baseline_corrected"
    means = {name: float(a.mean()) for name, a in motion.components.items()}
    total = math.hypot(*means.values())
    alone = any(_is_gravity(mean) for mean in means.values())
    if recorded and not alone and _is_gravity(total):  # of a tilted instrument
        together = f"{', '.join(means)} together", f"{', '.join(means)}を合わせた"
        raise InputError("motion.gravity", option, component=together, mean=total, option=option)
    for name, a in motion.components.items():
        mean = means[name]
        if recorded and _is_gravity(mean):
            raise InputError("motion.gravity", option, component=name, mean=mean, option=option)
        if name == "z" and _is_gravity(mean):
            warn(InputWarning("motion.gravity", "z", component=name, mean=mean, option=option))
        elif oscillates_about_offset(a, motion.dt):
            velocity = abs(mean) * motion.duration
            share = abs(mean) / float(np.abs(a).max())
            about: dict[str, Any] = {
                "component": name,
                "mean": mean,
                "velocity": velocity,
                "share": 100.0 * share,
            }
            if recorded and velocity > _FASTEST_LEFT and share > _MOST_OF_PEAK:
                raise InputError("motion.offset", option, **about, option=option)
            warn(InputWarning("motion.offset", option, **about, option=option))
        elif begin := offset_begins(a, motion.dt):
            about = {"component": name, "mean": float(a[begin:].mean()), "begin": begin * motion.dt}
            warn(InputWarning("motion.late_offset", name, **about))


def checked_record(motion: Motion, *, remove_mean: bool) -> Motion:
    """Return a motion that was read, less the mean of each component where that is asked for.

    Its source says what was taken off. Raises and warns as `check_baseline` does.
    """
    if remove_mean:
        means = {name: float(a.mean()) for name, a in motion.components.items()}
        removed = ", ".join(f"{name} {mean:.4g}" for name, mean in means.items())
        samples: dict[str, Any] = {name: a - means[name] for name, a in motion.components.items()}
        motion = replace(motion, **samples, source=f"{motion.source}; mean removed [m/s²]: {removed}")
    check_baseline(motion, recorded=True)
    return motion


def _is_gravity(mean: float) -> bool:
    return abs(abs(mean) - STANDARD_GRAVITY) <= _GRAVITY_TOLERANCE * STANDARD_GRAVITY
