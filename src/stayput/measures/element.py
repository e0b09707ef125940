"""Force elements of measures in newtons, the rows that the mechanics read, and what became of each."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from stayput.catalogue import Phrase, phrase
from stayput.mechanics.devices import columns
from stayput.model.state import State, standing_corners

if TYPE_CHECKING:
    from collections.abc import Sequence

    from stayput.measures.measure import Held
    from stayput.model.body import Body


EDGE = 0.03
"""Nearest to an end of a piece that something is screwed to its top [m]: a bracket is 40 mm wide."""


@dataclass(frozen=True, slots=True)
class Line:
    """A spring with a damper, slack and strength, along the normal or the tangent of an element.

    Parameters
    ----------
    stiffness : float
        k [N/m]; 0 where there is no such line.
    damping : float
        c [N s/m].
    slack_plus, slack_minus : float
        Elongation at which it pulls and shortening at which it pushes [m]; inf: never, negative: preload.
    limit_plus, limit_minus : float
        Strength in pull and in push, or to either side of the tangent [N].
    ultimate : float
        Plastic elongation at which it parts [m], or of a tangent with friction, how far from where it was it
        slips before it is lost; 0 is brittle, with friction never.
    weakest : Phrase, optional
        What happens at its strength.
    """

    stiffness: float = 0.0
    damping: float = 0.0
    slack_plus: float = math.inf
    slack_minus: float = math.inf
    limit_plus: float = math.inf
    limit_minus: float = math.inf
    ultimate: float = 0.0
    weakest: Phrase | None = None

    def shared(self, count: int) -> Line:
        """Return the part of it that each of several like devices is."""
        return replace(
            self,
            stiffness=self.stiffness / count,
            damping=self.damping / count,
            limit_plus=self.limit_plus / count,
            limit_minus=self.limit_minus / count,
        )


@dataclass(frozen=True, slots=True)
class Element:
    """A force between a point of the body and a place in the room.

    Parameters
    ----------
    kind : str
        The measure that it belongs to.
    point : tuple of float
        Where it holds the body, right of the middle of its base and up, in the body's axes [m].
    normal : Line
        Along the line to the anchor, or at right angles to the plane.
    tangent : Line
        Along the plane.
    to_anchor : tuple of float, optional
        From the point at rest to the anchor, right and up [m]; then the force is along the line between them.
    facing : tuple of float, optional
        The normal of the plane, into the room; then the plane goes through the point at rest.
    place : str
        Tells it from others of the same measure: "front".
    friction : float
        The tangent slips at this times the push; nan: it does not.
    interaction : bool
        Whether it fails where (pull/strength)² + (shear/strength)² reaches 1.
    drops_out : bool
        Whether it is gone for good once it pushes no more.
    count : int
        How many like devices it stands for, side by side along the length of the piece.
    inset : float
        How far the outermost of them are from the ends of the length [m]; nan: each in the middle of an equal
        part of it, two at the quarter points.
    across : float
        Where it is along the length, from the middle [m].
    pitches : tuple of float
        Usual distances between what alone it may be fixed to along the length [m]; none: it may be anywhere.

    Examples
    --------
    >>> from stayput.measures import Belt, hold
    >>> import stayput as sp
    >>> held = hold(sp.Body(0.4, 1.8, 80.0), sp.Room(left_wall=sp.Wall(0.05)), [Belt()])
    >>> element = held.elements[0]
    >>> element.kind, element.point
    ('belt', (-0.1, 1.8))
    """

    kind: str
    point: tuple[float, float]
    normal: Line
    tangent: Line = Line()
    to_anchor: tuple[float, float] | None = None
    facing: tuple[float, float] | None = None
    place: str = ""
    friction: float = math.nan
    interaction: bool = False
    drops_out: bool = False
    count: int = 1
    inset: float = math.nan
    across: float = 0.0
    pitches: tuple[float, ...] = ()

    @property
    def rise(self) -> float:
        """How far its anchor is above the point where it holds the body at rest [m]; 0 on a plane."""
        return 0.0 if self.to_anchor is None else self.to_anchor[1]

    def unbreakable(self) -> Element:
        """Return it with the same stiffness, but no strength that it could reach, and never lost."""
        normal, tangent = (
            replace(line, limit_plus=math.inf, limit_minus=math.inf, ultimate=0.0, weakest=None)
            for line in (self.normal, self.tangent)
        )
        return replace(self, normal=normal, tangent=tangent, drops_out=False)

    def spread(self, length: float) -> tuple[Element, ...]:
        """Return the devices that it stands for, one by one, along a length [m].

        On studs, whose places are not known, they are as far apart as a multiple of a usual distance that
        comes next to equal parts; in equal parts too where they are more than there are studs.
        """
        n = self.count
        if math.isnan(self.inset):
            equal, most = length / n, (length - 2.0 * EDGE) / max(1, n - 1)
            fitting = (times * pitch for pitch in self.pitches for times in range(1, int(most / pitch) + 1))
            apart = min(fitting, key=lambda distance: abs(distance - equal), default=equal)
            places = [(i - 0.5 * (n - 1)) * apart for i in range(n)]
        else:
            reach = max(0.0, 0.5 * length - self.inset)
            places = [reach * (2.0 * i / (n - 1) - 1.0) if n > 1 else 0.0 for i in range(n)]
        names = {1: ("",), 2: ("left", "right")}.get(n, tuple(f"{i + 1}" for i in range(n)))
        normal, tangent = self.normal.shared(n), self.tangent.shared(n)
        return tuple(
            replace(
                self,
                normal=normal,
                tangent=tangent,
                count=1,
                across=place,
                place=f"{self.place} {name}".strip(),
            )
            for place, name in zip(places, names, strict=True)
        )

    def row(self, body: Body, factor: float) -> tuple[object, ...]:
        """Return it as a row of ELEMENT: forces per unit mass of a body, places relative to G.

        Parameters
        ----------
        body : Body
            The body that it holds.
        factor : float
            Factor on its strengths; friction is not one.
        """
        (x_g, z_g), (right, up), m = body.centre_of_gravity, self.point, body.mass
        lines = self.normal, self.tangent
        x = z = math.nan
        cos, sin, length = 1.0, 0.0, 0.0
        if self.to_anchor is not None:
            x, z = at_rest(body, self.point)
            x, z = x + self.to_anchor[0], z + self.to_anchor[1]
            length = math.hypot(*self.to_anchor)
        elif self.facing is not None:
            cos, sin = self.facing[1], -self.facing[0]
        return (
            columns.AXIAL if self.to_anchor is not None else columns.PLANAR,
            right - x_g,
            up - z_g,
            self.across,
            x,
            z,
            cos,
            sin,
            length,
            [line.stiffness / m for line in lines],
            [line.damping / m for line in lines],
            [line.slack_plus for line in lines],
            [line.slack_minus for line in lines],
            [factor * line.limit_plus / m for line in lines],
            [factor * line.limit_minus / m for line in lines],
            [line.ultimate for line in lines],
            self.friction,
            int(self.interaction),
            int(self.drops_out),
        )


def spacing(elements: Sequence[Element], length: float) -> Phrase:
    """Return how far devices are apart along a length, and from its ends [m]."""
    if len(elements) < 2:
        return phrase("measures.in_the_middle")
    places = sorted(element.across for element in elements)
    return phrase("measures.apart", apart=places[1] - places[0], edge=0.5 * length - places[-1])


def on_studs(elements: Sequence[Element]) -> Phrase:
    """Return how devices on a wall come to stand on studs; nothing where they may stand anywhere."""
    if not elements[0].pitches:
        return "", ""
    if len(elements) < 2:
        return phrase("measures.on_one_stud")
    apart = abs(elements[1].across - elements[0].across)
    on = [pitch for pitch in elements[0].pitches if abs(math.remainder(apart, pitch)) < 1e-9]
    return phrase("measures.on_studs", pitch=1e3 * on[0]) if on else phrase("measures.on_a_strip")


def damper(ratio: float, stiffness: float, mass: float) -> float:
    """Return the damping that is a ratio of the critical one of the body's mass on a spring [N s/m]."""
    return 2.0 * ratio * math.sqrt(stiffness * mass)


def at_rest(body: Body, point: tuple[float, float]) -> tuple[float, float]:
    """Return where a point of the body is in the room at rest: right of the middle of the base, and up [m].

    Parameters
    ----------
    body : Body
        The body.
    point : tuple of float
        Right of the middle of its base and up, in the body's axes [m].
    """
    x, z = standing_corners(body, State())[0]
    right = point[0] + body.width / 2 - body.base_insets[0]
    up = point[1] - body.base_heights[0]
    sin, cos = math.sin(body.resting_tilt), math.cos(body.resting_tilt)
    return x + right * cos + up * sin, z + up * cos - right * sin


CAUSES: dict[int, str | None] = {
    columns.HOLDS: None,
    columns.PULLED: "pulled off",
    columns.PUSHED: "pushed in",
    columns.SHEARED: "sheared off",
    columns.DRAWN_OUT: "drawn out",
    columns.DROPPED_OUT: "dropped out",
}
"""Why a device failed, by the mechanics' numbers; None: it holds."""


@dataclass(frozen=True, slots=True, eq=False)
class DeviceResult:
    """What became of one device, which is one element of a measure.

    Attributes
    ----------
    kind : str
        The measure that it belongs to.
    label : tuple of str
        What it is called, in English and Japanese.
    place : str
        Tells it from others of the same measure: "front".
    peak_pull, peak_push, peak_shear : float
        Largest forces that it bore at any time [N]: until it failed, if it did. What was asked of it is that
        of the same device which cannot fail: `stayput.measures.Measure.unbreakable`.
    utilisation : float
        Largest peak force over its strength; at least 1 where it failed, 0 where it has no strength to reach.
    failed : bool
        Whether it is gone for good.
    failure_time : float
        When it failed [s], or nan.
    cause : str or None
        Why it failed.
    pull, shear : ndarray of float64, shape [samples]
        Forces along its normal, + where it pulls, and along its tangent, at the samples of the run [N].
    weakest : Phrase or None
        What gave way, or what would first where it holds: "the screws pull out of the plasterboard"; None
        where nothing can.
    member : int or None
        The number of the piece that it holds, in an assembly; None of a joint.
    between : tuple of int or None
        The numbers of the bodies that a joint joins.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import Belt
    >>> room = sp.Room(left_wall=sp.Wall(0.02))
    >>> run = sp.simulate(sp.Body(0.3, 1.8, 90.0), room, sp.near_fault(), [Belt()])
    >>> device = run.devices[0]
    >>> device.label[0], device.failed, device.peak_pull > 0.0
    ('Belts', False, True)
    """

    kind: str
    label: tuple[str, str]
    place: str
    peak_pull: float
    peak_push: float
    peak_shear: float
    utilisation: float
    failed: bool
    failure_time: float
    cause: str | None
    pull: NDArray[np.float64]
    shear: NDArray[np.float64]
    weakest: Phrase | None = None
    member: int | None = None
    between: tuple[int, int] | None = None


def utilisation(elements: NDArray[np.void], devices: NDArray[np.void]) -> NDArray[np.float64]:
    """Return the largest peak force over its strength, of any shape; at least 1 where a device failed.

    Parameters
    ----------
    elements : ndarray of ELEMENT
        The devices.
    devices : ndarray of DEVICE
        What became of them.
    """
    shear = np.minimum(
        elements["limit_plus"][..., columns.TANGENT], elements["limit_minus"][..., columns.TANGENT]
    )
    pairs = (
        (devices["peak_pull"], elements["limit_plus"][..., columns.NORMAL]),
        (devices["peak_push"], elements["limit_minus"][..., columns.NORMAL]),
        (devices["peak_shear"], shear),
    )
    used = np.zeros(devices.shape)
    for peak, strength in pairs:
        used = np.maximum(used, np.divide(peak, strength, out=np.zeros_like(used), where=strength > 0.0))
    return np.where(devices["failure"] != columns.HOLDS, np.maximum(used, 1.0), used)


def weakest(element: Element, devices: NDArray[np.void]) -> Phrase | None:
    """Return what gave way most often in runs with a device, or where it held, what was used most.

    Parameters
    ----------
    element : Element
        The device.
    devices : ndarray of DEVICE, shape [m]
        What became of it; forces of any one unit.
    """
    failed = devices[devices["failure"] != columns.HOLDS]
    counted = failed if failed.size else devices
    dropped = np.count_nonzero(counted["failure"] == columns.DROPPED_OUT)
    if 2 * dropped > counted.size:
        return phrase("measures.drops_out")
    normal, tangent = element.normal, element.tangent
    along = np.maximum(counted["peak_pull"] / normal.limit_plus, counted["peak_push"] / normal.limit_minus)
    across = counted["peak_shear"] / min(tangent.limit_plus, tangent.limit_minus)
    line = tangent if 2 * np.count_nonzero(across > along) > counted.size else normal
    return line.weakest


def failed(elements: NDArray[np.void], devices: NDArray[np.void]) -> NDArray[np.bool_]:
    """Return which devices failed, of any shape; those that only pad the rows of a case did not."""
    return (devices["failure"] != columns.HOLDS) & (elements["kind"] != columns.NONE)


def device_result(
    called: tuple[str, Phrase, str],
    device: np.void,
    used: float,
    forces: NDArray[np.float64],
    mass: float = 1.0,
    **more: Any,
) -> DeviceResult:
    """Return what became of a device with this kind, label and place; see `device_results`."""
    return DeviceResult(
        *called,
        mass * float(device["peak_pull"]),
        mass * float(device["peak_push"]),
        mass * float(device["peak_shear"]),
        float(used),
        int(device["failure"]) != columns.HOLDS,
        float(device["failure_time"]),
        CAUSES[int(device["failure"])],
        mass * forces[:, columns.F_NORMAL],
        mass * forces[:, columns.F_TANGENT],
        **more,
    )


def device_results(
    held: Held,
    elements: NDArray[np.void],
    devices: NDArray[np.void],
    forces: NDArray[np.float64],
    mass: float,
    member: int | None = None,
) -> tuple[DeviceResult, ...]:
    """Name what the mechanics returned in numbers.

    Parameters
    ----------
    held : Held
        The body and its devices.
    elements, devices : ndarray, shape [n]
        The mechanics' rows.
    forces : ndarray of float64, shape [samples, n, 2]
        Forces at the samples.
    mass : float
        By what the mechanics' forces are multiplied: the body's mass [kg] where they are per unit mass.
    member : int, optional
        The number of the body in an assembly.
    """
    labels = {measure.kind: measure.label for measure in held.measures}
    used = utilisation(elements, devices)
    return tuple(
        device_result(
            (element.kind, labels[element.kind], element.place),
            device,
            used[n],
            forces[:, n],
            mass,
            weakest=weakest(element, devices[n : n + 1]),
            member=member,
        )
        for n, (element, device) in enumerate(zip(held.elements, devices, strict=True))
    )
