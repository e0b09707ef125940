"""Contents of furniture: refusals, and what a verdict says of what comes out."""

TEXTS: dict[str, tuple[str, str]] = {
    "kind": ("Contents", "収納物の種類（kind）"),
    "doors": ("Doors", "扉（doors）"),
    "drawers": ("Drawers", "引き出し（drawers）"),
    "doors_and_drawers": (
        "Doors are {doors!r} and drawers are {drawers!r}; contents are behind doors or in drawers, not both.",
        "扉が{doors!r}、引き出しが{drawers!r}になっています。どちらか一方だけを指定してください。",
    ),
    "no_loads": (
        "There is no load; give the load of at least one shelf.",
        "棚の荷重がありません。1段以上の荷重を指定してください。",
    ),
    "kinetic_above_static": (
        "The kinetic friction of the contents is {kinetic:g}; it must not be above the static, {static:g}.",
        "収納物の動摩擦係数は{kinetic:g}です。静止摩擦係数（{static:g}）以下にしてください。",
    ),
    "too_heavy": (
        "The loads of the shelves are {loads:g} kg in all; the furniture with them weighs {mass:g} kg.",
        "棚の荷重の合計が{loads:g} kgになっています。家具の質量（収納物を含む）は{mass:g} kgです。",
    ),
    "needs_coulomb": (
        "The contact is '{contact}'; following what is in furniture needs 'coulomb'.",
        "接触モデル（contact）が「{contact}」です。収納物の計算には「coulomb」を指定してください。",
    ),
    "given_up": (
        "The furniture's run was given up, so that its contents cannot be followed.",
        "家具の計算が打ち切られたため、収納物の動きを計算できません。",
    ),
}
"""Texts by their keys: English, Japanese."""
