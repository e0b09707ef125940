"""What is shipped: the lock file, a light import, the public names, tidy sources, and the wheel."""

from __future__ import annotations

import ast
import os
import re
import subprocess
import sys
import tarfile
import time
import tomllib
import zipfile
from importlib.util import find_spec
from pathlib import Path

import pytest

import stayput

ROOT = Path(__file__).parents[2]
HEAVY = ("numba", "obspy", "matplotlib", "scipy", "xarray", "pandas")


def run_python(*arguments: str, times: int = 1) -> tuple[str, float]:
    """Run this Python on its own; return what it prints, and the least of some wall times [s]."""
    seconds = list[float]()
    for _ in range(times):
        start = time.perf_counter()
        done = subprocess.run([sys.executable, *arguments], capture_output=True, text=True, check=True)
        seconds.append(time.perf_counter() - start)
    return done.stdout, min(seconds)


def tracked_files() -> list[Path]:
    """Files that git tracks or would track."""
    command = ["git", "-C", str(ROOT), "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    try:
        listed = subprocess.run(command, capture_output=True, check=True).stdout.decode().split("\0")
    except (OSError, subprocess.CalledProcessError):
        pytest.skip("this is not a git checkout")
    return [ROOT / name for name in listed if name and (ROOT / name).is_file()]


def locked() -> dict[str, str]:
    lines = (ROOT / "requirements.lock").read_text(encoding="utf-8").splitlines()
    return dict(line.split("==") for line in lines)


def canonical(name: str) -> str:
    return re.sub(r"[-_.]+", "-", name).lower()


def test_lock_holds_names_and_versions_only() -> None:
    lines = (ROOT / "requirements.lock").read_text(encoding="utf-8").splitlines()
    wrong = [line for line in lines if not re.fullmatch(r"[A-Za-z0-9][\w.-]*==[0-9][\w.+!]*", line)]
    assert not wrong
    assert len({canonical(line.split("==")[0]) for line in lines}) == len(lines)


def test_lock_covers_every_dependency() -> None:
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    project, groups = settings["project"], settings["dependency-groups"]
    wanted = [*project["dependencies"], *(d for e in project["optional-dependencies"].values() for d in e)]
    del groups["peers"]  # whose environment is their own
    wanted += [
        d for group in groups.values() for d in group if isinstance(d, str)
    ]  # else it includes a group
    names = {canonical(re.split(r"[\[<>=!~; ]", requirement)[0]) for requirement in wanted}
    assert names <= {canonical(name) for name in locked()}


def test_ruff_before_a_commit_is_the_locked_one() -> None:
    text = (ROOT / ".pre-commit-config.yaml").read_text(encoding="utf-8")
    repository = text.split("ruff-pre-commit")[1]
    assert f"rev: v{locked()['ruff']}\n" in repository


def test_import_is_light() -> None:
    """`import stayput` loads nothing heavy; the aim is 0.2 s on top of bare Python."""
    code = f"import sys, stayput; print([m for m in {HEAVY} if m in sys.modules])"
    loaded, seconds = run_python("-c", code, times=3)
    _, bare = run_python("-c", "pass", times=3)
    print(f"import stayput: {seconds - bare:.3f} s on top of bare Python")
    assert loaded.strip() == "[]"
    assert seconds - bare < 2.0


def test_a_verdict_waits_for_nothing_that_it_does_not_need() -> None:
    needless = {"xarray", "pandas", "matplotlib", "obspy", "fastapi"}
    code = f"import sys, stayput; stayput.verify; print([m for m in {needless} if m in sys.modules])"
    assert run_python("-c", code)[0].strip() == "[]"


def test_the_module_of_measures_is_there_at_once_and_loads_when_it_is_used() -> None:
    code = "import sys, stayput as sp; a = 'stayput.measures' in sys.modules; print(a, sp.measures.Belt.kind)"
    assert run_python("-c", code)[0].split() == ["False", "belt"]


def test_every_public_name_resolves() -> None:
    for name in stayput.__all__:
        assert getattr(stayput, name) is not None, name
    assert set(stayput.__all__) <= set(dir(stayput))
    with pytest.raises(AttributeError):
        stayput.no_such_name  # noqa: B018


def test_every_public_name_says_what_it_is() -> None:
    for name in stayput.__all__:
        thing = getattr(stayput, name)
        assert not callable(thing) or (thing.__doc__ or "").strip(), name


def test_version_is_the_project_s() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert stayput.__version__ == project["version"]
    citation = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    assert f"version: {project['version']}" in citation
    assert f"[{project['version']}]" in (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")


def test_no_source_file_is_long() -> None:
    kinds = {".py", ".js", ".html", ".css"}
    files = [f for f in tracked_files() if f.suffix in kinds]
    long = {f.name: n for f in files if (n := len(f.read_text(encoding="utf-8").splitlines())) > 500}
    assert not long


def test_no_machine_paths_in_the_tree() -> None:
    marks = tuple(f"/{name}/" for name in ("work", "root"))  # not written out, so as not to find itself
    found = []
    for file in tracked_files():
        try:
            text = file.read_text(encoding="utf-8")
        except UnicodeDecodeError:
            continue
        found += [f"{file.relative_to(ROOT)}: {mark}" for mark in marks if mark in text]
    assert not found


def test_sources_parse_on_the_oldest_python() -> None:
    for file in [*(ROOT / "src").rglob("*.py"), *(ROOT / "studies").glob("*.py")]:
        ast.parse(file.read_text(encoding="utf-8"), str(file), feature_version=(3, 11))


@pytest.mark.long
@pytest.mark.skipif(find_spec("hatchling") is None, reason="hatchling, which builds the source, is absent")
def test_tests_of_the_source_distribution_can_be_collected(tmp_path: Path) -> None:
    build = [sys.executable, "-m", "hatchling", "build", "-t", "sdist", "-d", str(tmp_path)]
    subprocess.run(build, cwd=ROOT, check=True, capture_output=True)
    (packed,) = tmp_path.glob("stayput-*.tar.gz")
    with tarfile.open(packed) as archive:
        for member in archive.getmembers():
            archive.extract(member, tmp_path)  # `filter` is in no Python before 3.11.4
    source = next(path for path in tmp_path.iterdir() if path.is_dir())
    # assertions as they are: to rewrite those of all tests takes as long as all else
    quickly = ["-q", "-p", "no:cacheprovider", "--assert=plain"]
    done = subprocess.run(
        [sys.executable, "-m", "pytest", "--collect-only", *quickly],
        cwd=source,
        env={**os.environ, "PYTHONPATH": str(source / "src"), "PYTHONDONTWRITEBYTECODE": "1"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout[-3000:]
    assert (source / "Makefile").is_file()
    assert (source / "requirements.lock").is_file()
    assert (source / "studies" / "friction.py").is_file()


@pytest.mark.skipif(find_spec("hatchling") is None, reason="hatchling, which builds the wheel, is absent")
def test_wheel_has_the_package_and_its_type_marker(tmp_path: Path) -> None:
    options = ("--no-deps", "--no-build-isolation", "--no-index", "--disable-pip-version-check", "-q")
    command = [sys.executable, "-m", "pip", "wheel", *options, "-w", str(tmp_path), str(ROOT)]
    subprocess.run(command, check=True, capture_output=True)
    (wheel,) = tmp_path.glob("stayput-*.whl")
    with zipfile.ZipFile(wheel) as archive:
        names = archive.namelist()
        metadata = next(archive.read(n).decode() for n in names if n.endswith(".dist-info/METADATA"))
    assert "stayput/py.typed" in names
    data = [f for f in (ROOT / "src").rglob("*") if f.is_file() and "__pycache__" not in f.parts]
    assert {str(f.relative_to(ROOT / "src")) for f in data} <= set(names)
    assert all(name.startswith(("stayput/", "stayput-")) for name in names)
    assert f"Version: {stayput.__version__}" in metadata
