"""Taylor series of the tilt of a body on one fulcrum, sticking or slipping.

With J_G/m = I, the corner at σ = r sin(β−θ), κ = r cos(β−θ) from G, and the loads A, Γ linear in time
over a step (the record is piecewise linear), the fulcrum either sticks (Eqs. 3.12, 3.13)

    (I + r²) θ̈ = −κ A − σ Γ

or slips in the direction d (Eqs. 3.10 and 3.11 together with the rotation)

    k = σ − μ'd κ,   θ̈ = −k (Γ − κ θ̇²) / (I + k σ).

The right-hand sides are products of series whose coefficients follow by recurrence, so the series of θ up to
τ⁷ costs about as much as two evaluations, and provides dense output.
"""

from stayput.compiling import inline, inner
from stayput.mechanics.elementary import sixth_root


@inline
def rock_series(q, sg0, ka0, theta, omega, load):
    """Coefficients θ₀..θ₇ of a rocking body.

    q = −1/(I+r²); σ and κ at the start; load = (A, its rate, Γ, its rate). From σ' = −κθ̇ and κ' = σθ̇ follow
    n σₙ = −Σ kθ_k κ_{n−k} and n κₙ = Σ kθ_k σ_{n−k}; sums are written so that the newest coefficient
    is added last: the processor computes the rest while it waits for it.
    """
    A0, A1, G0, G1 = load
    t1 = omega
    t2 = (ka0 * A0 + sg0 * G0) * (0.5 * q)
    sg1, ka1 = -ka0 * t1, sg0 * t1
    t3 = ((ka1 * A0 + sg1 * G0) + (ka0 * A1 + sg0 * G1)) * (q * (1.0 / 6.0))
    u2 = 2.0 * t2
    sg2 = -(ka0 * t2 + 0.5 * (t1 * ka1))
    ka2 = sg0 * t2 + 0.5 * (t1 * sg1)
    t4 = ((ka2 * A0 + sg2 * G0) + (ka1 * A1 + sg1 * G1)) * (q * (1.0 / 12.0))
    u3 = 3.0 * t3
    sg3 = -(ka0 * t3 + (u2 * ka1 + t1 * ka2) * (1.0 / 3.0))
    ka3 = sg0 * t3 + (u2 * sg1 + t1 * sg2) * (1.0 / 3.0)
    t5 = ((ka3 * A0 + sg3 * G0) + (ka2 * A1 + sg2 * G1)) * (q * (1.0 / 20.0))
    u4 = 4.0 * t4
    sg4 = -(ka0 * t4 + 0.25 * (u3 * ka1 + (u2 * ka2 + t1 * ka3)))
    ka4 = sg0 * t4 + 0.25 * (u3 * sg1 + (u2 * sg2 + t1 * sg3))
    t6 = ((ka4 * A0 + sg4 * G0) + (ka3 * A1 + sg3 * G1)) * (q * (1.0 / 30.0))
    sg5 = -(ka0 * t5 + 0.2 * (u4 * ka1 + u3 * ka2 + (u2 * ka3 + t1 * ka4)))
    ka5 = sg0 * t5 + 0.2 * (u4 * sg1 + u3 * sg2 + (u2 * sg3 + t1 * sg4))
    t7 = ((ka5 * A0 + sg5 * G0) + (ka4 * A1 + sg4 * G1)) * (q * (1.0 / 42.0))
    return theta, omega, t2, t3, t4, t5, t6, t7


@inner
def slide_rock_series(I, mu_d, sg0, ka0, theta, omega, load):
    """Coefficients θ₀..θ₇ of a body that rocks on a slipping fulcrum; mu_d = μ'd, σ and κ at the start.

    The series of σ, κ, k, M = I + kσ and P = Γ − κθ̇² grow by one coefficient at a time, each from the
    lower ones: θ̈ₙ = −((kP)ₙ + Σ_{j≥1} M_j θ̈_{n−j})/M₀.
    """
    G0, G1 = load[2], load[3]
    k0 = sg0 - mu_d * ka0
    M0 = I + k0 * sg0
    over = -1.0 / M0
    v0 = omega * omega
    P0 = G0 - ka0 * v0
    a0 = k0 * P0 * over
    w1 = a0

    sg1, ka1 = -ka0 * omega, sg0 * omega
    k1 = sg1 - mu_d * ka1
    M1 = k0 * sg1 + k1 * sg0
    v1 = 2.0 * omega * w1
    P1 = G1 - (ka0 * v1 + ka1 * v0)
    a1 = (k0 * P1 + k1 * P0 + M1 * a0) * over
    w2 = 0.5 * a1

    sg2 = -0.5 * (ka0 * w1 + ka1 * omega)
    ka2 = 0.5 * (sg0 * w1 + sg1 * omega)
    k2 = sg2 - mu_d * ka2
    M2 = k0 * sg2 + k1 * sg1 + k2 * sg0
    v2 = 2.0 * omega * w2 + w1 * w1
    P2 = -(ka0 * v2 + ka1 * v1 + ka2 * v0)
    a2 = (k0 * P2 + k1 * P1 + k2 * P0 + M1 * a1 + M2 * a0) * over
    w3 = a2 * (1.0 / 3.0)

    sg3 = -(ka0 * w2 + ka1 * w1 + ka2 * omega) * (1.0 / 3.0)
    ka3 = (sg0 * w2 + sg1 * w1 + sg2 * omega) * (1.0 / 3.0)
    k3 = sg3 - mu_d * ka3
    M3 = k0 * sg3 + k1 * sg2 + k2 * sg1 + k3 * sg0
    v3 = 2.0 * (omega * w3 + w1 * w2)
    P3 = -(ka0 * v3 + ka1 * v2 + ka2 * v1 + ka3 * v0)
    a3 = (k0 * P3 + k1 * P2 + k2 * P1 + k3 * P0 + M1 * a2 + M2 * a1 + M3 * a0) * over
    w4 = 0.25 * a3

    sg4 = -0.25 * (ka0 * w3 + ka1 * w2 + ka2 * w1 + ka3 * omega)
    ka4 = 0.25 * (sg0 * w3 + sg1 * w2 + sg2 * w1 + sg3 * omega)
    k4 = sg4 - mu_d * ka4
    M4 = k0 * sg4 + k1 * sg3 + k2 * sg2 + k3 * sg1 + k4 * sg0
    v4 = 2.0 * (omega * w4 + w1 * w3) + w2 * w2
    P4 = -(ka0 * v4 + ka1 * v3 + ka2 * v2 + ka3 * v1 + ka4 * v0)
    a4 = (k0 * P4 + k1 * P3 + k2 * P2 + k3 * P1 + k4 * P0 + M1 * a3 + M2 * a2 + M3 * a1 + M4 * a0) * over
    w5 = 0.2 * a4

    sg5 = -0.2 * (ka0 * w4 + ka1 * w3 + ka2 * w2 + ka3 * w1 + ka4 * omega)
    ka5 = 0.2 * (sg0 * w4 + sg1 * w3 + sg2 * w2 + sg3 * w1 + sg4 * omega)
    k5 = sg5 - mu_d * ka5
    M5 = k0 * sg5 + k1 * sg4 + k2 * sg3 + k3 * sg2 + k4 * sg1 + k5 * sg0
    v5 = 2.0 * (omega * w5 + w1 * w4 + w2 * w3)
    P5 = -(ka0 * v5 + ka1 * v4 + ka2 * v3 + ka3 * v2 + ka4 * v1 + ka5 * v0)
    kP = k0 * P5 + k1 * P4 + k2 * P3 + k3 * P2 + k4 * P1 + k5 * P0
    a5 = (kP + M1 * a4 + M2 * a3 + M3 * a2 + M4 * a1 + M5 * a0) * over
    return (
        theta,
        omega,
        0.5 * a0,
        a1 * (1.0 / 6.0),
        a2 * (1.0 / 12.0),
        a3 * (1.0 / 20.0),
        a4 * (1.0 / 30.0),
        a5 * (1.0 / 42.0),
    )


@inline
def tilt_after(series, h):
    """Tilt and tilt rate from the series after a time h; the newest coefficients are added last."""
    theta, omega, t2, t3, t4, t5, t6, t7 = series
    h2 = h * h
    h3 = h2 * h
    h4, h5, h6 = h2 * h2, h2 * h3, h3 * h3
    h7 = h3 * h4
    tilt = (theta + h * omega + h2 * t2) + (h3 * t3 + h4 * t4) + (h5 * t5 + h6 * t6) + h7 * t7
    rate = (omega + 2.0 * h * t2) + (3.0 * h2 * t3 + 4.0 * h3 * t4) + (5.0 * h4 * t5 + 6.0 * h5 * t6)
    return tilt, rate + 7.0 * h6 * t7


@inline
def step_within(h, series, tolerance):
    """Longest step, at most h, whose last term θ₇h⁷ stays within the tolerance [rad].

    Where the motion is even in time, as at a release from rest, every other term vanishes and the last one
    says nothing; so the term before it must stay within 16 tolerances too, which otherwise follows by itself.
    """
    h3 = h * h * h
    last = h3 * h3 * max(abs(series[7]) * h, abs(series[6]) * 0.0625)
    if last > tolerance:
        h *= 0.9 * sixth_root(tolerance / last)
    return h
