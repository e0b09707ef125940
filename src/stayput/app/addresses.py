"""The address that the server is bound to, and who else can reach it."""

from __future__ import annotations

import ipaddress
import socket
from contextlib import suppress

from stayput.errors import InputError

_ELSEWHERE = {socket.AF_INET: "192.0.2.1", socket.AF_INET6: "2001:db8::1"}
"""Addresses for documentation: nobody has them, and a socket of datagrams that is connected sends nothing."""

MEANING = (
    "There is no password and no encryption: whoever reaches it can use this machine's time and read what "
    "goes over the network. Do this only in a network that you trust; without --host only this machine can."
)


def warning_of(bound: socket.socket) -> str | None:
    """Return what is to be said of a bound socket that other machines can reach, or None where none can."""
    host, port = str(bound.getsockname()[0]), int(bound.getsockname()[1])
    address = ipaddress.ip_address(host.partition("%")[0])
    if address.is_loopback:
        return None
    reached = own_addresses(bound.family) if address.is_unspecified else [host]
    shown = [f"http://[{one}]:{port}/" if ":" in one else f"http://{one}:{port}/" for one in reached]
    where = ", ".join(shown) or f"port {port} of every address of this machine"
    return f"Warning: other machines can reach stayput, at {where}. {MEANING}"


def own_addresses(family: socket.AddressFamily | int) -> list[str]:
    """Return this machine's addresses that others may know: the one that leads elsewhere first.

    Parameters
    ----------
    family : socket.AddressFamily
        AF_INET, or AF_INET6, which reaches both kinds.
    """
    found: list[str] = []
    for kind in (socket.AF_INET, *((socket.AF_INET6,) if family == socket.AF_INET6 else ())):
        with suppress(OSError), socket.socket(kind, socket.SOCK_DGRAM) as probe:
            probe.connect((_ELSEWHERE[kind], 9))
            found.append(str(probe.getsockname()[0]))
        with suppress(OSError):
            found += [str(info[4][0]) for info in socket.getaddrinfo(socket.gethostname(), None, kind)]
    known = {one: ipaddress.ip_address(one.partition("%")[0]) for one in found}  # each once, in this order
    return [one for one, it in known.items() if not (it.is_loopback or it.is_link_local or it.is_unspecified)]


def bind(host: str, port: int) -> socket.socket:
    """Return a socket that is bound and listens.

    Raises
    ------
    InputError
        The address cannot be bound to.
    """
    try:
        family, kind, protocol, _, place = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)[0]
        found = socket.socket(family, kind, protocol)
        try:
            found.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            found.bind(place)
            found.listen(128)
        except OSError:
            found.close()
            raise
    except (OSError, UnicodeError, OverflowError) as error:
        reason = (getattr(error, "strerror", None) or str(error)).lower()
        raise InputError("app.not_served", host=host, port=port, reason=reason) from None
    found.setblocking(False)
    return found


def address_of(bound: socket.socket) -> str:
    """Return the address of a bound socket as a browser takes it."""
    host, port = str(bound.getsockname()[0]), int(bound.getsockname()[1])
    shown = {"0.0.0.0": "127.0.0.1", "::": "::1"}.get(host, host)
    return f"http://[{shown}]:{port}/" if ":" in shown else f"http://{shown}:{port}/"
