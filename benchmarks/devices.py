"""Speed of bodies that devices hold, beside the bare ones: the mixed cases of `workload`, on one core.

A body that a device holds moves on where a bare one rests or has fallen, so a case and a step are compared. A
second table makes each device stiffer and softer, with the same strength, preload and ratio of damping.
"""

from __future__ import annotations

import math
import time
from typing import TYPE_CHECKING

import numpy as np

import workload
from stayput.mechanics.devices import columns as el
from stayput.mechanics.runner import no_elements, run_cases, run_cases_with_devices, shaking

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    Measured = Callable[[], NDArray[np.void]]

COUNT, MASS = 1000, 100.0


def placed(
    count: int, plane: tuple[float, float], points: list[tuple[NDArray[np.float64], NDArray[np.float64]]]
) -> NDArray[np.void]:
    """Return planar elements at points of each body, that do nothing yet."""
    rows = no_elements(len(points), count)
    rows["kind"] = el.PLANAR
    rows["cos"], rows["sin"] = plane
    for n, (u, v) in enumerate(points):
        rows["u"][:, n], rows["v"][:, n] = u, v
    return rows


def bracket(b: NDArray[np.float64], h: NDArray[np.float64]) -> NDArray[np.void]:
    """L-bracket to a stud at the back's top edge: 300 kN/m, 1.5 kN, a millimetre of play up and down."""
    rows = placed(len(b), (0.0, -1.0), [(-b / 2, h / 2)])
    rows["stiffness"] = 300e3 / MASS, 100e3 / MASS
    rows["damping"][..., 0] = 2 * 0.05 * math.sqrt(300e3 / MASS)
    rows["slack_plus"] = rows["slack_minus"] = 0.0, 1e-3
    rows["limit_plus"] = 1500.0 / MASS
    rows["limit_minus"][..., 1] = 1500.0 / MASS
    return rows


def belt(b: NDArray[np.float64], h: NDArray[np.float64]) -> NDArray[np.void]:
    """Belts from the top, 0.1 m before the back, up to the wall: 100 kN/m, 3 kN, a centimetre of slack."""
    rows = no_elements(1, len(b))
    away, rise = 0.12, 0.12 * math.tan(0.5)
    rows["kind"] = el.AXIAL
    rows["u"][:, 0], rows["v"][:, 0] = 0.1 - b / 2, h / 2
    rows["x"][:, 0], rows["z"][:, 0] = 0.1 - b / 2 - away, h + rise
    rows["length"] = math.hypot(away, rise)
    rows["stiffness"][..., 0] = 100e3 / MASS
    rows["damping"][..., 0] = 2 * 0.05 * math.sqrt(100e3 / MASS)
    rows["slack_plus"][..., 0], rows["limit_plus"][..., 0] = 0.01, 3000.0 / MASS
    return rows


def pads(b: NDArray[np.float64], h: NDArray[np.float64]) -> NDArray[np.void]:
    """Gel pads under both edges: two of 50 mm by 50 mm each, 4 mm thick."""
    rows = placed(len(b), (1.0, 0.0), [(-b / 2, -h / 2), (b / 2, -h / 2)])
    area = 2 * 0.05 * 0.05
    rows["stiffness"] = 4e6 * area / 0.004 / MASS, 4e5 * area / 0.004 / MASS
    rows["damping"] = 0.2 * np.sqrt(rows["stiffness"])
    rows["slack_plus"], rows["slack_minus"][..., 1] = 0.0, 0.0
    rows["limit_plus"] = 100e3 * area / MASS, 50e3 * area / MASS
    rows["limit_minus"][..., 1] = 50e3 * area / MASS
    rows["interaction"] = 1
    return rows


def pole(b: NDArray[np.float64], h: NDArray[np.float64]) -> NDArray[np.void]:
    """Tension pole at the back: preload 150 N, 100 kN/m, a ceiling that bears 600 N."""
    rows = placed(len(b), (-1.0, 0.0), [(-b / 2 + 0.05, h / 2)])
    rows["stiffness"] = 100e3 / MASS, 50e3 / MASS
    rows["slack_minus"][..., 0] = -150.0 / 100e3
    rows["slack_plus"][..., 1] = rows["slack_minus"][..., 1] = 0.0
    rows["limit_minus"][..., 0], rows["friction"], rows["drops_out"] = 600.0 / MASS, 0.4, 1
    return rows


def best(run: Measured, repeats: int = 3) -> tuple[float, NDArray[np.void]]:
    """Shortest time of a run [s], and its results."""
    results, shortest = run(), math.inf
    for _ in range(repeats):
        start = time.perf_counter()
        results = run()
        shortest = min(shortest, time.perf_counter() - start)
    return shortest, results


def stiffer(elements: NDArray[np.void], factor: float) -> NDArray[np.void]:
    """Return devices with other springs, whose forces at rest and damping ratios are the same."""
    rows = elements.copy()
    rows["stiffness"] *= factor
    rows["damping"] *= math.sqrt(factor)
    preload = np.isfinite(rows["slack_minus"]) & (rows["slack_minus"] < 0.0)
    rows["slack_minus"][preload] /= factor
    return rows


def main() -> None:
    drawn = workload.mixed(COUNT)
    cases, motion = workload.columns(drawn), workload.record()
    floor = shaking(motion.x, None, motion.dt, 0)
    b, h = np.array([case.width for case in drawn]), np.array([case.height for case in drawn])

    def run(elements: NDArray[np.void]) -> tuple[float, NDArray[np.void]]:
        return best(lambda: run_cases_with_devices(cases, elements, floor)[0])

    bare, results = best(lambda: run_cases(cases, floor))
    step = bare / results["steps"].sum()
    print("device    cases/s   × bare, a case   a step    steps  events  overturned  failed devices")
    print(f"{'none':8} {COUNT / bare:8.0f} {1.0:16.1f} {1.0:8.1f} {results['steps'].mean():8.0f} "
          f"{results['events'].mean():7.1f} {np.mean(results['outcome'] == 4):11.3f}")  # fmt: skip
    devices = {make.__name__: make(b, h) for make in (bracket, belt, pads, pole)}
    for name, elements in devices.items():
        took, results = run(elements)
        gone = run_cases_with_devices(cases, elements, floor)[1]["failure"] != el.HOLDS
        print(f"{name:8} {COUNT / took:8.0f} {took / bare:16.1f} {took / results['steps'].sum() / step:8.1f} "
              f"{results['steps'].mean():8.0f} {results['events'].mean():7.1f} "
              f"{np.mean(results['outcome'] == 4):11.3f} {gone.mean():15.3f}")  # fmt: skip

    factors = (0.01, 0.1, 1.0, 10.0, 100.0)
    print("\n× bare, a case, where the springs are stiffer by")
    print(f"{'device':8}" + "".join(f"{factor:9g}" for factor in factors) + "   most/least")
    for name, elements in devices.items():
        ratios = [run(stiffer(elements, factor))[0] / bare for factor in factors]
        print(
            f"{name:8}" + "".join(f"{ratio:9.1f}" for ratio in ratios) + f"{max(ratios) / min(ratios):12.1f}"
        )


if __name__ == "__main__":
    main()
