"""Inventories of furniture."""

TEXTS: dict[str, tuple[str, str]] = {
    # the call
    "memory": ("Memory", "メモリ"),
    "the": ("The {what}", "{what}"),
    "the_uncertainty": ("The uncertainty of the shake map", "地震動マップの不確かさ"),
    "the_map": ("The shake map", "地震動マップ"),
    "the_file": ("The inventory", "家具一覧"),
    "memory_format": ("a text like 2GB", "2GBのような文字列"),
    # files
    "not_a_file": ("a file", "ファイル"),
    "changed": ("The {file} {path} was changed while it was read; give the command again.",
                "{file}（{path}）が読み込み中に変更されました。コマンドをもう一度実行してください。"),
    "unwritable": (("The folder is {folder}; it could not be written: {reason}{at}. The same command goes "
                    "on from there."),
                   ("フォルダー{folder}に書き込めませんでした：{reason}{at}。"
                    "同じコマンドで続きから再開できます。")),
    "at_path": (" (at {path})", "（{path}）"),
    "file_ending": ("a file that ends in {endings} (a spreadsheet can save any other table as one)",
                    "拡張子が{endings}のファイル（表計算ソフトで保存し直せます）"),
    "encoding": ("a text in UTF-8, cp932 (Shift_JIS) or UTF-16 (Excel saves CSV UTF-8)",
                 "UTF-8、cp932（Shift_JIS）、BOM付きUTF-16のいずれかのテキスト（Excelでは「CSV UTF-8」）"),
    "first_row": ("The first row of the inventory must name the columns: {reason}.",
                  "家具一覧の1行目に列名がありません：{reason}。"),
    "is_empty": ("it is empty", "空です"),
    "no_rows": ("a table with a row below its header", "見出しの下に行のある表"),
    "other_kind": ("a file of {kind}", "{kind}のファイル"),
    "a_row": ("The row", "行"),
    "open_quote": (("In row {row} of the inventory (line {line}) a quote opens that does not close; it "
                    "must close within {most:,} characters."),
                   ("家具一覧の{row}行目（ファイルの{line}行目）で始まる引用符が、"
                    "{most:,}文字以内に閉じられていません。")),
    # header
    "row_length": ("The row has {cells} cells; it must have one for each of {columns} columns.",
                   "この行のセルは{cells}個です。列の数と同じ{columns}個にしてください。"),
    "cell_without_name": ("Cell {cell} is {value}, in a column without a name.",
                          "{cell}番目のセルに{value}とありますが、その列に名前がありません。"),
    "nothing": ("nothing", "なし"),
    # cells
    "usable": ("a plain text or number", "文字列または数値"),
    "cell_formula": ("a formula", "数式"),
    "cell_date": ("a date", "日付"),
    "cell_other": ("neither text nor number", "文字列でも数値でもない値"),
    "cell_error": ("an error of the spreadsheet ({error})", "表計算ソフトのエラー値（{error}）"),
    "merged_cells": (("Cells {cells} of the sheet are merged over several rows; each row must have its "
                      "own, the headings one row."),
                     ("シートのセル{cells}が複数行にわたって結合されています。"
                      "結合を解除して各行に値を入れ、見出しは1行にしてください。")),
    "of_a_piece": ("that of a piece, and not of a total", "合計ではない家具のもの"),
    "cell_unit": ("a number that is shown in {unit}", "単位{unit}付きで表示される数値"),
    "plain_number": ("a plain number{unit}", "数値だけ{unit}"),
    "comma": ("written without its point or comma, which may be of decimals or of thousands",
              "点やコンマのない数値（小数点か桁区切りか分かりません）"),
    "cell_without_unit": ("a number with a unit, as in its column", "同じ列と同様に単位のある数値"),
    "decimal_comma": (" (a comma is a decimal one where semicolons stand between the columns)",
                      "（小数点のコンマは、列をセミコロンで区切った表だけで使えます）"),
    "in_unit": (" in {unit}", "（単位は{unit}）"),
    "parts": ("parts", "要素"),
    "missing_number": ("numbers between all semicolons", "セミコロンで区切った数値"),
    "without_mass": ("Its forces, or the motion of what is inside, depend on the mass, which must be given.",
                     "力や収納物の動きは家具の重量によります。重量を指定してください。"),
    # rows
    "row": ("row {row}", "{row}行目"),
    "place_missing": ("given with stations or a shake map", "観測点や地震動マップを使うときは緯度と経度"),
    "building_missing": (("{name} is missing; a storey needs it: in a column building, or under [shaking] "
                          "of the scenario."),
                         ("{name}がありません。階を指定するときは、列「建物」か、"
                          "シナリオの[shaking]のbuildingとstoreyに書いてください。")),
    "storey": (("{name} is {value}; it must be 1 (on the ground) to {highest} (the roof), or such as 3F, "
                "M2F, B1 to B{deepest} or RF."),
               ("{name}が{value}になっています。1（1階）～{highest}（屋上）か、3F、3階、中2階、"
                "B1～B{deepest}、屋上のように書いてください。")),
    "unknown_building": (("{name} is {value}; it must be one of the scenario's ({known}), or storeys and "
                          "structure such as 10 RC."),
                         ("{name}が{value}になっています。シナリオにある建物（{known}）、"
                          "または「10 RC」のような階数と構造にしてください。")),
    "floor": ("a surface, or static;kinetic friction", "床材、または静止;動摩擦係数"),
    # scenarios
    "not_used": (("{scenario}: {key} is not used; here measures are well installed, and only earthquakes "
                  "count."),
                 ("{scenario}: {key}は使われません。一覧の評価では、対策は正しく取り付けられたものとし、"
                  "地震だけを扱います。")),
    "other_building": ("The building {name} is another one in {scenario}; it must be the same.",
                       "建物{name}の内容が{scenario}では異なります。同じにしてください。"),
    "scenarios": ("a folder with files that end in .toml", "拡張子が.tomlのファイルのあるフォルダー"),
    "as_in_others": ("given as in the other files", "ほかのファイルと同様の指定"),
    "map_beside_stations": ("beside stations or several scenarios", "観測点のある、または複数のシナリオ"),
    # shake maps
    "period": ("The period of column {column}", "列{column}の周期"),
    "on_the_map": ("{name} on the shake map", "地震動マップ上の{name}"),
    "in_row_of_the_map": ("{name} in row {row} of the shake map", "地震動マップ{row}行目の{name}"),
    "map_not_csv": ("CSV in UTF-8 or ShakeMap's grid.xml, uncompressed", "圧縮していないCSVかgrid.xml"),
    "map_empty": ("a map with at least one place", "地点のあるマップ"),
    "map_columns": (("The shake map has the columns {columns}; they must be lat, lon and one of intensity "
                     "(JMA's), pga[%g], pgv[cm/s], mmi and sa_T, Sa [g] at 5 % damping at a period T [s], "
                     "such as sa_0.3; sigma may be added, and of several measures one must be chosen."),
                    ("地震動マップの列は{columns}です。lat、lonと、intensity（計測震度）、pga[%g]、"
                     "pgv[cm/s]、mmi、sa_T（周期T秒、減衰5%の加速度応答スペクトル [g]、例："
                     "sa_0.3）のいずれか1つにしてください（sigmaを加えられます。"
                     "複数あるときは1つを選びます）。")),
    # the folder of the results
    "other_assessment": (("The folder {folder} holds an assessment of another {other}; give the same one, "
                          "or another folder."),
                         ("フォルダー{folder}には別の{other}による結果があります。同じものか、"
                          "別のフォルダーを指定してください。")),
    "input_format": ("format", "形式"),
    "input_version_of_stayput": ("version of stayput", "stayputのバージョン"),
    "input_inventory": ("inventory", "家具一覧"),
    "input_scenario": ("scenario", "シナリオ"),
    "input_shake_map": ("shake map", "地震動マップ"),
    "input_field": ("field of the shake map", "地震動マップの項目"),
    "input_uncertainty": ("uncertainty of the shake map", "地震動マップの不確かさ"),
    "input_columns": ("mapping of columns", "列の対応"),
    "input_slide_limit": ("slide limit", "移動量の上限"),
    "input_list_of_inputs": ("list of inputs", "入力の一覧"),
    "strangers": ("The folder {folder} holds {name} and no assessment; it must be empty or new.",
                  ("フォルダー{folder}に{name}がありますが、評価結果ではありません。"
                   "空または新しいフォルダーにしてください。")),
    "at_work": ("Another command is at work in {folder}; wait until it ends.",
                "別のコマンドが{folder}で実行中です。終わるまでお待ちください。"),
    "in_the_way": (("The folder {folder} holds {name}, which is not the assessment's and in its way; move "
                    "it elsewhere."),
                   ("フォルダー{folder}にある{name}は評価結果のものではなく、妨げになります。"
                    "別の場所へ移してください。")),
    # executors
    "no_scheduler": ("The scheduler is {scheduler}; it could not be reached: {reason}.",
                     "スケジューラー{scheduler}に接続できませんでした：{reason}。"),
}
