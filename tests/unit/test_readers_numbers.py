"""Columns of numbers: how they are written, how many there are, and what stands above them."""

from __future__ import annotations

import re

import pytest

import stayput as sp
from record_files import UP_LAST, peaks, table


@pytest.mark.parametrize(
    "text", ["0\n1.5\n-2\n", " 0.\r\n+1.5e0\r\n-.2E+1\r\n", "# gal\n\n0\n1.5\n-2", "\ufeff0\n1.5\n-2\n\x1a"]
)
def test_one_column_in_any_writing(read, text):
    motion, _ = read(text, name="record.txt", unit="gal", dt=0.01)
    assert motion == sp.Motion(
        0.01, [0.0, 0.015, -0.02], name="record", source="columns of numbers: x = unnamed"
    )


@pytest.mark.parametrize("mark", [" ", "\t", ",", ", ", ";", "; "])
def test_two_columns_are_time_and_x(read, mark):
    motion, _ = read("".join(f"{0.02 * i:.2f}{mark}{i}\n" for i in range(5)), unit="m/s²")
    assert motion.dt == pytest.approx(0.02)
    assert motion.x.tolist() == [0.0, 1.0, 2.0, 3.0, 4.0]


def test_time_may_begin_anywhere_and_be_rounded(read):
    motion, _ = read("".join(f"{12.0 + i / 128:.3f} {i}\n" for i in range(129)), unit="gal")
    assert motion.dt == pytest.approx(1 / 128, rel=1e-5)
    rows = "".join(f"{1e-5 * round(1999.9999 * (i + 1)):.5f} {i}\n" for i in range(500))
    assert read(rows, unit="gal", dt=0.02)[0].dt == pytest.approx(0.02, rel=1e-6)


def test_quoted_cells_and_codings_of_spreadsheets(read, refusal):
    quoted = table("t,x,y,z").replace(",", '","').replace("\n", '"\n"').removesuffix('"')
    assert peaks(read(f'"{quoted}', unit="gal")[0]) == UP_LAST
    two = table("", 2).replace(",", '","').replace("\n", '"\n"').removesuffix('"')
    assert refusal(f'"{two}'.replace(".", ","), unit="gal").code == "motion.not_a_decimal"
    for coding in ("utf-16", "utf-8-sig", "cp932"):
        head = "時間 (秒)\t南北 (gal)\tEW (gal)\tUD (gal)"
        assert peaks(read(table(head).replace("\n", "\r\n").encode(coding))[0]) == UP_LAST


@pytest.mark.parametrize(
    ("text", "given", "message"),
    [
        ("0\n", {"dt": 0.01}, "at least 2"),
        ("0 1 2\n0.01 2 3\n", {}, "3 columns"),
        ("0 1\n0.01 2 3\n0.02 3\n", {}, "Row 2 has 3 values"),
        ("0,1,2,3\n0.01,4,,6\n", {}, "''"),
        ("0 1\n0.01 nan\n0.02 3\n", {}, "'nan'"),
        ("0 1\n0.01 inf\n0.02 3\n", {}, "'inf'"),
        ("0 1\n0.01 1_0\n0.02 3\n", {}, "'1_0'"),
        ("0 1\n0.01 ٣\n0.02 3\n", {}, "'٣'"),
        ("0 1\n0.01 1.0D+01\n0.02 3\n", {}, "'1.0D"),
        ("0 1\n0.01 1e999\n0.02 3\n", {}, "'1e999'"),
        ("0;1\n0,01;2\n0,02;3\n", {}, "'0,01'"),
        ("0 1\n0.01 2\n0.03 3\n0.04 4\n", {}, "irregular"),
        ("0 1\n0.01 2\n0.01 3\n0.02 4\n", {}, "irregular"),
        ("0.02 1\n0.01 2\n0.00 3\n", {}, "irregular"),
        ("0 1\n5 2\n10 3\n", {}, "time step"),
        ("20\n" + "0.1\n" * 20, {"dt": 0.01}, "looks like a count.* skip_lines passes"),
        ("20\n" + "0 0.1\n" * 20, {}, "skip_lines passes"),
        ("0\n1e30\n", {"dt": 0.01}, r"sample 1 is 1e\+28 m/s²"),
        ("0 1\n0.02 2\n0.04 3\n", {"dt": 0.01}, r"file states, 0\.02 s"),
        ("0 1 2 3\n0.01 4 5 6\n", {"component": "NS"}, "component is 'NS'; it must be one of"),
        ("0 1\n0.01 2\n", {"location": "00"}, "location is given for a file of columns of numbers"),
    ],
)
def test_numbers_that_are_refused(refusal, text, given, message):
    assert re.search(message, str(refusal(text, unit="gal", **given)))


@pytest.mark.parametrize("place", [1, 50, 98])
def test_a_missing_row_is_noticed_wherever_it_is(refusal, place):
    rows = [f"{0.01 * i:.2f} {i}\n" for i in range(100) if i != place]
    assert refusal("".join(rows), unit="gal").code == "motion.irregular_sampling"


@pytest.mark.parametrize("line", ["{} 0.02", "  {}, 0.02", "0.02 {}", "A quake\n{}\t.02E0", "# x\n{} 0.02"])
@pytest.mark.parametrize("each", [1, 3, 8])
def test_the_number_of_samples_and_the_step_may_stand_above_rows_of_any_length(read, refusal, line, each):
    wave = table("", 1).split()
    rows = "".join(" ".join(wave[i : i + each]) + "\n" for i in range(0, len(wave), each))
    motion, _ = read(f"{line.format(60)}\n{rows}", unit="gal")
    assert (len(motion), motion.dt, peaks(motion)) == (60, 0.02, {"x": 0.1})
    assert refusal(f"{line.format(61)}\n{rows}", unit="gal").code == "motion.not_as_stated"
    assert refusal(f"{line.format(60)}\n{rows}", unit="gal", dt=0.01).code == "motion.not_the_files_own"


def test_a_line_may_be_passed_over(read):
    for head, columns, dt in (("60", 1, 0.02), ("60", 2, None), ("# factor = 2", 2, None)):
        assert len(read(table(head, columns), unit="gal", dt=dt, skip_lines=1)[0]) == 60


@pytest.mark.parametrize("above", ["1;2;3\n\nstarted 12:00;;\n", "3 lines\n2 lines\n1 line\n"])
def test_lines_at_the_beginning_are_passed_over(read, refusal, above):
    text = f"{above}time;acc [g]\n0.00;0.1\n0.01;0.2\n"
    assert read(text, skip_lines=3)[0].x == pytest.approx([0.980665, 1.96133])
    assert refusal(text)
    assert read(text.replace(above.split("\n")[0], "synthetic"), skip_lines=3)[0].synthetic
    for count in (6, 7, 100):
        assert f"skip_lines is {count}; it must be smaller than" in str(refusal(text, skip_lines=count))


@pytest.mark.parametrize("mark", [";", "\t", " "])
def test_numbers_may_have_a_decimal_comma(read, refusal, mark):
    rows = "".join(f"0,0{i}{mark}{i},5\n" for i in range(4))
    motion, _ = read(rows, unit="m/s²", decimal_comma=True)
    assert (motion.dt, motion.x.tolist()) == (0.01, [0.5, 1.5, 2.5, 3.5])
    if mark == ";":
        assert "'0,00'" in str(error := refusal(rows, unit="m/s²"))
        assert error.code == "motion.decimal_comma"
