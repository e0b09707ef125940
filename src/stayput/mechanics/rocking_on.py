"""The commonest event: a body that rocks lands on its other base corner, and rocks on about that.

More than half of all events are of this kind. Here the impact and the choice of the mode are those of
`impact` and `modes`, for the one pattern that nearly always is the consistent one: the corner that lands
presses and sticks, the other lifts. Where that is not clearly so, those decide.
"""

from __future__ import annotations

from stayput.compiled import inner
from stayput.mechanics.columns import FLOOR_BITS, STICK
from stayput.mechanics.contact import STUCK
from stayput.mechanics.fulcrum import NEAR_LIMIT, margins
from stayput.mechanics.geometry import arm, gap_rate, slip_rate
from stayput.mechanics.impact import damp_change_of_fulcrum, stop
from stayput.mechanics.modes import pivot_on


@inner
def rocks_on(contacts, touch, case, s, a, G):
    """Carry out such an event under the loads (a, G), if it is one; whether it was.

    The body rocked on one base corner and sticks with the other, just landed; it touches nothing else. A
    landing that bounces, slips or ends the rocking, and a force near its limit, are for the general case.
    """
    if s.kind != STICK or touch != FLOOR_BITS or s.hit | s.closed != FLOOR_BITS or s.hit == s.closed:
        return False
    new, old = s.hit - 1, s.closed - 1  # contacts 0 and 1 have the bits 1 and 2
    con = contacts[new]
    if con.restitution > 0.0 or abs(slip_rate(con, s)) > STUCK:
        return False
    before = s.vx, s.vz, s.omega
    ok, s.vx, s.vz, s.omega = stop(contacts, new, case.inertia, s)
    if ok and case.restitution < 1.0:
        damp_change_of_fulcrum(contacts, new, case, s)
    if ok and gap_rate(contacts[old], s) > s.settle:
        sigma, kappa = arm(con, s)
        q = -1.0 / (case.inertia + sigma * sigma + kappa * kappa)
        law = (True, case.inertia, q, con.mu_static, 0.0, 1.0)
        f, g, alpha = margins(law, sigma, kappa, s.omega, a, G, 0.0)
        if min(f, g) > NEAR_LIMIT * case.gravity:
            s.i, s.d, s.j, s.dj, s.closed, s.alpha = new, 0, -1, 0, s.hit, alpha
            pivot_on(con, s)
            return True
    s.vx, s.vz, s.omega = before
    return False
