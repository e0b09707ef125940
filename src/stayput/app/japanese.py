"""Refusals that somebody may meet on the page, in Japanese: patterns of the English sentences, and words.

The sentences are made in English, where the input is checked; as in a catalogue of translations, they are
the keys.
"""

from __future__ import annotations

import re
from typing import NamedTuple

from stayput.measures import MEASURES

NAMES = {kind.label[0]: kind.label[1] for kind in MEASURES.values()}
"""Measures: their English names, and the Japanese ones."""

_NUMBER = r"-?\d[\d.e+,-]*\d|\d"  # without the stop at the end of its sentence
_VARIES = {
    "measure": "|".join(map(re.escape, NAMES)),
    "a": _NUMBER,
    "b": _NUMBER,
    "c": _NUMBER,
    "text": ".+?",
}


class Wording(NamedTuple):
    """A refusal in Japanese.

    Attributes
    ----------
    english : str
        Part of the English sentence, with <measure>, <a>, <b>, <c>, <text> for what varies.
    pattern : re.Pattern
        The same as a pattern, with a group for each.
    japanese : str
        The sentence, with {groups} for the values.
    field : str or None
        Field of the request that would help, where the sentence alone says which.
    """

    english: str
    pattern: re.Pattern[str]
    japanese: str
    field: str | None = None


def _wording(english: str, japanese: str, field: str | None = None) -> Wording:
    pattern = re.escape(english)
    for name, values in _VARIES.items():
        pattern = pattern.replace(f"<{name}>", f"(?P<{name}>{values})")
    return Wording(english, re.compile(pattern), japanese, field)


MEASURES_THAT_DO_NOT_FIT = (
    _wording(
        "<measure> stands <a> m from the wall; the gap must be at most <b> m",
        "家具と壁のすき間が{a} mあります。「{measure}」を使うには{b} m以下にしてください。",
    ),
    _wording(
        "<measure> setback is <a> m; it must be at most the width, <b> m",
        "「{measure}」の背面からの距離は{a} mです。家具の奥行き（{b} m）以下にしてください。",
    ),
    _wording(
        "<measure> angle is <a> rad, which puts its anchor at <b> m; it must be between floor and ceiling",
        "「{measure}」の壁側の取付け位置が高さ{b} mになります。床と天井の間になる角度にしてください。",
    ),
    _wording(
        "<measure> preload is <a> N; it must be below the ceiling's strength, <b> N",
        "「{measure}」の突っ張り力は{a} Nです。天井の強さ（{b} N）より小さくしてください。",
    ),
    _wording(
        "<measure> have <a> m below the ceiling; it must be between <b> and <c> m",
        "家具と天井の間が{a} mです。「{measure}」を使うには{b}～{c} mにしてください。",
    ),
    _wording(
        "<measure> height is <a> m; it must be at most the piece's, <b> m",
        "「{measure}」の高さは{a} mです。家具の高さ（{b} m）以下にしてください。",
    ),
    _wording(
        "<measure> share is <a>; so much is not in the upper half of this piece",
        "「{measure}」の割合は{a}ですが、この家具の上半分にはそれだけの重さがありません。小さくしてください。",
    ),
    _wording(
        "<measure> kinetic_friction is <a>; it must not be above static_friction, <b>",
        "「{measure}」の動摩擦係数は{a}です。静止摩擦係数（{b}）以下にしてください。",
    ),
    _wording(
        "kinetic friction is <a>; it must not be above the static one, <b>",
        "動摩擦係数は{a}です。静止摩擦係数（{b}）以下にしてください。",
    ),
)
"""Measures whose numbers do not go with the piece, the room or each other."""

FILES = (
    _wording("is in no known format", "対応している形式のファイルではありません。"),
    _wording("is binary", "テキストのファイルではありません。地震記録のテキストファイルを選んでください。"),
    _wording("is empty", "ファイルが空です。"),
    _wording("states no unit", "加速度の単位がファイルに書かれていません。単位を選んでください。", "unit"),
    _wording(
        "it must be the one that the file states, '<text>'",
        "ファイルに書かれている単位は{text}です。それを選んでください。",
        "unit",
    ),
    _wording(
        "states no time step",
        "時間刻みがファイルに書かれていません。秒単位で入力してください。",
        "dt",
    ),
    _wording(
        "it must be the one that the file states, <a> s",
        "ファイルに書かれている時間刻みは{a}秒です。それを入力してください。",
        "dt",
    ),
    _wording(
        "it must be the one of the time column, <a> s",
        "ファイルの時刻の列から求めた時間刻みは{a}秒です。それを入力してください。",
        "dt",
    ),
    _wording("dt is <a> s; it must be between <b> and <c> s", "時間刻みは{b}～{c}秒にしてください。", "dt"),
    _wording(
        "channels; component must name one of <text>.",
        "記録に多くのチャンネルがあります。使うものを次から選んで入力してください：{text}",
        "component",
    ),
    _wording(
        "of the file; it must be one of <text>.",
        "そのチャンネルはファイルにありません。次から選んで入力してください：{text}",
        "component",
    ),
    _wording("sampling is irregular near <a> s", "時刻が{a}秒付近で等間隔になっていません。"),
    _wording("it must be a finite decimal number", "数値でない値が含まれています。"),
    _wording("it must be finite", "数値でない値が含まれています。"),
    _wording(
        "The file has <a> columns", "{a}列あります。1列（加速度）、2列（時刻と加速度）、4列に対応しています。"
    ),
    _wording("values; it must have <a> like the first", "行によって列の数が違います。"),
    _wording("has a line of <a> characters", "1行が長すぎます（{a}文字）。"),
    _wording("it must be complete", "ファイルが途中で切れています。"),
    _wording("they must be as many", "ヘッダーに書かれた数とデータの数が合いません。"),
    _wording("so the file is damaged", "ヘッダーの最大加速度とデータが合いません。ファイルが壊れています。"),
    _wording(
        "Motion x at sample <a> is <b> m/s²",
        "加速度が大きすぎます（{b} m/s²）。単位を確かめてください。",
        "unit",
    ),
    _wording("lasts <a> s; this server allows <b> s", "記録が長すぎます（{a}秒）。{b}秒まで使えます。"),
    _wording("has <a> samples; this server allows <b>", "データが多すぎます（{a}個）。{b}個まで使えます。"),
    _wording(
        "has about <a> numbers; this server reads <b>", "数値が多すぎます（約{a}個）。{b}個まで読めます。"
    ),
    _wording("cannot be scaled to an intensity", "揺れのない記録なので、震度に合わせることができません。"),
    _wording(
        "an intensity needs at least <a> s", "記録が短すぎて震度を求められません（{a}秒以上必要です）。"
    ),
)
"""Records that cannot be read, or not be used."""

LIMITS = (
    _wording(
        "This verification makes <a> simulations; this server allows <b>",
        "計算が多すぎます（{a}回）。このサーバーで計算できるのは{b}回までです。",
    ),
    _wording("The verification failed; the server's log says why", "計算に失敗しました。"),
)
"""Verifications that are too much, or went wrong."""

WORDINGS = MEASURES_THAT_DO_NOT_FIT + FILES + LIMITS
"""All wordings; the first that fits counts."""


def wording_of(sentence: str) -> tuple[str | None, str | None]:
    """Return a refusal in Japanese, and the field that would help, as far as they are known.

    Parameters
    ----------
    sentence : str
        The refusal in English.
    """
    for _, pattern, japanese, field in WORDINGS:
        found = pattern.search(sentence)
        if found is not None:
            values = found.groupdict()
            if "measure" in values:
                values["measure"] = NAMES[values["measure"]]
            return japanese.format(**values), field
    return None, None
