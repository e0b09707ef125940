"""What became of a run: in a sentence, in rows, in an animation."""

TEXTS: dict[str, tuple[str, str]] = {
    # What became of a run, in one sentence.
    "rested": ("{name} stayed put: it neither slid nor rocked.", "{name}は動きませんでした。"),
    "slid": (
        "{name} slid by {slide} without rocking{hits}, and stayed upright.",
        "{name}は{hits}{slide}滑りましたが、倒れませんでした。",
    ),
    "rocked": (
        "{name} rocked by {tilt} and slid by {slide}{hits}, and stayed upright.",
        "{name}は{hits}{tilt}揺れ動き、{slide}滑りましたが、倒れませんでした。",
    ),
    "rocked_only": (
        "{name} rocked by {tilt}{hits}, and stayed upright.",
        "{name}は{hits}{tilt}揺れ動きましたが、倒れませんでした。",
    ),
    "leaning": (
        "{name} did not overturn but was left leaning to the {side}{hits}.",
        "{name}は{hits}倒れませんでしたが、{side}へ寄りかかったまま止まりました。",
    ),
    "overturned": (
        "{name} overturned to the {side} {time:.1f} s into the motion{hits}.",
        "{name}は{hits}揺れ始めから{time:.1f}秒後に{side}へ倒れました。",
    ),
    "failed": (
        (
            "{name} could not be followed beyond {end:.2f} s, because too many events "
            "crowded together, so this run says nothing about whether it stands."
        ),
        "{name}の動きは{end:.2f}秒より先を計算できませんでした。倒れるかどうかは分かりません。",
    ),
    "first_to_fail": (
        "{outcome} First to fail: {device}, after {time:.1f} s.",
        "{outcome}最初に破損または脱落した器具：{device}（{time:.1f}秒後）。",
    ),
    "side_left": ("left", "左"),
    "side_right": ("right", "右"),
    "side_back": ("back", "奥"),
    "side_front": ("front", "手前"),
    "hits": (" after hitting {parts}", "{parts}ぶつかり、"),
    "hits_wall": ("the wall {times}", "壁に{times}"),
    "hits_ceiling": ("the ceiling {times}", "天井に{times}"),
    "once": ("once", "1回"),
    "twice": ("twice", "2回"),
    "times": ("{n} times", "{n}回"),
    "slid_far": (
        "more than {far:g} m (there is no wall to stop it)",
        "{far:g} mを超えて（止める壁がありません）",
    ),
    "slid_least": ("less than a millimetre", "1 mm未満"),
    "slid_up_to": ("up to {length}", "最大{length}"),
    "tilted_least": ("less than 0.1°", "0.1度未満の傾きで"),
    "tilted_up_to": ("up to {angle:.1f}°", "最大{angle:.1f}度の傾きで"),
    # Pieces of a run.
    "number_of_names": (
        "There are {count} names for {pieces} pieces; give one for each.",
        "名前が{count}個ありますが、家具は{pieces}個です。それぞれに1つずつ指定してください。",
    ),
    "no_piece": (
        "There is no piece {value} in the run; its pieces are {allowed}.",
        "計算結果に{value}という家具はありません。家具は{allowed}です。",
    ),
    "several": (
        "The run has several pieces; name one, as in {example}. Its pieces are {allowed}.",
        "計算結果には複数の家具があります。{example}のように1つを指定してください。家具は{allowed}です。",
    ),
    "no_body": (
        "What moved is a solid and has no body of furniture.",
        "計算した物体は立体であり、家具（Body）ではありません。",
    ),
    # The results of a run, a row each.
    "row_motion": ("Motion", "地震動"),
    "row_motion_value": ("{name}, {duration:g} s, {peak}", "{name}、{duration:g}秒、{peak}"),
    "motion_title": ("{name}, {peak}", "{name}、{peak}"),
    "peak_along_depth": ("peak along the depth {peak:.2f} m/s²", "奥行き方向の最大加速度 {peak:.2f} m/s²"),
    "row_outcome": ("Outcome", "結果"),
    "row_overturned": ("Overturned at", "転倒した時刻"),
    "row_fell_off": ("Fell off at", "落下した時刻"),
    "row_tilt": ("Peak tilt", "最大傾き"),
    "row_slide": ("Peak slide", "最大移動量"),
    "row_way": ("Peak slide, rolling included", "最大移動量（転がりを含む）"),
    "row_residual": ("Residual slide", "残留移動量"),
    "row_error": ("Estimated error but for impacts", "推定誤差（衝突を除く）"),
    "row_rough": ("Steps with rough forces", "力が収束しなかったステップ"),
    "row_floor": ("Floor impacts", "床への衝突"),
    "row_yaw": ("Peak turn in plan", "水平面内の最大回転"),
    "row_bodies": ("Hits on other pieces", "他の家具への衝突"),
    "row_walls": ("Wall impacts", "壁への衝突"),
    "row_walls_and_ceiling": ("Wall and ceiling impacts", "壁と天井への衝突"),
    "row_used": (", {share:.0f} % of its strength", "、強度の{share:.0f}%"),
    "row_failed": ("; {cause} at {time:.2f} s", "、{time:.2f}秒に破損・脱落（{cause}）"),
    "row_holds": ("; holds", "、破損・脱落なし"),
    "cause_pulled_off": ("pulled off", "引き抜け"),
    "cause_pushed_in": ("pushed in", "押しつぶれ"),
    "cause_sheared_off": ("sheared off", "せん断破壊"),
    "cause_drawn_out": ("drawn out", "引き出し"),
    "cause_dropped_out": ("dropped out", "脱落"),
    "open_side": (" (there is no wall to stop it)", "（止める壁がありません）"),
    "synthetic": ("{name} (synthetic)", "{name}（模擬）"),
    # Animations.
    "player_theme": ("Light / dark", "明るい配色／暗い配色"),
    "recorded_on": ("{name}, recorded on {floor}", "{name}（{floor}の記録）"),
    "unnamed": ("a motion without a name", "名前のない地震動"),
    "floor_acceleration": ("Floor acceleration: {motion}", "床の加速度：{motion}"),
    "drawn_smaller": (", drawn at {share:.0f} % of its size", "、実際の{share:.0f}%で表示"),
    "too_short": (
        "The run has {samples} samples; an animation needs at least 2.",
        "計算結果のデータは{samples}個です。動画には2個以上必要です。",
    ),
    "animation_fps": ("The animation's fps", "動画のフレームレート"),
    "animation_speed": ("The animation's speed", "動画の速さ"),
    "animation_hold": ("The animation's hold", "動画の最後の静止時間"),
    "animation_width": ("The animation's width", "動画の幅"),
    "no_video": (
        "ffmpeg could not write {suffix}: {reason}.",
        "ffmpegで{suffix}を書き出せませんでした：{reason}。",
    ),
    "no_reason": ("no reason given", "理由は不明です"),
    "no_letters": (
        (
            "No font of this machine has the letters {letters}; pictures show {shown} "
            "instead. Install one that has, such as Noto Sans CJK (on Debian and Ubuntu: "
            "fonts-noto-cjk)."
        ),
        (
            "この環境のフォントには{letters}の文字がないため、図では{shown}と表示します。Noto"
            " Sans CJKなど、これらの文字を含むフォントをインストールしてください（DebianとUbu"
            "ntuではfonts-noto-cjk）。"
        ),
    ),
}
"""Texts by their keys: English, Japanese."""
