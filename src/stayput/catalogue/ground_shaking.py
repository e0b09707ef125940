"""How strongly the ground shakes: what was stated, by which model it is a strength, what it amounts to."""

TEXTS: dict[str, tuple[str, str]] = {
    "intensity": ("JMA intensity {value:.3g}", "計測震度{value:.3g}"),
    "pga": (
        "peak ground acceleration {value:.3g} m/s², to which each motion is scaled",
        "地面の最大加速度{value:.3g} m/s²（各地震動をこの値に合わせます）",
    ),
    "pgv": (
        "peak ground velocity {value:.3g} m/s, to which each motion is scaled",
        "地面の最大速度{value:.3g} m/s（各地震動をこの値に合わせます）",
    ),
    "mmi": (
        "modified Mercalli intensity {value:.3g}, as a peak ground velocity by Worden et al. (2012)",
        "改正メルカリ震度{value:.3g}（Wordenほか（2012）により最大速度に換算）",
    ),
    "earthquake": (
        (
            "magnitude {magnitude:.3g} at {distance:.3g} km, {depth:.3g} km deep, {kind}, on ground of "
            "{vs30:.3g} m/s, as a peak ground velocity by Si and Midorikawa (1999) and Fujimoto and "
            "Midorikawa (2006)"
        ),
        (
            "マグニチュード{magnitude:.3g}、断層からの距離{distance:.3g} km、深さ{depth:.3g} km、{kind}、"
            "地盤の平均S波速度{vs30:.3g} m/s（司・翠川（1999）と藤本・翠川（2006）により最大速度に換算）"
        ),
    ),
    "crustal": ("in the crust", "内陸の浅い地震"),
    "interface": ("between plates", "プレート境界の地震"),
    "intraslab": ("within a diving plate", "プレート内部の地震"),
    # How the motions have their strengths by it
    "scattered": (
        (
            "{about}: median {pgv:.3g} cm/s, standard deviation {scatter:g} of its common logarithm, from "
            "which each motion has a strength of its own; this is not the seismic hazard at your site"
        ),
        (
            "{about}。中央値{pgv:.3g} cm/s、常用対数の標準偏差{scatter:g}のばらつきから、地震動ごとに強さを割り当てます。"
            "お住まいの場所の地震危険度を示すものではありません"
        ),
    ),
    "middle": (
        (
            "{about}: {pgv:.3g} cm/s, the median; its scatter, a standard deviation of {scatter:g} of the common "
            "logarithm, needs several motions; this is not the seismic hazard at your site"
        ),
        (
            "{about}。中央値{pgv:.3g} cm/sです。ばらつき（常用対数の標準偏差{scatter:g}）は、地震動が複数の場合だけ"
            "考慮します。お住まいの場所の地震危険度を示すものではありません"
        ),
    ),
}
