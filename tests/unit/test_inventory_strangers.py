"""Files of others in the folder of an assessment: none is removed, and what is in the way is named."""

from __future__ import annotations

import os
import shutil
import sys

import pytest
from forks import start
from inventories import CITY, city, digests, pieces, table

import stayput as sp
from stayput.inventory import assess


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
    ".photos-abcdefgh/summer.jpg",
    "work/plan.sqlite",
    "work/drafts/0123456789abcdef-0/part-000000.parquet",
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


BESIDE = [".photos-abcdefgh/summer.jpg", "pieces/.DS_Store", "work/drafts/draft-x", "work/notes.txt"]


@pytest.mark.parametrize("name", BESIDE)
def test_files_beside_the_results_stay(done, name):
    inputs, out = done
    path = out / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("mine")
    assert assess(*inputs, out, progress=False).runs == 0
    assert path.read_text() == "mine"


IN_THE_WAY = {
    "file": ["pieces/mine.parquet"],
    "folder": [
        ".lock",
        "report.html",
        "pieces/part-000000.parquet",
        "work/plan.sqlite",
        "work/drafts/draft-7",
    ],
    "link": [".lock", "report.html", "pieces", "work", "work/plan.sqlite", "work/drafts/draft-99"],
}


@pytest.mark.parametrize(("kind", "name"), [(kind, name) for kind in IN_THE_WAY for name in IN_THE_WAY[kind]])
def test_what_is_in_the_way_is_named_and_stays(done, tmp_path, kind, name):
    (inputs, out), mine = done, tmp_path / "mine"
    mine.mkdir()
    (mine / "file").write_text("mine")
    path = out / name
    if path.exists():
        path.rename(tmp_path / "before")
    path.parent.mkdir(parents=True, exist_ok=True)
    match kind:
        case "file":
            path.write_text("mine")
        case "folder":
            shutil.copytree(mine, path)
        case _:
            path.symlink_to(mine)
    before = everything(out)
    with pytest.raises(sp.InputError, match=f"holds '{name}/?', .* in its way; move it elsewhere"):
        assess(*inputs, out, progress=False)
    assert everything(out) == before
    assert (mine / "file").read_text() == "mine"


def test_a_part_that_the_plan_does_not_have_is_named(done):
    inputs, out = done
    (out / "pieces" / "part-000001.parquet").touch()
    with pytest.raises(sp.InputError, match=r"holds 'part-000001\.parquet'"):
        assess(*inputs, out, progress=False)


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


@pytest.mark.parametrize("content", ["", "[]", "[" * 100_000, "\x00\xff", '{"inputs": 3}'])
def test_a_damaged_manifest_is_that_of_somebody_else(done, content):
    inputs, out = done
    (out / "manifest.json").write_text(content, encoding="latin-1")
    before = everything(out)
    with pytest.raises(sp.InputError, match=r"holds 'manifest\.json' and no assessment"):
        assess(*inputs, out, progress=False)
    assert everything(out) == before


def test_a_folder_in_which_a_table_was_refused_takes_the_mended_one(tmp_path):
    scenario = city(tmp_path, CITY.split("[[measures]]")[0])
    with pytest.raises(sp.InputError, match="did you mean"):
        assess(table(tmp_path, ["a,chest"], "id,presett"), scenario, tmp_path / "out", progress=False)
    assess(table(tmp_path, ["a,chest"], "id,preset"), scenario, tmp_path / "out", progress=False)


def test_a_table_that_changes_while_it_is_read_is_said(tmp_path, monkeypatch):
    inventory, scenario = table(tmp_path, pieces(4)), city(tmp_path, CITY.split("[[measures]]")[0])
    module = sys.modules["stayput.inventory.plan"]
    opened = module.open_table

    def replaced(path):
        table(tmp_path, pieces(3))
        return opened(path)

    with monkeypatch.context() as patch:
        patch.setattr(module, "open_table", replaced)
        with pytest.raises(sp.InputError, match="was changed while it was read; give the command again"):
            assess(inventory, scenario, tmp_path / "out", progress=False)
    assert assess(inventory, scenario, tmp_path / "out", progress=False).facts["pieces"] == 3
