"""Published records, processed and raw: none has an offset, and each has one with a tenth of its peak."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

import stayput as sp
from real_records import MOTIONS, recorded
from stayput.motion.processing import oscillates_about_offset

RECORDS = {
    "elcentro_1940_180.AT2": {},
    "jma_kobe_1995_ns.AT2": {},
    "jma_uki_2016.csv": {},
    "jma_yonago_2000.csv": {},
    "hachinohe_1968_ns_gal_dt0.01.txt": {"unit": "gal", "dt": 0.01},
    "market575_1989_floor42_gal_dt0.01.csv": {"unit": "gal"},
    "csmip_ce36456.V2": {},
    "nishi_akashi_1995_090.AT2": {},
}
pytestmark = recorded


@pytest.mark.parametrize("name", RECORDS)
def test_a_published_record_is_none_and_is_one_with_an_offset(name):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        motion = sp.read_motion(MOTIONS / name, **RECORDS[name])
    assert not {"motion.offset", "motion.long_step"} & {one.message.code for one in caught}
    for component, a in motion.components.items():
        assert not oscillates_about_offset(a, motion.dt), component
        peak = float(np.abs(a).max())
        for share in (0.1, -0.1):
            assert oscillates_about_offset(a + share * peak, motion.dt), component
