"""Two stacked boxes whose upper one is tied to the wall or joined to the lower one, beside statics by hand.

The floor's acceleration rises slowly to a, so that all is nearly at rest. About its front lower edge the
upper box of mass m, depth b and height h is turned by m a h/2 and held by m g b/2. What holds it as well has
the arm h (a level belt at its top) or b (connectors at its back edge):

    belt:        h F = m a h/2 − m g b/2
    connectors:  b T = m a h/2 − m g b/2
"""

from __future__ import annotations

import numpy as np
import pytest

import stayput as sp
from stayput.measures import Belt

G = 9.80665
A, B, H, M = 5.0, 0.4, 1.0, 40.0
MOMENT = 0.5 * M * (A * H - G * B)
PULL, LIFT = MOMENT / H, MOMENT / B
LOWER, UPPER = sp.Body(0.8, 1.0, 200.0, length=0.9), sp.Body(B, H, M, length=0.9)
ROOM = sp.Room(sp.Floor(2.0, 2.0), left_wall=sp.Wall(0.3))


def rising() -> sp.Motion:
    """Return a floor that is pushed to where the wall is, by an acceleration that rises for 6 s."""
    time = np.arange(0.0, 9.0, 0.01)
    return sp.Motion(dt=0.01, x=-A * np.clip(time / 6.0, 0.0, 1.0), name="rising")


def run(belts: tuple[Belt, ...] = (), joints: tuple[sp.Joint, ...] = ()) -> sp.Run:
    pieces = [sp.Piece(LOWER), sp.Piece(UPPER, at=(0.0, 0.0, 1.0), measures=belts)]
    return sp.simulate(sp.Scene(pieces, ROOM, friction=(2.0, 2.0), joints=joints), rising())


def belts(strength: float) -> Belt:
    return Belt(slack=0.0, angle=0.0, stiffness=1e6, strength=strength / 2, ultimate=0.0)


def connectors(strength: float) -> tuple[sp.Joint, ...]:
    return tuple(sp.Joint(1, 0, (-B / 2, y, 1.0), strength=strength / 2) for y in (-0.4, 0.4))


def test_without_anything_it_falls() -> None:
    assert run()[1].overturned


@pytest.mark.parametrize(("strong", "holds"), [(0.95, False), (1.05, True)])
def test_belts_to_the_wall(strong: float, holds: bool) -> None:
    found = run(belts=(belts(strong * PULL),))
    assert [device.member for device in found.devices] == [1, 1]
    assert all(device.failed != holds for device in found.devices)
    assert bool(found[1].overturned) != holds
    if holds:
        assert sum(device.peak_pull for device in found.devices) == pytest.approx(PULL, rel=0.02)


@pytest.mark.parametrize(("strong", "holds"), [(0.95, False), (1.05, True)])
def test_connectors_to_the_lower_box(strong: float, holds: bool) -> None:
    found = run(joints=connectors(strong * LIFT))
    assert all(device.failed != holds for device in found.devices)
    assert bool(found[1].overturned) != holds
    if holds:
        assert sum(device.peak_pull for device in found.devices) == pytest.approx(LIFT, rel=0.02)


def test_joined_pieces_are_held_together_by_belts_on_the_upper_one() -> None:
    """Tied to the wall at the top and joined below, the boxes share the load: neither needs its whole."""
    found = run((belts(0.95 * PULL),), connectors(0.95 * LIFT))
    assert not any(piece.overturned for piece in found.pieces)
    assert not any(device.failed for device in found.devices)
