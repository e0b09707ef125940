"""Uploads: what is kept, under which name, for how long; and hostile files."""

from __future__ import annotations

import io
import zipfile
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
import pytest
from serving import SCENE, Clock, Running, client_of, hold_verifications, running
from test_api import finished

from real_records import MOTIONS, recorded
from stayput.app import motions
from stayput.app.limits import Limits
from stayput.app.motions import safe_label

if TYPE_CHECKING:
    from pathlib import Path

    import httpx

    from stayput.app.service import Service

RECORD = "".join(f"{0.01 * i:.2f},{np.sin(0.2 * i):.5f}\n" for i in range(1500))


def upload(
    client: httpx.Client, data: bytes | str, name: str = "record.csv", **fields: str
) -> httpx.Response:
    content = data.encode() if isinstance(data, str) else data
    return client.post("/api/v1/motions", files={"file": (name, content)}, data=fields)


def folder_of(server: Running) -> Path:
    service: Service = server.app.state.service
    return service.motions.folder


def test_a_record_is_kept_under_an_id_and_used_by_it(client: httpx.Client, server: Running) -> None:
    asked = upload(client, RECORD, "../../etc/cron.d/my record.csv")
    assert asked.status_code == 422
    assert "unit" in asked.json()["message"]
    answer = upload(client, RECORD, "../../etc/cron.d/my record.csv", unit="m/s²")
    assert answer.status_code == 201, answer.text
    found = answer.json()
    assert found["name"] == "my record.csv"
    assert found["samples"] == 1500
    assert [file.name for file in folder_of(server).iterdir()].count(found["id"]) == 1
    again = client.get(f"/api/v1/motions/{found['id']}").json()
    assert {**again, "expires_in_s": found["expires_in_s"]} == found
    preview = client.get(f"/api/v1/motions/{found['id']}/preview").json()
    assert max(preview["high_m_s2"]) == pytest.approx(1.0, abs=1e-3)
    assert len(preview["time_s"]) == len(preview["low_m_s2"]) <= 1000
    scene = {**SCENE, "shaking": found["shaking"]}
    run = client.post("/api/v1/simulate", json={"scene": scene}).json()
    assert run["motion"]["name"] == "my record.csv"
    text = client.post("/api/v1/scenario/toml", json={"scene": scene}).text
    assert 'record = "my record.csv"' in text
    assert found["id"] not in text
    assert client.delete(f"/api/v1/motions/{found['id']}").status_code == 204
    assert not (folder_of(server) / found["id"]).exists()
    assert client.get(f"/api/v1/motions/{found['id']}").status_code == 404
    assert client.post("/api/v1/simulate", json={"scene": scene}).status_code == 422


def bomb() -> bytes:
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("record.csv", b"0" * 50_000_000)
    return packed.getvalue()


@pytest.mark.parametrize(
    ("data", "words"),
    [(bomb(), "compressed archive"), ("1," * 1_500_000, "line"), ("\n".join(["1"] * 900_000), "time step")],
)
def test_hostile_files_are_refused(
    client: httpx.Client, server: Running, data: bytes | str, words: str
) -> None:
    before = set(folder_of(server).iterdir())
    answer = upload(client, data, "evil.csv", unit="m/s²")
    assert answer.status_code == 422, answer.text
    problem = answer.json()
    assert words in problem["message"]
    assert problem["field"] in ("file", "unit", "dt")
    assert str(folder_of(server)) not in problem["message"]
    assert set(folder_of(server).iterdir()) == before


def test_forms_that_are_none(client: httpx.Client) -> None:
    def post(content: bytes, kind: str) -> httpx.Response:
        return client.post("/api/v1/motions", content=content, headers={"content-type": kind})

    answer = post(b"x", "multipart/form-data")
    assert answer.status_code == 400
    assert "multipart/form-data" in answer.json()["message"]
    assert "送ってください" in answer.json()["message_ja"]
    answers = {
        "file": post(b"x", "text/plain"),
        "other": client.post("/api/v1/motions", files={"file": ("a", b"x"), "other": ("a", b"x")}),
        "unit": client.post("/api/v1/motions", files={"file": ("a", b"x")}, data={"unit": "x" * 1000}),
        "dt": client.post("/api/v1/motions", files={"file": ("a", b"x")}, data={"dt": "nan"}),
        "path": client.post("/api/v1/motions", files={"file": ("a", b"x")}, data={"path": "/etc"}),
    }
    assert {answer.status_code for answer in answers.values()} == {422}
    assert {key: answer.json()["field"] for key, answer in answers.items()} == {key: key for key in answers}
    assert client.post("/api/v1/motions", data={"file": "text"}).status_code == 422


def test_names_are_made_harmless() -> None:
    assert safe_label("../../etc/passwd") == "passwd"
    assert safe_label("C:\\evil\\<b>x</b>.csv") == "b_.csv"
    assert safe_label("<script>.csv") == "_script_.csv"
    assert safe_label("..") == "record"
    assert safe_label(None) == "record"
    assert safe_label("a\r\nb\x00.csv") == "a__b_.csv"
    assert len(safe_label("x" * 1000)) == 60


def test_motions_are_few_and_expire(monkeypatch: pytest.MonkeyPatch) -> None:
    clock = Clock(monkeypatch, motions)
    limits = replace(Limits(), motions=2, keep=1000.0)
    with running(limits) as server, client_of(server) as client:
        names = [upload(client, RECORD, unit="m/s²").json()["id"] for _ in range(3)]
        assert client.get(f"/api/v1/motions/{names[0]}").status_code == 404
        assert client.get(f"/api/v1/motions/{names[2]}").status_code == 200
        assert len(list(folder_of(server).iterdir())) == 2
        clock.ahead += 2000.0
        assert client.get(f"/api/v1/motions/{names[2]}").status_code == 404
        folder = folder_of(server)
        assert not list(folder.iterdir())
    assert not folder.exists()  # it goes with the server


def test_what_is_doubtful_about_a_file_is_told_in_both_languages(client: httpx.Client) -> None:
    clear = upload(client, RECORD, unit="m/s²").json()
    assert (clear["warnings"], clear["floor"]) == ([], "")
    rows = "".join(f"{0.01 * i:.2f},{2 * (i % 7 - 3)},{i % 5 - 2},{i % 3 - 1}\n" for i in range(1500))
    text = "# acceleration (gal)\n# t,NS,EW,UD\n" + rows
    answer = upload(client, text, "floor12.csv", unit="g").json()
    assert answer["floor"] == "floor 12"
    told = {one["field"]: one for one in answer["warnings"]}
    assert told.keys() == {"component", "unit", None}
    assert "階で観測された記録のようです（12階）" in told[None]["message_ja"]
    assert "horizontal channels NS, EW" in told["component"]["message"]
    assert "水平の成分「NS、EW」のどれも選ばれていない" in told["component"]["message_ja"]
    assert all(one["message"].startswith("floor12.csv") for one in answer["warnings"])
    assert any("6 g" in (one["message_ja"] or "") for one in answer["warnings"])
    assert any("ヘッダーには「gal」" in (one["message_ja"] or "") for one in answer["warnings"])
    assert client.get(f"/api/v1/motions/{answer['id']}").json()["warnings"] == answer["warnings"]


def test_a_vertical_channel_does_not_shake_sideways(client: httpx.Client) -> None:
    text = "# unit: m/s²\nt,NS,EW,UD\n" + "".join(
        f"{0.01 * i:.2f},{i % 7 - 3},{i % 5 - 2},{i % 3 - 1}\n" for i in range(1500)
    )
    refused = upload(client, text, component="UD")
    assert (refused.status_code, refused.json()["field"]) == (422, "component")
    assert "'UD' is a vertical channel; it must be a horizontal one: NS" in refused.json()["message"]
    assert "水平の成分を次から選んでください" in refused.json()["message_ja"]
    found = upload(client, text).json()
    for place in ("", "/preview"):
        again = client.get(f"/api/v1/motions/{found['id']}{place}", params={"component": "UD"})
        assert again.status_code == 422
    scene = {**SCENE, "shaking": {**found["shaking"], "component": "UD"}}
    told = client.post("/api/v1/simulate", json={"scene": scene})
    assert told.status_code == 422
    assert "vertical channel" in told.json()["message"]


def test_a_motion_that_a_job_reads_stays(monkeypatch: pytest.MonkeyPatch) -> None:
    """Newer uploads do not push it out; it goes once the job has ended."""
    hold_verifications(monkeypatch)
    limits = replace(Limits(), motions=1, threads=1)
    with running(limits) as server, client_of(server) as client:
        found = upload(client, RECORD, unit="m/s²").json()
        scene = {**SCENE, "shaking": found["shaking"]}
        job = client.post("/api/v1/verify", json={"scene": scene}).json()
        names = [upload(client, RECORD, unit="m/s²").json()["id"] for _ in range(3)]
        assert client.get(f"/api/v1/motions/{found['id']}").status_code == 200
        assert client.get(f"/api/v1/motions/{names[1]}").status_code == 404
        assert client.get(f"/api/v1/motions/{names[2]}").status_code == 200
        refused = client.delete(f"/api/v1/motions/{found['id']}")
        assert refused.status_code == 409
        assert "verification" in refused.json()["message"]
        assert client.get(f"/api/v1/jobs/{job['id']}").json()["state"] in ("waiting", "running")
        client.delete(f"/api/v1/jobs/{job['id']}")
        upload(client, RECORD, unit="m/s²")
        assert client.get(f"/api/v1/motions/{found['id']}").status_code == 404


def test_errors_name_the_user_s_file_and_no_folder_of_the_server() -> None:
    with running() as server, client_of(server) as client:
        folder = folder_of(server)
        found = upload(client, RECORD, "mine.csv", unit="m/s²").json()
        scene = {**SCENE, "shaking": found["shaking"], "uncertainty": {"samples": 8}}
        (folder / found["id"]).write_text("damaged")  # as a disk may do
        told = finished(client, {"scene": scene})
        assert told["state"] == "failed"
        (folder / found["id"]).unlink()
        answers = [
            client.post(f"/api/v1/{path}", json={"scene": scene}) for path in ("simulate", "simulate/csv")
        ]
        messages = [told["error"]["message"], *(answer.json()["message"] for answer in answers)]
        for message in messages:
            assert "mine.csv" in message
            assert folder.name not in message
            assert found["id"] not in message


def three(x: float, y: float, z: float) -> str:
    wave = np.sin(0.2 * np.arange(1500))
    lines = (f"{0.01 * i:.2f},{x * w:.6f},{y * w:.6f},{z * w:.6f}" for i, w in enumerate(wave))
    return "# unit: m/s²\n" + "\n".join(lines)


def test_channels_are_listed_and_another_one_is_taken(client: httpx.Client) -> None:
    found = upload(client, three(1.0, 0.5, 0.25)).json()
    assert found["channels"] == [
        {"name": "x", "vertical": False, "used": True},
        {"name": "y", "vertical": False, "used": False},
        {"name": "z", "vertical": True, "used": False},
    ]
    assert found["warnings"] == []
    place = f"/api/v1/motions/{found['id']}"
    across = client.get(place, params={"component": "y"}).json()
    assert across["shaking"] == {**found["shaking"], "component": "y"}
    assert across["pga_m_s2"] == pytest.approx(0.5 * found["pga_m_s2"], rel=1e-5)
    run = client.post("/api/v1/simulate", json={"scene": {**SCENE, "shaking": across["shaking"]}}).json()
    assert run["motion"]["pga_m_s2"] == pytest.approx(across["pga_m_s2"])
    assert [one["used"] for one in across["channels"]] == [False, True, False]
    preview = client.get(f"{place}/preview", params={"component": "y"}).json()
    assert max(preview["high_m_s2"]) == pytest.approx(0.5, abs=1e-3)
    none = client.get(place, params={"component": "w"})
    assert none.status_code == 422
    assert none.json()["field"] == "component"
    assert client.get(place).json()["shaking"] == found["shaking"]  # as it was uploaded


def test_an_option_is_called_by_the_page_s_control_or_by_its_flag(client: httpx.Client) -> None:
    asked = upload(client, "1,2,3,4,5\n" * 20, unit="gal").json()
    assert "unless --columns on the command line says which" in asked["message"]
    assert "「コマンドの--columns」で" in asked["message_ja"]
    assert asked["field"] == "file"
    upright = "t,x,y,z\n" + "".join(f"{0.01 * i:.2f},0,{i % 2},-9.81\n" for i in range(200))
    asked = upload(client, upright, unit="m/s²").json()
    assert "(“Take the mean off each component”)" in asked["message"]
    assert "（「各成分から平均を除く」）" in asked["message_ja"]
    assert asked["field"] == "remove_mean"


@recorded
def test_the_files_of_one_record_say_so_and_make_one_motion(client: httpx.Client) -> None:
    names = (*(f"jma_kobe_1995_{axis}.AT2" for axis in ("ns", "ew", "ud")), "elcentro_1940_180.AT2")
    ns, ew, up, other = (upload(client, (MOTIONS / name).read_bytes(), name).json() for name in names)
    assert ns["record"] == ew["record"] == up["record"] != other["record"]
    path, parts = f"/api/v1/motions/{ns['id']}", {"across": ew["id"], "vertical": up["id"]}
    all_three = client.get(path, params=parts).json()
    assert all_three["components"] == ["x", "y", "z"]
    assert all_three["shaking"] == {**ns["shaking"], **parts}
    assert all_three["intensity"] == pytest.approx(6.4, abs=0.1)  # as published
    refused = client.get(path, params={"across": other["id"]})
    assert refused.status_code == 422
    assert "time steps" in refused.json()["message"] or "record" in refused.json()["message"]
