"""Routes of the charts that a reader keeps."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any

from fastapi import Path as InPath
from fastapi import Query
from starlette.responses import Response

from stayput.app.downloads import attachment
from stayput.app.figures import FigureKind, FigureName, map_figure, run_figure, verdict_figure
from stayput.app.requests import (  # noqa: TC001 - FastAPI reads the annotations
    Name,
    SimulateRequest,
    SizeMapRequest,
)
from stayput.app.service import Service, problems
from stayput.app.size_map import size_map
from stayput.catalogue import Language
from stayput.report.charts.chart import KINDS

if TYPE_CHECKING:
    from fastapi import APIRouter

    from stayput.report.charts.chart import Chart

ChartKind = Annotated[FigureKind, Query(description="A picture with its caption, or the numbers.")]
Spoken = Annotated[Language, Query()]


def add_figures(router: APIRouter, service: Service) -> None:
    """Add the routes."""
    content: dict[int | str, dict[str, Any]] = {
        200: {"content": {media.partition(";")[0]: {} for media in KINDS.values()}}
    }
    refusals = {**content, **problems(400, 413, 422, 503)}

    @router.post("/simulate/figure", response_class=Response, tags=["runs"], responses=refusals)
    async def run_figures(body: SimulateRequest, kind: ChartKind = "svg", lang: Spoken = "en") -> Response:
        """Run a scene without and with measures; return its histories as a chart to keep."""

        def work() -> Response:
            scenario = service.shaken(body.scene, body.measures)
            return _file(run_figure(scenario, lang, service.motions.named), "histories", kind)

        return await service.slow.run(work)

    @router.post("/size-map/figure", response_class=Response, tags=["runs"], responses=refusals)
    async def map_figures(body: SizeMapRequest, kind: ChartKind = "svg", lang: Spoken = "en") -> Response:
        """Return the map of sizes as a chart to keep."""

        def work() -> Response:
            scenario = service.scene(body.scene, body.measures)
            reply = size_map(scenario, body.axis, service.limits.threads)
            return _file(map_figure(scenario, reply, lang, service.motions.named), "size_map", kind)

        return await service.slow.run(work)

    @router.get(
        "/jobs/{job}/figures/{figure}.{kind}",
        response_class=Response,
        tags=["verification"],
        responses={**content, **problems(404, 409, 422, 503)},
    )
    async def job_figures(
        job: Name,
        figure: Annotated[FigureName, InPath()],
        kind: Annotated[FigureKind, InPath()],
        lang: Spoken = "en",
    ) -> Response:
        """Return a chart of a job's verdict, to keep; curves only of a job that made them."""
        _, verdict = service.verdict(job)

        def work() -> Response:
            return _file(verdict_figure(verdict, figure, lang, service.motions.named), figure, kind)

        return await service.slow.run(work)


def _file(chart: Chart, name: str, kind: FigureKind) -> Response:
    return attachment(chart.file(kind), f"stayput_{name}.{kind}", KINDS[kind])
