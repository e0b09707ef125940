"""Rooms: their plans, the verdict on who is hit and which door stays shut, and changes."""

TEXTS: dict[str, tuple[str, str]] = {
    # Names of fields
    "wall": ("wall", "壁"),
    "hinge": ("hinge", "ちょうつがい"),
    "opens": ("opens", "開き方"),
    "kind": ("kind", "種類"),
    "at": ("at", "位置"),
    # Refusals
    "heights_in_order": ("high is {high:g} m; it must be more than low, {low:g} m.",
                         "highが{high:g} mになっています。low（{low:g} m）より大きい値を指定してください。"),
    "beyond_wall": (("The opening ends at {end:g} m along its wall; it must be at most {most:g} m, where "
                     "the wall ends."),
                    ("開口部の終わりが壁に沿って{end:g} mになっています。"
                     "壁の長さ{most:g} m以下にしてください。")),
    "openings_overlap": (("{name} overlaps {other} by {overlap:.3g} m of the same wall; openings must stand "
                          "beside each other."),
                         ("{name}が同じ壁の{other}と{overlap:.3g} m重なっています。"
                          "重ならないように配置してください。")),
    "same_name": ("Two are named {name}; each must have a name of its own.",
                  "{name}という名前が2つあります。それぞれに異なる名前を付けてください。"),
    "outside": (("The place {name} reaches out of the room; it must be between 0 and {width:g} m along x "
                 "and between 0 and {length:g} m along y."),
                ("場所{name}が部屋の外に出ています。x方向に0～{width:g} m、"
                 "y方向に0～{length:g} mの範囲に置いてください。")),
    "in_the_ceiling": ("{name} is {high:.3g} m high; under the ceiling it must be at most {height:.3g} m.",
                       "{name}の高さは{high:.3g} mです。天井の高さ{height:.3g} m以下にしてください。"),
    "in_a_wall": (("{name} reaches from {low_x:.3g} to {high_x:.3g} m along x and from {low_y:.3g} to "
                   "{high_y:.3g} m along y; it must be between 0 and {width:g} m along x and between 0 "
                   "and {length:g} m along y."),
                  ("{name}がx方向に{low_x:.3g}～{high_x:.3g} m、"
                   "y方向に{low_y:.3g}～{high_y:.3g} mを占めています。x方向に0～{width:g} m、"
                   "y方向に0～{length:g} mの範囲に置いてください。")),
    "in_another": ("{name} reaches {depth:.3g} m into {other}; it must stand beside it.",
                   "{name}が{other}に{depth:.3g} m入り込んでいます。重ならないように置いてください。"),
    "no_plan": ("a table with width and length", "幅と奥行きのあるテーブル"),
    "against_without_plan": ("without a [plan]", "[plan]のないファイル"),
    # Names of places
    "bed": ("bed", "ベッド"),
    "futon": ("futon", "布団"),
    "cot": ("cot", "ベビーベッド"),
    "desk": ("desk", "机"),
    "sofa": ("sofa", "ソファ"),
    "play area": ("play area", "遊び場"),
    "door": ("door", "ドア"),
    # Walls, as in "to the wall on the left"
    "left_wall": ("left wall", "左の壁"),
    "right_wall": ("right wall", "右の壁"),
    "near_side_wall": ("near wall", "手前の壁"),
    "far_side_wall": ("far wall", "奥の壁"),
    # Within a sentence: what has a name of the user's own is quoted, what has none has an article
    "the": ("the {name}", "{name}"),
    "named": ("“{name}”", "「{name}」"),
    # What there are several of and has no name of its own
    "numbered": ("{name} {number}", "{name}{number}"),
    # Where somebody is, as in "hits whoever is in bed"; at a place with a name of its own
    "in_place": ("in {place}", "{place}"),
    "on_place": ("on {place}", "{place}"),
    "at_place": ("at {place}", "{place}"),
    # Of what: of many motions, each an earthquake; of a single one
    "earthquakes": ("earthquakes", "地震"),
    "runs": ("runs", "計算"),
    "runs_of": ("runs of {motion}", "{motion}による計算"),
    "this_record": ("this record", "この記録"),
    "this_motion": ("this one motion", "この1つの地震動"),
    # How often
    "often": ("in {share} of {cases}", "{cases}の{share}で"),
    # The verdict
    "strength": ("In shaking of JMA intensity {strength}: ", "{strength}の揺れでは、"),
    "strength_scattered": (("In earthquakes as stated, with the scatter of their strength around JMA "
                            "intensity {strength}: "),
                           "強さのばらつきを含む、{strength}を中央とする地震では、"),
    "interval": ("95 % interval: ", "95%区間："),
    "falls_on": ("{often} {piece} falls on whoever is {place}{interval}",
                 "{often}{piece}が{place}にいる人の上に倒れます{interval}"),
    "touches": ("{often} {piece} touches whoever is {place} without falling{interval}",
                "{often}{piece}が倒れずに{place}にいる人に触れます{interval}"),
    "nobody_hit": ("in these runs nobody is hit; somebody may be {often}",
                   "計算した範囲では、人に当たる家具はありません（{often}当たる可能性は否定できません）"),
    "blocked": ("{often} {door} stays blocked{interval}", "{often}{door}がふさがります{interval}"),
    "blocked_already": ("{door} is blocked already as the furniture stands, before any shaking",
                        "{door}は、揺れる前から家具でふさがっています"),
    "shut_in_already": ("so there is no way out before any shaking", "揺れる前から外に出られません"),
    "shut_in": ("{often} there is no way out for whoever is {place}{interval}",
                "{often}{place}にいる人が外に出られなくなります{interval}"),
    # What helps
    "best": ("Best single change: {change}.", "最も効果のある変更：{change}。"),
    "among_best": ("One of the best single changes: {change}. Others may help as much ({count}).",
                   "最も効果のある変更の1つ：{change}。ほかに{count}件が同じくらい効く可能性があります。"),
    "no_best": ("None of the single changes that were tried makes it clearly better.",
                "試した変更のうち、明らかに良くなるものはありませんでした。"),
    "as_it_is": ("the room as it is", "今の部屋"),
    "fix": ("{measure} on {piece}", "{piece}を{measure}で固定"),
    "move_along": ("move {piece} along the {wall} until its middle is {along:.2f} m from the {start}",
                   "{piece}を{wall}に沿って、{start}から中心まで{along:.2f} mの位置へ移動"),
    "move_piece": ("move {piece} to the {wall}, its middle {along:.2f} m from the {start}",
                   "{piece}を{wall}沿い（{start}から中心まで{along:.2f} m）へ移動"),
    "move_place": ("{how}, its middle {x:.2f} m from the left wall and {y:.2f} m from the near wall",
                   "{how}、中心が左の壁から{x:.2f} m、手前の壁から{y:.2f} mの位置へ移動"),
    "moved": ("move {place}", "{place}を"),
    "turned": ("turn {place} by 90° and move it", "{place}の向きを90°変え"),
    "falls_too": ("{often} {piece} overturns{interval}{others}",
                  "{often}{piece}が倒れます{interval}{others}"),
    "any_falls": ("{often} any of the pieces overturns", "{often}いずれかの家具が倒れます"),
    "with_others": (", beside others ({count})", "。ほかにも{count}個の家具が倒れることがあります"),
    "change_of": ("{change}. The chance that {what} {goes}", "{change}すると、{what}確率は{goes}"),
    "chance_of_hit": ("somebody is hit", "人に当たる"),
    "chance_of_shut_in": ("somebody is shut in", "外に出られなくなる"),
    "chance_of_blocked": ("a door is blocked", "ドアがふさがる"),
    "chance_of_overturned": ("it overturns", "倒れる"),
    "falls": ("falls by {least} to {most} points, to {held}",
              "{least}～{most}ポイント下がり、{held}になります"),
    "rises": ("rises by {least} to {most} points, to {held}",
              "{least}～{most}ポイント上がり、{held}になります"),
    "stays": ("does not clearly change", "明らかには変わりません"),
    # Changes that have been decided on
    "decided_unknown": ("{name} of a decided change is not in the room; it must be one of {there}.",
                        "決めた変更の{name}は、この部屋にありません。次のいずれかにしてください：{there}"),
    "decided_both": ("The decided change of {name} must be either a measure or another place.",
                     "{name}の決めた変更は、対策か別の位置のどちらか一方にしてください。"),
    "decided_on_no_piece": (("The decided change of {name} puts a measure on what is no furniture; it "
                             "must be another place."),
                            ("{name}は家具ではないので、対策は取り付けられません。"
                             "別の位置を指定してください。")),
    "decided_joined": (("The decided changes move {name}, which stands on or is joined to another piece; "
                        "it must stand by itself."),
                       ("{name}は、ほかの家具の上にあるか、つながれているので動かせません。"
                        "単独の家具にしてください。")),
    "home_contradicts": (("“{condition}” was asked for, but {name} is stated otherwise; one of the two "
                          "must go."),
                         "条件「{condition}」が、{name}の指定と食い違います。どちらかを取り消してください。"),
    # Why a measure cannot be put on a piece
    "leans_into": ("It leans the piece into what stands on it.",
                   "家具が傾き、上に載っている物にぶつかります。"),
    "wall_too_far": ("There is no wall within {most:.2f} m behind the piece.",
                     "家具の背面から{most:.2f} m以内に壁がありません。"),
    "at_an_opening": ("There is a door or a window where it would be screwed on.",
                      "ねじ留めする所にドアか窓があります。"),
    # Tables
    "motions": ("{count} motions", "地震動{count}本"),
    "report": ("Verification of a room", "部屋の地震対策の検証"),
    "by_falling": ("falls on them", "倒れかかる"),
    "by_touching": ("touches them without falling", "倒れずに触れる"),
    "upper_bounds": (("Chances are for somebody who is there, with their 95 % intervals; by day and at "
                      "night they are multiplied by the share of the time in which somebody is there. A "
                      "piece that comes less than 5 cm into the place touches nobody. Speed and energy are "
                      "medians, and upper bounds: in the model neither a bed nor a person holds the piece "
                      "up."),
                     ("確率は、そこに人がいる場合の値と95%区間です。昼と夜の値は、"
                      "人がいる時間の割合を掛けたものです。"
                      "人のいる場所に入り込む深さが5 cmに満たない家具は、当たったと数えません。"
                      "速さとエネルギーは中央値で、ベッドや人が家具を支えないとした上限です。")),
    "already": ("blocked already", "揺れる前からふさがっている"),
    "more_changes": ("And {count} more changes; all are in the report (--report).",
                     "ほかに{count}件の変更を試しました。すべては報告書（--report）にあります。"),
    # What a change is clearly better or worse in
    "fewer_hit": ("clearly fewer hit", "当たる確率が明らかに下がる"),
    "more_hit": ("clearly more hit", "当たる確率が明らかに上がる"),
    "fewer_shut_in": ("way out clearly free more often", "明らかに外へ出やすくなる"),
    "more_shut_in": ("way out clearly free less often", "明らかに外へ出にくくなる"),
    "fewer_blocked": ("door clearly free more often", "明らかにドアがふさがりにくくなる"),
    "more_blocked": ("door clearly blocked more often", "明らかにドアがふさがりやすくなる"),
    "fewer_overturned": ("clearly overturns less often", "明らかに倒れにくくなる"),
    "more_overturned": ("clearly overturns more often", "明らかに倒れやすくなる"),
    "simulations": (("{runs} runs of the pieces under {motions}, of which the room is composed: {each} times "
                     "as it is and with each change."),
                    "家具の計算{runs}回（{motions}）。部屋は、これを組み合わせて現状と変更ごとに{each}回計算しています。"),
}
