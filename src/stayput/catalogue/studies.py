"""The studies."""

STUDIES: dict[str, tuple[str, str]] = {
    "friction": (
        "peak slide over static and kinetic friction (§4.2 of the paper)",
        "静摩擦係数と動摩擦係数に対する最大移動量（論文4.2節）",
    ),
    "critical-ratio": (
        "critical amplitude of a sine over b/h and frequency (§4.3, Eq. 4.1)",
        "幅高さ比と振動数に対する正弦波の転倒限界振幅（4.3節、式4.1）",
    ),
    "wall-gap": (
        "overturning over width and distance to a wall, under a sine (§4.4)",
        "正弦波での、幅と壁までの距離に対する転倒（4.4節）",
    ),
    "wall-gap-record": (
        "the same under a record (§4.5, Table 4.3)",
        "wall-gapと同じ内容を地震記録で（4.5節、表4.3）",
    ),
    "spectrum": (
        "overturning and rocking spectra of pulses and of a record",
        "パルスと地震記録の転倒スペクトルとロッキングスペクトル",
    ),
    "tokyo": (
        "devices alone and together, as in Tokyo's product test of 2015",
        "器具の単独使用と併用（東京都の2015年の商品テスト）",
    ),
    "baseline": (
        "what the ideal block leaves out and is worth, and where bare furniture lies in the field",
        "理想的な剛体モデルの妥当性と限界、対策なしの家具と既往の研究との比較",
    ),
    "tip-over": (
        "what tips common pieces over without an earthquake",
        "地震がなくても家具が倒れる条件",
    ),
    "tombstones": (
        "gravestones that fall against intensity, beside surveys",
        "震度に対する墓石の転倒と、現地調査との比較",
    ),
    "consumer-centre": (
        "the Japanese consumer centre's shake table of 2018, as far as published",
        "国民生活センターの2018年の振動台実験との比較（公表された範囲）",
    ),
    "ac156": (
        "does a piece that passes AC156 survive the floors of buildings?",
        "AC156に合格した家具は建物の床の揺れに耐えるか",
    ),
    "contents": (
        "what comes out of shelves and cupboards, beside tests and reports",
        "棚や食器棚からの収納物の飛び出しと、実験や報告との比較",
    ),
    "capacity": (
        "median overturning capacity beside Kaneko and Hayashi's formula",
        "転倒耐力の中央値と金子・林の式との比較",
    ),
    "three-dimensions": (
        "how often, and for which shapes, the plane's verdict differs from that of space",
        "平面と三次元の解析で判定が異なる割合と、その形状",
    ),
}
"""Names of the studies, and what they are about."""

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
