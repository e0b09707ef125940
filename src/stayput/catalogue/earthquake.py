"""The page's entry of an earthquake: how people say how strong it is, and what it amounts to."""

TEXTS: dict[str, tuple[str, str]] = {
    "amounts": ("About JMA intensity {at:.1f}: {strength}.", "計測震度{at:.1f}程度（{strength}）です。"),
}
