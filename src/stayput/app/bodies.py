"""Bodies of requests as they come: not too large, not too slow, and uploads only a few at a time."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING

from stayput.app.refusals import RefusedError, refused

if TYPE_CHECKING:
    from starlette.types import Message, Receive

    from stayput.app.limits import Limits

_DRAINED = 64 * 1024 * 1024  # of a body that is refused so much is read, so that the answer can be seen
_DRAIN_SECONDS = 5.0
_YOUNG = 1.0  # so long a body is given to show how fast it comes [s]
_FAST = 64 * 1024  # a body that comes so fast is not in anybody's way [bytes/s]


class Body:
    """The body of one request.

    Parameters
    ----------
    receive : Receive
        Where it comes from.
    limits : Limits
        How slow it may be.
    most : int
        How large it may be [bytes].
    too_large : RefusedError
        What is said of a larger one.
    """

    def __init__(self, receive: Receive, limits: Limits, most: int, too_large: RefusedError) -> None:
        self._source = receive
        self._limits = limits
        self._most = most
        self._too_large = too_large
        self._seen = 0
        self._clock = asyncio.get_running_loop().time
        self._began = self._clock()
        self._waiting: asyncio.Timeout | None = None
        self._given_up = False
        self.complete = False

    async def receive(self) -> Message:
        """Return the next part.

        Raises
        ------
        RefusedError
            It is too large, or comes too slowly.
        """
        if self.complete:
            return await self._source()
        try:
            async with asyncio.timeout_at(self._deadline()) as self._waiting:
                message = await self._source()
        except TimeoutError:
            raise refused(408, "app.body_too_slow") from None
        finally:
            self._waiting = None
        if message["type"] == "http.request":
            self._seen += len(message.get("body", b""))
            self.complete = not message.get("more_body", False)
            if self._seen > self._most:
                if not self.complete:
                    await drain(self._source)
                raise self._too_large
        return message

    def _deadline(self) -> float:
        """Return until when the next part must come: what has come gives time for what follows."""
        limits = self._limits
        allowed = min(limits.seconds, limits.header_seconds + self._seen / limits.slowest)
        return self._clock() if self._given_up else self._began + allowed

    @property
    def speed(self) -> float:
        """How fast it comes [bytes/s]; infinite as long as that cannot be told."""
        age = self._clock() - self._began
        return self._seen / age if age > _YOUNG else float("inf")

    def give_up(self) -> None:
        """Let it end now as one that came too slowly."""
        self._given_up = True
        if self._waiting is not None:
            self._waiting.reschedule(self._clock())


class Uploads:
    """The uploads that are on their way.

    Where there are too many, a slow one makes room; where none is slow, the new one has to wait.

    Parameters
    ----------
    limits : Limits
        How many, in all and of one client.
    """

    def __init__(self, limits: Limits) -> None:
        self._limits = limits
        self._coming: dict[Body, str] = {}

    def add(self, body: Body, client: str) -> None:
        """Take an upload in.

        Raises
        ------
        RefusedError
            There are too many already.
        """
        coming = {one: name for one, name in self._coming.items() if not one.complete}
        own = [one for one, name in coming.items() if name == client]
        for others, most in ((own, self._limits.uploads_of_one), (list(coming), self._limits.uploads)):
            if sum(one in coming for one in others) < most:
                continue
            slowest = min((one for one in others if one in coming), key=lambda one: one.speed)
            if slowest.speed > _FAST:
                raise refused(429, "app.many_uploads", retry_after=1)
            slowest.give_up()
            del coming[slowest]
        self._coming = {**coming, body: client}

    def remove(self, body: Body) -> None:
        """Forget an upload."""
        self._coming.pop(body, None)


async def drain(receive: Receive) -> None:
    """Read the rest of a body that is refused, for a while, keeping nothing."""
    seen = 0
    try:
        async with asyncio.timeout(_DRAIN_SECONDS):
            while seen < _DRAINED:
                message = await receive()
                seen += len(message.get("body", b""))
                if message["type"] != "http.request" or not message.get("more_body", False):
                    return
    except TimeoutError:
        return
