"""The API's routes: each reads its request, computes on a worker's thread, and returns a response."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from fastapi import APIRouter, Depends, Form, Query, Request
from pydantic import Field
from starlette.responses import Response

import stayput
from stayput.app import messages  # noqa: TC001 - FastAPI reads the annotations
from stayput.app.downloads import KINDS, attachment, film, report_page, run_csv, scene_toml
from stayput.app.jobs import Job, StoppedError, Turn
from stayput.app.messages import RefusedError, Reply
from stayput.app.motions import MotionReply, PreviewReply
from stayput.app.presets import PresetsReply, presets
from stayput.app.running import ShakingReply, SimulateReply, shaking_reply, simulated
from stayput.app.service import OF_BODY, OF_JOB, Service, json_response, of_file, problems
from stayput.app.verification import EverydayReply, JobReply, everyday_reply, runs_of, with_options
from stayput.catalogue import LANGUAGES, Language
from stayput.errors import InputError
from stayput.files import CSV_ENCODING
from stayput.report.room.card import plan_html
from stayput.rooms.planning import action_plan
from stayput.rooms.steps import ActionPlan, Home, changes_between
from stayput.scenario.toml import table_of_toml
from stayput.verification import Verdict, verify

if TYPE_CHECKING:
    from stayput.execution import Stop
    from stayput.scenario import Scenario

ComponentQuery = Annotated[str | None, Query(max_length=60, description="Channel that is to be x.")]

Which = Annotated[Literal["without", "with"], Query()]
"""Which run of a scene is meant, without or with the measures."""

AskedHome = Annotated[Home, Depends()]
"""What the home of a plan is like, by the query."""


class PingReply(Reply):
    """Whether the server is there."""

    status: Literal["ok"] = "ok"
    ready: bool = Field(description="Whether everything is compiled.")
    version: str


class SceneReply(Reply):
    """A scenario file as a scene."""

    scene: dict[str, Any]
    pieces: list[str] = Field(description="What its pieces are called, where it is of several; else none.")


class PlanProgressReply(Reply):
    """How far a plan to buy and do has come."""

    made: bool = Field(description="Whether it is there, and comes at once.")
    runs: int = Field(description="Runs of pieces made for it so far.")


def api(service: Service) -> APIRouter:
    """Return the routes under /api/v1."""
    router = APIRouter(prefix="/api/v1")
    parts = {"general": _add_general, "runs": _add_runs, "verification": _add_jobs, "motions": _add_motions}
    for tag, add in parts.items():
        routes = APIRouter(tags=[tag])
        add(routes, service)
        router.include_router(routes)
    return router


def _add_general(router: APIRouter, service: Service) -> None:
    @router.get("/ping", response_model=PingReply)
    async def ping() -> Response:
        """Say whether the server is there."""
        return json_response(PingReply(ready=service.ready, version=stayput.__version__))

    @router.get("/presets", response_model=PresetsReply, responses=problems(503))
    async def all_presets() -> Response:
        """Return everything that can be chosen."""
        return await service.workers.run(lambda: json_response(presets(service.limits)))

    @router.post("/scenario/toml", **of_file(OF_BODY, "application/toml"))
    async def toml(body: messages.MeasuredRequest) -> Response:
        """Return a scene as a scenario file."""

        def work() -> Response:
            scenario = service.scene(body.scene, body.measures)
            return attachment(scene_toml(scenario, service.motions), "scenario.toml")

        return await service.workers.run(work)

    @router.post("/scenario/read", response_model=SceneReply, responses=problems(*OF_BODY))
    async def read(body: messages.ReadRequest) -> Response:
        """Return a scenario file as a scene."""

        def work() -> Response:
            checked = service.scene(table_of_toml(body.toml, Path(body.name)))
            pieces = () if checked.alone else checked.names
            return json_response(SceneReply(scene=checked.stated_keys(), pieces=list(pieces)))

        return await service.workers.run(work)


def _add_runs(router: APIRouter, service: Service) -> None:
    @router.post("/simulate", response_model=SimulateReply, responses=problems(*OF_BODY))
    async def simulate(request: Request, body: messages.RunRequest) -> Response:
        """Run a scene without and with measures, in the plane or in space; several pieces in space."""

        def work(_left: Stop) -> Response:
            reply = simulated(service.shaken(body.scene, body.measures), body.sample)
            reply.motion.name = service.motions.with_file_names(reply.motion.name)
            return json_response(reply)

        workers = service.slow if isinstance(body.scene.get("furniture"), list) else service.workers
        return await service.while_awaited(workers, request, work)

    @router.post("/simulate/csv", **of_file(OF_BODY, "text/csv"))
    async def simulate_csv(request: Request, body: messages.RunRequest, which: Which = "without") -> Response:
        """Run a scene without or with measures; return its histories at the record's samples."""

        def work(_left: Stop) -> Response:
            scenario = service.shaken(body.scene, body.measures)
            return attachment(run_csv(scenario, held=which == "with", sample=body.sample), f"run_{which}.csv")

        return await service.while_awaited(service.slow, request, work)

    films = ("text/html", "image/gif", "video/mp4")

    @router.post("/simulate/film", **of_file((*OF_BODY, 404, 409), *films))
    async def simulate_film(
        request: Request,
        body: messages.RunRequest,
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

    @router.post("/shaking", response_model=ShakingReply, responses=problems(*OF_BODY))
    async def strength(body: messages.SceneRequest) -> Response:
        """Return how strongly the ground shakes in a scene, as a JMA intensity with its scatter."""
        return await service.workers.run(lambda: json_response(shaking_reply(service.shaken(body.scene))))


def _add_jobs(router: APIRouter, service: Service) -> None:
    @router.post("/verify", status_code=202, response_model=JobReply, responses=problems(*OF_BODY, 429))
    async def start(body: messages.VerifyRequest) -> Response:
        """Begin a verification: it goes on as a job."""

        def prepare() -> tuple[Scenario, int]:
            scenario = service.lone_piece(body.scene, body.measures)
            extended = with_options(scenario, body.scene, body.compare_usual)
            return extended, runs_of(extended, service.limits)

        scenario, runs = await service.workers.run(prepare)
        return service.begun(partial(verify, levels=None if body.curves else []), body, scenario, runs)

    @router.post("/room", status_code=202, response_model=JobReply, responses=problems(*OF_BODY, 429))
    async def start_room(body: messages.RoomRequest) -> Response:
        """Begin the verification of a room: it goes on as a job, whose result gets better while it runs."""

        def prepare() -> tuple[Scenario, int, Scenario | None]:
            scenario = service.room(body.scene)
            runs = runs_of(scenario, service.limits)
            return scenario, runs, None if body.before is None else service.before(body.before, scenario)

        scenario, runs, before = await service.workers.run(prepare)
        return service.begun(partial(verify, changes=body.changes), body, scenario, runs, before)

    @router.get("/jobs/{name}", response_model=JobReply, responses=problems(404, 422, 503))
    async def get_job(name: messages.Name) -> Response:
        """Return how a job stands, and its verdict once it is done."""
        job = service.jobs.get(name)
        return await service.workers.run(lambda: json_response(service.reply_of(job)))

    @router.delete("/jobs/{name}", response_model=JobReply, responses=problems(404, 422, 503))
    async def cancel_job(name: messages.Name) -> Response:
        """Stop a job; forget one that has ended."""
        job = service.jobs.cancel(name)
        return await service.workers.run(lambda: json_response(service.reply_of(job)))

    refusals = problems(*OF_BODY, 404, 409)

    @router.put("/jobs/{name}/everyday", response_model=EverydayReply, responses=refusals)
    async def put_everyday(name: messages.Name, body: messages.SceneRequest) -> Response:
        """Put another scene's everyday use into a verdict that is done, whose runs it has no part in."""
        service.done(name, of_room=False)
        scenario = await service.workers.run(service.lone_piece, body.scene)
        job, verdict = service.done(name, of_room=False)
        same = verdict.scenario.model_copy(update={"everyday": scenario.everyday})
        changed = replace(verdict, scenario=same)
        job.verdict, job.reports = changed, {}
        return await service.workers.run(lambda: json_response(everyday_reply(changed)))

    @router.get("/jobs/{name}/report", **of_file(OF_JOB, "text/html"))
    async def report(
        request: Request, name: messages.Name, lang: Annotated[Language, Query()] = "en"
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
    async def table(name: messages.Name) -> Response:
        """Return the ranking of a job as a table."""
        _, verdict = service.done(name)
        file = "stayput_ranking.csv" if verdict.scenario.plan is None else "stayput_room.csv"
        return await service.workers.run(lambda: attachment(verdict.to_csv().encode(CSV_ENCODING), file))

    _add_plans(router, service)


def _add_plans(router: APIRouter, service: Service) -> None:
    @router.get("/jobs/{name}/plan", **of_file(OF_JOB, "text/html"))
    async def plan(
        request: Request, name: messages.Name, home: AskedHome, lang: Annotated[Language, Query()] = "en"
    ) -> Response:
        """Return what to buy and do in the room of a job: one page to print."""
        job, verdict = service.done(name, of_room=True)
        reports, key = job.reports, f"{lang} {home}"

        def work(left: Stop) -> Response:
            def note_progress(runs: int) -> None:
                job.plan_runs[str(home)] += runs
                turn.go_on()

            if key not in reports:
                job.plan_runs[str(home)] = 0
                with Turn(service.turns, lambda: not left.is_set(), job.client.address) as turn:
                    made = _plan(job, verdict, home, service.limits.threads, note_progress)
                for language in LANGUAGES:  # the page's language may be changed
                    reports[f"{language} {home}"] = plan_html(made, language).encode("utf-8")
            return Response(reports[key], headers=KINDS[".html"])

        return await service.while_awaited(service.planners, request, work)

    refusals = problems(404, 409, 422)

    @router.get("/jobs/{name}/plan/progress", response_model=PlanProgressReply, responses=refusals)
    async def progress(name: messages.Name, home: AskedHome) -> Response:
        """Return how far a plan has come that another request is waiting for, or whether it is there."""
        job, _ = service.done(name, of_room=True)
        made = f"{LANGUAGES[0]} {home}" in job.reports
        return json_response(PlanProgressReply(made=made, runs=job.plan_runs.get(str(home), 0)))


def _plan(
    job: Job, verdict: Verdict, home: Home, threads: int | None, on_progress: Callable[[int], None]
) -> ActionPlan:
    """Return the plan of a room; changes that are tried in it are its steps.

    Raises
    ------
    RefusedError
        The room cannot have been as it is said to have been before these changes.
    """
    before = home.of(verdict.scenario if job.before is None else job.before)
    try:
        return action_plan(
            replace(verdict, scenario=before),
            decided=changes_between(before, verdict.scenario),
            **asdict(home),
            threads=threads,
            progress=False,
            on_progress=on_progress,
        )
    except InputError as error:
        if job.before is None:
            raise
        sentences = error.told("en"), error.told("ja")
        raise RefusedError(422, InputError("app.before_refused", "before", why=sentences)) from None


def _add_motions(router: APIRouter, service: Service) -> None:
    @router.post("/motions", status_code=201, response_model=MotionReply, responses=problems(*OF_BODY, 429))
    async def add(upload: Annotated[messages.Upload, Form(media_type="multipart/form-data")]) -> Response:
        """Upload a record; it is kept for a while under the id that is returned."""
        stored = await service.motions.add(upload)
        return await service.workers.run(lambda: json_response(service.motions.about(stored), 201))

    @router.get("/motions/{name}", response_model=MotionReply, responses=problems(404, 422, 503))
    async def about(
        name: messages.Name,
        component: ComponentQuery = None,
        across: messages.FurtherName = None,
        vertical: messages.FurtherName = None,
    ) -> Response:
        """Return what is known of an uploaded motion, with the components that other uploads hold."""
        motions, stored = service.motions, await service.motions.with_component(name, component)

        def work() -> Response:
            return json_response(motions.about(motions.joined(stored, across=across, vertical=vertical)))

        return await service.workers.run(work)

    @router.get("/motions/{name}/preview", response_model=PreviewReply, responses=problems(404, 422, 503))
    async def preview(name: messages.Name, component: ComponentQuery = None) -> Response:
        """Return the outline of an uploaded motion."""
        stored = await service.motions.with_component(name, component)
        return await service.workers.run(lambda: json_response(service.motions.preview(stored.motion)))

    refusals = problems(404, 409, 422)

    @router.delete("/motions/{name}", status_code=204, responses=refusals, response_class=Response)
    async def remove(name: messages.Name) -> Response:
        """Forget an uploaded motion."""
        service.motions.remove(name)
        return Response(status_code=204)
