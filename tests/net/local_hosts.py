"""Hosts in threads of the test, over pairs of sockets that the test can cut."""

from __future__ import annotations

import socket
import threading
from collections.abc import Callable, Sequence

import numpy as np

from crs_cc.net.channel import Channel, ConnectionLostError, KeepAlive
from crs_cc.net.host_link import HostGoneError, HostLink
from crs_cc.net.program_host import ProgramHost, Streams
from crs_cc.net.remote_fleet import RemoteFleet
from crs_cc.runtime.executable import Executable
from crs_cc.session.build import build_driver
from crs_cc.session.host import Output, discard, no_input

Meddler = Callable[[socket.socket], socket.socket]
"""Returns what a host connects to in place of the environment's socket."""


class LocalHosts:
    """Starts hosts, and others in place of those that are lost.

    Attributes:
        threads: how many threads of each run programs, see `Fleet`.
    """

    threads: int | None = None

    def __init__(
        self,
        executables: Sequence[Executable],
        count: int,
        meddler: Meddler = lambda connection: connection,
        write: Output = discard,
        losses: int = 10**6,
    ) -> None:
        self._executables, self._meddler, self._write = executables, meddler, write
        self._left = losses
        self._shown: dict[tuple[str, ...], int] = {}
        self.lost: list[str] = []
        self.ended: list[object] = []
        self._threads: dict[tuple[str, ...], threading.Thread] = {}
        self._keep_alive = KeepAlive()
        self._keep_alive.__enter__()
        mixed = np.random.default_rng(1).permutation(len(executables))
        parts = [np.sort(part) for part in np.array_split(mixed, count)]
        links = [self._link(robots) for robots in parts if robots.size]
        self.fleet = RemoteFleet(executables, links)

    def close(self) -> None:
        self.fleet.dismiss(everyone=True)
        self.fleet.close()
        for thread in self._threads.values():
            thread.join(10.0)
            assert not thread.is_alive()
        self._keep_alive.__exit__()

    def _link(self, robots: np.ndarray) -> HostLink:
        names = tuple(f"robot{robot}" for robot in robots)
        return HostLink(names, robots, self._started(names), self._replace)

    def _replace(self, link: HostLink, reason: str) -> Channel:
        self.lost.append(reason)
        self._left -= 1
        if self._left < 0:
            raise HostGoneError(reason)
        return self._started(link.names)

    def _started(self, names: tuple[str, ...]) -> Channel:
        here, there = socket.socketpair()
        channel = Channel(self._meddler(here))
        self._keep_alive.add(channel)
        before = self._threads.get(names)
        thread = threading.Thread(target=self._serve, args=(names, there, before), daemon=True)
        thread.start()
        self._threads[names] = thread
        return channel

    def _serve(
        self, names: tuple[str, ...], connection: socket.socket, before: threading.Thread | None
    ) -> None:
        channel = Channel(connection)
        self._keep_alive.add(channel)
        if before is not None:
            before.join()  # a host that comes back has noticed that it was lost
        robots = [int(name.removeprefix("robot")) for name in names]

        def write(robot: int, stream: int, content: bytes) -> None:
            self._write(robots[robot], stream, content)

        host = ProgramHost(
            [self._executables[robot] for robot in robots],
            build_driver(),
            Streams(write, no_input, lambda _robot, _clock_s: (0, 0.0)),
            self._shown.get(names, 0),
            self.threads,
        )
        try:
            self.ended.append(host.serve(channel))
        except ConnectionLostError:
            self._shown[names] = max(self._shown.get(names, 0), host.shown)
        finally:
            channel.close()
