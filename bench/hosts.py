"""Measures runs whose programs are on hosts, in processes of their own on this machine.

Two programs, one that waits for its robot and one that computes all the time, on 1, 2 and 4 hosts
and in the session's own process (one thread): real time of a timestep of 50 ms, processor time of
the thread that runs it, and of all hosts together (on Linux), rounds that hosts are asked for, and
what a round costs more real time than at home, by the median of the timesteps. The latter needs as
many idle processors as hosts, and one more. As its limit, the same number of bytes goes to as many
processes that do nothing but answer, and back, over plain sockets. With `--real-time`, which needs
Linux and root, whatever else the machine does waits while timesteps are measured. With `--dask`,
hosts are on the cluster of a scheduler, such as `tcp://127.0.0.1:8786`. With `--table`, the table
of `docs/performance.md` follows.

    python bench/hosts.py [--steps N] [--hosts N ...] [--real-time] [--only-tcp] [--dask ADDRESS]
                          [--table] [ROBOTS ...]
"""

from __future__ import annotations

import argparse
import math
import os
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, closing, contextmanager
from itertools import groupby
from pathlib import Path
from typing import NamedTuple
from unittest import mock

import numpy as np

from crs_cc.core.source import Diagnostics
from crs_cc.net.access import Access
from crs_cc.net.channel import Channel, Kind
from crs_cc.net.cluster_fleet import ClusterFleet
from crs_cc.net.host_link import HostLink
from crs_cc.net.host_registry import HostRegistry
from crs_cc.net.listener import Listener, bound_socket
from crs_cc.net.remote_fleet import RemoteFleet
from crs_cc.runtime.executable import Executable
from crs_cc.runtime.fleet import Fleet
from crs_cc.session.build import build_driver, build_executable
from crs_cc.session.session import Session
from crs_cc.sim.files.world_xml import parse_world
from crs_cc.sim.model.world import WorldModel

PROGRAMS = {
    "waiting": """
#include <Nclient.h>

int main(void)
{
    connect_robot(1);
    for (;;) {
        get_sn();
        vm(State[STATE_SONAR_0] < 20 ? 0 : 50, 100, 0);
    }
}
""",
    "computing": """
#include <Nclient.h>

int main(void)
{
    unsigned sum = 0, i;
    connect_robot(1);
    for (;;) {
        for (i = 0; i < 400000; i++)
            sum = sum * 1664525 + i;
        vm(sum % 50, 100, 0);
    }
}
""",
}
IDLE = """
import os, sys
processor, parent = map(int, sys.argv[1:])
os.sched_setaffinity(0, [processor])
os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(1))
while os.getppid() == parent:
    for _ in range(10000):
        pass
"""
"""Keeps a processor from other work, after whatever has a higher priority."""
ECHO = """
import socket, sys
port, received, sent = map(int, sys.argv[1:])
answer = bytes(sent)
with socket.create_connection(("127.0.0.1", port)) as connection:
    connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    while connection.recv(received, socket.MSG_WAITALL):
        connection.sendall(answer)
"""
"""Answers so many bytes by so many others, until the other side goes."""
WARM_STEPS = 5
ECHO_ROUNDS = 300
MILLISECONDS = 1e3
MAX_STEPS, MIN_STEPS, ROBOT_STEPS = 60, 5, 6000


class Row(NamedTuple):
    """What has been measured of a program with some robots on some hosts."""

    program: str
    robots: int
    hosts: int
    step_s: float
    cpu_s: float
    rounds: float
    hosts_cpu_s: float
    more_s: float = math.nan
    echo_s: float = math.nan

    def __str__(self) -> str:
        text = f"{self.program:10} {self.robots:7} {self.hosts or 'none':>6}"
        text += f" {self.step_s * MILLISECONDS:12.2f} {self.cpu_s * MILLISECONDS:8.2f}"
        text += f" {self.hosts_cpu_s * MILLISECONDS:9.2f}"
        text += f" {self.rounds:7.1f}"
        if self.hosts:
            text += f" {self.more_s * MILLISECONDS:14.3f} {self.echo_s * MILLISECONDS:10.3f}"
        return text


def world_of(robots: int) -> WorldModel:
    """Return a floor with Scouts in rows."""
    side = math.ceil(math.sqrt(robots))
    rows = "".join(
        f'<robot id="r{n}" x="{2 * (n % side) + 1}m" y="{2 * (n // side) + 1}m"/>'
        for n in range(robots)
    )
    text = f'<world version="1"><area length="{2 * side}m" width="{2 * side}m"/>{rows}</world>'
    return parse_world(text.encode(), "floor.xml")


@contextmanager
def hosts(
    world: WorldModel,
    executable: Executable,
    source: Path,
    count: int,
    dask: str,
    *,
    only_tcp: bool = False,
) -> Iterator[Fleet]:
    """Yield a fleet on a number of hosts, on a cluster if one is named; none is a fleet here."""
    executables = [executable] * len(world.robots)
    if not count:
        yield Fleet(executables, build_driver(), threads=1)
        return
    if dask:
        per_host = -(-len(world.robots) // count)
        with closing(ClusterFleet(world.robots, executables, dask, per_host)) as placed:
            yield placed
        return
    with ExitStack() as stack:
        registry, access = HostRegistry(world.robots), Access.made()
        listener = Listener(bound_socket("127.0.0.1", 0), access, registry, only_tcp=only_tcp)
        stack.callback(listener.close)
        names = [robot.id for robot in world.robots]
        for part in range(count):
            own = ",".join(names[part::count])
            words = ["join", own, f"127.0.0.1:{listener.port}", str(source), "--threads", "1", "-q"]
            line = [sys.executable, "-m", "crs_cc", *words, "--token", access.token("robot")]
            process = subprocess.Popen(line, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            stack.callback(process.wait)
        stack.callback(listener.close)  # first, or hosts that are left would come again
        while registry.missing():
            registry.wait()
        links = []
        for assignment in registry.begin():
            channel = registry.wait_for_channel(assignment, lambda: False)
            assert channel
            robots = np.array([names.index(name) for name in assignment.names], np.intp)
            links.append(HostLink(assignment.names, robots, channel, _no_other))
        fleet = RemoteFleet(executables, links)
        try:
            yield fleet
        except BaseException:
            fleet.close()  # or they would be waited for
            raise
        fleet.outcome = lambda _robot: {"exit_status": 0, "failed": False}
        fleet.dismiss(everyone=True)


def _no_other(link: HostLink, reason: str) -> None:  # type: ignore[misc]
    raise SystemExit(f"the host of {link.names[0]} is lost: {reason}")


@contextmanager
def real_time(*, wanted: bool) -> Iterator[None]:
    """Run this process and its children before all others, if that is wanted.

    While they wait, each processor does nothing: other work would empty its caches.
    """
    if not wanted:
        yield
        return
    _schedule(os.SCHED_FIFO, 2)
    with ExitStack() as stack:
        stack.callback(_schedule, os.SCHED_OTHER, 0)
        for processor in os.sched_getaffinity(0):
            words = [sys.executable, "-S", "-c", IDLE, str(processor), str(os.getpid())]
            idle = subprocess.Popen(words)
            stack.callback(idle.wait)
            stack.callback(idle.kill)
        time.sleep(0.2)
        yield


def _schedule(policy: int, priority: int) -> None:
    own = os.getpid()
    children = Path(f"/proc/{own}/task/{own}/children").read_text().split()
    for process in (own, *children):
        for thread in Path(f"/proc/{process}/task").iterdir():
            os.sched_setscheduler(int(thread.name), policy, os.sched_param(priority))


def step_s(
    world: WorldModel,
    executable: Executable,
    fleet: Fleet,
    steps: int,
    sizes: dict[Kind, list[int]],
    *,
    first: bool,
) -> tuple[float, float, float, float, str]:
    """Return what a timestep takes, and the state hash.

    That is real and processor time here [s], rounds, and processor time of all hosts [s].

    Notes the sizes of messages that cross.
    """
    rounds = 0
    run = fleet.run_rounds

    def counted(end_s: float) -> int:
        nonlocal rounds
        found = run(end_s)
        rounds += found > 0
        return found

    fleet.run_rounds = counted  # type: ignore[method-assign]
    session = Session(world, [executable] * len(world.robots), fleet=fleet)
    with noting(sizes):
        while session.timesteps < WARM_STEPS:
            session.advance(1)
    rounds, times_s = 0, []
    clocks = _clocks_of_children()
    hosts_cpu_s = -sum(map(time.clock_gettime, clocks))
    with real_time(wanted=first):
        while session.timesteps < WARM_STEPS + steps:
            begin_s, begin_cpu_s = time.perf_counter(), time.thread_time()
            session.advance(1)
            times_s.append((time.perf_counter() - begin_s, time.thread_time() - begin_cpu_s))
        hosts_cpu_s += sum(map(time.clock_gettime, clocks))
    took_s, cpu_s = map(float, np.median(times_s, axis=0))
    return took_s, cpu_s, rounds / steps, hosts_cpu_s / steps, session.state_hash()


def _clocks_of_children() -> list[int]:
    """Return the clocks of the processes that this one has started: how Linux numbers them."""
    own = os.getpid()
    children = Path(f"/proc/{own}/task/{own}/children")
    if not children.exists():
        return []
    return [(~int(each) << 3) | 2 for each in children.read_text().split()]


@contextmanager
def echoing(count: int, sizes: tuple[int, int]) -> Iterator[list[socket.socket]]:
    """Yield connections to processes that answer so many bytes by so many others."""
    with ExitStack() as stack:
        listener = stack.enter_context(socket.create_server(("127.0.0.1", 0)))
        connections = []
        for _ in range(count):
            words = map(str, (listener.getsockname()[1], *sizes))
            process = subprocess.Popen([sys.executable, "-S", "-c", ECHO, *words])
            stack.callback(process.wait)
            connection = stack.enter_context(listener.accept()[0])
            connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            connections.append(connection)
        yield connections


def echo_s(count: int, sizes: tuple[int, int], *, first: bool) -> float:
    """Return what it takes to send to all processes that only answer, and to hear them [s]."""
    sent, received = sizes
    content, times_s = bytes(sent), []
    with echoing(count, sizes) as connections, real_time(wanted=first):
        for _ in range(ECHO_ROUNDS):
            begin_s = time.perf_counter()
            for connection in connections:
                connection.sendall(content)
            for connection in connections:
                connection.recv(received, socket.MSG_WAITALL)
            times_s.append(time.perf_counter() - begin_s)
    return float(np.median(times_s))


@contextmanager
def noting(sizes: dict[Kind, list[int]]) -> Iterator[None]:
    """Note the sizes of messages of some kinds, with their heads [bytes]."""
    send, receive = Channel.send_frame, Channel.receive_frame

    def counted_send(channel: Channel, kind: Kind, frame: memoryview) -> None:
        sizes.get(kind, []).append(len(frame))
        send(channel, kind, frame)

    def counted_receive(channel: Channel, kind: Kind, buffer: memoryview) -> int:
        if size := receive(channel, kind, buffer):
            sizes.get(kind, []).append(size)
        return size

    with mock.patch.multiple(Channel, send_frame=counted_send, receive_frame=counted_receive):
        yield


def measure(name: str, source: Path, robots: int, asked: argparse.Namespace) -> Iterator[Row]:
    """Yield a row for each number of hosts."""
    world = world_of(robots)
    executable = build_executable([source], Diagnostics())
    steps = asked.steps or max(MIN_STEPS, min(MAX_STEPS, ROBOT_STEPS // robots))
    known = home_s = None
    for count in (0, *asked.hosts):
        if count > robots:
            continue
        sizes: dict[Kind, list[int]] = {Kind.GRANT: [], Kind.RAN: []}
        placed = hosts(world, executable, source, count, asked.dask, only_tcp=asked.only_tcp)
        with placed as fleet:
            found = step_s(world, executable, fleet, steps, sizes, first=asked.real_time)
        *measured, state = found
        row = Row(name, robots, count, *measured)
        if home_s is None:
            known, home_s = state, row.step_s
        assert state == known, "another state than at home"
        if count:
            sent, received = (int(np.median(each)) for each in sizes.values())
            least_s = echo_s(count, (sent, received), first=asked.real_time)
            more_s = (row.step_s - home_s) / max(row.rounds, 1e-9)
            row = row._replace(more_s=more_s, echo_s=least_s)
        yield row


def table(rows: Sequence[Row]) -> Iterator[str]:
    """Yield the lines of the table of `docs/performance.md`."""
    counts = ", ".join(map(str, sorted({row.hosts for row in rows} - {0})))
    yield (
        "| program | robots | rounds per timestep | ms per timestep, local |"
        f" on {counts} hosts | processor time in the environment [ms] | additional ms per round |"
    )
    yield "|" + " --- |" * 7
    for (name, robots), group in groupby(rows, lambda row: (row.program, row.robots)):
        home, *away = group
        cells = [name, f"{robots:,}", f"{(away or [home])[0].rounds:.1f}", _ms(home.step_s)]
        cells += [", ".join(_ms(each.step_s) for each in away)]
        cells += [", ".join(_ms(each.cpu_s) for each in away)]
        cells += [", ".join(f"{each.more_s * MILLISECONDS:.2f}" for each in away)]
        yield f"| {' | '.join(cells)} |"


def _ms(time_s: float) -> str:
    """Return a time with two digits [ms].

    >>> _ms(0.004249), _ms(0.0323)
    ('4.2', '32')
    """
    return f"{time_s * MILLISECONDS:.{0 if time_s > 0.00995 else 1}f}"


def main() -> None:
    """Measure all that is asked for."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("robots", nargs="*", type=int, default=[10, 100, 1000])
    parser.add_argument("--steps", type=int, help="timesteps; by default fewer for more robots")
    parser.add_argument("--hosts", nargs="*", type=int, default=[1, 2, 4])
    parser.add_argument("--real-time", action="store_true")
    parser.add_argument("--only-tcp", action="store_true", help="without local sockets")
    parser.add_argument("--dask", default="", help="address of a scheduler, for hosts there")
    parser.add_argument("--table", action="store_true", help="print a table in Markdown, too")
    asked = parser.parse_args()
    head = f"{'program':10} {'robots':>7} {'hosts':>6} {'ms/timestep':>12}"
    print(f"{head} {'cpu here':>8} {'cpu hosts':>9} {'rounds':>7}  ms/round more  echo only")
    rows: list[Row] = []
    with tempfile.TemporaryDirectory() as folder:
        for name, text in PROGRAMS.items():
            source = Path(folder, f"{name}.c")
            source.write_text(text)
            for robots in asked.robots:
                for row in measure(name, source, robots, asked):
                    print(row, flush=True)
                    rows.append(row)
    if asked.table:
        print("", *table(rows), sep="\n")


if __name__ == "__main__":
    main()
