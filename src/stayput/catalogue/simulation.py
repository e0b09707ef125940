"""Sweeps, columns of cases, overturning maps and stability boundaries."""

TEXTS: dict[str, tuple[str, str]] = {
    # Names
    "at": ("Place", "位置"),
    "to": ("Second place of a joint", "接合部の2点目の位置"),
    "tilt": ("Tilt", "傾き"),
    "velocity": ("Velocity", "速度"),
    "rotation_rate": ("Rotation rate", "回転速度"),
    "friction": ("Friction between pieces", "家具間の摩擦係数"),
    "kinetic_friction": ("Kinetic friction between pieces", "家具間の動摩擦係数"),
    "floor": ("floor", "床"),
    "the_piece": ("The piece", "家具"),
    "begins_inside": ("{piece} begins {depth:.2g} m inside the {surface}; it must begin outside it.",
                      "{piece}は、初めに{surface}に{depth:.2g} mめり込んでいます。外に置いてください。"),
    "begin_in_each_other": (("{first} and {second} begin {depth:.2g} m inside each other; they must begin "
                             "apart."),
                            ("{first}と{second}は、初めに互いに{depth:.2g} mめり込んでいます。"
                             "離して置いてください。")),
    "heading": ("Heading", "向き"),
    "step": ("Step", "時間刻み"),
    "pieces": ("The number of pieces", "家具の数"),
    "joint_first": ("First piece of a joint", "接合部の1つ目の家具"),
    "joint_second": ("Second piece of a joint", "接合部の2つ目の家具"),
    "joint_stiffness": ("Stiffness of a joint", "接合部の剛性"),
    "joint_strength": ("Strength of a joint", "接合部の引張強さ"),
    "joint_shear": ("Shear strength of a joint", "接合部のせん断強さ"),
    "joint_slack": ("Slack of a joint", "接合部のたるみ"),
    "joint_damping": ("Damping ratio of a joint", "接合部の減衰定数"),
    "joins_itself": ("A joint joins {piece} to itself; it must join two pieces.",
                     "接合部が{piece}をそれ自身につないでいます。2つの家具を指定してください。"),
    "slack_without_to": (("A joint at one point has a slack of {value} m; only one between two points "
                          "(to) can have any."),
                         ("1点の接合部に{value} mのたるみが指定されています。"
                          "たるみは2点間（to）の接合部だけに指定できます。")),
    "joint_piece": ("A joint names piece {number}; the last one is {last}.",
                    "接合部が家具{number}を指していますが、最後の家具は{last}です。"),
    "joint_in_the_air": (("{name} holds {piece} at a point {apart:.3g} m outside of it; it must be no more "
                          "than {most:g} m from it."),
                         ("{name}の点が{piece}から{apart:.3g} m離れています。"
                          "{most:g} m以内にしてください。")),
    "settles": (("Sinking into the floor, by {value:g} mm, is left out for {pieces}: it is computed for "
                 "boxes alone."),
                ("{pieces}については、床への沈み込み（{value:g} mm）を考慮していません（沈み込みは直方体だ"
                 "けで計算します）。")),
    "chunk": ("Chunk", "一度に計算するケース数"),
    "tolerance": ("Tolerance", "許容誤差"),
    "left_wall": ("left wall", "左の壁"),
    "right_wall": ("right wall", "右の壁"),
    "near_side_wall": ("near side wall", "手前側の側壁"),
    "far_side_wall": ("far side wall", "奥側の側壁"),
    "ceiling": ("ceiling", "天井"),
    "case_number": ("Case {number} of {count}", "{count}件中のケース{number}"),
    # Axes
    "axis_lists": ("The axis {names} has values for {count} paths; it must have one list for each path.",
                   ("軸{names}に{count}個のパスの値が指定されています。"
                    "パスごとにリストを1つずつ指定してください。")),
    "axis_lengths": ("The axis {names} has {lengths} values; paths on one axis must have as many.",
                     ("軸{names}の値の数が{lengths}になっています。"
                      "同じ軸のパスには同じ数の値を指定してください。")),
    "path": ("Path", "パス"),
    "list_of_numbers": ("a list of {least} or more numbers", "{least}個以上の数値のリスト"),
    "surface_missing": (("{path!r} changes a {surface} that is not there; give the room one, or set "
                         "{distance!r} too."),
                        ("{path!r}に必要な{surface}が部屋にありません。{surface}を設けるか、"
                         "{distance!r}も指定してください。")),
    # Histories
    "history": ("History", "時刻歴の名前"),
    "histories_in_space": ("A sweep in space keeps no histories; simulate the cases of interest one by one.",
                           ("三次元の一括計算では時刻歴を保存しません。"
                            "必要なケースを1つずつ計算してください。")),
    "time_steps_differ": ("The motions' time steps are {steps} s; histories need motions of one time step.",
                          ("地震動の時間刻みが{steps}秒になっています。時刻歴を残すには、"
                           "すべての時間刻みを同じにしてください。")),
    # Amplitudes of maps and boundaries
    "amplitudes": ("The list of amplitudes", "振幅のリスト"),
    "amplitudes_not_increasing": (("The amplitude {value:g} comes after {before:g}; amplitudes must "
                                   "increase, from 0 or more."),
                                  ("振幅が{before:g}の次に{value:g}になっています。"
                                   "0以上の値を小さい順に指定してください。")),
    "scale_on_axis": ("{path!r} is among the axes; it must be given by the amplitudes only.",
                      "{path!r}が軸に含まれています。振幅だけで指定してください。"),
    "edge": ("Edge", "境界の種類"),
}
