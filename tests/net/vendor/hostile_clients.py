"""Throws hostile connections at the port of an Nserver, beside a client that drives its robot.

    python -m tests.net.vendor.hostile_clients [--count N] [--seed N]

Wrong lengths, floods whose answers nobody reads, half packets, other protocols, and clients that
take a robot and vanish; some connections stay open. Meanwhile a client drives its robot all the
time: each of its requests must be answered, and how long that takes is shown. Afterwards the run
goes on, has had no error of its own, holds no more memory and files than before, and its recording
is that of the same run.
"""

from __future__ import annotations

import argparse
import random
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import time
from collections import Counter, deque
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path
from typing import Final

from tests.net.fuzz_port import MORE_KB, held, wait_for
from tests.net.vendor.nclient import Nclient

ROBOTS: Final = "".join(f'<robot x="{place}m" y="2m"/>' for place in (1, 3, 5))
WORLD: Final = (
    f'<world version="1"><area length="6m" width="4m"/>{ROBOTS}</world>'  # the first is driven
)
KEPT: Final = 20
"""Hostile connections that stay open for a while."""

SETTLE_S: Final = 12.0
"""Until connections without a robot are closed, see `net.vendor.server.OPENING_TIMEOUT_S`."""

CONNECT: Final = 102


class Driver:
    """A client that drives its robot, and measures how long it waits.

    Attributes:
        waits_s: how long each request has taken [s].
        failed: the number of requests without a valid answer.
    """

    def __init__(self, port: int) -> None:
        self._client = Nclient(port)
        assert self._client.connect_robot(1)
        self.waits_s: list[float] = []
        self.failed = 0
        self._ends = threading.Event()
        self._thread = threading.Thread(target=self._drive, daemon=True)
        self._thread.start()

    def _drive(self) -> None:
        while not self._ends.wait(0.01):
            began_s = time.monotonic()
            speed = 50 if len(self.waits_s) % 80 < 40 else -50
            self.failed += not self._client.state_call(12, speed, speed, 0)
            self.waits_s.append(time.monotonic() - began_s)

    def stop(self) -> None:
        """Let it end."""
        self._ends.set()
        self._thread.join(30.0)
        assert not self._thread.is_alive()


class Hostile:
    """Connections that say what they should not.

    Attributes:
        made: how many there were, by their kind.
    """

    def __init__(self, port: int, seed: int) -> None:
        self._port, self._random = port, random.Random(seed)
        self._kept: deque[socket.socket] = deque()
        self.made: Counter[str] = Counter()

    def throw(self) -> None:
        """Connect, and say something."""
        kinds = self.noise, self.lengths, self.half, self.flood, self.vanishing, self.silence
        kind: Callable[[], bytes] = self._random.choice(kinds)
        self.made[kind.__name__] += 1
        connection = socket.create_connection(("127.0.0.1", self._port), 20.0)
        connection.setblocking(False)
        try:
            connection.send(kind())
        except OSError:
            self.made["cut off"] += 1
        self._kept.append(connection)
        if len(self._kept) > KEPT or self._random.random() < 0.5:
            self._kept.popleft().close()

    def close(self) -> None:
        """Close what is open."""
        while self._kept:
            self._kept.popleft().close()

    def noise(self) -> bytes:
        """Return random bytes, or another protocol."""
        web = b"GET / HTTP/1.1\r\nHost: x\r\n\r\n"
        return self._random.choice((web, self._random.randbytes(200)))

    def lengths(self) -> bytes:
        """Return packets that say to have other lengths than they have."""
        opening = self._opening()
        count = self._random.choice((0, 1, 17, 300, 65535))
        return opening + struct.pack(">HH", self._random.randrange(300), count) + bytes(20)

    def half(self) -> bytes:
        """Return the beginning of a packet."""
        opening = self._opening()
        return opening[: self._random.randrange(len(opening))]

    def flood(self) -> bytes:
        """Return thousands of requests."""
        return self._opening() + struct.pack(">HH", 29, 0) * 5000

    def vanishing(self) -> bytes:
        """Return a request for motion that lasts, of a client that will not be there."""
        return self._opening() + struct.pack(">HHiii", 12, 3, 50, 50, 0)

    def silence(self) -> bytes:
        """Return nothing."""
        return b""

    def _opening(self) -> bytes:
        robot = self._random.choice((1, 2, 3, 4, -1, 2**31 - 1))
        return struct.pack(">HHii", CONNECT, 2, robot, 4711)


def attack(folder: Path, count: int, seed: int, show: Callable[[str], None]) -> None:
    """Attack a run; raise AssertionError where it or its client is disturbed."""
    (folder / "world.xml").write_text(WORLD)
    log, crs = folder / "serve.log", [sys.executable, "-m", "crs_cc"]
    words = "serve", "world.xml", "--nserver", "0", "--no-view", "--record", "run.mcap"
    with ExitStack() as stack, log.open("w") as errors:
        run = subprocess.Popen([*crs, *words], cwd=folder, stderr=errors)
        stack.callback(run.wait)
        stack.callback(run.kill)
        port = int(wait_for(log, r"Nserver is on port (\d+)")[1])
        driver = Driver(port)
        time.sleep(2.0)
        quiet = len(driver.waits_s)
        hostile = Hostile(port, seed)
        stack.callback(hostile.close)
        memories = []
        for number in range(1, count + 1):
            hostile.throw()
            if number in (count // 4, count // 2, 3 * count // 4):
                memories.append(held(run.pid))
        hostile.close()
        time.sleep(SETTLE_S)
        attacked = driver.waits_s[quiet:]
        after = held(run.pid)
        again = Nclient(port)
        assert again.connect_robot(2)
        assert again.state_call(15)
        driver.stop()
        show(f"{count} connections: {dict(hostile.made)}")
        for name, waits in (("alone", driver.waits_s[:quiet]), ("attacked", attacked)):
            middle, longest = sorted(waits)[len(waits) // 2], max(waits)
            show(f"{name}: {len(waits)} requests, {middle * 1e3:.1f} ms, longest {longest:.2f} s")
        show(f"{driver.failed} failed; KB and files held: {memories}, at the end {after}")
        run.send_signal(signal.SIGINT)
        assert run.wait(60.0) == 130, log.read_text()
        assert not driver.failed
        assert "Traceback" not in log.read_text(), log.read_text()
        assert after[0] - memories[0][0] < MORE_KB
        assert after[1] <= memories[0][1] + 2
    replay = [*crs, "replay", "run.mcap", "--verify"]
    done = subprocess.run(replay, cwd=folder, capture_output=True, text=True, check=False)
    assert "the same run" in done.stdout + done.stderr, done.stderr
    show("the recording is that of the same run")


def main() -> None:
    """Attack a run of its own."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=10_000)
    parser.add_argument("--seed", type=int, default=1)
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        attack(Path(folder), asked.count, asked.seed, print)


if __name__ == "__main__":
    main()
