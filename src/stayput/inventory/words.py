"""What an assessment came to, in sentences: for its report and for the command line."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING, Any

from stayput.catalogue import phrase, say
from stayput.fragility.probabilities import percent
from stayput.inventory.results import Finding, least_motions
from stayput.measures import MEASURES
from stayput.montecarlo.counting import RANKING_ORDER
from stayput.report.names import given_name
from stayput.verification.contents import MOTIONS
from stayput.verification.words import SAFE
from stayput.wording import counted

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Mapping, Sequence

    from stayput.catalogue import Phrase
    from stayput.inventory.summary import Total

_SHEET = re.compile(r"sheet (?P<name>'.*?')(?:; not (?P<others>.*))?")
"""How a sheet of a workbook is called in the facts."""


def counted_phrase(number: int, noun: str, counter: str) -> Phrase:
    """Return a number with its noun in English, and with its counter in Japanese."""
    return counted(number, noun), f"{number:,}{counter}"


def pieces_counted(number: int) -> Phrase:
    """Return a number of pieces."""
    return counted_phrase(number, "piece", "点")


def narrow_told(facts: Mapping[str, Any], language: str) -> str:
    """Return how many rows are narrower than deep; empty where none is."""
    narrow = facts["narrower than deep"]
    return (
        say("inventory_report.narrow", language, rows=counted_phrase(narrow, "row", "行")) if narrow else ""
    )


def empty_told(facts: Mapping[str, Any], language: str) -> str:
    """Return in which columns cells are empty, and what holds there; empty where none is."""
    counts = [
        say("inventory_report.empty_column", language, column=column, rows=counted_phrase(rows, "row", "行"))
        for column, rows in facts["empty cells"].items()
    ]
    listed = say("common.listed", language).join(counts)
    return say("inventory_report.empty_cells", language, columns=listed) if counts else ""


def first_of(items: Sequence[str], total: int, language: str) -> str:
    """Return the first few of more items, as "2, 3, 4, …"."""
    return (", " if language == "en" else "、").join([*items, "…"] if total > len(items) else items)


def rows_told(found: Mapping[str, Any], language: str) -> str:
    """Return how many rows have a finding in common, and which are the first of them."""
    places = first_of([str(row["row"]) for row in found["first"]], found["rows"], language)
    rows = counted_phrase(found["rows"], "row", "行")
    return say("inventory_report.rows_alike", language, rows=rows, places=places)


def reason_told(found: Mapping[str, Any], language: str) -> str:
    """Return the reason of a finding; that of its first row as an example, where others differ from it."""
    reason = found["reason" if language == "en" else "reason_ja"]
    return reason if found["same"] else say("inventory_report.such_as", language, reason=reason)


def impossible_told(facts: Mapping[str, Any], language: str) -> list[str]:
    """Return which sets of measures cannot be put in place, in which rows, and why."""
    return [
        say(
            "inventory_report.not_possible",
            language,
            name=measures_named(found["about"], language),
            rows=rows_told(found, language),
            reason=reason_told(found, language),
        )
        for found in facts["measures not possible"]
    ]


def share_told(value: float | None, language: str) -> str:
    """Return a share in per cent; empty where there is none."""
    if value is None:
        return ""
    if math.isnan(value):
        return say("inventory_report.unknown", language)
    return say("inventory_report.share", language, value=percent(value))


def interval_told(row: Mapping[str, Any], which: str, language: str) -> str:
    """Return the probability of overturning of a row, with its interval.

    Parameters
    ----------
    row : mapping
        The row.
    which : str
        "overturned" without a measure, "best_overturned" with the best one.
    language : str
        "en" or "ja".
    """
    return _interval(lambda end: row[f"{which}{end}"], language)


def share_of(total: Total, which: str, language: str) -> str:
    """Return the share that overturns with its interval; with "_best" of the best measures."""
    return _interval(lambda end: total.share(f"{which}{end}"), language)


def _interval(value: Callable[[str], float], language: str) -> str:
    ends = {"estimate": "", "low": "_low", "high": "_high"}
    shown = {name: percent(value(end)) for name, end in ends.items()}
    return say("inventory_report.interval", language, **shown)


def amount(value: float | None) -> str:
    """Return an amount of money; empty where there is none."""
    return "" if value is None else f"{value:,.0f}"


def building_named(building: str, language: str) -> str:
    """Return a building's name, in a language where stayput gave it, or that there is none."""
    return given_name(building, language) if building else say("inventory_report.no_building", language)


def measures_named(name: str, language: str) -> str:
    """Return a set of measures as it is called in a language; a name of one's own stays as it is."""
    if language == "en":
        return name
    return "+".join(
        say(MEASURES[part].label, language) if part in MEASURES else part
        for part in map(str.strip, name.split("+"))
    )


def read_as(facts: Mapping[str, Any]) -> Phrase:
    """Return how a table was read, in both languages, and how many of its rows are empty."""
    how: str | Phrase = facts["read as"]
    encoding, _, between = facts["read as"].partition(" with ")
    if between in ("tabs", "semicolons"):
        how = phrase(f"inventory_report.with_{between}", encoding=encoding)
    elif sheet := _SHEET.fullmatch(facts["read as"]):
        key = "sheet" if sheet["others"] is None else "sheet_of_several"
        how = phrase(f"inventory_report.{key}", **sheet.groupdict())
    empty = facts["empty rows"]
    return phrase(f"inventory_report.{'and_empty' if empty else 'read_as'}", how=how, count=empty)


def expected(total: Total, language: str) -> str:
    """Return how many pieces are expected to overturn, without and with the best measures."""
    best = ""
    if total.fallen_best < total.fallen:
        shared = share_of(total, "_best", language)
        fallen = f"{total.fallen_best:,.1f}"
        best = say("inventory_report.expected_best", language, fallen=fallen, share=shared)
    return say(
        "inventory_report.expected",
        language,
        fallen=f"{total.fallen:,.1f}",
        pieces=pieces_counted(total.pieces),
        verb=("is" if total.pieces == 1 else "are", ""),
        share=_known_share(total, language),
        best=best,
    )


def _known_share(total: Total, language: str) -> str:
    """Return the share that overturns with its interval, or that nothing is known of it."""
    if total.pieces == total.unknown:
        return say("inventory_report.given_up", language)
    return share_of(total, "", language)


def against_event(event: str) -> Phrase:
    """Return what a measure helps against that lessens an event."""
    return phrase(f"inventory_report.against_{event}")


def findings_told(total: Total, language: str) -> str:
    """Return what the runs show: of how many pieces a measure helps, none is needed, or nothing is shown."""

    def against(finding: Finding) -> str:
        counts = ((event, total.lessened[finding, event]) for event in RANKING_ORDER)
        parts = [
            say("inventory_report.against_counted", language, count=n, against=against_event(event))
            for event, n in counts
            if n
        ]
        return say("common.listed", language).join(parts)

    told = (
        say(
            f"inventory_report.{finding}_counted",
            language,
            pieces=pieces_counted(total.found[finding]),
            against=against(finding),
            safe=percent(SAFE),
            least=least_motions(),
        )
        for finding in Finding
        if total.found[finding]
    )
    return (" " if language == "en" else "").join(told)


def further(total: Total, language: str) -> str:
    """Return what else is known of the pieces: what helps, the loss, what comes out, what is unknown."""
    return (" " if language == "en" else "").join(_further(total, language))


def _further(total: Total, language: str) -> Iterator[str]:
    if told := findings_told(total, language):
        yield told
    if total.loss is not None:
        loss, best = amount(total.loss), amount(total.loss_best)
        yield say("inventory_report.expected_loss", language, loss=loss, best=best)
    if total.share_out is not None:
        yield say(
            "inventory_report.inside_out",
            language,
            pieces=pieces_counted(total.filled),
            share=share_told(total.share_out, language),
            best=share_told(total.share_out_best, language),
        )
    if total.unknown:
        yield say("inventory_report.nothing_known", language, pieces=pieces_counted(total.unknown))


def done(facts: Mapping[str, Any], manifest: Mapping[str, Any], contents: bool, language: str) -> list[str]:
    """Return what was read and computed, a sentence or two each.

    Parameters
    ----------
    facts : mapping
        What is known of the plan.
    manifest : mapping
        What the manifest says of the assessment.
    contents : bool
        Whether there is anything inside the pieces.
    language : str
        "en" or "ja".
    """
    rows = counted_phrase(facts["rows"], "row", "行")
    read = say("inventory_report.read", language, rows=rows, how=read_as(facts))
    if facts["columns not used"]:
        columns = ", ".join(facts["columns not used"])
        read += (" " if language == "en" else "") + say(
            "inventory_report.not_used", language, columns=columns
        )
    if facts["columns renamed"]:
        columns = ", ".join(facts["columns renamed"])
        read += (" " if language == "en" else "") + say("inventory_report.renamed", language, columns=columns)
    if empty_cells := empty_told(facts, language):
        read += (" " if language == "en" else "") + empty_cells
    told = [read, *(_scenario(scenario, language) for scenario in manifest["scenarios"])]
    choices = counted_phrase(facts["choices"], "combination", "通り")
    told.append(say("inventory_report.units", language, choices=choices, units=f"{facts['units']:,}"))
    told.append(say("inventory_report.slide_limit", language, limit=manifest["slide limit"]))
    if contents:
        told.append(say("inventory_report.contents_followed", language, most=MOTIONS))
    told += [say(f"inventory_report.{key}", language) for key in ("intervals", "best_chosen")]
    if manifest["shake map"]:
        told.append(say("inventory_report.shake_map", language, map=tuple(manifest["shake map"])))
    return [*told, say("inventory_report.version", language, version=manifest["version"])]


def _scenario(scenario: Mapping[str, Any], language: str) -> str:
    level = scenario["intensity"]
    suite = scenario["suite"]
    return say(
        "inventory_report.scenario",
        language,
        name=scenario["name"],
        strength="" if level is None else phrase("inventory_report.at_intensity", value=level),
        suite=given_name(suite, language) if suite else phrase("inventory_report.one_motion"),
        motions=counted_phrase(scenario["motions"], "motion", "本"),
        synthetic=phrase("inventory_report.synthetic") if scenario["synthetic"] else "",
        samples=counted_phrase(scenario["samples"], "Monte Carlo sample", "組"),
        seed=scenario["seed"],
    )


def printed(total: Total, event: str, language: str) -> list[str]:
    """Return what an event came to, in the lines of a terminal."""
    best: Phrase | str = ""
    if total.fallen_best < total.fallen:
        best = phrase("inventory_report.printed_best", fallen=f"{total.fallen_best:,.1f}")
    lines = [
        say(
            "inventory_report.printed_expected",
            language,
            event=event,
            fallen=f"{total.fallen:,.1f}",
            pieces=pieces_counted(total.pieces),
            share=_known_share(total, language),
            best=best,
        )
    ]
    if told := findings_told(total, language):
        lines.append(told)
    if total.share_out is not None:
        lines.append(
            say(
                "inventory_report.printed_inside",
                language,
                event=event,
                pieces=pieces_counted(total.filled),
                share=share_told(total.share_out, language),
                best=share_told(total.share_out_best, language),
            )
        )
    return lines
