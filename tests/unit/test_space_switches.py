"""At which part of a step of a flow a device begins or ends to bear, yields or rubs."""

import math
from typing import Any

import numpy as np
import pytest

from stayput.compiling import entry
from stayput.mechanics.devices import columns as col
from stayput.mechanics.space.columns import PULL, SPRING
from stayput.mechanics.space.devices import first_switch  # pyright: ignore[reportUnknownVariableType]

STIFFNESS, SLACK, STRENGTH = 1e6, 5e-4, 1000.0
"""Along the normal and the plane [N/m, m, N]."""


@entry
def switch_of(springs: Any, before: Any, pulls: Any, found: Any) -> None:
    found[0] = first_switch(springs, before, pulls)


def device(**law: Any) -> np.ndarray:
    """Return a device with play both ways, along the normal and the plane."""
    springs = np.zeros(1, SPRING)
    springs["kind"] = col.PLANAR
    stated = {"stiffness": STIFFNESS, "slack_plus": SLACK, "slack_minus": SLACK, "friction": math.nan}
    for name, value in (
        {"limit_plus": STRENGTH, "limit_minus": STRENGTH, "ultimate": 0.01} | stated | law
    ).items():
        springs[name] = value
    return springs


def stretched(
    e: float, force: float, along: float = 0.0, shear: float = 0.0, plastic: float = 0.0
) -> np.ndarray:
    pulls = np.zeros(1, PULL)
    for name, value in {"e": e, "force": force, "xx": along, "shear": shear, "plastic": plastic}.items():
        pulls[name] = value
    return pulls


@pytest.mark.parametrize(
    ("before", "after", "part"),
    [
        (stretched(0.0, 0.0), stretched(1e-3, 500.0), 0.5),  # it takes up its play
        (stretched(1e-3, 500.0), stretched(0.0, 0.0), 0.5),
        (stretched(2e-4, 0.0), stretched(-1e-3, -500.0), 0.7 / 1.2),
        (stretched(0.0, 0.0, plastic=2e-4), stretched(1e-3, 300.0, plastic=2e-4), 0.7),
        (stretched(1e-3, 500.0), stretched(-1e-3, -500.0), 0.25),  # through its play, which ends at 0.75
        (stretched(7e-4, 200.0), stretched(1.7e-3, 1000.0), 0.8),  # it yields where 1 mm is taken up
        (stretched(-7e-4, -200.0), stretched(-1.7e-3, -1000.0), 0.8),
        (stretched(0.0, 0.0), stretched(0.0, 0.0, 1e-3, 500.0), 0.5),
        (stretched(0.0, 0.0, 1e-3, 500.0), stretched(0.0, 0.0, 2e-3, 1000.0), 0.5),
        (stretched(0.0, 0.0), stretched(4e-4, 0.0), math.inf),
        (stretched(7e-4, 200.0), stretched(9e-4, 400.0), math.inf),
    ],
)
def test_a_device_switches_where_its_law_has_a_kink(
    before: np.ndarray, after: np.ndarray, part: float
) -> None:
    found = np.zeros(1)
    switch_of(device(), before, after, found)
    assert found[0] == pytest.approx(part)


def test_a_head_rubs_from_where_its_push_holds_no_more() -> None:
    springs, found = device(friction=0.5, slack_plus=0.0, slack_minus=0.0), np.zeros(1)
    before, after = stretched(-6e-4, -600.0, 1e-4, 100.0), stretched(-6e-4, -600.0, 2e-3, 300.0)
    switch_of(springs, before, after, found)  # it sticks up to 0.3 mm
    assert found[0] == pytest.approx(2.0 / 19.0)


def test_the_first_of_several_devices_counts_and_what_is_lost_does_not() -> None:
    springs, found = np.concatenate([device()] * 3), np.zeros(1)
    before = np.concatenate([stretched(0.0, 0.0)] * 3)
    after = np.concatenate([stretched(e, 1e6 * (e - SLACK)) for e in (1e-3, 2e-3, 5e-3)])
    after["lost"][2] = 1
    switch_of(springs, before, after, found)
    assert found[0] == pytest.approx(0.25)


def test_what_lets_go_under_both_forces_does_not_yield() -> None:
    found = np.zeros(1)
    switch_of(device(interaction=1), stretched(7e-4, 200.0), stretched(1.7e-3, 1000.0), found)
    assert found[0] == math.inf
