"""What the friction study found, in words."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from stayput.motion.units import STANDARD_GRAVITY
from stayput.studies.friction.runs import (
    FREE,
    HELD,
    PAPER_BODY,
    PAPER_ROWS,
    PAPER_SLIDES,
    PHASES,
    Nearest,
    effects,
    in_words,
)

if TYPE_CHECKING:
    from collections.abc import Sequence

    import xarray as xr


def text_of(
    searched: dict[str, xr.Dataset],
    nearest: dict[str, Nearest],
    rows: dict[str, xr.Dataset],
    duration: float,
) -> str:
    """Return the study's paragraphs.

    Parameters
    ----------
    searched, nearest, rows : dict
        By model: the searched sines, the nearest of them, and the paper's rows under the sine nearest for the
        body that only slides.
    duration : float
        Length of the shaking [s].
    """
    return "\n\n".join(
        (
            _what_was_done(searched[HELD], duration),
            _why_it_must_not_rock(nearest[HELD], rows),
            _how_near(nearest),
            _which_matters_more(nearest),
            _where_it_flips(searched),
        )
    )


def _what_was_done(grid: xr.Dataset, duration: float) -> str:
    body = PAPER_BODY
    A, f = grid.amplitude.to_numpy(), grid.frequency.to_numpy()
    phases = " and ".join(f"{phase:g}°" for phase in PHASES)
    return (
        f"The paper (§4.2) lets a body of {body.width:g} × {body.height:g} m and {body.mass:g} kg slide "
        f"for three pairs of coefficients. It does not state its input. So sines of {duration:g} s were "
        f"searched, of {A[0]:g} to {A[-1]:g} m/s² and {f[0]:g} to {f[-1]:g} Hz at phases of {phases}, for "
        "the one whose three peak slides come nearest to the paper's; the measure is the largest relative "
        "deviation of the three."
    )


def _why_it_must_not_rock(sine: Nearest, rows: dict[str, xr.Dataset]) -> str:
    ratio, static = PAPER_BODY.width / PAPER_BODY.height, PAPER_ROWS[2][0]
    third = {law: rows[name].isel(row=2).squeeze() for law, name in FREE.items()}
    does = {
        law: f"{'rocks' if found.rocks else 'stands'} and slides {100 * float(found.peak_slide):.2f} cm"
        for law, found in third.items()
    }
    return (
        f"To slide at μ = {static:g} the body needs more than {static:g} g, and at b/h = {ratio:g} it "
        f"begins to rock beyond {ratio:g} g under either law. So the paper's third row is of a body that "
        "was not let rock, or of one that rocks as well. Both were run: a body so wide that it only "
        "slides, for which both laws are the same, and the paper's body under each law. Under the sine of "
        f"{in_words(sine)}, in the third row, the free body {does['paper']} under the paper's law, and "
        f"{does['coulomb']} under Coulomb's."
    )


def _how_near(nearest: dict[str, Nearest]) -> str:
    found = [
        f"{100 * sine.deviation:.0f} % for “{name}” ({in_words(sine)})" for name, sine in nearest.items()
    ]
    return (
        f"The nearest sines leave a largest deviation of {'; '.join(found)}. What is left says that the "
        "paper's input was none of these, or its model none of ours."
    )


def _which_matters_more(nearest: dict[str, Nearest]) -> str:
    def told(slides: Sequence[float]) -> str:
        base, kinetic, static = (100.0 * slide for slide in slides)
        order = "μ" if static < kinetic else "μ'"
        return f"{base - static:.2f} cm for μ and {base - kinetic:.2f} cm for μ', so {order} matters more"

    base, kinetic, static = (100.0 * slide for slide in PAPER_SLIDES)
    ours = "; ".join(f"{told(sine.slides.tolist())} (“{name}”)" for name, sine in nearest.items())
    return (
        f"An increase of 0.2 shortens the paper's slide by {told(PAPER_SLIDES)}. (Its slides satisfy "
        f"{kinetic:.2f} + {static:.2f} = {base:.2f}, so each difference is also the slide of the other "
        f"row; one of the printed numbers may be a slip.) Ours, each under its nearest sine: {ours}."
    )


def _no_help(grid: xr.Dataset) -> tuple[xr.DataArray, xr.DataArray]:
    """Whether more static friction changes nothing, and more kinetic friction lengthens the slide."""
    static, kinetic = effects(grid)
    slides = grid.peak_slide.isel(row=0) > 0.0
    return (abs(static) < 1e-9).where(slides), (kinetic < 0.0).where(slides)


def _where_it_flips(searched: dict[str, xr.Dataset]) -> str:
    said: list[str] = []
    for name, grid in searched.items():
        static, kinetic = effects(grid)
        matters = (kinetic > static).transpose("amplitude", ...).to_numpy()
        known = (static.notnull() & kinetic.notnull() & (grid.peak_slide.isel(row=0) > 0.0)).to_numpy()
        share = 100.0 * matters.sum() / max(1, known.sum())
        first = grid.amplitude.to_numpy()[matters.argmax(axis=0)[matters.any(axis=0)]] / STANDARD_GRAVITY
        start = f" (from {np.median(first):.2f} g on)" if first.size else ""
        said.append(f"{share:.0f} % for “{name}”{start}")
    idle, longer = (100.0 * float(part.mean()) for part in _no_help(searched[HELD]))
    g, mu = PAPER_BODY.height / PAPER_BODY.width, PAPER_ROWS[2][0]
    slips = (mu * (1.0 + 4.0 * g**2) - 3.0 * g) / (4.0 + g**2 - 3.0 * g * mu)
    return (
        "The conclusion flips with the amplitude. Of the searched sines that slide the first body and "
        f"turn none over, μ' matters more in {'; '.join(said)}; in brackets the lowest such amplitude, its "
        f"median over frequency and phase. For pure sliding μ wins where the floor hardly exceeds {mu:g} "
        "g, so that more static friction keeps the body where it is; once it slides all the same, what "
        "slows it is μ', and the frequency scales the slides but hardly moves the flip. Of these sines "
        f"{idle:.0f} % slide it just as far with 0.2 more μ, such as a cosine that starts beyond both, and "
        f"{longer:.0f} % further with 0.2 more μ', as it slides back less. A body that is free to rock "
        f"does so instead of sliding at μ = {mu:g} until its corner slips, from {slips:.2f} g on at the "
        "first uplift (Shenton 1996), so μ wins for longer."
    )
