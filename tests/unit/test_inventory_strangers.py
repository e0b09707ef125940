"""Files of others in the folder of an assessment: none is removed, and what is in the way is named."""

from __future__ import annotations

import json
import os
import shutil
import sys

import pytest
from forks import start
from inventories import CITY, city, digests, pieces, table

import stayput as sp
from stayput.inventory import assess
from stayput.inventory.plan import make_plan
from stayput.inventory.workspace import Workspace, remove


@pytest.fixture(scope="module")
def finished(tmp_path_factory):
    folder = tmp_path_factory.mktemp("finished")
    inputs = table(folder, pieces(4)), city(folder, CITY.split("[[measures]]")[0])
    assess(*inputs, folder / "out", progress=False)
    return inputs, folder / "out"


@pytest.fixture
def done(finished, tmp_path):
    """An assessment that is complete: its inputs, and a copy of its folder."""
    inputs, out = finished
    shutil.copytree(out, tmp_path / "out")
    return inputs, tmp_path / "out"


def everything(folder):
    """Whatever lies in a folder, with its content."""
    return {
        str(path.relative_to(folder)): path.read_bytes() if path.is_file() else path.is_symlink()
        for path in sorted(folder.rglob("*"))
    }


STRANGERS = [
    "thesis.txt",
    ".bashrc",
    ".secret-12345678",
    ".photos-abcdefgh/summer.jpg",
    "work/.git-abcdefgh/config",
    "work/plan/plan.sqlite",
    "work/drafts/0123456789abcdef-0",
    "work/drafts/0123456789abcdef-0/rows/part-000000.parquet",
    "pieces/part-000000.parquet",
    "report.html",
    "manifest.json",
]


@pytest.mark.parametrize("name", STRANGERS)
def test_a_folder_of_somebody_else_is_left_as_it_is(finished, tmp_path, name):
    path = tmp_path / "out" / name
    path.parent.mkdir(parents=True)
    path.write_text("mine")
    before = everything(tmp_path / "out")
    with pytest.raises(sp.InputError, match=r"The folder '.*' holds "):
        assess(*finished[0], tmp_path / "out", progress=False)
    assert everything(tmp_path / "out") == before


def test_a_lock_of_somebody_else_is_not_taken(finished, tmp_path):
    out, elsewhere = tmp_path / "out", tmp_path / "elsewhere"
    out.mkdir()
    (out / ".lock").symlink_to(elsewhere)
    with pytest.raises(sp.InputError, match=r"holds '\.lock' and no assessment"):
        assess(*finished[0], out, progress=False)
    assert not elsewhere.exists()


BESIDE = [
    ".secret-12345678",
    ".photos-abcdefgh/summer.jpg",
    "notes/.draft-12345678",
    "pieces/.DS_Store",
    "work/.lock-abcdefgh",
    "work/drafts/mine-12345678",
    "work/drafts/0123456789abcdef-0",
    "work/drafts/draft-x",
    "work/notes.txt",
]


@pytest.mark.parametrize("name", BESIDE)
def test_files_beside_the_results_stay(done, name):
    inputs, out = done
    path = out / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("mine")
    assert assess(*inputs, out, progress=False).runs == 0
    assert path.read_text() == "mine"


IN_THE_WAY = ["pieces/mine.parquet", "pieces/part-000001.parquet", "work/plan/notes.txt"]


@pytest.mark.parametrize("name", IN_THE_WAY)
def test_what_would_be_read_as_results_is_named(done, name):
    inputs, out = done
    (out / name).write_text("mine")
    before = digests(out)
    with pytest.raises(sp.InputError, match=r"is in its way; move it elsewhere") as told:
        assess(*inputs, out, progress=False)
    assert name.rpartition("/")[2] in str(told.value)
    assert digests(out) == before
    assert (out / name).read_text() == "mine"


FILES = [
    ".lock",
    "manifest.json",
    "report.html",
    "summary.csv",
    "rejects.parquet",
    "pieces/part-000000.parquet",
    "work/claim.json",
    "work/outcomes.sqlite",
    "work/plan/plan.sqlite",
]


@pytest.mark.parametrize("name", FILES)
def test_a_folder_in_the_place_of_a_file_is_named(done, name):
    inputs, out = done
    (out / name).unlink()
    (out / name).mkdir()
    (out / name / "mine").touch()
    with pytest.raises(sp.InputError, match=name.rpartition("/")[2]):
        assess(*inputs, out, progress=False)
    assert (out / name / "mine").exists()


FOLDERS = ["pieces", "work", "work/drafts", "work/plan", "work/plan/rows"]


@pytest.mark.parametrize("name", [*FOLDERS, "report.html", ".lock", "work/outcomes.sqlite"])
def test_links_out_of_the_folder_are_not_followed(done, tmp_path, name):
    inputs, out = done
    elsewhere = tmp_path / "elsewhere"
    (out / name).rename(elsewhere)
    before = everything(elsewhere) if elsewhere.is_dir() else elsewhere.read_bytes()
    (out / name).symlink_to(elsewhere)
    with pytest.raises(sp.InputError, match=f"holds the link '{name}'"):
        assess(*inputs, out, progress=False)
    assert (everything(elsewhere) if elsewhere.is_dir() else elsewhere.read_bytes()) == before


def test_a_link_among_the_drafts_is_named_and_what_it_points_to_stays(done, tmp_path):
    inputs, out = done
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "file").touch()
    (out / "work" / "drafts" / "draft-99").symlink_to(tmp_path / "mine")
    with pytest.raises(sp.InputError, match="holds the link"):
        assess(*inputs, out, progress=False)
    remove(out / "work" / "drafts" / "draft-99")
    assert (tmp_path / "mine" / "file").exists()


def test_a_file_of_others_in_a_plan_that_was_left_half_made_is_named(done):
    inputs, out = done
    left = out / "work" / "drafts" / "draft-7"
    (left / "rows").mkdir(parents=True)
    (left / "plan.sqlite").touch()
    (left / "rows" / "mine.txt").touch()
    with pytest.raises(sp.InputError, match=r"holds the file 'rows/mine\.txt'"):
        assess(*inputs, out, progress=False)
    assert (left / "plan.sqlite").exists()
    (left / "rows" / "mine.txt").unlink()
    assess(*inputs, out, progress=False)
    assert not left.exists()


def test_a_plan_is_removed_with_all_that_it_consists_of(finished, tmp_path):
    (tmp_path / "work").mkdir()
    space = Workspace(tmp_path / "work")
    from stayput.inventory.scenarios import read_scenarios

    make_plan(space, finished[0][0], read_scenarios(finished[0][1]), 2**20, lambda count: None)
    remove(tmp_path / "work" / "plan")
    assert not (tmp_path / "work" / "plan").exists()


TOUCHES = ("open", "os.rename", "os.mkdir", "os.remove", "os.rmdir")


def killed_at(step, out, *inputs):
    """Assess up to the next file after so many that are touched in the folder."""
    left = step

    def count(event, arguments):
        nonlocal left
        if event in TOUCHES and str(out) in str(arguments[0]):
            left -= 1
            if left < 0:
                os._exit(9)

    sys.addaudithook(count)
    assess(*inputs, out, progress=False, threads=1)


@pytest.mark.processes
def test_killed_at_any_file_it_goes_on_and_leaves_others_alone(finished, tmp_path):
    """Each child ends at the next file that it touches in the folder: opens, makes, renames or removes."""
    inputs, complete = finished
    expected = digests(complete)
    out, step, ended = tmp_path / "out", 0, 9
    while ended == 9:
        child = start(killed_at, step, out, *inputs)
        child.join()
        ended = child.exitcode
        assert ended in (0, 9)
        if (out / "manifest.json").exists():
            (out / ".mine-12345678").write_text("mine")
        step += 1 if step < 12 else 3
    assert step > 20
    assert (out / ".mine-12345678").read_text() == "mine"
    (out / ".mine-12345678").unlink()
    assert digests(out) == expected
    assert not list((out / "work" / "drafts").iterdir())


@pytest.mark.parametrize("content", ["", "{", "null", "[]", "[" * 100_000, "\x00\xff", '{"inputs": 3}'])
@pytest.mark.parametrize("name", ["manifest.json", "work/claim.json"])
def test_a_damaged_manifest_is_written_again(done, content, name):
    inputs, out = done
    before = digests(out)
    (out / name).write_text(content, encoding="latin-1")
    assert assess(*inputs, out, progress=False).runs == 0
    assert digests(out) == before
    assert json.loads((out / name).read_text())["inputs"]


def test_a_damaged_manifest_alone_is_named(done):
    inputs, out = done
    shutil.rmtree(out / "work")
    (out / "manifest.json").write_text("{")
    with pytest.raises(sp.InputError, match=r"a manifest\.json that is damaged"):
        assess(*inputs, out, progress=False)
    assert (out / "manifest.json").read_text() == "{"


def test_a_damaged_manifest_does_not_let_another_inventory_in(done, tmp_path):
    (_, scenario), out = done
    (out / "manifest.json").write_text("{")
    with pytest.raises(sp.InputError, match="another inventory"):
        assess(table(tmp_path, pieces(5)), scenario, out, progress=False)


def test_a_folder_in_which_a_table_was_refused_takes_the_mended_one(tmp_path):
    scenario = city(tmp_path, CITY.split("[[measures]]")[0])
    with pytest.raises(sp.InputError, match="did you mean"):
        assess(table(tmp_path, ["a,chest"], "id,presett"), scenario, tmp_path / "out", progress=False)
    assess(table(tmp_path, ["a,chest"], "id,preset"), scenario, tmp_path / "out", progress=False)


def test_a_table_that_changes_while_it_is_read_is_said(tmp_path, monkeypatch):
    inventory, scenario = table(tmp_path, pieces(4)), city(tmp_path, CITY.split("[[measures]]")[0])
    module = sys.modules["stayput.inventory.plan"]
    fill = module._fill

    def replaced(*arguments):
        table(tmp_path, pieces(3))
        fill(*arguments)

    with monkeypatch.context() as patch:
        patch.setattr(module, "_fill", replaced)
        with pytest.raises(sp.InputError, match="was changed while it was read; give the command again"):
            assess(inventory, scenario, tmp_path / "out", progress=False)
    assert assess(inventory, scenario, tmp_path / "out", progress=False).facts["pieces"] == 3
