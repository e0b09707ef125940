"""Limits of the server: sizes, lengths, counts and times."""

from __future__ import annotations

from dataclasses import dataclass

from stayput.execution import cores

MEBIBYTE = 1024 * 1024


@dataclass(frozen=True, slots=True)
class Limits:
    """Limits of a server; beyond them a request is refused with one sentence.

    Parameters
    ----------
    body : int
        Largest body of a request but an upload [bytes].
    upload : int
        Largest body of an upload, the form around the file included [bytes].
    seconds : float
        Longest time in which a body must have come [s].
    head_seconds : float
        Longest time in which the head of a request must have come [s].
    connections, connections_per_address : int
        Most connections and requests at a time, and connections of one address that is no proxy.
    duration : float
        Longest motion [s].
    samples_of_motion : int
        Most samples of a motion.
    film : float
        Longest motion of which a GIF is drawn [s].
    motions : int
        Most motions kept; those of who has most go first.
    motion_bytes : int
        Most bytes of all motions kept.
    keep : float
        How long a motion or a finished job is kept after its last use [s].
    reading_waiting : int
        Most uploads that wait to be read.
    reading_seconds : float
        Longest time to read an upload [s].
    reading_memory : int
        Most memory to read an upload, where the system can limit it [bytes].
    storeys : int
        Most storeys of a building.
    suite : int
        Most motions of a suite.
    samples : int
        Most samples of a verification.
    options : int
        Most options of a verification.
    runs, runs_in_space : int
        Most simulations of a verification, in the plane and in space.
    runs_of_room : int
        Most simulations of a room as it is, in a verification.
    pieces : int
        Most pieces of a scene of several.
    seconds_of_pieces : float
        Longest motion of a scene of several, times their number [s].
    jobs_running, jobs_waiting, jobs_kept : int
        Most jobs at work, waiting for their turn, and known at all.
    jobs_per_address, jobs_per_page : int
        Most jobs of one address, and of one page there, that are at work or wait.
    workers : int
        Threads for requests that compute something short.
    waiting : int
        Most such requests that wait for a thread.
    slow_workers, slow_waiting : int
        The same for runs of several pieces, tables, films and reports.
    planners : int
        Most plans to buy and do that are made by turns.
    threads : int
        Threads of one verification or map.
    """

    body: int = 256 * 1024
    upload: int = 16 * MEBIBYTE
    seconds: float = 60.0
    head_seconds: float = 10.0
    connections: int = 256
    connections_per_address: int = 64
    duration: float = 600.0
    samples_of_motion: int = 200_000
    film: float = 120.0
    motions: int = 32
    motion_bytes: int = 64 * MEBIBYTE
    keep: float = 7200.0
    reading_waiting: int = 8
    reading_seconds: float = 10.0
    reading_memory: int = 768 * MEBIBYTE
    storeys: int = 60
    suite: int = 100
    samples: int = 2000
    options: int = 20
    runs: int = 2_000_000
    runs_in_space: int = 50_000
    runs_of_room: int = 20_000
    pieces: int = 20
    seconds_of_pieces: float = 2400.0
    jobs_running: int = 1
    jobs_waiting: int = 31
    jobs_kept: int = 48
    jobs_per_address: int = 24
    jobs_per_page: int = 5
    workers: int = max(2, cores())
    waiting: int = 64
    slow_workers: int = 1
    slow_waiting: int = 32
    planners: int = 8
    threads: int = max(1, cores() - 1)
