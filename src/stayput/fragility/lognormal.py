"""Lognormal fragility curve for loss tools, and a test of its goodness of fit.

The curve is p = Φ(a + b u), fitted by maximum likelihood (Shinozuka, Feng, Lee and Naganuma 2000; Baker
2015, equations 10 to 12): the log-likelihood is concave, so that Newton's method with halved steps finds the
one maximum. It is tested against p = Φ(a + b u + c u² + d u³), which bends where a lognormal cannot: a lower
tail that is too heavy, a plateau between two kinds of motions. The test is Rao's score test with the motions
as the units: their scores of (c, d), less what a change of (a, b) would explain, are compared with their own
scatter (Liang and Zeger 1986; Rotnitzky and Jewell 1990) by Hotelling's T², whose F distribution knows that
the motions are few.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import chdtrc, fdtrc, log_ndtr, ndtr, ndtri

from stayput.catalogue import Phrase, phrase
from stayput.fragility.probabilities import percent

if TYPE_CHECKING:
    from stayput.fragility.intensity_measures import IntensityMeasure
    from stayput.fragility.trials import Level, Trials

SIGNIFICANCE = 0.05
"""A lognormal fits where its test gives no smaller probability than this."""

FEWEST_MOTIONS = 5
"""Motions that the test needs: with fewer their scatter says nothing."""

_BENDS = 2
"""Powers of u that the test adds, where there are levels enough to see them."""

_SINGULAR = 1e-12
"""Share of the product of its diagonal below which a covariance's determinant counts as none."""

_STEPS = 40
_TOLERANCE = 1e-10
_HALVINGS = 12
_LOG_ROOT_2PI = 0.5 * math.log(2.0 * math.pi)


@dataclass(frozen=True, slots=True, eq=False)
class LognormalFit:
    """The curve p = Φ((u − μ)/β), u being the logarithm of a peak or the intensity itself, and its test.

    Parameters
    ----------
    measure : IntensityMeasure
        What the curve is over.
    median : float
        Parameter θ = exp μ [SI], or μ of an intensity. It may lie outside what was run.
    dispersion : float
        Parameter β: standard deviation of the logarithm of the peak, or of the intensity, at falling.
    p_value : float
        Probability of falls that bend so much or more, were the curve right; NaN where it cannot be tested.
    misfit : float
        Largest difference between an observed share and the curve.
    seen : bool
        Whether the median lies within what was run. Beyond, nothing bears it out.
    """

    measure: IntensityMeasure
    median: float
    dispersion: float
    p_value: float
    misfit: float
    seen: bool

    @property
    def fits(self) -> bool:
        """Whether the curve was tested and passed, and its median was seen."""
        return self.seen and self.p_value >= SIGNIFICANCE

    @property
    def family(self) -> str:
        """Family of the distribution: normal in an intensity, which is a logarithm already."""
        return "normal" if self.measure.is_logarithm else "lognormal"

    @property
    def texts(self) -> Phrase:
        """The parameters and the test in a sentence, in both languages."""
        untested = math.isnan(self.p_value)
        result = "untested" if untested else "unseen" if not self.seen else "fits" if self.fits else "misfits"
        median = self.measure.text(self.median)
        test = phrase("fragility.test", p=self.p_value, points=percent(self.misfit))
        return phrase(
            "fragility.lognormal_curve",
            family=phrase(f"fragility.{self.family}"),
            result=phrase(f"fragility.{result}"),
            parameters=phrase("fragility.parameters", median=median, dispersion=self.dispersion),
            test=phrase("common.aside", content=test) if result in ("fits", "misfits") else "",
        )

    @property
    def text(self) -> str:
        """The parameters and the test in an English sentence."""
        return self.texts[0]

    def probability(self, im: ArrayLike) -> NDArray[np.float64]:
        """Return the probability of falling at intensities [SI]."""
        u, middle = self.measure.coordinate(im), self.measure.coordinate(self.median)
        return ndtr((u - middle) / self.dispersion)


def lognormal(trials: Trials, levels: tuple[Level, ...]) -> LognormalFit | None:
    """Fit a lognormal curve and test it; None where no rise of the falls has a slope.

    Parameters
    ----------
    trials : Trials
        What was run.
    levels : tuple of Level
        What was observed, to compare the curve with.
    """
    u = trials.measure.coordinate(trials.im)
    fell, stood = trials.fell, trials.runs - trials.fell
    falls, stands = u[fell > 0.0], u[stood > 0.0]
    if stands.max() <= falls.min() or falls.max() <= stands.min():  # Albert and Anderson (1984)
        return None
    middle, spread = float(u.mean()), float(u.std())
    v = (u - middle) / spread
    ab = _fit(v, fell, stood)
    a, b = float(ab[0]), float(ab[1])
    if not b > 0.0:
        return None
    slope, curvature = _derivatives(v, fell, stood, ab)
    median = float(trials.measure.value(middle - a / b * spread))
    p = ndtr(a + b * (trials.measure.coordinate([level.im for level in levels]) - middle) / spread)
    misfit = float(np.abs(p - [level.probability.estimate for level in levels]).max())
    p_value = _p_value(v, slope, curvature, trials.motion)
    seen = levels[0].im <= median <= levels[-1].im
    return LognormalFit(trials.measure, median, spread / b, p_value, misfit, seen)


def _p_value(
    v: NDArray[np.float64],
    slope: NDArray[np.float64],
    curvature: NDArray[np.float64],
    motion: NDArray[np.intp] | None,
) -> float:
    """Return the test's p-value from each cell's slope and curvature of the log-likelihood."""
    bends = min(_BENDS, len(np.unique(v)) - 2)
    if bends < 1 or (motion is not None and motion.max() + 1 < FEWEST_MOTIONS):
        return math.nan
    # what of each power the line a + b v does not explain, so that an error of a and b does not count
    powers = [v**power for power in range(2, 2 + bends)]
    shared = [((curvature * power).sum(), (curvature * v * power).sum()) for power in powers]
    lines = np.linalg.solve(_information(v, curvature), np.transpose(shared)).astype(np.float64)
    bent = np.stack([power - a - b * v for power, (a, b) in zip(powers, lines.T, strict=True)])
    score: NDArray[np.float64] = (slope * bent).sum(axis=1)
    motions = 0
    if motion is None:
        variance: NDArray[np.float64] = (curvature * bent[:, np.newaxis] * bent).sum(axis=2)
    else:
        motions = int(motion.max()) + 1
        parts = np.stack([np.bincount(motion, slope * column, motions) for column in bent])
        centred = parts - parts.mean(axis=1, keepdims=True)
        variance = motions / (motions - 1.0) * (centred[:, np.newaxis] * centred).sum(axis=2)
    if not np.linalg.det(variance) > _SINGULAR * np.prod(np.diag(variance)):
        return math.nan
    weighed = np.linalg.solve(variance, score).astype(np.float64)
    squared = float((score * weighed).sum())
    if motion is None:
        return float(chdtrc(bends, squared))
    free = motions - bends
    return float(fdtrc(bends, free, squared * free / (bends * (motions - 1.0))))


def _fit(
    v: NDArray[np.float64], fell: NDArray[np.float64], stood: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Return (a, b) of the largest likelihood; the coordinates v have the mean 0 and the spread 1."""
    share = np.clip(fell.sum() / (fell + stood).sum(), 1e-3, 1.0 - 1e-3)
    ab = np.array([ndtri(share), 0.0], np.float64)
    height = _log_likelihood(v, fell, stood, ab)
    for _ in range(_STEPS):
        slope, curvature = _derivatives(v, fell, stood, ab)
        gradient = np.array([slope.sum(), (slope * v).sum()])
        step = np.linalg.solve(_information(v, curvature), gradient).astype(np.float64)
        gain = 0.5 * (gradient * step).sum()
        reached = _log_likelihood(v, fell, stood, ab + step)
        for _ in range(_HALVINGS):
            if not reached < height - 1e-12 * abs(height):
                break
            step *= 0.5
            reached = _log_likelihood(v, fell, stood, ab + step)
        ab, height = ab + step, reached
        if not gain > _TOLERANCE:
            break
    return ab


def _log_likelihood(
    v: NDArray[np.float64], fell: NDArray[np.float64], stood: NDArray[np.float64], ab: NDArray[np.float64]
) -> float:
    """Return Σ k ln Φ(η) + (n − k) ln Φ(−η), η = a + b v."""
    eta = ab[0] + ab[1] * v
    return float((fell * log_ndtr(eta) + stood * log_ndtr(-eta)).sum())


def _derivatives(
    v: NDArray[np.float64], fell: NDArray[np.float64], stood: NDArray[np.float64], ab: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return each cell's slope and curvature of the log-likelihood in η.

    With λ(η) = φ(η)/Φ(η): slope k λ(η) − (n − k) λ(−η); curvature, its sign turned,
    k λ(η)(λ(η) + η) + (n − k) λ(−η)(λ(−η) − η).
    """
    eta = ab[0] + ab[1] * v
    log_density = -0.5 * eta * eta - _LOG_ROOT_2PI
    up = np.exp(log_density - log_ndtr(eta))
    down = np.exp(log_density - log_ndtr(-eta))
    return fell * up - stood * down, fell * up * (up + eta) + stood * down * (down - eta)


def _information(v: NDArray[np.float64], curvature: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the observed information of (a, b) from each cell's curvature, shape (2, 2)."""
    aa, ab, bb = curvature.sum(), (curvature * v).sum(), (curvature * v * v).sum()
    return np.array([[aa, ab], [ab, bb]])
