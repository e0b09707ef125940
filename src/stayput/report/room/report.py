"""A verdict on a room as tables of texts, for terminal and Markdown, and as a self-contained HTML page."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from markupsafe import Markup

import stayput
from stayput.catalogue import phrase, say
from stayput.montecarlo.counting import OVERTURNED, SLID
from stayput.report.page import rendered, write_page
from stayput.report.room.plan import change_plan, legend, room_plan
from stayput.report.verdict import numbers
from stayput.report.verdict.assumptions import assumptions
from stayput.report.verdict.html import shared_content
from stayput.report.verdict.markdown import plain, table
from stayput.simulation.space_fate import FALLS_FROM, MAY_FALL_FROM
from stayput.verification import room_words
from stayput.verification.events import PASSAGE
from stayput.verification.people import DAY_HOURS, HitVerdict
from stayput.wording import with_aside

if TYPE_CHECKING:
    from stayput.fragility.probabilities import Probability
    from stayput.verification.verdict import OptionVerdict, Verdict


class TextTable(NamedTuple):
    """A table of texts, with what is said below it; without rows it is left out."""

    headings: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    below: str = ""


def sentences(verdict: Verdict, language: str) -> tuple[str, ...]:
    """Return what is said above the tables."""
    best = room_words.best_sentence(verdict, language)
    return (verdict.sentence(language), *([best] if best else []))


def hit_by(hit: HitVerdict) -> str:
    """Return the key of how a piece hits somebody: it falls on them, or slides against them."""
    return "by_falling" if hit.by_falling else "by_sliding"


def tables(verdict: Verdict, options: Sequence[OptionVerdict], language: str) -> tuple[TextTable, ...]:
    """Return who is hit by what, which ways out are blocked, and what some of the options bring."""
    people = room_words.people_in(verdict)

    def texts(*keys: str) -> tuple[str, ...]:
        return tuple(say(f"rooms.{key}", language) for key in keys)

    def chance(value: Probability) -> str:
        return say(value.texts, language)

    def warned(option: OptionVerdict) -> str:
        label, clear = (
            verdict.label(option, language),
            [say(tag, language) for tag in room_words.tags(option)],
        )
        return (
            with_aside(label, say("common.listed", language).join(clear), language) if option.worse else label
        )

    hits: list[tuple[str, ...]] = []
    for place in people.places:
        shares = (numbers.probability(share, language) for share in (place.by_day, place.by_night))
        name = say(room_words.place_name(place.place), language)
        hits.append((name, *texts("any_piece"), chance(place.hit), *shares, "", "", ""))
        for hit in place.by:
            strength = numbers.speed(hit.speed.median), numbers.energy(hit.energy.median)
            way = say(f"rooms.{hit_by(hit)}", language)
            name = with_aside(say(room_words.piece_name(hit.piece), language), way, language)
            hits.append(("", name, chance(hit.probability), "", "", *strength, numbers.mass(hit.mass)))
    already = say("rooms.already", language)
    ways = [
        (
            phrase("rooms.door_blocked", door=room_words.door_name(door.door)),
            already if door.at_rest else chance(door.blocked),
        )
        for door in people.doors
    ]
    shut_in = people.places if any(door.door.way_out for door in people.doors) else ()
    ways += [
        (
            phrase("rooms.place_shut_in", place=room_words.place_name(p.place)),
            already if p.shut_in_at_rest else chance(p.shut_in),
        )
        for p in shut_in
    ]
    changes = [
        (
            warned(option),
            chance(option.people.hit.chance),
            numbers.change(option.people.hit.change, language),
            chance(option.people.shut_in.chance),
            ""
            if (overturned := room_words.piece_changed(option, verdict)) is None
            else chance(overturned[0]),
        )
        for option in options
        if option.people is not None
    ]
    return (
        TextTable(
            texts("who", "by", "chance", "day", "night", "speed", "energy", "mass"),
            tuple(hits),
            *texts("upper_bounds"),
        ),
        TextTable(texts("way", "chance"), tuple((say(label, language), blocked) for label, blocked in ways)),
        TextTable(texts("change", "hit_then", "hit_less", "shut_in_then", "overturned_then"), tuple(changes)),
    )


def simulations_of_room(verdict: Verdict, language: str) -> str:
    """Return how many runs the verdict rests on."""
    motions = room_words.motion_phrase(verdict) or phrase("rooms.motions", count=verdict.motions)
    runs = f"{verdict.runs:,}"
    return say("rooms.simulations", language, runs=runs, motions=motions, samples=verdict.samples)


def room_markdown(verdict: Verdict, language: str = "en") -> str:
    """Return a verdict on a room as a text in Markdown, in "en" or "ja"."""
    first, *others = sentences(verdict, language)
    lines = [f"# {plain(verdict.scenario.title or say('rooms.report', language))}", f"\n**{plain(first)}**"]
    lines += [f"\n{plain(sentence)}" for sentence in others]
    for each in tables(verdict, verdict.others, language):
        if each.rows:
            lines += ["", *table(each.headings, each.rows), *([f"\n{each.below}"] if each.below else [])]
    lines += [f"\n{simulations_of_room(verdict, language)}", f"\nstayput {stayput.__version__}"]
    return "\n".join(lines) + "\n"


SHEETS = ("verdict/report.css", "canvas/plan.css", "room/plan.css", "room/room.css")
"""Style sheets of the report: those of a verdict, of plans, of their figures, and its own."""


def write_room_report(verdict: Verdict, path: str | Path, language: str = "en") -> Path:
    """Write the report of a verdict on a room: one HTML file that loads nothing from elsewhere.

    Parameters
    ----------
    verdict : Verdict
        The verdict.
    path : str or Path
        The file, whose name ends in .html.
    language : str
        "en" or "ja".

    Returns
    -------
    Path
        The file written.

    Raises
    ------
    InputError
        Another language, or a path that cannot be written.
    """
    return write_page(path, language, lambda: room_html(verdict, language))


def room_html(verdict: Verdict, language: str = "en") -> str:
    """Return the text of a report; see `write_room_report`."""
    headline, *others = sentences(verdict, language)
    people = room_words.people_in(verdict)
    moved = change_plan(verdict, language)
    kind = say("rooms.report", language)
    content = {
        **shared_content(verdict, "room_report", kind, SHEETS, assumptions(verdict), language),
        "people": people,
        "headline": headline,
        "risk": _risk(people.risk, people.hit.chance, language),
        "others": others,
        "simulations": simulations_of_room(verdict, language),
        "plan": Markup(room_plan(verdict, language)),
        "legend": [(Markup(swatch), name) for swatch, name in legend(language)],
        "hours": {"day": DAY_HOURS, "night": 24.0 - DAY_HOURS},
        "passage": PASSAGE,
        "falls_from": 100.0 * FALLS_FROM,
        "may_fall_from": 100.0 * MAY_FALL_FROM,
        "ways_out": any(door.door.way_out for door in people.doors),
        "places": [
            {
                "name": say(room_words.place_name(place.place), language),
                "hit": place.hit,
                "times": [
                    (
                        numbers.probability(chance, language),
                        say("room_report.presence", language, share=numbers.share(time, language)),
                    )
                    for chance, time in ((place.by_day, place.place.day), (place.by_night, place.place.night))
                ],
                "shut_in": place.shut_in,
            }
            for place in people.places
        ],
        "hits": hit_rows(verdict, language),
        "doors": [
            {
                "name": say(room_words.door_name(door.door), language),
                "wall": say(f"rooms.{door.door.wall}", language),
                "opens": say(f"room_report.{door.door.opens}", language),
                "leads_out": say(f"room_report.{'yes' if door.door.way_out else 'no'}", language),
                "blocked": door.blocked,
                "at_rest": door.at_rest,
            }
            for door in people.doors
        ],
        "pieces": piece_rows(verdict, language),
        "changes": change_rows(verdict, language),
        "moved": None if moved is None else (Markup(moved[0]), moved[1]),
    }
    return rendered("room/room.html", content)


def _risk(risk: float, hit: Probability, language: str) -> str:
    """Return a chance of being hit that counts how long somebody is there, as finely as that of a hit."""
    return numbers.probability(hit.scaled(risk / hit.estimate if hit.estimate else 1.0), language)


def hit_rows(verdict: Verdict, language: str) -> list[dict[str, Any]]:
    """Return what hits each place, the most harmful first: median and 90 % quantile of speed and energy."""
    return [
        {
            "place": say(room_words.place_name(place.place), language),
            "piece": say(room_words.piece_name(hit.piece), language),
            "way": say(f"rooms.{hit_by(hit)}", language),
            "chance": hit.probability,
            "speed": (numbers.speed(hit.speed.median), numbers.speed(hit.speed.p90)),
            "energy": (numbers.energy(hit.energy.median), numbers.energy(hit.energy.p90)),
            "mass": numbers.mass(hit.mass),
        }
        for place in room_words.people_in(verdict).places
        for hit in place.by
    ]


def piece_rows(verdict: Verdict, language: str) -> list[dict[str, Any]]:
    """Return the pieces, the most harmful first, with median and 90 % quantile of their slides."""
    room = verdict.scenario.surroundings()
    return [
        {
            "name": say(room_words.piece_name(piece.name), language),
            "overturned": piece.probabilities[OVERTURNED],
            "slid": piece.probabilities[SLID],
            "slide": numbers.slides(piece.slide, room, language),
            "harm": numbers.energy(piece.harm) if room_words.people_in(verdict).places else numbers.NO_NUMBER,
        }
        for piece in room_words.pieces_in(verdict)
    ]


def change_rows(verdict: Verdict, language: str) -> list[dict[str, Any]]:
    """Return the single changes, the best first.

    Their differences are from the room as it is; only a piece has a chance of overturning.
    """
    change = partial(numbers.change, language=language)
    rows: list[dict[str, Any]] = []
    for result in verdict.others:
        people, overturned = result.people, room_words.piece_changed(result, verdict)
        assert people is not None
        rows.append(
            {
                "label": verdict.label(result, language),
                "kind": "better" if result.helps else "worse" if result.worse else "chance",
                "tags": [say(tag, language) for tag in room_words.tags(result)],
                "hit": people.hit.chance,
                "hit_change": change(people.hit.change),
                "shut_in": people.shut_in.chance,
                "shut_in_change": change(people.shut_in.change),
                "overturned": None if overturned is None else overturned[0],
                "overturned_change": "" if overturned is None else change(overturned[1]),
                "risk": _risk(people.risk, people.hit.chance, language),
            }
        )
    return rows
