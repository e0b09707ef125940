"""Charts that a reader keeps, with their captions."""

TEXTS: dict[str, tuple[str, str]] = {
    "inputs": ("Inputs: {inputs}.", "入力：{inputs}。"),
    "made": ("Made with stayput {version}; seed {seed}.", "stayput {version}で作成、乱数の種は{seed}。"),
    "measures": ("Measures", "対策"),
    "shaken": (
        "{name}, {peak:.3g} m/s² at most on this floor",
        "{name}、この床での最大加速度{peak:.3g} m/s²",
    ),
    "without": ("Without measures", "対策なし"),
    "with": ("With the measures", "対策あり"),
    "histories": ("Second by second", "時間を追って見る"),
    "axis_force": ("Force [N]", "力 [N]"),
    "axis_yaw": ("Turn in plan [°]", "水平面内の回転 [°]"),
    "axis_overturned": ("Overturned [%]", "転倒した割合 [%]"),
    "axis_height": ("Height [cm]", "高さ [cm]"),
    "axis_depth": ("Depth [cm]", "奥行き [cm]"),
    "tens": ("How likely is it?", "どのくらい起こりやすいか"),
    "tens_note": (
        "Of ten pieces so many lie as overturn; the ranges hold with 95 %.",
        "10台のうち転倒する台数を横倒しで示しています。範囲は95%信頼区間です。",
    ),
    "ranking": ("What helps most?", "どの対策が最も効くか"),
    "ranking_note": (
        "Bars: share of the runs in which the piece overturns; lines: 95 % intervals.",
        "棒は転倒した割合、線は95%信頼区間です。",
    ),
    "fragility": ("Chance of overturning by intensity", "震度ごとの転倒確率"),
    "fragility_note": (
        "Marks: shares in the simulations; lines: isotonic regression of them, with 95 % bands; dotted: the shaking in question.",
        "印は計算で転倒した割合、線はその単調回帰（帯は95%信頼帯）、点線は今の揺れです。",
    ),
    "sizes": ("Size against intensity", "大きさと震度"),
    "sizes_note": (
        "Share that overturns in {runs} runs of each size at each intensity; grey: not possible, or not known.",
        "各寸法・各震度で{runs}回ずつ計算し、転倒した割合です。灰色は設置できないか不明です。",
    ),
    "own_piece": ("the piece itself", "この家具"),
    "no_curves": (
        "This verification has no curves; ask for it with curves.",
        "この判定には曲線がありません。曲線を計算してから保存してください。",
    ),
}
"""Texts by their keys: English, Japanese."""
