"""Scenario files: what is wrong with one. Names of keys stand as in the file."""

TEXTS: dict[str, tuple[str, str]] = {
    "measure_by_name": (
        "measures holds {value}; it must hold measures, such as MEASURES['belt']() or measures.Belt().",
        "measuresに{value}が含まれています。MEASURES['belt']()やmeasures.Belt()のような対策を指定してください。",
    ),
    "only_a_path": (
        "what is {value}; a file must be read first: read_scenario({value}).",
        "whatが{value}になっています。ファイルは先にread_scenario({value})で読み込んでください。",
    ),
    "in_table": ("In [{table}]", "[{table}]"),
    # What a key must be, from the JSON Schema
    "unknown_key": (
        "{name} is unknown{hint}; {where} must be one of {known}.",
        "{name}というキーはありません{hint}。{where}は次のいずれかです：{known}",
    ),
    "key_of_table": ("a key of [{table}]", "[{table}]のキー"),
    "top_level_key": ("a top-level key", "最上位のキー"),
    "missing": (
        "{name} is missing; it must be {allowed}.",
        "{name}がありません。{allowed}を指定してください。",
    ),
    "table": ("a table", "テーブル"),
    "table_with_type": ("a table with type", "typeのあるテーブル"),
    "one_of_tables": ("a table with type or combine", "typeかcombineのあるテーブル"),
    "or": (" or ", "、または"),
    "one_of": ("one of {names}", "{names}のいずれか"),
    "whole_number": ("a whole number between {low:g} and {high:g}{unit}", "{low:g}～{high:g}{unit}の整数"),
    "number": ("a number between {low:g} and {high:g}{unit}", "{low:g}～{high:g}{unit}の数値"),
    "true_or_false": ("true or false", "trueかfalse"),
    "list": ("a list of {count} items, each {item}", "{count}個の要素のリスト（各要素は{item}）"),
    "few_to_many": ("{few} to {many}", "{few}～{many}"),
    "table_of": ("a table of {keys}", "{keys}からなるテーブル"),
    "text": (
        "a text of {few} to {many} characters without control characters",
        "{few}～{many}文字の文字列（制御文字を除く）",
    ),
    # Keys that do not go together
    "no_preset": (
        "{name} is missing; it must be given where no {preset} is.",
        "{name}がありません。{preset}を使わない場合は必要です。",
    ),
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
    "on_and_height": (
        "The piece {name!r} stands on another and has a height in at; give x and y alone.",
        "家具{name!r}は他の家具の上に置かれ、atに高さもあります。xとyだけを指定してください。",
    ),
    "stands_on": (
        ("{name} is {value}, which names no piece before it; a piece stands on one that is given before."),
        "{name}が{value}になっていますが、それより前にその名前の家具がありません。",
    ),
    "no_such_piece": (
        "{name} is {value}, which names no piece of the file.",
        "{name}が{value}になっていますが、その名前の家具がありません。",
    ),
    "of_several": (
        "furniture is a list of pieces, stands in a [plan], or is no box; here it must be one preset or box, written as [furniture].",
        "furnitureが家具のリスト、[plan]のある部屋、または直方体以外の形になっています。ここでは[plan]なしの[furniture]（presetか直方体）にしてください。",
    ),
    "measures_on_solid": (
        "The piece {name!r} has measures; what they hold must be a preset or a box.",
        "家具{name!r}に対策が指定されています。対策はpresetか直方体の家具だけに使えます。",
    ),
    "no_such_path": (
        "{path!r} is no key of the file; it must be like room.back_wall.gap or joints[0].strength.",
        "{path!r}というキーはありません。room.back_wall.gapやjoints[0].strengthのように指定してください。",
    ),
    "installed_well": (
        "uncertainty.installation is given for several pieces; it must be 'well' or left out.",
        "複数の家具にuncertainty.installationが指定されています。'well'にするか、省いてください。",
    ),
    "no_length": (
        "{name} is missing; in space the piece needs its length across the depth [m].",
        "{name}がありません。立体で計算するには、奥行きと直角な方向の幅 [m] が必要です。",
    ),
    "of_a_lone_piece": (
        "{name} is of a single preset or box, written as [furniture] without a [plan]; here it must be left out.",
        "{name}は[plan]なしの[furniture]（presetか直方体）だけの指定です。ここでは省いてください。",
    ),
    "of_pieces": (
        "{name} is of several pieces; it must be left out, or furniture must be a list: [[furniture]].",
        "{name}は複数の家具のための指定です。省くか、furnitureをリスト（[[furniture]]）にしてください。",
    ),
    "pieces_in_the_plane": (
        "dimensions is 2; lists of pieces, rooms and what is no box are in space, so it must be 3 or left out.",
        "dimensionsが2ですが、家具のリスト、部屋、直方体以外の形は立体で計算します。3にするか、省いてください。",
    ),
    "sweep_of_a_case": (
        "{name} is given for a sweep of a scenario; it must be left out, or a Case be given.",
        "シナリオのsweepに{name}が指定されています。省くか、Caseを渡してください。",
    ),
    "flag_of_one": (
        "{flag} is of one piece, and must not be given with a file of several.",
        "{flag}は家具が1つの場合の指定です。複数の家具のファイルには使えません。",
    ),
    "beside_support": (
        "{name} = {value} must be a place on {other}: x of {low_x:.3g} to {high_x:.3g} m and y of {low_y:.3g} to {high_y:.3g} m from its middle.",
        "{name} = {value}は{other}の上の位置にしてください（中央からxは{low_x:.3g}～{high_x:.3g} m、yは{low_y:.3g}～{high_y:.3g} m）。",
    ),
    "no_carcass": (
        "furniture.mass is missing; where shelves are given it must be the empty carcass's [kg].",
        "furniture.massがありません。shelvesを指定する場合は、空の本体の質量 [kg] が必要です。",
    ),
    "roof": ("between 1 and {roof}, the roof", "1～{roof}（屋上）"),
    "only_one": (
        "{name} is given beside {other}; only one of the two must be given.",
        "{other}と{name}の両方があります。一方だけを指定してください。",
    ),
    "needs_both": (
        "{name} is given without {other}; it needs both.",
        "{name}だけがあります。{other}も必要です。",
    ),
    "without_record": (
        "{name} is given without shaking.record; it belongs to a record only.",
        "{name}はshaking.recordがある場合だけ指定できます。",
    ),
    "vertical_without_record": (
        "shaking.vertical is {value} without shaking.record; it must be true or false there.",
        "shaking.recordがないのにshaking.verticalが{value}になっています。trueかfalseにしてください。",
    ),
    "vertical_across": (
        "{name} is {file}, a vertical record ({label!r}); it must be a horizontal one.",
        "{name}の{file}は上下動の記録（「{label}」）です。水平の記録を指定してください。",
    ),
    "member_of_one": (
        "shaking.member is given for one motion; it belongs to a suite.",
        "shaking.memberは地震動が1つの場合は指定できません。suiteとともに使ってください。",
    ),
    "in_python": (
        "Given in Python, and not or not fully in this file: {what}.",
        "Pythonで指定され、このファイルにはない、または一部しかないもの：{what}。",
    ),
    "same_name": (
        "{name} is {value}; it must not be that of {other}.",
        "{name}が{value}になっていますが、{other}と同じ名前です。別の名前にしてください。",
    ),
    "option_of_nothing": ("the option with nothing in place", "何も付けない案"),
    # The file itself
    "file": ("The scenario file is {file}; {reason}.", "シナリオファイル{file}：{reason}。"),
    "file_too_long": ("it may have {most} bytes at most", "ファイルは{most}バイトまでです"),
    "file_not_read": ("it could not be read: {reason}", "読み込めませんでした（{reason}）"),
    "file_not_utf8": ("it must be a text in UTF-8", "UTF-8のテキストファイルにしてください"),
    "file_not_toml": ("it must be TOML, but: {reason}", "TOMLとして読めません（{reason}）"),
    "file_long_number": (
        "a whole number in it is too long; it must fit in 64 bits",
        "64ビットに収まらない整数があります",
    ),
    "file_too_deep": (
        "its brackets must be nested at most {most} deep",
        "括弧の入れ子は{most}段までにしてください",
    ),
    "file_long_keys": (
        "its keys have {count} parts beyond two each; they must have at most {most}",
        "キーの3個目以降の部分が合わせて{count}個あります。{most}個までにしてください",
    ),
}
"""Texts by their keys: English, Japanese."""
