"""Verdicts: what happens with each measure, and why; Monte Carlo sampling behind them."""

TEXTS: dict[str, tuple[str, str]] = {
    "of_a_floor": (("The motions are of {floor}, not of the ground: their intensity is what JMA's formula "
                    "gives for them and not that of the place, and the peaks are the floor's. The "
                    "equipment guideline and AC156 go by the storeys of the building, which are not "
                    "known, and are left out."),
                   ("地震動は{floor}の揺れで、地面の揺れではありません。"
                    "計測震度は床の揺れから計算した値でその場所の震度ではなく、最大値も床のものです。"
                    "設備の指針とAC156は建物の階数によるため省いています。")),
    "strength": ("Strength of the ground's shaking: {strength}.", "地面の揺れの強さ：{strength}。"),
    "in_space": (("Simulated in space, under all components of the motions ({components}); the piece faces "
                  "{heading:.0f}° from their x."),
                 ("三次元で、地震動のすべての成分（{components}）を使って計算しました（家具の向きはx成分から"
                  "{heading:.0f}°）。")),
    "in_space_drawn": (("Simulated in space, under all components of the motions ({components}), whose "
                        "direction in plan is drawn anew in each run."),
                       ("三次元で、地震動のすべての成分（{components}）を使い、"
                        "x成分の向きを毎回変えて計算しました。")),
    "no_length": (("Simulated in the plane of the piece's depth, since its length is not stated: the "
                   "shaking along the length is left out{held}."),
                  ("家具の幅（length）が指定されていないため、奥行き方向だけで計算しました。"
                   "幅の方向の揺れは含まれません{held}。")),
    "in_plane": (("Simulated in the plane of the piece's depth, as asked: the shaking along its length is "
                  "left out{held}."),
                 "指定のとおり奥行き方向だけで計算しました。幅の方向の揺れは含まれません{held}。"),
    "may_fail": (", and what holds here may fail in a real earthquake",
                 "（ここでは持ちこたえる器具も、実際の地震では外れることがあります）"),
    "one_component": (("The motion has one horizontal component: a real earthquake shakes in three "
                       "directions, and what holds the furniture bears more."),
                      ("地震動の水平成分は1つだけです。実際の地震は3方向に揺れ、"
                       "器具の負担はこれより大きくなります。")),
    # verification
    "needs_coulomb": ("'coulomb' for a verification", "検証では'coulomb'"),
    "slide_limit": ("Slide limit", "移動量の上限"),
    "no_shaking": ('a Motion, a Suite or such as "6-upper"', 'Motion、Suite、"6-upper"など'),
    "said_already": ("beside a {kind}, which says it already", "それを含む{kind}"),
    "no_option": ("There is no option {value}; the options are {allowed}.",
                  "案{value}はありません。案は{allowed}です。"),
    "levels_not_increasing": ("The levels are not increasing; each must be higher than the one before it.",
                              ("震度の段階が小さい順に並んでいません。"
                               "前の段階より大きい値を順に指定してください。")),
    # the verdict in a sentence
    "falls": ("in {share} of the cases", "{share}の場合に転倒します"),
    "no_bare_run": ("No run without {none} could be followed to its end, so nothing can be said.",
                    "{none}なしの計算が最後まで進まなかったため、判定できません。"),
    "none": ("a measure", "対策"),
    "if_there": ("{option}", "{option}があれば"),
    "what": ("{name}", "この家具は"),
    "better": (("In shaking of JMA intensity {strength} {what} overturns {falls}{bare}; with {option}, in "
                "{share}."),
               "{strength}の揺れで、{bare}{what}{falls}。{option}{share}です。"),
    "stays_upright": (("In shaking of JMA intensity {strength} {what} stays upright without any "
                       "measure{doubt}."),
                      "{strength}の揺れでも、{what}対策なしで転倒しません{doubt}。"),
    "not_ruled_out": (" in these runs; it may overturn in {share} of the cases",
                      "（今回の計算の範囲では。{share}の場合に転倒する可能性は否定できません）"),
    "bare_falls": ("In shaking of JMA intensity {strength} {what} overturns {falls}{bare}{more}.",
                   "{strength}の揺れで、{bare}{what}{falls}。{more}"),
    "none_helps": (", and no measure that was compared makes that clearly rarer",
                   "比較した対策では明らかには減りません。"),
    "slides_less": ("With {option} {it} slides by over {limit} in {held} of the cases instead of {bare}.",
                    "{option}、{it}{limit}を超えて移動する割合は{bare}から{held}に減ります。"),
    # why an option stands where it does: clauses
    "no_run": ("No run could be followed to its end.", "最後まで進んだ計算がありません。"),
    "it": ("it", ""),
    "overturns": ("{it} overturns {falls}", "{it}{falls}"),
    "no_clear_change": ("no clear difference from without {none} in how often {it} overturns",
                        "転倒する割合は{none}なしと明らかな差がありません"),
    "less_often": ("{it} overturns in {held} of the cases instead of {bare}",
                   "転倒は{bare}から{held}に減ります"),
    "more_often": ("{it} overturns more often than without {none}, in {held} of the cases",
                   "転倒は{none}なしより増えて{held}です"),
    "more_contents_out": ("clearly more of the contents come out than without {none}",
                          "収納物の飛び出しは{none}なしより明らかに増えます"),
    "more_slid": ("it clearly slides too far more often than without {none}",
                  "大きく移動する割合は{none}なしより明らかに増えます"),
    "device_fails": ("a device fails in {share}", "器具は{share}の場合に破損または脱落します"),
    "gives_way": ("mostly {weakest}", "多くは{weakest}ことによります"),
    "caution": ("caution: {caution}", "注意：{caution}"),
    "slides_far": ("in 10 % or more it slides by over {far:g} m, as no wall in front or behind stops it",
                   "10%以上の場合に{far:g} mを超えて移動します（止める壁がありません）"),
    "slides": ("in 90 % it slides by {length} at most", "90%の場合は移動が{length}以内です"),
    "stays_where_it_is": ("it stays where it is", "その場に留まります"),
    # what comes out of the furniture: clauses, and sentences that follow the verdict's
    "contents_out": ("{share} of the {contents} come out", "{contents}の{share}が飛び出します"),
    "contents_leave": ("where the piece stands, {from_where}, 90 % of them at {fast:.2f} m/s or less",
                       "家具が立っている場合、{from_where}、90%は水平速度{fast:.2f} m/s以下で飛び出します"),
    "from_shelves": ("half of them leave from {height} or higher (at most {most})",
                     "その半数は高さ{height}以上（最高{most}）から"),
    "from_the_top": ("half of them or more leave from {highest}, none from higher",
                     "その半数以上は最も高い{highest}から"),
    "contents_unknown": ("what the {contents} do is unknown", "{contents}の動きは計算できませんでした"),
    "contents_without": (" ({share} without a measure)", "（対策なしでは{share}）"),
    "contents_with": ("With {measure}{held}{clause}{aside}.", "{measure}{held}{clause}{aside}。"),
    "held": (", ", "があると"),
    "well_held": (", well installed, ", "を正しく取り付けた場合、"),
    "contents_alone": ("And {clause}.", "また、{clause}。"),
    "stands_but": ("It then mostly stands, but {clause}{aside}.", "倒れなくても、{clause}{aside}。"),
    # notes beside the numbers
    "field": (("Against the field: half of such pieces overturn at a peak floor velocity of {median:.0f} "
               "cm/s here, {least:.2g} to {most:.2g} times what is given for unanchored furniture that "
               "stands free and does not slide: {low:.0f} cm/s (FEMA P-58) to {high:.0f} cm/s (Kaneko and "
               "Hayashi)."),
              ("既往の式との比較：この家具の半数が転倒する床の最大速度は、ここでは{median:.0f} cm/sです。"
               "これは、壁のない、滑らない未固定家具の式の値（FEMA P-58：{low:.0f} cm/s、金子・林："
               "{high:.0f} cm/s）の{least:.2g}～{most:.2g}倍です。")),
    "contents_bound": (("What the contents do to the furniture itself is bounded, not computed: over the "
                        "{runs} runs in which they were followed, one of each motion, it overturns "
                        "without a measure in {rigid} with all of them fixed to it, and in {emptied} "
                        "without any.{opened}"),
                       ("収納物が家具に及ぼす影響は、計算せず幅で示します。"
                        "収納物を追跡した計算（地震動ごとに1回、計{runs}回）では、対策なしの転倒は、"
                        "すべて固定した場合が{rigid}、空の場合が{emptied}です。{opened}")),
    "drawers_open": (" With its drawers half open it overturns in {share}.",
                     "引き出しが半分開いた状態では{share}が転倒します。"),
    "estimate_differs": (("The quick estimate (Kaneko and Hayashi) lets {formula} % overturn without a "
                          "measure, the simulation {simulated}. The formula leaves out: {left_out}."),
                         ("対策なしの転倒は、簡易式（金子・林）では{formula}%、"
                          "シミュレーションでは{simulated}です。簡易式が考慮していないもの：{left_out}。")),
    "may_slide": ("a floor on which it may slide (friction {friction:.2g}, depth over height {slender:.2g})",
                  "滑ることのある床（摩擦係数{friction:.2g}、奥行き÷高さ{slender:.2g}）"),
    "centre_off_middle": ("a centre of gravity at {percent:.0f} % of the height, not at half",
                          "高さの{percent:.0f}%にある重心（式では50%）"),
    "of_their_own": (("what these motions and this piece have of their own (its spread, ζ = 0.5, stands "
                      "for all kinds of earthquakes and furniture on average)"),
                     "この地震動と家具に固有の性質（式のばらつきζ=0.5は、さまざまな地震と家具の平均的な値）"),
    "as_installed": (("as people install it, {usual} overturn (well installed: {well}): {share} % of such "
                      "devices are badly installed ({how})"),
                     ("実際の取付けでは転倒{usual}（正しく取り付けた場合{well}。{share}%が取付け不良："
                      "{how}）")),
    "alike_as_installed": (("as people install it, {usual} overturn, no clear difference from when it is "
                            "well installed: {share} % of such devices are badly installed ({how})"),
                           ("実際の取付けでも転倒{usual}で、"
                            "正しく取り付けた場合と明らかな差はありません（{share}%が取付け不良：{how}）")),
    "best_as_installed": ("With {measure}, as people install such devices, it overturns in {share}.",
                          "{measure}を実際の取付けのとおりとすると、{share}の場合に転倒します。"),
    "overturns_as_installed": ("As people install it, it overturns in {share}.",
                               "実際の取付けでは{share}の場合に転倒します。"),
    "latches_hold": ("Latched doors are taken to stay shut when the furniture falls.",
                     "ラッチ付きの扉は、家具が倒れても閉じたままと仮定しています。"),
    "trust_A": ("Well founded (grade A). Measured or stated: {inputs}.",
                "根拠は確かです（区分A）。測定値または指定値：{inputs}。"),
    "trust_B": ("Fairly sure (grade B). Usual values, which scatter, are taken for: {inputs}.",
                "根拠はほぼ確かです（区分B）。ばらつきのある一般的な値によるもの：{inputs}。"),
    "trust_C": ("Rough (grade C). Assumed, not measured: {inputs}. Your own values would make it surer.",
                "目安です（区分C）。仮定した値によるもの：{inputs}。実際の値を入れるとより確かになります。"),
    "and_more": ("; and {more} more", "、ほか{more}件"),
    "meets": (("In {fell} of {runs} runs {first} and {second} strike each other. What they do to each other "
               "then is not followed."),
              "計算{runs}回中{fell}回、{first}と{second}がぶつかります。その後、互いに及ぼす影響は計算していません。"),
    "meets_with": (("{option}: then {first} and {second} strike each other in {fell} of {runs} runs. What "
                    "they do to each other is not followed."),
                   ("{option}：この場合、計算{runs}回中{fell}回、{first}と{second}がぶつかります。"
                    "互いに及ぼす影響は計算していません。")),
    "alike": (("{pieces} are of one kind: they are computed as one, and those that face the same way fall "
               "together. Real ones differ, so that the chance that any of them falls lies between {least} "
               "and {most} %."),
              ("{pieces}は同じ種類なので、1つとして計算し、同じ向きのものは同時に倒れるものとします。"
               "実際には個体差があり、どれかが倒れる確率は{least}〜{most}%です。")),
    "slides_off": (("A slide of more than {far:g} m is shown as “> {far:g} m” only: the room has no wall "
                    "on one side, so nothing stops a piece that slides or rolls off. If something would "
                    "stop it, give it as a wall."),
                   ("{far:g} mを超える移動は「> {far:g} m」と示します。"
                    "壁のない側では止めるものがないためです。実際に壁や家具があれば、"
                    "壁として指定してください。")),
    "everyday_tips": (("Without an earthquake, {case} tips the piece over: the moment of its own weight "
                       "is {margin:.2f} times the overturning one (grade {letter}; not a certificate by "
                       "any stability rule)."),
                      ("地震がなくても、{case}に倒れます：自重で支えられるモーメントは、"
                       "かかるモーメントの{margin:.2f}倍です（根拠は{letter}。"
                       "いかなる安定性基準の認証でもありません）。")),
    "everyday_stays": (("Without an earthquake, the piece withstands {case}; the margin is {margin:.2f}, "
                        "the moment of its own weight over the overturning one (grade {letter}; not a "
                        "certificate by any stability rule)."),
                       ("地震がないとき、{case}でも倒れず、余裕は{margin:.2f}倍です："
                        "自重で支えられるモーメントの、かかるモーメントに対する比です（根拠は{letter}。"
                        "いかなる安定性基準の認証でもありません）。")),
    "everyday_on_carpet": ("{case} (with carpet that lifts its back by {carpet:.0f} mm)",
                           "カーペットで背面が{carpet:.0f} mm浮き、{case}"),
    "everyday_pull": ("a forward pull of {pull:g} N at {height:.2f} m",
                      "高さ{height:.2f} mを{pull:g} Nで手前に引いた場合"),
    "everyday_load": ("{load:g} kg on its front edge", "前縁に{load:g} kgの荷重がかかった場合"),
    "everyday_one_drawer": ("{load:g} kg on one open drawer",
                            "開いた引き出し1つに{load:g} kgの荷重がかかった場合"),
    "everyday_all_drawers": ("{load:g} kg on one of its {drawers} drawers with all of them open",
                             "引き出し{drawers}つをすべて開け、その1つに{load:g} kgの荷重がかかった場合"),
    # inputs that decide an outcome
    "size_and_mass": ("size and mass of the piece", "家具の寸法と質量"),
    "floor_settlement": ("how far the floor gives", "床の沈み込み"),
    "floor_friction": ("friction on the floor", "床の摩擦"),
    "the_building": ("the building", "建物"),
    "the_wall": ("what is behind the wall's surface", "壁の下地"),
    "the_ceiling": ("what is above the ceiling's surface", "天井の下地"),
    # probability distributions and draws
    "mean": ("Mean", "平均"),
    "deviation": ("Deviation", "標準偏差"),
    "median": ("Median", "中央値"),
    "cov": ("Coefficient of variation", "変動係数"),
    "low": ("Low", "下限"),
    "high": ("High", "上限"),
    "draws": ("Draws", "サンプル数"),
    "start": ("Start", "開始番号"),
    "motions": ("Motions", "地震動の数"),
    "above_zero_to": ("larger than 0 and at most {most:g}", "0より大きく{most:g}以下の値"),
    "low_not_below_high": ("Low is {low:g} and high is {high:g}; low must be below high.",
                           "下限が{low:g}、上限が{high:g}になっています。下限は上限より小さくしてください。"),
}
