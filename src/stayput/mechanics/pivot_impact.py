"""Fast path for the commonest impact: a rocking body lands on its other base corner and pivots about it.

More than half of all events are of this kind. Impact and mode selection are those of `impact` and `modes`,
restricted to the active set that nearly always is the consistent one: the landing corner sticks, the other
lifts. Where that is not clearly so, the general case decides.
"""

from __future__ import annotations

from stayput.compiling import inner
from stayput.mechanics.columns import FLOOR_BITS, ROCK
from stayput.mechanics.contact import STICK_RATE
from stayput.mechanics.fulcrum import NEAR_LIMIT, margins
from stayput.mechanics.geometry import arm, gap_rate, slip_rate
from stayput.mechanics.impact import energy, scale_change_of_fulcrum, stop_corner
from stayput.mechanics.projection import set_pivot_velocity


@inner
def stop_on_landing(contacts, touch, case, s):
    """Apply the impact, if the landing corner sticks and the other lifts; whether it did.

    The body rocked on one base corner, lands on the other, and touches nothing else. A landing that bounces,
    slips or ends the rocking is the general case.
    """
    if s.kind != ROCK or touch != FLOOR_BITS or s.hit | s.closed != FLOOR_BITS or s.hit == s.closed:
        return False
    new, old = s.hit - 1, s.closed - 1  # contacts 0 and 1 have the bits 1 and 2
    con = contacts[new]
    if con.restitution > 0.0 or abs(slip_rate(con, s)) > STICK_RATE:
        return False
    before = s.vx, s.vz, s.omega
    ok, s.vx, s.vz, s.omega = stop_corner(contacts, new, case.inertia, s)
    if ok and case.restitution != 1.0:
        scale_change_of_fulcrum(contacts, new, case, s, energy(case.inertia, before[0], before[1], before[2]))
    if ok and gap_rate(contacts[old], s) > s.settle_rate:
        return True
    s.vx, s.vz, s.omega = before
    return False


@inner
def pivot_on_landing(contacts, touch, case, s, a, G):
    """Handle the landing of a bare body under the loads (a, G), if the fast path applies; whether it did.

    A force near its limit is the general case too.
    """
    before = s.vx, s.vz, s.omega
    if not stop_on_landing(contacts, touch, case, s):
        return False
    new = s.hit - 1
    con = contacts[new]
    sigma, kappa = arm(con, s)
    q = -1.0 / (case.inertia + sigma * sigma + kappa * kappa)
    law = (True, case.inertia, q, con.mu_static, 0.0, 1.0)
    f, g, alpha = margins(law, sigma, kappa, s.omega, a, G, 0.0)
    if min(f, g) > NEAR_LIMIT * case.gravity:
        s.i, s.d, s.j, s.dj, s.closed, s.alpha = new, 0, -1, 0, s.hit, alpha
        set_pivot_velocity(con, s)
        return True
    s.vx, s.vz, s.omega = before
    return False
