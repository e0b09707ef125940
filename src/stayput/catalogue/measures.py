"""Measures: why one cannot be put in place. What they are called stands beside their parameters."""

TEXTS: dict[str, tuple[str, str]] = {
    "own_class": (
        "{name} has no kind or no label; a measure's kind must be a text, its label two: English and Japanese.",
        "自作の対策{name}に、種類（kind）または名称（label）がありません。kindは文字列、labelは英語と日本語の2つの文字列にしてください。",
    ),
    "twice": (
        "{measure} is given twice, both {place}; only one of them can be there.",
        "「{measure}」が2回指定されています。同じ場所（{place}）に使えるのは1つだけです。",
    ),
    "same_place": (
        "{first} and {second} are given together, both {place}; only one of them can be there.",
        "「{first}」と「{second}」は同じ場所（{place}）に取り付けるため、どちらか1つしか使えません。",
    ),
    "room_of_several": (
        "{measure} cannot be given to one piece of several; say where it stands by its place (at) instead.",
        "「{measure}」は複数の家具のうちの1つには使えません。位置（at）で置き場所を指定してください。",
    ),
    "base_on_another": (
        "{measure} belong on the floor, and the piece stands {height:g} m above it; join it to the one below.",
        "「{measure}」は床に使うものですが、家具は床から{height:g} mの高さにあります。下の家具と接合してください。",
    ),
    # Places that a measure takes up
    "under_base": ("under the base", "底面の下"),
    "on_wall": ("on the wall at {height:g} times the height", "家具の高さの{height:g}倍の位置の壁"),
    "at_distance": ("at a distance from the wall", "壁から離した位置"),
    "tied": ("tied to the wall at {height:g} times the height", "家具の高さの{height:g}倍の位置と壁との間"),
    "on_top": ("on the top, {setback:g} m from the back", "天板の上、背面から{setback:g} mの位置"),
    "on_shelves": ("on the shelves", "棚の上"),
    # What gives way; the links of a chain say it beside their numbers
    "as_given": ("they reach the strength that is given for them", "指定された強さに達する"),
    "mats_peel": ("the mats peel off", "マットがはがれる"),
    "mats_shear": ("the mats shear off", "マットがずれてはがれる"),
    "drops_out": ("the poles lose their hold and drop out", "ポールが緩んで外れる"),
    # How a measure is often installed
    "beside_the_studs": (
        "screws beside the studs, in plasterboard",
        "ねじが下地を外れて石こうボードだけに留まる",
    ),
    "hangs_loose": ("hangs loose", "たるませたまま取り付ける"),
    "hardly_tightened": ("hardly tightened", "締付けが足りない"),
    "on_dust": ("on dust or an uneven floor", "ほこりや凹凸のある床に貼る"),
    "too_short": ("too short, with its thin part under the edge", "短く、薄い部分だけが挟まる"),
    # Why a measure may not do much here
    "in_plasterboard": (
        (
            "{measure} are fixed to plasterboard alone, which holds less than a stud and lets go without warning; "
            "look for the studs"
        ),
        (
            "「{measure}」を下地のない石こうボードに留めています。下地より弱く、前触れなく抜けるので、"
            "下地を探してください"
        ),
    ),
    "pole_on_board": (
        (
            "{measure} push against plasterboard between the joists, which they break; put a board between, "
            "or move them under a joist"
        ),
        "「{measure}」が野縁のない石こうボードを押しています。突き破るので、当て板をするか野縁の下に移してください",
    ),
    "pole_long": (
        "{measure} are longer than {most:g} m and lean at a small force",
        "「{measure}」が{most:g} mより長く、小さな力で傾きます",
    ),
    "glides_stick": (
        "“{measure}” slides like this on hard floors; on a soft one it sinks in and slides less easily",
        "「{measure}」のすべりやすさは硬い床での値です。柔らかい床では沈み込み、滑りにくくなります",
    ),
    "locks_slip": (
        (
            "“{measure}” may roll or slip all the same: in shake-table tests locking did not always lessen how far "
            "equipment moved"
        ),
        (
            "「{measure}」はロックしても転がったり滑ったりすることがあります"
            "（振動台実験では、ロックしても移動量が必ずしも減っていません）"
        ),
    ),
    "rubber_slips": (
        "“{measure}” grips like this on hard, clean floors; on a soft one it slips with the pile or the weave",
        "「{measure}」の摩擦は硬くきれいな床での値です。柔らかい床では毛足や畳の目に沿って滑ります",
    ),
    "wedge_sinks": (
        "“{measure}” sinks into a soft floor, and leans the piece less",
        "「{measure}」は柔らかい床では沈み込み、傾きが小さくなります",
    ),
    "wedge_squat": (
        (
            "{measure}: on its own base this piece slides before it tips (width/height {slender:.2f}, friction "
            "{friction:.2f}); the rubber stops the sliding and may tip it"
        ),
        (
            "「{measure}」なしでは転倒する前に滑る家具です（奥行き／高さ{slender:.2f}、摩擦{friction:.2f}）。"
            "ゴムで滑りが止まり、かえって転倒することがあります"
        ),
    ),
    # Measures whose numbers do not go with the piece, the room or each other
    "no_wall": (
        "There is no wall behind the piece; for “{measure}” the room must have a back_wall.",
        "「{measure}」には背面の壁が必要です。",
    ),
    "too_far": (
        "The gap to the wall is {gap:g} m; for “{measure}” it must be at most {most:g} m.",
        "家具と壁のすき間が{gap:g} mあります。「{measure}」を使うには{most:g} m以下にしてください。",
    ),
    "no_ceiling": (
        "{measure} need a ceiling; the room must have one, or ceiling_height be given.",
        "「{measure}」には天井が必要です。天井の高さを指定してください。",
    ),
    "dropped_ceiling": (
        "{measure} need a ceiling that bears them; a dropped ceiling lifts. Give strength if it is known.",
        "「{measure}」には力に耐える天井が必要です。吊り天井は持ち上がります。強さが分かる場合は指定してください。",
    ),
    "does_not_stick": (
        "{measure} do not stick to carpet or tatami; the floor must be hard and smooth.",
        "「{measure}」はカーペットや畳には粘着しません。硬く平らな床で使ってください。",
    ),
    "anchor": (
        (
            "“{measure}” angle is {angle:.3g} rad, which puts its anchor at {height:.3g} m; "
            "it must be between floor and ceiling."
        ),
        "「{measure}」の壁側の取付け位置が高さ{height:.3g} mになります。床と天井の間になる角度にしてください。",
    ),
    "preload": (
        "“{measure}” preload is {preload:g} N; it must be below the ceiling's strength, {strength:g} N.",
        "「{measure}」の突っ張り力は{preload:g} Nです。天井の強さ（{strength:g} N）より小さくしてください。",
    ),
    "length": (
        "{measure} have {space:g} m below the ceiling; that must be between {low:g} and {high:g} m.",
        "家具と天井の間が{space:g} mです。「{measure}」を使うには{low:g}～{high:g} mにしてください。",
    ),
    "share": (
        "“{measure}” share is {share:g}; it must be no more than the upper half of this piece holds.",
        (
            "「{measure}」の割合は{share:g}ですが、この家具の上半分にはそれだけの重さがありません。"
            "小さくしてください。"
        ),
    ),
    "kinetic_above_static": (
        "“{measure}” kinetic_friction is {kinetic:g}; it must not be above static_friction, {static:g}.",
        "「{measure}」の動摩擦係数は{kinetic:g}です。静止摩擦係数（{static:g}）以下にしてください。",
    ),
}
"""Texts by their keys: English, Japanese."""
