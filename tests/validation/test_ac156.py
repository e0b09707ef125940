"""ICC-ES AC156 with ASCE 7-16 and 7-22, as in public code: ordinates, and motions that meet them."""

import numpy as np
import pytest

import stayput as sp

G = 9.80665


@pytest.mark.parametrize(
    ("edition", "height_ratio", "flexible", "rigid"),
    [
        ("7-16", 0.0, 1.0, 0.4),
        ("7-16", 0.25, 1.5, 0.6),
        ("7-16", 1.0, 1.6, 1.2),
        ("7-22", 0.0, 1.0, 0.4),
        ("7-22", 0.2, 1.5 / 1.3, 0.6 / 1.3),
        ("7-22", 1.0, 1.6, 0.4 * 3.5 / 1.3),
    ],
)
def test_amplification_over_height(edition, height_ratio, flexible, rigid):
    for sds in (0.5, 1.0, 2.0):
        required = sp.ac156(sds, height_ratio, edition)
        assert required.flexible == pytest.approx(sds * flexible)
        assert required.rigid == pytest.approx(sds * rigid)


def test_ordinates():
    required = sp.ac156(1.0, 0.5)
    at = {0.1: 0.160, 1.0: 0.7902 * 1.6, 1.3: 1.6, 5.0: 1.6, 8.3: 1.6, 33.3: 0.8, 50.0: 0.8}
    for frequency, value in at.items():
        assert required.horizontal(1.0 / frequency) / G == pytest.approx(value, rel=2e-3)
    middle = np.sqrt(8.3 * 33.3)
    assert required.horizontal(1.0 / middle) / G == pytest.approx(np.sqrt(1.6 * 0.8), rel=1e-4)
    for height_ratio in (0.0, 1.0):  # the vertical one is the ground's at every height
        vertical = sp.ac156(1.0, height_ratio).vertical
        assert vertical(0.2) / G == pytest.approx(0.67)
        assert vertical(1.0 / 33.3) / G == pytest.approx(0.27)


@pytest.mark.parametrize("required", [sp.ac156(1.0, 0.0), sp.ac156(0.5, 1.0, "7-22")], ids=lambda r: r.name)
@pytest.mark.parametrize("lowest", [None, 0.2])
def test_a_matched_motion_meets_the_spectrum(required, lowest):
    """Each component is within 6 % of it on average and within 30 % at every period of the band."""
    motion = sp.ac156_motion(required, lowest=lowest)
    periods = np.geomspace(1.0 / 33.3, 1.0 / (lowest or 1.3), 80)
    for component, target in (
        ("x", required.horizontal),
        ("y", required.horizontal),
        ("z", required.vertical),
    ):
        ratio = motion.spectrum(periods, component=component).sa / target(periods)
        assert np.abs(ratio - 1.0).mean() < 0.06
        assert np.abs(ratio - 1.0).max() < 0.30
    assert abs(motion.component("x").velocity[-1]) < 1e-9


def test_below_the_cut_off_a_motion_asks_for_little():
    required = sp.ac156(1.0)
    motion = sp.ac156_motion(required)
    ratio = motion.spectrum([2.0, 4.0]).sa / required.horizontal([2.0, 4.0])
    assert ratio[0] < 0.4
    assert ratio[1] < 0.2


def test_motions_are_independent_and_the_same_again():
    required = sp.ac156(1.0)
    first, second = (sp.ac156_motion(required, number) for number in (1, 2))
    assert first == sp.ac156_motion(required, 1)
    for a, b in ((first.x, second.x), (first.x, first.y), (first.x, first.z)):
        assert abs(np.corrcoef(a, b)[0, 1]) < 0.15


@pytest.mark.parametrize(
    ("arguments", "words"), [((0.0,), "SDS"), ((1.0, 1.5), "height_ratio"), ((1.0, 0.5, "7-10"), "edition")]
)
def test_refusals(arguments, words):
    with pytest.raises(sp.InputError, match=words):
        sp.ac156(*arguments)


def test_a_motion_s_number_and_band_are_checked():
    with pytest.raises(sp.InputError, match="lowest is 10 Hz"):
        sp.ac156_motion(sp.ac156(1.0), lowest=10.0)
    with pytest.raises(sp.InputError):
        sp.ac156_motion(sp.ac156(1.0), 0)
