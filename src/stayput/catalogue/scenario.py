"""Scenario files: what is wrong with one. Names of keys stand as in the file."""

TEXTS: dict[str, tuple[str, str]] = {
    "in_table": ("In [{table}]", "[{table}]"),
    # What a key must be, from the JSON Schema
    "unknown_key": (
        "{name} is unknown{hint}; {where} must be one of {known}.",
        "{name}というキーはありません{hint}。{where}は次のいずれかです：{known}",
    ),
    "key_of_table": ("a key of [{table}]", "[{table}]のキー"),
    "top_level_key": ("a top-level key", "最上位のキー"),
    "missing": ("{name} is missing; it must be {allowed}.", "{name}がありません。{allowed}が必要です。"),
    "table": ("a table", "テーブル"),
    "table_with_type": ("a table with type", "typeのあるテーブル"),
    "one_of_tables": ("a table with type or combine", "typeかcombineのあるテーブル"),
    "or": (" or ", "、または"),
    "like_that": ("like that", "前記と同じもの"),
    "one_of": ("one of {names}", "{names}のいずれか"),
    "whole_number": ("a whole number between {low:g} and {high:g}{unit}", "{low:g}～{high:g}{unit}の整数"),
    "number": ("a number between {low:g} and {high:g}{unit}", "{low:g}～{high:g}{unit}の数値"),
    "true_or_false": ("true or false", "trueかfalse"),
    "list": ("a list of {count} items, each {item}", "{count}個の要素のリスト（各要素は{item}）"),
    "few_to_many": ("{few} to {many}", "{few}～{many}"),
    "table_of": ("a table of {keys}", "{keys}からなるテーブル"),
    "names_of_pieces": ("names of pieces", "家具の名前"),
    "text": (
        "a text of {few} to {many} characters without control characters",
        "{few}～{many}文字の文字列（制御文字を除く）",
    ),
    # Keys that do not go together
    "without_preset": ("given where no preset is", "プリセットを使わない場合の値"),
    "one_shape": (
        (
            "The piece {name!r} needs one shape: preset; width, length and height; diameter and height; "
            "bottom, top and height; or mesh."
        ),
        (
            "家具{name!r}には形を1つだけ指定してください（preset、width・length・height、diameter・height、"
            "bottom・top・height、meshのいずれか）。"
        ),
    ),
    "given_before": ("the name of a piece given before it", "それより前にある家具の名前"),
    "of_several": (
        "furniture must here be one preset or box written as [furniture], without [plan].",
        "furnitureは、ここでは[plan]なしの[furniture]（presetか直方体）にしてください。",
    ),
    "of_a_solid": ("for a piece that is neither a preset nor a box", "presetでも直方体でもない家具"),
    "no_such_path": (
        "{path!r} is no key of the file; it must be like room.left_wall.gap or joints[0].strength.",
        "{path!r}というキーはありません。room.left_wall.gapやjoints[0].strengthのように指定してください。",
    ),
    "of_a_lone_piece": (
        "where furniture is not one preset or box written as [furniture], without [plan]",
        "[plan]なしの[furniture]（presetか直方体）以外",
    ),
    "of_pieces": ("for one piece, not a list: [[furniture]]", "リスト（[[furniture]]）ではない1つの家具"),
    "pieces_in_the_plane": ("3 or left out, unless one box stands alone", "直方体1つ以外では3（または省略）"),
    "sweep_of_a_case": ("for a sweep of a scenario, not of a Case", "シナリオのsweep"),
    "beside_support": (
        "{name} = {value} must be a place on {other}: x of {low_x:.3g} to {high_x:.3g} m and y of {low_y:.3g} to {high_y:.3g} m from its middle.",
        "{name} = {value}は{other}の上の位置にしてください（中央からxは{low_x:.3g}～{high_x:.3g} m、yは{low_y:.3g}～{high_y:.3g} m）。",
    ),
    "no_carcass": ("the empty carcass's [kg], with shelves", "棚を除いた本体の質量 [kg] "),
    "roof": ("a whole number from 1 to {roof}, the roof", "1～{roof}（屋上）の整数"),
    "only_one": (
        "{name} is given beside {other}; only one of the two must be given.",
        "{other}と{name}の両方があります。一方だけを指定してください。",
    ),
    "needs_both": ("{name} is given without {other}; give both.", "{name}には{other}も必要です。"),
    "without_record": ("without shaking.record", "shaking.recordのないファイル"),
    "vertical_without_record": (
        "true or false without shaking.record",
        "shaking.recordがなければtrueかfalse",
    ),
    "horizontal": ("a horizontal record", "水平の記録"),
    "member_of_one": ("without a suite", "suiteのないファイル"),
    "in_python": (
        "Given in Python, and not or not fully in this file: {what}.",
        "Pythonで指定され、このファイルにはない、または一部しかないもの：{what}。",
    ),
    "same_name": (
        "{name} is {value}; it must not be that of {other}.",
        "{name}が{value}になっていますが、{other}と同じです。別のものにしてください。",
    ),
    "option_of_nothing": ("the option with nothing in place", "何も付けない案"),
    # The file itself
    "file": ("The scenario file is {file}; {reason}.", "シナリオファイル{file}：{reason}。"),
    "file_too_long": ("it may have {most} bytes at most", "ファイルは{most}バイトまでです"),
    "file_not_read": ("it could not be read: {reason}", "読み込めませんでした（{reason}）"),
    "file_not_utf8": ("it must be a text in UTF-8", "UTF-8のテキストファイルにしてください"),
    "file_not_toml": ("it must be TOML, but: {reason}", "TOMLとして読めません（{reason}）"),
    "file_long_number": ("a whole number in it exceeds 64 bits", "64ビットに収まらない整数があります"),
    "file_too_deep": ("its brackets must nest at most {most} deep", "括弧の入れ子は{most}段までです"),
    "file_long_keys": (
        "its keys have {count} parts beyond two each; they must have at most {most}",
        "キーの3個目以降の部分が合わせて{count}個あります。{most}個までにしてください",
    ),
}
"""Texts by their keys: English, Japanese."""
