"""Limits on the bodies of requests: size, speed, and uploads at a time."""

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


class RequestBody:
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
        The refusal of a larger one.
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
        """Return the deadline of the next part [s of the loop's clock]: each byte received extends it."""
        limits = self._limits
        allowed = min(limits.seconds, limits.header_seconds + self._seen / limits.slowest)
        return self._clock() if self._given_up else self._began + allowed

    @property
    def speed(self) -> float:
        """Mean rate of arrival [bytes/s]; infinite while it is too young to be measured."""
        age = self._clock() - self._began
        return self._seen / age if age > _YOUNG else float("inf")

    def give_up(self) -> None:
        """End it now, as one that comes too slowly."""
        self._given_up = True
        if self._waiting is not None:
            self._waiting.reschedule(self._clock())


class Uploads:
    """The uploads in progress.

    Where there are too many, a slow one makes room; where none is slow, the new one has to wait.

    Parameters
    ----------
    limits : Limits
        How many, in all and of one client.
    """

    def __init__(self, limits: Limits) -> None:
        self._limits = limits
        self._incoming: dict[RequestBody, str] = {}

    def add(self, body: RequestBody, client: str) -> None:
        """Take an upload in.

        Raises
        ------
        RefusedError
            There are too many already.
        """
        incoming = {upload: name for upload, name in self._incoming.items() if not upload.complete}
        own = [upload for upload, name in incoming.items() if name == client]
        for group, most in ((own, self._limits.uploads_per_client), (list(incoming), self._limits.uploads)):
            others = [upload for upload in group if upload in incoming]
            if len(others) < most:
                continue
            slowest = min(others, key=lambda upload: upload.speed)
            if slowest.speed > _FAST:
                raise refused(429, "app.many_uploads", retry_after=1)
            slowest.give_up()
            del incoming[slowest]
        self._incoming = {**incoming, body: client}

    def remove(self, body: RequestBody) -> None:
        """Forget an upload."""
        self._incoming.pop(body, None)


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
