"""Fragility curves and the probabilities behind them."""

TEXTS: dict[str, tuple[str, str]] = {
    # measures of intensity
    "jma": ("JMA instrumental intensity", "計測震度"),
    "floor_jma": ("number by JMA's formula for the motion of the floor, not the intensity of the place",
                  "床の揺れから計算した計測震度相当値（その場所の震度ではない）"),
    "pga": ("peak ground acceleration", "地面の最大加速度"),
    "pgv": ("peak ground velocity", "地面の最大速度"),
    "pfa": ("peak floor acceleration", "床の最大加速度"),
    "pfv": ("peak floor velocity", "床の最大速度"),
    "mmi": ("modified Mercalli intensity", "改正メルカリ震度"),
    "mmi_scatter": (("The intensities are means of the two lines of Worden et al. (2012), from PGA and "
                     "PGV; what people report at a place has a standard deviation of 0.66 and 0.63 about "
                     "them, which the curves do not hold."),
                    ("改正メルカリ震度は、最大加速度と最大速度からWordenほか（2012）の2つの式で求めた値の"
                     "平均です。各地で実際に報告される震度は、"
                     "これらの式のまわりに標準偏差0.66と0.63でばらつきますが、曲線には含まれていません。")),
    "sa": ("spectral acceleration at {period:g} s", "周期{period:g}秒の加速度応答"),
    # counts and shapes
    "booleans": ("of type bool, with missing runs apart", "bool型（打ち切った計算はmissingで指定）"),
    "axes": ("of {dimensions} axes, none empty", "{dimensions}次元で、どの軸も1以上の長さ"),
    "either": ("{first} or {second}", "{first}または{second}"),
    "bad_counts": (("A level has {fell:g} falls of {runs:g} runs; it must have whole numbers, no more "
                    "falls than runs."),
                   ("転倒数が{fell:g}、計算数が{runs:g}の段階があります。整数とし、"
                    "転倒数は計算数以下にしてください。")),
    "measures": ("{known}, or SA(T) with a period T in seconds: SA(0.5)",
                 "{known}、または周期T秒のSA(T)（例：SA(0.5)）"),
    "no_runs": ("There are no runs, or all were given up; at least one is needed.",
                "有効な計算がありません。少なくとも1件の計算が必要です。"),
    # probabilities, differences and capacities in words
    "probability": ("{estimate} % ({low} to {high} %)", "{estimate}%（{low}～{high}%）"),
    "probability_unknown": ("unknown (no run)", "不明（計算なし）"),
    "difference": ("{low} to {high} points", "{low}～{high}ポイント"),
    "no_clear_difference": ("no clear difference", "明らかな差なし"),
    "difference_unknown": ("unknown (no pair of runs)", "不明（対になる計算なし）"),
    "capacity": ("{value} ({ends})", "{value}（{ends}）"),
    "capacity_above": ("> {above}", "{above}超"),
    "capacity_below": ("< {below}", "{below}未満"),
    "ends_not_run": ("interval wider than what was run", "区間は計算した範囲より広い"),
    "ends": ("{low} to {high}", "{low}～{high}"),
    "at_most": ("at most {high}", "{high}以下"),
    "more_than": ("more than {low}", "{low}超"),
    # curves in words
    "curve": ("Half fall at {measure} {half}, 10 % at {tenth}.{intervals}",
              "半数が転倒する{measure}は{half}、10%が転倒する{measure}は{tenth}です。{intervals}"),
    "of_one_motion": (" The intervals are for the one motion alone.",
                      "区間は、この1つの地震動だけについてのものです。"),
    "normal": ("normal", "正規分布"),
    "lognormal": ("lognormal", "対数正規分布"),
    "lognormal_curve": ("Nearest {family} curve: median {median}, dispersion {dispersion:.3g}.",
                        "最も近い{family}：中央値 {median}、ばらつき {dispersion:.3g}。"),
    "share": ("Share", "割合"),
    # files for loss tools
    "not_for_loss_tools": ("The curve {name} is not for loss tools: {why}.",
                           "曲線{name}は、損失評価ツール用に書き出せません（{why}）。"),
    "not_in_nrml": ("The curve {name} is over {measure}; in NRML it must be over {allowed}.",
                    "曲線{name}の指標は{measure}です。NRMLで使える指標は{allowed}です。"),
    "total": ("Number of pieces", "調べた個数"),
    "fell": ("Number of pieces that fell", "倒れた個数"),
    "samples": ("Samples", "試行数"),
    "level": ("Level of intensity", "震度の段階"),
    "rising_levels": ("three or more, each above the one before", "小さい順に並べた3個以上の段階"),
    "scatter": ("Scatter of the intensity", "震度のばらつき"),
    "left_out": ("{option} is not in the files for loss tools: {why}.",
                 "{option}は、損失評価ツール用のファイルに含まれていません（{why}）。"),
    "is_of_one_motion": ("one motion has no scatter of motions", "地震動が1つでばらつきが分からないため"),
    "has_no_median": ("the shaking at which half fall lies beyond what was run",
                      "半数が転倒する揺れが計算した範囲の外にあるため"),
}
