"""The page's entry of how strong an earthquake is, by what people know of it, and of records of their own."""

TEXTS: dict[str, tuple[str, str]] = {
    # What it amounts to, by the server
    "amounts": ("JMA intensity {at:.1f}: {strength}.", "計測震度{at:.1f}（{strength}）です。"),
    "amounts_about": (
        "About JMA intensity {at:.1f} ± {deviation:.1f}: {strength}.",
        "計測震度{at:.1f}±{deviation:.1f}程度（{strength}）です。",
    ),
    "amounts_between": (
        "About JMA intensity {at:.1f} ± {deviation:.1f}: {low} to {high}.",
        "計測震度{at:.1f}±{deviation:.1f}程度（{low}から{high}）です。",
    ),
    # The entry
    "knownBy": ("What do you know of it?", "揺れの強さを何で決めますか"),
    "earthquake": ("Magnitude and distance", "マグニチュードと距離"),
    "mmi": ("Modified Mercalli intensity", "改正メルカリ震度"),
    "mmi_4": ("IV, light", "4（やや弱い）"),
    "mmi_5": ("V, moderate", "5（中程度）"),
    "mmi_6": ("VI, strong", "6（強い）"),
    "mmi_7": ("VII, very strong", "7（非常に強い）"),
    "mmi_8": ("VIII, severe", "8（激しい）"),
    "mmi_9": ("IX, violent", "9（猛烈な）"),
    "mmi_10": ("X, extreme", "10（極めて猛烈な）"),
    "pga": ("Peak acceleration of the ground", "地面の最大加速度"),
    "pgv": ("Peak velocity of the ground", "地面の最大速度"),
    "saPeriod": ("Period of the oscillator", "応答の周期"),
    "sa": ("Spectral acceleration, 5 % damping", "加速度応答（減衰5%）"),
    "magnitude": ("Moment magnitude", "モーメントマグニチュード"),
    "distance": ("Shortest distance to the fault", "断層までの最短距離"),
    "depth": ("Depth", "震源の深さ"),
    "quakeKind": ("Where it breaks", "震源の種類"),
    "kind_crustal": ("In the crust", "内陸の浅い地震"),
    "kind_interface": ("Between two plates", "プレート境界の地震"),
    "kind_intraslab": ("Within a diving plate", "プレート内部の地震"),
    "groundKind": ("Ground", "地盤"),
    "ground_600": ("Rock or hard ground", "岩盤・硬い地盤"),
    "ground_300": ("Firm ground", "普通の地盤"),
    "ground_180": ("Soft ground", "軟らかい地盤"),
    "asking": ("Working out what that amounts to …", "どの程度の揺れか計算しています…"),
    "familyAbout": (
        "Computed motions, no recordings: {about}.",
        "計算で作った模擬地震動で、観測記録ではありません。{about}。",
    ),
    # A record of one's own
    "measuredWhere": ("Where was it measured?", "どこで観測した記録ですか"),
    "measuredGround": ("The ground", "地面"),
    "measuredFloor": ("A floor of a building", "建物の床"),
    "placeMeasured": ("On the floor where it was recorded,", "記録が観測された床の上、"),
    "measuredNote": (
        "It shakes the piece as it is, with no building between.",
        "建物を通さず、この記録でそのまま家具を揺らします。",
    ),
    "verticalAlone": (
        "“{name}” holds a vertical component alone, which overturns nothing by itself. Drop the horizontal record first; then this one can be its vertical component.",
        "「{name}」は上下動だけの記録です。上下動だけでは家具の転倒を調べられません。先に水平動の記録をドロップしてください。その上下動として使えます。",
    ),
    "verticalOffered": (
        "“{name}” holds a vertical component alone. Take it as the vertical component of “{record}”?",
        "「{name}」は上下動だけの記録です。「{record}」の上下動として使いますか。",
    ),
    "takeVertical": ("Take it as vertical", "上下動として使う"),
    "withVertical": ("Vertical component: {name}.", "上下動：{name}。"),
}
