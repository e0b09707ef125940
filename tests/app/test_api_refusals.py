"""Refusals that somebody meets on the page: each has its sentence in Japanese."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import pytest
from serving import SCENE, client_of, running

from stayput.app.limits import Limits

if TYPE_CHECKING:
    from collections.abc import Iterator

    import httpx

FEW = replace(Limits(), duration=30.0, samples_of_motion=2000, runs=1000)
"""A server that allows little, so that small files are too large for it."""

TIMES = "".join(f"{0.01 * i:.2f},{i % 7 - 3}\n" for i in range(100))
UNIT = {"unit": "m/s²"}
FILES_REFUSED: dict[str, tuple[str | bytes, dict[str, str], str]] = {
    "no format": ("hello\n", {}, "file"),
    "binary": (b"\x00\x01\x02", {}, "file"),
    "no unit": (TIMES, {}, "unit"),
    "another unit": ("# unit: gal\n" + TIMES, {"unit": "g"}, "unit"),
    "no step": ("1\n-1\n0\n" * 9, UNIT, "dt"),
    "another step": (TIMES, {**UNIT, "dt": "0.5"}, "dt"),
    "too large": ("0.0,1\n0.01,1e30\n", UNIT, "unit"),
    "too long": ("".join(f"{i * 0.5},1\n" for i in range(200)), UNIT, "file"),
    "many samples": ("".join(f"{i * 0.005:.3f},1\n" for i in range(3000)), UNIT, "file"),
}


@pytest.fixture(scope="module")
def strict() -> Iterator[httpx.Client]:
    with running(FEW) as found, client_of(found) as client:
        yield client


def in_japanese(answer: httpx.Response) -> str:
    assert answer.status_code == 422, answer.text[:300]
    problem = answer.json()
    told = problem["message_ja"]
    assert told, problem["message"]
    assert told.endswith("。") or "：" in told
    plain = re.sub(r"^a\.csv（数値の列）：|「.*?」|SAC|miniSEED|[cm]?m/s²|in/s²|ft/s²|gal|mg", "", told)
    assert not re.search("[A-Za-z]{2,}|[{}]", plain), told
    return told


@pytest.mark.parametrize("name", FILES_REFUSED)
def test_files_that_cannot_be_used(strict: httpx.Client, name: str) -> None:
    data, said, field = FILES_REFUSED[name]
    content = data.encode() if isinstance(data, str) else data
    answer = strict.post("/api/v1/motions", files={"file": ("a.csv", content)}, data=said)
    in_japanese(answer)
    assert answer.json()["field"] == field


def test_a_verification_that_is_too_much(strict: httpx.Client) -> None:
    in_japanese(strict.post("/api/v1/verify", json={"scene": SCENE}))


def test_measures_that_do_not_fit_have_values_and_names_in_the_sentence(client: httpx.Client) -> None:
    far = {**SCENE, "room": {**SCENE["room"], "left_wall": {"gap": 0.4}}}
    answer = client.post("/api/v1/simulate", json={"scene": far, "measures": [{"type": "l_bracket"}]})
    in_japanese(answer)
    problem = answer.json()
    assert problem["field"] == "measures"
    assert (
        problem["message"]
        == "The gap to the wall for “Screwed L-brackets” is 0.4 m; it must be between 0 and 0.15 m."
    )
    assert (
        problem["message_ja"]
        == "「L型金具（ねじ留め）」のための家具と壁のすき間が0.4 mになっています。0～0.15 mにしてください。"
    )


BODIES: dict[str, tuple[str, dict[str, Any], str, str]] = {
    "a word for a number": ("verify", {"slide_limit_m": "far"}, "must be a number", "数値を指定"),
    "less than allowed": ("verify", {"slide_limit_m": -1.0}, "must be at least 0", "0以上を指定"),
    "more than allowed": ("room", {"lease_s": 1e5}, "must be at most 3600", "3600以下を指定"),
    "no switch": ("room", {"changes": "often"}, "must be true or false", "trueかfalseを指定"),
    "no list": ("verify", {"measures": 3}, "must be a list", "リストを指定"),
    "too many": ("verify", {"measures": [{}] * 9}, "must be a list of at most 8", "8個までのリストを指定"),
    "no table": ("room", {"scene": 3}, "must be a table", "テーブルを指定"),
    "a number for a text": ("scenario/read", {"toml": 3}, "must be a text", "文字列を指定"),
    "a long text": ("scenario/read", {"toml": "", "name": "a" * 300}, "at most 255 char", "255文字までの"),
    "missing": ("room", {}, "scene is missing", "sceneがありません"),
    "not known": ("room", {"scene": {}, "beds": 3}, "beds is not known here", "bedsという項目はありません"),
}


@pytest.mark.parametrize("name", BODIES)
def test_bodies_that_are_not_as_described(client: httpx.Client, name: str) -> None:
    address, body, english, japanese = BODIES[name]
    scene = {} if name == "missing" else {"scene": {}}
    answer = client.post(f"/api/v1/{address}", json={**scene, **body} if address != "scenario/read" else body)
    assert answer.status_code == 422, answer.text
    problem = answer.json()
    assert english in problem["message"]
    assert japanese in problem["message_ja"]
