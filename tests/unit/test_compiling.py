"""Compiled code on disk: used again unless it is damaged or its source changed; announced when made."""

import errno
import os
import pickle
import re
import runpy
import shutil
import signal
import stat
import subprocess
import sys
import tempfile
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from io import StringIO
from pathlib import Path
from threading import Event, Thread, main_thread

import numpy as np
import pytest
from forks import start
from numba import njit

import stayput.compiling as compiled
from stayput.compiling import machine_code
from stayput.compiling.machine_code import MachineCode
from stayput.mechanics.flat import block_extremes
from stayput.motion.oscillator import peak_responses

ROOT = Path(__file__).parents[2]
MAKE_FOR_A_WHEEL = ROOT / ".ci" / "machine_code.py"

CALLER = """
import numpy as np
from stayput.compiling import entry, on_compilation
from small.callee import part

@entry
def whole(x, result):
    result[0] = part(x) + 1.0

result = np.zeros(1)
with on_compilation(lambda: print("compiling", end=" ")):
    whole(2, result), whole(1.0, result)
print(result[0])
"""


def callee(factor):
    return f"from stayput.compiling import inner\n\n@inner\ndef part(x):\n    return {factor} * x\n"


class Program:
    """A program of two files that are compiled, and the folder of its code."""

    def __init__(self, folder: Path) -> None:
        self.folder, self.package, self.code = folder, folder / "small", folder / "code"
        self.package.mkdir()
        (self.package / "caller.py").write_text(CALLER)
        (self.package / "callee.py").write_text(callee(2.0))

    def __call__(self, **environment: str) -> str:
        """Run it in a new process, which has none of its code; return what it says, warnings last."""
        said = self.folder / "said"
        process = start(run_program, self.folder, said, environment or {"NUMBA_CACHE_DIR": str(self.code)})
        process.join()
        assert process.exitcode == 0
        return said.read_text().strip()


def run_program(folder: Path, said: Path, environment: dict[str, str]) -> None:
    os.environ.update(environment)
    tempfile.tempdir = None
    machine_code.WITH_PACKAGE = folder / "with the package"
    # a source of the same size that is written within a second of the last one has its bytecode
    sys.dont_write_bytecode = True
    sys.path.insert(0, str(folder))
    with redirect_stdout(StringIO()) as output, redirect_stderr(StringIO()) as warnings:
        runpy.run_module("small.caller", run_name="__main__")
    said.write_text(output.getvalue() + warnings.getvalue())


@pytest.fixture
def run(tmp_path):
    return Program(tmp_path)


@pytest.fixture(scope="module")
def compiled_once(tmp_path_factory):
    run = Program(tmp_path_factory.mktemp("program"))
    run()
    return run


def test_code_on_disk_is_used_until_any_source_changes(run):
    assert run() == "compiling 3.0"
    assert run() == "3.0"
    (run.package / "callee.py").write_text(callee(5.0))  # the entry's own file stays as it was
    assert run() == "compiling 6.0"
    assert run() == "6.0"


def test_code_on_disk_is_not_used_when_a_source_of_what_its_callee_calls_changes(run):
    (run.folder / "far").mkdir()
    calls = "return distant(x)\n\nfrom far.away import part as distant\n"
    (run.package / "callee.py").write_text(callee(1.0).replace("return 1.0 * x\n", calls))
    for factor, said in ((2.0, "compiling 3.0"), (2.0, "3.0"), (5.0, "compiling 6.0")):
        (run.folder / "far" / "away.py").write_text(callee(factor))
        assert run() == said


def test_code_that_came_with_the_package_is_used_unless_it_is_damaged_or_a_source_changed(compiled_once):
    with_package = compiled_once.folder / "with the package"
    compiled_once.code.rename(with_package)
    for file in with_package.rglob("*.code"):
        file.rename(with_package / file.name)
    assert compiled_once() == "3.0"
    assert not compiled_once.code.exists()
    (compiled_once.package / "callee.py").write_text(callee(5.0))
    assert compiled_once() == "compiling 6.0"
    (compiled_once.package / "callee.py").write_text(callee(2.0))
    shutil.rmtree(compiled_once.code)
    for file in with_package.glob("*.code"):
        file.write_bytes(file.read_bytes()[:-1])
    assert compiled_once() == "compiling 3.0"
    shutil.rmtree(with_package)


def test_all_that_is_compiled_is_made_for_a_wheel():
    program = (
        "import gc, runpy\n"
        "from stayput.compiling import Entry\n"
        f"runpy.run_path({str(MAKE_FOR_A_WHEEL)!r})['call_all']()\n"
        "entries = [one for one in gc.get_objects() if type(one) is Entry]\n"
        "print(*(f'{one.__name__}:{len(one._loaded)}' for one in entries))"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    made = dict(each.split(":") for each in done.stdout.split())
    sources = [file.read_text(encoding="utf-8") for file in (ROOT / "src").rglob("*.py")]
    entries = {name for source in sources for name in re.findall(r"^@entry\ndef (\w+)", source, re.MULTILINE)}
    # the plane has an entry for bodies without devices and one for those with them
    assert made == {name: "2" if name == "run_batch" else "1" for name in entries}


def test_processors_that_lack_what_the_usual_ones_have_get_code_of_their_own(monkeypatch):
    usual = MachineCode("module.function", ("f",), (Path(__file__).parent,))._file
    host, features = machine_code.llvm.get_host_cpu_name(), machine_code.llvm.get_host_cpu_features()
    monkeypatch.setattr(machine_code.platform, "machine", lambda: "x86_64")
    monkeypatch.setattr(machine_code.llvm, "get_host_cpu_features", lambda: features)
    wanted = machine_code.GENERIC["x86_64", "amd64"][1]
    for name in wanted:
        features[name] = True
    assert machine_code._processor.__wrapped__() == ("x86-64-v3", "")
    features["avx2"] = False
    assert machine_code._processor.__wrapped__() == (host, features.flatten())
    monkeypatch.setattr(machine_code, "_processor", lambda: ("older", "-avx2"))
    assert MachineCode("module.function", ("f",), (Path(__file__).parent,))._file != usual


def test_code_on_disk_runs_without_numba():
    program = (
        "import sys, numpy, stayput as sp\n"
        "run = sp.simulate(sp.Body(0.4, 1.6, 50.0), sp.Room(), sp.Motion(0.01, numpy.ones(10)))\n"
        "print(run.outcome.value, 'numba' in sys.modules)"
    )
    for _ in range(2):  # the first may have to compile
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["rested", "False"]


def cut(share):
    return lambda content: content[: int(share * len(content))]


def _zeros(content):
    middle = len(content) // 2
    return content[:middle] + bytes(200) + content[middle + 200 :]


DAMAGES = {
    "empty": cut(0.0),
    "cut early": cut(0.01),
    "cut in the middle": cut(0.5),
    "cut at the end": lambda content: content[:-1],
    "zeros": lambda content: bytes(len(content)),
    "zeros inside": _zeros,
    "one bit": lambda content: content[:-500] + bytes([content[-500] ^ 1]) + content[-499:],
    "garbage": lambda content: b"\xde\xad\xbe\xef" * 1000,
    "another pickle": lambda content: pickle.dumps({"version": None}),
    "more": lambda content: content + b"\0",
}


@pytest.mark.parametrize("damage", DAMAGES)
def test_damaged_code_is_compiled_anew(compiled_once, damage):
    files = sorted(compiled_once.code.rglob("*.code"))
    assert files
    for file in files:
        file.write_bytes(DAMAGES[damage](file.read_bytes()))
    assert compiled_once() == "compiling 3.0"


def test_code_in_the_file_of_other_code_is_not_taken(run):
    run()
    one, other = sorted(run.code.rglob("*.code"))
    shutil.copy(one, other)
    assert run() == "compiling 3.0"
    assert run() == "3.0"


def test_a_folder_in_the_place_of_code_is_said_in_a_line(run):
    run()
    for file in run.code.rglob("*.code"):
        file.unlink()
        file.mkdir()
    head, warning = run().splitlines()
    assert head == "compiling 3.0"
    assert warning.startswith(f"Compiled code cannot be kept on this machine ({run.code}")
    assert warning.endswith(": is a directory); every start compiles anew.")


def test_where_a_disk_is_full_the_next_folder_is_taken(monkeypatch, tmp_path, caplog):
    full, free = tmp_path / "full", tmp_path / "free"
    code = MachineCode("module.function", ("f",), (tmp_path,))
    write = Path.write_bytes

    def written(file, content):
        if full in file.parents:
            raise OSError(errno.ENOSPC, "No space left on device")
        return write(file, content)

    monkeypatch.setattr(Path, "write_bytes", written)
    monkeypatch.setattr(machine_code, "_folders", lambda beside: iter((full, free)))
    code._save(b"content")
    assert [file.read_bytes() for file in free.iterdir()] == [b"content"]
    assert not list(full.iterdir())
    machine_code._warn_once.cache_clear()
    monkeypatch.setattr(machine_code, "_folders", lambda beside: iter((full,)))
    code._save(b"content")
    assert f"({full}: no space left on device); every start compiles anew." in caplog.text


@pytest.mark.skipif(os.name != "posix", reason="elsewhere an interrupt waits for a lock")
def test_an_interrupt_ends_the_wait_for_llvm_and_not_its_work(request):
    # a shell that starts the tests in the background has them ignore interrupts
    usual = signal.signal(signal.SIGINT, signal.default_int_handler)
    request.addfinalizer(lambda: signal.signal(signal.SIGINT, usual))
    begun, ended = Event(), Event()

    def work():
        begun.set()
        ended.wait(10.0)
        return "made"

    def interrupted():
        begun.wait(10.0)
        signal.pthread_kill(main_thread().ident, signal.SIGINT)

    Thread(target=interrupted).start()
    with pytest.raises(KeyboardInterrupt):
        machine_code.uninterrupted(work)
    ended.set()
    assert machine_code.uninterrupted(lambda: "next") == "next"  # after the work that went on
    with pytest.raises(ValueError, match="wrong"):
        machine_code.uninterrupted(lambda: int("wrong"))


@pytest.fixture
def unwritable(run):
    """Neither beside the sources nor in the home can a folder be made, whoever runs the program."""
    (run.package / "__pycache__").touch()
    temporary = run.folder / "temporary"
    temporary.mkdir()
    home = str(run.package / "caller.py")
    environment = {"TMPDIR": str(temporary), "HOME": home, "XDG_CACHE_HOME": home}
    user = f"-{os.getuid()}" if hasattr(os, "getuid") else ""
    return (lambda: run(**environment).splitlines()), temporary / f"stayput{user}"


def test_where_nothing_can_be_written_code_is_kept_in_a_temporary_folder_of_the_user(unwritable):
    run, folder = unwritable
    said = (
        f"Neither the folder of stayput nor your home can be written to; compiled code is kept in {folder}."
    )
    assert run() == ["compiling 3.0", said]
    assert run() == ["3.0"]
    assert stat.S_IMODE(folder.stat().st_mode) == 0o700
    assert list(folder.rglob("*.code"))


@pytest.mark.parametrize("trap", ["of another user", "open to others", "link", "file"])
def test_a_temporary_folder_that_others_may_have_made_is_not_used(unwritable, trap):
    run, folder = unwritable
    elsewhere = folder.parent / "elsewhere"
    elsewhere.mkdir(mode=0o700)
    match trap:
        case "of another user":
            if os.getuid() != 0:
                pytest.skip("only root can make a folder of another user")
            folder.mkdir(mode=0o700)
            os.chown(folder, 12345, -1)
        case "open to others":
            folder.mkdir()
            folder.chmod(0o777)
        case "link":
            folder.symlink_to(elsewhere)
        case _:
            folder.touch()
    said = "Compiled code cannot be kept on this machine; every start compiles anew."
    assert run() == ["compiling 3.0", said]
    assert not list(folder.parent.rglob("*.code"))


@compiled.inner
def part(x):
    return x + 1.0


@compiled.inner
def other(x):
    return part(x) + part(2.0 * x)


@compiled.inner
def never(x):
    return x


@compiled.entry
def named_four(x, device, result):
    result[0] = other(x)
    if device is not None:
        result[0] = never(x)


def test_a_bar_advances_with_each_function_while_the_mechanics_are_compiled(run, monkeypatch):
    """It is there until the machine code is made."""

    seen = []

    @contextmanager
    def recorded(total, what, unit):
        seen.append((total, what, unit))
        yield seen.append
        seen.append(len(list(run.code.rglob("*.code"))))

    monkeypatch.setattr(compiled, "bar", recorded)
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(run.code))
    result = np.zeros(1)
    for _ in range(2):
        named_four(1.0, None, result)
    assert result[0] == 5.0
    assert seen == [(None, "progress.compiling", "progress.functions"), 1, 1, 1, 1]


def test_where_the_inside_of_numba_differs_it_compiles_the_same_by_itself(monkeypatch, tmp_path, caplog):
    ground = np.random.default_rng(1).standard_normal(200)
    usual, alone = np.zeros((3, 4)), np.zeros((3, 4))
    arguments = ground, 0.01, np.array([0.1, 0.5, 2.0]), 0.05
    peak_responses(*arguments, usual)
    monkeypatch.setitem(sys.modules, "stayput.compiling.front_end", None)
    monkeypatch.setattr(compiled, "_by_numba_alone", Event())
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    compiled.Entry(peak_responses.py_func)(*arguments, alone)
    assert alone.tobytes() == usual.tobytes()
    assert usual.all()
    result = np.zeros(1)
    compiled.Entry(named_four.py_func)(1.0, None, result)
    assert result[0] == 5.0
    (said,) = (record.message for record in caplog.records)
    assert "takes longer and at each start (ModuleNotFoundError" in said
    assert not list(tmp_path.rglob("*.code"))


def test_constants_do_not_compile_a_function_anew():
    @compiled.inner
    def raised(x, power):
        return x**power

    @njit
    def both(x):
        return raised(x, 2) + raised(x, 3) + raised(x, int(x))

    assert both(2.0) == 16.0
    assert len(raised.dispatcher.signatures) == 1


def test_an_array_that_is_not_aligned_is_read_and_written():
    low, high = (np.frombuffer(bytearray(8 * 1 + 1), np.uint8)[1:].view(float) for _ in range(2))
    values = np.frombuffer(bytes(1) + np.arange(5.0).tobytes(), np.uint8)[1:].view(float)
    assert not any(array.flags.aligned for array in (values, low, high))
    block_extremes(values, low, high)
    assert (low[0], high[0]) == (0.0, 4.0)


def test_an_array_with_gaps_and_another_type_are_refused():
    with pytest.raises(TypeError, match="contiguous"):
        block_extremes(np.arange(8.0)[::2], *np.zeros((2, 1)))
    with pytest.raises(TypeError, match="cannot take a str"):
        block_extremes("values", *np.zeros((2, 1)))
