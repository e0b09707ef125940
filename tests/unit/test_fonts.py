"""Letters that the pictures' own font lacks: drawn where the machine has a font for them, else told once."""

import re
import warnings

import matplotlib as mpl
import pytest
import report_runs
from typer.testing import CliRunner

from stayput.cli import app
from stayput.errors import InputWarning
from stayput.fragility.curve import FragilityCurve
from stayput.fragility.intensity_measures import JMA_INTENSITY
from stayput.fragility.trials import Trials
from stayput.report import figures
from stayput.report.animation import animate_run
from stayput.report.fragility import plot_fragility
from stayput.report.plot import plot_run

JAPANESE = "本棚とポール"


@pytest.fixture
def bare_machine(monkeypatch):
    """A machine with no fonts but Matplotlib's own."""
    monkeypatch.setattr(figures, "findSystemFonts", list)
    monkeypatch.setattr(figures, "_warned", set())
    for kept in (figures._system_fonts, figures._other):
        kept.cache_clear()
    yield
    for kept in (figures._system_fonts, figures._other):
        kept.cache_clear()


def curve(name):
    trials = Trials.from_counts(JMA_INTENSITY, [5.0, 5.5, 6.0, 6.5], [2, 15, 33, 39], [40] * 4)
    return FragilityCurve(name, trials)


def test_what_the_own_font_has_is_drawn_with_it_alone():
    assert figures.drawable("Bookcase, 3°, μ = 0.4 é") == "Bookcase, 3°, μ = 0.4 é"
    figure = plot_fragility([curve("none")])
    families = {tuple(text.get_fontfamily()) for text in figure.findobj(mpl.text.Text)}
    assert families == {tuple(mpl.rcParams["font.family"])}


@pytest.mark.usefixtures("japanese_font")
def test_japanese_is_drawn_where_a_font_has_it(tmp_path):
    with warnings.catch_warnings():
        warnings.simplefilter("error")  # Matplotlib's of missing glyphs among them
        figure = plot_fragility([curve(JAPANESE)], tmp_path / "it.png", title=JAPANESE)
        run = plot_run(report_runs.rocking(), tmp_path / "run.svg", title=JAPANESE)
    texts = [text.get_text() for text in figure.findobj(mpl.text.Text)]
    assert any(text.startswith(JAPANESE) for text in texts)
    assert JAPANESE in run.get_suptitle()
    told, face = figures.with_face(f"{JAPANESE} 3°", 13)
    assert told == f"{JAPANESE} 3°"
    assert face.path != figures.font(13).path


def test_a_machine_without_such_a_font_says_so_once(bare_machine, tmp_path):
    with pytest.warns(InputWarning, match="No font of this machine has the letters"):
        assert figures.drawable(f"a {JAPANESE} b") == "a … b"
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert figures.with_face(f"a {JAPANESE} b", 13)[0] == "a … b"
        plot_fragility([curve("ポール")], tmp_path / "it.png")
        animate_run(report_runs.rocking().named([JAPANESE]), tmp_path / "it.gif", fps=2)
    assert (tmp_path / "it.png").stat().st_size > 10_000


def test_the_command_line_says_it_in_one_plain_line(bare_machine, tmp_path):
    scene = tmp_path / "scene.toml"
    tables = (
        '[furniture]\npreset = "chest"\nname = "箪笥"\n[shaking.sine]\namplitude = 1.0\nfrequency = 1.0\n'
    )
    scene.write_text(tables, encoding="utf-8")
    done = CliRunner().invoke(app, ["simulate", str(scene), "--plot", str(tmp_path / "it.png")])
    assert done.exit_code == 0, done.output
    (line,) = [line for line in done.stderr.splitlines() if "No font" in line]
    assert re.match(
        r"Warning: No font of this machine has the letters .+; pictures show … instead\. Install", line
    )
    assert "UserWarning" not in done.stderr
    assert "InputWarning" not in done.stderr
