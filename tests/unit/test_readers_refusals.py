"""Refusals and warnings about a file: the argument that would help, and the sentence in Japanese."""

import pytest
from test_readers_japan import jma
from test_readers_peer import at2
from test_readers_world import WAVE, csmip_channel

import stayput as sp
from stayput.errors import InputError, InputWarning, warnings_to

TIMES = "".join(f"{0.01 * i:.2f},{i % 7 - 3}\n" for i in range(100))
ARRAY = "".join(csmip_channel(i, f"{90 * i} DEG", WAVE) for i in (1, 2, 3))


@pytest.mark.parametrize(
    ("text", "given", "field", "japanese"),
    [
        ("hello\n", {}, None, "対応している形式のファイルではありません"),
        ("\x00\x01", {}, None, "テキストでないファイル"),
        (
            TIMES,
            {},
            "unit",
            "加速度の単位（unit）がファイルに書かれていません。次から選んでください：m/s²",
        ),
        (
            "# acc_gal\n" + TIMES,
            {},
            "unit",
            "ヘッダーに「gal」とありますが、加速度の単位とは書かれていません",
        ),
        ("# unit: gal\n" + TIMES, {"unit": "g"}, "unit", "ファイルに書かれている単位は「gal」です"),
        (TIMES, {"unit": "furlong"}, "unit", "加速度の単位が「furlong」になっています"),
        ("1\n-1\n0\n", {}, "unit", "加速度の単位（unit）と時間刻み（dt）がファイルに書かれていません"),
        ("1\n-1\n0\n", {"unit": "g"}, "dt", "時間刻み（dt）がファイルに書かれていません"),
        (TIMES, {"unit": "gal", "dt": 0.5}, "dt", "ファイルの時間刻みは0.01秒です"),
        (TIMES, {"unit": "gal", "dt": 1e6}, "dt", "時間刻みが1e+06 sになっています"),
        ("0.0,1\n0.01,1e30\n", {"unit": "gal"}, "unit", "x成分のデータ番号1が1e+28 m/s²"),
        ("0.0,1\n0.01,x\n", {"unit": "gal"}, None, "数値の4番目の値が「x」になっていて"),
        (ARRAY, {}, "component", "使うものを次から選んで入力してください：「90 DEG (channel 1)、180 DEG"),
        (jma(), {"component": "ZZ"}, "component", "「ZZ」というチャンネルはファイルにありません"),
    ],
)
def test_a_refusal_names_the_argument_that_helps(tmp_path, text, given, field, japanese):
    file = tmp_path / "a.txt"
    file.write_text(text)
    with pytest.raises(InputError) as caught:
        sp.read_motion(file, **given)
    assert caught.value.field == field
    assert japanese in caught.value.told("ja")


def test_a_warning_names_the_argument_that_helps(tmp_path):
    file = tmp_path / "floor42.csv"
    file.write_text(jma())
    warnings: list[InputWarning] = []
    with warnings_to(warnings.append):
        sp.read_motion(file)
    assert [(warning.code, warning.field) for warning in warnings] == [
        ("motion.x_chosen", "component"),
        ("motion.upper_floor", None),
    ]
    chosen, floor = (warning.told("ja") for warning in warnings)
    assert chosen.startswith("floor42.csv（JMA CSV）：ファイルには水平の成分が「NS、EW」とあります")
    assert "観測された記録のようです（42階）" in floor


def test_a_file_without_a_direction_is_told_of(tmp_path):
    file = tmp_path / "a.at2"
    file.write_text(at2(title="Q, S, UP"))
    with pytest.warns(InputWarning, match="vertical channel alone") as caught:
        sp.read_motion(file)
    warning = caught[0].message
    assert isinstance(warning, InputWarning)
    assert "上下動の成分（「UP」）しかありません" in warning.told("ja")
