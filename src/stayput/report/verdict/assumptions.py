"""What a verdict rests on, each with how well founded it is."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from stayput.furniture import FURNITURE
from stayput.report.verdict.words import named, place, word
from stayput.uncertainty import USUAL, Lognormal, Normal, Uniform

if TYPE_CHECKING:
    from collections.abc import Iterator

    from stayput.room import Floor
    from stayput.scenario import Scenario
    from stayput.uncertainty import Marginal
    from stayput.verification import Verdict

GIVEN, MODEL = "given", "model"
"""Tags beside those of `stayput.uncertainty.Confidence`: said by the user; a limit of the model."""


@dataclass(frozen=True, slots=True)
class Assumption:
    """One thing that a verdict rests on.

    Parameters
    ----------
    texts : tuple
        What it is and its value, in English and in Japanese.
    confidence : str
        "low", "medium", "high", "given" or "model".
    """

    texts: tuple[tuple[str, str], tuple[str, str]]
    confidence: str

    def what(self, language: str) -> str:
        """Return what it is."""
        return self.texts[0][place(language)]

    def value(self, language: str) -> str:
        """Return its value."""
        return self.texts[1][place(language)]


QUANTITIES = {
    "friction factor": ("Friction, factor on its value", "摩擦係数に掛ける倍率"),
    "restitution factor": ("Rebound of the rocking, factor", "ロッキングの反発に掛ける倍率"),
    "wall restitution": ("Restitution of the walls", "壁の反発係数"),
    "mass factor": ("Mass, factor on its value", "質量に掛ける倍率"),
    "height of gravity factor": ("Height of the centre of gravity, factor", "重心の高さに掛ける倍率"),
    "device strength factor": ("Strength of the devices, factor", "器具の強さに掛ける倍率"),
}
"""What is drawn, in words."""

LIMITS = (
    (
        ("Rigid body in a plane", "平面内の剛体"),
        (
            (
                "No shaking across the piece, no turning about its vertical axis, no bending; contents do "
                "not fall out, doors stay shut."
            ),
            "奥行方向以外の水平動、水平面内の回転、家具の変形、中身の飛び出しや扉の開きは考慮しません。",
        ),
    ),
    (
        ("Contacts", "接触"),
        (
            (
                "Coulomb friction; a landing corner does not bounce, and rocking loses what the momentum "
                "balance demands (Housner)."
            ),
            "クーロン摩擦。着地した角は跳ね返らず、ロッキングは運動量のつり合い（ハウスナー）に従って減衰します。",
        ),
    ),
    (
        ("Devices", "器具"),
        (
            "Springs with slack, damping and a strength; age, dirt and faulty mounting are not in it.",
            "がた・減衰・強さをもつばねです。経年劣化、汚れ、取付け不良は含みません。",
        ),
    ),
)
"""What the model leaves out."""


def assumptions(verdict: Verdict) -> list[Assumption]:
    """Return what a verdict rests on, apart from the parameters of the measures."""
    scenario = verdict.scenario
    return [
        _furniture(scenario),
        _floor(scenario),
        *_walls(scenario),
        _motions(scenario, verdict.motions),
        *([] if scenario.shaking.building is None else [_building(scenario)]),
        *(_drawn(name, marginal) for name, marginal in USUAL.items()),
        *(Assumption(texts, MODEL) for texts in LIMITS),
    ]


def _both(key: str) -> tuple[str, str]:
    return word(key, "en"), word(key, "ja")


def _furniture(scenario: Scenario) -> Assumption:
    table, body = scenario.furniture, scenario.furniture.body()
    x, z = body.centre_of_gravity
    sizes = f"{body.width:g} m × {body.height:g} m, {body.mass:.4g} kg"
    told = (
        f"{sizes}, centre of gravity {z:.3g} m up" + (f", {x:+.3g} m forward" if x else ""),
        f"{sizes}、重心の高さ {z:.3g} m" + (f"、前方へ {x:+.3g} m" if x else ""),
    )
    said = [table.width, table.height, table.mass if table.shelves is None else table.shelves]
    known = table.preset not in FURNITURE or all(value is not None for value in said)
    return Assumption((_both("piece"), told), GIVEN if known else "low")


def _floor(scenario: Scenario) -> Assumption:
    floor, table = scenario.room.room().floor, scenario.room.floor
    surface = table if isinstance(table, str) else table.surface
    return Assumption((_both("floor"), _frictions(floor, surface)), GIVEN if surface is None else "medium")


def _frictions(floor: Floor, surface: str | None) -> tuple[str, str]:
    static, kinetic = floor.static_friction, floor.kinetic_friction
    names = [""] * 2 if surface is None else [f"{surface}: ", f"{named(surface, 'ja')}："]
    return (
        f"{names[0]}static friction {static:g}, kinetic {kinetic:g}",
        f"{names[1]}静止摩擦係数 {static:g}、動摩擦係数 {kinetic:g}",
    )


def _walls(scenario: Scenario) -> Iterator[Assumption]:
    room = scenario.room.room()
    for key, wall in (("wall", room.left_wall), ("front wall", room.right_wall)):
        if wall is not None:
            gap = f"{100.0 * wall.gap:.3g} cm"
            yield Assumption((_both(key), (f"{gap} away", f"すき間 {gap}")), GIVEN)
    if room.ceiling is not None:
        high = f"{room.ceiling.height:g} m"
        yield Assumption((_both("ceiling"), (f"{high} high", f"高さ {high}")), GIVEN)


def _motions(scenario: Scenario, count: int) -> Assumption:
    shaking = scenario.shaking
    if shaking.record is not None or isinstance(shaking.suite, str):
        name = shaking.record or shaking.suite
        return Assumption(
            (_both("motions"), (f"{count}, read from {name}", f"{count}本（{name}から読込み）")), GIVEN
        )
    if shaking.of_a_suite:
        family = "mixed" if shaking.suite is None else shaking.suite.family
        told = (
            f"{count} synthetic ones ({family}): computed, not recorded",
            f"模擬地震動{count}本（{named(family, 'ja')}）：計算で作ったもので、観測記録ではありません",
        )
        return Assumption((_both("motions"), told), "low")
    name = "sine" if shaking.sine is not None else "near-fault"
    told = (
        f"{name}, synthetic: computed, not recorded",
        f"{named(name, 'ja')}（模擬）：観測記録ではありません",
    )
    return Assumption((_both("motions"), told), GIVEN if shaking.sine is not None else "low")


def _building(scenario: Scenario) -> Assumption:
    table = scenario.shaking.building
    assert table is not None
    name, storey = table.building().name, scenario.shaking.storey
    told = (
        f"{name}, floor of storey {storey}, as a shear model",
        f"{name}、{storey}階の床（せん断質点系モデル）",
    )
    return Assumption((_both("building"), told), GIVEN if table.masses is not None else "low")


def _drawn(name: str, marginal: Marginal) -> Assumption:
    return Assumption((QUANTITIES[name], _distribution(marginal)), marginal.confidence.value)


def _distribution(marginal: Marginal) -> tuple[str, str]:
    """Return a distribution in words."""
    match marginal:
        case Lognormal():
            return (
                f"lognormal, median {marginal.median:g}, coefficient of variation {marginal.cov:g}",
                f"対数正規分布、中央値 {marginal.median:g}、変動係数 {marginal.cov:g}",
            )
        case Normal():
            return (
                f"normal, mean {marginal.mean:g}, standard deviation {marginal.deviation:g}",
                f"正規分布、平均 {marginal.mean:g}、標準偏差 {marginal.deviation:g}",
            )
        case Uniform():
            return (
                f"uniform, {marginal.low:g} to {marginal.high:g}",
                f"一様分布、{marginal.low:g}〜{marginal.high:g}",
            )
        case _:
            raise TypeError(type(marginal).__name__)
