"""The report of a verdict."""

TEXTS: dict[str, tuple[str, str]] = {
    # The page, from its top to its foot.
    "report": ("Verification of earthquake-proof measures", "家具の地震対策 検証報告書"),
    "skip": ("Skip to the ranking", "順位表へ移動"),
    "shaking": ("Shaking", "揺れの強さ"),
    "instrumental": ("JMA intensity {class} (instrumental {value})", "{class}（計測震度 {value}）"),
    "simulations": ("Simulations", "計算回数"),
    "simulations_text": ("{runs} runs in all; motions: {motions}; of each measure: {each}",
                         "合計{runs}回：地震動{motions}本、対策ごとに{each}回"),
    "motions": ("Motions", "地震動"),
    "not_precise": ("The precision that was asked for was not reached with the samples that were allowed.",
                    "指定された精度には、許された標本数では達していません。"),
    "one_motion": (("Only one motion was run: the shares and their intervals hold for this motion, not "
                    "for other earthquakes of the same intensity."),
                   ("地震動は1本だけです。割合と区間はこの地震動についてのもので、"
                    "同じ震度の他の地震には当てはまりません。")),
    "ranking": ("The measures, best first", "対策の順位"),
    "brief_ranking_text": (("Share of the cases in which it overturns, with the 95 % interval; measures that "
                            "do not clearly differ share a rank. {runs}."),
                           ("転倒する割合と95%区間です。明らかな差のない対策は同じ順位です。{runs}。")),
    "more_ranked": ("{count} more below, also what is not possible.",
                    "ほか{count}件は下の表にあります（設置できないものを含む）。"),
    "numbers": ("All measures in numbers", "すべての対策の数値"),
    "defaults": ("Defaults and limits of the model", "既定値とモデルの限界"),
    "trust": ("How far to trust it", "どこまで確かか"),
    "ranking_text": (("Shares of all runs with their 95 % intervals. All measures met the same motions "
                      "and the same draws. Ranked by what clearly differs: overturning, then what comes "
                      "out of the furniture, then sliding. What does not clearly differ shares a rank. "
                      "“Unsure”: the runs are too few to say it with 95 % confidence of all measures "
                      "together."),
                     ("全計算に対する割合と95%区間です。どの対策にも同じ地震動と同じ標本を用いています。"
                      "順位は、転倒、収納物の飛び出し、移動の順に、明らかな差があるもので決めます。"
                      "明らかな差がなければ同じ順位です。「不確実」は、計算数が少なく、"
                      "比較した対策全体で95%の信頼度では言えないものです。")),
    "grade": ("Grade of its inputs", "入力の根拠"),
    "grade_text": ("Grade: that of the weakest of the inputs that decide a number ({meanings}).",
                   "根拠：数値を左右する入力のうち、最も不確かなものの区分（{meanings}）。"),
    "weakest": ("Weakest inputs: {inputs}", "最も不確かな入力：{inputs}"),
    "rank": ("Rank", "順位"),
    "measure": ("Measure", "対策"),
    "overturned": ("Overturns", "転倒"),
    "slid": ("Slides more than {limit}", "{limit}を超える移動"),
    "hit_wall": ("Hits a wall", "壁に衝突"),
    "device_failed": ("A device fails", "器具の破損・脱落"),
    "slide": ("Peak slide, median", "最大移動量（中央値）"),
    "tilt": ("Peak tilt, median", "最大傾き（中央値）"),
    "most": ("90 %: {value}", "90%値：{value}"),
    "slide_both": ("Peak slide: median, 90 %", "最大移動量：中央値、90%値"),
    "capacity": ("Intensity at which {share} % overturn", "{share}%が転倒する計測震度"),
    "contents_out": ("Contents that come out", "飛び出す収納物"),
    "brief_contents_out": ("Contents\nout", "収納物の\n飛び出し"),
    "inside": ("Contents", "収納物"),
    "inside_text": (("{kind} on {shelves} shelves, {mass:.3g} kg; friction {static:g}, {kinetic:g}; lip "
                     "{lip:g} cm{front}"),
                    ("{kind}、{shelves}段、{mass:.3g} kg。摩擦係数{static:g}、{kinetic:g}。"
                     "棚の縁{lip:g} cm{front}")),
    "inside_doors": ("; doors: {doors}", "。扉：{doors}"),
    "inside_drawers": ("; drawers: {drawers}", "。引き出し：{drawers}"),
    "brief_overturned": ("Overturns", "転倒"),
    "brief_slid": ("Slides\n> {limit}", "移動\n> {limit}"),
    "brief_hit_wall": ("Hits\na wall", "壁に\n衝突"),
    "brief_device_failed": ("Device\nfails", "破損・\n脱落"),
    "brief_not_possible": ("not\npossible", "設置\n不可"),
    "brief_slide": ("Slide", "移動量"),
    "brief_falls": ("falls", "転倒"),
    "brief_capacity": ("I{share}", "I{share}"),
    "brief_text": (("Shares of all runs. Slide: median of the peak. I10, I50: where 10, 50 % overturn "
                    "({intensity}). Below, in brackets: the 95 % interval of overturning."),
                   ("全計算に対する割合です。移動量：最大値の中央値。I10、"
                    "I50：10%、50%が転倒する値（{intensity}）。かっこ内：転倒の95%区間。")),
    "capacity_short": ("{share} % overturn at intensity", "{share}%転倒の計測震度"),
    "change": ("Change from “{without}”", "「{without}」との差"),
    "why": ("Why", "理由"),
    "falls": ("overturned", "転倒"),
    "no_device": ("no device", "器具なし"),
    "interval": ("95 % interval", "95%区間"),
    "fragility": ("How strong may the shaking be?", "どの強さの揺れまで耐えるか"),
    "fragility_text": (("Share that overturns against the intensity, without a measure and with at "
                        "most the seven best. The marks are what was counted at each level, with 95 % "
                        "intervals as bars, moved apart sideways to be seen; the lines are fits to all "
                        "runs (logit); the bands are their 95 % intervals, as with other motions of the "
                        "same kind. Of more than three curves the first two have bands and bars."),
                       ("計測震度に対する転倒の割合です（対策なしと上位7つまでの対策）。印は各レベルで数えた割合、"
                        "細い縦線はその95%区間（重ならないよう左右にずらしています）、"
                        "線はすべての計算への当てはめ（ロジット曲線）、"
                        "帯は同じ種類の別の地震動も考えた95%区間です（曲線が4本以上なら最初の2本のみ）。")),
    "fragility_alt": (("Curves of the share that overturns over the intensity, one for each measure; the "
                       "numbers are in the table of the measures."),
                      "計測震度に対する転倒割合の曲線（対策ごと）。数値は順位の表にあります。"),
    "axis_share": ("Share that overturns", "転倒する割合"),
    "here": ("this shaking: {value}", "この揺れ：{value}"),
    "watch": ("See it happen", "動きを見る"),
    "typical": ("A typical case", "典型的な場合"),
    "typical_text": (("Of all draws the one that differs least from the others in what falls, without a "
                      "measure and with it. The same motion and the same draw on both sides."),
                     ("対策の有無とも、何が倒れるかがほかの標本に最も近い計算です。"
                      "どちらも同じ地震動・同じ標本です。")),
    "typical_also_falls": ("With the measure it overturns in {share} of the cases, and in this run.",
                           "この対策では{share}の場合に転倒し、この計算でも転倒します。"),
    "typical_is_held": ("With the measure it overturns in {share} of the cases, but not in this run.",
                        "この対策では{share}の場合に転倒しますが、この計算では転倒しません。"),
    "typical_never_falls": ("None of the runs with the measure overturns, nor does this one.",
                            "この対策では、この計算を含むどの計算でも転倒しません。"),
    "worst": ("The worst case", "最悪の場合"),
    "worst_text": ("The run that went worst with the best of those compared, and the same one without it.",
                   "比較した中で最良の案で最も悪い結果になった計算と、その案なしの同じ計算です。"),
    "worst_bare_text": ("{without}, the run that went worst.", "{without}で最も悪い結果になった計算です。"),
    "scene_alt": ("Animation of what stands in the room: {content}", "部屋と家具の動画：{content}"),
    "histories": ("Time histories", "時刻歴"),
    "typical_bare_text": ("Of all draws the one that differs least from the others in what falls.",
                          "何が倒れるかがほかの標本に最も近い計算です。"),
    "axis_time": ("Time [s]", "時刻 [s]"),
    "motion_shown": (("Motion {number} of {count}: {name}; {peak}. Shown from {start} to {end} s of "
                      "{duration} s."),
                     "地震動 {number}/{count}：{name}、{peak}。全{duration}秒のうち{start}～{end}秒を表示。"),
    "estimates": ("Quick estimates, to compare", "簡易式による目安"),
    "estimates_text": (("These are formulas for a piece that does not slide and stands free, not "
                        "simulations. They are here so that the size of the results can be checked."),
                       ("滑らず周囲に壁のない家具についての略算式で、シミュレーションではありません。"
                        "結果の大きさを確かめるために並べています。")),
    "formula": ("Formula", "式"),
    "says": ("What it says", "内容"),
    "beside": ("Simulation, with the walls and contents that there are",
               "シミュレーション（実際の壁や収納物を含む）"),
    "west": ("West", "ウェストの式"),
    "west_text": ("rocks where the floor's peak acceleration exceeds {value} m/s²",
                  "床の最大加速度が{value} m/s²を超えるとロッキングを始める"),
    "ishiyama": ("Ishiyama (1982)", "石山（1982）"),
    "ishiyama_text": (("can only overturn where the floor's peak velocity also exceeds {value} cm/s: "
                       "{share} of the motions"),
                      "さらに床の最大速度が{value} cm/sを超えないと転倒しない：該当する地震動は{share}"),
    "kaneko": ("Kaneko and Hayashi", "金子・林の式"),
    "kaneko_text": ("{share} overturn", "{share}が転倒"),
    "equipment": ("Japanese equipment guideline, class {grade}, {position}",
                  "建築設備の耐震指針、耐震クラス{grade}、{position}"),
    "position_upper": ("upper storeys", "上層階"),
    "position_middle": ("middle storeys", "中間階"),
    "position_ground": ("ground floor", "1階"),
    "equipment_overturns": (("overturns under the static load K_H = {coefficient}; a tie at its top needs "
                             "{force} N"),
                            "静的な水平震度K_H = {coefficient}で転倒する。頂部で支えるには{force} Nが必要"),
    "equipment_stands": ("does not overturn under the static load K_H = {coefficient}",
                         "静的な水平震度K_H = {coefficient}では転倒しない"),
    "ac156": ("AC156 shake-table test (ASCE 7-16), z/h {ratio}",
              "AC156の振動台試験（ASCE 7-16）、z/h {ratio}"),
    "ac156_text": (("rocks the piece where it is made for S_DS of {value} g or more (A_rig reaches West's "
                    "acceleration)"),
                   "S_DSが{value} g以上の試験でロッキングを始める（A_rigがウェストの式の加速度に達する）"),
    "asce43": ("ASCE 43-05, approximate sliding", "ASCE 43-05の滑りの略算"),
    "asce43_text": (("were it only to slide, {share} of the motions would move it, half of these by more "
                     "than {distance}"),
                    "滑りだけが起こるとすれば、地震動の{share}で動き、その半数では{distance}より大きく動く"),
    "asce43_all": ("were it only to slide, all motions would move it, half of them by more than {distance}",
                   "滑りだけが起こるとすれば、すべての地震動で動き、その半数では{distance}より大きく動く"),
    "asce43_still": ("would not slide under any of the motions", "どの地震動でも滑らない"),
    "details": ("Each measure", "対策ごとの詳細"),
    "drawing_alt": (("Drawing to scale, seen from the side: {piece}, {width} cm deep and {height} cm "
                     "high; {label}"),
                    "縮尺図（横から）：{piece}、奥行{width} cm、高さ{height} cm。{label}"),
    "device": ("Device", "器具"),
    "weakest_link": ("Weakest link", "最初に壊れるところ"),
    "failed": ("Failed", "破損・脱落"),
    "failure_time": ("Fails at, median", "破損・脱落の時刻（中央値）"),
    "seconds": ("{value} s", "{value} 秒"),
    "peak_force": ("Largest force that it bore: median, 90 %", "負担した最大の力：中央値、90%値"),
    "used": ("Of its strength: median, 90 %", "強度に対する割合：中央値、90%値"),
    "demand": ("Asked of its strength, were it unbreakable: median, 90 %",
               "壊れないとした場合の力の強度に対する割合：中央値、90%値"),
    "devices": ("Loads in the devices", "器具にかかる力"),
    "parameter": ("Parameter", "項目"),
    "value": ("Value", "値"),
    "confidence": ("How well founded", "確からしさ"),
    "parameters": ("Parameters", "設定値"),
    "assumptions": ("What this rests on", "前提"),
    "assumptions_text": (("Values marked as defaults are common values that were not measured on your "
                          "furniture. Measure what matters, above all friction and the strength of wall, "
                          "ceiling and anchors."),
                         ("「既定値」は一般的な値で、お使いの家具で測ったものではありません。特に摩擦と、"
                          "壁・天井・留め具の強さは、実際に確かめてください。")),
    "assumption": ("Assumption", "前提"),
    "low": ("default, low confidence", "既定値・信頼度 低"),
    "medium": ("default, medium confidence", "既定値・信頼度 中"),
    "high": ("default, high confidence", "既定値・信頼度 高"),
    "given": ("given by the user", "利用者の指定"),
    "model": ("limit of the model", "モデルの限界"),
    "again": ("To do it again", "再現するには"),
    "again_text": (("Save this as {file}, and run the command with stayput {version}. The same seed gives "
                    "the same numbers."),
                   ("これを{file}に保存し、stayput {version}でコマンドを実行します。"
                    "同じ乱数のシードなら同じ数値になります。")),
    "record_text": ("It names files of records; they are needed too, in the same place relative to it.",
                    "記録ファイルの名前を含みます。それらも同じ相対位置に必要です。"),
    "command": ("Command", "コマンド"),
    "took": ("{seconds} s of computing", "計算時間 {seconds} 秒"),
    "version": ("Version", "版"),
    "caution": ("A simulation of rigid bodies is not a guarantee. Real rooms, walls and fixings differ.",
                ("これは剛体のシミュレーションであり、安全を保証するものではありません。実際の部屋や壁、"
                 "固定の状態はこれと異なります。")),
    "floor": ("Floor", "床"),
    "piece": ("Furniture", "家具"),
    "wall": ("Wall behind", "背後の壁"),
    "wall_fixing": ("What devices are fixed to in the wall behind", "背後の壁で器具を留める相手"),
    "ceiling_fixing": ("What poles push against in the ceiling", "天井でポールが押す相手"),
    "front_wall": ("Wall in front", "前方の壁"),
    "near_side_wall": ("Wall at the near side", "手前側の側壁"),
    "far_side_wall": ("Wall at the far side", "奥側の側壁"),
    "ceiling": ("Ceiling", "天井"),
    "building": ("Building", "建物"),
    # What a verdict rests on.
    "piece_text": (("{width:g} m × {length}{height:g} m, {mass:.4g} kg, centre of gravity {up:.3g} m "
                    "up{forward}"),
                   "{width:g} m × {length}{height:g} m、{mass:.4g} kg、重心の高さ {up:.3g} m{forward}"),
    "length": ("{length:g} m × ", "{length:g} m × "),
    "forward": (", {across:+.3g} m forward", "、前方へ {across:+.3g} m"),
    "surface": ("{name}: ", "{name}："),
    "frictions": ("{surface}static friction {static:g}, kinetic {kinetic:g}",
                  "{surface}静止摩擦係数 {static:g}、動摩擦係数 {kinetic:g}"),
    "gap_text": ("{gap:.3g} cm away", "すき間 {gap:.3g} cm"),
    "height_text": ("{height:g} m high", "高さ {height:g} m"),
    "strength": ("Strength of the ground's shaking", "地面の揺れの強さ"),
    "motions_read": ("{count}, read from {name}{mean}", "{count}本（{name}から読込み{mean}）"),
    "motions_synthetic": ("{count} synthetic ones ({family}): computed, not recorded",
                          "模擬地震動{count}本（{family}）：計算で作ったもので、観測記録ではありません"),
    "motion_synthetic": ("{name}, synthetic: not recorded", "{name}（模擬）：観測記録ではありません"),
    "sine": ("sine {values}", "正弦波 {values}"),
    "suite": ("synthetic {family} suite, seed {seed}", "模擬地震動群（{family}、乱数の種{seed}）"),
    "japanese_target": ("Japanese design spectrum, {level}, soil {soil}",
                        "建築基準法の設計用スペクトル（{level}、第{soil}種地盤）"),
    "building_name": ("{storeys}-storey {structure} building", "{storeys}階建て（{structure}）"),
    "model_name": ("{masses}-mass shear model", "{masses}質点せん断モデル"),
    "motion_on_floor": ("{motion}, {place} of {building}", "{motion}（{building}の{place}）"),
    "floor_name": ("storey {storey}", "{storey}階"),
    "ground_name": ("ground", "地盤"),
    "standard_input": ("standard input", "標準入力"),
    "suite_member": ("synthetic {family} {number}", "模擬地震動（{family}）{number}"),
    "building_text": ("{name}, floor of storey {storey}, as a shear model",
                      "{name}、{storey}階の床（せん断質点系モデル）"),
    "lognormal": ("lognormal, median {median:g}, coefficient of variation {cov:g}",
                  "対数正規分布、中央値 {median:g}、変動係数 {cov:g}"),
    "normal": ("normal, mean {mean:g}, standard deviation {deviation:g}",
               "正規分布、平均 {mean:g}、標準偏差 {deviation:g}"),
    "uniform": ("uniform, {low:g} to {high:g}", "一様分布、{low:g}～{high:g}"),
    "limit_body": ("Rigid body in a plane", "平面内の剛体"),
    "limit_body_text": (("No shaking across the piece, no turning about its vertical axis, no bending. "
                         "What is inside does not act on the piece; whether it comes out is computed "
                         "where the scenario says what is inside."),
                        ("奥行方向以外の水平動、水平面内の回転、家具の変形は考慮しません。"
                         "収納物は家具の動きに影響しないものとし、"
                         "飛び出しは収納物が指定されている場合にだけ計算します。")),
    "limit_contacts": ("Contacts", "接触"),
    "limit_contacts_text": (("Coulomb friction; a landing corner does not bounce, and rocking loses what "
                             "the momentum balance about the place of the landing demands, and a drawn "
                             "part more."),
                            ("クーロン摩擦。着地した角は跳ね返らず、"
                             "ロッキングは着地点まわりの運動量のつり合いと、"
                             "ばらつきとして与えた損失に従って減衰します。")),
    "limit_devices": ("Devices", "器具"),
    "limit_devices_text": (("Springs with slack, damping and the strength of their weakest link. Age is "
                            "not in it; faulty mounting only where “as people install it” is asked for."),
                           ("がた・減衰と、最も弱い部分の強さをもつばねです。経年劣化は含みません。"
                            "取付け不良は「実際の取付け」を指定した場合にだけ含みます。")),
    # What is drawn at random.
    "as_stated": ("as stated, not drawn", "入力値のまま（ばらつきなし）"),
    "quantity_friction": ("Friction, factor on its value", "摩擦係数に掛ける倍率"),
    "quantity_restitution": ("Rebound of the rocking, factor", "ロッキングの反発に掛ける倍率"),
    "quantity_wall_restitution": ("Restitution of the walls", "壁の反発係数"),
    "quantity_mass": ("Mass, factor on its value", "質量に掛ける倍率"),
    "quantity_gravity_height": ("Height of the centre of gravity, factor", "重心の高さに掛ける倍率"),
    "quantity_wall_gap": ("Gaps to the walls, factor on their value", "壁とのすき間に掛ける倍率"),
    "quantity_lean": ("Lean of the floor, along the shaking's x [rad]", "床の傾き（揺れのx方向へ、rad）"),
    "quantity_back_inset": ("Feet or plinth inside the back, part of the depth",
                            "背面から脚・台輪までの距離（奥行きに対する比）"),
    "quantity_front_inset": ("Feet or plinth inside the front, part of the depth",
                             "前面から脚・台輪までの距離（奥行きに対する比）"),
    "quantity_settlement": ("Sinking into the floor, factor on its value", "床の沈み込みに掛ける倍率"),
    "quantity_landing_place": ("Where a landing pushes (1: at the edge, Housner), part of half the base",
                               "着地の力の位置（1：底の角、ハウスナー）"),
    "quantity_strength": ("Strength of the devices, factor", "器具の強さに掛ける倍率"),
    # What is left out of the files of curves, and why.
    "in_no_file": ("{option} is in no file: it cannot be put in place. {reason}",
                   "{option}は設置できないため、どのファイルにも含まれていません。{reason}"),
    "renamed": ("{option} is {identifier} in the files for loss tools, which take plain names.",
                ("{option}は、損失評価ツール用のファイルでは{identifier}という名前になります（英数字のみ使"
                 "えるため）。")),
    "no_nrml": ("There is no NRML file: OpenQuake has no {measure}.",
                "OpenQuakeには{measure}がないため、NRMLファイルはありません。"),
    "overturning_of": ("Overturning of {piece}", "{piece}の転倒"),
    "motions_shown": ("Motions: {motions}", "地震動：{motions}"),
}
