"""The channels of a file, how they become the components of a motion, and whether these are of one record."""

from __future__ import annotations

import math
import re
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from stayput.catalogue import Phrase, phrase
from stayput.errors import InputError, InputWarning, excerpt, not_allowed, unknown, warn
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.motion.floors import BOREHOLE, floor_phrase, upper_floor
from stayput.motion.processing import check_size

if TYPE_CHECKING:
    from stayput.motion.record import Motion

_UNNAMED = "(unnamed)"

LISTED: Phrase = (", ", "、")
"""What parts the labels of a listing."""

_UP = re.compile(r"UD\d?|UP|UPDOWN|UPWARDS?|Z|U|V|VER|VRT|VERT|VERTICAL")
_DOWN = re.compile(r"DOWN|DWN|DN")
_VERTICAL = re.compile(rf"{_UP.pattern}|{_DOWN.pattern}|(?!HZ)[A-Z]{{1,2}}Z")
_NAMED = {"0": "N NS NORTH 360", "90": "E EW EAST", "180": "S SOUTH", "270": "W WEST"}
_AZIMUTHS = {name: azimuth for azimuth, names in _NAMED.items() for name in names.split()}
_OF_THE_SENSOR = {"H1", "H2", "L", "LONG", "R", "T", "TRAN", "TRANS"}
_HORIZONTAL = {*_AZIMUTHS, *_OF_THE_SENSOR, "X", "Y"} - {"S"}  # which heads seconds, too
_SEED_CODE = re.compile(r"(?:[0-9]{2})?[A-SU-Z][HLGN]([NEZ])(?:[0-9]{2})?")  # with a location; not "THE"
_AXIS = re.compile(r"(?:A|ACC|ACCEL|ACCELERATION)([XYZ])")

_OF_KIK_NET = re.compile(r"(?<=NS|EW|UD)[12]$")  # its two sensors
_BOREHOLE = re.compile(r"(?<![a-z])(?:bore|down)[ -]?hole(?![a-z])|地中|孔中|ボアホール", re.IGNORECASE)
_SURFACE = re.compile(r"(?<![a-z])surface|地表", re.IGNORECASE)
_CHANNEL_NUMBER = re.compile(
    r"(?<![a-z])(?:ch(?:an(?:nel)?)?|col(?:umn)?|comp(?:onent)?|acc)[ ._-]?[0-9]{1,2}(?![0-9])", re.IGNORECASE
)

_DOUBTFUL_PEAK = 5.0  # g; no more than a handful of records are larger, a wrong unit nearly always is
_PEAK_TOLERANCE = 0.01  # headers round the peak, or take it before the last correction
_PEAK_ROUNDING = 1e-5  # m/s², a header's last digit
_LENGTH_TOLERANCE = 0.01  # published components of one record differ by some samples at their end


@dataclass(frozen=True, slots=True)
class Channel:
    """One channel of a file.

    Parameters
    ----------
    label : str
        Direction as the file writes it: "N-S", "90 DEG", "UP", "HNE", ...; "" where it does not.
    acceleration : ndarray, shape (n,)
        Acceleration [m/s²].
    dt : float
        Time step [s].
    name : str
        Event and station as the file writes them.
    peak : float, optional
        Largest magnitude as the file's header states it [m/s²].
    note : str
        What else the motion's ``source`` should say.
    location : str
        What the file says of the place, as of a floor of a building.
    origin : str
        Event, station and sensor, in the same words in each file of one record; default ``name``.
    borehole : bool
        Whether the sensor is below the ground, at the bottom of a borehole.
    role : str
        The component that the caller says it is: "x", "y" or "z"; "" where the label says it.
    heading : str
        All that heads its column but the unit; "" where the label is all.
    """

    label: str
    acceleration: NDArray[np.float64]
    dt: float
    name: str = ""
    peak: float | None = None
    note: str = ""
    location: str = ""
    origin: str = ""
    borehole: bool = False
    role: str = ""
    heading: str = ""


class Listing(NamedTuple):
    """The channels of a file, and which one became x.

    Attributes
    ----------
    names : tuple of str
        What chooses each one: its direction where no other has it, else its place ("channel 2").
    vertical : tuple of bool
        Whether each one is vertical.
    used : int
        Index of the one that became x as it was read.
    labels : dict of str to str
        Direction of each component as its file writes it, by its name: "x", "y", "z"; "" where it does not.
    origin : str
        Event, station and sensor as the file states them; likewise.
    """

    names: tuple[str, ...]
    vertical: tuple[bool, ...]
    used: int
    labels: dict[str, str]
    origin: str = ""

    def of(self, **components: str) -> Listing:
        """Return the listing where components were called otherwise; no direction of others is known."""
        return self._replace(
            labels={"x": ""} | {name: self.labels.get(old, "") for name, old in components.items()}
        )


def plain_label(label: str) -> str:
    """Return a direction in one spelling: "N-S" → "NS", "090 deg" → "90", "Up" → "UP"."""
    plain = re.sub(r"[^A-Z0-9]", "", label.upper().removesuffix("."))
    plain = plain.removesuffix("DEGREES").removesuffix("DEG")
    return str(int(plain)) if re.fullmatch(r"[0-9]{1,6}", plain) else plain


def _direction(label: str) -> str:
    """Return the direction in a label: "acc_z" → "Z", "BHZ00" → "Z"; the label where there is none."""
    plain = plain_label(label)
    for part in (plain, *map(plain_label, reversed(re.findall(r"[^\W_]+", label)))):
        code = _SEED_CODE.fullmatch(part) or _AXIS.fullmatch(part)
        direction = code[1] if code else part
        if direction in _HORIZONTAL or _VERTICAL.fullmatch(direction):
            return direction
    return plain


def is_vertical(label: str) -> bool:
    """Return whether a direction is the vertical one, up or down."""
    return _VERTICAL.fullmatch(_direction(label)) is not None


def is_down(label: str) -> bool:
    """Return whether a direction is the vertical one, down: such a channel is turned up."""
    return _DOWN.fullmatch(_direction(label)) is not None


def is_direction(label: str) -> bool:
    """Return whether a label is that of a direction: "NS", "East", "x", "Up", "NS1"."""
    return is_vertical(label) or bool({_direction(label), _direction(direction(label))} & _HORIZONTAL)


def in_borehole(label: str, texts: Iterable[str] = ()) -> bool:
    """Return whether KiK-net's number of a sensor, or else what is said of it, is of one below the ground."""
    if _OF_KIK_NET.search(plain := plain_label(label)):
        return plain.endswith("1")
    return any(_BOREHOLE.search(text) and not _SURFACE.search(text) for text in texts)


def _sensor(channel: Channel) -> str:
    """Return what is said beside the direction and the channel's number: "ground NS" → "ground"."""
    said = _CHANNEL_NUMBER.sub("", (channel.heading or channel.label).lower())
    beside = (word for word in re.findall(r"[^\W_]+", said) if not is_direction(word))
    words = (word for word in beside if word not in ("n", "s", "e", "w", "u", "d", "no", "max", "deg"))
    return " ".join(words) if is_direction(channel.label) else ""


def _of_one_sensor(channels: Sequence[Channel]) -> bool:
    """Return whether channels can be the components of one sensor: no direction twice, and headed alike."""
    lines = [line for c in channels if (line := line_of(c.label) or _direction(c.label))]
    sensors = [sensor for c in channels if (sensor := _sensor(c))]
    # Figures that are each channel's own count the channels, or are its azimuth or peak.
    counts = len(set(sensors)) == len(sensors) and all(s.replace(" ", "").isdecimal() for s in sensors)
    return len(set(lines)) == len(lines) and (len(set(sensors)) < 2 or counts)


def labels_phrase(labels: Iterable[str]) -> Phrase:
    """Return the labels of channels as a listing in both languages."""
    shown = [label or _UNNAMED for label in labels]
    return LISTED[0].join(shown), LISTED[1].join(shown)


def direction(label: str) -> str:
    """Return a channel's direction without the number of KiK-net's sensor: "NS2" → "NS"."""
    return _OF_KIK_NET.sub("", plain_label(label))


def plain_origin(origin: str) -> str:
    """Return what a file says of event and station without marks, blanks and case: "KOBE,KJM" → "kobekjm"."""
    return re.sub(r"[\W_]+", "", origin.casefold())


def line_of(label: str) -> str | None:
    """Return the line of a direction: "up", an azimuth below 180, or one of the sensor; None where unknown.

    X and Y are none: they are what a program calls its columns.
    """
    code = _direction(direction(label))
    if is_vertical(label):
        return "up"
    azimuth = _AZIMUTHS.get(code, code)
    if azimuth.isdecimal():
        return str(int(azimuth) % 180)
    return code if code in _OF_THE_SENSOR else None


def spellings(label: str) -> set[str]:
    """Return what a direction may be called, so that "NS", "HNN" and "360" are the same one."""
    plain = plain_label(label)
    code = _direction(label)
    return {plain, code, "up" if _UP.fullmatch(code) else _AZIMUTHS.get(code, code)}


def _chosen(channels: Sequence[Channel], component: str) -> int:
    """Return the index of the channel that the caller names: its place, its label, or another spelling."""
    wanted = str(component).strip()
    labels = [channel.label for channel in channels]
    labelled = [i for i, label in enumerate(labels) if label]
    place = re.fullmatch(r"(?:ch|chan|channel)\s*([0-9]{1,4})", wanted.lower())
    if place:
        matches = [int(place[1]) - 1] if 1 <= int(place[1]) <= len(channels) else []
    else:
        # An exact label comes first: of "360" and "NS" in one file, each names its own channel.
        matches = [i for i in labelled if plain_label(labels[i]) == plain_label(wanted)]
        matches = matches or [i for i in labelled if spellings(direction(labels[i])) & spellings(wanted)]
    if len(matches) == 1:
        return matches[0]
    listing = _numbered(channels, _horizontal(channels))
    known = () if matches else filter(None, labels)  # of two that are meant none is suggested
    raise unknown("motion.the_component", component, known, "component", listed=listing)


def _horizontal(channels: Sequence[Channel]) -> dict[int, str]:
    """Return the labels of the horizontal channels by their indices."""
    return {i: channel.label for i, channel in enumerate(channels) if not is_vertical(channel.label)}


def check_horizontal(channels: Sequence[Channel], component: str | None, *, refuse: bool) -> None:
    """Refuse a component that names a vertical channel of a file that has horizontal ones, or warn of it.

    In Python it may be meant, as for the spectrum of a vertical channel.
    """
    horizontal = _horizontal(channels)
    if component is None or not horizontal or _chosen(channels, component) in horizontal:
        return
    values: dict[str, Any] = {"component": str(component), "channels": _numbered(channels, horizontal)}
    if refuse:
        raise InputError("motion.vertical_component", "component", **values)
    warn(InputWarning("motion.vertical_as_x", "component", **values))


def _numbered(channels: Sequence[Channel], which: Collection[int]) -> Phrase:
    """Return the labels of some of the channels with their places, as a sentence lists what is allowed."""
    return labels_phrase(
        f"{channels[i].label or _UNNAMED} (channel {i + 1})" for i in which or range(len(channels))
    )


def _assigned(channels: Sequence[Channel], component: str | None) -> dict[str, Channel]:
    """Return which channel becomes which component: x, and y and z where only one channel can be meant."""
    if component is None and channels[0].role:
        return {channel.role: channel for channel in channels}
    chosen = None if component is None else _chosen(channels, component)
    # The sensor at the surface and the one in the borehole below it are two records.
    below = all(channel.borehole for channel in channels) if chosen is None else channels[chosen].borehole
    beside = [i for i, channel in enumerate(channels) if channel.borehole == below]
    horizontal = [i for i in _horizontal(channels) if i in beside]
    vertical = [i for i in beside if i not in horizontal]
    if {_direction(channels[i].label) for i in horizontal} == {"X", "Y"}:
        horizontal.sort(key=lambda i: _direction(channels[i].label))
    together = len(horizontal) <= 2 and len(vertical) <= 1
    of_one = _of_one_sensor([channels[i] for i in beside])
    if len(beside) < len(channels):  # of each sensor the same components
        of_one &= (
            len({frozenset(direction(c.label) for c in channels if c.borehole == b) for b in (0, 1)}) == 1
        )
    if chosen is None and not (together and of_one):
        about: dict[str, Any] = {"channels": _numbered(channels, horizontal), "option": "columns"}
        raise InputError("motion.many_channels", "component", count=len(channels), **about)
    x = (horizontal or vertical)[0] if chosen is None else chosen
    assigned = {"x": channels[x]}
    if x in horizontal and together and of_one:
        others = {"y": [i for i in horizontal if i != x], "z": vertical}
        assigned |= {name: channels[places[0]] for name, places in others.items() if places}
    return assigned


def _warn_of_choice(x: Channel, channels: Sequence[Channel]) -> None:
    """Warn of the channel that became x where the caller named none and the file does not say either."""
    horizontal = list(_horizontal(channels).values())
    if not horizontal:
        warn(InputWarning("motion.vertical_alone", "component", label=x.label, option="component"))
    elif len(horizontal) > 1 and {_direction(label) for label in horizontal} != {"X", "Y"}:
        taken = (x.label, f"「{x.label}」") if x.label else phrase("motion.the_first")
        listing = labels_phrase(horizontal)
        warn(InputWarning("motion.x_chosen", "component", channels=listing, label=taken))


def _check_header_peak(channel: Channel) -> None:
    """Raise `InputError` when a channel's samples contradict the peak in its header by more than 1 %."""
    if channel.peak is None or not math.isfinite(channel.peak) or channel.peak == 0.0:
        return
    peak, stated = float(np.abs(channel.acceleration).max()), abs(channel.peak)
    if abs(peak - stated) > _PEAK_TOLERANCE * stated + _PEAK_ROUNDING:
        about: dict[str, Any] = {"stated": stated, "found": peak, "unit": " m/s²"}
        raise InputError("motion.not_as_stated", what=phrase("motion.the_peak"), **about)


def _check_sizes(components: Mapping[str, Channel]) -> None:
    """Refuse an impossible acceleration and warn of a doubtful one: the unit is probably wrong."""
    for name, channel in components.items():
        if not channel.acceleration.size:  # refused by `Motion`
            continue
        check_size(name, channel.acceleration, "unit")
        peak = float(np.abs(channel.acceleration).max()) / STANDARD_GRAVITY
        if peak > _DOUBTFUL_PEAK:
            warn(InputWarning("motion.large_peak", "unit", component=name, peak=peak, limit=_DOUBTFUL_PEAK))


def _common_length(lengths: Mapping[str, int]) -> tuple[int, str]:
    """Return the shortest of lengths that differ by at most 1 %, and a note that says what was cut."""
    shortest, longest = min(lengths.values()), max(lengths.values())
    if longest - shortest > _LENGTH_TOLERANCE * longest:
        listing = ", ".join(f"{name} {length}" for name, length in lengths.items())
        raise InputError("motion.lengths_differ", listing=listing)
    cut = ", ".join(f"{name} from {length}" for name, length in lengths.items() if length > shortest)
    return shortest, f"; cut to {shortest} samples: {cut}" if cut else ""


def motion_fields(
    channels: Sequence[Channel], component: str | None, source: str, name: str = ""
) -> dict[str, Any]:
    """Return the arguments of the `Motion` that a file's channels make.

    The chosen channel becomes x, the other horizontal one y, the vertical one z, up. A file of more than
    two horizontal channels or one vertical one (a building's array) gives only the chosen channel.

    Parameters
    ----------
    channels : sequence of Channel
        All channels of the file.
    component : str, optional
        Direction or number ("channel 2") of the one that becomes x; default the first horizontal one.
    source : str
        The file's format.
    name : str
        Used when the file names neither event nor station; the file's name.

    Raises
    ------
    InputError
        No such channel or more than one, different time steps or lengths, a peak unlike the header's.

    Warns
    -----
    InputWarning
        The channel had to be chosen, or its peak is above 5 g.
    """
    for channel in channels:
        _check_header_peak(channel)
    components = _assigned(channels, component)
    x = components["x"]
    if component is None and not x.role:
        _warn_of_choice(x, [channel for channel in channels if channel.borehole == x.borehole])
    below = [channel.label for channel in channels if channel.borehole]
    if x.borehole:
        warn(InputWarning("motion.borehole", "component", label=x.label or x.name or _UNNAMED))
    elif below and component is None:
        warn(InputWarning("motion.borehole_left_out", "component", channels=labels_phrase(below)))
    _check_sizes(components)
    listing = _listing(channels, components)
    for key, channel in components.items():
        if not math.isclose(channel.dt, x.dt, rel_tol=1e-6):  # steps are written with six digits or more
            raise InputError("motion.motion_dt_differs", component=key, dt=channel.dt, x_dt=x.dt)
        if is_down(channel.label):
            note = f"{channel.note}, sign changed to up"
            components[key] = replace(channel, acceleration=-channel.acceleration, note=note)
    length, cut = _common_length({key: len(channel.acceleration) for key, channel in components.items()})
    roles = ", ".join(f"{key} = {c.label or 'unnamed'}{c.note}" for key, c in components.items())
    samples = {key: channel.acceleration[:length] for key, channel in components.items()}
    floor = BOREHOLE if x.borehole else upper_floor((name, x.label, x.name, x.location))
    place = f"; recorded on {floor_phrase(floor)[0]}" if floor else ""
    return {
        "dt": x.dt,
        **samples,
        "name": ", ".join(part for part in (x.name, x.label) if part) if x.name else name,
        "source": f"{source}: {roles}{cut}{place}",
        "floor": floor,
        "listing": listing,
    }


def _listing(channels: Sequence[Channel], components: Mapping[str, Channel]) -> Listing:
    x = components["x"]
    labels = [channel.label for channel in channels]
    plain = [plain_label(label) for label in labels]
    names = (
        label if plain[i] and plain.count(plain[i]) == 1 else f"channel {i + 1}"
        for i, label in enumerate(labels)
    )
    place = next(i for i, channel in enumerate(channels) if channel is x)
    vertical = tuple(is_vertical(label) for label in labels)
    directions = {name: channel.label for name, channel in components.items()}
    return Listing(tuple(names), vertical, place, directions, " ".join((x.origin or x.name).split()))


_ROUNDING = 0.01
"""Share of the peak up to which samples differ where one record is written with other digits."""


def one_record(parts: Mapping[str, Motion]) -> tuple[int, str]:
    """Return the length of the components of one record, and a note that says what is cut.

    Where the files do not say of which record they are, it is warned. What was computed is of none.

    Parameters
    ----------
    parts : mapping
        The motions of which each one's x becomes a component, by its name: "x", "y", "z".

    Raises
    ------
    InputError
        Two have the same samples, but for rounding and zeros at the end; the files state another event,
        station or sensor, or directions that cannot be those of the components; the time steps or the lengths
        differ; one is of the ground and another of a floor.
    """
    recorded = {name: motion for name, motion in parts.items() if not motion.synthetic}
    for (first, a), (second, b) in combinations(recorded.items(), 2):
        length = min(len(a), len(b))
        if np.abs(a.x[:length] - b.x[:length]).max() <= _ROUNDING * np.abs(a.x[:length]).max():
            raise InputError("motion.one_record", second, first=first, second=second, name=excerpt(a.name))
        if a.listing is not None and b.listing is not None:
            if a.listing.names is not b.listing.names:  # which components of one file share
                _check_origins(first, a.listing, second, b.listing)
            _check_directions(first, a.listing.labels["x"], second, b.listing.labels["x"])
    x = parts["x"]
    for name, motion in parts.items():
        if not math.isclose(motion.dt, x.dt, rel_tol=1e-6):
            raise InputError("motion.motion_dt_differs", name, component=name, dt=motion.dt, x_dt=x.dt)
        if motion.floor != x.floor:
            raise _apart("same_place", "x", floor_phrase(x.floor), name, floor_phrase(motion.floor))
    return _common_length({name: len(motion) for name, motion in parts.items()})


def _check_origins(first: str, a: Listing, second: str, b: Listing) -> None:
    origin, other = a.origin, b.origin
    if origin and other and plain_origin(origin) == plain_origin(other):
        return
    # A title in which no direction was found may have it among its words, and so differ.
    if origin and other and a.labels["x"] and b.labels["x"]:
        raise _apart("same_record", first, _told(origin), second, _told(other))
    warn(InputWarning("motion.origin_unstated", second, first=first, second=second))


def _apart(what: str, first: str, of_first: Phrase, second: str, of_second: Phrase) -> InputError:
    """Return the refusal of two components that are not of the same record or place."""
    about: dict[str, Any] = {"one": of_first, "other": of_second, "what": phrase(f"motion.{what}")}
    return InputError("motion.two_records", second, first=first, second=second, **about)


def _told(origin: str) -> Phrase:
    """Return event and station as a sentence quotes them, the sensor of KiK-net in each language."""
    english, japanese = excerpt(origin)
    for word in ("borehole", "surface"):
        japanese = japanese.replace(f", {word},", f", {phrase(f'motion.sensor_{word}')[1]},")
    return english, japanese


def _check_directions(first: str, label: str, second: str, other: str) -> None:
    axes = [line_of(label), line_of(other)]
    for component, axis, said in zip((first, second), axes, (label, other), strict=True):
        if axis is not None and (axis == "up") != (component == "z"):
            wanted = f"motion.{'vertical' if component == 'z' else 'horizontal'}"
            name = phrase("motion.component_of", component=component)
            raise not_allowed(name, excerpt(said), wanted, component)
    if axes[0] is not None and axes[0] == axes[1]:
        labels: dict[str, Any] = {"one": excerpt(label), "other": excerpt(other)}
        raise InputError("motion.one_direction", second, first=first, second=second, **labels)
