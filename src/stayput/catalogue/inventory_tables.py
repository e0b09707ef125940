"""Tables and shake maps as people have them: their columns, units and files."""

TEXTS: dict[str, tuple[str, str]] = {
    # the mapping of columns
    "column_name": ("The column", "列名"),
    "mapping": (("The mapping of columns has {value}; it must be such as "
                 "width=奥行[mm],count=台数,ignore=備考."),
                "列の対応に{value}があります。width=奥行[mm],count=台数,ignore=備考のように書いてください。"),
    "mapping_file": ("a JSON object of texts, at most 1 MiB",
                     "文字列からなるJSONのオブジェクト（1 MiBまで）"),
    "mapped_unclear": (("The mapping names {header}, and two columns are called so; it must have the "
                        "whole name of one."),
                       "列の対応の{header}に当たる列が2つあります。列名を全部書いてください。"),
    # headings
    "no_known_column": (("No heading of the first row is known that tells what the pieces are or how "
                         'large they are; --columns "{proposal}" says what the columns are, with one of '
                         "{columns} or ignore in the place of each ? (width is the depth, from front to "
                         "back)."),
                        ("1行目に、家具の種類や寸法が分かる見出しがありません。"
                         '--columns "{proposal}" の?を次のいずれかに置き換えて指定してください：'
                         "{columns}（widthは奥行）。使わない列はignoreとします。")),
    "headings_below": (("Row {row} has headings ({found}); they must be one row, the first, with whole "
                        "names such as Depth (mm): rows above them must be removed."),
                       ("{row}行目に見出し（{found}など）があります。その上の行を削除するか1行にまとめ、"
                        "「奥行(mm)」のように列名を全部書いた見出しを1行目にしてください。")),
    "buildings": (("The inventory is a table of buildings in Open Exposure Data ({columns}, …); it must have "
                   "a row for each piece of furniture."),
                  "Open Exposure Dataの建物の一覧です（{columns}など）。1行に家具1点の表にしてください。"),
    # what is unclear about columns
    "unclear": (('Not all columns are certain; they look like --columns "{proposal}", which must be '
                 "checked and given{fill} (width is the depth, from front to back): {doubts}."),
                ('意味のはっきりしない列があります。おそらく --columns "{proposal}" です（widthは奥行）。'
                 "確かめて{fill}指定してください：{doubts}。")),
    "fill": (", with the name of a column, a unit or ignore for each ?", "?を列名・単位・ignoreで埋めて"),
    "currencies": (("The values and the costs are in {currencies}; both must be in one currency."),
                   "損失額と費用の通貨が異なります（{currencies}）。同じ通貨にそろえてください。"),
    "more_doubts": ("and {count} more", "ほか{count}件"),
    "doubt_unit": ("{header} has no unit that is known for it", "{header}の単位が分かりません"),
    "doubt_note": ("{header} may be something else, because of {note!r}",
                   "{header}は「{note}」とあるので、別のものかもしれません"),
    "doubt_width": (("{header} is there beside {width}: the shaking is front to back, so stayput's width "
                     "is the depth"),
                    "{width}のほかに{header}があります（揺れは前後方向で、stayputのwidthは奥行です）"),
    "doubt_no_depth": (("{header} seems to be along the wall, and the depth is missing (if it is the "
                        "depth: width=…)"),
                       ("{header}は壁に沿った寸法のようです。"
                        "転倒に関わる奥行の列がありません（奥行ならwidth=…）")),
    "doubt_twice": ("{first} and {header} are both the {name}", "{first}と{header}の両方が{name}です"),
    "doubt_masses": (("{first} seems to be with what is inside, as the mass is, and {header} without (ignore "
                      "{first} if it is of several pieces)"),
                     ("{first}は収納物を含む重量（massはこちら）、{header}は家具だけの重量のようです"
                      "（{first}が何点かの合計なら、そちらをignore）")),
    "doubt_rack_units": ("{header} seems to be a height in rack units of 44.45 mm, without the frame",
                         "{header}はラックユニット（1Uは44.45 mm、枠を含まない）の高さのようです"),
    "doubt_count": ("{header} seems to say how many pieces there are", "{header}は家具の数のようです"),
    "doubt_total": (("{header} may be of all pieces of a row, and stayput takes that of one (if it is "
                     "that: value=…)"),
                    ("{header}は行全体の合計かもしれません（stayputは1点あたりの額を使います。"
                     "1点の額ならvalue=…）")),
    "doubt_size": (("{header} seems to be a size, and it is not certain which (width, height, or ignore; "
                    "each in its own column)"),
                   ("{header}は寸法のようですが、どの寸法か分かりません（width、height、またはignore。"
                    "寸法ごとに1列）")),
    "doubt_floor": ("{header} holds storeys, and stayput's floor is the surface",
                    "{header}には階が入っています（stayputのfloorは床材です）"),
    # shake maps
    "grid_numbers": ("its grid_data must hold numbers alone, a line for each place",
                     "grid_dataには、地点ごとに1行の数値だけを書いてください"),
    "grid_kind": (("it must be a shakemap_grid with a grid_specification, whose nlon and nlat are whole "
                   "numbers, and the fields LON and LAT, each field once with an index"),
                  ("nlonとnlatが整数のgrid_specificationと、"
                   "LONとLATを含む重複しない項目（それぞれindexが必要）のあるshakemap_gridにしてください")),
    "grid_count": ("it has {count} numbers; it must have {due}",
                   "数値が{count}個あります。必要な数は{due}個です"),
    "grid_places": ("its places must be a regular grid of latitudes and longitudes, 2 by 2 at least",
                    "地点は、緯度と経度の規則的な格子（2×2以上）にしてください"),
    "grid_broken": ("it is no well-formed XML ({said})", "XMLの形式が正しくありません（{said}）"),
    "map_is_silent": ("The place is {lat:g}°, {lon:g}°, where the shake map has no value.",
                      "位置（{lat:g}°、{lon:g}°）には地震動マップの値がありません。"),
    "no_deviations": ("a file with values of the field {name}", "{name}の値のあるファイル"),
    "unit_of": ("The unit of {name}", "{name}の単位"),
    "other_event": (("The map {path} is of {event} and the uncertainty {other} of {other_event}; they "
                     "must be of one."),
                    ("マップ{path}は{event}、不確かさ{other}は{other_event}のものです。"
                     "同じ地震の同じ版でなければなりません。")),
    "event_unstated": (("The map {path} and the uncertainty {other} do not both say of which event they "
                        "are; check it."),
                       ("マップ{path}と不確かさ{other}から、同じ地震のものかどうかが分かりません。"
                        "確かめてください。")),
    "other_grid": ("one for the places of the shake map", "地震動マップと同じ地点のもの"),
    "of_csv": ("beside a map in CSV, whose column sigma has it", "CSVの地震動マップ（sigmaの列に書きます）"),
    # exports
    "export": ("The format of an export", "書き出しの形式"),
    # cells
    "column": ("Column {header}", "列{header}"),
}
