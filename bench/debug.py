"""Measures what it costs to run under the debugger, and to go back.

Scouts stand on a 4 m grid in an arena with a box beside each. Each runs the C program below: it
reads its sonars as often as the line lets it, drives, and turns on the spot while something is
near; the function `minute` is called once a minute, of 60 s unless it is shortened, `never` never.
The same is run by the run build in a plain session, by the debug build under the debugger with a
breakpoint in `never`, and by the watching build with a watchpoint on a variable that nobody
touches. Then the user goes back, to a breakpoint of one robot and to one of all. Then a
breakpoint with a condition is passed at each depth of a deep recursion, and last the user asks
where a value came from that is a minute old; the goals are printed with these figures.

    python bench/debug.py [--minutes M] [--minute S] [--depth N] [ROBOTS[:MINUTES] ...]

`python bench/debug.py 1:60 100:2 1000:1` is the run of `docs/performance.md`: an hour of one robot
comes first, since the most memory that the process has had counts.
"""

from __future__ import annotations

import argparse
import gc
import resource
import statistics
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from crs_cc.core.source import Diagnostics
from crs_cc.debug.engine import Debugger
from crs_cc.debug.past import Past
from crs_cc.debug.program import DebugProgram
from crs_cc.debug.why import Why
from crs_cc.frontend.preprocess.options import Options
from crs_cc.session.build import build_executable
from crs_cc.session.library import HEADERS
from crs_cc.session.session import Session
from crs_cc.sim.files.world_xml import empty_world, load_world
from crs_cc.sim.model.world import WorldModel

PROGRAM = r"""
#include <stdio.h>
#include <sys/time.h>
#include "Nclient.h"

static int near[16], minutes, untouched;

static void never(void) { untouched++; }

static void minute(void)
{
    minutes++;
    printf("minute %d at %ld %ld\n", minutes, State[STATE_CONF_X], State[STATE_CONF_Y]);
}

static int nearest(void)
{
    int i, best = 0;

    for (i = 0; i < 16; i++)
        near[i] = (int) State[STATE_SONAR_0 + i];
    for (i = 0; i < 16; i++)
        if ((i < 3 || i > 13) && near[i] < near[best])
            best = i;
    return near[best];
}

int main(void)
{
    struct timeval start, now;

    gettimeofday(&start, 0);
    if (!connect_robot(1))
        return 1;
    ac(300, 300, 0);
    for (;;) {
        gs();
        if (nearest() < 25)
            vm(0, 300, 0);
        else
            vm(120, 0, 0);
        gettimeofday(&now, 0);
        if ((now.tv_sec - start.tv_sec) / SECONDS > minutes)
            minute();
        if (minutes < 0)
            never();
    }
}
"""
RECURSION = """
static int down(int n)
{
    if (n == 0)
        return 0;
    return 1 + down(n - 1);
}
int main(void)
{
    return down(DEPTH);
}
"""
ASKED = r"""
#include <unistd.h>
#include "Nclient.h"

static int first, gap, turns;

int main(void)
{
    connect_robot(1);
    gs();
    first = (int) State[STATE_SONAR_0] * 3;
    gap = first + 2;
    conf_tm(0);
    vm(30, first, 0);
    for (;;) {
        gs();
        turns++;
        usleep(80000);
    }
}
"""
MANY = 100
AGAIN = 5
"""How often each way back is taken; the median counts."""


@dataclass
class Bench:
    """A world of so many robots, and how long it is to run: so many times so many seconds."""

    folder: Path
    robots: int
    minutes: int
    minute_s: int

    def __post_init__(self) -> None:
        self.program = self.folder / "drive.c"
        self.program.write_text(f"#define SECONDS {self.minute_s}\n{PROGRAM}")
        world = self.folder / f"{self.robots}.xml"
        world.write_text(world_text(self.robots))
        self.world: WorldModel = load_world(world)
        self.timesteps = round(self.minute_s * self.minutes / self.world.timestep_s)

    def run_build_s(self) -> float:
        """Return the time that a run takes without the debugger [s]."""
        executable = build_executable([self.program], Diagnostics())
        session = Session(self.world, [executable] * self.robots)
        return timed(lambda: [session.step() for _ in range(self.timesteps)])

    def debugger(self) -> Debugger:
        """Return the debugger before the run."""
        options = Options((), (HEADERS,))
        executable = build_executable([self.program], Diagnostics(), debug=True)
        program = DebugProgram(executable, [self.program], options)
        return Debugger(self.world, [program] * self.robots)


def world_text(robots: int) -> str:
    """Return the world file."""
    side = max(1, round(robots**0.5 + 0.49))
    places = [(2 + 4 * (n % side), 2 + 4 * (n // side)) for n in range(robots)]
    elements = [f'<robot x="{x}m" y="{y}m" heading="{37 * x % 360}deg"/>' for x, y in places]
    elements += [
        f'<box x="{x + 1.2}m" y="{y + 1.2}m" length="0.5m" width="0.5m"/>' for x, y in places
    ]
    size = f'length="{4 * side}m" width="{4 * side}m"'
    return f'<world version="1"><area {size}/>{"".join(elements)}</world>'


def timed(work: Callable[[], object]) -> float:
    """Return the processor time of something [s]."""
    start = time.process_time()
    work()
    return time.process_time() - start


class Table:
    """What was measured, line by line."""

    def __init__(self, robots: int) -> None:
        self.robots = robots

    def row(self, what: str, seconds: float, ratio: float, unit: str) -> None:
        """Print a line."""
        print(f"{self.robots:7} {what:32}{seconds:10.3f} s{ratio:10.4g} {unit}", flush=True)


def forward(bench: Bench, table: Table) -> tuple[Debugger, float]:
    """Measures the way forward; gives the debugger at its end, and its time for a minute [s].

    The debugger comes first: its memory is the most that the process has had.
    """
    debugger = bench.debugger()
    debugger.stop_points.add_breakpoint("never")
    seconds = timed(lambda: debugger.tick(bench.timesteps))
    if debugger.stop.reason != "tick":
        sys.exit(f"stopped: {debugger.stop}")
    history = debugger.run.history
    print(f"{bench.robots:7} {len(history)} snapshots, {history.size / 2**20:.0f} MiB")
    simulated = f"{bench.minutes * bench.minute_s / 60:g} minutes"
    most = "300 MiB for an hour" if bench.robots == 1 else "none"
    goal(f"memory at most, {simulated}", f"{peak_mib():.0f} MiB", most)
    plain_s = bench.run_build_s()
    table.row("run build", plain_s, plain_s / bench.timesteps * 1000, "ms for a timestep")
    table.row("breakpoint not hit", seconds, seconds / plain_s, "x run build")
    watching = bench.debugger()
    watching.stop_points.add_watchpoint("untouched")
    few = max(1, bench.timesteps // 10)
    watching_s = timed(lambda: watching.tick(few))
    over = plain_s * few / bench.timesteps
    table.row(
        "watchpoint not hit", watching_s, watching_s / over, "x run build (a tenth of the way)"
    )
    return debugger, seconds / bench.minutes


def backward(bench: Bench, table: Table, debugger: Debugger, minute_s: float) -> None:
    """Measures the ways back, the short ones again and again."""
    forward_s = minute_s * bench.minutes

    def again(what: str, move: Callable[[], object]) -> None:
        seconds = statistics.median(timed(move) for _ in range(AGAIN))
        table.row(what, seconds, seconds / forward_s, "x the way forward")

    debugger.step()
    again("reverse-step", lambda: debugger.step(backward=True))
    again("reverse-next", lambda: debugger.next(backward=True))
    again("tick backward", lambda: debugger.tick(backward=True))
    minute = round(bench.minute_s / bench.world.timestep_s)
    for each in debugger.stop_points.breakpoints:  # that of the way forward concerns all robots
        debugger.stop_points.remove(each.number)
    debugger.stop_points.add_breakpoint("minute", robot=0)
    debugger.goto_timestep(bench.timesteps - 1)
    seconds = timed(lambda: debugger.resume(backward=True))
    back = bench.timesteps - debugger.position.timestep
    if abs(back - minute) > 1:
        sys.exit(f"went {back} timesteps back, not {minute}: {debugger.stop}")
    table.row("reverse-continue, a minute", seconds, seconds / minute_s, "x a minute forward")
    if bench.robots == MANY:
        goal(f"reverse-continue, one of {MANY} robots", f"{seconds:.2f} s", "2 s")
    if bench.robots > 1:
        debugger.stop_points.add_breakpoint("minute")
        debugger.goto_timestep(bench.timesteps - 1)
        seconds = timed(lambda: debugger.resume(backward=True))
        table.row("the same, of all robots", seconds, seconds / minute_s, "x a minute forward")
        if bench.robots == MANY:
            goal(f"reverse-continue, all of {MANY} robots", f"{seconds:.2f} s", "2 s")
    middle = bench.timesteps // 2 + 3
    seconds = timed(lambda: debugger.goto_timestep(middle))
    table.row("goto the middle", seconds, seconds / forward_s, "x the way forward")


def peak_mib() -> float:
    """Return the most memory that the process has had so far [MiB]."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def goal(what: str, figure: str, most: str) -> None:
    """Print a figure and its goal."""
    print(f"{'':7} {what:36}{figure:>8} (goal {most})", flush=True)


def deep(folder: Path, depth: int) -> None:
    """Measures stops in a recursion, each deeper than the last, and steps at its end."""
    source = folder / "down.c"
    source.write_text(RECURSION.replace("DEPTH", str(depth)))
    executable = build_executable([source], Diagnostics(), debug=True)
    program = DebugProgram(executable, [source], Options((), (HEADERS,)))
    debugger = Debugger(empty_world(), [program])
    debugger.start()
    debugger.stop_points.add_breakpoint("down", condition="n == 0")

    gc.collect()  # what earlier parts have left is not part of it
    seconds = timed(debugger.resume)
    if debugger.stop.reason != "breakpoint":
        sys.exit(f"stopped: {debugger.stop}")
    goal(f"break if, {depth:,} deep", f"{seconds:.2f} s", "1 s")
    goal("a condition, tested by programs", f"{1e6 * seconds / depth:.1f} us", "20 us")
    seconds = statistics.median(timed(lambda: debugger.step(backward=True)) for _ in range(AGAIN))
    goal("reverse-step there", f"{1e3 * seconds:.0f} ms", "50 ms")
    evaluator = debugger.view.evaluator(0)
    seconds = timed(lambda: [evaluator.holds("n == 0") for _ in range(1000)]) / 1000
    goal("a condition, evaluated", f"{1e6 * seconds:.1f} us", "20 us")


def asked(folder: Path, minute_s: int) -> None:
    """Measures questions about the past, at first with the builds that they need."""
    source = folder / "asked.c"
    source.write_text(ASKED)
    executable = build_executable([source], Diagnostics(), debug=True)
    program = DebugProgram(executable, [source], Options((), (HEADERS,)))
    debugger = Debugger(empty_world(), [program])
    debugger.goto_time(minute_s + 0.5)

    def why() -> None:
        cause = Why(debugger.view, debugger.navigator).explain("gap")
        if not cause.causes or not cause.causes[0].causes:
            sys.exit(f"not explained: {cause}")

    goal("why, a minute old, first time", f"{timed(why):.2f} s", "2 s")
    goal("why, a minute old, again", f"{timed(why):.2f} s", "2 s")

    def moved() -> None:
        cause = Why(debugger.view, debugger.navigator).explain("robot0.heading")
        if not cause.causes or not cause.causes[0].causes:
            sys.exit(f"not explained: {cause}")

    goal("why robot0.heading, a minute old", f"{timed(moved):.2f} s", "2 s")
    past = Past(debugger.view, debugger.stop_points)
    for expression in ("turns", "robot0.heading"):
        seconds = timed(partial(past.values, expression, past.whole()))
        print(f"{'':7} {f'history {expression}, a minute':32}{seconds:10.2f} s", flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", 1)[0])
    parser.add_argument("robots", nargs="*", default=["1", "100"], metavar="ROBOTS[:MINUTES]")
    parser.add_argument("--minutes", type=int, default=10, help="whole ones (default 10)")
    parser.add_argument("--minute", type=int, default=60, help="seconds of one (default 60)")
    parser.add_argument("--depth", type=int, default=10_000, help="of the recursion (10000)")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        for wanted in options.robots:
            robots, _, minutes = wanted.partition(":")
            table = Table(int(robots))
            bench = Bench(
                Path(folder), int(robots), int(minutes or options.minutes), options.minute
            )
            backward(bench, table, *forward(bench, table))
        deep(Path(folder), options.depth)
        asked(Path(folder), options.minute)


if __name__ == "__main__":
    main()
