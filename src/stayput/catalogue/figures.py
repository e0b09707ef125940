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
    "room_plan": ("Where the pieces come to lie", "家具が行き着く場所"),
    "room_plan_note": (
        "Outlines: pieces as they stand; shaded cells: where each ends, strongest where it lies overturned in every run; blue: places of people.",
        "輪郭は今の家具、塗りは揺れの後に行き着く場所で、倒れている確率が高いほど濃くしています。青は人のいる場所です。",
    ),
    "room_hits": ("Who is hit, and by what?", "誰に何が当たるか"),
    "room_hits_hit_note": (
        "Bars: the chance that whoever is there is hit, by any piece and by each; lines: 95 % intervals. Whether a blow injures is not computed.",
        "棒は、そこにいる人に家具（いずれか、または各家具）が当たる確率、線は95%区間です。けがをするかどうかは計算していません。",
    ),
    "room_changes": ("Which single change helps most?", "どの変更が最も効くか"),
    "room_changes_hit_note": (
        "Bars: the chance that somebody is hit, with each change alone; lines: 95 % intervals.",
        "棒は、それぞれの変更だけをした場合に人に当たる確率、線は95%区間です。",
    ),
    "room_changes_shut_in_note": (
        "Bars: the chance that somebody is shut in, with each change alone; lines: 95 % intervals. Nobody is hit as the room is.",
        "棒は、それぞれの変更だけをした場合に誰かが出られなくなる確率、線は95%区間です。今のままでは誰にも当たりません。",
    ),
    "room_changes_overturned_note": (
        "Bars: the chance that the piece overturns, with each change alone; lines: 95 % intervals. Nobody is hit or shut in as the room is.",
        "棒は、それぞれの変更だけをした場合にその家具が倒れる確率、線は95%区間です。今のままでは誰にも当たらず、閉じ込められる人もいません。",
    ),
    "room_as_is": ("The room as it is", "今のままの部屋"),
    "piece_as_is": ("{piece}, as it is", "今のままの{piece}"),
    "axis_from_left": ("From the left wall [m]", "左の壁から [m]"),
    "axis_from_near": ("From the near wall [m]", "手前の壁から [m]"),
    "axis_hit": ("Hit [%]", "当たる確率 [%]"),
    "axis_shut_in": ("Shut in [%]", "出られなくなる確率 [%]"),
    "of_one_piece": (
        "The job is of one piece; this chart is there for the verification of a room.",
        "家具1点の計算です。この図は部屋の検証で使えます。",
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
