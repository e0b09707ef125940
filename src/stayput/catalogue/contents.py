"""Contents of furniture: refusals, and what a verdict says of what comes out."""

TEXTS: dict[str, tuple[str, str]] = {
    "kind": ("Contents", "収納物の種類（kind）"),
    "doors": ("Doors", "扉（doors）"),
    "drawers": ("Drawers", "引き出し（drawers）"),
    # Where what was given has no place
    "behind_doors": ("beside doors", "扉のある家具"),
    "without_catch": ("without hinged doors or drawers with catches",
                      "開き戸も留め具付きの引き出しもない家具"),
    "without_doors": ("without doors that are {needed}", "扉が{needed}でない家具"),
    "in_drawers": ("for contents in drawers", "引き出しのある家具"),
    "beside_loads": ("beside loads of the shelves", "棚の荷重（loads）を指定した家具"),
    "kinetic_friction": ("The kinetic friction of the contents", "収納物の動摩擦係数"),
    "too_heavy": (("The loads of the shelves are {loads:g} kg in all; they must be less than the mass of "
                   "the furniture with them, {mass:g} kg."),
                  ("棚の荷重の合計が{loads:g} kgになっています。家具の質量（収納物を含む、"
                   "{mass:g} kg）より小さくしてください。")),
    "needs_coulomb": ("'coulomb' where contents are followed", "収納物の計算では'coulomb'"),
    "piece": ("Number of the piece", "家具の番号（piece）"),
    "samples_apart": (("The samples of the run are {dt:g} s apart; they must be no more than {most:g} s "
                       "apart, so simulate under motion.resampled."),
                      ("計算結果の時間刻みが{dt:g}秒になっています。"
                       "motion.resampledで{most:g}秒以下にして計算し直してください。")),
    "given_up": ("The run of the furniture was given up; its contents cannot be followed.",
                 "家具の計算が打ち切られたため、収納物の動きを計算できません。"),
}
