"""A wall that gives, beside two masses that are stepped in time: the piece, and the panel on its spring."""

import itertools

import numba
import pytest

from studies.baseline import panel_restitution


@numba.njit
def returned(panel: float, damping: float, local: float, dt: float) -> float:
    """Return the speed at which a unit mass leaves a panel that it hits at speed 1; the panel swings at 1/s.

    Each contact has Newton's restitution ``local``; where the masses touch without approaching, they move
    together as long as they press on each other.
    """
    x, v, y, w = 0.0, 1.0, 0.0, 0.0
    together, last = False, 0.0
    t = 0.0
    while t - last < 20.0:  # three periods of the panel without another contact
        a = -(panel * y + 2.0 * damping * panel * w) / (1.0 + panel if together else panel)
        if together and a > 0.0:
            together = False
            continue
        w += a * dt
        y += w * dt
        if together:
            x, v, last = y, w, t
        else:
            x += v * dt
            if x >= y and v >= w:
                x, last = y, t
                common, closing = (v + panel * w) / (1.0 + panel), v - w
                together = closing * local < 1e-4
                apart = 0.0 if together else local * closing / (1.0 + panel)
                v, w = common - panel * apart, common + apart
        t += dt
    return -v


CASES = list(itertools.product((0.1, 0.3, 0.6, 1.0, 1.5), (0.02, 0.05, 0.1)))


@pytest.mark.parametrize(("panel", "damping"), CASES)
def test_two_masses_that_stay_together(panel: float, damping: float) -> None:
    law = panel_restitution(1.0, panel, damping)
    assert returned(panel, damping, 0.0, 1e-5) == pytest.approx(law, abs=1e-4)


@pytest.mark.parametrize(("panel", "damping"), CASES)
def test_how_they_meet_hardly_matters(panel: float, damping: float) -> None:
    """Gypsum board returns 0.2 to 0.4 by itself; the whole wall returns what its mode does, within 0.09."""
    law = panel_restitution(1.0, panel, damping)
    for local in (0.2, 0.3, 0.4):
        assert returned(panel, damping, local, 1e-5) == pytest.approx(law, abs=0.09)


def test_a_wall_of_studs_under_furniture_of_a_home() -> None:
    """One or two studs with their boards, 22 kg each at 1.8 m, and pieces of 36 to 70 kg effective mass."""
    found = [panel_restitution(m, M, 0.05) for m in (36.0, 70.0) for M in (22.0, 44.0)]
    assert min(found) == pytest.approx(0.40, abs=0.01)
    assert max(found) == pytest.approx(0.71, abs=0.01)
