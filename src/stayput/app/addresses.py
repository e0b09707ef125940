"""The address that the server is bound to, and the warning where other machines can reach it."""

from __future__ import annotations

import ipaddress
import socket
from contextlib import suppress

from stayput.catalogue import phrase, say
from stayput.errors import InputError, reason_of

_ELSEWHERE = {socket.AF_INET: "192.0.2.1", socket.AF_INET6: "2001:db8::1"}
"""Addresses for documentation: nobody has them, and a socket of datagrams that is connected sends nothing."""


def warning_of(bound: socket.socket, language: str = "en") -> str | None:
    """Return the warning about a bound socket that other machines can reach, or None where none can.

    Parameters
    ----------
    bound : socket
        The socket.
    language : str
        "en" or "ja".
    """
    host, port = str(bound.getsockname()[0]), int(bound.getsockname()[1])
    address = ipaddress.ip_address(host.partition("%")[0])
    if address.is_loopback:
        return None
    reachable = own_addresses(bound.family) if address.is_unspecified else [host]
    urls = [_url(ip, port) for ip in reachable]
    where = ", ".join(urls) or phrase("app.every_address", port=port)
    return say("app.reachable", language, where=where)


def own_addresses(family: socket.AddressFamily | int) -> list[str]:
    """Return this machine's addresses that others may know: the one that leads elsewhere first.

    Parameters
    ----------
    family : socket.AddressFamily
        AF_INET, or AF_INET6, which reaches both kinds.
    """
    addresses: list[str] = []
    for kind in (socket.AF_INET, *((socket.AF_INET6,) if family == socket.AF_INET6 else ())):
        with suppress(OSError), socket.socket(kind, socket.SOCK_DGRAM) as probe:
            probe.connect((_ELSEWHERE[kind], 9))
            addresses.append(str(probe.getsockname()[0]))
        with suppress(OSError):
            addresses += [str(info[4][0]) for info in socket.getaddrinfo(socket.gethostname(), None, kind)]

    def known_elsewhere(address: str) -> bool:
        ip = ipaddress.ip_address(address.partition("%")[0])
        return not (ip.is_loopback or ip.is_link_local or ip.is_unspecified)

    return [address for address in dict.fromkeys(addresses) if known_elsewhere(address)]


def bind(host: str, port: int) -> socket.socket:
    """Return a socket that is bound and listens.

    Raises
    ------
    InputError
        The address cannot be bound to.
    """
    try:
        family, kind, protocol, _, address = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)[0]
        listener = socket.socket(family, kind, protocol)
        try:
            listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            listener.bind(address)
            listener.listen(128)
        except OSError:
            listener.close()
            raise
    except (OSError, UnicodeError, OverflowError) as error:
        reason = reason_of(error)
        raise InputError("app.not_served", host=host, port=port, reason=reason) from None
    listener.setblocking(False)
    return listener


def address_of(bound: socket.socket) -> str:
    """Return the address of a bound socket as a browser takes it."""
    host, port = str(bound.getsockname()[0]), int(bound.getsockname()[1])
    return _url({"0.0.0.0": "127.0.0.1", "::": "::1"}.get(host, host), port)


def _url(host: str, port: int) -> str:
    return f"http://[{host}]:{port}/" if ":" in host else f"http://{host}:{port}/"
