"""The plan in the report of a room: to scale, with its names, marks and changes."""

import math
import re
from dataclasses import replace

import numpy as np
import pytest
from test_room_report import HOSTILE, made

from stayput.report.room.plan import DrawnPiece, change_plan, covers_svg, plan_svg
from stayput.report.room.sheet import PlanSheet
from stayput.verification.changes import Change, with_changes


def drawn(**options):
    verdict = made()
    pieces = [
        DrawnPiece(one.name, one.zones.outline, 0.0, one.stability, one.zones.fell, one.zones.stood)
        for one in verdict.without.pieces
    ]
    plan = verdict.scenario.scene().plan
    return plan, plan_svg(plan, pieces, ["bed", "cot"], "en", **options).svg


def polygons(picture, class_):
    found = re.findall(rf'<polygon points="([^"]*)" class="{class_}"', picture)
    return [np.array([[float(x) for x in point.split(",")] for point in each.split()]) for each in found]


def test_the_plan_is_to_scale_with_y_upwards():
    plan, picture = drawn()
    sheet = PlanSheet(plan)
    x0, y0, x1, y1 = sheet.floor
    assert (x1 - x0) / (y1 - y0) == pytest.approx(plan.width / plan.length)
    assert sheet.place(0.0, 0.0) == (x0, y1)
    assert sheet.place(plan.width, plan.length) == (x1, y0)
    (bed, _) = polygons(picture, "place")
    wanted = [sheet.place(x, y) for x, y in plan.places[0].corners.tolist()]
    assert bed == pytest.approx(np.array(wanted), abs=0.05)
    assert np.ptp(bed[:, 0]) == pytest.approx(2.0 * sheet.scale, abs=0.11)  # a bed of 2 m, turned along x
    standing = polygons(picture, "standing falls")
    assert standing[0][:, 1].mean() == pytest.approx(sheet.place(0.0, 1.0)[1], abs=0.1)


def test_the_pillow_is_at_the_head_of_the_bed():
    """Heading 90° turns −y, where the head is, to +x."""
    plan, picture = drawn()
    pillow = polygons(picture, "soft")[0].mean(axis=0)
    assert pillow[0] > PlanSheet(plan).place(*plan.places[0].at)[0] + 40.0


def test_cells_are_drawn_where_they_are_and_in_the_step_of_their_share():
    plan = made().scenario.scene().plan
    sheet = PlanSheet(plan)
    covers = np.zeros((80, 60))
    covers[10:14, 20] = 0.35
    covers[10, 50] = 1.0
    covers[79, 59] = 0.001
    found = {
        int(step): [float(value) for value in re.findall(r"[\d.]+", path)]
        for path, step in re.findall(
            r'd="([^"]*)" class="cover fell step(\d+)"', covers_svg(sheet, covers, "fell")
        )
    }
    assert sorted(found) == [1, 4, 10]
    x0, y0, x1, y1, _ = found[4]
    assert (x0, y1) == pytest.approx(sheet.place(0.5, 1.0), abs=0.06)
    assert (x1, y0) == pytest.approx(sheet.place(0.7, 1.05), abs=0.06)


def test_the_front_is_marked_and_a_round_piece_has_none():
    plan, picture = drawn()
    fronts = re.findall(r'<polyline points="([^"]*)" class="front"', picture)
    sheet = PlanSheet(plan)
    outline = made().without.pieces[0].zones.outline
    xs = [float(point.split(",")[0]) for point in fronts[0].split()]
    assert xs == pytest.approx([sheet.place(outline[:, 0].max(), 0.0)[0] - 2.0] * 2, abs=0.1)
    angle = np.linspace(0.0, 2.0 * math.pi, 32, endpoint=False)
    round_one = np.column_stack([2.0 + np.cos(angle), 1.0 + np.sin(angle)])
    picture = plan_svg(
        made().scenario.scene().plan, [DrawnPiece("vase", round_one, 0.0)], ["bed", "cot"], "en"
    ).svg
    assert 'class="front"' not in picture


def test_doors_swing_to_their_side():
    plan, picture = drawn()
    sheet = PlanSheet(plan)
    x0, y0, x1, _ = sheet.floor
    swings = [
        np.array([[float(x) for x in point.split(",")] for point in arc.split()])
        for arc in re.findall(r'<polyline points="([^"]*)" class="swing"', picture)
    ]
    inwards, outwards = swings  # the third door slides
    assert inwards[:, 0].min() == pytest.approx(x1 - 0.8 * sheet.scale, abs=0.1)
    assert inwards[:, 0].max() == pytest.approx(x1, abs=0.1)
    assert outwards[:, 1].min() == pytest.approx(y0 - 0.8 * sheet.scale, abs=0.1)
    assert outwards[:, 1].min() > 0.0  # within the picture
    assert outwards[:, 0].min() > x0


def test_names_on_the_plan_are_escaped_and_told_to_a_screen_reader():
    plan, picture = drawn(notes={HOSTILE: "hit: <b>", "hall & co": "blocked"})
    assert "<script" not in picture
    assert "<b>" not in picture
    assert "<title>hall &amp; co (outwards): blocked</title>" in picture
    assert picture.count("<title>") >= 2 + 2 * 2 + 3 + 1
    assert f"{plan.width:g} m wide" in picture


def test_numbers_and_letters_stand_for_names_that_would_overlap():
    """Of ten pieces side by side in a large room the names overlap; the numbers of the steps do not."""
    plan = replace(made().scenario.scene().plan, width=12.0, length=9.0)
    corners = np.array([[0.0, 0.0], [0.3, 0.0], [0.3, 0.4], [0.0, 0.4]])
    pieces = [DrawnPiece(f"a long name {n}", corners + np.array([0.0, 0.5 * n]), 0.0) for n in range(10)]
    numbered = {piece.name: str(n) for n, piece in enumerate(pieces[:8], 1)}
    few, many = (
        plan_svg(where, own, ["bed", "cot"], "en", numbered=numbered, letters=letters)
        for where, own, letters in ((made().scenario.scene().plan, pieces[:1], 10.0), (plan, pieces, 17.0))
    )
    assert few.legend == ()
    assert ">1 a long name 0<" in few.svg
    told = dict(many.legend)
    assert [told["a"], told["b"]] == [place.name for place in plan.places]
    assert [told["c"], told["d"]] == ["a long name 8", "a long name 9"]
    marks = re.findall(r'class="name halo"[^>]*>([^<]*)<', many.svg)
    assert sorted(marks) == sorted([*numbered.values(), *told])
    plain = plan_svg(plan, pieces, ["bed", "cot"], "en")
    assert plain.legend == ()  # without numbers there is nothing to stand for a name


def test_the_best_change_that_moves_something_is_drawn():
    verdict = made()
    picture, label = change_plan(verdict, "en")
    sheet = PlanSheet(verdict.scenario.scene().plan)
    assert label == verdict.label(verdict.others[1])
    (was,) = polygons(picture, "was")
    assert was.mean(axis=0) == pytest.approx(sheet.place(2.0, 0.8), abs=0.1)
    assert polygons(picture, "place")[0].mean(axis=0) == pytest.approx(sheet.place(2.5, 1.6), abs=0.1)
    assert "cover" not in picture
    assert change_plan(replace(verdict, options=(verdict.others[0], verdict.without)), "en") is None


def test_a_piece_that_is_moved_is_turned_about_the_middle_of_its_base():
    verdict = made()
    change = Change(HOSTILE, at=(2.0, 2.8), heading=-math.pi / 2.0)
    option = with_changes(verdict.scenario.stated, [change], verdict.scenario.names)
    moved = replace(verdict, options=(replace(verdict.others[1], option=option), verdict.without))
    picture, _ = change_plan(moved, "en")
    looks = f"standing {moved.others[0].pieces[0].stability}"  # with the change
    sheet, standing = PlanSheet(verdict.scenario.scene().plan), polygons(picture, looks)[0]
    low, high = standing.min(axis=0), standing.max(axis=0)
    assert 0.5 * (low + high) == pytest.approx(sheet.place(2.0, 2.8), abs=0.1)
    assert high - low == pytest.approx(sheet.scale * np.array([0.8, 0.3]), abs=0.2)
