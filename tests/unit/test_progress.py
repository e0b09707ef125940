"""Progress bars: drawn on a terminal, all in one place, by the process that a person has started."""

import multiprocessing
import re
import time

import pytest

import stayput.progress as progress
from stayput.progress import bar, told_in


@pytest.fixture
def terminal(monkeypatch):
    monkeypatch.setenv("FORCE_COLOR", "1")
    monkeypatch.setenv("COLUMNS", "120")


def test_a_bar_shows_rate_and_time_left_on_a_terminal_only(request, capsys):
    with bar(10, "progress.simulating") as tell:
        tell(10)
    assert capsys.readouterr() == ("", "")
    request.getfixturevalue("terminal")
    with bar(10, "progress.simulating", True) as tell:
        tell(4)
        time.sleep(0.3)
        tell(6)
        time.sleep(0.3)
    shown = capsys.readouterr().err
    assert "10/10" in shown
    assert "cases/s" in shown


@pytest.mark.parametrize(("language", "told"), [("en", r"0:00:\d\d left"), ("ja", r"残り0:00:\d\d")])
def test_the_time_left_is_told_in_the_language(terminal, capsys, language, told):
    with told_in(language), bar(10, "progress.simulating") as tell:
        tell(4)
        time.sleep(0.1)
        tell(3)
        time.sleep(0.7)  # a column is drawn anew after half a second
    assert re.search(told, capsys.readouterr().err)


def test_a_bar_within_another_stands_below_it_and_goes_when_it_is_done(terminal, capsys):
    with bar(10, "progress.simulating", unit="progress.cases") as tell:
        with bar(3, "progress.compiling", unit="progress.functions") as inner:
            inner(1)
            time.sleep(0.01)
            inner(1)
            (drawn,) = progress._drawn
            assert [(task.description, task.completed) for task in drawn.tasks] == [
                ("Simulating", 0),
                ("Compiling the mechanics once", 2),
            ]
            time.sleep(0.3)
        assert [task.description for task in drawn.tasks] == ["Simulating"]
        tell(10)
    assert not progress._drawn
    shown = capsys.readouterr().err
    assert "2/3" in shown
    assert "functions/s" in shown


def test_an_error_clears_all_bars(terminal):
    with pytest.raises(ZeroDivisionError), bar(10, "progress.simulating"), bar(3, "progress.compiling"):
        raise ZeroDivisionError
    assert not progress._drawn


def test_a_process_that_another_has_started_draws_none(terminal, monkeypatch, capsys):
    monkeypatch.setattr(multiprocessing, "parent_process", lambda: "another")
    with bar(10, "progress.simulating") as tell:
        tell(10)
    assert capsys.readouterr() == ("", "")
