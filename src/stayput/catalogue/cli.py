"""The command line's refusals and warnings. Flags stand as they are typed."""

TEXTS: dict[str, tuple[str, str]] = {
    "strength": ("Stated shaking", "指定した揺れ"),
    "one_of_two": (
        "{flag} is {value} beside {other} {other_value}; it must be one of the two.",
        "{flag} {value}と{other} {other_value}の両方が指定されています。一方だけにしてください。",
    ),
    "no_vertical_file": (
        "--z is {value} beside --no-vertical; it must be one of the two.",
        "--z {value}と--no-verticalの両方が指定されています。一方だけにしてください。",
    ),
    "no_motion": (
        "There is no motion; it must be given as {name} or with --x.",
        "揺れが指定されていません。{name}か--xで指定してください。",
    ),
    "no_output": (
        "OUT is missing; it must be the file to write.",
        "OUTが指定されていません。書き出すファイルを指定してください。",
    ),
    "input_twice": (
        "{flag} and {other} are both -, standard input; one of them must be a file.",
        "{flag}と{other}がどちらも-（標準入力）になっています。一方にはファイルを指定してください。",
    ),
    "output_twice": (
        "{flag} and {other} both go to standard output; one of them must go to a file, or be left out.",
        "{flag}と{other}の両方が標準出力に書き出されます。一方はファイルに書き出すか、省いてください。",
    ),
    "written_like": (
        "{flag} is {value}; it must be written like {example}.",
        "{flag}が{value}になっています。{example}のように書いてください。",
    ),
    "warning": ("Warning: {sentence}", "注意：{sentence}"),
    "wrong_value": (
        "{name} is {value}; it must be {allowed}.",
        "{name}が{value}になっています。{allowed}を指定してください。",
    ),
    "number": ("a number", "数値"),
    "whole_number": ("a whole number", "整数"),
    "whole_number_within": ("a whole number from {low} to {high}", "{low}から{high}までの整数"),
    "no_such_flag": (
        "There is no flag {flag}; `{command} --help` lists those that there are.",
        "{flag}というオプションはありません。{command} --helpで一覧を確認してください。",
    ),
    "missing": (
        "{name} is missing; `{command} --help` says how the command is written.",
        "{name}が指定されていません。書き方は{command} --helpで確認してください。",
    ),
    "misused": (
        "{said}; `{command} --help` says how the command is written.",
        "コマンドを読み取れません（{said}）。書き方は{command} --helpで確認してください。",
    ),
    "same_file": (
        "{flag} and {other} are both {value}; each must have a file of its own.",
        "{flag}と{other}がどちらも{value}になっています。別々のファイルを指定してください。",
    ),
    "home_without_plan": (
        "--no-drilling, --tatami, --plasterboard or --dropped-ceiling is given without --plan; each must come with it.",
        "--no-drilling、--tatami、--plasterboard、--dropped-ceilingは--planと一緒に指定してください。",
    ),
    "plan_of_a_room": (
        "--plan is given for a file without [plan]; it must be the file of a room.",
        "--planが指定されていますが、[plan]がありません。部屋のファイルを指定してください。",
    ),
    "length_in_the_plane": (
        "--length is {value:g} m, which changes nothing in the plane of the depth; with --dimensions 3 it does.",
        "--lengthが{value:g} mになっていますが、奥行き方向の平面の解析では結果に影響しません。--dimensions 3では影響します。",
    ),
    "no_row": (
        "No row of the inventory could be assessed; {rejects} says why, row by row.",
        "評価できる行がありませんでした。理由は行ごとに{rejects}に書かれています。",
    ),
    "out_needs_storey": (
        "--out is {out}; it must come with one --storey, whose motion is written.",
        "--outが{out}になっています。揺れを書き出す階を1つ、--storeyで指定してください。",
    ),
    "target": (
        "--target is {value}; it must be japan[:LEVEL[,SOIL]], asce7:SDS,SD1[,TL] or a file that exists.",
        (
            "--targetが{value}になっています。"
            "japan[:LEVEL[,SOIL]]、asce7:SDS,SD1[,TL]、または存在するファイルを指定してください。"
        ),
    ),
    "folder_is_file": (
        "The folder is {folder}; it must be a folder, and that is a file.",
        "{folder}はファイルです。フォルダーを指定してください。",
    ),
    "no_parent": (
        "The folder is {folder}; the folder that it is in must exist.",
        "フォルダー{folder}の親フォルダーがありません。先に作成してください。",
    ),
    "of_a_target": (
        "--select and --fit are given without --target; they belong to a target spectrum.",
        "--selectと--fitは、--target（目標スペクトル）とともに使ってください。",
    ),
}
"""Texts by their keys: English, Japanese."""
