"""Films and scenario files that a reader keeps: what they show, and that they have the page's numbers."""

from __future__ import annotations

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
    below = [np.asarray(film.convert("L"))[-45:] for film in films]
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


@pytest.mark.parametrize("dimensions", [2, 3])
def test_the_file_gives_the_page_s_numbers_to_the_bit(client: httpx.Client, dimensions: int) -> None:
    few = {**FEW, "dimensions": dimensions, "uncertainty": {"samples": 3, "seed": 2}}
    asked = {"scene": few, "measures": BRACKET}
    run = client.post("/api/v1/simulate", json=asked).json()
    file = sp.Scenario.parse(tomllib.loads(client.post("/api/v1/scenario/toml", json=asked).text))
    for key, measures in (("without", ()), ("with", file.options[0].measures)):
        copied = file.case(measures).run()
        told = run[key]
        (piece,) = told["pieces"]
        assert piece["peak_tilt_rad"] == copied.peak_tilt
        assert piece["peak_slide_m"] == copied.peak_slide
        if dimensions == 2:
            assert piece["residual_slide_m"] == [copied.residual_slide, 0.0]
        else:
            assert piece["residual_slide_m"] == copied[0].slide_in_plan[-1].tolist()
        for device, one in zip(told["devices"], copied.devices, strict=True):
            assert device["peak_pull_n"] == one.peak_pull
