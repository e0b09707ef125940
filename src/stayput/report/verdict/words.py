"""The words of a report of a verdict, in English and Japanese."""

from __future__ import annotations

import re

from stayput.simulation import Mode, Outcome

WORDS: dict[str, tuple[str, str]] = {
    "report": ("Verification of earthquake-proof measures", "家具の地震対策 検証報告書"),
    "untitled": ("Untitled scenario", "無題のシナリオ"),
    "made by": ("Made by stayput {version}", "stayput {version} で作成"),
    "skip": ("Skip to the ranking", "順位表へ移動"),
    "contents": ("Contents", "目次"),
    "verdict": ("The verdict", "結論"),
    "shaking": ("Shaking of the ground", "地盤の揺れ"),
    "instrumental": ("JMA intensity {class} (instrumental {value})", "{class}（計測震度 {value}）"),
    "simulations": ("Simulations", "計算回数"),
    "simulations told": (
        (
            "{runs} in all: motions × draws of what is not known, {motions} × {samples} for each measure and "
            "level"
        ),
        "合計{runs}回：地震動{motions}本 × 不確かさの標本{samples}組を、各対策・各レベルで計算",
    ),
    "motions": ("Motions", "地震動"),
    "not precise": (
        "The precision that was asked for was not reached with the samples that were allowed.",
        "指定された精度には、許された標本数では達していません。",
    ),
    "one motion": (
        (
            "Only one motion was run: the shares and their intervals hold for this motion, not for other "
            "earthquakes of the same intensity."
        ),
        "地震動は1本だけです。割合と区間はこの地震動についてのもので、同じ震度の他の地震には当てはまりません。",
    ),
    "before": ("Without a measure", "対策なし"),
    "after": ("With the best of those compared", "比較した中で最良の対策"),
    "ranking": ("The measures, best first", "対策の順位"),
    "ranking told": (
        (
            "Shares of all runs with their 95 % intervals. All measures met the same motions and the "
            "same draws. Ranked by overturning; where that is equal, by sliding, failing devices, "
            "and hits on a wall. “Unsure”: the runs are too few to say it with 95 % confidence."
        ),
        (
            "全計算に対する割合と95%区間です。どの対策にも同じ地震動と同じ標本を用いています。"
            "順位は転倒の少なさで決め、同じなら移動、器具の破損、壁への衝突の順に比べます。"
            "「不確実」は、計算数が少なく95%の信頼度では言えないものです。"
        ),
    ),
    "colon": (": ", "："),
    "stop": (". ", "。"),
    "listed": ("; ", "、"),
    "aside": (" ({told})", "（{told}）"),
    "rank": ("Rank", "順位"),
    "measure": ("Measure", "対策"),
    "overturned": ("Overturns", "転倒"),
    "slid": ("Slides more than {limit}", "{limit}を超える移動"),
    "hit_wall": ("Hits a wall", "壁に衝突"),
    "device_failed": ("A device fails", "器具の破損・脱落"),
    "slide": ("Peak slide, median", "最大移動量（中央値）"),
    "tilt": ("Peak tilt, median", "最大傾き（中央値）"),
    "most": ("90 %: {value}", "90%値：{value}"),
    "slide both": ("Peak slide: median, 90 %", "最大移動量：中央値、90%値"),
    "capacity": ("Intensity at which {share} % overturn", "{share}%が転倒する計測震度"),
    "brief overturned": ("Overturns", "転倒"),
    "brief slid": ("Slides\n> {limit}", "移動\n> {limit}"),
    "brief hit_wall": ("Hits\na wall", "壁に\n衝突"),
    "brief device_failed": ("Device\nfails", "器具\n破損"),
    "brief slide": ("Slide", "移動量"),
    "brief falls": ("falls", "転倒"),
    "brief capacity": ("I{share}", "I{share}"),
    "brief told": (
        (
            "Shares of all runs. Slide: median of the peak. I10, I50: JMA intensity at which 10, 50 % "
            "overturn; ?: unsure. In brackets: the 95 % interval of overturning."
        ),
        (
            "全計算に対する割合。移動量：最大値の中央値。I10、I50：10%、50%が転倒する計測震度。?は不確実。"
            "かっこ内：転倒の95%区間。"
        ),
    ),
    "capacity short": ("{share} % overturn at intensity", "{share}%転倒の計測震度"),
    "change": ("Against no measure", "対策なしとの差"),
    "points": ("points", "ポイント"),
    "why": ("Why", "理由"),
    "falls": ("overturned", "転倒"),
    "none": ("none", "なし"),
    "no device": ("no device", "器具なし"),
    "unknown": ("unknown", "不明"),
    "unsure": ("unsure", "不確実"),
    "at least": ("at least {low}", "{low}以上"),
    "at most": ("at most {high}", "{high}以下"),
    "between": ("{low} to {high}", "{low}〜{high}"),
    "interval": ("95 % interval", "95%区間"),
    "fragility": ("How strong may the shaking be?", "どの強さの揺れまで耐えるか"),
    "fragility told": (
        (
            "Share that overturns against the intensity of the ground. The bands are 95 % intervals; the "
            "marks are what was counted at each level, drawn for no measure and for the best one."
        ),
        (
            "地盤の計測震度に対する転倒の割合です。帯は95%区間、印は各レベルで数えた割合です"
            "（帯と印は対策なしと最良の対策のみ）。"
        ),
    ),
    "fragility alt": (
        (
            "Curves of the share that overturns over the intensity, one for each measure; the numbers are in "
            "the table of the measures."
        ),
        "計測震度に対する転倒割合の曲線（対策ごと）。数値は順位の表にあります。",
    ),
    "axis intensity": ("JMA instrumental intensity of the ground", "地盤の計測震度"),
    "axis share": ("Share that overturns", "転倒する割合"),
    "here": ("this shaking: {value}", "この揺れ：{value}"),
    "no curve": ("no curve ({state})", "曲線なし（{state}）"),
    "none fell": ("none fell", "転倒なし"),
    "all fell": ("all fell", "すべて転倒"),
    "abrupt": ("too abrupt to fit", "急に変わるため当てはめ不可"),
    "one level": ("one level", "1レベルのみ"),
    "no trend": ("no trend", "傾向なし"),
    "watch": ("See it happen", "動きを見る"),
    "watch told": (
        (
            "The room moves with the ground, without its drift below {corner} Hz; the dotted lines stand "
            "still, {grid} m apart."
        ),
        (
            "部屋は地盤とともに動きます（{corner} Hz未満のゆっくりした動きは除外）。"
            "点線は動かない目印で、間隔は{grid} mです。"
        ),
    ),
    "part shown": (
        "The room's movement is drawn at {part} % of its size.",
        "部屋の動きは実際の{part}%で描いています。",
    ),
    "typical": ("A typical case", "典型的な場合"),
    "typical told": (
        (
            "Without a measure, half of the runs went better than this one and half went worse. The same "
            "motion and the same draw on both sides."
        ),
        "対策なしで、結果がちょうど中程度だった計算です。左右とも同じ地震動・同じ標本です。",
    ),
    "worst": ("The worst case", "最悪の場合"),
    "worst told": (
        "The run that went worst with the best measure, and the same one without it.",
        "最良の対策で最も悪い結果になった計算と、その対策なしの場合です。",
    ),
    "worst bare told": (
        "The run that went worst without a measure.",
        "対策なしで最も悪い結果になった計算です。",
    ),
    "play": ("Play", "再生"),
    "pause": ("Pause", "一時停止"),
    "time": ("Time", "時刻"),
    "speed": ("Speed", "速さ"),
    "scene alt": (
        "Animation of the piece in its room, seen from its side: {told}",
        "家具と部屋を横から見た動画：{told}",
    ),
    "histories": ("Time histories", "時刻歴"),
    "histories alt": (
        "Floor acceleration, tilt and slide over time, without and with the measure: {told}",
        "床の加速度・傾き・移動量の時刻歴（対策なしとあり）：{told}",
    ),
    "axis acceleration": ("Floor acceleration [m/s²]", "床の加速度 [m/s²]"),
    "axis tilt": ("Tilt [°]", "傾き [°]"),
    "axis slide": ("Slide [cm]", "移動量 [cm]"),
    "typical bare told": (
        "Without a measure, half of the runs went better than this one and half went worse.",
        "対策なしで、結果がちょうど中程度だった計算です。",
    ),
    "axis time": ("Time [s]", "時刻 [s]"),
    "device failure": ("device fails", "器具の破損"),
    "motion shown": (
        (
            "Motion {number} of {count}: {name}; peak acceleration of the floor {peak} m/s². Shown from "
            "{start} to {end} s of {duration} s; tilts are cut at three critical angles."
        ),
        (
            "地震動 {number}/{count}：{name}、床の最大加速度 {peak} m/s²。"
            "全{duration}秒のうち{start}〜{end}秒を表示。傾きは限界角の3倍までを表示します。"
        ),
    ),
    "estimates": ("Quick estimates, to compare", "簡易式による目安"),
    "estimates told": (
        (
            "These are formulas for a piece that does not slide and stands free, not simulations. They are "
            "here so that the size of the results can be checked."
        ),
        (
            "滑らず周囲に壁のない家具についての略算式で、シミュレーションではありません。"
            "結果の大きさを確かめるために並べています。"
        ),
    ),
    "formula": ("Formula", "式"),
    "says": ("What it says", "内容"),
    "beside": ("Simulation beside it", "シミュレーションの結果"),
    "west": ("West", "ウェストの式"),
    "west told": (
        "rocks where the floor's peak acceleration exceeds {value} m/s²",
        "床の最大加速度が{value} m/s²を超えるとロッキングを始める",
    ),
    "ishiyama": ("Ishiyama (1982)", "石山（1982）"),
    "ishiyama told": (
        "can only overturn where the floor's peak velocity also exceeds {value} cm/s: {share} of the motions",
        "さらに床の最大速度が{value} cm/sを超えないと転倒しない：該当する地震動は{share}",
    ),
    "kaneko": ("Kaneko and Hayashi", "金子・林の式"),
    "kaneko told": ("{share} overturn", "{share}が転倒"),
    "details": ("Each measure", "対策ごとの詳細"),
    "drawing alt": (
        "Drawing to scale, seen from the side: {piece}, {width} cm deep and {height} cm high; {label}",
        "縮尺図（横から）：{piece}、奥行{width} cm、高さ{height} cm。{label}",
    ),
    "scale told": ("Drawn to scale, seen from the side", "縮尺どおり、横から見た図"),
    "device": ("Device", "器具"),
    "failed": ("Failed", "破損・脱落"),
    "failure time": ("Fails at, median", "破損の時刻（中央値）"),
    "seconds": ("{value} s", "{value} 秒"),
    "peak force": ("Peak force: median, 90 %", "最大の力：中央値、90%値"),
    "used": ("Of its strength: median, 90 %", "強度に対する割合：中央値、90%値"),
    "devices": ("Loads in the devices", "器具にかかる力"),
    "parameter": ("Parameter", "項目"),
    "value": ("Value", "値"),
    "confidence": ("How well founded", "確からしさ"),
    "parameters": ("Parameters", "設定値"),
    "assumptions": ("What this rests on", "前提"),
    "assumptions told": (
        (
            "Values marked as defaults are common values that were not measured on your furniture. Measure "
            "what matters, above all friction and the strength of wall, ceiling and anchors."
        ),
        (
            "「既定値」は一般的な値で、お使いの家具で測ったものではありません。"
            "特に摩擦と、壁・天井・留め具の強さは、実際に確かめてください。"
        ),
    ),
    "assumption": ("Assumption", "前提"),
    "low": ("default, low confidence", "既定値・信頼度 低"),
    "medium": ("default, medium confidence", "既定値・信頼度 中"),
    "high": ("default, high confidence", "既定値・信頼度 高"),
    "given": ("given by the user", "利用者の指定"),
    "model": ("limit of the model", "モデルの限界"),
    "again": ("To do it again", "再現するには"),
    "again told": (
        (
            "Save this as {file}, and run the command with stayput {version}. The same seed gives the same "
            "numbers."
        ),
        "これを{file}に保存し、stayput {version}でコマンドを実行します。同じシードなら同じ数値になります。",
    ),
    "record told": (
        "It names files of records; they are needed too, in the same place relative to it.",
        "記録ファイルの名前を含みます。それらも同じ相対位置に必要です。",
    ),
    "seed": ("Seed", "シード"),
    "command": ("Command", "コマンド"),
    "took": ("{seconds} s of computing", "計算時間 {seconds} 秒"),
    "version": ("Version", "版"),
    "caution": (
        "A simulation of a rigid body in a plane is not a guarantee. Real rooms, walls and fixings differ.",
        (
            "これは平面内の剛体シミュレーションであり、安全を保証するものではありません。"
            "実際の部屋や壁、固定の状態はこれと異なります。"
        ),
    ),
    "floor": ("Floor", "床"),
    "piece": ("Furniture", "家具"),
    "wall": ("Wall behind", "背後の壁"),
    "front wall": ("Wall in front", "前方の壁"),
    "ceiling": ("Ceiling", "天井"),
    "building": ("Building", "建物"),
}
"""Every text of the report by a key: English, Japanese."""

MODES: dict[Mode, tuple[str, str]] = {
    Mode.REST: ("rest", "静止"),
    Mode.SLIDE: ("slide", "滑り"),
    Mode.ROCK: ("rock", "ロッキング"),
    Mode.SLIDE_ROCK: ("slide-rock", "滑り＋ロッキング"),
    Mode.FLIGHT: ("flight", "浮き上がり"),
    Mode.LEAN: ("lean", "もたれ"),
    Mode.OVERTURNED: ("overturned", "転倒"),
}
"""Modes, in English and Japanese."""

OUTCOMES: dict[Outcome, tuple[str, str]] = {
    Outcome.RESTED: ("stays where it is", "動きません"),
    Outcome.SLID: ("slides by up to {slide} and stays upright", "最大{slide}滑りますが、倒れません"),
    Outcome.ROCKED: (
        "rocks by up to {tilt}, slides by up to {slide} and stays upright",
        "最大{tilt}傾き、最大{slide}移動しますが、倒れません",
    ),
    Outcome.LEANING: ("is left leaning", "もたれたまま止まります"),
    Outcome.OVERTURNED: ("overturns after {time} s", "{time}秒後に転倒します"),
    Outcome.FAILED: ("could not be followed to the end", "最後まで計算できませんでした"),
}
"""What became of a run, in English and Japanese."""


NAMES: dict[str, str] = {
    "bookcase": "本棚",
    "empty bookcase": "空の本棚",
    "wardrobe": "洋服だんす",
    "cupboard": "食器棚",
    "chest": "整理だんす",
    "refrigerator": "冷蔵庫",
    "television": "テレビ",
    "vending machine": "自動販売機",
    "server rack": "サーバーラック",
    "upright piano": "アップライトピアノ",
    "wood flooring": "フローリング",
    "vinyl": "塩ビ床",
    "tatami, along the weave": "畳（目に沿う方向）",
    "tatami, across the weave": "畳（目に直交する方向）",
    "carpet": "カーペット",
    "felt on wood": "木の床とフェルト",
    "PTFE glide": "フッ素樹脂のすべり材",
    "rubber pad": "ゴムパッド",
    "free caster, hard floor": "キャスター（硬い床）",
    "free caster, carpet": "キャスター（カーペット）",
    "locked caster": "ロックしたキャスター",
    "mixed": "混合",
    "crustal": "内陸地殻内地震",
    "subduction": "海溝型地震",
    "near-fault": "断層近傍",
    "basin": "堆積盆地の長周期地震動",
    "long-period basin": "堆積盆地の長周期地震動",
    "synthetic near-fault motion": "断層近傍の合成地震動",
    "sine": "正弦波",
    "front": "前面側",
    "back": "背面側",
}
"""Names of presets, families of motions and places in Japanese; in English they are what they are."""

_MEMBER = re.compile(r"synthetic (.+) (\d+)")
"""What a motion of a synthetic suite is called: its kind of earthquake and its number."""

HARDLY = ("hardly moves (tilt {tilt}, slide {slide})", "ほとんど動きません（傾き{tilt}、移動{slide}）")
"""What became of a run in which nothing to speak of happened."""


def word(key: str, language: str, **values: object) -> str:
    """Return a text in "en" or "ja", with values in it.

    Parameters
    ----------
    key : str
        Its key in `WORDS`.
    language : str
        "en" or "ja".
    **values
        What stands in its braces.
    """
    return WORDS[key][place(language)].format(**values)


def named(name: str, language: str) -> str:
    """Return a preset's name in a language; a name of the user's own stays as it is."""
    return name if language == "en" else NAMES.get(name, name)


def motion_named(name: str, language: str) -> str:
    """Return a motion's name in a language; a record's stays as it is."""
    member = None if language == "en" else _MEMBER.fullmatch(name)
    if member is None:
        return named(name, language)
    return f"合成地震動（{named(member[1], language)}）{member[2]}"


def place(language: str) -> int:
    """Return where a language stands in a pair: 0 for "en", 1 for "ja"."""
    return ("en", "ja").index(language)
