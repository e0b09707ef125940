"""Contents of furniture: refusals, and what a verdict says of what comes out."""

TEXTS: dict[str, tuple[str, str]] = {
    "kind": ("Contents", "収納物の種類（kind）"),
    "doors": ("Doors", "扉（doors）"),
    "drawers": ("Drawers", "引き出し（drawers）"),
    "doors_and_drawers": (
        "Doors are {doors!r} and drawers are {drawers!r}; contents are behind doors or in drawers, not both.",
        "扉が{doors!r}、引き出しが{drawers!r}になっています。どちらか一方だけを指定してください。",
    ),
    "no_catch": (
        (
            "The catch holds {catch:g} N, but doors are {doors!r} and drawers are {drawers!r}; a catch needs "
            "hinged doors, or drawers with catches."
        ),
        (
            "留め具の保持力が{catch:g} Nですが、扉が{doors!r}、引き出しが{drawers!r}になっています。留め具は開き戸か"
            "留め具付きの引き出しにだけ指定してください。"
        ),
    ),
    "without_doors": (
        "The {name} is {value:g} {unit}, but doors are {doors!r}; they must be one of {needed}.",
        "{name}が{value:g} {unit}ですが、扉が{doors!r}になっています。扉を次のいずれかにしてください：{needed}",
    ),
    "in_drawers": (
        "The {name} is {value:g} m, but drawers are {drawers!r}; it is for things on shelves, so give only one of the two.",
        (
            "{name}が{value:g} m、引き出しが{drawers!r}になっています。"
            "前者は棚に置いた物のための値です。どちらか一方だけを指定してください。"
        ),
    ),
    "loads_and_shelves": (
        "The number of loads is {loads} and that of shelves is {shelves}; give one load for each shelf.",
        "荷重の数が{loads}、棚の数が{shelves}になっています。棚ごとに荷重を1つ指定してください。",
    ),
    "loads_and_share": (
        "The loads are {loads:g} kg in all and their share of the mass is {share:g}; give only one of the two.",
        "荷重の合計が{loads:g} kg、質量の割合が{share:g}になっています。どちらか一方だけを指定してください。",
    ),
    "kinetic_friction": ("The kinetic friction of the contents", "収納物の動摩擦係数"),
    "too_heavy": (
        "The loads of the shelves are {loads:g} kg in all; they must be less than the mass of the furniture with them, {mass:g} kg.",
        "棚の荷重の合計が{loads:g} kgになっています。家具の質量（収納物を含む、{mass:g} kg）より小さくしてください。",
    ),
    "needs_coulomb": ("'coulomb' where contents are followed", "収納物の計算では'coulomb'"),
    "piece": ("Number of the piece", "家具の番号（piece）"),
    "samples_apart": (
        "The samples of the run are {dt:g} s apart; they must be no more than {most:g} s apart, so simulate under motion.resampled.",
        "計算結果の時間刻みが{dt:g}秒になっています。motion.resampledで{most:g}秒以下にして計算し直してください。",
    ),
    "given_up": (
        "The run of the furniture was given up; its contents cannot be followed.",
        "家具の計算が打ち切られたため、収納物の動きを計算できません。",
    ),
}
"""Texts by their keys: English, Japanese."""
