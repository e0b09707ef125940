"""When rebounds have ended: where they are tiny, or small and sure to die out while the load holds the body.

A body that lands rebounds for ever, ever less. A rebound at the rate ω about a corner takes 2ω/α, at the
acceleration α that returns it, and the next, about the other corner, begins at ρω. So ω falls, on average,
at the rate (1 − ρ) α_A α_B/(α_A + α_B).
"""

from __future__ import annotations

from stayput.compiled import inner
from stayput.mechanics.columns import A_FLOOR, B_FLOOR, FLOOR_BITS
from stayput.mechanics.contact import STICK_RATE
from stayput.mechanics.geometry import arm, gap_rate, slip_rate
from stayput.mechanics.sampling import loads


@inner
def settling_rate(contacts, touch, case, s, motion):
    """Rate up to which a contact that opens after an impact stays closed [m/s].

    It is larger for a body on both base corners that small rebounds leave at rest before the load, which is
    known ahead, could tip it or slide it: they do not change where it is then.
    """
    if touch & FLOOR_BITS != FLOOR_BITS:
        return s.settle_rate
    left, right = contacts[A_FLOOR], contacts[B_FLOOR]
    rate = max(gap_rate(left, s), gap_rate(right, s))
    if not s.settle_rate < rate <= s.small_rate:
        return s.settle_rate
    slips = max(abs(slip_rate(left, s)), abs(slip_rate(right, s))) > STICK_RATE
    return s.settle_rate if slips or not _die_out(contacts, case, s, motion, rate) else s.small_rate


@inner
def _die_out(contacts, case, s, motion, rate):
    """Whether rebounds from this rate end while the floor alone would hold the body at rest."""
    left, right = contacts[A_FLOOR], contacts[B_FLOOR]
    sigma_a, kappa_a = arm(left, s)
    sigma_b, kappa_b = arm(right, s)
    about_a = case.inertia + sigma_a * sigma_a + kappa_a * kappa_a
    about_b = case.inertia + sigma_b * sigma_b + kappa_b * kappa_b
    kept = case.restitution * (case.inertia + sigma_a * sigma_b + kappa_a * kappa_b) / min(about_a, about_b)
    c = 0
    while s.present >> c:
        if s.present >> c & 1:
            kept = max(kept, contacts[c].restitution)
        c += 1
    mu = min(case.static_friction, left.mu_static, right.mu_static)
    omega = 2.0 * rate / (sigma_b - sigma_a)  # twice, since the rebounds follow the mean only roughly
    ax, az = motion.ax, motion.az
    h = motion.dt - s.tau
    a, _, G, _ = loads(case, ax, az, case.scale / motion.dt, s.k, s.tau)
    for k in range(s.k + 1, ax.shape[0]):
        a1, G1 = case.scale * ax[k], case.gravity + case.scale * az[k]
        am, Gm = 0.5 * (a + a1), 0.5 * (G + G1)
        alpha_a, alpha_b = (-sigma_a * Gm - kappa_a * am) / about_a, (sigma_b * Gm + kappa_b * am) / about_b
        tips = min(alpha_a, alpha_b, -sigma_a * G1 - kappa_a * a1, sigma_b * G1 + kappa_b * a1) <= 0.0
        if tips or abs(a) > mu * G or abs(a1) > mu * G1:
            return False
        omega -= h * (1.0 - kept) * alpha_a * alpha_b / (alpha_a + alpha_b)
        if omega <= 0.0:
            return True
        a, G, h = a1, G1, motion.dt
    return kept < 1.0
