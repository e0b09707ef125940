"""The classes of JMA's intensity in plain words: what people meet, and what furniture does.

Abridged from the Japan Meteorological Agency's explanation of its scale (気象庁震度階級関連解説表, 2009).
"""

from __future__ import annotations

LABELS_JA = {"5-lower": "5弱", "5-upper": "5強", "6-lower": "6弱", "6-upper": "6強"}
"""Names of the classes in Japanese, where they differ."""

PEOPLE: dict[str, tuple[str, str]] = {
    "0": ("Nobody notices; only instruments do.", "人は気づかず、計器だけが感じる。"),
    "1": ("A few people who sit quietly indoors notice.", "屋内で静かにしている人の一部が気づく。"),
    "2": (
        "Most people who sit quietly indoors notice, and some sleepers wake.",
        "屋内で静かにしている人の大半が気づき、眠っている人の一部が目を覚ます。",
    ),
    "3": (
        "Almost all people indoors notice, as do some who walk; most sleepers wake.",
        "屋内のほとんどの人と歩いている人の一部が気づく。眠っている人の大半が目を覚ます。",
    ),
    "4": (
        "Almost all people are startled; those who walk notice, and sleepers wake.",
        "ほとんどの人が驚く。歩いている人も気づき、眠っている人は目を覚ます。",
    ),
    "5-lower": (
        "Most people are frightened and reach for something to hold on to.",
        "大半の人が怖いと感じ、物につかまりたくなる。",
    ),
    "5-upper": (
        "Most people find it hard to walk without holding on to something.",
        "大半の人が、物につかまらないと歩きにくい。",
    ),
    "6-lower": ("Standing is hard.", "立っているのが難しい。"),
    "6-upper": (
        "Nobody can stand; people crawl, and may be thrown off their feet.",
        "立っていられず、はって動くしかない。体が投げ出されることもある。",
    ),
    "7": (
        "Nobody can stand or move as they wish; people may be thrown.",
        "思うように動けず、体が投げ出されることもある。",
    ),
}
"""What people meet, in English and Japanese."""

ON_FURNITURE: dict[str, tuple[str, str]] = {
    "0": ("Nothing moves.", "何も動かない。"),
    "1": ("Nothing moves.", "何も動かない。"),
    "2": ("Hanging lamps may sway a little.", "つり下げた照明がわずかに揺れることがある。"),
    "3": ("Dishes in a cupboard may rattle.", "棚の食器が音を立てることがある。"),
    "4": (
        "Lamps swing, dishes rattle; an unsteady ornament may fall.",
        "照明が大きく揺れ、食器が鳴る。座りの悪い置物が倒れることがある。",
    ),
    "5-lower": (
        "Books and dishes may drop from shelves; unfixed furniture may shift, what is unsteady may fall.",
        "棚の本や食器が落ちることがある。固定していない家具がずれ、不安定なものは倒れることがある。",
    ),
    "5-upper": (
        "Many books and dishes drop; a television may come off its stand, unfixed furniture may overturn.",
        "本や食器の多くが落ちる。テレビが台から落ちたり、固定していない家具が倒れたりすることがある。",
    ),
    "6-lower": (
        "Most unfixed furniture shifts and some overturns; doors may no longer open.",
        "固定していない家具の大半がずれ、倒れるものもある。扉が開かなくなることがある。",
    ),
    "6-upper": (
        "Almost all unfixed furniture shifts, and much of it overturns.",
        "固定していない家具のほとんどがずれ、倒れるものが多い。",
    ),
    "7": (
        "Almost all unfixed furniture shifts or overturns, and some is thrown.",
        "固定していない家具のほとんどがずれたり倒れたりし、飛ぶこともある。",
    ),
}
"""What it does to furniture, in English and Japanese."""
