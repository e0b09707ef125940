"""Charts, films and programs that a reader keeps: what they are of, and that they have the page's numbers."""

from __future__ import annotations

import csv
import io
import re
import shutil
import tomllib
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from PIL import Image
from serving import SCENE

import stayput as sp
from stayput.app.downloads import film_kinds
from waiting import wait_until

if TYPE_CHECKING:
    import httpx

JAPANESE = re.compile("[\u3040-\u30ff\u4e00-\u9fff]")
FEW = {
    **SCENE,
    "shaking": {"suite": {"count": 3}, "intensity": "6-upper"},
    "uncertainty": {"samples": 6, "seed": 7},
}
BRACKET = [{"type": "l_bracket"}]


def numbers(content: bytes) -> tuple[list[str], list[dict[str, str]]]:
    """Return the lines about a table, without their mark, and its rows."""
    lines = content.decode("utf-8-sig").splitlines()
    about = [line.removeprefix("#").removeprefix(" ") for line in lines if line.startswith("#")]
    return about, list(csv.DictReader(line for line in lines if not line.startswith("#")))


def done(client: httpx.Client, **asked: Any) -> dict[str, Any]:
    job = client.post("/api/v1/verify", json={"scene": FEW, "measures": BRACKET, **asked}).json()

    def ended() -> bool:
        job.update(client.get(f"/api/v1/jobs/{job['id']}").json())
        return job["state"] not in ("waiting", "running")

    wait_until(ended)
    assert job["state"] == "done", job["error"]
    return job


@pytest.fixture(scope="module")
def job(server: Any) -> dict[str, Any]:
    from serving import client_of

    with client_of(server) as client:
        return done(client)


@pytest.mark.parametrize("name", ["tens", "ranking", "fragility"])
def test_a_verdict_s_charts_say_what_they_are_of(
    client: httpx.Client, job: dict[str, Any], name: str
) -> None:
    address = f"/api/v1/jobs/{job['id']}/figures/{name}"
    drawn = client.get(f"{address}.svg")
    assert drawn.headers["content-type"].startswith("image/svg+xml")
    assert drawn.headers["content-disposition"] == f'attachment; filename="stayput_{name}.svg"'
    for part in (
        "seed 7",
        f"stayput {sp.__version__}",
        job["result"]["headline"]["en"],
        'intensity = "6-upper"',
    ):
        assert part in drawn.text
    assert client.get(f"{address}.svg").content == drawn.content
    printed = client.get(f"{address}.pdf", params={"lang": "ja"})
    assert printed.content.startswith(b"%PDF-")
    about, rows = numbers(client.get(f"{address}.csv", params={"lang": "ja"}).content)
    assert JAPANESE.search(about[0])
    assert job["result"]["headline"]["ja"] in about[1]
    scenario = sp.Scenario.parse(tomllib.loads("\n".join(about[about.index("") :])))
    assert scenario.uncertainty.seed == 7
    assert rows


def test_the_numbers_of_charts_are_those_of_the_verdict(client: httpx.Client, job: dict[str, Any]) -> None:
    options = {one["name"]: one for one in job["result"]["options"]}
    _, ranked = numbers(client.get(f"/api/v1/jobs/{job['id']}/figures/ranking.csv").content)
    assert [row["option"] for row in ranked] == list(options)
    for row in ranked:
        chance = options[row["option"]]["overturned"]
        for end, key in (("", "estimate"), ("_low", "low"), ("_high", "high")):
            assert float(row[f"overturned{end}"]) == pytest.approx(chance[key], rel=1e-8)
    _, tens = numbers(client.get(f"/api/v1/jobs/{job['id']}/figures/tens.csv").content)
    assert [row["option"] for row in tens] == ["none", "yours"]
    share = options["none"]["overturned"]["estimate"]
    assert tens[0]["fallen_of_ten"] == str(round(10 * share))
    _, points = numbers(client.get(f"/api/v1/jobs/{job['id']}/figures/fragility.csv").content)
    observed = [row for row in points if (row["option"], row["from"]) == ("none", "runs")]
    assert [float(row["overturned"]) for row in observed] == pytest.approx(
        [one["estimate"] for one in options["none"]["curve"]["observed"]]
    )


def test_curves_that_were_not_made_are_refused(client: httpx.Client) -> None:
    job = done(client, curves=False, compare_usual=False)
    answer = client.get(f"/api/v1/jobs/{job['id']}/figures/fragility.svg")
    assert answer.status_code == 409
    assert "no curves" in answer.json()["message"]
    for wrong in ("pie.svg", "tens.exe"):
        assert client.get(f"/api/v1/jobs/{job['id']}/figures/{wrong}").status_code == 404


@pytest.mark.parametrize("dimensions", [2, 3])
def test_histories_have_both_runs_and_every_device(client: httpx.Client, dimensions: int) -> None:
    asked = {"scene": {**SCENE, "dimensions": dimensions}, "measures": BRACKET}
    answer = client.post("/api/v1/simulate/figure", params={"kind": "csv"}, json=asked)
    about, rows = numbers(answer.content)
    run = client.post("/api/v1/simulate", json=asked).json()
    assert run["without"]["sentence"]["en"] in about[1]
    assert run["with"]["sentence"]["en"] in about[1]
    tilts = [abs(float(row["tilt_with_rad"])) for row in rows]
    peak = run["with"]["peak_tilt_rad"] if dimensions == 2 else run["with"]["pieces"][0]["peak_tilt_rad"]
    assert max(tilts) == pytest.approx(peak, rel=0.02, abs=1e-6)
    assert sum(name.startswith("device_") for name in rows[0]) == len(run["with"]["devices"])
    picture = client.post("/api/v1/simulate/figure", params={"lang": "ja"}, json=asked)
    assert picture.content.startswith(b"<?xml")
    assert run["with"]["sentence"]["ja"] in picture.text


def test_the_map_s_numbers_are_those_that_were_shown(client: httpx.Client) -> None:
    asked = {"scene": FEW, "measures": [], "axis": "height"}
    shown = client.post("/api/v1/size-map", json=asked).json()
    _, rows = numbers(client.post("/api/v1/size-map/figure", params={"kind": "csv"}, json=asked).content)
    flat = [share for row in shown["overturned"] for share in row]
    assert [row["overturned"] for row in rows] == ["" if one is None else f"{one:.9g}" for one in flat]


def test_a_short_film_shows_what_happens_and_says_the_verdict(
    client: httpx.Client, job: dict[str, Any]
) -> None:
    asked = {"scene": FEW, "measures": BRACKET}
    query = {"kind": "gif", "seconds": 4, "job": job["id"]}
    with_verdict = client.post("/api/v1/simulate/film", params=query, json=asked)
    bare = client.post("/api/v1/simulate/film", params={"kind": "gif", "seconds": 4}, json=asked)
    films = [Image.open(io.BytesIO(one.content)) for one in (with_verdict, bare)]
    seconds = films[0].n_frames * films[0].info["duration"] / 1000
    assert 3.0 < seconds < 4.0 + 1.5 + 0.3  # and the last pose is held
    below = [np.asarray(film.convert("L"))[-70:] for film in films]
    assert (below[0] < 200).sum() > 1.2 * (below[1] < 200).sum()  # more is written


@pytest.mark.skipif(shutil.which("ffmpeg") is None, reason="there is no ffmpeg")
def test_a_film_is_an_mp4_where_that_can_be_made(client: httpx.Client) -> None:
    assert client.get("/api/v1/presets").json()["films"] == ["html", "gif", "mp4"]
    for dimensions in (2, 3):
        asked = {"scene": {**SCENE, "dimensions": dimensions}}
        answer = client.post("/api/v1/simulate/film", params={"kind": "mp4", "seconds": 2}, json=asked)
        assert answer.headers["content-type"] == "video/mp4"
        assert answer.content[4:8] == b"ftyp"


def test_no_mp4_is_promised_without_its_encoder(
    client: httpx.Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("stayput.app.downloads.shutil.which", lambda _: None)
    assert film_kinds() == ("html", "gif")
    answer = client.post("/api/v1/simulate/film", params={"kind": "mp4"}, json={"scene": SCENE})
    assert answer.status_code == 422
    assert "one of html, gif" in answer.json()["message"]
    assert answer.json()["field"] == "kind"


def executed(client: httpx.Client, asked: dict[str, Any]) -> dict[str, Any]:
    """Run the program of a scene; return what it has made."""
    answer = client.post("/api/v1/scenario/python", json=asked)
    assert answer.headers["content-type"].startswith("text/x-python")
    made: dict[str, Any] = {}
    exec(compile(answer.text, "scenario.py", "exec"), made)
    return made


@pytest.mark.parametrize("dimensions", [2, 3])
def test_the_program_and_the_file_give_the_page_s_numbers_to_the_bit(
    client: httpx.Client, dimensions: int
) -> None:
    few = {**FEW, "dimensions": dimensions, "uncertainty": {"samples": 3, "seed": 2}}
    asked = {"scene": few, "measures": BRACKET}
    made = executed(client, asked)
    run = client.post("/api/v1/simulate", json=asked).json()
    file = sp.Scenario.parse(tomllib.loads(client.post("/api/v1/scenario/toml", json=asked).text))
    for name, key, measures in (("without", "without", ()), ("held", "with", file.measures[0].measures)):
        again = file.case(measures).run()
        told, copied = run[key], made[name]
        for field in ("tilt", "slide", "time"):
            assert np.array_equal(getattr(copied, field), getattr(again, field))
        if dimensions == 2:
            assert told["peak_tilt_rad"] == copied.peak_tilt
            assert told["peak_slide_m"] == copied.peak_slide
            assert told["residual_slide_m"] == copied.residual_slide
        else:
            assert told["pieces"][0]["peak_tilt_rad"] == copied.peak_tilt[0]
            assert told["pieces"][0]["residual_slide_m"] == copied.slide[0, -1].tolist()
        for device, one in zip(told["devices"], copied.devices, strict=True):
            assert device["peak_pull_n"] == one.peak_pull
    held = {"scene": few, "measures": BRACKET, "compare_usual": False, "curves": False}
    verdict = done(client, **held)["result"]
    shown = {one["name"]: one["overturned"] for one in verdict["options"]}
    for option in made["verdict"].options:
        chance = option.probabilities["overturned"]
        assert shown[option.option.name]["estimate"] == chance.estimate
        assert (shown[option.option.name]["low"], shown[option.option.name]["high"]) == (
            chance.low,
            chance.high,
        )


def test_a_program_of_several_pieces_runs_too(client: httpx.Client) -> None:
    scene = {
        "furniture": [
            {"preset": "chest", "name": 'a "low" one'},
            {"preset": "television", "name": "screen", "on": 'a "low" one'},
        ],
        "shaking": {"sine": {"amplitude": 4.0, "frequency": 2.0, "duration": 2.0}},
    }
    asked = {"scene": scene, "measures": []}
    made = executed(client, asked)
    told = client.post("/api/v1/simulate", json=asked).json()["without"]["pieces"]
    assert [one["peak_tilt_rad"] for one in told] == made["run"].peak_tilt.tolist()
