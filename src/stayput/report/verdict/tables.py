"""Rankings, devices and quick estimates as rows: for CSV, HTML and terminal; verdicts as Markdown."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple

import stayput
from stayput.catalogue import Phrase, say
from stayput.files import csv_text
from stayput.fragility.intensity_measures import JMA_INTENSITY
from stayput.measures.measure import MEANINGS
from stayput.montecarlo.counting import DEVICE_FAILED, EVENTS, OVERTURNED
from stayput.report.names import place_named
from stayput.report.summary import number
from stayput.report.verdict import numbers
from stayput.report.verdict.assumptions import assumptions, told
from stayput.report.verdict.numbers import NO_NUMBER, word
from stayput.simulation.placing import JOINT, JOINT_LABEL
from stayput.verification.options import weakest
from stayput.verification.words import length, reason, title
from stayput.wording import with_aside

if TYPE_CHECKING:
    from stayput.fragility.curve import Capacity
    from stayput.fragility.paired import Difference
    from stayput.fragility.probabilities import Probability
    from stayput.verification import Verdict
    from stayput.verification.contents import ContentsVerdict
    from stayput.verification.verdict import DeviceSummary, OptionVerdict


def verdict_markdown(verdict: Verdict, language: str = "en") -> str:
    """Return a verdict as a text in Markdown.

    Parameters
    ----------
    verdict : Verdict
        The verdict.
    language : str
        "en" or "ja".
    """
    return "\n".join(_lines(verdict, language)) + "\n"


def _lines(verdict: Verdict, language: str) -> Iterator[str]:
    """Yield the text in pieces of one or more lines."""
    text = partial(word, language=language)
    alone, rows = verdict.scenario.alone, ranking(verdict, language)
    yield f"# {plain(verdict.scenario.title or text('report'))}"
    yield f"\n**{plain(verdict.sentence(language))}**\n"
    if not alone:
        yield f"{say('several.about', language)}\n"
    yield from (f"{plain(note)}\n" for note in verdict.notes(language))
    yield simulations(verdict, language)
    if verdict.motions == 1:
        yield f"\n{text('one_motion')}"
    if not verdict.precise:
        yield f"\n{text('not_precise')}"

    columns = [text("rank"), text("measure"), *event_headings(verdict, language)]
    if alone:
        contents = () if verdict.without.contents is None else (text("contents_out"),)
        capacities = (text("capacity", share=f"{100.0 * share:g}") for share in SHARES)
        columns += [*contents, text("slide_both"), *capacities]
    else:
        columns += [say("several.each", language), text("slide_both")]
    columns += [text("grade"), text("why")]
    blank = (NO_NUMBER,) * (len(columns) - 4)
    impossible = [
        (NO_NUMBER, label, text("not_possible"), *blank, reason)
        for label, reason in impossible_rows(verdict, language)
    ]
    ranked = [_cells(row, alone, language) for row in rows]
    yield from _section(text("ranking"), *table(columns, [*ranked, *impossible]))
    yield f"\n{plain(grades_text(language))}"

    devices = [
        (title(row.option.option, verdict, language), *each)
        for row in rows
        for each in device_rows(row.option, verdict, language)
    ]
    if devices:
        holds = () if alone else (say("several.holds", language),)
        columns = (text("measure"), *holds, *map(text, DEVICE_COLUMNS))
        yield from _section(text("devices"), *table(columns, devices))
    if verdict.estimates is not None:
        columns = (text("formula"), text("says"), text("beside"))
        formulas = table(columns, estimate_rows(verdict, language))
        yield from _section(text("estimates"), f"{text('estimates_text')}\n", *formulas)
    yield from rests_on(verdict, language)
    yield from _section(text("again"), text("again_text", file="scenario.toml", version=stayput.__version__))
    yield f"\n```toml\n{verdict.scenario.to_toml().rstrip()}\n```\n"
    yield text("caution")


def rests_on(verdict: Verdict, language: str) -> Iterator[str]:
    """Yield the lines of a verdict's assumptions."""
    columns = (word(key, language) for key in ("assumption", "value", "confidence"))
    listed = told(assumptions(verdict), language)
    rows = ((what, value, word(confidence, language)) for what, value, confidence in listed)
    yield from _section(word("assumptions", language), *table([*columns], rows))


def _section(heading: str, *lines: str) -> tuple[str, ...]:
    return f"\n## {heading}\n", *lines


def _cells(row: RankingRow, alone: bool, language: str) -> tuple[str, ...]:
    """Return a row of the ranking as its cells."""
    listed, label = word("listed", language), row.label
    if alone and row.name:
        label = with_aside(row.name, label, language)
    shares = [NO_NUMBER if chance is None else say(chance.texts, language) for _, chance in row.shares]
    contents = () if row.contents is None else (say(row.contents.texts, language),)
    pieces = [f"{name} {say(chance.texts, language)}" for name, chance in row.pieces]
    each = () if alone else (listed.join(pieces),)
    capacities = (with_aside(middle, ends, language) if ends else middle for middle, ends in row.capacities)
    head = str(row.option.rank), label, *shares
    return *head, *contents, *each, listed.join(row.slide), *capacities, row.grade, row.reason


def table(heading: Sequence[str], rows: Iterable[Sequence[str]]) -> Iterator[str]:
    """Yield the lines of a table."""
    yield f"| {' | '.join(map(plain, heading))} |"
    yield f"|{' --- |' * len(heading)}"
    for row in rows:
        yield f"| {' | '.join(map(plain, row))} |"


def plain(text: str) -> str:
    """Return a text in which no character means something to Markdown or HTML, on one line."""
    one_line = " ".join(text.split())
    return re.sub(r"([\\`*_\[\]<>|#~&])", r"\\\1", one_line)


SHARES = (0.1, 0.5)
"""Shares of overturning whose intensities stand in the tables."""

_NO_MEASURE = "No measure"
"""The option without measures in the CSV file, whose values stay what they are."""

DEVICE_COLUMNS = ("device", "failed", "failure_time", "weakest_link", "peak_force", "used", "demand")
"""Keys of the headings of `device_rows`."""


class RankingRow(NamedTuple):
    """One option as it is read: texts in one language.

    Parameters
    ----------
    option : OptionVerdict
        The option.
    label : str
        What it is called, or what it consists of; of several pieces with their names.
    name : str
        What stands for it where there is little room, a name of the user's own before all; of one piece such
        a name or nothing.
    shares : tuple of (str, Probability)
        Each event and its probability; there is none of a device's failure without devices.
    slide, tilt : tuple of str
        Median and 90 % quantile of the peaks.
    reason, brief : str
        Why it stands where it does, and the same in two clauses.
    capacities : tuple of (str, str)
        Intensity at which each of `SHARES` overturns, and its interval; of one piece.
    grade : str
        Grade of its weakest inputs.
    contents : Probability, optional
        Share of the contents that comes out; none where nothing is said of contents.
    pieces : tuple of (str, Probability)
        Each of several pieces, and how likely it overturns.
    """

    option: OptionVerdict
    label: str
    name: str
    shares: tuple[tuple[str, Probability | None], ...]
    slide: tuple[str, str]
    tilt: tuple[str, str]
    reason: str
    brief: str
    capacities: tuple[tuple[str, str], ...] = ()
    grade: str = ""
    contents: Probability | None = None
    pieces: tuple[tuple[str, Probability], ...] = ()


def ranking(verdict: Verdict, language: str) -> list[RankingRow]:
    """Return the options as they are read, the best first.

    Parameters
    ----------
    verdict : Verdict
        The verdict.
    language : str
        "en" or "ja".
    """
    scenario, rows = verdict.scenario, list[RankingRow]()
    room = scenario.surroundings()
    for result in verdict.options:
        option = result.option
        name = option.name if option.own_name else ""
        each: dict[str, Any] = {"grade": verdict.grade(result).value}
        if scenario.alone:
            label = say(option.label(), language)
            each["capacities"] = tuple(
                (numbers.capacity(reached, language), numbers.capacity_interval(reached, language))
                for reached in map(result.capacities.get, SHARES)
            )
            each["contents"] = None if result.contents is None else result.contents.out
        else:
            label, name = title(option, verdict, language), name or say(option.label(), language)
            each["pieces"] = tuple((piece.name, piece.probabilities[OVERTURNED]) for piece in result.pieces)
        shares = tuple(
            (event, result.probabilities[event] if event != DEVICE_FAILED or result.devices else None)
            for event in EVENTS
        )
        slide, tilt = numbers.slides(result.slide, room, language), numbers.angles(result.tilt, language)
        why, brief = (reason(result, verdict, language, most) for most in (None, 2))
        rows.append(RankingRow(result, label, name, shares, slide, tilt, why, brief, **each))
    return rows


def event_headings(verdict: Verdict, language: str) -> list[str]:
    """Return the headings of the columns of events."""
    limit = numbers.length(verdict.slide_limit, language)
    others = [word(event, language, limit=limit) for event in EVENTS if event != OVERTURNED]
    overturned = say(f"{'report' if verdict.scenario.alone else 'several'}.overturned", language)
    return [overturned, *others]


def impossible_rows(verdict: Verdict, language: str) -> list[tuple[str, str]]:
    """Return label and reason of each option that cannot be put in place."""
    return [(title(item.option, verdict, language), item.why(language)) for item in verdict.impossible]


def grades_text(language: str) -> str:
    """Return the meanings of the grades in a sentence."""
    colon = word("colon", language)
    meanings = [f"{grade.value}{colon}{say(meaning, language)}" for grade, meaning in MEANINGS.items()]
    return word("grade_text", language, meanings=word("listed", language).join(meanings))


def weakest_inputs(result: OptionVerdict, verdict: Verdict, language: str) -> str:
    """Return the inputs that give an option its grade, as a text."""
    inputs = weakest(result.option, verdict.scenario)
    return word("listed", language).join(say(item.label, language) for item in inputs)


def device_rows(result: OptionVerdict, verdict: Verdict, language: str) -> list[tuple[str, ...]]:
    """Return the results of each device and joint of an option, as texts.

    Parameters
    ----------
    result : OptionVerdict
        The option.
    verdict : Verdict
        The verdict that it is of.
    language : str
        "en" or "ja".

    Returns
    -------
    list of tuple
        Which piece it holds, unless there is only one; name, share of failures with its interval, median time
        of failure, weakest link, and median and 90 % of the peak force and of the part of the strength that
        was used.
    """
    labels = {JOINT: JOINT_LABEL} | {measure.kind: measure.label for measure in result.option.measures}
    joint, several = " – " if language == "en" else "と", not verdict.scenario.alone
    return [
        (
            *(joint.join(device.pieces),) * several,
            *_device(device, labels.get(device.kind, (device.kind, device.kind)), language),
        )
        for device in result.devices
    ]


def _device(device: DeviceSummary, label: Phrase, language: str) -> tuple[str, ...]:
    """Return the results of a device as texts; its name has its place where its measure has several."""
    name, where = say(label, language), device.name.removeprefix(device.kind).strip()
    listed = word("listed", language)
    return (
        with_aside(name, place_named(where, language), language) if where else name,
        say(device.failed.texts, language),
        numbers.moment(device.failure_time, language),
        numbers.NO_NUMBER if device.weakest is None else say(device.weakest, language),
        listed.join(numbers.forces(device.peak, language)),
        listed.join(numbers.used(device.used, language)) or numbers.NO_NUMBER,
        numbers.NO_NUMBER
        if device.demand is None
        else listed.join(numbers.used(device.demand, language)) or numbers.NO_NUMBER,
    )


def simulations(verdict: Verdict, language: str) -> str:
    """Return the number of simulations in words."""
    counts = {"runs": f"{verdict.runs:,}", "motions": verdict.motions, "each": verdict.runs_each}
    return word("simulations_text", language, **counts)


def verdict_csv(verdict: Verdict) -> str:
    """Return the ranking as the text of a CSV file: one row an option, empty where there is no number.

    What cannot be put in place comes last, without a rank and a number, and with the reason.
    """
    names = verdict.scenario.names
    records = [_record(result, verdict) for result in verdict.options]
    records += [
        {
            "option": item.option.name,
            "measures": say(item.option.label(names), "en"),
            "not_possible": item.why("en"),
        }
        for item in verdict.impossible
    ]
    columns = list(records[0])
    return csv_text(columns, ([record.get(name) for name in columns] for record in records), "\n")


def _record(result: OptionVerdict, verdict: Verdict) -> dict[str, object]:
    shares, alone = result.probabilities[OVERTURNED], verdict.scenario.alone
    measures = say(result.option.label(verdict.scenario.names), "en") if result.option.count else _NO_MEASURE
    record: dict[str, object] = {"rank": result.rank, "option": result.option.name, "measures": measures}
    for event, chance in result.probabilities.items():
        record |= {**_ends(event, chance), f"{event}_count": chance.fell}
    record |= {"runs": shares.runs, "missing": shares.missing}
    for key, quantiles in (("peak_slide_m", result.slide), ("peak_tilt_rad", result.tilt)):
        record |= {f"{key}_median": number(quantiles.median), f"{key}_p90": number(quantiles.p90)}
    for piece in () if alone else result.pieces:
        record[f"overturned: {piece.name}"] = number(piece.probabilities[OVERTURNED].estimate)
    for share in SHARES if alone else ():
        capacity = result.capacities.get(share)
        key = f"{'floor_jma' if verdict.floor else 'jma_intensity'}_{100.0 * share:.0f}_percent"
        record |= {**_ends(key, capacity), f"{key}_text": None if capacity is None else capacity.text}
    if result.contents is not None:
        record |= contents_data(result.contents)
    record |= {"grade": verdict.grade(result).value, "weakest_inputs": weakest_inputs(result, verdict, "en")}
    if alone:
        record["overturned_as_installed"] = result.installed and number(result.installed.usual[OVERTURNED])
    return {**record, "not_possible": None}


def contents_data(contents: ContentsVerdict) -> dict[str, float | None]:
    """Return what comes out of the furniture as plain values, by keys that name their units."""
    leaving = contents.leaving
    return {
        **_ends("contents_out_share", contents.out),
        **_ends("contents_out_change", contents.change),
        "contents_runs": contents.rigid.runs,
        "contents_toppled_share": number(contents.toppled),
        "contents_out_mass_kg": number(contents.mass_out),
        "contents_leaving_height_m_median": None if leaving is None else number(leaving.height),
        "contents_leaving_height_m_most": None if leaving is None else number(leaving.highest),
        "contents_leaving_speed_m_s_median": None if leaving is None else number(leaving.speed),
        "contents_leaving_speed_m_s_p90": None if leaving is None else number(leaving.fast),
        **_ends("overturned_contents_fixed", contents.rigid),
        **_ends("overturned_without_contents", contents.emptied),
        **_ends("overturned_drawers_open", contents.opened),
    }


def _ends(key: str, value: Probability | Difference | Capacity | None) -> dict[str, float | None]:
    """Return an estimate and its interval as plain values; nothing of one that does not apply."""
    ends = (None,) * 3 if value is None else map(number, (value.estimate, value.low, value.high))
    return dict(zip((key, f"{key}_low", f"{key}_high"), ends, strict=True))


def estimate_rows(verdict: Verdict, language: str) -> list[tuple[str, str, str]]:
    """Return each formula, its result, and the simulation's beside it, as texts.

    Parameters
    ----------
    verdict : Verdict
        The verdict.
    language : str
        "en" or "ja".
    """
    estimates, bare = verdict.estimates, verdict.without
    assert estimates is not None
    room = verdict.scenario.room.room()
    text = partial(word, language=language)

    def beside(key: str, value: str) -> str:
        return f"{text(key)}{text('colon')}{value}"

    overturned = beside("overturned", numbers.probability(bare.probabilities[OVERTURNED], language))
    rocking = beside("tilt", numbers.angles(bare.tilt, language)[0])
    median = ""
    if bare.curves:  # the first verdict of the page has none
        capacity = numbers.capacity(bare.curves[JMA_INTENSITY].capacity(0.5), language)
        median = f"{text('listed')}{text('capacity_short', share='50')}{text('colon')}{capacity}"
    velocity, possible = f"{100.0 * estimates.overturning_velocity:.0f}", estimates.possible
    falls = numbers.share(estimates.overturning_ratio, language)
    west = text("west_text", value=f"{estimates.rocking_acceleration:.2f}")
    ishiyama = text("ishiyama_text", value=velocity, share=numbers.share(possible, language))
    shown = [
        (text("west"), west, rocking),
        (text("ishiyama"), ishiyama, overturned),
        (text("kaneko"), text("kaneko_text", share=falls), f"{overturned}{median}"),
    ]
    for load in estimates.equipment:
        key, force = f"equipment_{'overturns' if load.overturns else 'stands'}", f"{load.force:.0f}"
        says = text(key, coefficient=f"{load.coefficient:g}", force=force)
        name = text("equipment", grade=load.grade, position=text(f"position_{load.position}"))
        shown.append((name, says, overturned))
    if (test := estimates.shake_table) is not None:
        name = text("ac156", ratio=f"{test.height_ratio:.2f}")
        shown.append((name, text("ac156_text", value=f"{test.sds:.2f}"), rocking))
    sliding = estimates.sliding
    says = text(
        {0.0: "asce43_still", 1.0: "asce43_all"}.get(sliding.share, "asce43_text"),
        share=numbers.share(sliding.share, language),
        distance=length(sliding.distance),
    )
    slid = beside("slide", numbers.slides(bare.slide, room, language)[0])
    return [*shown, (text("asce43"), says, slid)]
