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
    "capacity_one_motion": ("{value} (one motion: no interval)", "{value}（地震動が1つのため区間なし）"),
    "capacity_between": ("between {above} and {below}{doubt}", "{above}～{below}{doubt}"),
    "capacity_above": ("> {above}{doubt}", "{above}超{doubt}"),
    "capacity_below": ("< {below}{doubt}", "{below}未満{doubt}"),
    "ends_not_run": ("interval wider than what was run", "区間は計算した範囲より広い"),
    "ends": ("{low} to {high}", "{low}～{high}"),
    "at_most": ("at most {high}", "{high}以下"),
    "more_than": ("more than {low}", "{low}超"),
    "doubt_unsure": (" (unsure)", "（不確実）"),
    "doubt_one_motion": (" (one motion)", "（地震動が1つ）"),
    # curves in words
    "state_fitted": ("fitted", "曲線あり"),
    "state_none_fell": ("none fell", "転倒なし"),
    "state_all_fell": ("all fell", "すべて転倒"),
    "state_abrupt": ("abrupt", "ある強さから一斉に転倒"),
    "state_one_level": ("one level", "強さが1段階のみ"),
    "state_no_trend": ("no trend", "傾向なし"),
    "curve_fitted": ("Half fall at {measure} {half}, 10 % at {tenth}.{intervals}",
                     "半数が転倒する{measure}は{half}、10%が転倒する{measure}は{tenth}です。{intervals}"),
    "curve_none_fell": ("None of {runs} fell, up to {measure} {highest}.{intervals}",
                        "{measure}{highest}まで、{runs}の計算はどれも転倒しませんでした。{intervals}"),
    "curve_all_fell": ("All of {runs} fell, from {measure} {lowest} on.{intervals}",
                       "{measure}{lowest}から、{runs}の計算はすべて転倒しました。{intervals}"),
    "curve_one_level": ("At {measure} {level} {probability} fell; no other was run.{intervals}",
                        ("{measure}{level}で転倒した割合は{probability}です。"
                         "ほかの強さでは計算していません。{intervals}")),
    "curve_abrupt": (("There is no curve, as all stand up to a level and fall from the next: half fall at "
                      "{measure} {half}.{intervals}"),
                     ("ある強さまではすべて転倒せず、次の強さからはすべて転倒するため、曲線はありません。"
                      "半数が転倒する{measure}は{half}です。{intervals}")),
    "curve_no_trend": (("The share of falls does not grow with {measure} in {runs}, so there is no "
                        "curve.{intervals}"),
                       ("{runs}の計算では、{measure}が大きくなっても転倒の割合が増えないため、"
                        "曲線はありません。{intervals}")),
    "no_intervals": (" One motion tells nothing of how motions scatter: there are no intervals.",
                     "地震動が1つではばらつきが分からないため、区間はありません。"),
    "normal": ("normal", "正規分布"),
    "lognormal": ("lognormal", "対数正規分布"),
    "parameters": ("median {median}, dispersion {dispersion:.3g}",
                   "中央値 {median}、ばらつき {dispersion:.3g}"),
    "test": ("p = {p:.2g}, at most {points} points off", "p = {p:.2g}、差は最大{points}ポイント"),
    "lognormal_curve": ("A {family} curve {result}: {parameters}{test}.",
                        "{family}の曲線{result}：{parameters}{test}。"),
    "untested": ("cannot be tested on these runs", "が合うかどうかは、この計算では検定できません"),
    "unseen": ("has its median outside what was run", "の中央値は、計算した範囲の外にあります"),
    "fits": ("fits", "が合います"),
    "misfits": ("does not fit", "は合いません"),
    "of_one_motion": ("of one motion", "「地震動が1つ」"),
    # sample size
    "half_width": ("Half width", "信頼区間の半幅"),
    "share": ("Share", "割合"),
    # files for loss tools
    "not_fitted": ("The curve {name} is {state}; loss tools need one that is fitted, to several motions.",
                   ("曲線{name}の状態は{state}です。損失評価ツール用に書き出せるのは、"
                    "複数の地震動から当てはめのできた曲線だけです。")),
    "not_in_nrml": ("The curve {name} is over {measure}; in NRML it must be over {allowed}.",
                    "曲線{name}の指標は{measure}です。NRMLで使える指標は{allowed}です。"),
    "no_lognormal": ("Its falls are too abrupt for a lognormal.",
                     "転倒が急に始まるため、対数正規分布では表せません。"),
    # Intensity from fallen pieces
    "total": ("Number of pieces", "調べた個数"),
    "fell": ("Number of pieces that fell", "倒れた個数"),
    "samples": ("Samples", "試行数"),
    "level": ("Level of intensity", "震度の段階"),
    "rising_levels": ("three or more, each above the one before", "小さい順に並べた3個以上の段階"),
    "scatter": ("Scatter of the intensity", "震度のばらつき"),
    "left_out_state": ("{option} is not in the files for loss tools: it has no curve ({state}).",
                       ("{option}には曲線がないため、"
                        "損失評価ツール用のファイルに含まれていません（{state}）。")),
    "left_out_one_motion": (("{option} is not in the files for loss tools: one motion has no scatter of "
                             "motions."),
                            ("{option}は地震動が1つでばらつきが分からないため、"
                             "損失評価ツール用のファイルに含まれていません。")),
    "by_points": (("{option} is in pelicun.csv by its points, and taken to fall for certain above "
                   "{highest}. {why}"),
                  ("{option}はpelicun.csvに曲線上の点で書き出し、"
                   "{highest}を超えると必ず転倒するとみなしています。{why}")),
}
