"""Bodies, rooms, cases, what is not known, and a run of them."""

TEXTS: dict[str, tuple[str, str]] = {
    # Parts of the labels of fields, and what other numbers are called
    "static_friction": ("{surface} static friction", "{surface}の静止摩擦係数"),
    "kinetic_friction": ("{surface} kinetic friction", "{surface}の動摩擦係数"),
    "field_of": ("“{owner}” {name}", "「{owner}」の{name}"),
    # Bodies
    "inside_the_section": ("inside the section: below {width:g} m sideways and {height:g} m upwards in size",
                           "断面の内側（横{width:g} m未満、縦{height:g} m未満）の値"),
    "bearing_insets": (("smaller, so that the base carries the centre of gravity, {x:g} m right of the "
                        "middle"),
                       "中央から{x:g} m右の重心を底面が支えられる、より小さい値"),
    "density": (("The mass of {mass:g} kg makes a mean density of {density:.3g} kg/m³ for this size; it must "
                 "be between {least:g} and {most:,.0f} kg/m³."),
                ("質量{mass:g} kgでは、この大きさの平均密度が{density:.3g} kg/m³になります。"
                 "{least:g}～{most:,.0f} kg/m³の範囲になる値にしてください。")),
    "not_of_its_shape": (("{name} follows from the shape of the body; make another body with Body.hull, "
                          ".box, .cylinder or .mesh."),
                         ("{name}は立体の形から決まります。Body.hull、.box、.cylinder、"
                          ".meshで別のBodyを作ってください。")),
    "another_shape": (("The body has a shape of its own; here it must be made by its section: Body(width, "
                       "height, mass)."),
                      ("Bodyに立体の形が指定されています。ここでは断面で作ってください："
                       "Body(width, height, mass)。")),
    "total_mass": ("The parts' total mass", "部分の質量の合計"),
    # Rooms
    "surface": ("Floor surface", "床の種類"),
    # The start of a run
    "laid_down": (("The body is tilted by {tilt:.5g}° at the start, {rest:.5g}° of it at rest; it must be "
                   "less than 90° to either side."),
                  ("家具が最初から{tilt:.5g}°傾いています（うち静止時の傾き{rest:.5g}°）。"
                   "左右とも90°未満にしてください。")),
    "inside": ("The body stands {depth:g} m inside {place} at the start; it must be clear of it.",
               "家具が最初から{place}に{depth:g} mめり込んでいます。離して置いてください。"),
    "right_wall": ("the wall in front", "前方の壁"),
    "left_wall": ("the wall behind", "背後の壁"),
    "ceiling": ("the ceiling", "天井"),
    "part_of_room": ("a value such as {example}", "{example}のような値"),
    "side_wall_in_the_plane": ("3 for a wall at the side, {name}", "側面の壁（{name}）があるときは3"),
    "contact": ("Contact", "接触の法則（contact）"),
    "dimensions": ("Dimensions", "次元（dimensions）"),
    "coulomb_in_space": ("'coulomb' in space", "三次元では'coulomb'"),
    "of_a_body": ("for what is no lone Body made by its section", "断面で作った単独のBody以外"),
    "room_of_a_scene": ("beside a Scene, which has its own", "部屋を含むScene"),
    # Quick estimates
    "tie_height": ("Height of the tie", "取付け高さ"),
    "peak_acceleration": ("Peak acceleration", "最大加速度"),
    "vertical_peak": ("Peak vertical acceleration", "鉛直方向の最大加速度"),
    "peak_velocity": ("Peak velocity", "最大速度"),
    "equivalent_frequency": ("Equivalent frequency", "等価振動数"),
    "file_to_write": ("The file to write", "書き込むファイル"),
    # Files
    "wrong_suffix": ("a file that ends in {suffixes}", "拡張子が{suffixes}のファイル"),
    "null_in_name": ("a name without null characters", "ヌル文字を含まないファイル名"),
    "no_folder": ("in a folder that exists", "存在するフォルダーの中のファイル"),
    "file_is_folder": ("a file, and no folder", "フォルダーではなくファイル"),
    "file_is_input": ("another file than {source}, which is read", "読み込む{source}とは別のファイル"),
    "without_ffmpeg": ("one in .gif or .html: an MP4 needs ffmpeg, which is not installed",
                       "MP4に必要なffmpegがインストールされていないため、.gifか.htmlのファイル"),
    # Optional libraries
    "not_installed": (("{what} needs {module}, which is not installed; pip install '.[{extra}]' in a "
                       "checkout of stayput installs it."),
                      ("{what}には{module}が必要ですが、インストールされていません。"
                       "stayputのソースのフォルダーで pip install '.[{extra}]' を実行してください。")),
}
