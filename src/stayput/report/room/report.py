"""A verdict on a room as sections: for the terminal, as Markdown, and as a self-contained HTML page."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

from markupsafe import Markup

import stayput
from stayput.catalogue import TEXTS, phrase, say
from stayput.montecarlo.counting import DEVICE_FAILED, OVERTURNED, SLID
from stayput.report.page import rendered
from stayput.report.room.plan import change_plan, legend, room_plan
from stayput.report.verdict import numbers, tables
from stayput.report.verdict.html import MOST_RANKED, shared_content
from stayput.simulation.space_fate import FALLS_FROM, MAY_FALL_FROM
from stayput.verification import room_words
from stayput.verification.events import PASSAGE
from stayput.verification.people import CRUSHING_ENERGY, DAY_HOURS, People, presence
from stayput.wording import with_aside

if TYPE_CHECKING:
    from stayput.fragility.probabilities import Probability
    from stayput.verification.verdict import OptionVerdict, Verdict


class TableCell(NamedTuple):
    """What stands in a cell of a table.

    Parameters
    ----------
    value : str or Probability
        Its value; a probability is told with its interval.
    aside : str
        What stands small beside it.
    tag : str
        The look of that as a tag, by a class of the style sheet; none by default.
    """

    value: str | Probability
    aside: str = ""
    tag: str = ""

    def text(self, language: str) -> str:
        """Return the cell as a text."""
        value = self.value if isinstance(self.value, str) else say(self.value.texts, language)
        return with_aside(value, self.aside, language) if value and self.aside else value or self.aside


Row = tuple["TableCell | str", ...]


class Section(NamedTuple):
    """A table under a heading, and what is said above it.

    Parameters
    ----------
    key : str
        Which it is.
    title, about : str
        Its heading, and what stands above the table.
    columns : tuple of str
        The headings of the columns.
    rows : tuple of tuple of TableCell
        The cells, row by row.
    """

    key: str
    title: str
    about: str
    columns: tuple[str, ...]
    rows: tuple[tuple[TableCell, ...], ...]


def sentences(verdict: Verdict, language: str) -> tuple[str, ...]:
    """Return what is said above the tables."""
    best = room_words.best_sentence(verdict, language)
    return (verdict.sentence(language), *([best] if best else []))


def sections(verdict: Verdict, options: Sequence[OptionVerdict], language: str) -> list[Section]:
    """Return who is hit by what, which ways out are blocked, what pieces do, and what options bring.

    Pieces and what hits come with the most harmful first, options in their order. Differences are from the
    room as it is; only a piece has a chance of overturning.

    Parameters
    ----------
    verdict : Verdict
        A verdict on a room.
    options : sequence of OptionVerdict
        The single changes to tell.
    language : str
        "en" or "ja".
    """
    tell = partial(say, language=language)
    limit = numbers.length(verdict.slide_limit, language)
    people, room = room_words.people_in(verdict), verdict.scenario.surroundings()
    ways_out, somebody = any(door.door.way_out for door in people.doors), bool(people.places)

    def own(key: str, **values: object) -> str:
        return say(f"room_report.{key}", language, **values)

    def heading(key: str) -> str:
        return own(key) if f"room_report.{key}" in TEXTS else numbers.word(key, language, limit=limit)

    def section(
        key: str, columns: Sequence[str], rows: Iterable[Row], none: str = "", **values: object
    ) -> Section:
        cells = tuple(
            tuple(cell if isinstance(cell, TableCell) else TableCell(cell) for cell in row) for row in rows
        )
        about = own(f"{key}_text", **values) if cells else own(none)
        return Section(key, own(key), about, tuple(map(heading, columns)), cells)

    def both(low: str, most: str) -> TableCell:
        return TableCell(low, numbers.word("most", language, value=most))

    def here(chance: Probability, time: float) -> TableCell:
        there = own("presence", share=numbers.share(time, language))
        return TableCell(chance if time else numbers.share(0.0, language), there)

    def known(chance: Probability, at_rest: bool) -> TableCell:
        return TableCell("", own("at_rest"), "low") if at_rest else TableCell(chance)

    places, hits, shut_in = list[Row](), list[Row](), list[Row]()
    for p in people.places:
        name = tell(room_words.place_name(p.place))
        times = here(p.by_day, p.place.day), here(p.by_night, p.place.night)
        places.append((name, *map(TableCell, (p.hit, p.crushed, p.touched)), *times))
        shut_in.append((name, known(p.shut_in, p.shut_in_at_rest)))
        for hit in p.by:
            how = "rooms.by_falling" if hit.by_falling else "rooms.by_touching"
            piece = TableCell(tell(room_words.piece_name(hit.piece)), tell(how))
            speed = both(numbers.speed(hit.speed.median), numbers.speed(hit.speed.p90))
            energy = both(numbers.energy(hit.energy.median), numbers.energy(hit.energy.p90))
            hits.append((name, piece, TableCell(hit.probability), speed, energy, numbers.mass(hit.mass)))
    doors = list[Row]()
    for door in people.doors:
        names = tell(room_words.door_name(door.door)), tell(f"rooms.{door.door.wall}")
        leads_out = own("yes" if door.door.way_out else "no")
        doors.append((*names, own(door.door.opens), leads_out, known(door.blocked, door.at_rest)))
    pieces = list[Row]()
    for each in room_words.pieces_in(verdict):
        shares = TableCell(each.probabilities[OVERTURNED]), TableCell(each.probabilities[SLID])
        slide = both(*numbers.slides(each.slide, room, language))
        harm = [numbers.energy(each.harm)] * somebody
        pieces.append((tell(room_words.piece_name(each.name)), *shares, slide, *harm))
    values = {"day": DAY_HOURS, "night": 24.0 - DAY_HOURS, "energy": CRUSHING_ENERGY}
    covers = own("covers") if verdict.motions > 1 else ""
    of_hits = "place", "piece", "how_often", "hit_speed", "hit_energy", "mass"
    of_doors = "door", "wall", "opens", "leads_out", "blocked"
    of_pieces = "piece", "overturned", "slid", "slide", *["piece_harm"] * somebody
    effects = ("changed_hit", "changed_shut_in", "changed_overturned", "risk")
    of_changes = "change", "rank", *(effects if somebody else effects[2:3]), "device_failed"
    changes = (_change(option, verdict, language) for option in options)

    def of_people() -> Iterator[Section]:
        of_places = "place", "hit", "crushed", "touched", "by_day", "by_night"
        yield section("places", of_places, places, "", covers=covers, **values)
        yield section("what_hits", of_hits, hits, "no_hit")

    return [
        *(of_people() if somebody else ()),
        section("ways", of_doors, doors, "no_doors", passage=PASSAGE),
        *[section("shut_in", ("place", "shut_in"), shut_in * ways_out, "no_way_out")]
        * (somebody and bool(doors)),
        section("pieces", of_pieces, pieces, harm=own("harm_text") if somebody else ""),
        section("changes", of_changes, changes, "no_changes"),
    ]


def _change(option: OptionVerdict, verdict: Verdict, language: str) -> Row:
    """Return the row of a single change."""
    people, overturned = option.people, room_words.piece_changed(option, verdict)
    assert people is not None
    look = "high" if option.helps else "low" if option.worse else "model"
    clear = say("common.listed", language).join(say(tag, language) for tag in room_words.tags(option))
    change = partial(numbers.change, language=language)
    label = TableCell(verdict.label(option, language), clear, look)
    falls = "" if overturned is None else TableCell(overturned[0], change(overturned[1]))
    rank, failed = str(option.rank), option.probabilities[DEVICE_FAILED]
    fails = TableCell(failed if failed.estimate else "")
    if not people.places:
        return label, rank, falls, fails
    hit, shut_in = (TableCell(each.chance, change(each.change)) for each in (people.hit, people.shut_in))
    return label, rank, hit, shut_in, falls, TableCell(_risk(people)), fails


def simulations_of_room(verdict: Verdict, language: str) -> str:
    """Return how many runs the verdict rests on."""
    motions = room_words.motion_phrase(verdict) or phrase("rooms.motions", count=verdict.motions)
    runs = f"{verdict.runs:,}"
    return say("rooms.simulations", language, runs=runs, motions=motions, each=verdict.runs_each)


def room_markdown(verdict: Verdict, language: str = "en") -> str:
    """Return a verdict on a room as a text in Markdown, in "en" or "ja"."""
    first, *others = sentences(verdict, language)
    title = verdict.scenario.title or say("rooms.report", language)
    lines = [f"# {tables.plain(title)}", f"\n**{tables.plain(first)}**"]
    lines += [f"\n{tables.plain(sentence)}" for sentence in others]
    for each in sections(verdict, verdict.others, language):
        lines += [f"\n## {each.title}", f"\n{each.about}"]
        if each.rows:
            rows = (tuple(cell.text(language) for cell in row) for row in each.rows)
            lines += ["", *tables.table(each.columns, rows)]
    lines += [f"\n{tables.plain(note)}" for note in verdict.notes(language)]
    lines += tables.rests_on(verdict, language)
    lines += [f"\n{simulations_of_room(verdict, language)}", f"\nstayput {stayput.__version__}"]
    return "\n".join(lines) + "\n"


SHEETS = ("verdict/report.css", "canvas/plan.css", "room/plan.css", "room/room.css")
"""Style sheets of the report: those of a verdict, of plans, of their figures, and its own."""


def room_html(verdict: Verdict, language: str = "en") -> str:
    """Return the report of a verdict on a room: one HTML page that loads nothing from elsewhere.

    Parameters
    ----------
    verdict : Verdict
        The verdict.
    language : str
        "en" or "ja".
    """
    headline, *others = sentences(verdict, language)
    people = room_words.people_in(verdict)
    moved = change_plan(verdict, language)
    kind = say("rooms.report", language)
    shown = sections(verdict, verdict.others, language)
    changes = next(each for each in shown if each.key == "changes")
    everything = verdict.without.probabilities[OVERTURNED]
    content = {
        **shared_content(verdict, "room_report", kind, SHEETS, language),
        "people": people,
        "headline": headline,
        "risk": _risk(people),
        "others": others,
        "simulations": simulations_of_room(verdict, language),
        "notes": verdict.notes(language),
        "plan": Markup(room_plan(verdict, language)),
        "legend": [(Markup(swatch), name) for swatch, name in legend(language)],
        "falls_from": 100.0 * FALLS_FROM,
        "may_fall_from": 100.0 * MAY_FALL_FROM,
        "ways_out": any(door.door.way_out for door in people.doors),
        "sections": shown,
        "changes": changes,
        "ranked": changes.rows[: MOST_RANKED - 1],  # beside the room as it is
        "now": people.hit.chance if people.places else everything,
        "moved": None if moved is None else (Markup(moved[0]), moved[1]),
    }
    return rendered("room/room.html", content)


def _risk(people: People) -> Probability:
    """Return the chance that somebody is hit, counting how long people are at their places.

    Where nobody was hit in any run, its end is that of the place where somebody is longest.
    """
    hit, there = people.hit.chance, (presence(place.place) for place in people.places)
    return hit.scaled(people.risk / hit.estimate if hit.estimate else max(there, default=1.0))
