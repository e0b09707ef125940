"""The studies."""

TEXTS: dict[str, tuple[str, str]] = {
    # What values are called
    "amplitudes": ("amplitudes", "振幅"),
    "frequencies": ("frequencies", "振動数"),
    "coefficients": ("coefficients", "摩擦係数"),
    "ratios": ("ratios", "幅高さ比"),
    "intensities": ("JMA intensities", "計測震度"),
    "one_of": ("One of the {name}", "{name}の値"),
    "amplitude": ("Amplitude", "振幅"),
    "frequency": ("Frequency", "振動数"),
    "aspect_ratio": ("Aspect ratio", "幅高さ比"),
    "width": ("Width", "幅"),
    "wall_gap": ("Wall gap", "壁までの距離"),
    "slenderness": ("Slenderness", "角度α（対角線と鉛直線のなす角）"),
    "period": ("Period 2π/p", "周期2π/p"),
    "step": ("Step", "刻み"),
    "amplitude_step": ("Step of the amplitudes", "振幅の刻み"),
    "samples": ("Samples", "試行数"),
    "motions": ("Number of motions", "地震動の数"),
    "stones": ("Number of stones", "墓石の数"),
    # Values that are too few or out of order
    "not_rising": (
        "The {several} are {values}; they must be two or more, each above the last.",
        "{several}が{values}になっています。2個以上を小さい順に指定してください。",
    ),
    "not_increasing": (
        "{name} has {count} values; there must be some, each above the one before.",
        "{name}の値が{count}個、指定されています。1個以上を小さい順に、重複なく指定してください。",
    ),
    "not_sorted": (
        "{name} has the values {values}; they must be increasing.",
        "{name}が{values}になっています。小さい順に、重複なく指定してください。",
    ),
    "rule_without_values": (
        "{name} has no values to test the rule with; there must be at least one.",
        "15%の規則を調べるための{name}がありません。1個以上を指定してください。",
    ),
    "spectrum_too_small": (
        (
            "The spectrum has {slendernesses} slendernesses and {periods} periods; "
            "it must have one or more and two or more."
        ),
        "角度αが{slendernesses}個、周期が{periods}個あります。αは1個以上、周期は2個以上を指定してください。",
    ),
    "few_overturn": (
        "{count} of the bodies turn over at some amplitude; a regression needs five or more.",
        "調べた振幅で転倒する剛体が{count}個しかありません。回帰には5個以上が必要です。",
    ),
    "corners": (
        "The corner periods are {corners}; they must lie between 0.16 and 5 s.",
        "コーナー周期が{corners}になっています。0.16～5 sの値を1個以上指定してください。",
    ),
    # Names, motions and folders
    "size": (
        "The size is {size!r}; it must be one of {sizes}.",
        "家具の種類が{size!r}になっています。{sizes}のいずれかを指定してください。",
    ),
    "still": (
        "The motion {motion!r} is still along the shaking; it must shake.",
        "地震動{motion!r}は加振方向に動きがありません。揺れのある地震動を指定してください。",
    ),
    "name": ("Study", "スタディの名前"),
    "no_motion": (
        "Study {name!r} takes no motion; --motion is for {names}.",
        "スタディ{name!r}では地震動を指定できません。--motionを使えるのは{names}です。",
    ),
}
"""Texts by their keys: English, Japanese."""
