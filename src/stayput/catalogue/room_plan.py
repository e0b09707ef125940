"""Texts of the editor of a room's plan; its script fills in what stands in braces."""

SHARED = (
    "room_report.is_blocked",
    "room_report.is_hit",
    "room_report.overturns",
    "rooms.far_side_wall",
    "rooms.left_wall",
    "rooms.near_side_wall",
    "rooms.right_wall",
)
"""Texts of other modules that the editor says too; their keys there are their keys on the page."""

TEXTS: dict[str, tuple[str, str]] = {
    "roomPlan": ("The room", "部屋"),
    "door": ("Door", "ドア"),
    "window": ("Window", "窓"),
    # Palette
    "paletteFurniture": ("Furniture", "家具"),
    "palettePlaces": ("Places of people", "人のいる場所"),
    "paletteOpenings": ("Doors and windows", "ドアと窓"),
    # Plan
    "planAlt": (
        "Plan to scale of a room {width} wide and {length} long: {content}",
        "幅{width}、奥行き{length}の部屋の平面図（縮尺どおり）：{content}",
    ),
    "planEdited": (
        "Plan of a room {width} wide and {length} long, to be edited",
        "幅{width}、奥行き{length}の部屋の平面図（編集できます）",
    ),
    "planHelp": ("How to edit the plan", "平面図の編集のしかた"),
    "planKeys": (
        (
            "Drag things with the mouse or a finger; near a wall a piece turns its back to it. Pull the round handles to "
            "change a size or to turn it; with Alt held down nothing snaps. With the keyboard: Tab goes from thing to thing, the "
            "arrows move by 5 cm, with Shift by 1 cm, R turns by 90°, D makes another of the same, Delete removes, "
            "Enter goes to its numbers and Escape back, Escape gives up a drag, Ctrl+Z takes a change back and Ctrl+Y makes it again."
        ),
        (
            "マウスや指で動かせます。家具は壁に近づけると背を壁に向けて付きます。丸い印を引くと大きさや向きが変わります。"
            "〔Alt〕キーを押している間は壁や辺に吸着しません。キーボードでは、〔Tab〕で次へ移り、矢印で5 cm（〔Shift〕と一緒に1 cm）ずつ動かし、"
            "〔R〕で90°回し、〔D〕で同じものを増やし、〔Delete〕で取り除きます。"
            "〔Enter〕で数値の欄に移り、〔Esc〕で戻ります。〔Esc〕でドラッグをやめ、〔Ctrl+Z〕で元に戻し、〔Ctrl+Y〕でやり直します。"
        ),
    ),
    "pullToSize": ("Pull to change the size", "引いて大きさを変える"),
    "pullToTurn": ("Pull to turn", "引いて向きを変える"),
    "undoIt": ("Undo", "元に戻す"),
    "redoIt": ("Redo", "やり直す"),
    "turnIt": ("Turn by 90°", "90°回す"),
    "removeIt": ("Remove", "取り除く"),
    "emptyIt": ("Empty room", "部屋を空にする"),
    "emptied": (
        "The room is empty. Undo brings everything back.",
        "部屋を空にしました。「元に戻す」ですべて戻ります。",
    ),
    "undone": ("The last change is taken back.", "直前の変更を元に戻しました。"),
    "redone": ("The change is made again.", "変更をやり直しました。"),
    "added": ("Added: {what}", "追加：{what}"),
    "removed": ("Removed: {name}", "取り除いたもの：{name}"),
    "layer_fell": ("Where pieces fall", "倒れる範囲"),
    "layer_stood": ("Where they slide to", "滑って止まる範囲"),
    "layer_hit": ("Who is hit", "人に当たる確率"),
    "layer_blocked": ("Blocked doors", "ふさがるドア"),
    "layersHint": (
        "Plain cells: where it lies overturned; chequered ones: where it stands. The stronger the colour, the more often.",
        "塗りは倒れている範囲、市松模様は立ったまま止まる範囲です。濃いほど多く起こります。",
    ),
    # Where something is
    "metresLong": ("{value} m", "{value} m"),
    "atWall": ("at the {wall}", "{wall}に背を付けて"),
    "inTheWall": ("in the {wall}", "{wall}"),
    "fromWall": ("{distance} from the {wall}", "{wall}から{distance}"),
    "fromTo": ("from {start} to {end}", "{start}から{end}まで"),
    "facesTo": ("facing the {wall}", "{wall}向き"),
    "headTo": ("head towards the {wall}", "頭は{wall}の側"),
    "turnedBy": ("turned by {angle}°", "{angle}°回転"),
    "standsOn": ("on the {name}", "「{name}」の上"),
    "opens_inwards": ("opens inwards", "内開き"),
    "opens_outwards": ("opens outwards", "外開き"),
    "opens_sliding": ("slides", "引き戸"),
    # What stands wrong
    "inWall": ("{name} reaches {depth} into a wall.", "「{name}」が壁に{depth}入り込んでいます。"),
    "inOther": (
        "{name} and {other} stand {depth} in each other.",
        "「{name}」と「{other}」が{depth}重なっています。",
    ),
    "opensAgainst": (
        "{name} does not open fully: {other} is in its way.",
        "「{name}」が「{other}」に当たり、全開できません。",
    ),
    "noFurniture": (
        "The room is empty; put at least one piece of furniture into it.",
        "部屋に家具がありません。1つ以上置いてください。",
    ),
    # What is selected
    "inspector": ("What is selected", "選んだもの"),
    "selectHint": (
        "Select something on the plan to see its numbers.",
        "平面図で選ぶと、その数値を変えられます。",
    ),
    "roomSize": ("Size of the room", "部屋の大きさ"),
    "roomWidth": ("From the left to the right wall", "左の壁から右の壁まで"),
    "roomLength": ("From the near to the far wall", "手前の壁から奥の壁まで"),
    "name": ("Name", "名前"),
    "nameEmpty": ("A name must be given.", "名前を入力してください。"),
    "nameTaken": (
        "{name} is the name of something else; each must have a name of its own.",
        "「{name}」はほかで使われています。それぞれに異なる名前を付けてください。",
    ),
    "standsAt": ("Stands with its back to", "背を付ける壁"),
    "freely": ("no wall", "壁に付けない"),
    "alongWall": (
        "Its middle along that wall, from the near or left end",
        "壁の手前または左の端から中心まで",
    ),
    "fromLeft": ("Its middle from the left wall", "左の壁から中心まで"),
    "fromNear": ("Its middle from the near wall", "手前の壁から中心まで"),
    "turnedDegrees": ("Turned by", "向き"),
    "pieceDepth": ("Depth, back to front", "奥行き"),
    "pieceLength": ("Length, side to side", "幅"),
    "filling": ("What is in it", "中身"),
    "filling_full": ("full", "いっぱい"),
    "filling_empty": ("empty", "空"),
    "needsItsWall": ("Only for a piece with its back to a wall.", "背を壁に付けた家具だけに使えます。"),
    "needsItsCeiling": (
        "Only under a ceiling that is higher than the piece.",
        "家具より高い天井がある場合だけに使えます。",
    ),
    "placeWidth": ("Width", "幅"),
    "placeLength": ("Length", "長さ"),
    "personLow": ("The person is from this height", "人がいる高さ（下端）"),
    "personHigh": ("up to this height", "人がいる高さ（上端）"),
    "byDay": ("Share of the day with somebody there", "昼に人がいる割合"),
    "atNight": ("Share of the night with somebody there", "夜に人がいる割合"),
    "inWhichWall": ("In which wall", "どの壁か"),
    "startsAt": ("Begins along the wall, from its near or left end", "壁の手前または左の端から始まりまで"),
    "clearWidth": ("Clear width", "幅（有効）"),
    "howOpens": ("How it opens", "開き方"),
    "hingeAt": ("Hinge", "ちょうつがい"),
    "hinge_start": ("where it begins", "始まりの側"),
    "hinge_end": ("where it ends", "終わりの側"),
    "wayOut": ("It leads out", "外への避難経路になる"),
    "sill": ("Sill above the floor", "床から窓の下端まで"),
    "doubleIt": ("Another of the same", "同じものを追加"),
}
"""Texts by their keys: English, Japanese."""
