"""Rooms: their plans, the verdict on who is hit and which door stays shut, and changes."""

TEXTS: dict[str, tuple[str, str]] = {
    # Names of fields
    "wall": ("wall", "壁"),
    "hinge": ("hinge", "ちょうつがい"),
    "opens": ("opens", "開き方"),
    "kind": ("kind", "種類"),
    "at": ("at", "位置"),
    # Refusals
    "heights_in_order": (
        "high is {high:g} m; it must be more than low, {low:g} m.",
        "highが{high:g} mになっています。low（{low:g} m）より大きい値を指定してください。",
    ),
    "too_many": (
        "{count} are given; there must be at most {most}.",
        "{count}個指定されています。{most}個以下にしてください。",
    ),
    "beyond_wall": (
        "The opening ends at {end:g} m along its wall; it must be at most {most:g} m, where the wall ends.",
        "開口部の終わりが壁に沿って{end:g} mになっています。壁の長さ{most:g} m以下にしてください。",
    ),
    "same_name": (
        "Two are named {name}; each must have a name of its own.",
        "{name}という名前が2つあります。それぞれに異なる名前を付けてください。",
    ),
    "outside": (
        (
            "The place {name} reaches out of the room; it must be between 0 and {width:g} m along x and between 0 and "
            "{length:g} m along y."
        ),
        "場所{name}が部屋の外に出ています。x方向に0～{width:g} m、y方向に0～{length:g} mの範囲に置いてください。",
    ),
    "in_the_ceiling": (
        "{name} is {high:.3g} m high; under the ceiling it must be at most {height:.3g} m.",
        "{name}の高さは{high:.3g} mです。天井の高さ{height:.3g} m以下にしてください。",
    ),
    "in_a_wall": (
        (
            "{name} reaches from {low_x:.3g} to {high_x:.3g} m along x and from {low_y:.3g} to {high_y:.3g} m along y; it "
            "must be between 0 and {width:g} m along x and between 0 and {length:g} m along y."
        ),
        (
            "{name}がx方向に{low_x:.3g}～{high_x:.3g} m、y方向に{low_y:.3g}～{high_y:.3g} mを占めています。x方向に"
            "0～{width:g} m、y方向に0～{length:g} mの範囲に置いてください。"
        ),
    ),
    "in_another": (
        "{name} reaches {depth:.3g} m into {other}; it must stand beside it.",
        "{name}が{other}に{depth:.3g} m入り込んでいます。重ならないように置いてください。",
    ),
    "use_verify_room": (
        "A room with a plan was given; it must go to verify_room.",
        "部屋（[plan]）が渡されました。verify_roomを使ってください。",
    ),
    "against_without_along": (
        "{name} is missing; it must say where along the {wall} the piece stands.",
        "{name}がありません。{wall}のどこに置くかを指定してください。",
    ),
    "options_in_a_room": (
        "options is given beside [plan]; it must be left out, as in a room measures are tried one by one on each piece.",
        "[plan]のあるファイルにoptionsがあります。部屋では家具ごとに対策を1つずつ試すため、optionsは省いてください。",
    ),
    "against_without_plan": (
        "{name} is {value} in a file without a plan; it must be left out, or a [plan] must be given.",
        "{name}が{value}ですが、[plan]がありません。省くか、[plan]を指定してください。",
    ),
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
    # How often
    "of_ten": ("in {count} of 10 earthquakes", "10回中{count}回の地震で"),
    "always": ("in every earthquake", "どの地震でも"),
    "rarely": ("in {share} of the earthquakes", "{share}の地震で"),
    # The verdict
    "strength": ("In shaking of JMA intensity {strength}: ", "{strength}の揺れで、"),
    "hits": ("{often} {piece} hits who is at the {place}", "{often}「{piece}」が{place}にいる人に当たります"),
    "nobody_hit": ("nobody who is there is hit", "いる場所で人に当たる家具はありません"),
    "no_places": ("no place of a person is given", "人のいる場所が指定されていません"),
    "blocked": ("{often} the {door} stays blocked", "{often}{door}がふさがります"),
    "shut_in": (
        "{often} no way leads out from the {place}",
        "{often}{place}から外に出られなくなります",
    ),
    # What helps
    "best": ("Best single change: {change}.", "最も効果のある変更：{change}。"),
    "no_best": (
        "None of the single changes that were tried makes it clearly better.",
        "試した変更のうち、明らかに良くなるものはありませんでした。",
    ),
    "fix": ("{measure} on {piece}", "「{piece}」に{measure}を取付け"),
    "move_piece": (
        "{piece} moved to the {wall}, {along:.2f} m along it",
        "「{piece}」を{wall}の{along:.2f} mの位置へ移動",
    ),
    "move_place": (
        "the {place} moved, {x:.2f} m from the left wall and {y:.2f} m from the near wall",
        "{place}を左の壁から{x:.2f} m、手前の壁から{y:.2f} mの位置へ移動",
    ),
    "turn_place": (
        "the {place} turned by 90°, {x:.2f} m from the left wall and {y:.2f} m from the near wall",
        "{place}の向きを90°変えて左の壁から{x:.2f} m、手前の壁から{y:.2f} mの位置へ移動",
    ),
    "effect": (
        "with {change}, somebody is hit {held} instead of {bare}",
        "{change}で、人に当たる割合は{bare}から{held}になります",
    ),
    "effect_shut": (
        "with {change}, somebody is shut in {held} instead of {bare}",
        "{change}で、出られなくなる割合は{bare}から{held}になります",
    ),
    # Tables
    "report": ("Verification of a room", "部屋の地震対策の検証"),
    "who": ("Who is hit", "人のいる場所"),
    "by": ("by", "当たる家具"),
    "any_piece": ("any piece", "いずれか"),
    "chance": ("chance", "確率"),
    "day": ("by day", "昼"),
    "night": ("at night", "夜"),
    "speed": ("speed", "速さ"),
    "energy": ("energy", "エネルギー"),
    "mass": ("mass", "質量"),
    "upper_bounds": (
        (
            "Chances are for somebody who is there; by day and at night they are times the share in which somebody is. "
            "Speed and energy are medians, and upper bounds: neither a bed nor a person holds the piece up."
        ),
        (
            "確率は人がいる場合のもので、昼・夜はいる時間の割合を掛けた値です。速さとエネルギーは中央値で、ベッドや人が"
            "家具を支えないとした上限です。"
        ),
    ),
    "way": ("Ways out", "避難経路"),
    "door_blocked": ("{door} blocked", "{door}がふさがる"),
    "place_shut_in": ("shut in at the {place}", "{place}から出られない"),
    "blocked_at_rest": (
        "A door is blocked as the furniture stands.",
        "家具を置いた状態で、すでにふさがっているドアがあります。",
    ),
    "change": ("Single change", "変更（1つだけ）"),
    "hit_then": ("hit then", "人に当たる確率"),
    "hit_less": ("difference", "差"),
    "shut_in_then": ("shut in then", "出られない確率"),
    "simulations": (
        "{runs} runs of pieces: {motions} motions × {samples} Monte Carlo samples, as the room is and for each change.",
        "家具の計算{runs}回：地震動{motions}本 × 不確かさの標本{samples}組を、現状と各変更について計算しました。",
    ),
}
"""Texts by their keys: English, Japanese."""
