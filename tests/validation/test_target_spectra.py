"""Target spectra against the numbers that their formulas give by hand, and suites that meet them.

Japan: notification 1457 of the Ministry of Construction (2000); ASCE/SEI 7-16, section 11.4.6; both as they
are commonly known.
"""

import numpy as np
import pytest

from real_records import MOTIONS, recorded
from stayput.errors import InputError
from stayput.motion.processing import displacement, velocity
from stayput.motion.response import mean_period
from stayput.motion.suites.suite import Suite, read_suite
from stayput.motion.suites.synthesis import synthetic_suite
from stayput.motion.suites.target import TargetSpectrum, asce7, japanese_design, read_target

KOBE = ("jma_kobe_1995_ns.AT2", "jma_kobe_1995_ew.AT2", "nishi_akashi_1995_090.AT2")
OTHERS = ("elcentro_1940_180.AT2", "arleta_1994_360.at2", "jma_uki_2016.csv")

G = 9.80665
BAND = (0.1, 5.0)
DENSE = np.geomspace(*BAND, 137)  # periods that the matching does not use


@pytest.mark.parametrize(
    ("soil", "points"),
    [  # period [s], Sa [m/s²] by hand
        (1, {0.1: 6.2 * 1.5, 0.3: 12.0, 0.6: 8.0 * 0.864 / 0.6, 1.0: 5.12 * 1.35, 4.0: 1.28 * 1.35}),
        (2, {0.1: 9.3, 0.3: 12.0, 0.8: 5.12 / 0.8 * 1.5 * 0.8 / 0.64, 1.0: 5.12 * 2.03, 5.0: 1.024 * 2.03}),
        (3, {0.1: 9.3, 0.7: 12.0, 1.0: 12.0, 1.152: 12.0, 2.0: 2.56 * 2.7}),
    ],
)
def test_the_japanese_spectrum_has_the_values_by_hand(soil, points):
    target = japanese_design("very rare", soil)
    for period, sa in points.items():
        assert target([period])[0] == pytest.approx(sa, rel=2e-4)  # log-log between the table's points
        assert japanese_design("rare", soil)([period])[0] == pytest.approx(sa / 5.0, rel=2e-4)


def test_the_asce_spectrum_has_its_corners():
    target = asce7(sds=1.0, sd1=0.6, tl=8.0)
    t0, ts = 0.12, 0.6
    found = target([0.01, t0, 0.3, ts, 1.2, 8.0, 10.0]) / G
    by_hand = [0.4 + 0.6 * 0.01 / t0, 1.0, 1.0, 1.0, 0.5, 0.075, 0.6 * 8.0 / 100.0]
    assert found == pytest.approx(by_hand, rel=1e-6)


def test_a_table_is_read_and_is_log_log_linear(tmp_path):
    file = tmp_path / "sa.csv"
    file.write_text("# period [s], Sa [g]\n0.1, 0.5\n1.0; 0.5\n10 0.05\n")
    target = read_target(file)
    assert target([0.3, 1.0, np.sqrt(10.0)]) == pytest.approx([0.5 * G, 0.5 * G, 0.05 * np.sqrt(10.0) * G])
    assert read_target(file, "gal")([1.0]) == pytest.approx([0.005])
    with pytest.raises(InputError, match=r"0\.1"):
        target([0.05])


@pytest.mark.parametrize(
    "text", ["0.1 0.5\n", "0.1 0.5\n0.1 0.6\n", "0.1 x\n1 1\n", "0.1 0.5 3\n", "0.1 -1\n1 1\n"]
)
def test_a_bad_table_is_refused_by_name(tmp_path, text):
    file = tmp_path / "bad.csv"
    file.write_text(text)
    with pytest.raises(InputError, match=r"bad\.csv"):
        read_target(file)


@pytest.mark.parametrize(
    "call",
    [
        lambda: japanese_design("common"),
        lambda: japanese_design(soil=4),
        lambda: asce7(1.0, 20.0),
        lambda: asce7(-1.0, 0.5),
        lambda: asce7(0.1, 1.0, 5.0),
        lambda: TargetSpectrum([0.1, 1.0], [1.0]),
    ],
)
def test_nonsense_is_refused(call):
    with pytest.raises(InputError):
        call()


@pytest.mark.parametrize("target", [japanese_design(), asce7(1.0, 0.6)], ids=["Japan", "ASCE 7"])
@pytest.mark.parametrize("family", ["near-fault", "crustal"])
def test_a_matched_suite_meets_the_target_in_the_mean_and_each_motion_does(target, family):
    suite = synthetic_suite(family, 5, target=target)
    for component in "xy":
        mean = suite.median(DENSE, component=component) / target(DENSE)
        assert np.abs(mean - 1.0).mean() < 0.03
        assert np.abs(mean - 1.0).max() < 0.10
        each = suite.spectra(DENSE, component=component) / target(DENSE)
        assert np.abs(each - 1.0).mean(axis=1).max() < 0.10
    assert suite.deviation(target).mean < 0.03
    assert suite.log_std(DENSE).max() < 0.2


def test_a_suite_that_is_matched_together_keeps_its_variability():
    target = japanese_design()
    suite = synthetic_suite("crustal", 8, target=target, together=True)
    for component in "xy":
        mean = suite.median(DENSE, component=component) / target(DENSE)
        assert np.abs(mean - 1.0).mean() < 0.03
        assert np.abs(mean - 1.0).max() < 0.10
    free = synthetic_suite("crustal", 8).to_spectrum(target)
    assert suite.log_std(DENSE).mean() == pytest.approx(free.log_std(DENSE).mean(), rel=0.15)


def test_matched_motions_are_synthetic_at_rest_and_keep_their_envelope():
    target = japanese_design("rare", 1)
    before = synthetic_suite("crustal", 3)
    for old, new in zip(before, before.matched(target), strict=True):
        assert new.synthetic
        assert target.name in new.source
        for a in new.components.values():
            assert abs(velocity(a, new.dt)[-1]) < 1e-12
            assert abs(displacement(a, new.dt)[-1]) < 1e-10
        pad = round(0.5 * (new.duration - old.duration) / new.dt)
        assert pad * new.dt == pytest.approx(2.0 * BAND[1])
        strength = [np.convolve(a**2, np.ones(500), "valid") for a in (old.x, new.x[pad:-pad])]
        assert np.corrcoef(*np.sqrt(strength))[0, 1] > 0.9


def test_the_bits_of_a_matched_suite_do_not_depend_on_threads():
    from stayput.motion.suites.target import matched

    target, motions = japanese_design(), list(synthetic_suite("near-fault", 3))
    for together in (False, True):
        one, many = (matched(motions, target, (0.2, 2.0), together=together, threads=n) for n in (1, 3))
        assert one == many


def test_a_record_of_one_component_is_matched_too():
    motion = synthetic_suite("crustal", 1)[0].component("x")
    suite = Suite((motion,)).matched(asce7(0.5, 0.3))
    assert list(suite[0].components) == ["x"]
    assert suite.deviation(asce7(0.5, 0.3)).mean < 0.05


@recorded
def test_the_records_of_kobe_lie_inside_the_near_fault_suite():
    suite = synthetic_suite("near-fault", 40)
    for record in read_suite([MOTIONS / name for name in KOBE[:2]]):
        for measure in (_duration, _mean_period, _velocity_ratio):
            values = [measure(motion) for motion in suite]
            assert min(values) < measure(record) < max(values)


def _duration(motion):
    return motion.significant_duration


def _mean_period(motion):
    return mean_period(motion.x, motion.dt)


def _velocity_ratio(motion):
    return motion.pgv / motion.pga


@recorded
def test_records_are_selected_scaled_and_matched():
    target = japanese_design()
    records = read_suite([MOTIONS / name for name in (*KOBE, *OTHERS)])
    assert not records.synthetic
    chosen = records.selected(target, 3)
    assert {motion.name for motion in chosen} < {motion.name for motion in records}
    misfit = [np.std(np.log(s / target(DENSE))) for s in chosen.spectra(DENSE)]
    assert misfit == sorted(misfit)
    scaled = records.to_spectrum(target)
    assert scaled.deviation(target).mean < records.deviation(target).mean
    matched = records.matched(target)
    assert matched.synthetic
    assert matched.deviation(target).mean < 0.05
    assert matched.deviation(target).worst < 0.10
