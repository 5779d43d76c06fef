"""A session gives the same results in any number of threads."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from crs_cc.runtime import fleet, workers
from crs_cc.runtime.executable import Executable
from crs_cc.session.session import Session
from crs_cc.session.trace import Trace
from crs_cc.sim.files.world_xml import load_world, parse_world
from crs_cc.sim.kernels import beam_field
from tests.session.programs import LOOP, ROAM, build

COMPUTE = r"""
#include <stdio.h>
#include "Nclient.h"

int main(void)
{
    unsigned sum = 0, i;
    connect_robot(1);
    for (;;) {
        for (i = 0; i < 300000; i++)
            sum = sum * 1664525 + i;
        vm(sum % 100, sum % 50, 0);
        printf("%u\n", sum);
    }
}
"""
FAIL = r"""
#include <stdlib.h>
#include "Nclient.h"

int main(void)
{
    char *block = malloc(4);
    connect_robot(1);
    gs();
    gs();
    return block[State[STATE_CONF_X] + 4];
}
"""
DEEP = r"""
static int deeper(int depth) { return deeper(depth + 1) + depth; }

int main(void) { return deeper(0); }
"""
EXIT = r"""
#include <stdio.h>
#include <unistd.h>

int main(void)
{
    puts("hello");
    usleep(400000);
    return 3;
}
"""
LOOK = r"""
#include <unistd.h>
#include "Nclient.h"

int main(void)
{
    connect_robot(1);
    for (;;) {
        get_ir();
        vm(State[STATE_IR_0] < 3 ? -200 : 200, 200 - 10 * (State[STATE_IR_0 + 4] < 2), 0);
        usleep(70000);
    }
}
"""
RING = """<robot-definition version="1" name="ring">
  <body radius="20cm" mass="10kg"/>
  <drive wheel-base="34cm" speed-limit="1m/s" acceleration-limit="2m/s2" speed="1m/s"
         acceleration="2m/s2"/>
  <sonars order=""/>
  <infrared step="20cm"/>
</robot-definition>
"""
PLACES = [(x, y) for y in (2, 6, 10) for x in (2, 6, 10)]
PRESENCE = {3: 'join="0.3s"', 6: 'leave="0.7s"', 8: 'join="0.2s" leave="0.6s"'}
WORLD = parse_world(
    '<world version="1"><area length="12m" width="12m"/>{}</world>'.format(
        "".join(
            f'<robot id="robot{number}" x="{x}m" y="{y}m" {PRESENCE.get(number, "")}/>'
            for number, (x, y) in enumerate(PLACES)
        )
    ).encode(),
    "hall",
)


@pytest.fixture(autouse=True)
def _always_parallel(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(fleet, "PARALLEL_S", -1.0)


@pytest.fixture(scope="module")
def programs(tmp_path_factory: pytest.TempPathFactory) -> list[Executable]:
    """Return a program for each robot: some drive, compute, fail, exit or loop."""
    folder = tmp_path_factory.mktemp("programs")
    built = [
        build(folder, source, f"program{number}.c")
        for number, source in enumerate((ROAM, COMPUTE, FAIL, EXIT, DEEP, LOOP))
    ]
    return [built[robot % len(built)] for robot in range(len(PLACES))]


class Run:
    """A session with all that it shows."""

    def __init__(self, programs: list[Executable], threads: int, *, is_traced: bool = True) -> None:
        self.output: list[tuple[int, int, bytes]] = []
        self.lines: list[str] = []
        names = [robot.id for robot in WORLD.robots]
        self.session = Session(
            WORLD, programs, 5, threads=threads,
            trace=Trace(self.lines.append, names) if is_traced else None,
            output=lambda *each: self.output.append(each),
        )  # fmt: skip

    def steps(self, count: int) -> Run:
        for _ in range(count):
            self.session.step()
        return self

    def shown(self) -> tuple[object, ...]:
        result = self.session.result()
        robots = [replace(each, error=None) for each in result.robots]
        errors = [each.error.text for each in result.robots if each.error]
        return result.state_hash, robots, errors, self.output, self.lines


def test_results_and_traces_are_the_same_in_any_number_of_threads(
    programs: list[Executable],
) -> None:
    shown = [Run(programs, threads).steps(20).shown() for threads in (1, 2, 3)]
    assert {each.outcome for each in shown[0][1]} == {"running", "failed", "exited", "left"}  # type: ignore[attr-defined]
    assert shown[1] == shown[0]
    assert shown[2] == shown[0]


def test_a_snapshot_resumes_in_another_number_of_threads(programs: list[Executable]) -> None:
    begun = Run(programs, 2).steps(8)
    snapshot = begun.session.snapshot()
    expected = begun.steps(10).session.state_hash()
    for threads in (1, 3):
        other = Run(programs, threads).steps(3)
        other.session.restore(snapshot)
        assert other.steps(10).session.state_hash() == expected


def test_robots_added_and_removed_are_run_in_any_number_of_threads(
    programs: list[Executable],
) -> None:
    home = WORLD.robots[0]
    guests = [
        replace(home, id=f"guest{y_m}", start=replace(home.start, x_m=4.0, y_m=y_m))
        for y_m in (4.0, 8.0)
    ]
    hashes = []
    for threads in (1, 2, 3):
        run = Run(programs, threads, is_traced=False).steps(5)
        for guest in guests:
            run.session.add_robot(guest, programs[1])
        run.session.remove_robot(1)
        hashes.append(run.steps(5).session.state_hash())
    assert len(set(hashes)) == 1


def test_breakpoints_stop_programs_in_their_order_in_any_number_of_threads(tmp_path: Path) -> None:
    debug = build(tmp_path, COMPUTE, debug=True)
    assert _stops(debug, 2) == _stops(debug, 3) == _stops(debug, 1)


def _stops(debug: Executable, threads: int) -> list[tuple[int | None, list[int]]]:
    """Return where programs stop, and the statements that each has begun by then."""
    run = Run([debug] * len(WORLD.robots), threads)
    for marks in run.session.fleet.marks:
        marks[:] = 0
        marks[3] = 1
    stops = []
    for _ in range(40):
        run.session.run_round() or run.session.end_cycle()
        stops.append((run.session.state.halted, run.session.fleet.slots["statements"].tolist()))
    assert sum(halted is not None for halted, _ in stops) > 10
    return stops


def test_rings_measure_the_same_in_any_number_of_threads(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(beam_field, "ROBOTS_PER_THREAD", 1)
    (tmp_path / "ring.xml").write_text(RING)
    robots = "".join(
        f'<robot x="{1 + n % 8}m" y="{1 + n // 8}m" heading="{37 * n % 360}deg" '
        'definition="ring.xml"/>'
        for n in range(64)
    )
    box = '<box x="4.5m" y="4.5m" length="0.4m" width="0.4m"/>'
    area = '<area length="9m" width="9m"/>'
    file = tmp_path / "world.xml"
    file.write_text(f'<world version="1" timestep="100ms">{area}{box}{robots}</world>')
    program, hashes = build(tmp_path, LOOK), set()
    for threads in (1, 2, 3):
        session = Session(load_world(file), [program] * 64, 5, threads=threads)
        for _ in range(12):
            session.step()
        field = session.environment._running.rays._field
        assert field is not None
        assert len(field._sorted) == threads
        hashes.add(session.state_hash())
    assert len(hashes) == 1
    readings = session.environment.state.devices.infrared.level
    assert len(np.unique(readings)) > 5


def test_threads_are_used_only_by_rounds_that_take_long(
    programs: list[Executable], monkeypatch: pytest.MonkeyPatch
) -> None:
    calls: list[int] = []

    def run_all(tasks: list[workers.Task]) -> None:
        calls.append(len(tasks))
        workers.run_all(tasks)

    monkeypatch.setattr(fleet, "PARALLEL_S", 0.0003)
    monkeypatch.setattr(fleet, "run_all", run_all)
    exits = Run([programs[3]] * len(WORLD.robots), 2).steps(20)
    assert not exits.session.state.alive.any()
    assert not calls
    Run([programs[1]] * len(WORLD.robots), 2).steps(20)
    assert len(calls) > 10
