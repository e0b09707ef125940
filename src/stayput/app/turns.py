"""Whose turn it is: addresses take turns, at each address its pages, and of each page what came first.

A page that is open somewhere says in the header `CLIENT_HEADER` which it is. So ten people behind one address
take turns, and who opens a hundred pages gets one turn of the addresses all the same.
"""

from __future__ import annotations

from collections import OrderedDict, deque
from contextvars import ContextVar
from typing import Generic, NamedTuple, TypeVar

T = TypeVar("T")

CLIENT_HEADER = "x-stayput-client"
"""Header in which a page says which of the pages at its address it is."""

LONGEST_CLIENT = 64
"""So many of its characters count."""


class Client(NamedTuple):
    """Who asks."""

    address: str
    page: str


NOBODY = Client("", "")
"""Who asks where that is not known."""

CLIENT: ContextVar[Client] = ContextVar("client", default=NOBODY)
"""Who has sent the request that is being answered."""


class Turns(Generic[T]):
    """Items that wait for their turn."""

    def __init__(self) -> None:
        self._addresses: OrderedDict[str, OrderedDict[str, deque[T]]] = OrderedDict()

    def __len__(self) -> int:
        """Return how many wait."""
        return sum(len(items) for pages in self._addresses.values() for items in pages.values())

    def of_address(self, address: str) -> int:
        """Return how many of an address wait."""
        pages = self._addresses.get(address)
        return 0 if pages is None else sum(len(items) for items in pages.values())

    def add(self, client: Client, item: T, *, again: bool = False) -> None:
        """Let an item wait; ``again``: it has begun and goes on before others of its client."""
        items = self._addresses.setdefault(client.address, OrderedDict()).setdefault(client.page, deque())
        if again:
            items.appendleft(item)
        else:
            items.append(item)

    def take(self) -> T | None:
        """Return whose turn it is, or None where nobody waits; its address and its client go to the end."""
        if not self._addresses:
            return None
        address, pages = self._addresses.popitem(last=False)
        page, items = pages.popitem(last=False)
        item = items.popleft()
        if items:
            pages[page] = items
        if pages:
            self._addresses[address] = pages
        return item

    def remove(self, item: T) -> None:
        """Let an item wait no longer; nothing happens where it does not."""
        for address, pages in list(self._addresses.items()):
            for page, items in list(pages.items()):
                if item in items:
                    items.remove(item)
                if not items:
                    del pages[page]
            if not pages:
                del self._addresses[address]

    def in_order(self) -> list[T]:
        """Return all that wait, in the order of their turns if nobody else comes."""
        rehearsal: Turns[T] = Turns()
        for address, pages in self._addresses.items():
            rehearsal._addresses[address] = OrderedDict((page, deque(own)) for page, own in pages.items())
        return [item for _ in range(len(rehearsal)) if (item := rehearsal.take()) is not None]
