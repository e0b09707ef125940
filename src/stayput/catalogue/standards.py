"""Standards beside the simulation."""

TEXTS: dict[str, tuple[str, str]] = {
    "lifted": (
        "Peak vertical acceleration is {vertical:.3g} m/s²; friction is left below {most:.3g} m/s² only.",
        "鉛直方向の最大加速度が{vertical:.3g} m/s²です。摩擦が残るように{most:.3g} m/s²未満にしてください。",
    )
}
"""Texts by their keys: English, Japanese."""
