"""Names of what can be chosen, in English and Japanese."""

from __future__ import annotations

from stayput.simulation import EventKind, Mode, Outcome

FURNITURE = {
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
    "bookcase": ("bookcase", "本棚"),
    "empty bookcase": ("bookcase", "本棚"),
    "wardrobe": ("wardrobe", "洋服だんす"),
    "cupboard": ("cupboard", "食器棚"),
    "chest": ("chest of drawers", "整理だんす"),
    "refrigerator": ("refrigerator", "冷蔵庫"),
    "television": ("television", "テレビ"),
    "vending machine": ("vending machine", "自動販売機"),
    "server rack": ("server rack", "サーバーラック"),
    "upright piano": ("piano", "ピアノ"),
}
"""What a preset is called within a sentence."""

ANY_PIECE = ("piece of furniture", "家具")
"""A piece that is no preset."""

SURFACES = {
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

STRUCTURES = {
    "RC": ("Reinforced concrete", "鉄筋コンクリート造"),
    "steel": ("Steel", "鉄骨造"),
    "wood": ("Wood", "木造"),
    "base-isolated": ("Base-isolated", "免震構造"),
}
"""Structures of buildings."""

FAMILIES = {
    "mixed": (
        ("Mixed", "いろいろな地震"),
        ("all kinds of earthquake that furniture in Japan may meet", "日本の家具が遭いうるさまざまな地震"),
    ),
    "near-fault": (
        ("Right above the fault", "直下型地震"),
        (
            "a shallow earthquake next to its fault: short, with a strong push",
            "断層のすぐ近くの浅い地震。短く、強いパルス状の揺れが来る",
        ),
    ),
    "crustal": (
        ("In the crust, some way off", "内陸の地殻内地震"),
        (
            "a shallow earthquake some tens of kilometres away",
            "数十キロ離れた浅い地震",
        ),
    ),
    "subduction": (
        ("At the plate boundary", "海溝型の巨大地震"),
        (
            "a great earthquake: minutes of shaking, in one or more bursts",
            "巨大地震。何分も続き、強い揺れが何度か来ることもある",
        ),
    ),
    "basin": (
        ("Long-period, in a basin", "長周期地震動（平野）"),
        (
            "a great earthquake far away, felt in a deep basin as slow swaying",
            "遠くの巨大地震が深い平野でゆっくりした長い揺れになる",
        ),
    ),
}
"""Families of earthquakes: what they are called, and what they are."""

MODES = {
    Mode.REST: ("stands still", "静止"),
    Mode.SLIDE: ("slides", "滑り"),
    Mode.ROCK: ("rocks", "ロッキング"),
    Mode.SLIDE_ROCK: ("slides and rocks", "滑りながらロッキング"),
    Mode.FLIGHT: ("is off the floor", "床から離れる"),
    Mode.LEAN: ("leans", "寄りかかり"),
    Mode.OVERTURNED: ("overturned", "転倒"),
}
"""How a body moves."""

OUTCOMES = {
    Outcome.RESTED: ("stayed put", "動かない"),
    Outcome.SLID: ("slid", "滑った"),
    Outcome.ROCKED: ("rocked", "揺れ動いた"),
    Outcome.LEANING: ("left leaning", "寄りかかったまま"),
    Outcome.OVERTURNED: ("overturned", "転倒"),
    Outcome.FAILED: ("could not be followed", "計算できず"),
}
"""What became of a body."""

EVENTS = {
    EventKind.SLIP: ("starts to slide", "滑り始め"),
    EventKind.STICK: ("stops sliding", "滑り止まり"),
    EventKind.UPLIFT: ("lifts an edge", "浮き上がり"),
    EventKind.FLOOR_IMPACT: ("lands on the floor", "床に着地"),
    EventKind.WALL_IMPACT: ("hits a wall", "壁に衝突"),
    EventKind.CEILING_IMPACT: ("hits the ceiling", "天井に衝突"),
    EventKind.LIFT_OFF: ("leaves the floor", "床から離れる"),
    EventKind.WALL_RELEASE: ("leaves the wall", "壁から離れる"),
    EventKind.REST: ("comes to rest", "静止"),
    EventKind.OVERTURNED: ("overturns", "転倒"),
    EventKind.FAILED: ("could not be followed", "計算打ち切り"),
    EventKind.DEVICE_FAILURE: ("a device fails", "器具が破損・脱落"),
}
"""What happens at an event."""
