"""Names of files that are too long end in a sentence; those that just are not are written."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest
from commands import SLENDER, cli

from stayput.errors import InputError
from stayput.files import check_target, draft, folder_draft

if TYPE_CHECKING:
    from pathlib import Path

LONG = 300 * "a"
WIDE = 120 * "あ"
"""A name whose bytes are too many, and its letters are not."""


@pytest.mark.parametrize(
    "command",
    [
        "simulate --plot {name}.png",
        "simulate --animate {name}.html",
        "simulate {name}.toml",
        "verify s.toml --csv {name}.csv",
        "verify s.toml --report {name}.html",
        "verify s.toml --csv {name}/v.csv",
        "assess {name}.csv --scenario s.toml --out out",
        "assess t.csv --scenario s.toml --out {name}",
        "verify s.toml --curves {name}",
        "motion convert near-fault {name}.csv",
        "motion suite --family near-fault --count 2 --out {name}",
    ],
)
@pytest.mark.parametrize("name", [LONG, WIDE], ids=["letters", "bytes"])
def test_a_name_that_is_too_long_is_refused_in_a_sentence(
    name: str, command: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "s.toml").write_text(SLENDER, encoding="utf-8")
    (tmp_path / "t.csv").write_text("id,width,height,mass\n1,0.3,1.8,60\n", encoding="utf-8")
    before = set(tmp_path.iterdir())
    done = cli(*command.format(name=name).split())
    assert done.exit_code == 2, done.exception
    assert "too long" in done.stderr
    assert len(done.stderr.splitlines()) == 1
    assert {path.name for path in set(tmp_path.iterdir()) - before} <= {"out"}


@pytest.mark.parametrize("stem", [250 * "a", 83 * "あ"])
def test_a_name_as_long_as_may_be_is_written(stem: str, tmp_path: Path):
    target = check_target(tmp_path / f"{stem}.csv", (".csv",))
    with draft(target) as unfinished:
        unfinished.write_text("1")
    assert [path.name for path in tmp_path.iterdir()] == [target.name]


def test_a_path_that_no_file_can_have_is_refused(tmp_path: Path):
    with pytest.raises(InputError, match="too long"), draft(tmp_path / LONG / "it.csv") as unfinished:
        unfinished.write_text("1")
    with pytest.raises(InputError, match="too long"), folder_draft(tmp_path / LONG):
        pass


def test_a_name_with_a_null_character_is_refused():
    with pytest.raises(InputError, match=r"'a\\x00b.nc'; it must be a name without null characters"):
        check_target("a\0b.nc", (".nc",))


def test_a_folder_that_cannot_be_written_to_is_refused_before_the_runs(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setattr("stayput.files.os.access", lambda _path, _mode: False)  # root may write everywhere
    with pytest.raises(InputError, match=r"r\.html.* could not be written: permission denied"):
        check_target(tmp_path / "r.html", (".html",))
