"""Damaged files: each is refused with one sentence, or gives a motion with the file's components and step.

Any other motion comes with a warning. The files are written here, in each format, from one wave; then they
are cut, mixed up and overwritten.
"""

import io
import re
import time
import warnings

import numpy as np
import pytest
from damage import damaged, odd_spellings
from hypothesis import given, settings
from hypothesis import strategies as st

from record_files import asa, at2, block, cosmos, csmip_channel, esm, jma, knet, knet_csv
from stayput.errors import LONGEST_SENTENCE, InputError, warnings_to
from stayput.motion.readers import read_motion
from stayput.motion.record import Motion

pytestmark = pytest.mark.hostile

N = 96
WAVE = np.round(200.0 * np.sin(np.arange(N) * 0.37) * np.exp(-np.arange(N) / 60.0), 3)  # gal, or g/1000


KNET_COUNTS = np.round(WAVE * 1000).astype(int) + 12345


def csmip():
    integers = "".join(f"{i:5d}" for i in (1, 1, 1, 3, 3, *[0] * 11)) + "\n"
    channels = ((1, "360 DEG", WAVE), (2, "UP", WAVE / 2), (3, " 90 DEG", -WAVE))
    text = "".join(csmip_channel(*channel, integers=integers) for channel in channels)
    return text.replace(".020 SEC", ".010 SEC")


def columns():
    return "# t, x, y, z\n" + "".join(
        f"{i / 100:.2f} {a:.3f} {-a:.3f} {a / 2:.3f}\n" for i, a in enumerate(WAVE)
    )


def ordered():
    """Columns whose order a comment states, the vertical first."""
    head = "#AmplitudeUnit:  gal. DCoffset(corr)\n#DataSequence: Time U(+); N(+); E(+)\n#Data: 4F10.3\n"
    return head + "".join(f"{i / 100:.2f} {a / 2:.3f} {a:.3f} {-a:.3f}\n" for i, a in enumerate(WAVE))


def titled():
    """Columns of quoted cells below titles, headings and a row of units."""
    head = 'Quake of May\nStation: T1\n"Time","NS","EW","UD"\n"(s)","(gal)","(gal)","(gal)"\n'
    return head + "".join(f'"{i / 100:.2f}","{a:.3f}","{-a:.3f}","{a / 2:.3f}"\n' for i, a in enumerate(WAVE))


def counted():
    """One column below the number of its samples and the time step."""
    return f"Quake of May\n{N} 0.01\n" + block(WAVE, "%.3f", 1)


def in_rows():
    """One channel in rows of five, below words that state its number of samples and its time step."""
    head = f"001XYZ\nCOMP. NS\nUNIT: GAL\nNO. OF POINTS: {N}  EQUALLY SPACED INTERVALS OF: 0.01 SEC\n"
    return head + block(WAVE, "%10.3f", 5)


def without_time():
    """Columns of directions alone below a number of samples and a time step."""
    head = f"NUMBER OF DATA: {N}\nSAMPLING INTERVAL (sec): 0.01\nRAW PGA VALUES (gal): 1 2 3\nN-S E-W U-D\n"
    return head + "".join(f"{a:.3f} {-a:.3f} {a / 2:.3f}\n" for a in WAVE)


ESM = esm(WAVE, SAMPLING_INTERVAL_S="0.01", DURATION_S="0.96", STREAM="HNN")
FORMATS = {
    name: text.encode("cp932")
    for name, text in {
        "peer": at2(f"NPTS= {N:5d}, DT= .01000 SEC", "QUAKE 1/2/99, PLACE, 090", values=WAVE / 1000),
        "jma": jma(rows=[(a, -a, a / 2) for a in WAVE]),
        "knet": knet(
            counts=KNET_COUNTS,
            peak=np.abs(KNET_COUNTS - KNET_COUNTS.mean()).max() / 1000,
            seconds=0.96,
            scale="1000(gal)/1000000",
        ),
        "knet_csv": knet_csv(rows=[(a, -a, a / 2) for a in WAVE]),
        "esm": ESM,
        "csmip": csmip(),
        "cosmos": cosmos(WAVE, interval=10.0),
        "asa": asa([(a, -a, a / 2) for a in WAVE]),
        "columns": columns(),
        "ordered": ordered(),
        "titled": titled(),
        "counted": counted(),
        "in_rows": in_rows(),
        "without_time": without_time(),
        "swapped_case": ESM.lower().replace(": ", " : "),  # small letters, wider spacing
    }.items()
}
UNITS = {"columns": "gal", "counted": "gal"}
UNCOUNTED = {
    "jma",
    "knet_csv",
    "columns",
    "ordered",
    "titled",
}  # they do not state how many samples they have


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    return tmp_path_factory.mktemp("hostile") / "record"


def _read(file, name, content, told=None) -> Motion | None:
    """Read a file; append what is told of it, and return None where it is refused."""
    file.write_bytes(content)
    heard = [] if told is None else told
    start = time.process_time()
    try:
        with warnings_to(lambda warning: heard.append(str(warning))):
            motion = read_motion(file, unit=UNITS.get(name))
    except InputError as error:
        heard.append(str(error))
        motion = None
    assert time.process_time() - start < 2.0
    for sentence in heard:
        assert sentence.endswith(".")
        assert "\n" not in sentence.strip()
        assert len(sentence) <= LONGEST_SENTENCE
    if motion is None:
        return None
    for values in motion.components.values():
        assert np.isfinite(values).all()
        assert len(values) == len(motion) >= 2
    assert 0.0 < motion.dt <= 1.0
    return motion


hostile = settings(max_examples=max(60, settings.default.max_examples))
each_format = pytest.mark.parametrize("name", FORMATS)


@each_format
def test_the_undamaged_file_is_the_wave(name, file):
    motion = _read(file, name, FORMATS[name])
    assert motion is not None
    size = 9.80665e-3 if name == "peer" else 0.01
    wave = WAVE - WAVE.mean() if name == "knet" else WAVE
    assert motion.x == pytest.approx(size * wave, abs=2e-5)
    assert motion.dt == pytest.approx(0.01)
    if len(motion.components) == 3:
        assert motion.y == pytest.approx(-motion.x)
        assert motion.z == pytest.approx(motion.x / 2, abs=1e-5)


@each_format
@hostile
@given(data=st.data())
def test_truncated_anywhere(name, file, data):
    content = FORMATS[name]
    motion = _read(file, name, content[: data.draw(st.integers(0, len(content) - 1))])
    if motion is None:
        return
    whole = _read(file, name, content)
    assert whole is not None
    if name not in UNCOUNTED:
        assert len(motion) == len(whole)
    last = len(motion) - 1  # the last number may have lost digits where nothing tells how many it had
    for key, values in motion.components.items():
        difference = values[:last] - whole.components[key][:last]
        if name == "knet":  # whose offset, the mean, moves with the last number
            difference = np.diff(difference)
        assert np.abs(difference).max(initial=0.0) < 1e-12


ONCE = {  # the time step, where a format states it once: nothing else tells that another number is wrong
    "peer": r"DT= (\.01000)",
    "jma": r"RATE= (100)Hz",
    "cosmos": r"-999\.000000 +(10\.000000)",
    "counted": r"96 (0\.01)",
    "in_rows": r"OF: (0\.01)",
    "without_time": r"\(sec\): (0\.01)",
}


@each_format
@hostile
@given(data=st.data())
def test_one_piece_of_damage(name, file, data):
    text = FORMATS[name].decode("cp932")
    whole = _read(file, name, FORMATS[name])
    assert whole is not None
    spared = tuple(m.span(1) for m in re.finditer(ONCE[name], text)) if name in ONCE else ()
    told: list[str] = []
    motion = _read(file, name, data.draw(damaged(text, spared)).encode("cp932", "replace"), told)
    if motion is not None and not told:
        assert motion.dt == pytest.approx(whole.dt, rel=1e-12)
        assert motion.components.keys() == whole.components.keys()


@pytest.mark.parametrize("name", ONCE)
@hostile
@given(data=st.data())
def test_the_time_step_in_odd_spellings(name, file, data):
    text = FORMATS[name].decode("cp932")
    found = re.search(ONCE[name], text)
    assert found is not None
    other = data.draw(st.sampled_from(odd_spellings(found[1])))
    motion = _read(
        file, name, (text[: found.start(1)] + other + text[found.end(1) :]).encode("cp932", "replace")
    )
    if motion is not None:
        assert other.isascii()
        assert motion.dt == pytest.approx(0.01, rel=1e-12)


@each_format
@hostile
@given(data=st.data())
def test_bytes_overwritten(name, file, data):
    content = bytearray(FORMATS[name])
    for _ in range(data.draw(st.integers(1, 8))):
        content[data.draw(st.integers(0, len(content) - 1))] = data.draw(st.integers(0, 255))
    _read(file, name, bytes(content))


@each_format
@hostile
@given(data=st.data())
def test_lines_swapped_dropped_and_doubled(name, file, data):
    lines = FORMATS[name].split(b"\n")
    for _ in range(data.draw(st.integers(1, 3))):
        place = st.integers(0, len(lines) - 1)
        i, j = data.draw(place), data.draw(place)
        what = data.draw(st.sampled_from(["swap", "drop", "double"]))
        if what == "swap":
            lines[i], lines[j] = lines[j], lines[i]
        elif what == "drop":
            lines = lines[:i] + lines[i + 1 :] or [b""]
        else:
            lines.insert(j, lines[i])
    _read(file, name, b"\n".join(lines))


BAD = ["nan", "NaN", "inf", "-Infinity", "1e999", "*****", "1_0", "0x1F", "1,5", "--1", "1.2.3", "", "\u0663"]


@each_format
@hostile
@given(data=st.data())
def test_a_sample_that_is_no_number_is_refused(name, file, data):
    text = FORMATS[name].decode("cp932")
    places = list(re.finditer(r"-?[0-9.]+(?:E[+-][0-9]+)?", text, re.IGNORECASE))
    last = {"csmip": "END OF DATA", "cosmos": "End-of-data"}.get(name)
    end = text.rindex(last) if last else len(text)
    begin = text.index(_first(name)) + len(_first(name))
    samples = [m for m in places if m.start() >= begin and m.end() <= end]
    if name == "csmip":  # velocities and displacements are not read
        samples = samples[: N - 1]
    if name == "knet_csv":  # nor are the dates
        samples = [m for m in samples if text[m.start() - 1] == ","]
    found = data.draw(st.sampled_from(samples))
    bad = data.draw(st.sampled_from([b for b in BAD if b not in {"", "1,5", "--1"}]))
    field = bad.rjust(found.end() - found.start())
    assert _read(file, name, (text[: found.start()] + field + text[found.end() :]).encode()) is None


def _first(name):
    """Return the text after which only samples (and times) stand."""
    return {
        "peer": " SEC\n",
        "jma": "NS,EW,UD",
        "knet": "Memo.",
        "knet_csv": "EW,UD",
        "esm": "in it\n",
        "csmip": "(UNITS: CM/SEC/SEC)",
        "cosmos": "Format=(8F10.3)",
        "asa": " V;+\n",
        "columns": "y, z",
        "ordered": "4F10.3",
        "titled": '"(gal)"\n',
        "counted": "0.01\n",
        "in_rows": " SEC\n",
        "without_time": "U-D\n",
        "swapped_case": "in it\n",
    }[name]


@hostile
@given(content=st.binary(max_size=300))
def test_any_bytes(file, content):
    _read(file, "columns", content)


HEADS = [
    "",
    "#DataSequence: Time U(+); N(+)\n",
    "Component: UD\nTime,NS,EW\ns,gal,gal\n",
    "9 0.01\n",
    "time [ms],NS [gal],EW [m/s2],UD [g]\n",
    "# t; NS (gal); EW (cm/s); UD (mm)\n",
    "NPTS= 3, DT= .01\n",
    "SITE CODE= 1\nSAMPLING RATE= 100Hz\nNS,EW,UD\n",
    "Origin Time\nScale Factor\n",
    "#Offset(gal),1,2,3\n",
    "EVENT: x\nNDATA: 3\nSAMPLING_INTERVAL_S: 0.01\nDATA_TYPE: ACCELERATION\n",
    "9 POINTS OF ACCEL DATA EQUALLY SPACED AT .01 SEC (UNITS: G)\n",
    "Corrected (Format v01.20 with 13 text lines)\n",
]


@hostile
@given(
    content=st.text(alphabet="0123456789.,-+eE \t\n#;:=()NPTSDTGunitsgal/^é加", max_size=400),
    head=st.sampled_from(HEADS),
)
def test_any_text_after_any_head(file, content, head):
    _read(file, "columns", (head + content).encode())


@given(
    form=st.sampled_from(["MSEED", "SAC"]),
    places=st.lists(st.tuples(st.integers(0, 10**6), st.integers(0, 255)), min_size=1, max_size=8),
    kept=st.floats(0.0, 1.0) | st.just(1.0),
)
def test_damaged_seismograms_are_read_or_refused(file, form, places, kept):
    obspy = pytest.importorskip("obspy", reason="ObsPy is not installed")
    written = io.BytesIO()
    trace = obspy.Trace((100.0 * WAVE).astype(np.int32), {"station": "T", "channel": "HNE", "delta": 0.01})
    trace.write(written, format=form)
    content = bytearray(written.getvalue())
    for place, byte in places:
        content[place % len(content)] = byte
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        _read(file, "columns", bytes(content[: max(1, round(kept * len(content)))]))
