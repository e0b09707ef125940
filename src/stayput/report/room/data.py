"""A verdict on a room as plain values: JSON and CSV."""

from __future__ import annotations

import csv
import io
import json
from typing import TYPE_CHECKING, Any

import stayput
from stayput.catalogue import LANGUAGES
from stayput.motion.intensity import intensity_class
from stayput.report.several.data import in_both
from stayput.report.summary import number
from stayput.report.verdict.data import quantiles_data, strength_data
from stayput.rooms.events import CELL
from stayput.rooms.words import best_sentence, change_label, change_sentence, sentence_of_room, tags
from stayput.spreadsheets import text_cell

if TYPE_CHECKING:
    from collections.abc import Iterator

    from stayput.fragility import Difference, Probability
    from stayput.rooms.verdict import ChangeVerdict, RoomVerdict


def room_json(verdict: RoomVerdict) -> str:
    """Return a verdict as the text of a JSON file; see `room_data`."""
    return json.dumps(room_data(verdict), allow_nan=False, ensure_ascii=False, indent=2) + "\n"


def room_data(verdict: RoomVerdict) -> dict[str, Any]:
    """Return a verdict as plain values, in SI units that the keys name; what is not finite is None."""
    return {
        "stayput": stayput.__version__,
        "title": verdict.scenario.title,
        "verdict": in_both(lambda language: sentence_of_room(verdict, language)),
        "best": in_both(lambda language: best_sentence(verdict, language)),
        "jma_intensity": number(verdict.intensity),
        "intensity_class": None if verdict.floor else intensity_class(verdict.intensity),
        "motion_floor": verdict.floor or None,
        "strength": strength_data(verdict.scenario, verdict.motions),
        "motions": verdict.motions,
        "samples": verdict.samples,
        "runs": verdict.runs,
        "seed": verdict.seed,
        "seconds": number(verdict.seconds),
        "hit": chance_data(verdict.hit),
        "shut_in": chance_data(verdict.shut_in),
        "risk": number(verdict.risk),
        "places": [
            {
                "name": place.place.name,
                "hit": chance_data(place.hit),
                "hit_by_day": number(place.by_day),
                "hit_at_night": number(place.by_night),
                "shut_in": chance_data(place.shut_in),
                "by": [
                    {
                        "piece": one.piece,
                        "mass_kg": number(one.mass),
                        "probability": chance_data(one.probability),
                        "speed_m_s": quantiles_data(one.speed),
                        "energy_J": quantiles_data(one.energy),
                    }
                    for one in place.by
                ],
            }
            for place in verdict.places
        ],
        "doors": [
            {"name": door.door.name, "blocked": chance_data(door.blocked), "blocked_at_rest": door.at_rest}
            for door in verdict.doors
        ],
        "pieces": [
            {
                "name": piece.name,
                "engine": "plane" if piece.in_plane else "space",
                "probabilities": {event: chance_data(one) for event, one in piece.probabilities.items()},
                "peak_slide_m": quantiles_data(piece.slide),
                "falls": piece.falls,
                "risk": number(piece.risk),
                "outline_m": piece.outline.tolist(),
            }
            for piece in verdict.pieces
        ],
        "cell_m": CELL,
        "collisions": [
            {"pieces": list(pair), "probability": chance_data(one)}
            for pair, one in verdict.collisions.items()
        ],
        "changes": [_change(one, verdict) for one in verdict.changes],
    }


def _change(result: ChangeVerdict, verdict: RoomVerdict) -> dict[str, Any]:
    change, own = result.change, verdict.piece_changed(result)
    return {
        "what": change.what,
        "label": in_both(lambda language: change_label(change, verdict, language)),
        "sentence": in_both(lambda language: change_sentence(result, verdict, language)),
        "measure": None if change.measure is None else change.measure.kind,
        "drilled": change.measure is not None and change.measure.drilled,
        "at_m": None if change.at is None else list(change.at),
        "heading_rad": change.heading,
        "hit": chance_data(result.hit),
        "hit_change": chance_data(result.hit_change),
        "shut_in": chance_data(result.shut_in),
        "shut_in_change": chance_data(result.shut_in_change),
        "overturned": None if own is None else chance_data(own[0]),
        "overturned_change": None if own is None else chance_data(own[1]),
        "risk": number(result.risk),
        "helps": result.helps,
        "better": list(result.better),
        "worse": list(result.worse),
        "tags": [dict(zip(LANGUAGES, tag, strict=True)) for tag in tags(result)],
    }


def chance_data(chance: Probability | Difference) -> dict[str, float | None]:
    """Return a probability or a difference of two, with its interval."""
    return {"estimate": number(chance.estimate), "low": number(chance.low), "high": number(chance.high)}


def room_csv(verdict: RoomVerdict) -> str:
    """Return the probabilities of a verdict as CSV: what happens to what, by what.

    Of a change, also what it brings: the probability with it less that of the room as it is.
    """
    lines = io.StringIO()
    writer = csv.writer(lines, lineterminator="\r\n")
    changed = ("change", "change_low", "change_high")
    writer.writerow(("event", "of", "by", "probability", "low", "high", *changed))
    for event, of, by, chance, change in _rows(verdict):
        ends = (*_cells(chance), *(("",) * len(changed) if change is None else _cells(change)))
        writer.writerow((event, text_cell(of), text_cell(by), *ends))
    return lines.getvalue()


def _cells(chance: Probability | Difference) -> Iterator[float | str]:
    for value in (chance.estimate, chance.low, chance.high):
        finite = number(value)
        yield "" if finite is None else finite


def _rows(verdict: RoomVerdict) -> Iterator[tuple[str, str, str, Probability, Difference | None]]:
    for place in verdict.places:
        yield "hit", place.place.name, "", place.hit, None
        for one in place.by:
            yield "hit", place.place.name, one.piece, one.probability, None
        yield "shut_in", place.place.name, "", place.shut_in, None
    for door in verdict.doors:
        yield "blocked", door.door.name, "", door.blocked, None
    for piece in verdict.pieces:
        for event, chance in piece.probabilities.items():
            yield event, piece.name, "", chance, None
    for (first, second), chance in verdict.collisions.items():
        yield "meet", first, second, chance, None
    for one in verdict.changes:
        label = change_label(one.change, verdict, "en")
        yield "hit_with", label, "", one.hit, one.hit_change
        yield "shut_in_with", label, "", one.shut_in, one.shut_in_change
        if (own := verdict.piece_changed(one)) is not None:
            yield "overturned_with", label, "", *own
