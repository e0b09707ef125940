"""What the devices of an option would have to bear: their forces in runs in which they cannot fail.

A device that fails has borne no more than its strength. So demand over strength is taken from runs with the
same device in its unbreakable form, of the same stiffness, under the same motions and draws.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from stayput.montecarlo.counting import Quantiles

if TYPE_CHECKING:
    from stayput.measures import Element
    from stayput.montecarlo.runs import Runs
    from stayput.scenario.measures import Option
    from stayput.verification.option_runner import OptionRunner
    from stayput.verification.verdict import OptionVerdict


def with_demand(runner: OptionRunner, verdict: OptionVerdict) -> OptionVerdict:
    """Return the verdict on an option with what is asked of its devices, over what they bear.

    Parameters
    ----------
    runner : OptionRunner
        Under whose motions and draws the option ran.
    verdict : OptionVerdict
        The verdict on it.
    """
    held = runner.held_by(verdict.option)
    if not any(element is not None for _, element in held):
        return verdict
    (runs,) = runner.run([unbreakable(verdict.option)], runner.demand_members)
    devices = tuple(
        device if element is None else replace(device, demand=_demand(element, runs, number))
        for number, (device, (_, element)) in enumerate(zip(verdict.devices, held, strict=True))
    )
    return replace(verdict, devices=devices)


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
