"""Refusals that any number or name may meet."""

TEXTS: dict[str, tuple[str, str]] = {
    "colon": (": ", "："),
    "listed": ("; ", "、"),
    "stop": (". ", "。"),
    "not_possible": ("not possible", "設置不可"),
    "unknown": ("unknown", "不明"),
    "seed": ("Seed", "乱数のシード"),
    "without": ("Without measures", "対策なし"),
    "about": ("about {share}", "約{share}"),
    "under": ("under {share}", "{share}未満"),
    "over": ("over {share}", "{share}超"),
    # Controls of an animation
    "play": ("Play", "再生"),
    "pause": ("Pause", "一時停止"),
    "time": ("Time", "時刻"),
    "speed": ("Speed", "速さ"),
    # Refusals
    "aside": (" ({content})", "（{content}）"),
    "did_you_mean": (" (did you mean {name}?)", "（{name}ではありませんか）"),
    "no_such_file": ("no such file or directory", "ファイルまたはフォルダーがありません"),
    "no_access": ("permission denied", "アクセスが許可されていません"),
    "is_folder": ("is a directory", "フォルダーです"),
    "no_folder": ("not a directory", "フォルダーではありません"),
    "there_already": ("file exists", "すでにあります"),
    "long_name": ("file name too long", "名前が長すぎます"),
    "disk_full": ("no space left on device", "ディスクの空き容量がありません"),
    "read_only": ("read-only file system", "書き込みが禁止されています"),
    "address_in_use": ("address already in use", "そのアドレスはすでに使われています"),
    "connection_refused": ("connection refused", "接続が拒否されました"),
    "not_one_of": (
        "{name} is {value}{hint}; it must be one of {known}.",
        "{name}が{value}になっています{hint}。次のいずれかにしてください：{known}",
    ),
    "folder_is_file": (
        "The folder is {folder}; it must be a folder, and {path} is a file.",
        "{folder}はフォルダーにしてください。{path}はファイルです。",
    ),
    "not_allowed": (
        "{name} is {value}{hint}; it must be {allowed}.",
        "{name}が{value}になっています{hint}。{allowed}を指定してください。",
    ),
    "left_out": (
        "{name} is given {where}; it must be left out.",
        "{name}は{where}には指定できません。省いてください。",
    ),
    "number": ("a number", "数値"),
    "numbers": ("numbers", "数値の並び"),
    "so_many_numbers": ("{count} numbers", "{count}個の数値"),
    "finite_number": ("a finite number", "有限の数値"),
    "whole_number": ("a whole number", "整数"),
    "not_written": ("{path} could not be written: {reason}.", "{path}に書き込めませんでした（{reason}）。"),
    "shape_of": ("The shape of {name}", "{name}の形状"),
    "unreadable": ("{file} cannot be read: {reason}.", "{file}を読み込めません（{reason}）。"),
    "above_zero": ("larger than 0", "0より大きい数値"),
    "list": ("a list", "リスト"),
    "numbers_in": ("numbers", "数値"),
    "items": ("items", "項目"),
    "so_many_values": (
        "{name} has {count} values; it must have {wanted}.",
        "{name}の値が{count}個になっています。{wanted}個にしてください。",
    ),
    "twice": ("{name} is given twice; give it once.", "{name}が2回あります。1回にしてください。"),
    "empty": ("{name} is empty; give one or more.", "{name}が空です。1つ以上指定してください。"),
    "of_type": ("of type {wanted}", "{wanted}型の値"),
    "plain_text": (
        "a text of one or more characters without control characters",
        "制御文字を含まない1文字以上の文字列",
    ),
    "compilation_disabled": (
        "NUMBA_DISABLE_JIT is set, and the mechanics run as compiled code only; unset it.",
        "NUMBA_DISABLE_JITが設定されていますが、計算部はコンパイルしたコードでしか動きません。設定を解除してください。",
    ),
    "too_many": (
        "{name} has {count:,} {what}; it must have at most {most:,}.",
        "{name}の{what}が{count:,}あります。{most:,}以下にしてください。",
    ),
    "too_many_bytes": (
        "{file} has {size} bytes; at most {most} are read.",
        "{file}が大きすぎます（{size}バイト）。{most}バイトまで読めます。",
    ),
    "only_a_path": (
        "{name} is {value}; a file must be read first: {reader}({value}).",
        "{name}が{value}になっています。ファイルは先に{reader}({value})で読み込んでください。",
    ),
    "too_large": ("{name} is too large; it must be finite.", "{name}が大きすぎます。有限の数値が必要です。"),
    "not_within": (
        "{name} is {value:g}{unit}; it must be between {low:g} and {high:g}{unit}.",
        "{name}が{value:g}{unit}になっています。{low:g}～{high:g}{unit}にしてください。",
    ),
    "language": ("The language", "言語"),
    # threads and executors
    "threads": ("Threads", "スレッド数"),
    "executor_lost": (
        "The executor is lost ({reason}); start it anew, and give the same call again.",
        "処理系（executor）が使えなくなりました（{reason}）。起動し直してから、同じ処理をもう一度実行してください。",
    ),
    "no_worker": ("The cluster has no worker; waiting for one.", "クラスターのワーカーを待っています。"),
    "worker_version": (
        "A worker has stayput {worker}; it must have that of this command, {version}.",
        "ワーカーのstayputが{worker}になっています。このコマンドと同じ{version}にしてください。",
    ),
}
"""Texts by their keys: English, Japanese."""
