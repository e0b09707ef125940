"""Columns in any order and in any units give the same motion, or are refused."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from stayput.errors import InputError, warnings_to
from stayput.motion.readers import read_motion
from stayput.motion.units import ACCELERATION_UNITS

SHAKING = {"NS": [0.0, 1.0, -2.0, 0.5], "EW": [0.25, -1.0, 1.5, 0.0], "UD": [0.0, 0.5, 0.25, -0.75]}
TIMES = {"time [s]": 1.0, "t": 1.0, "time_ms": 1e-3, "Zeit [ms]": 1e-3}
WRITTEN = ("{} [{}]", "{} ({})", "{}_{}", "{}[{}]")


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    return tmp_path_factory.mktemp("headings") / "record.csv"


def read(file, text, unit=None):
    file.write_text(text, encoding="utf-8")
    with warnings_to(lambda _warning: None):
        return read_motion(file, "NS", unit)


@given(
    order=st.permutations(["time", *SHAKING]),
    units=st.tuples(*[st.sampled_from(sorted(ACCELERATION_UNITS))] * 3),
    time=st.sampled_from(sorted(TIMES)),
    written=st.sampled_from(WRITTEN),
    given_unit=st.none() | st.sampled_from(sorted(ACCELERATION_UNITS)),
    mark=st.sampled_from([",", ";", "\t"]),
)
def test_headings_say_what_each_column_is(file, order, units, time, written, given_unit, mark):
    unit = dict(zip(SHAKING, units, strict=True))
    headings = {"time": time} | {name: written.format(name, unit[name]) for name in SHAKING}
    columns = {"time": [0.01 * i / TIMES[time] for i in range(4)]} | {
        name: [a / ACCELERATION_UNITS[unit[name]] for a in values] for name, values in SHAKING.items()
    }
    rows = [mark.join(repr(columns[name][i]) for name in order) for i in range(4)]
    text = "\n".join([mark.join(headings[name] for name in order), *rows, ""])
    sizes = {ACCELERATION_UNITS[name] for name in units}
    if given_unit is not None and sizes != {ACCELERATION_UNITS[given_unit]}:
        with pytest.raises(InputError, match="must be the one that the file states"):
            read(file, text, given_unit)
        return
    motion = read(file, text, given_unit)
    assert motion.dt == pytest.approx(0.01)
    for name, values in zip(SHAKING, (motion.x, motion.y, motion.z), strict=True):
        np.testing.assert_allclose(values, SHAKING[name], rtol=1e-12)
