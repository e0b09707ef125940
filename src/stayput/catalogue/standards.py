"""Standards beside the simulation."""

TEXTS: dict[str, tuple[str, str]] = {
    "lifted": (
        (
            "The peak vertical acceleration is {vertical:.3g} m/s²; it must be below {most:.3g} m/s², at which the "
            "method leaves no friction."
        ),
        (
            "鉛直方向の最大加速度が{vertical:.3g} m/s²です。この方法では{most:.3g} m/s²以上で摩擦がなくなるため、"
            "それより小さくしてください。"
        ),
    ),
}
"""Texts by their keys: English, Japanese."""
