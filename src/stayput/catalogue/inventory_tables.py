"""Tables and shake maps as people have them: their columns, units and files."""

TEXTS: dict[str, tuple[str, str]] = {
    # the mapping of columns
    "the_mapping": ("mapping of columns", "列の対応"),
    "mapped_column": ("The column of a mapping", "列の対応の列名"),
    "mapping": (
        "The mapping of columns has {value}; it must be such as width=奥行[mm],count=台数,ignore=備考.",
        "列の対応に{value}があります。width=奥行[mm],count=台数,ignore=備考のように書いてください。",
    ),
    "mapping_file": (
        "The mapping of columns is {path}; it must be a JSON object of texts, at most 1 MiB.",
        "列の対応（{path}）は、文字列からなるJSONのオブジェクト（1 MiB以下）にしてください。",
    ),
    "mapped_missing": (
        "The mapping says {name}={header}, and the table has no such column; it has {names}.",
        "列の対応に{name}={header}とありますが、表にその列がありません。表の列：{names}。",
    ),
    "mapped_twice": (
        "The mapping names {header} for two columns; each must be there once.",
        "列の対応で{header}が2つの列に使われています。1回だけにしてください。",
    ),
    "mapped_unclear": (
        "The mapping names {header}, and two columns are called so; it must have the whole name of one.",
        "列の対応の{header}に当たる列が2つあります。列名を全部書いてください。",
    ),
    "mapped_unit": (
        "The mapping has {name} in {unit}; its unit must be one of {known}.",
        "列の対応で{name}の単位が{unit}になっています。次のいずれかにしてください：{known}。",
    ),
    "mapped_other_unit": (
        "The mapping has {name} in {unit}, and the column {header} states another unit; they must agree.",
        "列の対応では{name}の単位が{unit}ですが、列{header}の単位と異なります。同じにしてください。",
    ),
    # what is unclear about columns
    "unclear": (
        (
            'The table has columns that must be clear: {doubts}. It looks like --columns "{proposal}"; '
            "check it, fill in what is a ?, and give it."
        ),
        (
            '表の列に、はっきりしないものがあります：{doubts}。おそらく --columns "{proposal}" です。'
            "確かめて、?があれば埋めて指定してください。"
        ),
    ),
    "more_doubts": ("and {count} more", "ほか{count}件"),
    "doubt_no_unit": ("{header} has no unit", "{header}に単位がありません"),
    "doubt_unit": ("{header} is in a unit that is unknown for it", "{header}の単位が分かりません"),
    "doubt_large": (
        "{header} would be in m, and its numbers are about {number}",
        "{header}はm単位のはずですが、数値が{number}前後です",
    ),
    "doubt_note": (
        "{header} may be something else, because of {note!r}",
        "{header}は「{note}」とあるので、別のものかもしれません",
    ),
    "doubt_width": (
        "{depth} is there beside {width}: the shaking is front to back, so stayput's width is the depth",
        "{width}のほかに{depth}があります（揺れは前後方向で、stayputのwidthは奥行です）",
    ),
    "doubt_no_depth": (
        (
            "{header} seems to be the size along the wall, and the one from front to back is missing, on which "
            "falling depends (if it is that: width=…)"
        ),
        "{header}は壁に沿った寸法のようです。転倒に関わる奥行の列がありません（奥行ならwidth=…）",
    ),
    "doubt_twice": (
        "{a} and {b} are both the {name}",
        "{a}と{b}の両方が{name}に当たります",
    ),
    "doubt_count": (
        "{header} seems to say how many pieces there are",
        "{header}は家具の数のようです",
    ),
    "doubt_total": (
        (
            "{header} may be of all pieces of a row, where stayput takes the value of one "
            "(if it is of one: value=…)"
        ),
        "{header}は行全体の合計かもしれません（stayputは1点あたりの額を使います。1点の額ならvalue=…）",
    ),
    "doubt_sizes": (
        "{header} seems to hold several sizes; each must have its own column",
        "{header}には複数の寸法が入っているようです。寸法ごとに列を分けてください",
    ),
    "doubt_floor": (
        "{header} holds storeys, and stayput's floor is the surface",
        "{header}には階が入っています（stayputのfloorは床材です）",
    ),
    # cells
    "comma": (
        (
            "{name} is {value}, of which the mark may be that of decimals or of thousands; "
            "it must be written without it."
        ),
        "{name}が{value}になっています。点またはコンマが小数点か桁区切りか分かりません。どちらもなしで書いてください。",
    ),
}
"""Texts by their keys: English, Japanese."""
