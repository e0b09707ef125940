"""What the devices of an option would have to bear: their forces in runs in which they cannot fail.

A device that fails has borne no more than its strength, and tells nothing of what it would have had to bear.
So runs in which one reaches its strength are repeated with devices in their unbreakable form, of the same
stiffness, under the same motions and draws. The others would be the same, but for rounding near the strength.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from stayput.montecarlo.counting import Quantiles
from stayput.montecarlo.runs import Runs

if TYPE_CHECKING:
    from stayput.measures import Element
    from stayput.scenario.measures import Option
    from stayput.verification.option_runner import OptionRunner
    from stayput.verification.verdict import OptionVerdict

DEMAND_RUNS = 16
"""Runs at the stated shaking with unbreakable devices: the median of 16 peaks is within their middle half."""


def with_demand(runner: OptionRunner, verdict: OptionVerdict) -> OptionVerdict:
    """Return the verdict on an option with what is asked of its devices, over what they bear.

    Parameters
    ----------
    runner : OptionRunner
        Under whose motions and draws the option ran.
    verdict : OptionVerdict
        The verdict on it.
    """
    option = verdict.option
    held = runner.held_by(option)
    if not any(element is not None for _, element in held):
        return verdict
    runs = demand_runs(runner, option, unbreakable(option))
    devices = tuple(
        device if element is None else replace(device, demand=_demand(element, runs, number))
        for number, (device, (_, element)) in enumerate(zip(verdict.devices, held, strict=True))
    )
    return replace(verdict, devices=devices)


def demand_runs(runner: OptionRunner, option: Option, strong: Option, count: int = DEMAND_RUNS) -> Runs:
    """Return runs of an option at the stated shaking, in which its devices bear what is asked of them.

    Parameters
    ----------
    runner : OptionRunner
        The motions and draws.
    option, strong : Option
        The option, and the same with devices that cannot fail.
    count : int
        How many runs.
    """
    members = runner.members.chosen(runner.members.level == 0).chosen(slice(count))
    (runs,) = runner.run([option], members)
    broken: NDArray[np.bool_] = np.any(runs.used >= 1.0, axis=1)
    if not broken.any():
        return runs
    (repeated,) = runner.run([strong], members.chosen(broken))
    return Runs.joined([runs.chosen(~broken), repeated])


def unbreakable(option: Option) -> Option:
    """Return an option whose devices cannot fail; the ones that have no strength are as they are."""
    on = tuple(tuple(measure.unbreakable() for measure in measures) for measures in option.on)
    return replace(option, on=on)


def _demand(element: Element, runs: Runs, number: int) -> Quantiles | None:
    """Return the largest force on a device over its strength; None of what any force leaves whole."""
    normal, tangent, device = element.normal, element.tangent, runs.devices[:, number]
    across = min(tangent.limit_plus, tangent.limit_minus) if tangent.stiffness > 0.0 else np.inf
    strengths = {"peak_pull": normal.limit_plus, "peak_push": normal.limit_minus, "peak_shear": across}
    finite = {name: limit for name, limit in strengths.items() if 0.0 < limit < np.inf}
    ratios = [runs.masses * device[name] / limit for name, limit in finite.items()]
    if not ratios:
        return None
    asked = np.max(ratios, axis=0)[~runs.missing]
    return Quantiles.of(asked, np.zeros_like(asked, np.bool_))
