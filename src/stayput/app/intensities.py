"""The classes of JMA's intensity in plain words: what people meet, and what furniture does.

The words are our own; the classes are those of the Japan Meteorological Agency.
"""

from __future__ import annotations

LABELS_JA = {"5-lower": "5弱", "5-upper": "5強", "6-lower": "6弱", "6-upper": "6強"}
"""Names of the classes in Japanese, where they differ."""

PEOPLE: dict[str, tuple[str, str]] = {
    "0": ("Nobody notices; only instruments do.", "人は気づかず、計器だけが感じる。"),
    "1": ("A few people who sit quietly indoors notice.", "屋内で静かにしている人の一部が気づく。"),
    "2": ("Many people who sit quietly indoors notice.", "屋内で静かにしている人の多くが気づく。"),
    "3": ("Most people indoors notice; it may alarm some.", "屋内のほとんどの人が気づき、驚く人もいる。"),
    "4": (
        "Most people are startled; those who walk notice, and sleepers wake.",
        "ほとんどの人が驚く。歩いていても気づき、眠っている人は目を覚ます。",
    ),
    "5-lower": (
        "Most people are frightened and reach for something to hold on to.",
        "多くの人が怖いと感じ、何かにつかまりたくなる。",
    ),
    "5-upper": (
        "Walking is hard without holding on to something.",
        "何かにつかまらないと歩きにくい。",
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
