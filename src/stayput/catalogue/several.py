"""Verdicts on several pieces: what happens with their joints and with measures, and why."""

TEXTS: dict[str, tuple[str, str]] = {
    # What an option consists of
    "joined": ("Joints", "接合"),
    "nothing": ("Without joints and measures", "接合・対策なし"),
    "on": ("{measure} on {pieces}", "{pieces}に{measure}"),
    "as_stated": ("As stated: {what}", "現状：{what}"),
    # The verdict in a sentence
    "stays_upright": (("In shaking of JMA intensity {strength} all furniture stays upright without "
                       "{none}{doubt}."),
                      "{strength}の揺れでも、{none}なしで家具は転倒しません{doubt}。"),
    "none_helps": (", and nothing that was compared makes that clearly rarer",
                   "比較した案では明らかには減りません。"),
    "none_possible": ("; nothing else was compared, as none of the options is possible",
                      "どの案も設置できないため、比較していません。"),
    # Why an option stands where it does: clauses
    "if_there": ("{option}", "「{option}」なら"),
    "it": ("furniture", "家具のいずれかが"),
    "none": ("joints and measures", "接合・対策"),
    "none_more": ("further measures", "追加の対策"),
    "what": ("furniture", "家具のいずれかが"),
    "without": (" without {none}", "{none}がなければ"),
    "most_often": ("most often: {name} ({share})", "最も多いのは「{name}」（{share}）です"),
    "loose": ("{name} overturns {falls}", "「{name}」は{falls}"),
    "joint_fails": ("mostly what joins {first} and {second}", "多くは「{first}」と「{second}」の接合部です"),
    "device_of": ("mostly on {name}: {weakest}", "多くは「{name}」で、{weakest}ことによります"),
    "slides": ("in 90 % no furniture slides by over {length}", "90%の場合は移動が{length}以内です"),
    # The report
    "about": (("Simulated in space, under all components of the motions, with friction and impacts "
               "between the pieces. Options are ranked by how often any piece of furniture overturns "
               "(presets and boxes), then by sliding, where that clearly differs; other objects are listed "
               "by themselves."),
              ("三次元で、地震動のすべての成分と、家具どうしの摩擦・衝突を考慮して計算しました。順位は、"
               "いずれかの家具（規定の家具と直方体）が転倒する割合、移動の順に、"
               "明らかな差があるもので決めています。そのほかの物は個別に示します。")),
    "brief_text": (("Columns of events count any piece of furniture; those of the pieces tell how often "
                    "each overturns."),
                   "事象の列はいずれかの家具に起こる割合、各家具の列はその家具が転倒する割合です。"),
    "overturned": ("Any furniture overturns", "いずれかの家具が転倒"),
    "each": ("Which pieces overturn", "転倒する家具"),
    "holds": ("Holds", "取付け先"),
    "piece_box": ("{width:g} × {length:g} × {height:g} m, {mass:.4g} kg",
                  "{width:g} × {length:g} × {height:g} m、{mass:.4g} kg"),
    "gap_text": ("{gap:.3g} cm from the piece nearest to it", "最も近い家具から {gap:.3g} cm"),
    "between": ("Friction between the pieces", "家具どうしの摩擦"),
    "drawn_between": ("Friction between pieces, strength of joints", "家具どうしの摩擦と接合部の強さ"),
    "drawn_between_text": (("drawn by themselves, like friction and the strength of devices; masses, "
                            "centres and feet of each piece too"),
                           "摩擦・器具の強さと同じ分布で別に与える。質量・重心・脚は家具ごとに与える"),
    "rolling": ("Slide of round pieces", "丸い物の移動量"),
    "rolling_text": ("How far they are from where they stood, rolling included.",
                     "置かれていた位置からの距離で、転がりを含みます。"),
    "limit_settlement": ("Sinking into the floor", "床の沈み込み"),
    "settlement_of_solids": (("Left out for round pieces and meshes: on carpet and tatami they fall more "
                              "easily than is told."),
                             ("丸い物やメッシュの物体では考慮しません。カーペットや畳の上では、"
                              "示した値より倒れやすくなります。")),
    "settlement_of_stacks": (("A piece that carries others sinks in as if it stood alone: on carpet and "
                              "tatami the stack falls more easily than is told."),
                             ("上に物が載っている家具も、単独で置いたときと同じだけ沈むものとします。"
                              "カーペットや畳の上では、示した値より倒れやすくなります。")),
    "limit_body": ("Rigid bodies in space", "三次元の剛体"),
    "limit_body_text": (("Each runs under all components of the motions, together with what stands on it, is "
                         "joined to it, or stands in a row with it. What else meets is counted, and moves on "
                         "as if the other were not there. The pieces do not bend, and what is inside them "
                         "does not move."),
                        ("地震動のすべての成分を使い、上に載っているもの、連結されているもの、列をなして並ぶもの"
                         "とは一緒に計算します。それ以外の家具とぶつかる場合は数えるだけで、相手がないものとして"
                         "動きを計算します。家具の変形と、中身の動きは考慮しません。")),
}
