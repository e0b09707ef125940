"""Bodies, rooms, cases, what is not known, and a run of them."""

TEXTS: dict[str, tuple[str, str]] = {
    # Parts of the labels of fields, and what other numbers are called
    "load_width": ("load_width", "棚の荷物の奥行き（load_width）"),
    "static_friction": ("{surface} static friction", "{surface}の静止摩擦係数"),
    "kinetic_friction": ("{surface} kinetic friction", "{surface}の動摩擦係数"),
    "field_of": ("“{owner}” {name}", "「{owner}」の{name}"),
    # Bodies
    "cg_outside": (
        (
            "Body cg_offset is ({x:g}, {z:g}) m; the centre of gravity must lie inside the section, "
            "so below {half_width:g} m sideways and {half_height:g} m upwards in size."
        ),
        (
            "重心のずれ（cg_offset）が ({x:g}, {z:g}) mになっています。重心は断面の内側になければなりません。"
            "横は{half_width:g} m未満、縦は{half_height:g} m未満にしてください。"
        ),
    ),
    "cg_beside_base": (
        (
            "With base_insets {insets} the base of the body of {width:g} m does not carry its centre of gravity, "
            "{x:g} m right of the middle; use smaller insets."
        ),
        (
            "base_insets が{insets}のとき、幅{width:g} mの家具の底面は中央から{x:g} m右の重心を支えられません。"
            "より小さい値を指定してください。"
        ),
    ),
    "not_of_its_shape": (
        "{name} follows from the shape of the body; make another body with Body.hull, .box, .cylinder or .mesh.",
        "{name}は立体の形から決まります。Body.hull、.box、.cylinder、.meshで別のBodyを作ってください。",
    ),
    "another_shape": (
        "The body has a shape of its own; here it must be made by its section: Body(width, height, mass).",
        "Bodyに立体の形が指定されています。ここでは断面で作ってください：Body(width, height, mass)。",
    ),
    "no_mass": (
        "The parts' total mass is {mass:g} kg; it must be more than 0 kg.",
        "部分の質量の合計が{mass:g} kgになっています。0 kgより大きくしてください。",
    ),
    "no_shelves": (
        "The bookcase has no shelves; loads must list at least one load [kg].",
        "本棚に棚がありません。棚の荷重（loads）[kg] を1つ以上指定してください。",
    ),
    # Rooms
    "kinetic_above_static": (
        "{surface} kinetic friction is {kinetic:g}; it must not be above the static one, {static:g}.",
        "{surface}の動摩擦係数は{kinetic:g}です。静止摩擦係数（{static:g}）以下にしてください。",
    ),
    "surface": ("Floor surface", "床の種類"),
    # The start of a run
    "laid_down": (
        (
            "The body is tilted by {tilt:.5g}° at the start, {rest:.5g}° of it at rest; "
            "it must be less than 90° to either side."
        ),
        "家具が最初から{tilt:.5g}°傾いています（うち静止時の傾き{rest:.5g}°）。左右とも90°未満にしてください。",
    ),
    "inside": (
        "The body stands {depth:g} m inside {place} at the start; it must be clear of it.",
        "家具が最初から{place}に{depth:g} mめり込んでいます。離して置いてください。",
    ),
    "right_wall": ("the wall in front", "前方の壁"),
    "left_wall": ("the wall behind", "背後の壁"),
    "ceiling": ("the ceiling", "天井"),
    "part_of_room": (
        "{name} is {value}; it must be of type {wanted}, such as {example}.",
        "{name}が{value}になっています。{example}のような{wanted}型の値を指定してください。",
    ),
    "side_wall_in_the_plane": (
        "{name} is a wall at the side of the piece, which the plane does not have; {other} must be 3.",
        "{name}は家具の側面の壁で、平面の計算にはありません。{other}を3にしてください。",
    ),
    "contact": ("Contact", "接触の法則（contact）"),
    "dimensions": ("Dimensions", "次元（dimensions）"),
    "paper_in_space": (
        "The paper's contact law is one of the plane; in space it must be 'coulomb'.",
        "論文の接触の法則は平面だけのものです。三次元では'coulomb'を指定してください。",
    ),
    "of_a_body": (
        "{name} is of a Body by itself that is made by its section; here it must be left out.",
        "{name}は、断面で作ったBodyを単独で計算するときだけに指定できます。ここでは省いてください。",
    ),
    "room_of_a_scene": (
        "{name} is given beside a scene, which has its own; it must be left out: simulate(scene, motion).",
        "{name}が指定されていますが、Sceneには部屋が含まれています。simulate(scene, motion)のように省いてください。",
    ),
    # Quick estimates
    "tie_height": ("Height of the tie", "取付け高さ"),
    "peak_acceleration": ("Peak acceleration", "最大加速度"),
    "peak_velocity": ("Peak velocity", "最大速度"),
    "equivalent_frequency": ("Equivalent frequency", "等価振動数"),
    "not_positive": (
        "{name} is {value:g}{unit}; it must be larger than 0.",
        "{name}が{value:g}{unit}になっています。0より大きくしてください。",
    ),
    # Files
    "wrong_suffix": (
        "The file to write is {file}; its name must end in {suffixes}.",
        "書き込むファイルが{file}になっています。拡張子は{suffixes}にしてください。",
    ),
    "null_in_name": (
        "The file to write is {file}; its name must be without null characters.",
        "書き込むファイルが{file}になっています。ヌル文字を含まないファイル名を指定してください。",
    ),
    "no_folder": (
        "The file to write is {file}; its folder must exist.",
        "書き込むファイル{file}のフォルダーがありません。先に作成してください。",
    ),
    "file_is_folder": (
        "The file to write is {file}; it must be a file, and that is a folder.",
        "書き込むファイル{file}はフォルダーです。ファイルを指定してください。",
    ),
    "file_is_input": (
        "The file to write is {file}; it must be another one than {source}, which is read.",
        "書き込むファイルが{file}になっていますが、読み込むファイル{source}と同じです。別のファイルを指定してください。",
    ),
    "not_written": (
        "The file to write is {file}; it could not be written: {reason}.",
        "ファイル{file}に書き込めませんでした（{reason}）。",
    ),
    "folder_not_written": (
        "The folder to write is {folder}; its files could not be written: {reason}.",
        "フォルダー{folder}にファイルを書き込めませんでした（{reason}）。",
    ),
    "no_ffmpeg": (
        (
            "The file to write is {file}; an MP4 needs the program ffmpeg, which is not installed, "
            "so install it or choose .gif or .html."
        ),
        (
            "書き込むファイルは{file}ですが、MP4に必要なffmpegがインストールされていません。"
            "ffmpegをインストールするか、.gifか.htmlを選んでください。"
        ),
    ),
    # Optional libraries
    "not_installed": (
        (
            "{what} needs {module}, which is not installed; pip install '.[{extra}]' in a checkout of stayput "
            "installs it."
        ),
        (
            "{what}には{module}が必要ですが、インストールされていません。stayputのソースのフォルダーで "
            "pip install '.[{extra}]' を実行してください。"
        ),
    ),
}
"""Texts by their keys: English, Japanese."""
