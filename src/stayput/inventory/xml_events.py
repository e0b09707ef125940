"""XML as a stream of events: memory stays bounded, and a document type is refused."""

from __future__ import annotations

from typing import IO, TYPE_CHECKING, Any
from xml.parsers import expat

if TYPE_CHECKING:
    from collections.abc import Iterator

CHUNK = 2**16
"""Bytes that are parsed at a time."""

LONGEST_TAG, DEEPEST = 2**20, 50
"""Most bytes of a tag, and most elements within each other."""


class DoctypeError(ValueError):
    """A document type, by which XML names entities that grow or lie in other files."""


def xml_events(file: IO[bytes]) -> Iterator[tuple[str, str, dict[str, str]]]:
    """Yield "start" with a tag and its attributes, "end" with a tag, and "text" with characters.

    Tags are without their namespace.

    Raises
    ------
    ValueError, LookupError, ExpatError
        A document type, an encoding that is not known, too long a tag, too many levels, or no XML.
    """
    events: list[tuple[str, str, dict[str, str]]] = []

    depth = 0

    def start(tag: str, given: dict[str, str]) -> None:
        nonlocal depth
        depth += 1
        if depth > DEEPEST:
            raise ValueError(f"it nests more than {DEEPEST} elements")
        events.append(("start", tag.rpartition(":")[2], given))

    def end(tag: str) -> None:
        nonlocal depth
        depth -= 1
        events.append(("end", tag.rpartition(":")[2], {}))

    def text(characters: str) -> None:
        events.append(("text", characters, {}))

    def refused(*_: object) -> None:
        raise DoctypeError("it declares a document type")

    parser: Any = expat.ParserCreate()
    parser.StartElementHandler, parser.EndElementHandler = start, end
    parser.CharacterDataHandler, parser.StartDoctypeDeclHandler = text, refused
    parser.buffer_text = True
    fed = 0
    while True:
        chunk = file.read(CHUNK)
        parser.Parse(chunk, not chunk)
        fed += len(chunk)
        if fed - parser.CurrentByteIndex > LONGEST_TAG:
            raise ValueError(f"it has a tag of more than {LONGEST_TAG} bytes")
        yield from events
        events.clear()
        if not chunk:
            return
