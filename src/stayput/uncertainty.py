"""Probability distributions of uncertain quantities, and draws from them."""

from __future__ import annotations

import math
import zlib
from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from functools import lru_cache
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stayput.catalogue import phrase
from stayput.errors import InputError, finite, not_allowed, within


class Confidence(StrEnum):
    """How well founded a value is."""

    LOW = "low"
    MEDIUM = "medium"
    HIGH = "high"


@dataclass(frozen=True, slots=True, kw_only=True)
class Marginal(ABC):
    """A quantity that is not known exactly; independent of the others.

    Parameters
    ----------
    unit : str
        Its unit; "" for a number.
    confidence : Confidence
        How well founded its distribution is.
    """

    unit: str = ""
    confidence: Confidence = Confidence.LOW

    @abstractmethod
    def quantile(self, u: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the values below which shares u inside (0, 1) lie."""


@dataclass(frozen=True, slots=True)
class Normal(Marginal):
    """A normal distribution, cut at low and high.

    Parameters
    ----------
    mean, deviation : float
        Mean and standard deviation, before it is cut.
    low, high : float
        Where it is cut.

    Examples
    --------
    >>> import numpy as np
    >>> import stayput as sp
    >>> for low in (-np.inf, 0.4):  # not cut, and cut, which moves its middle up
    ...     filling = sp.Normal(mean=0.5, deviation=0.1, low=low)
    ...     print(filling.quantile(np.array([0.05, 0.5, 0.95])).round(2))
    [0.34 0.5  0.66]
    [0.42 0.52 0.67]
    """

    mean: float
    deviation: float
    low: float = -math.inf
    high: float = math.inf

    def __post_init__(self) -> None:
        finite("verification.mean", self.mean)
        _check_spread("verification.deviation", self.deviation, math.inf)
        _check_order(self.low, self.high)

    def quantile(self, u: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the values below which shares u inside (0, 1) lie."""
        low, high = ((end - self.mean) / self.deviation for end in (self.low, self.high))
        return np.clip(self.mean + self.deviation * _cut_normal(u, low, high), self.low, self.high)


@dataclass(frozen=True, slots=True)
class Lognormal(Marginal):
    """A lognormal distribution, cut at low and high.

    Parameters
    ----------
    median : float
        Median, before it is cut; larger than 0.
    cov : float
        Coefficient of variation: standard deviation over mean, before it is cut.
    low, high : float
        Where it is cut.

    Examples
    --------
    >>> import numpy as np
    >>> import stayput as sp
    >>> friction = sp.Lognormal(median=0.4, cov=0.2, low=0.1)
    >>> friction.quantile(np.array([0.05, 0.5, 0.95])).round(2).tolist()
    [0.29, 0.4, 0.55]
    """

    median: float
    cov: float
    low: float = 0.0
    high: float = math.inf

    def __post_init__(self) -> None:
        _check_spread("verification.median", self.median, math.inf)
        _check_spread("verification.cov", self.cov, 5.0)
        _check_order(self.low, self.high)

    def quantile(self, u: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the values below which shares u inside (0, 1) lie: σ² = ln(1 + cov²)."""
        sigma = math.sqrt(math.log1p(self.cov**2))
        low, high = (
            math.log(end / self.median) / sigma if end > 0.0 else -math.inf for end in (self.low, self.high)
        )
        factors = _to_ten_decimals(np.exp(sigma * _cut_normal(u, low, high)))
        return np.clip(self.median * factors, self.low, self.high)


@dataclass(frozen=True, slots=True)
class Uniform(Marginal):
    """A uniform distribution from low to high.

    Examples
    --------
    >>> import numpy as np
    >>> import stayput as sp
    >>> gap = sp.Uniform(low=0.0, high=0.1)  # m
    >>> gap.quantile(np.array([0.25, 0.5])).tolist()
    [0.025, 0.05]
    """

    low: float
    high: float

    def __post_init__(self) -> None:
        finite("verification.low", self.low)
        finite("verification.high", self.high)
        _check_order(self.low, self.high)

    def quantile(self, u: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the values below which shares u inside (0, 1) lie."""
        return self.low + (self.high - self.low) * u


def _check_spread(name: str, value: float, most: float) -> None:
    if not 0.0 < finite(name, value) <= most:
        allowed = "common.above_zero" if math.isinf(most) else phrase("verification.above_zero_to", most=most)
        raise not_allowed(name, f"{value:g}", allowed)


def _check_order(low: float, high: float) -> None:
    if not low < high:
        raise InputError("verification.low_not_below_high", low=low, high=high)


def _cut_normal(u: NDArray[np.float64], low: float, high: float) -> NDArray[np.float64]:
    """Return standard normal values at shares u of the part between low and high."""
    from scipy.special import ndtr, ndtri

    first, last = ndtr((low, high))
    return _to_ten_decimals(ndtri(first + (last - first) * u))


def _to_ten_decimals(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Round what NumPy and SciPy computed, whose last digits depend on the processor: draws shall not."""
    return np.round(values, 10)


@dataclass(frozen=True, slots=True, repr=False)
class Uncertainty:
    """Independent quantities that are drawn together.

    Parameters
    ----------
    marginals : mapping of str to Marginal
        Each quantity by its name. Their order matters: one that is added at the end leaves the draws of the
        others as they are.

    Examples
    --------
    >>> import numpy as np
    >>> import stayput as sp
    >>> unknown = {
    ...     "room.floor.static_friction": sp.Uniform(0.3, 0.4),
    ...     "room.floor.kinetic_friction": sp.Uniform(0.2, 0.3),
    ... }
    >>> case = sp.Case(sp.Body(width=0.9, height=1.0, mass=100.0), sp.Room(), sp.near_fault())
    >>> slides = sp.simulate_many(case, sp.Uncertainty(unknown).sample(64, seed=1))["peak_slide"]
    >>> np.quantile(slides, [0.1, 0.5, 0.9]).round(2).tolist()  # m
    [0.17, 0.22, 0.26]
    """

    marginals: Mapping[str, Marginal] = field(default_factory=dict[str, Marginal])

    def __post_init__(self) -> None:
        object.__setattr__(self, "marginals", MappingProxyType(dict(self.marginals)))

    def __repr__(self) -> str:
        return f"Uncertainty({', '.join(self.marginals)})"

    def __reduce__(self) -> tuple[Any, ...]:
        return Uncertainty, (dict(self.marginals),)  # a view of a mapping cannot be pickled

    def sample(
        self, n: int, seed: int, *, motions: int | None = None, start: int = 0, stream: str = ""
    ) -> dict[str, NDArray[np.float64]]:
        """Draw values, each quantity of each motion from a stream of its own.

        Parameters
        ----------
        n : int
            Draws, or draws for each motion.
        seed : int
            Seed, ≥ 0. The same seed gives the same bits, whatever else is drawn.
        motions : int, optional
            Draw for each of so many motions, independently of the others.
        start : int
            Draws to skip, so that a later call can add more to those of an earlier one.
        stream : str
            Draws of one name are independent of those of another, and of those without.

        Returns
        -------
        dict
            Arrays by name, shape (n,) or (motions, n).

        Raises
        ------
        InputError
            A number out of range.

        Examples
        --------
        >>> drawn = Uncertainty({"friction": Lognormal(0.4, 0.2)}).sample(256, seed=1)
        >>> round(float(np.median(drawn["friction"])), 3)
        0.402
        """
        count = int(within("verification.draws", n, 1, 2**20))
        first = int(within("verification.start", start, 0, 2**20))
        streams = 1 if motions is None else int(within("verification.motions", motions, 1, 100_000))
        within("common.seed", seed, 0, 2**63)
        if not self.marginals:
            return {}
        drawn = {
            name: marginal.quantile(_shares(seed, streams, name, stream, first + count)[:, first:])
            for name, marginal in self.marginals.items()
        }
        return drawn if motions is not None else {name: column[0] for name, column in drawn.items()}


@lru_cache(maxsize=128)
def _shares(seed: int, motions: int, name: str, stream: str, count: int) -> NDArray[np.float64]:
    """Return so many draws of each motion as shares; the pieces of an inventory have the same."""
    named = (zlib.crc32(stream.encode()),) if stream else ()
    keys = ((seed, motion, zlib.crc32(name.encode()), *named) for motion in range(motions))
    return uniforms(np.array([random_bits(*key).random_raw(count) for key in keys], np.uint64))


def random_bits(*key: int) -> np.random.PCG64:
    """Return a stream of random bits; ``random_raw`` gives 64 a number.

    NumPy promises the raw bits of PCG64 and of a seed sequence for good, but not those of its distributions:
    what is drawn here is made from the bits themselves.

    Parameters
    ----------
    *key : int
        Whole numbers ≥ 0 that name the stream; another key gives an independent stream.
    """
    return np.random.PCG64(np.random.SeedSequence(key))


def uniforms(raw: NDArray[np.uint64]) -> NDArray[np.float64]:
    """Return numbers inside (0, 1), all equally likely, from the first 53 of each number's 64 bits."""
    return ((raw >> np.uint64(11)).astype(np.float64) + 0.5) * 2.0**-53


USUAL: Mapping[str, Marginal] = MappingProxyType(
    {
        "friction": Lognormal(1.0, 0.2, low=0.3, high=3.0),
        "restitution": Uniform(0.9, 1.0),
        "wall_restitution": Uniform(0.2, 0.6),
        "mass": Lognormal(1.0, 0.1, low=0.5, high=2.0),
        "gravity_height": Normal(1.0, 0.05, low=0.8, high=1.2),
        "strength": Lognormal(1.0, 0.3, low=0.2, high=5.0),
        "wall_gap": Lognormal(1.0, 0.5, low=0.2, high=3.0),
        "lean": Normal(0.0, 0.003, low=-0.01, high=0.01, unit="rad"),
        "back_inset": Uniform(0.0, 0.04),
        "front_inset": Uniform(0.0, 0.04),
        "settlement": Lognormal(1.0, 0.7, low=0.1, high=5.0),
        "landing_place": Uniform(0.3, 1.0, confidence=Confidence.MEDIUM),
    }
)
"""Common uncertainties by the fields of `stayput.montecarlo.sampling.Draw`; mostly of low confidence.

Most are factors on the stated values, the restitution's on Housner's. A wall returns 0.2 to 0.4 of the speed
where gypsum board on something heavy is crushed, and 0.35 to 0.6 where studs with their board swing along
(see the theory page). A floor leans by some 3 mm in a metre; feet and a plinth stand inside the outline by
a part of the depth. Landings push between the edge and a third of the way to it: rocking over a region of
contact loses less than Housner's corner in tests (Kalliontzis, Sritharan and Schultz 2016), and so do bodies
on springs (`stayput.model.soft_base`); materials lose more (ElGawady).
"""

QUANTITIES = Uncertainty(USUAL)
"""They as they are drawn together."""
