"""How strongly the ground shakes: what was stated, and what it amounts to by which model."""

TEXTS: dict[str, tuple[str, str]] = {
    "intensity": ("JMA intensity {value:.3g}", "計測震度{value:.3g}"),
    "value": ("{value:.3g}", "計測震度{value:.3g}"),
    "pga": ("peak ground acceleration {hundredfold:.4g} gal = {value:.4g} m/s²",
            "地面の最大加速度{hundredfold:.4g} gal = {value:.4g} m/s²"),
    "pgv": ("peak ground velocity {hundredfold:.4g} cm/s = {value:.4g} m/s",
            "地面の最大速度{hundredfold:.4g} cm/s = {value:.4g} m/s"),
    "sa": ("spectral acceleration {hundredfold:.4g} gal = {value:.4g} m/s² at {period:g} s",
           "周期{period:g}秒の加速度応答{hundredfold:.4g} gal = {value:.4g} m/s²"),
    "magnitude": ("magnitude {magnitude:.3g} at {distance:.3g} km",
                  "マグニチュード{magnitude:.3g}、断層までの距離{distance:.3g} km"),
    "scaled": ("{stated}, to which each motion is scaled", "{stated}（各地震動をこの値に合わせます）"),
    "of_floor": ("{strength} (by the motion on {floor}, not of the place)",
                 "{strength}相当（{floor}の揺れによる値で、その場所の震度ではない）"),
    "of_class": ("{strength} ({stated})", "{strength}（{stated}）"),
    "mmi": ("modified Mercalli intensity {value:.3g}", "改正メルカリ震度{value:.3g}"),
    "mmi_source": ("Worden et al. (2012)", "Wordenほか（2012）"),
    "earthquake": (("magnitude {magnitude:.3g} at {distance:.3g} km, {depth:.3g} km deep, {kind}; mean "
                    "shear-wave velocity of the ground {vs30:.4g} m/s"),
                   ("マグニチュード{magnitude:.3g}、断層までの距離{distance:.3g} km、深さ{depth:.3g} km、"
                    "{kind}、地盤の平均S波速度{vs30:.4g} m/s")),
    "earthquake_source": ("Si and Midorikawa (1999) and Fujimoto and Midorikawa (2006)",
                          "司・翠川（1999）と藤本・翠川（2006）"),
    "crustal": ("in the crust", "内陸の浅い地震"),
    "interface": ("between two plates", "プレート境界の地震"),
    "intraslab": ("within a diving plate", "プレート内部の地震"),
    "scattered": (("{about}. By {source} the peak velocity of the ground is {pgv:.3g} cm/s, times or over "
                   "{spread:.2g} (one standard deviation); {how}. This is not the seismic hazard at your "
                   "site"),
                  ("{about}。{source}による地面の最大速度は{pgv:.3g} cm/sで、"
                   "標準偏差は{spread:.2g}倍（または1/{spread:.2g}）です。{how}。"
                   "お住まいの場所の地震危険度を示すものではありません")),
    "each_drawn": ("each motion has a strength of its own out of this scatter",
                   "このばらつきに合わせて、地震動ごとに強さを変えます"),
    "median_alone": ("the one motion has the median, without this scatter",
                     "地震動が1つなので中央値を使い、ばらつきは考慮しません"),
}
