"""`Suite`, `synthetic_suite` and `read_suite`: what they hold, how they scale, what they refuse."""

from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from stayput.errors import InputError
from stayput.motion.record import Motion
from stayput.motion.suites import synthesis
from stayput.motion.suites.families import FAMILIES, MIX
from stayput.motion.suites.suite import Suite, read_suite
from stayput.motion.suites.synthesis import synthetic_motion, synthetic_suite
from stayput.motion.suites.target import TargetSpectrum, japanese_design
from stayput.motion.synthetic import near_fault, sine
from stayput.report.spectra import plot_suite, suite_title

PERIODS = np.array([0.1, 0.3, 1.0, 3.0])
FLAT = TargetSpectrum([0.05, 10.0], [5.0, 5.0], "flat")


@pytest.fixture(scope="module")
def small() -> Suite:
    return synthetic_suite("crustal", 4)


def test_a_suite_is_a_sequence_of_motions(small):
    assert len(small) == 4
    assert [motion.name for motion in small] == [f"synthetic crustal {n}" for n in (1, 2, 3, 4)]
    assert isinstance(small[1:3], Suite)
    assert small[1:3][0] is small[1]
    assert small[-1] in small
    assert small.synthetic
    assert small == Suite(list(small), small.name)


def test_every_motion_says_that_it_is_synthetic_and_what_was_drawn():
    for family in FAMILIES:
        motion = synthetic_motion(family, 3, seed=7)
        assert motion.synthetic
        assert motion.name.startswith("synthetic ")
        assert motion.name.endswith(" 3")
        for word in ("synthetic", "M ", "km", "MPa", "kappa", "seed 7", "residual displacement 0"):
            assert word in motion.source
        assert list(motion.components) == ["x", "y", "z"]
        assert motion.dt == 0.01
    assert "pulse" in synthetic_motion("near-fault").source
    assert "basin waves" in synthetic_motion("basin").source


def test_a_mixed_suite_has_the_stated_shares_and_begins_like_a_longer_one():
    suite = synthetic_suite(count=40)
    label = {"basin": "long-period basin"}
    for family, share in MIX.items():
        count = sum(m.name.startswith(f"synthetic {label.get(family, family)} ") for m in suite)
        assert count == pytest.approx(40 * share, abs=0.5)
    assert sum(MIX.values()) == pytest.approx(1.0)
    assert synthetic_suite(count=7).motions == suite.motions[:7]


def test_statistics_of_spectra_are_those_of_their_logarithms(small):
    sa = small.spectra(PERIODS)
    assert sa.shape == (4, 4)
    assert sa[2] == pytest.approx(small[2].spectrum(PERIODS).sa, rel=1e-15)
    assert small.median(PERIODS) == pytest.approx(np.exp(np.log(sa).mean(axis=0)))
    assert small.log_std(PERIODS) == pytest.approx(np.log(sa).std(axis=0, ddof=1))
    assert np.all(small.spectra(PERIODS, component="z") != sa)


def test_each_motion_reaches_the_intensity_exactly(small):
    for wanted, value in ((6.0, 6.0), ("6-upper", 6.25)):
        assert small.to_intensity(wanted).intensities == pytest.approx([value] * 4, abs=1e-9)


def test_scaling_to_a_spectrum_is_one_factor_a_motion_and_the_best_in_ln_sa(small):
    scaled = small.to_spectrum(FLAT, (0.2, 2.0))
    for before, after in zip(small, scaled, strict=True):
        k = after.x / np.where(before.x == 0.0, np.nan, before.x)
        assert np.nanmax(k) == pytest.approx(np.nanmin(k), rel=1e-12)
        assert after.z == pytest.approx(np.nanmedian(k) * before.z)
    periods = np.geomspace(0.2, 2.0, 31)
    off = np.log(FLAT(periods) / scaled.spectra(periods))
    assert off.mean(axis=1) == pytest.approx(np.zeros(4), abs=1e-12)


def test_selection_takes_the_nearest_shapes_whatever_their_strength(small):
    twin = TargetSpectrum(*_spectrum_of(small[2].scaled(7.0)), "twin")
    chosen = small.selected(twin, 2)
    assert chosen[0] is small[2]
    assert len(chosen) == 2


def _spectrum_of(motion: Motion):
    periods = np.geomspace(0.1, 5.0, 52)
    return periods, motion.spectrum(periods).sa


def test_a_folder_and_a_list_of_files_are_read(tmp_path, small):
    for n, motion in enumerate(small):
        rows = np.stack((motion.time, motion.x, motion.y, motion.z), axis=1)[:800]
        np.savetxt(tmp_path / f"r{n}.csv", rows, delimiter=",", fmt="%.8g")
    (tmp_path / "README.md").write_text("words")
    (tmp_path / ".hidden").write_text("words")
    read = read_suite(tmp_path, unit="m/s²")
    assert [motion.name for motion in read] == ["r0", "r1", "r2", "r3"]
    assert read.name == tmp_path.name
    assert not read.synthetic
    assert read[3].x == pytest.approx(small[3].x[:800], abs=1e-6)
    listed = read_suite([tmp_path / "r3.csv", tmp_path / "r0.csv"], unit="m/s²", name="two")
    assert (listed[0], listed.name) == (read[3], "two")
    (tmp_path / "r2.csv").write_text("0.0,1.0\n0.01,nan\n")
    with pytest.raises(InputError, match=r"r2\.csv"):
        read_suite(tmp_path, unit="m/s²")


def test_the_plot_is_written_with_and_without_a_target(tmp_path, small):
    figure = plot_suite(small, tmp_path / "suite.png", japanese_design(), title=suite_title(small, "en"))
    assert (tmp_path / "suite.png").stat().st_size > 10_000
    labels = [text.get_text() for text in figure.axes[0].get_legend().get_texts()]
    assert any(label.startswith("target") for label in labels)
    assert "synthetic" in figure.get_suptitle()
    assert small[:1].figure() is not None


@pytest.mark.parametrize(
    ("call", "told"),
    [
        (lambda: Suite(()), "motions is empty"),
        (lambda: Suite((1.0,)), "of type Motion"),
        (lambda: synthetic_suite("tsunami"), "near-fault"),
        (lambda: synthetic_motion("mixed"), "crustal"),
        (lambda: synthetic_suite(count=0), "between 1 and 1000"),
        (lambda: synthetic_suite(count=2.5), "whole"),
        (lambda: synthetic_suite(seed=-1), "-1"),
        (lambda: synthetic_motion("crustal", 0), "between 1 and"),
        (lambda: Suite((near_fault(),)).log_std(), "2 or more"),
        (lambda: Suite((near_fault(),)).selected(FLAT, 2), "between 1 and 1"),
        (lambda: Suite((near_fault(),)).to_spectrum(FLAT, (0.01, 1.0)), "0.05"),
        (lambda: Suite((near_fault(),)).to_spectrum(FLAT, (1.0, 1.0)), "between"),
        (lambda: Suite((sine(0.0, 1.0),)).to_spectrum(FLAT), "still"),
        (lambda: Suite((sine(0.0, 1.0),)).matched(FLAT), "still"),
        (lambda: read_suite("nowhere"), "nowhere"),
        (lambda: read_suite([]), "is empty"),
        (lambda: read_suite(["nowhere.csv"]), "nowhere.csv"),
    ],
)
def test_nonsense_is_refused_with_a_sentence(call, told):
    with pytest.raises(InputError, match=told):
        call()


def test_an_empty_folder_is_refused(tmp_path):
    with pytest.raises(InputError, match="is empty"):
        read_suite(tmp_path)


def test_a_motion_that_two_threads_ask_for_is_made_once_and_counted_by_its_bytes():
    before = synthesis._CACHE.currsize
    with ThreadPoolExecutor(4) as pool:
        suites = list(pool.map(lambda _: synthetic_suite("crustal", 1, seed=987), range(8)))
    assert all(suite == suites[0] for suite in suites)
    assert synthetic_suite("crustal", 1, seed=987)[0] is synthetic_suite("crustal", 1, seed=987)[0]
    added = sum(samples.nbytes for samples in suites[0][0].components.values())
    assert synthesis._CACHE.currsize == before + added <= synthesis.CACHE_SIZE
