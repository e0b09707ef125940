"""Ranking, devices and quick estimates as rows: for CSV, and as texts for Markdown, HTML and terminal."""

from __future__ import annotations

import csv
import io
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

from stayput.catalogue import say
from stayput.fragility import JMA_INTENSITY
from stayput.measures.measure import MEANINGS
from stayput.montecarlo.counting import DEVICE_FAILED, OVERTURNED
from stayput.report.names import place_named
from stayput.report.summary import number
from stayput.report.verdict import numbers
from stayput.report.verdict.words import word
from stayput.spreadsheets import text_cell
from stayput.verification import EVENTS
from stayput.verification.grades import weakest
from stayput.verification.words import length, reason, title
from stayput.wording import with_aside

if TYPE_CHECKING:
    from stayput.catalogue import Phrase
    from stayput.fragility import Probability
    from stayput.verification import DeviceSummary, OptionVerdict, Verdict
    from stayput.verification.contents import ContentsVerdict

SHARES = (0.1, 0.5)
"""Shares of overturning whose intensities stand in the tables."""

_NO_MEASURE = "No measure"
"""The option without measures in the CSV file, whose values stay what they are."""


@dataclass(frozen=True, slots=True)
class RankingRow:
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
    grade : str
        Grade of its weakest inputs.
    weakest : str
        These inputs.
    contents : Probability, optional
        Share of the contents that comes out; none where nothing is said of contents.
    """

    option: OptionVerdict
    label: str
    name: str
    shares: tuple[tuple[str, Probability | None], ...]
    slide: tuple[str, str]
    tilt: tuple[str, str]
    reason: str
    capacities: tuple[tuple[str, str], ...]
    grade: str
    weakest: str
    contents: Probability | None


def grades_text(language: str) -> str:
    """Return the meanings of the grades in a sentence."""
    colon = word("colon", language)
    meanings = [f"{grade.value}{colon}{say(meaning, language)}" for grade, meaning in MEANINGS.items()]
    return word("grade_text", language, meanings=word("listed", language).join(meanings))


def weakest_inputs(result: OptionVerdict, verdict: Verdict, language: str) -> str:
    """Return the inputs that give an option its grade, as a text."""
    inputs = weakest(result.option, verdict.scenario)
    return word("listed", language).join(say(item.label, language) for item in inputs)


def ranking(verdict: Verdict, language: str) -> list[RankingRow]:
    """Return the options as they are read, the best first.

    Parameters
    ----------
    verdict : Verdict
        The verdict.
    language : str
        "en" or "ja".
    """
    return [_row(result, verdict, language) for result in verdict.options]


def _row(result: OptionVerdict, verdict: Verdict, language: str) -> RankingRow:
    option = result.option
    capacities = [result.capacities.get(share) for share in SHARES]
    return RankingRow(
        option=result,
        label=option.label(language),
        name=option.name if option.own_name else "",
        shares=tuple(
            (event, result.probabilities[event] if event != DEVICE_FAILED or result.devices else None)
            for event in EVENTS
        ),
        slide=numbers.slides(result.slide, verdict.scenario.room.room(), language),
        tilt=numbers.angles(result.tilt, language),
        reason=reason(result, verdict, language),
        capacities=tuple(
            (numbers.capacity(c, language), numbers.capacity_interval(c, language)) for c in capacities
        ),
        grade=verdict.grade(result).value,
        weakest=weakest_inputs(result, verdict, language),
        contents=None if result.contents is None else result.contents.out,
    )


def impossible_rows(verdict: Verdict, language: str) -> list[tuple[str, str]]:
    """Return label and reason of each option that cannot be put in place."""
    return [
        (title(impossible.option, verdict, language), impossible.why(language))
        for impossible in verdict.impossible
    ]


DEVICE_COLUMNS = ("device", "failed", "failure_time", "weakest_link", "peak_force", "used")
"""Keys of the headings of `device_rows`."""


def device_rows(result: OptionVerdict, language: str) -> list[tuple[str, ...]]:
    """Return the results of each device of an option, as texts.

    Parameters
    ----------
    result : OptionVerdict
        The option.
    language : str
        "en" or "ja".

    Returns
    -------
    list of tuple
        Name, share of failures with its interval, median time of failure, weakest link, and median and 90 %
        of the peak force and of the part of the strength that was used.
    """
    labels = {measure.kind: measure.label for measure in result.option.measures}
    return [
        device_cells(device, labels.get(device.kind, (device.kind, device.kind)), language)
        for device in result.devices
    ]


def device_cells(device: DeviceSummary, label: Phrase, language: str) -> tuple[str, ...]:
    """Return the results of a device as texts; its name has its place where its measure has several."""
    name, where = say(label, language), device.name.removeprefix(device.kind).strip()
    listed = word("listed", language)
    return (
        with_aside(name, place_named(where, language), language) if where else name,
        numbers.with_interval(device.failed, language),
        numbers.moment(device.failure_time, language),
        numbers.NO_NUMBER if device.weakest is None else say(device.weakest, language),
        listed.join(numbers.forces(device.peak, language)),
        listed.join(numbers.used(device.used, language)) or numbers.NO_NUMBER,
    )


def simulations(verdict: Verdict, language: str) -> str:
    """Return the number of simulations in words, and of the runs that were settled without one."""
    counts = {"runs": f"{verdict.runs:,}", "motions": verdict.motions, "samples": verdict.samples}
    made = word("simulations_text", language, **counts)
    return made + word("settled_text", language, settled=f"{verdict.settled:,}") if verdict.settled else made


def verdict_csv(verdict: Verdict) -> str:
    """Return the ranking as the text of a CSV file: one row an option, empty where there is no number.

    What cannot be put in place comes last, without a rank and a number, and with the reason.
    """
    text = io.StringIO()
    records = [_record(result, verdict) for result in verdict.options]
    for impossible in verdict.impossible:
        names = {"option": impossible.option.name, "measures": impossible.option.label("en")}
        records.append({**dict.fromkeys(records[0]), **names, "not_possible": impossible.reason})
    writer = csv.DictWriter(text, list(records[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows(
        {name: text_cell(cell) if isinstance(cell, str) else cell for name, cell in record.items()}
        for record in records
    )
    return text.getvalue()


def _record(result: OptionVerdict, verdict: Verdict) -> dict[str, object]:
    record: dict[str, object] = {
        "rank": result.rank,
        "option": result.option.name,
        "measures": result.option.label("en") if result.option.measures else _NO_MEASURE,
    }
    for event, chance in result.probabilities.items():
        ends = (("", chance.estimate), ("_low", chance.low), ("_high", chance.high))
        record |= {f"{event}{end}": number(value) for end, value in ends}
        record[f"{event}_count"] = chance.fell
    shares = result.probabilities[EVENTS[0]]
    record |= {"runs": shares.runs, "missing": shares.missing}
    for name, quantiles in (("slide_m", result.slide), ("tilt_rad", result.tilt)):
        record |= {f"peak_{name}_median": number(quantiles.median), f"peak_{name}_p90": number(quantiles.p90)}
    for share in SHARES:
        capacity = result.capacities.get(share)
        key = f"{'floor_jma' if verdict.floor else 'jma_intensity'}_{100.0 * share:.0f}_percent"
        record |= {
            key: None if capacity is None else number(capacity.estimate),
            f"{key}_low": None if capacity is None else number(capacity.low),
            f"{key}_high": None if capacity is None else number(capacity.high),
            f"{key}_text": None if capacity is None else capacity.text,
        }
    if result.contents is not None:
        record |= contents_data(result.contents)
    record["grade"] = verdict.grade(result).value
    record["weakest_inputs"] = weakest_inputs(result, verdict, "en")
    installed = result.installed
    record["overturned_as_installed"] = None if installed is None else number(installed.usual[OVERTURNED])
    record["not_possible"] = None
    return record


def contents_data(contents: ContentsVerdict) -> dict[str, float | None]:
    """Return what comes out of the furniture as plain values, by keys that name their units."""
    leaving = contents.leaving
    return {
        **_chance("contents_out_share", contents.out),
        "contents_runs": contents.rigid.runs,
        "contents_toppled_share": number(contents.toppled),
        "contents_out_mass_kg": number(contents.mass_out),
        "contents_leaving_height_m_median": None if leaving is None else number(leaving.height),
        "contents_leaving_height_m_most": None if leaving is None else number(leaving.highest),
        "contents_leaving_speed_m_s_median": None if leaving is None else number(leaving.speed),
        "contents_leaving_speed_m_s_p90": None if leaving is None else number(leaving.fast),
        **_chance("overturned_contents_fixed", contents.rigid),
        **_chance("overturned_without_contents", contents.emptied),
        **_chance("overturned_drawers_open", contents.opened),
    }


def _chance(key: str, chance: Probability | None) -> dict[str, float | None]:
    """Return a probability and its interval as plain values; nothing of one that does not apply."""
    ends = (None,) * 3 if chance is None else (chance.estimate, chance.low, chance.high)
    names = (key, f"{key}_low", f"{key}_high")
    return {name: None if end is None else number(end) for name, end in zip(names, ends, strict=True)}


def estimate_rows(verdict: Verdict, language: str) -> list[tuple[str, str, str]]:
    """Return each formula, its result, and the simulation's beside it, as texts.

    Parameters
    ----------
    verdict : Verdict
        The verdict.
    language : str
        "en" or "ja".
    """
    estimates = verdict.estimates
    simulated = numbers.probability(verdict.without.probabilities[OVERTURNED], language)
    rocking, _ = numbers.angles(verdict.without.tilt, language)
    slid, _ = numbers.slides(verdict.without.slide, verdict.scenario.room.room(), language)
    sliding = estimates.sliding

    text = partial(word, language=language)
    colon = text("colon")
    beside = f"{text('overturned')}{colon}{simulated}"
    median = ""
    if verdict.without.curves:  # the first verdict of the page has none
        capacity = numbers.capacity(verdict.without.curves[JMA_INTENSITY].capacity(0.5), language)
        median = f"{text('listed')}{text('capacity_short', share='50')}{colon}{capacity}"
    return [
        (
            text("west"),
            text("west_text", value=f"{estimates.rocking_acceleration:.2f}"),
            f"{text('tilt')}{colon}{rocking}",
        ),
        (
            text("ishiyama"),
            text(
                "ishiyama_text",
                value=f"{100.0 * estimates.overturning_velocity:.0f}",
                share=numbers.share(estimates.possible, language),
            ),
            beside,
        ),
        (
            text("kaneko"),
            text("kaneko_text", share=numbers.share(estimates.overturning_ratio, language)),
            f"{beside}{median}",
        ),
        *(
            (
                text("equipment", grade=load.grade, position=text(f"position_{load.position}")),
                text(
                    "equipment_overturns" if load.overturns else "equipment_stands",
                    coefficient=f"{load.coefficient:g}",
                    force=f"{load.force:.0f}",
                ),
                beside,
            )
            for load in estimates.equipment
        ),
        *(
            (
                text("ac156", ratio=f"{test.height_ratio:.2f}"),
                text("ac156_text", value=f"{test.sds:.2f}"),
                f"{text('tilt')}{colon}{rocking}",
            )
            for test in (estimates.shake_table,)
            if test is not None
        ),
        (
            text("asce43"),
            text(
                {0.0: "asce43_still", 1.0: "asce43_all"}.get(sliding.share, "asce43_text"),
                share=numbers.share(sliding.share, language),
                distance=length(sliding.distance),
            ),
            f"{text('slide')}{colon}{slid}",
        ),
    ]
