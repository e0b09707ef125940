"""The API's routes: each reads its request, computes on a worker's thread, and returns a response."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from fastapi import APIRouter, Form, Query, Request
from starlette.responses import Response

import stayput
from stayput.app import replies, requests
from stayput.app.downloads import attachment, film, report_page, run_csv, scene_toml
from stayput.app.presets import presets
from stayput.app.room_api import add_rooms
from stayput.app.run_replies import SimulateReply
from stayput.app.running import shaking_reply, simulated
from stayput.app.service import OF_BODY, OF_JOB, Service, json_response, of_file, problems
from stayput.app.turns import StoppedError
from stayput.app.verdict_replies import EverydayReply, JobReply
from stayput.app.verification import everyday_reply, runs_of, with_options
from stayput.catalogue import Language  # noqa: TC001 - FastAPI reads the annotations
from stayput.scenario import Scenario
from stayput.scenario.toml import table_of_toml
from stayput.spreadsheets import CSV_ENCODING
from stayput.verification import verify
from stayput.verification.compare import LEVELS

if TYPE_CHECKING:
    from stayput.execution import Stop
    from stayput.scenario import Scenario

ComponentQuery = Annotated[str | None, Query(max_length=60, description="Channel that is to be x.")]

Which = Annotated[Literal["without", "with"], Query()]
"""Which run of a scene is meant, without or with the measures."""


def api(service: Service) -> APIRouter:
    """Return the routes under /api/v1."""
    router = APIRouter(prefix="/api/v1")
    parts = (
        ("general", _add_general),
        ("runs", _add_runs),
        ("verification", _add_jobs),
        ("verification", add_rooms),
        ("motions", _add_motions),
    )
    for tag, add in parts:
        routes = APIRouter(tags=[tag])
        add(routes, service)
        router.include_router(routes)
    return router


def _add_general(router: APIRouter, service: Service) -> None:
    @router.get("/ping", response_model=replies.PingReply)
    async def ping() -> Response:
        """Say whether the server is there."""
        return json_response(replies.PingReply(ready=service.ready, version=stayput.__version__))

    @router.get("/presets", response_model=replies.PresetsReply, responses=problems(503))
    async def all_presets() -> Response:
        """Return everything that can be chosen."""
        return await service.workers.run(lambda: json_response(presets(service.limits)))

    @router.post("/scenario/toml", **of_file(OF_BODY, "application/toml"))
    async def toml(body: requests.MeasuredRequest) -> Response:
        """Return a scene as a scenario file."""

        def work() -> Response:
            scenario = service.scene(body.scene, body.measures)
            return attachment(scene_toml(scenario, service.motions), "scenario.toml")

        return await service.workers.run(work)

    @router.post("/scenario/read", response_model=replies.SceneReply, responses=problems(*OF_BODY))
    async def read(body: requests.ReadRequest) -> Response:
        """Return a scenario file as a scene."""

        def work() -> Response:
            checked = service.scene(table_of_toml(body.toml, Path(body.name)))
            pieces = () if checked.alone else checked.names
            return json_response(replies.SceneReply(scene=checked.stated_keys(), pieces=list(pieces)))

        return await service.workers.run(work)


def _add_runs(router: APIRouter, service: Service) -> None:
    @router.post("/simulate", response_model=SimulateReply, responses=problems(*OF_BODY))
    async def simulate(request: Request, body: requests.RunRequest) -> Response:
        """Run a scene without and with measures, in the plane or in space; several pieces in space."""

        def work(_left: Stop) -> Response:
            reply = simulated(service.shaken(body.scene, body.measures), body.sample)
            reply.motion.name = service.motions.with_file_names(reply.motion.name)
            return json_response(reply)

        workers = service.slow if isinstance(body.scene.get("furniture"), list) else service.workers
        return await service.while_awaited(workers, request, work)

    @router.post("/simulate/csv", **of_file(OF_BODY, "text/csv"))
    async def simulate_csv(request: Request, body: requests.RunRequest, which: Which = "without") -> Response:
        """Run a scene without or with measures; return its histories at the record's samples."""

        def work(_left: Stop) -> Response:
            scenario = service.shaken(body.scene, body.measures)
            return attachment(run_csv(scenario, held=which == "with", sample=body.sample), f"run_{which}.csv")

        return await service.while_awaited(service.slow, request, work)

    films = ("text/html", "image/gif", "video/mp4")

    @router.post("/simulate/film", **of_file((*OF_BODY, 404, 409), *films))
    async def simulate_film(
        request: Request,
        body: requests.RunRequest,
        which: Which = "without",
        kind: Annotated[Literal["html", "gif", "mp4"], Query()] = "html",
        lang: Annotated[Language, Query()] = "en",
        seconds: Annotated[float | None, Query(ge=2.0, le=60.0, description="How much of it.")] = None,
        job: Annotated[str | None, Query(description="The job whose verdict stands in the film.")] = None,
    ) -> Response:
        """Run a scene without or with measures; return a page that plays it, a GIF, or an MP4."""
        note = "" if job is None else service.done(job)[1].sentence(lang)

        def work(left: Stop) -> Response:
            def go_on(*_frames: int) -> None:
                if left.is_set():
                    raise StoppedError

            content = film(
                service.shaken(body.scene, body.measures),
                kind,
                lang,
                service.limits,
                held=which == "with",
                sample=body.sample,
                seconds=seconds,
                note=note,
                named=service.motions.with_file_names,
                progress=go_on,
            )
            return attachment(content, f"run_{which}.{kind}")

        return await service.while_awaited(service.slow, request, work)

    @router.post("/shaking", response_model=replies.ShakingReply, responses=problems(*OF_BODY))
    async def strength(body: requests.SceneRequest) -> Response:
        """Return how strongly the ground shakes in a scene, as a JMA intensity with its scatter."""
        return await service.workers.run(lambda: json_response(shaking_reply(service.shaken(body.scene))))


def _add_jobs(router: APIRouter, service: Service) -> None:
    @router.post("/verify", status_code=202, response_model=JobReply, responses=problems(*OF_BODY, 429))
    async def start(body: requests.VerifyRequest) -> Response:
        """Begin a verification: it goes on as a job."""

        def prepare() -> tuple[Scenario, list[float], int]:
            scenario = service.lone_piece(body.scene, body.measures)
            extended = with_options(scenario, body.scene, body.compare_usual)
            levels = [float(level) for level in LEVELS if body.curves]
            return extended, levels, runs_of(extended, service.limits, len(levels))

        scenario, levels, runs = await service.workers.run(prepare)
        return service.begun(partial(verify, levels=levels), body, scenario, runs)

    @router.get("/jobs/{name}", response_model=JobReply, responses=problems(404, 422, 503))
    async def get_job(name: requests.Name) -> Response:
        """Return how a job stands, and its verdict once it is done."""
        job = service.jobs.get(name)
        return await service.workers.run(lambda: json_response(service.reply_of(job)))

    @router.delete("/jobs/{name}", response_model=JobReply, responses=problems(404, 422, 503))
    async def cancel_job(name: requests.Name) -> Response:
        """Stop a job; forget one that has ended."""
        job = service.jobs.cancel(name)
        return await service.workers.run(lambda: json_response(service.reply_of(job)))

    refusals = problems(*OF_BODY, 404, 409)

    @router.put("/jobs/{name}/everyday", response_model=EverydayReply, responses=refusals)
    async def put_everyday(name: requests.Name, body: requests.SceneRequest) -> Response:
        """Put another scene's everyday use into a verdict that is done, whose runs it has no part in."""
        service.verdict(name)
        scenario = await service.workers.run(service.lone_piece, body.scene)
        job, verdict = service.verdict(name)
        same = verdict.scenario.model_copy(update={"everyday": scenario.everyday})
        changed = replace(verdict, scenario=same)
        job.verdict, job.reports = changed, {}
        return await service.workers.run(lambda: json_response(everyday_reply(changed)))

    @router.get("/jobs/{name}/report", **of_file(OF_JOB, "text/html"))
    async def report(
        request: Request, name: requests.Name, lang: Annotated[Language, Query()] = "en"
    ) -> Response:
        """Return the report of a job: one HTML file."""
        job, verdict = service.done(name)
        reports = job.reports  # those of this verdict

        def work(_left: Stop) -> Response:
            if lang not in reports:
                reports[lang] = report_page(verdict, lang, service.motions)
            return attachment(reports[lang], "stayput_report.html")

        return await service.while_awaited(service.slow, request, work)

    @router.get("/jobs/{name}/csv", **of_file(OF_JOB, "text/csv"))
    async def table(name: requests.Name) -> Response:
        """Return the ranking of a job as a table."""
        _, verdict = service.done(name)
        file = "stayput_ranking.csv" if verdict.scenario.plan is None else "stayput_room.csv"
        return await service.workers.run(lambda: attachment(verdict.to_csv().encode(CSV_ENCODING), file))


def _add_motions(router: APIRouter, service: Service) -> None:
    @router.post(
        "/motions", status_code=201, response_model=replies.MotionReply, responses=problems(*OF_BODY, 429)
    )
    async def add(upload: Annotated[requests.Upload, Form(media_type="multipart/form-data")]) -> Response:
        """Upload a record; it is kept for a while under the id that is returned."""
        stored = await service.motions.add(upload)
        return await service.workers.run(lambda: json_response(service.motions.about(stored), 201))

    @router.get("/motions/{name}", response_model=replies.MotionReply, responses=problems(404, 422, 503))
    async def about(name: requests.Name, component: ComponentQuery = None) -> Response:
        """Return what is known of an uploaded motion."""
        stored = await service.motions.with_component(name, component)
        return await service.workers.run(lambda: json_response(service.motions.about(stored)))

    @router.get(
        "/motions/{name}/preview", response_model=replies.PreviewReply, responses=problems(404, 422, 503)
    )
    async def preview(name: requests.Name, component: ComponentQuery = None) -> Response:
        """Return the outline of an uploaded motion."""
        stored = await service.motions.with_component(name, component)
        return await service.workers.run(lambda: json_response(service.motions.preview(stored.motion)))

    refusals = problems(404, 409, 422)

    @router.delete("/motions/{name}", status_code=204, responses=refusals, response_class=Response)
    async def remove(name: requests.Name) -> Response:
        """Forget an uploaded motion."""
        service.motions.remove(name)
        return Response(status_code=204)
