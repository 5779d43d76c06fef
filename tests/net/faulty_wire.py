"""A wire that randomly delays, loses, duplicates, corrupts and reorders data, or is cut."""

from __future__ import annotations

import contextlib
import random
import socket
import threading
import time
from collections import Counter
from collections.abc import Iterator
from typing import Final

FAULTS: Final = ("delayed", "lost", "cut", "duplicated", "corrupted", "reordered")
_PART: Final = 2**16


class FaultyWire:
    """Carries the data of connections.

    Attributes:
        made: how many faults of each kind there have been.
    """

    def __init__(self, random_: random.Random, often: float, longest_s: float = 0.05) -> None:
        """Prepare a wire.

        Args:
            random_: determines the faults.
            often: the part of the pieces that a fault befalls.
            longest_s: the longest delay [s].
        """
        self.made: Counter[str] = Counter()
        self._random, self._often, self._longest_s = random_, often, longest_s

    def __call__(self, connection: socket.socket) -> socket.socket:
        """Return the other end of the wire, which replaces a connection."""
        here, there = socket.socketpair()
        self.between(there, connection)
        return here

    def between(self, near: socket.socket, far: socket.socket) -> None:
        """Carry what two sockets say in threads, until one has ended."""
        for ends in ((near, far), (far, near)):
            threading.Thread(target=self._carry, args=ends, daemon=True).start()

    def _carry(self, source: socket.socket, target: socket.socket) -> None:
        with contextlib.suppress(OSError):
            while part := source.recv(_PART):
                for each in self._meddled(part):
                    target.sendall(each)
        for end in (source, target):
            with contextlib.suppress(OSError):
                end.shutdown(socket.SHUT_RDWR)

    def _meddled(self, part: bytes) -> Iterator[bytes]:
        """Yield the pieces that arrive in place of a piece; raise OSError if the wire is cut."""
        if self._random.random() >= self._often:
            yield part
            return
        fault = self._random.choice(FAULTS)
        self.made[fault] += 1
        middle = self._random.randrange(len(part))
        if fault == "delayed":
            time.sleep(self._random.random() * self._longest_s)
            yield part
        elif fault == "cut":
            yield part[:middle]
            raise ConnectionAbortedError("cut")
        elif fault == "duplicated":
            yield part * 2
        elif fault == "corrupted":
            yield part[:middle] + bytes([part[middle] ^ 16]) + part[middle + 1 :]
        elif fault == "reordered":
            yield part[middle:] + part[:middle]


@contextlib.contextmanager
def proxy(address: tuple[str, int], wire: FaultyWire) -> Iterator[int]:
    """Yield a port of this machine that leads to an address over a wire."""
    with socket.create_server(("127.0.0.1", 0)) as listener:

        def serve() -> None:
            with contextlib.suppress(OSError):
                while True:
                    near, _ = listener.accept()
                    try:
                        wire.between(near, socket.create_connection(address, 5.0))
                    except OSError:
                        near.close()

        threading.Thread(target=serve, daemon=True).start()
        yield int(listener.getsockname()[1])
        listener.shutdown(socket.SHUT_RDWR)
