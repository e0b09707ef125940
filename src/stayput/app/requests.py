"""What the server is asked."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from stayput.app.fields import Measures, Request, SceneData


class SimulateRequest(Request):
    """One scene, run without and with measures."""

    scene: SceneData
    measures: Measures


class SizeMapRequest(Request):
    """A scene whose piece is made larger and smaller, and shaken more and less."""

    scene: SceneData
    measures: Measures
    axis: Literal["height", "width", "size"] = Field(
        default="height", description="What grows: the height, the depth, or both."
    )


class VerifyRequest(Request):
    """A scene to be verified."""

    scene: SceneData
    measures: Measures
    compare_usual: bool = Field(default=True, description="Whether the usual measures are compared too.")
    slide_limit_m: float = Field(default=0.10, ge=0.0, le=100.0, description="Slide that counts as too far.")
    curves: bool = Field(default=True, description="Whether fragility curves are made, which takes longer.")
    lease_s: float | None = Field(
        default=None,
        ge=1.0,
        le=3600.0,
        description="The job ends when nobody has asked for it for so long; null: it goes on to its end.",
    )


class TomlRequest(Request):
    """A scene to be written as a scenario file."""

    scene: SceneData
    measures: Measures
