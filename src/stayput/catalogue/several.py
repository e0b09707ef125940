"""Verdicts on several pieces: what happens with their joints and with measures, and why."""

TEXTS: dict[str, tuple[str, str]] = {
    "joined": ("Joined", "上下・隣どうしを接合"),
    "two_of_one_name": (
        "Two options are named {name}; each must have a name of its own.",
        "{name}という名前の案が2つあります。それぞれに異なる名前を付けてください。",
    ),
    "levels": (
        "levels are given for several pieces, which are run at the scenario's own shaking; they must be left out.",
        "複数の家具にlevelsが指定されています。シナリオの揺れだけで計算するので、省いてください。",
    ),
}
"""Texts by their keys: English, Japanese."""
