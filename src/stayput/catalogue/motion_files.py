"""Files of motions and their readers, of all formats and of single ones; ids begin as in `motion`."""

TEXTS: dict[str, tuple[str, str]] = {
    # Files that are no text.
    "file_is": ("The motion file {path!r} is {what}; it must be a text of a record, SAC or miniSEED.",
                "「{path}」は{what}です。地震記録のファイル（テキスト、SAC、miniSEED）を指定してください。"),
    "a_folder": ("a directory", "フォルダ"),
    "a_device": ("a device or a pipe", "デバイスまたはパイプ"),
    "empty": ("empty", "空のファイル"),
    "a_spreadsheet": ("a workbook of a spreadsheet, whose sheet can be saved as CSV",
                      "表計算ソフトのファイル（シートはCSV形式で保存できます）"),
    "an_archive": ("a compressed archive, which is to be unpacked", "圧縮ファイル（展開してください）"),
    "binary": ("binary (other formats can be read with ObsPy for Motion.from_obspy)",
               "テキストでないファイル（ほかの形式は「ObsPy」で読み、「Motion.from_obspy」で渡せます）"),
    "a_line_of": ("A line of {file!r}", "「{file}」の1行"),
    "file_cut": ("The file ends within a number, with {tail!r}; it must be complete.",
                 "ファイルが途中で切れています（末尾の数値が「{tail}」）。"),
    "unknown_format": ("The motion file {path!r} is in {format}; it must be in one of {formats}.",
                       ("「{path}」は{format}のファイルで、読み込めません。"
                        "次のいずれかの形式にしてください（ほかの形式では、"
                        "加速度を数値の列として保存できます）：「{formats}」")),
    # A file's unit and time step.
    "unknown_unit": ("The unit of acceleration", "加速度の単位"),
    "unknown_stated_unit": (("The file states the unit {unit}, which is not known; {option} must be given "
                             "as one of {known}."),
                            ("ファイルに書かれている単位{unit}には対応していません。"
                             "加速度の単位を次から選んでください：{known}")),
    "no_unit": ("The file states no unit; {option} must be given as one of {known}.",
                "加速度の単位（{option}）がファイルに書かれていません。次から選んでください：{known}"),
    "no_unit_but_mentioned": (("The header mentions {mentioned!r}, but not as the unit; {option} must be "
                               "given as one of {known}."),
                              ("ヘッダーに「{mentioned}」とありますが、単位とは書かれていません。"
                               "単位（{option}）を次から選んでください：{known}")),
    "no_unit_nor_step": (("The file states no unit and no time step; {option} must be given as one of "
                          "{known}, and {other_option} [s]."),
                         ("加速度の単位（{option}）と時間刻み（{other_option}）がファイルに書かれていませ"
                          "ん。単位を次から選び、時間刻みを秒単位で入力してください：{known}")),
    "not_the_files_own": (("The {what} is given as {given}; it must be the one that the file states, "
                           "{stated}."),
                          ("{what}に{given}が指定されましたが、ファイルでは{stated}です。"
                           "それにしてください。")),
    "unit_mentioned": (("The unit is given as {given!r} and the file's header mentions {mentioned!r}; "
                        "check which it is."),
                       ("選ばれた単位は「{given}」ですが、"
                        "ファイルのヘッダーには「{mentioned}」と書かれています。確かめてください。")),
    "no_time_step": ("The file states no time step; {option} must be given [s].",
                     "時間刻み（{option}）がファイルに書かれていません。秒単位で入力してください。"),
    "time_counts": (("The time counts {first:g}, {second:g}, …, like samples; {option} must be given [s], "
                     "1 if in seconds."),
                    ("時刻の列が{first:g}、{second:g}、…と1ずつ増えています。"
                     "時間刻み（{option}）を指定してください（秒であれば1）。")),
    "long_step": (("The time step is {dt:g} s, by which nothing faster than {frequency:g} Hz is seen; "
                   "check the time column or dt."),
                  ("時間刻みが{dt:g}秒で、{frequency:g} Hzより速い揺れが記録に現れません。"
                   "時刻の列か時間刻みを確かめてください。")),
    "gravity": (("The mean acceleration of {component} is {mean:.4g} m/s², which is gravity; take it off "
                 "({option})."),
                ("{component}成分の加速度の平均が{mean:.4g} m/s²で、重力加速度が含まれています。"
                 "除いてください（{option}）。")),
    "offset": (("{component} oscillates about {mean:.4g} m/s², {share:.3g} % of its peak, which leaves "
                "the floor moving at {velocity:.3g} m/s; an instrument's offset must be taken off "
                "({option})."),
               ("{component}成分の加速度が{mean:.4g} m/s²を中心に振動し（最大値の{share:.3g}%）、"
                "最後に床が{velocity:.3g} m/sで動き続けます。計器のオフセットであれば、"
                "平均を除いてください（{option}）。")),
    "late_offset": (("From {begin:.3g} s on the acceleration of {component} oscillates about {mean:.4g} "
                     "m/s²; check it."),
                    ("{component}成分の加速度が{begin:.3g}秒付近から{mean:.4g} m/s²を中心に振動していま"
                     "す。記録を確かめてください。")),
    "less_mean": (", less the mean of each component", "、各成分の平均を除去"),
    "varying_step": (("The time grows by steps of {shortest:.6g} to {longest:.6g} s; they must be equal, "
                      "or taken as equal with their mean given: {option} {mean:.8g}."),
                     ("時刻の刻みが{shortest:.6g}～{longest:.6g}秒で、そろっていません。"
                      "等間隔とみなしてよければ、平均の{mean:.8g}秒を時間刻み（{option}）に指定してください。")),
    "turned": (("The magnitude of {components} together stays at {magnitude:.3g} m/s², gravity, while its "
                "direction changes; the instrument must not be turned while it records."),
               ("{components}を合わせた加速度の大きさは{magnitude:.3g} m/s²（重力）のままで、向きが変わって"
                "います。計器の向きを変えずに記録したものが必要です。")),
    "irregular_sampling": ("The sampling is irregular near {time:g} s; the time must grow by equal steps.",
                           "時刻が{time:g}秒付近で等間隔になっていません。等間隔の記録が必要です。"),
    # The numbers in a file, and what the sentences about them call them.
    "the_numbers": ("numbers", "数値"),
    "the_samples": ("samples", "データ"),
    "the_counts": ("counts", "カウント値"),
    "the_offsets": ("offsets", "オフセット"),
    "the_peak": ("peak acceleration", "最大加速度"),
    "the_time_step": ("time step", "時間刻み"),
    "the_unit": ("unit", "単位"),
    "the_number": ("channel number", "チャンネルの番号"),
    "no_known_format": ("no known format", "対応していない形式"),
    "a_format": ("the format {format}, which is not read", "「{format}」形式"),
    "the_time": ("The time", "時刻の見出し"),
    "characters": ("characters", "文字数"),
    "number_of_samples": ("number of samples", "データの数"),
    "the_integer_header": ("integer header", "整数ヘッダー"),
    "the_real_header": ("real header", "実数ヘッダー"),
    "the_line_before_the_samples": ("line before the samples", "データの前の行"),
    "the_esm_size": ("entries NDATA and SAMPLING_INTERVAL_S", "「NDATA」と「SAMPLING_INTERVAL_S」"),
    "sampling_frequency": ("sampling frequency", "サンプリング周波数"),
    "direction": ("direction", "方向"),
    "duration": ("duration", "継続時間"),
    "scale_factor": ("scale factor such as 2000(gal)/8388608", "スケールファクター（例：2000(gal)/8388608）"),
    "npts": ("NPTS", "「NPTS」"),
    "dt": ("DT", "「DT」"),
    "velocity_or_displacement": ("velocity or displacement", "速度または変位"),
    "names_of_blocks": ("the names of its blocks", "ブロックの名前"),
    "so_many_numbers": ("as many numbers as there are components, {count}", "成分と同じ{count}個の数値"),
    "date_and_time": ("date and time first", "はじめに日時"),
    "npts_and_dt": ("NPTS= a number, DT= a number", "「NPTS= 数値, DT= 数値」"),
    "a_layout": ("how many samples follow, 1 or more, and their fields", "続くデータの数（1以上）と欄の書式"),
    "the_format": ("the format", "形式"),
    "knet_offset": ("line #Offset", "「#Offset」の行"),
    "knet_memo": ("line Memo. as its 17th", "17行目の「Memo.」の行"),
    "line_of_names": ("line of component names such as NS,EW,UD", "「NS,EW,UD」のような成分名の行"),
    "not_a_decimal": ("Value {index} of the {what} is {value}; it must be a finite decimal number.",
                      ("{what}の{index}番目の値が{value}になっていて、数値ではありません。"
                       "有限の10進数が必要です。")),
    "not_one_number": ("The {what} is {value}; it must be one number larger than 0{unit}.",
                       ("ヘッダーの{what}が{value}になっています。"
                        "0より大きい数値を1つだけ書いてください{unit}。")),
    "not_as_stated": (("The header states the {what} {stated:.9g}{unit} and the file has "
                       "{found:.9g}{unit}; they must agree."),
                      ("ヘッダーの{what}は{stated:.9g}{unit}ですが、データでは{found:.9g}{unit}です。"
                       "一致しなければなりません。")),
    "header_line": ("The line {line} is not as the format has it; it must state {wanted}.",
                    "{line}の行が形式に合いません。ここには{wanted}を書く必要があります。"),
    "no_end": ("A block has no line {line} after it; the file must be complete.",
               "ブロックの後に「{line}」の行がありません。ファイルが途中で切れています。"),
    "not_acceleration": ("The file is of {quantity}, by {where}; its numbers must be accelerations.",
                         "{where}によると{quantity}のファイルです。加速度の記録が必要です。"),
    "row_width": ("Row {row} is {value}; it must have {columns} values.",
                  "{row}行目が{value}になっています。1行に{columns}個の値が必要です。"),
    "few_rows": ("The number of rows of numbers is {rows}; it must be at least 2.",
                 "ファイルのデータが{rows}行しかありません。2行以上必要です。"),
    "no_header_entry": ("The header has no {what}; it must state it.", "ヘッダーに{what}がありません。"),
    "decimal_comma": (("Value {index} of the {what} is {value}; its decimal mark must be a point, unless "
                       "{option} is given."),
                      ("{what}の{index}番目の値が{value}です。小数点を「.」にするか、"
                       "「,」であれば{option}を指定してください。")),
    # What the caller says of a file.
    "columns_like": (("{name} has {value}; it must be such as t=1,x=2 or t=time,x=NS,y=EW,z=UD, with x, "
                      "and each once, or rows of one series: rows."),
                     ("{name}に{value}があります。「t=1,x=2」や「t=time,x=NS,y=EW,z=UD」のように"
                      "xを含めて1回ずつ書くか、1つの時系列が行に続けて並ぶ場合は「rows」と書いてください。")),
    "no_such_column": (("The columns say {role}={column}; each must be a column of the file, and another "
                        "one: {known}."),
                       ("列の指定の{role}={column}に当たる列が1つに決まりません。"
                        "別々の列を次から選んでください：{known}")),
    "columns_left_out": (("The columns {columns} are velocities, displacements or magnitudes and are left "
                          "out; the accelerations are taken."),
                         ("速度、変位、大きさの列「{columns}」は使いません。"
                          "各方向の加速度の列だけを使います。")),
    "not_of_format": ("for a file of {format}, which has no use for it", "{format}のファイル"),
    "fewer_lines": ("smaller than the number of the file's lines", "ファイルの行数より小さい数"),
    "other_instrument": (("Channel {channel} is of no accelerometer by its SEED code, whose letter "
                          "{letter} must be N, L or G."),
                         ("チャンネル{channel}は、SEEDコードの計器の文字が{letter}で、加速度計（N、L、"
                          "G）のものではありません。")),
    "seismogram_unread": ("ObsPy cannot read the file; it must be complete.",
                          "ObsPyでファイルを読み取れません。壊れていないファイルが必要です。"),
    "borehole_left_out": (("The channels {channels} are of the borehole below the ground and are left "
                           "out; the surface's are taken."),
                          ("地中（ボアホール）の地震計の成分「{channels}」は使いません。"
                           "地表の成分を使います。")),
    "borehole": (("The sensor of {label!r} is in the borehole, below the ground; for a floor the one at "
                  "the surface must be taken."),
                 ("「{label}」は地中（ボアホール）の地震計の記録です。"
                  "床の揺れには地表の記録を使ってください。")),
    # Columns of numbers.
    "columns_of_numbers": ("columns of numbers", "数値の列"),
    "file_and_form": ("{file} ({form})", "{file}（{form}）"),
    "column_count": (("The file has {columns} columns; it must have 1 (x), 2 (time, x) or 4 (time, x, y, z), "
                      "unless {option} says which they are ({example}), or that a series is in rows (rows)."),
                     ("{columns}列あります。1列（加速度）、2列（時刻と加速度）、4列（時刻とx、y、z）にするか、「{option}」"
                      "で、どれがその列か（「{example}」）、1つの時系列が行に続けて並ぶか（「rows」）を指定してください。")),
    "one_column_of_rows": (("Of {count} columns without headings only one is read; where each row has "
                            "several samples of one series, {option} must be rows."),
                           ("見出しのない{count}列のうち1列だけを読みます。1つの時系列が行に続けて並ぶ場合は"
                            "「{option}」を「rows」にしてください。")),
    "rows_taken_as_samples": ("Each row is read as {count} samples of one series that goes on in the next.",
                              "各行を、次の行へと続く1つの時系列の{count}個のデータとして読みます。"),
    "rows_of_one_series": ("Each row has {count} samples of one series; {option} must be rows.",
                           "1行に1つの時系列の{count}個のデータが並びます。「{option}」をrowsにしてください。"),
    "column_first_row": (("Row {row} has {count} values; it must have {columns} like the first, unless "
                          "{option} passes that over."),
                         ("行によって列の数が違います（1行目は{columns}個、{row}行目は{count}個）。"
                          "1行目がデータでなければ、「{option}」で読み飛ばしてください。")),
    "column_factor": (("The line {line} states a factor; numbers must be without one: if so, {option} "
                       "passes the line over."),
                      ("{line}の行に倍率があります。倍率のない数値にして、"
                       "この行を「{option}」で読み飛ばしてください。")),
    "column_count_first": (("The first number, {number:g}, looks like a count; only samples may stand "
                            "there, unless {option} passes it over."),
                           ("最初の数値（{number:g}）はデータの個数のようです。データだけを書くか、"
                            "「{option}」で読み飛ばしてください。")),
    "column_no_unit": (("The heading {column} states no unit, and the other columns have different ones; "
                        "it must state its own."),
                       ("列の見出し{column}に単位がなく、ほかの列の単位は互いに異なります。"
                        "見出しに単位を書いてください。")),
    "column_order": (("The columns are stated as {columns} and are {count}; each must be named once, as "
                      "in 'time, NS, EW, UD'."),
                     ("ファイルには列が{columns}と書かれていますが、{count}列あります。"
                      "「time, NS, EW, UD」のように、時刻と各列の方向を1つずつ書いてください。")),
    "column_order_unread": (("The file names directions in {line}, from which the order of the columns is "
                             "not understood; state it by {option}."),
                            ("ファイルには{line}と方向が書かれていますが、列の順序を読み取れません。"
                             "「{option}」で列を指定してください。")),
    "column_unit_factor": (("The heading {column} states a factor, {factor}; the numbers must be in a "
                            "unit without one."),
                           ("列の見出し{column}に倍率{factor}が書かれています。"
                            "倍率のない単位の数値にしてください。")),
    "units_of_columns": ("nothing but the units of the columns", "各列の単位だけ"),
    "other_sign": (("By {said} numbers are positive the other way; change their sign and leave it out, or "
                    "head the vertical 'Down'."),
                   ("{said}によると、数値の正負の向きが逆です。符号を反転してその記載を消すか、"
                    "上下動の列の見出しを「Down」としてください。")),
    "spectral": ("a peak or a spectrum", "最大値やスペクトル"),
    "stated_twice": ("The file states as the {what} both {first} and {second}; they must agree.",
                     ("ファイルに{first}と{second}という異なる{what}が書かれています。"
                      "一致しなければなりません。")),
    "column_no_time": (("The first column is headed {column} and none as the time; one must be, or "
                        "{option} and the time step given."),
                       ("最初の列の見出しは{column}で、時刻の見出しのある列がありません。"
                        "時刻の列を加えるか、読む列を「{option}」で、時間刻みも指定してください。")),
    "time_in": ("in s or ms", "秒（s）またはミリ秒（ms）"),
    # What single formats lack.
    "csmip_directions": (("The header of channel {channel} gives the directions {directions}; {taken} is "
                          "taken."),
                         ("チャンネル{channel}のヘッダーの成分の方向が一致しません（{directions}）。"
                          "{taken}として使います。")),
    "csmip_lengths": (("The acceleration of channel {channel} lasts {lasts:g} s and its {kind} {other:g} "
                       "s; they must last as long."),
                      ("チャンネル{channel}の加速度の長さは{lasts:g}秒、「{kind}」は{other:g}秒です。"
                       "同じ長さでなければなりません。")),
    "csmip_channels_missing": (("The header counts {stated} channels and the file has {count}; the others "
                                "are in files of their own, or it was cut."),
                               ("ヘッダーによるとチャンネルは{stated}個ですが、ファイルには{count}個しかありません。"
                                "残りは別のファイルにあるか、途中で切れています。")),
    "velocity": ("velocity", "速度"),
    "displacement": ("displacement", "変位"),
    "counts": ("raw counts or volts of a recorder", "収録器の生のカウント値や電圧"),
}
