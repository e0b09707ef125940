"""Names in English and Japanese of what can be chosen and of what happens, one table a kind.

Keyed by the name of a preset or the value of an enumeration.
"""

FURNITURE: dict[str, tuple[str, str]] = {
    "bookcase": ("Bookcase, full", "本棚（本が入った状態）"),
    "empty bookcase": ("Bookcase, empty", "本棚（空）"),
    "wardrobe": ("Wardrobe", "洋服だんす"),
    "cupboard": ("Cupboard", "食器棚"),
    "chest": ("Chest of drawers", "整理だんす"),
    "refrigerator": ("Refrigerator", "冷蔵庫"),
    "television": ("Television", "テレビ"),
    "vending machine": ("Vending machine", "自動販売機"),
    "server rack": ("Server rack", "サーバーラック"),
    "upright piano": ("Upright piano", "アップライトピアノ"),
}
"""Presets of furniture."""

PIECES = {
    preset: (english.partition(",")[0].lower(), japanese.partition("（")[0])
    for preset, (english, japanese) in FURNITURE.items()
}
"""What a preset is called within a sentence."""

ANY_PIECE = ("piece of furniture", "家具")
"""A piece that is no preset."""

PIECES_OF_RUNS = {**PIECES, "piece": ("piece", "家具"), ANY_PIECE[0]: ANY_PIECE}
"""What pieces of a run are called that have no name of their own."""

CONTENTS: dict[str, tuple[str, str]] = {
    "books": ("Books", "本"),
    "files": ("Files", "ファイル"),
    "dishes": ("Dishes", "食器"),
    "bottles": ("Bottles", "瓶"),
    "boxes": ("Boxes", "箱"),
    "pallet loads": ("Pallet loads", "パレットの荷"),
}
"""Presets of contents."""

DOORS: dict[str, tuple[str, str]] = {
    "none": ("none", "なし"),
    "hinged": ("hinged", "開き戸"),
    "hinged, latched": ("hinged, with latches", "開き戸（耐震ラッチ付き）"),
    "sliding": ("sliding", "引き戸"),
}
"""Kinds of doors, within a sentence."""

DRAWERS: dict[str, tuple[str, str]] = {
    "none": ("none", "なし"),
    "free": ("without stops", "ストッパーなし"),
    "stops": ("with stops", "ストッパー付き"),
    "catches": ("with stops and catches", "ストッパーと留め具付き"),
}
"""Kinds of drawers, within a sentence."""

SURFACES: dict[str, tuple[str, str]] = {
    "wood flooring": ("Wood flooring", "フローリング"),
    "vinyl": ("Vinyl", "ビニル床"),
    "tatami, along the weave": ("Tatami, along the weave", "畳（目に沿う方向）"),
    "tatami, across the weave": ("Tatami, across the weave", "畳（目に直交する方向）"),
    "carpet": ("Carpet", "カーペット"),
    "felt on wood": ("Felt pads on wood", "フェルト（木の床）"),
    "PTFE glide": ("Sliding glides (PTFE)", "すべり材（フッ素樹脂）"),
    "rubber pad": ("Rubber pads", "ゴム"),
    "free caster, hard floor": ("Free casters on a hard floor", "キャスター（ロックなし、硬い床）"),
    "free caster, carpet": ("Free casters on carpet", "キャスター（ロックなし、カーペット）"),
    "locked caster": ("Locked casters", "キャスター（ロックあり）"),
}
"""Presets of surfaces."""

STRUCTURES: dict[str, tuple[str, str]] = {
    "RC": ("Reinforced concrete", "鉄筋コンクリート造"),
    "steel": ("Steel", "鉄骨造"),
    "wood": ("Wood", "木造"),
    "base-isolated": ("Base-isolated", "免震構造"),
}
"""Structures of buildings."""

FAMILIES: dict[str, tuple[tuple[str, str], tuple[str, str]]] = {
    "mixed": (("Mixed", "いろいろな地震"),
              ("all kinds of earthquake that furniture in Japan may meet",
               "日本の家具が遭いうるさまざまな地震")),
    "near-fault": (("Right above the fault", "直下型地震"),
                   (("a shallow earthquake next to its fault, in the manner of Kobe in 1995: short, with a "
                     "strong push"),
                    "断層のすぐ近くの浅い地震（1995年の神戸のような揺れ）。短く、強いパルス状の揺れが来る")),
    "crustal": (("In the crust, some way off", "内陸の地殻内地震"),
                ("a shallow earthquake some tens of kilometres away", "数十キロ離れた浅い地震")),
    "subduction": (("At the plate boundary", "海溝型の巨大地震"),
                   (("a great earthquake, in the manner of Tohoku in 2011: minutes of shaking, in one or "
                     "more bursts"),
                    "巨大地震（2011年の東北のような揺れ）。何分も続き、強い揺れが何度か来ることもある")),
    "basin": (("Long-period, in a basin", "平野の長周期地震動"),
              ("a great earthquake far away, felt in a deep basin as slow swaying",
               "遠くの巨大地震が深い平野でゆっくりした長い揺れになる")),
}
"""Families of earthquakes: what they are called, and what they are."""

MOTIONS: dict[str, tuple[str, str]] = {
    "long-period basin": FAMILIES["basin"][0],
    "synthetic near-fault motion": ("Near-fault, synthetic", "断層近傍の模擬地震動"),
    "sine": ("Sine", "正弦波"),
    "Mavroeidis-Papageorgiou pulse and a random band, fixed seed; not a recorded earthquake": (
        "Mavroeidis-Papageorgiou pulse and a random band, fixed seed; not a recorded earthquake",
        "Mavroeidis・Papageorgiouのパルスと乱数による波（種は固定）。観測記録ではありません",
    ),
    "rare": ("Rare", "稀に発生する地震動"),
    "very rare": ("Very rare", "極めて稀に発生する地震動"),
}
"""Synthetic motions and targets, by what their names say."""

PLACES: dict[str, tuple[str, str]] = {
    "front": ("front", "前面側"),
    "back": ("back", "背面側"),
    "left": ("left", "左"),
    "right": ("right", "右"),
    "stops": ("stops", "ストッパー"),
    "spring": ("spring", "復元ばね"),
}
"""Places of devices on a piece, which may be said together: "front left"."""

MODES: dict[str, tuple[str, str]] = {
    "rest": ("stands still", "静止"),
    "slide": ("slides", "滑り"),
    "rock": ("rocks", "ロッキング"),
    "slide-rock": ("slides and rocks", "滑りながらロッキング"),
    "flight": ("is off the floor", "床から離れる"),
    "lean": ("leans", "寄りかかり"),
    "overturned": ("overturned", "転倒"),
}
"""How a body moves."""

STABILITY: dict[str, tuple[str, str]] = {
    "stays": ("stays put", "動かない"),
    "moves": ("moves", "動く"),
    "may_fall": ("may fall", "倒れることがある"),
    "falls": ("falls", "倒れる"),
}
"""How firmly a piece stands."""

OUTCOMES: dict[str, tuple[str, str]] = {
    "rested": ("stayed put", "動かない"),
    "slid": ("slid", "滑った"),
    "rocked": ("rocked", "揺れ動いた"),
    "leaning": ("left leaning", "寄りかかったまま"),
    "overturned": ("overturned", "転倒"),
    "failed": ("could not be followed", "計算できず"),
    "fell off": ("fell off", "落下"),
    "rolled": ("rolled", "転がった"),
}
"""What became of a body."""

EVENTS: dict[str, tuple[str, str]] = {
    "slip": ("starts to slide", "滑り始め"),
    "stick": ("stops sliding", "滑り止まり"),
    "uplift": ("lifts an edge", "浮き上がり"),
    "floor impact": ("lands on the floor", "床に着地"),
    "wall impact": ("hits a wall", "壁に衝突"),
    "ceiling impact": ("hits the ceiling", "天井に衝突"),
    "lift-off": ("leaves the floor", "床から離れる"),
    "wall release": ("leaves the wall", "壁から離れる"),
    "rest": ("comes to rest", "静止"),
    "overturned": ("overturns", "転倒"),
    "failed": ("could not be followed", "計算打ち切り"),
    "device failure": ("a device fails", "器具が破損または脱落"),
}
"""What happens at an event."""

INTENSITIES: dict[str, tuple[str, str]] = {
    "0": ("0", "震度0"),
    "1": ("1", "震度1"),
    "2": ("2", "震度2"),
    "3": ("3", "震度3"),
    "4": ("4", "震度4"),
    "5-lower": ("5-lower", "震度5弱"),
    "5-upper": ("5-upper", "震度5強"),
    "6-lower": ("6-lower", "震度6弱"),
    "6-upper": ("6-upper", "震度6強"),
    "7": ("7", "震度7"),
}
"""Classes of JMA's intensity."""

PEOPLE: dict[str, tuple[str, str]] = {
    "0": ("Nobody notices; only instruments do.", "人は気づかず、計器だけが感じる。"),
    "1": ("A few people who sit quietly indoors notice.", "屋内で静かにしている人の一部が気づく。"),
    "2": ("Most people who sit quietly indoors notice, and some sleepers wake.",
          "屋内で静かにしている人の大半が気づき、眠っている人の一部が目を覚ます。"),
    "3": ("Almost all people indoors notice, as do some who walk; most sleepers wake.",
          "屋内のほとんどの人と歩いている人の一部が気づく。眠っている人の大半が目を覚ます。"),
    "4": ("Almost all people are startled; those who walk notice, and sleepers wake.",
          "ほとんどの人が驚く。歩いている人も気づき、眠っている人は目を覚ます。"),
    "5-lower": ("Most people are frightened and reach for something to hold on to.",
                "大半の人が怖いと感じ、物につかまりたくなる。"),
    "5-upper": ("Most people find it hard to walk without holding on to something.",
                "大半の人が、物につかまらないと歩きにくい。"),
    "6-lower": ("Standing is hard.", "立っているのが難しい。"),
    "6-upper": ("Nobody can stand; people crawl, and may be thrown off their feet.",
                "立っていられず、はって動くしかない。体が投げ出されることもある。"),
    "7": ("Nobody can stand or move as they wish; people may be thrown.",
          "思うように動けず、体が投げ出されることもある。"),
}
"""What people meet in a class of JMA's intensity.

Abridged, as the next table, from the Japan Meteorological Agency's explanation of its scale
(気象庁震度階級関連解説表, 2009).
"""

ON_FURNITURE: dict[str, tuple[str, str]] = {
    "0": ("Nothing moves.", "何も動かない。"),
    "1": ("Nothing moves.", "何も動かない。"),
    "2": ("Hanging lamps may sway a little.", "つり下げた照明がわずかに揺れることがある。"),
    "3": ("Dishes in a cupboard may rattle.", "棚の食器が音を立てることがある。"),
    "4": ("Lamps swing, dishes rattle; an unsteady ornament may fall.",
          "照明が大きく揺れ、食器が鳴る。座りの悪い置物が倒れることがある。"),
    "5-lower": (("Books and dishes may drop from shelves; unfixed furniture may shift, what is unsteady "
                 "may fall."),
                "棚の本や食器が落ちることがある。固定していない家具がずれ、不安定なものは倒れることがある。"),
    "5-upper": (("Many books and dishes drop; a television may come off its stand, unfixed furniture may "
                 "overturn."),
                ("本や食器の多くが落ちる。テレビが台から落ちたり、"
                 "固定していない家具が倒れたりすることがある。")),
    "6-lower": ("Most unfixed furniture shifts and some overturns; doors may no longer open.",
                "固定していない家具の大半がずれ、倒れるものもある。扉が開かなくなることがある。"),
    "6-upper": ("Almost all unfixed furniture shifts, and much of it overturns.",
                "固定していない家具のほとんどがずれ、倒れるものが多い。"),
    "7": ("Almost all unfixed furniture shifts or overturns, and some is thrown.",
          "固定していない家具のほとんどがずれたり倒れたりし、飛ぶこともある。"),
}
"""What a class of JMA's intensity does to furniture."""
