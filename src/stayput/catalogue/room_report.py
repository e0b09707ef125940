"""The report of a verdict on a room, and its plan."""

TEXTS: dict[str, tuple[str, str]] = {
    # The page, from its top to its foot
    "skip": ("Skip to the plan", "平面図へ移動"),
    "any_hit": ("Somebody is hit, at one place or more", "どこかの場所で人に家具が当たる確率"),
    "any_shut_in": ("Somebody has no way out from somewhere", "どこかの場所から外に出られなくなる確率"),
    "missing": (("{missing} of {all} runs of the room could not be followed to the end, and are not in "
                 "the chances."),
                "部屋の計算{all}回のうち{missing}回は最後まで計算できず、確率に含めていません。"),
    # The plan
    "plan": ("The room, and where the pieces come to lie", "部屋と、家具が行き着く場所"),
    "plan_alt": ("Plan to scale of a room {width:g} m wide and {length:g} m long: {content}",
                 "幅{width:g} m、奥行き{length:g} mの部屋の平面図（縮尺どおり）：{content}"),
    "plan_text": (("The pieces are drawn as they stand now, with a thick side at the front. A piece falls "
                   "if it overturns in at least {falls:.0f} % of the runs and may fall from "
                   "{may_fall:.0f} % on; it moves if it slides too far or rocks in at least "
                   "{may_fall:.0f} %. Cells show where pieces are after the shaking: the lightest in up "
                   "to 10 % of the runs, the darkest in over 90 %."),
                  ("家具は地震前の位置に描き、太い辺が前面です。"
                   "転倒が計算の{falls:.0f}%以上なら「倒れる」、"
                   "{may_fall:.0f}%以上なら「倒れることがある」、"
                   "大きく滑るか揺れ動くのが{may_fall:.0f}%以上なら「動く」とします。"
                   "塗った範囲は揺れの後に家具がある場所で、最も薄い色は確率10%以下、"
                   "最も濃い色は90%超を示します。")),
    "fell": ("ends overturned here", "倒れている範囲"),
    "stood": ("ends standing here", "立ったまま止まる範囲"),
    "metres": ("{value:g} m", "{value:g} m"),
    "window": ("Window, {width:g} m wide", "窓、幅{width:g} m"),
    "is_hit": ("hit: {share}", "当たる：{share}"),
    "is_blocked": ("blocked: {share}", "ふさがる：{share}"),
    "overturns": ("overturns: {share}", "転倒：{share}"),
    "as_it_is": ("As it is", "今のまま"),
    # Places
    "places": ("Who is hit, and how often", "人に当たる確率"),
    "places_text": (("The chance that a falling piece hits whoever is there, with its 95 % interval{covers}; "
                     "crushed: with {energy:g} J or more. Pieces that touch without falling are counted "
                     "apart. By day ({day:g} hours) and at night ({night:g} hours) the chance of being hit "
                     "is multiplied by the share of the time in which somebody is there."),
                    ("そこにいる人に、倒れる家具が当たる確率と95%区間です{covers}。"
                     "そのうち{energy:g} J以上で当たる場合を「下敷き」とします。"
                     "倒れずに触れる家具は別に数えます。"
                     "昼（{day:g}時間）と夜（{night:g}時間）の値は、"
                     "当たる確率に人がいる時間の割合を掛けたものです。")),
    "covers": (", which covers other such earthquakes too", "（同じ強さのほかの地震も考えた区間です）"),
    "place": ("Place", "場所"),
    "hit": ("Hit by a falling piece", "倒れる家具が当たる"),
    "crushed": ("Crushed", "下敷きになる"),
    "touched": ("Touched", "倒れない家具が触れる"),
    "by_day": ("By day", "昼"),
    "by_night": ("At night", "夜"),
    "presence": ("there {share} of the time", "人がいる時間 {share}"),
    "what_hits": ("What hits or touches, and how hard", "当たる家具・触れる家具とその強さ"),
    "what_hits_text": (("Largest speed of the part that comes there, and largest kinetic energy of the "
                        "piece, over the runs in which it does: the median, and what nine in ten do not "
                        "exceed. They are upper bounds, because in the model neither a bed nor a person "
                        "holds the piece up. Injuries are not predicted."),
                       ("当たった計算での、その場所に入る部分の最大の速さと、"
                        "家具の最大の運動エネルギーです（中央値と、10回中9回が超えない値）。"
                        "モデルでは人もベッドも家具を受け止めないため、上限を示す値です。"
                        "けがの程度は予測しません。")),
    "piece": ("Piece", "家具"),
    "how_often": ("How often", "確率"),
    "hit_speed": ("Speed: median, 90 %", "速度：中央値、90%値"),
    "hit_energy": ("Energy: median, 90 %", "エネルギー：中央値、90%値"),
    "mass": ("Mass", "質量"),
    "no_hit": ("No piece came to a person in any run.", "どの計算でも、人に触れた家具はありません。"),
    # Doors and ways out
    "ways": ("Doors and ways out", "ドアと避難経路"),
    "ways_text": (("A door counts as blocked if it does not open the {passage:g} m that a person needs, "
                   "or if nobody can get to it past what lies on the floor."),
                  ("人が通れる幅{passage:g} mまで開かないドアと、"
                   "床にある家具のためにたどり着けないドアを「ふさがる」とします。")),
    "door": ("Door", "ドア"),
    "wall": ("Wall", "壁"),
    "opens": ("Opens", "開き方"),
    "inwards": ("inwards", "内開き"),
    "outwards": ("outwards", "外開き"),
    "sliding": ("sliding", "引き戸"),
    "leads_out": ("Leads out", "外への出口"),
    "yes": ("yes", "はい"),
    "no": ("no", "いいえ"),
    "blocked": ("Blocked", "ふさがる"),
    "at_rest": ("blocked already as the furniture stands", "家具の現在の配置ですでにふさがっています"),
    "shut_in": ("No way out", "外に出られない"),
    "shut_in_text": ("How often nobody who is there can get to a door that leads out.",
                     "そこにいる人が、外に出られるドアにたどり着けなくなる確率です。"),
    "no_doors": ("No doors are given.", "ドアは指定されていません。"),
    "no_way_out": ("No door leads out, so nothing is said about who is shut in.",
                   "外へのドアが指定されていないため、出られなくなるかどうかは判定していません。"),
    # Pieces
    "pieces": ("What the pieces do", "各家具の動き"),
    "piece_harm": ("Harm to people", "人への被害"),
    "pieces_text": (("Most dangerous first.{harm} The slide is the largest in a run; there is no number "
                     "where the piece overturns."),
                    ("危険な順です。{harm}移動量は揺れの間の最大値で、"
                     "転倒した場合は数値を示しません。")),
    "harm_text": ((" Harm is the energy with which a piece hits somebody, on average over all runs, counting "
                   "how long people are at each place."),
                  "被害は、人がいる時間を考慮した、家具が人に当たるエネルギーの全計算の平均です。"),
    # Changes
    "changes": ("Single changes, best first", "変更の候補（効果の大きい順）"),
    "all_changes": ("All changes in numbers", "すべての変更の数値"),
    "changes_text": (("Each change is made alone, under the same motions and with the same random "
                      "numbers. Differences are from the room as it is, in percentage points, with their "
                      "95 % intervals."),
                     ("それぞれの変更だけを、同じ地震動と同じ乱数で計算しました。"
                      "差は今の部屋との差（ポイント）で、かっこ内は95%区間です。")),
    "change": ("Change", "変更"),
    "changed_hit": ("Somebody is hit", "人に当たる確率"),
    "changed_shut_in": ("Somebody has no way out", "外に出られない確率"),
    "risk": ("Hit, counting the hours that people are there", "人に当たる確率（いる時間を考慮）"),
    "changed_overturned": ("The piece overturns", "その家具が倒れる確率"),
    "no_changes": ("No changes were compared.", "比較した変更はありません。"),
    "moved_text": ("{change}. Dashed: where it stands now.", "{change}。破線は現在の位置です。"),
    # What it rests on
    "limit_persons": ("Persons and beds", "人とベッド"),
    "limit_persons_text": (("They are boxes that stay where they are. A bed, a desk or a person does not "
                            "stop a piece that falls on them."),
                           ("人のいる場所は動かない直方体とします。ベッド・机・人は、"
                            "倒れてくる家具を受け止めません。")),
    "direction": ("Direction of the shaking", "揺れの向き"),
    "direction_drawn": ("varied from run to run: each direction in plan is as likely as any other",
                        "計算ごとに変える（水平面内のどの向きも同じ確率）"),
    "direction_given": ("x of the motions points {degrees:g}° from the room's x towards its y",
                        "地震動のx方向は、部屋のx方向からy方向へ{degrees:g}°"),
    "limit_passage": ("Walking and doors", "通行とドア"),
    "limit_passage_text": (("A person needs {passage:g} m to pass. Nobody climbs over a piece or pushes "
                            "it away. The floor is divided into squares of {cell:g} cm."),
                           ("人が通るには幅{passage:g} mが必要とし、"
                            "家具を乗り越えたり押しのけたりしないものとします。"
                            "床は{cell:g} cm四方に分けて調べます。")),
    "inputs": ("The scenario as TOML", "シナリオ（TOML）"),
    "again_text": ("This is the scenario. With the same seed, stayput {version} gives the same numbers.",
                   "計算に使ったシナリオです。同じ乱数のシードなら、stayput {version}で同じ数値になります。"),
}
