"""Runs on hosts of which some are lost, as processes of their own, against runs in one process.

    python -m tests.net.lossy_runs samples
    python -m tests.net.lossy_runs kills [--count N] [--seed N] [--faults PART]

`samples` runs ten programs here, on two and on four hosts, and on four of which some are killed and
replaced; `kills` kills hosts and the environment at random, with a connection that is as bad as
`--faults` says, and starts others. Each recording must be that of the run here, byte for byte.
"""

from __future__ import annotations

import argparse
import random
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import Final

from crs_cc.recording.recording import Recording
from tests.cli.machines import free_port
from tests.net.faulty_wire import FaultyWire, proxy

ROOT: Final = Path(__file__).parents[2]
SAMPLES: Final = ROOT / "samples" / "scout_c"

HALL: Final = """<world version="1" name="hall"><area length="12m" width="9m"/>
<box x="6m" y="4m" length="1m" width="0.8m"/><cylinder x="3m" y="6m" radius="0.3m"/>
<robot id="r0" x="1.5m" y="1.5m"/><robot id="r1" x="10m" y="1.5m" heading="120deg"/>
<robot id="r2" x="10m" y="7.5m" heading="200deg"/>
<robot id="r3" x="1.5m" y="7.5m" heading="300deg"/>
</world>"""

RUNS: Final = (
    *(("platoon", "platoon"), ("mixed", "mixed"), ("wander", "hall"), ("bounce", "hall")),
    *(("follow_wall", "hall"), ("square", "hall"), ("figure_eight", "hall")),
    *(("behaviours", "hall"), ("dead_reckoning", "hall"), ("count_doors", "hall")),
)
"""Programs and worlds of four robots or more."""

ROBOTS: Final = {
    "platoon": ("leader", "second", "third", "fourth"),
    "mixed": ("scout", "nomad", "pioneer", "amigo", "late"),
    "hall": ("r0", "r1", "r2", "r3"),
}
TIMEOUT_S: Final = 300.0


def crs(folder: Path, *words: str) -> subprocess.Popen[bytes]:
    """Start a command."""
    with (folder / "log").open("ab") as log:
        return subprocess.Popen(
            [sys.executable, "-m", "crs_cc", *words],
            cwd=folder,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=log,
        )


def is_usable(recording: Path) -> bool:
    """Return whether a recording has a hash, from which a run can be resumed."""
    try:
        opened = Recording(recording)
        try:
            return bool(list(opened.hashes()))
        finally:
            opened.close()
    except Exception:
        return False


class HostedRun:
    """A run on hosts, which can be killed.

    Attributes:
        recording: what the environment writes.
        kills: how many processes have been killed, by what they were.
    """

    def __init__(self, folder: Path, name: str, world: str, count: int, options: Sequence[str]):
        self._folder, self._program, self._world = folder, str(SAMPLES / f"{name}.c"), world
        self._options, self._port, self._number = options, free_port(), 0
        self._address = f"127.0.0.1:{self._port}"
        self.kills: Counter[str] = Counter()
        self.recording = folder / "hosts0.mcap"
        self._environment = self._served()
        names = ROBOTS[world]
        self._parts = [",".join(names[part::count]) for part in range(count)]
        self._hosts: list[subprocess.Popen[bytes]] = []

    def lead_through(self, port: int) -> None:
        """Let hosts connect to another port."""
        self._address = f"127.0.0.1:{port}"

    @property
    def address(self) -> tuple[str, int]:
        """Where the environment listens."""
        return "127.0.0.1", self._port

    def start_hosts(self) -> None:
        """Start all hosts."""
        self._hosts = [self._joined(part) for part in self._parts]

    def _served(self, *more: str) -> subprocess.Popen[bytes]:
        words = "serve", f"{self._world}.xml", "--listen", f"127.0.0.1:{self._port}", "--no-view"
        tokens = "--tokens", "tokens", "--record", self.recording.name
        return crs(self._folder, *words, *tokens, *self._options, *more)

    def _joined(self, part: str) -> subprocess.Popen[bytes]:
        token = "--token", "0123456789abcdef"
        return crs(
            self._folder, "join", part, self._address, self._program, *token, "--retry", "60"
        )

    @property
    def has_ended(self) -> bool:
        """Whether the environment has ended."""
        return self._environment.poll() is not None

    def kill_host(self, random_: random.Random) -> None:
        """Kill or stop a host, and start another one."""
        victim = random_.randrange(len(self._hosts))
        if self._hosts[victim].poll() is not None:
            return
        self._hosts[victim].send_signal(signal.SIGKILL)
        self._hosts[victim].wait()
        self._hosts[victim] = self._joined(self._parts[victim])
        self.kills["host"] += 1

    def kill_environment(self) -> None:
        """Kill the environment, and start it again where its recording ends."""
        self._environment.kill()
        self._environment.wait()
        self.kills["environment"] += 1
        done = self.recording
        known = [each for each in self._folder.glob("hosts*.mcap") if is_usable(each)]
        longest = max(known, key=lambda each: each.stat().st_mtime, default=None)
        self._number += 1
        self.recording = done.with_name(f"hosts{self._number}.mcap")
        self._environment = self._served(*(["--resume", longest.name] if longest else []))

    def finish(self) -> list[int]:
        """Wait for the end, and return the exit statuses."""
        return [each.wait(TIMEOUT_S) for each in (self._environment, *self._hosts)]

    def close(self) -> None:
        """End all processes."""
        for each in (self._environment, *self._hosts):
            each.kill()
            each.wait()


def prepared(stack: ExitStack) -> Path:
    """Return a directory with the worlds."""
    folder = Path(stack.enter_context(tempfile.TemporaryDirectory()))
    (folder / "hall.xml").write_text(HALL)
    (folder / "tokens").write_text("robot 0123456789abcdef\n")
    for world in ("platoon", "mixed"):
        (folder / f"{world}.xml").write_bytes((ROOT / "worlds" / f"{world}.xml").read_bytes())
    return folder


def local(folder: Path, name: str, world: str, options: Sequence[str]) -> bytes:
    """Return the recording of a run in one process."""
    words = "run", str(SAMPLES / f"{name}.c"), f"{world}.xml", "--record", "local.mcap"
    status = crs(folder, *words, *options).wait(TIMEOUT_S)
    assert status in (0, 1), (folder / "log").read_text()
    return (folder / "local.mcap").read_bytes()


def run_samples(time_s: str) -> bool:
    """Compare ten programs; return whether all runs are the same."""
    is_same, random_ = True, random.Random(1)
    for name, world in RUNS:
        with ExitStack() as stack:
            folder = prepared(stack)
            options = ["--max-time", time_s, "--quiet"]
            kills: Counter[str] = Counter()
            is_one = []
            for count, losses in ((2, 0), (4, 0), (4, 3)):
                pace = ["--speed", "5"] if losses else []
                expected = local(folder, name, world, [*options, *pace])
                run = HostedRun(folder, name, world, count, [*options, *pace])
                stack.callback(run.close)
                run.start_hosts()
                time.sleep(5.0 if losses else 0.0)
                for _ in range(losses):
                    time.sleep(random_.uniform(0.5, 1.5))
                    run.kill_host(random_)
                run.finish()
                kills += run.kills
                is_one.append(run.recording.read_bytes() == expected)
            is_same &= all(is_one)
            shown = " ".join("same" if each else "DIFFERENT" for each in is_one)
            print(f"{name:15} {world:8} {shown} {kills.total()} lost", flush=True)
    return is_same


def run_kills(count: int, seed: int, faults: float, time_s: str) -> bool:
    """Kill processes at random; return whether all runs are the same."""
    random_, total = random.Random(seed), Counter[str]()
    wire = FaultyWire(random_, faults, longest_s=0.3)
    while total["host"] + total["environment"] < count:
        with ExitStack() as stack:
            folder = prepared(stack)
            options = ["--max-time", time_s, "--quiet"]
            expected = local(folder, "wander", "hall", options)
            run = HostedRun(folder, "wander", "hall", 4, options)
            stack.callback(run.close)
            run.lead_through(stack.enter_context(proxy(run.address, wire)))
            run.start_hosts()
            while not run.has_ended:
                time.sleep(random_.expovariate(0.7))
                if run.kills.total() >= 12:
                    break  # it may come to its end
                if random_.random() < 0.8:
                    run.kill_host(random_)
                elif not run.has_ended:
                    run.kill_environment()
            statuses = run.finish()
            total += run.kills
            is_same = run.recording.read_bytes() == expected
            print(
                dict(total),
                dict(wire.made),
                statuses,
                "same" if is_same else "DIFFERENT",
                flush=True,
            )
            if not is_same:
                print((folder / "log").read_text()[-3000:])
                return False
    return True


def main() -> int:
    """Run what is asked for; return the exit status."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("what", choices=["samples", "kills"])
    parser.add_argument("--count", type=int, default=200, help="processes to kill")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--faults", type=float, default=0.001, help="part of the pieces")
    parser.add_argument("--time", default="", help="simulated time of a run [s]")
    asked = parser.parse_args()
    if asked.what == "samples":
        return 0 if run_samples(asked.time or "20") else 1
    return 0 if run_kills(asked.count, asked.seed, asked.faults, asked.time or "150") else 1


if __name__ == "__main__":
    sys.exit(main())
