"""Motions and suites; the sentences about their files stand in `motion_files`."""

from stayput.catalogue.motion_files import TEXTS as FILE_TEXTS

TEXTS: dict[str, tuple[str, str]] = {
    **FILE_TEXTS,
    # What numbers and names are called, for the refusals of `stayput.catalogue.common`.
    "name_intensity": ("Intensity", "震度"),
    "intensity_unrecorded": (("The intensity is {value:g}; none above {most:g} has been recorded, so that "
                              "what is computed for it is an extrapolation."),
                             ("震度が{value:g}になっています。{most:g}を超える震度は観測されたことがないため、"
                              "計算結果は外挿です。")),
    "name_dt": ("dt", "時間刻み"),
    "name_time_step": ("The time step", "時間刻み"),
    "name_pgv": ("PGV", "最大速度（PGV）"),
    "name_pga": ("PGA", "最大加速度（PGA）"),
    "name_period": ("Period", "周期"),
    "name_damping": ("Damping ratio", "減衰定数"),
    "name_target_period": ("Period of {target}", "「{target}」の周期"),
    "name_band_shortest": ("Band's shortest period", "周期帯の最短周期"),
    "name_band_longest": ("Band's longest period", "周期帯の最長周期"),
    "name_count": ("Number of motions", "地震動の数"),
    "family": ("The family", "地震の種類"),
    "the_component": ("The component", "成分"),
    "location": ("The location", "ロケーション"),
    "the_motion": ("The motion", "地震動"),
    "two_or_more": ("2 or more", "2以上の数"),
    # The samples of a motion.
    "samples_of": ("Motion {component}", "地震動の{component}成分"),
    "row_of_samples": ("one row of real numbers without gaps [m/s²]",
                       "欠測のない実数（m/s²）を1列に並べたデータ"),
    "samples_count": ("The number of samples of {component}", "{component}成分のデータの数"),
    "sample_of": ("Motion {component} at sample {index}", "地震動の{component}成分のデータ番号{index}"),
    # What is done with a motion.
    "rotation_without_y": ("The motion has no y component; rotated needs x and y (flipped does not).",
                           ("地震動にy成分がありません。"
                            "回転（rotated）にはx成分とy成分が必要です（反転（flipped）には不要です）。")),
    "trim_too_short": ("The trim from {start:g} s to {end:g} s keeps fewer than 2 samples; it must keep 2.",
                       "{start:g}～{end:g}秒の切り出しでは、残るデータが2個未満です。2個以上が必要です。"),
    "resampling_ratio": ("The new dt is {step:g} s; it must be a whole part or a multiple of {dt:g} s.",
                         ("新しい時間刻みが{step:g}秒になっています。"
                          "{dt:g}秒の整数分の1か整数倍にしてください。")),
    "at2_one_component": (("The motion has {components} and an AT2 file holds one component; it must be "
                           "picked first."),
                          ("地震動には成分が{components}とありますが、AT2ファイルに書けるのは1成分です。"
                           "先に成分を選んでください。")),
    # Intensity and spectra.
    "too_short_for_intensity": ("The motion lasts {duration:g} s; an intensity needs at least {least} s.",
                                ("記録が短すぎて震度を求められません（{duration:g}秒）。"
                                 "{least}秒以上必要です。")),
    "still_component": (("The {component} component of {motion} is still; it has no Sa, and cannot meet a "
                         "target."),
                        ("{motion}の{component}成分は揺れていません。加速度応答スペクトルSaがなく、"
                         "目標スペクトルにも合わせられません。")),
    "still_floor": ("The motion is a still floor; it cannot be scaled to an intensity.",
                    "揺れのない記録なので、震度に合わせることができません。"),
    "rising_row": ("one row, each longer than the one before", "1個以上の周期を短い順に並べた1列"),
    # Computed motions.
    "coarse_step": (("dt is {step:g} s; at most {most:g} s, a {fewest}th of the period or of the pulse, "
                     "is allowed."),
                    ("時間刻みが{step:g}秒になっています。"
                     "周期やパルスの長さの{fewest}分の1（{most:g}秒）以下にしてください。")),
    "pulse_needs": (("A {kind} pulse has duration {duration} and frequency {frequency}; it must have its "
                     "{wanted} only."),
                    ("「{kind}」のパルスには{wanted}だけを指定してください（継続時間{duration}、"
                     "振動数{frequency}）。")),
    "frequency": ("frequency", "振動数"),
    # From the channels of a file to the components of a motion.
    "lengths_differ": ("The components have {listing} samples; their lengths must agree within 1 %.",
                       "成分のデータの数が合いません（{listing}）。長さの違いは1%以内でなければなりません。"),
    "motion_dt_differs": ("The dt of {component} is {dt:g} s; it must be that of x, {x_dt:g} s.",
                          ("{component}成分の時間刻みが{dt:g}秒です。"
                           "x成分と同じ{x_dt:g}秒でなければなりません。")),
    "many_channels": (("{count} channels are not those of one sensor; component must name one of "
                       "{channels}, or {option} those of a table."),
                      ("1つの地震計のものではない{count}個のチャンネルがあります。"
                       "使うものを次から選んで入力してください：「{channels}」。数値の列では、"
                       "列を「{option}」で指定することもできます。")),
    "vertical_component": (("The component {component!r} is a vertical channel; it must be a horizontal "
                            "one: {channels}."),
                           ("「{component}」は上下動の成分です。水平の成分を次から選んでください："
                            "「{channels}」")),
    "vertical_as_x": (("The vertical channel {component!r} is taken as x; the file has the horizontal "
                       "channels {channels}."),
                      ("上下動の成分「{component}」をxに使います。"
                       "ファイルには水平の成分「{channels}」があります。")),
    "not_one_vertical": ("The channels are {channels}; exactly one must be vertical.",
                         "ファイルのチャンネルは「{channels}」です。上下動の成分が1つだけ必要です。"),
    "drifts": (("The displacement of {component} drifts with the record's baseline, which is not "
                "corrected: its peak is {pgd:.4g} cm, and {corrected:.4g} cm once a line is taken off the "
                "acceleration."),
               ("{component}の変位は、補正していない基線のずれで流れています。最大変位は{pgd:.4g} cm、"
                "加速度から直線成分を除くと{corrected:.4g} cmです。")),
    "vertical_by_name": (("The name of the file ends in {ending!r} like a vertical; it is taken as x, the "
                          "horizontal shaking."),
                         ("ファイル名の末尾が上下動の成分を表す「{ending}」ですが、"
                          "水平の揺れ（x）として使います。")),
    "vertical_alone": (("The file has a vertical channel alone, {label!r}, taken as x; if that is meant, "
                        "name it ({option})."),
                       ("ファイルには上下動の成分（「{label}」）しかありません。"
                        "水平の揺れに使うのであれば、選んでください（{option}）。")),
    "x_chosen": (("Of the horizontal channels {channels} none was chosen; {label} is taken as x, along "
                  "the shaking."),
                 "水平の成分「{channels}」のどれも選ばれていないので、{label}を揺れの方向（x）に使います。"),
    "the_first": ("the first", "最初の成分"),
    "large_peak": ("The peak acceleration of {component} is {peak:.4g} g; above {limit:g} g check the unit.",
                   ("{component}成分の最大加速度が{peak:.4g} gあります。{limit:g} gを超えています。"
                    "単位を確かめてください。")),
    "upper_floor": (("The name or the header says that it is of {floor} of a building; it is no motion of "
                     "the ground."),
                    "建物の上の階で観測された記録のようです（{floor}）。地面の揺れではありません。"),
    "not_of_the_ground": ("The motion {motion} is of {floor}, not of the ground; {rule}.",
                          "地震動{motion}は{floor}の揺れで、地面の揺れではありません。{rule}。"),
    "ground_alone_strength": (("an intensity, a peak, a spectral acceleration or an earthquake says how "
                               "strongly the ground shakes, so give none and at most a factor (scale), or "
                               "a motion of the ground"),
                              ("震度・最大値・応答スペクトル・地震は地面の揺れの強さです。"
                               "指定しないか倍率（scale）だけにするか、地面の揺れの地震動を使ってください")),
    "ground_alone_here": ("here motions of the ground alone may be given",
                          "ここで使えるのは地面の揺れだけです"),
    "ground_alone_suite": (("others beside it are of the ground, so give motions of the ground alone, or "
                            "of upper floors alone"),
                           ("一緒に指定された地震動には地面の揺れがあります。地面の揺れだけ、"
                            "または上の階の揺れだけにしてください")),
    "ground_alone_building": (("a building stands on the ground, so give it no building, as the floor's "
                               "own motion, or a motion of the ground"),
                              ("建物に入力できるのは地面の揺れだけです。"
                               "建物を指定せずに床の揺れとして使うか、地面の揺れを使ってください")),
    "ground_alone_measure": (("curves over PGA, PGV, Sa or MMI are of the ground, so take PFA, PFV or "
                              "JMA, or a motion of the ground"),
                             ("PGA、PGV、Sa、MMIに対する曲線は地面の揺れのものです。PFA、PFV、"
                              "JMAのいずれかにするか、地面の揺れを使ってください")),
    "floor_number": ("floor {number}", "{number}階"),
    "storey_number": ("storey {number}", "{number}階"),
    "roof": ("roof", "屋上"),
    "some_upper_floor": ("an upper floor", "上の階"),
    "roof_place": ("the roof", "屋上"),
    "borehole_place": ("the bottom of a borehole, below the ground", "地中（ボアホールの底）"),
    # Components that are put together.
    "one_record": (("The {first} and {second} components are the same record, {name}; each must have its "
                    "own."),
                   "{first}成分と{second}成分が同じ記録（{name}）です。別々の成分の記録を指定してください。"),
    "two_records": (("The {first} component is of {one} and the {second} component of {other}; they must "
                     "be of one {what}."),
                    ("{first}成分は{one}、{second}成分は{other}の記録です。"
                     "同じ{what}の記録でなければなりません。")),
    "origin_unstated": (("The files of the {first} and {second} components do not both say of which "
                         "record they are; check it."),
                        ("{first}成分と{second}成分のファイルから、同じ記録かどうかが分かりません。"
                         "確かめてください。")),
    "same_record": ("record", "地震、観測点、地震計"),
    "same_place": ("place", "場所"),
    "sensor_borehole": ("borehole", "地中"),
    "sensor_surface": ("surface", "地表"),
    "one_direction": (("The {first} component points to {one} and the {second} component to {other}; they "
                       "must be at right angles."),
                      ("{first}成分の方向が{one}、{second}成分の方向が{other}です。"
                       "互いに直交していなければなりません。")),
    "component_of": ("The {component} component", "{component}成分の方向"),
    "vertical": ("vertical", "上下動"),
    "horizontal": ("horizontal", "水平動"),
    # ObsPy's traces.
    "several_stations": ("The traces are of the stations {one} and {other}; they must be of one.",
                         ("トレースに{one}と{other}の2つの観測点があります。"
                          "1つの観測点のものだけにしてください。")),
    "several_locations": (("The station has {count} sensors, with the locations {known}; {option} must "
                           "name one of them."),
                          ("観測点に地震計が{count}つあります（ロケーション：{known}）。"
                           "使うものを{option}で指定してください。")),
    "trace_gaps": (("The trace of {channel!r} has gaps or is in several parts; merge it to one that is "
                    "complete."),
                   ("「{channel}」のトレースに欠測があるか、複数に分かれています。"
                    "欠測のない1つのトレースに結合してください。")),
    "trace_start": ("The trace of {channel!r} starts {late:g} s after the first; all must start together.",
                    ("「{channel}」のトレースは最初のトレースより{late:g}秒遅れて始まります。"
                     "すべて同時に始まらなければなりません。")),
    # Suites and target spectra.
    "only_samples": (("{name} is {value}; bare samples must be given their time step, in m/s²: "
                      "Motion(dt=0.01, x=samples)."),
                     ("{name}が{value}になっています。時間刻みを付け、"
                      "m/s²の値でMotion(dt=0.01, x=samples)のように指定してください。")),
    "the_suite": ("The suite", "地震動群"),
    "folder_of_records": ("a folder, or a list of files", "地震記録のフォルダかファイルの一覧"),
    "suite_left_out": ("Of the folder {name!r} these files are left out: {files}.",
                       "フォルダ「{name}」の次のファイルは使いません：{files}。"),
    "no_acceleration": ("{files}{more} (no acceleration)", "{files}{more}（加速度ではない）"),
    "ground": ("the ground", "地面"),
    "vertical_only": ("{files}{more} (vertical alone)", "{files}{more}（上下動のみ）"),
    "in_borehole": ("{files}{more} (borehole)", "{files}{more}（地中の記録）"),
    "no_record": ("{files}{more} (no record)", "{files}{more}（記録ではない）"),
    "and_more": (" and {count} more", "など（ほか{count}件）"),
}
