"""The ranking and the devices as rows: for CSV, and as texts for Markdown, HTML and the terminal."""

from __future__ import annotations

import csv
import io
from dataclasses import dataclass
from typing import TYPE_CHECKING

from stayput.report.verdict import numbers
from stayput.report.verdict.data import number
from stayput.report.verdict.words import named, place, word
from stayput.verification import EVENTS
from stayput.verification.verdict import DEVICE_FAILED
from stayput.verification.words import reason

if TYPE_CHECKING:
    from stayput.fragility import Probability
    from stayput.verification import DeviceSummary, OptionVerdict, Verdict

SHARES = (0.1, 0.5)
"""Shares of overturning whose intensities stand in the tables."""


@dataclass(frozen=True, slots=True)
class Row:
    """One option as it is read: texts in one language.

    Parameters
    ----------
    option : OptionVerdict
        The option.
    label : str
        What it is called.
    name : str
        What the user calls it, where that differs from its measures' own names.
    shares : tuple of (str, Probability)
        Each event and its probability; there is none of a device's failure without devices.
    slide, tilt : tuple of str
        Median and 90 % quantile of the peaks.
    reason : str
        Why it stands where it does.
    capacities : tuple of (str, str)
        Intensity at which each of `SHARES` overturns, and its interval.
    """

    option: OptionVerdict
    label: str
    name: str
    shares: tuple[tuple[str, Probability | None], ...]
    slide: tuple[str, str]
    tilt: tuple[str, str]
    reason: str
    capacities: tuple[tuple[str, str], ...]


def ranking(verdict: Verdict, language: str) -> list[Row]:
    """Return the options as they are read, the best first.

    Parameters
    ----------
    verdict : Verdict
        The verdict.
    language : str
        "en" or "ja".
    """
    return [_row(one, verdict, language) for one in verdict.options]


def _row(one: OptionVerdict, verdict: Verdict, language: str) -> Row:
    option = one.option
    usual = {"none", " + ".join(measure.kind for measure in option.measures)}
    found = [one.capacities.get(share) for share in SHARES]
    return Row(
        option=one,
        label=option.label(language),
        name="" if option.name in usual else option.name,
        shares=tuple(
            (event, one.probabilities[event] if event != DEVICE_FAILED or one.devices else None)
            for event in EVENTS
        ),
        slide=numbers.lengths(one.slide, language),
        tilt=numbers.angles(one.tilt, language),
        reason=reason(one, verdict, language),
        capacities=tuple(
            (numbers.capacity(c, language), numbers.capacity_interval(c, language)) for c in found
        ),
    )


DEVICE_COLUMNS = ("device", "failed", "failure time", "peak force", "used")
"""Keys of the headings of `device_rows`."""


def device_rows(one: OptionVerdict, language: str) -> list[tuple[str, ...]]:
    """Return what became of each device of an option, as texts.

    Parameters
    ----------
    one : OptionVerdict
        The option.
    language : str
        "en" or "ja".

    Returns
    -------
    list of tuple
        Name, share of failures with its interval, median time of failure, and median and 90 % of the peak
        force and of the part of the strength that was used.
    """
    names = {measure.kind: measure.label[place(language)] for measure in one.option.measures}
    listed = word("listed", language)
    return [
        (
            _device_name(device, names, language),
            numbers.with_interval(device.failed, language),
            numbers.moment(device.failure_time, language),
            listed.join(numbers.forces(device.peak, language)),
            listed.join(numbers.used(device.used, language)) or numbers.NO_NUMBER,
        )
        for device in one.devices
    ]


def _device_name(device: DeviceSummary, names: dict[str, str], language: str) -> str:
    """Return what a device is called, with its place where its measure has several."""
    name = names.get(device.kind, device.kind)
    if device.name in ("", device.kind):
        return name
    where = device.name.removeprefix(device.kind).strip()
    return name + word("aside", language, told=named(where, language))


def simulations(verdict: Verdict, language: str) -> str:
    """Return how many simulations there were, in words."""
    runs = f"{verdict.runs:,}"
    return word("simulations told", language, runs=runs, motions=verdict.motions, samples=verdict.samples)


def verdict_csv(verdict: Verdict) -> str:
    """Return the ranking as the text of a CSV file: one row an option, empty where there is no number."""
    text = io.StringIO()
    records = [_record(one) for one in verdict.options]
    writer = csv.DictWriter(text, list(records[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows(records)
    return text.getvalue()


def _record(one: OptionVerdict) -> dict[str, object]:
    record: dict[str, object] = {
        "rank": one.rank,
        "option": one.option.name,
        "measures": one.option.label("en"),
    }
    for event, found in one.probabilities.items():
        ends = (("", found.estimate), ("_low", found.low), ("_high", found.high))
        record |= {f"{event}{end}": number(value) for end, value in ends}
        record[f"{event}_count"] = found.fell
    shares = one.probabilities[EVENTS[0]]
    record |= {"runs": shares.runs, "missing": shares.missing}
    for name, found in (("slide_m", one.slide), ("tilt_rad", one.tilt)):
        record |= {f"peak_{name}_median": number(found.median), f"peak_{name}_p90": number(found.p90)}
    for share in SHARES:
        found = one.capacities.get(share)
        key = f"jma_intensity_{100.0 * share:.0f}_percent"
        record |= {
            key: None if found is None else number(found.estimate),
            f"{key}_low": None if found is None else number(found.low),
            f"{key}_high": None if found is None else number(found.high),
            f"{key}_text": None if found is None else found.text,
        }
    return record
