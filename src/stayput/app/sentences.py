"""What became of a run, in one plain sentence, English and Japanese."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from stayput.app.fields import Words
from stayput.app.words import ANY_PIECE, PIECES
from stayput.report.summary import sentence
from stayput.simulation import EventKind, Outcome

if TYPE_CHECKING:
    from stayput.scenario.tables import FurnitureTable
    from stayput.simulation import Run


def told(run: Run, furniture: FurnitureTable) -> Words:
    """Return the sentence of a run, and which device failed first."""
    usual = PIECES.get(furniture.preset or "", ANY_PIECE)
    english, japanese = (furniture.name or name for name in usual)
    failed = min((d for d in run.devices if d.failed), key=lambda d: d.failure_time, default=None)
    if failed is None:
        return Words(en=sentence(run, english), ja=_japanese(run, japanese))
    at = failed.failure_time
    return Words(
        en=f"{sentence(run, english)} First to fail: {failed.label[0].lower()}, after {at:.1f} s.",
        ja=f"{_japanese(run, japanese)}最初に壊れた対策：{failed.label[1]}（{at:.1f}秒後）。",
    )


def _japanese(run: Run, name: str) -> str:
    hits = _hits(run)
    match run.outcome:
        case Outcome.OVERTURNED:
            side = "右（手前）" if run.tilt[-1] > 0.0 else "左（奥）"
            return f"{name}は{hits}揺れ始めから{run.overturn_time:.1f}秒後に{side}へ倒れました。"
        case Outcome.FAILED:
            until = f"{run.time[-1]:.2f}秒より先を計算できませんでした"
            return f"{name}の動きは{until}。倒れるかどうかは分かりません。"
        case Outcome.LEANING:
            return f"{name}は{hits}倒れませんでしたが、寄りかかったまま止まりました。"
        case Outcome.RESTED:
            return f"{name}は動きませんでした。"
        case Outcome.SLID:
            return f"{name}は{hits}最大{_length(run.peak_slide)}滑りましたが、倒れませんでした。"
        case Outcome.ROCKED:
            tilt = f"最大{math.degrees(run.peak_tilt):.1f}度傾"
            if run.peak_slide < 5e-4:
                return f"{name}は{hits}{tilt}きましたが、倒れませんでした。"
            return f"{name}は{hits}{tilt}き、最大{_length(run.peak_slide)}滑りましたが、倒れませんでした。"


def _hits(run: Run) -> str:
    kinds = [event.kind for event in run.events]
    walls, ceilings = kinds.count(EventKind.WALL_IMPACT), kinds.count(EventKind.CEILING_IMPACT)
    parts = [f"{what}に{n}回" for what, n in (("壁", walls), ("天井", ceilings)) if n]
    return f"{'、'.join(parts)}ぶつかり、" if parts else ""


def _length(metres: float) -> str:
    return f"{1e3 * metres:.0f} mm" if metres < 0.01 else f"{1e2 * metres:.1f} cm"
