"""Random walks of many robots, with changes, typed input and branches on the way.

`python -m tests.debug.test_walks_of_many ROBOTS STEPS SEED` makes one of any size.
"""

from __future__ import annotations

import contextlib
import itertools
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

import pytest

from crs_cc.core.source import Diagnostics
from crs_cc.debug.engine import Debugger
from crs_cc.debug.errors import DebugError
from crs_cc.debug.program import DebugProgram
from crs_cc.debug.timeline.position import Position
from crs_cc.session.build import build_executable
from crs_cc.session.library import library_options
from crs_cc.sim.files.world_xml import load_world
from tests.debug.test_random_walks import Walk

PROGRAM = """\
#include <stdio.h>
#include "Nclient.h"
static int turns, typed;
static int nearest(void)
{
    int best = 255;
    for (int i = 0; i < 16; i++)
        if (State[STATE_SONAR_0 + i] < best)
            best = (int) State[STATE_SONAR_0 + i];
    return best;
}
int main(void)
{
    connect_robot(1);
    ac(300, 300, 0);
    for (;;) {
        gs();
        if (nearest() < 25)
            vm(-60 - typed, 90, 0);
        else
            vm(120, 120 - typed, 0);
        if (++turns % 8 == 0) {
            scanf("%d", &typed);
            printf("%d %d\\n", turns, typed);
        }
    }
}
"""
KINDS = "move", "turn", "degrade", "heal", "charge"


def world_of(robots: int) -> str:
    """Return a world in which robots stand on a grid, each with a box near by."""
    side = round(robots**0.5 + 0.49)
    places = [(2 + 3 * (n % side), 2 + 3 * (n // side)) for n in range(robots)]
    rows = [f'<robot x="{x}m" y="{y}m" heading="{41 * x % 360}deg"/>' for x, y in places]
    rows += [
        f'<box x="{x + 1}m" y="{y + 1}m" length="40cm" width="40cm" mass="3kg"/>' for x, y in places
    ]
    size = f'length="{3 * side + 2}m" width="{3 * side + 2}m"'
    return f'<world version="1"><area {size}/>{"".join(rows)}</world>'


def debugger_with(robots: int, folder: Path) -> Debugger:
    """Return the debugger of so many robots, to which a new number is typed each time."""
    (folder / "world.xml").write_text(world_of(robots))
    path = folder / "walk.c"
    path.write_text(PROGRAM)
    built = build_executable([path], Diagnostics(), debug=True)
    program, numbers = DebugProgram(built, [path], library_options()), itertools.count()
    return Debugger(
        load_world(folder / "world.xml"),
        [program] * robots,
        seed=3,
        read=lambda _robot, _wanted: b"%d\n" % (7 * next(numbers) % 50),
    )


class BranchingWalk(Walk):
    """A walk through the branches of a run."""

    def __init__(self, debugger: Debugger, seed: int) -> None:
        super().__init__(debugger, seed)
        self.by_branch: dict[str, dict[Position, tuple[str, bytes]]] = {}
        self.again = 0

    def go(self, steps: int) -> None:
        moves: list[Callable[[], None]] = [
            self._tick, self._tick, self._step, self._goto, self._resume, self._change,
            self._branch, self._switch,
        ]  # fmt: skip
        order: list[Callable[[], None]] = [self._tick]
        for _ in range(steps):
            order = order or self.random.sample(moves, len(moves))
            with contextlib.suppress(DebugError):
                order.pop()()
            here = (self.debugger.session.state_hash(), self.debugger.run.console.text())
            self.again += self.debugger.position in self.seen
            assert self.seen.setdefault(self.debugger.position, here) == here

    def _text(self) -> str:
        while (text := super()._text()).split()[0] not in KINDS:
            pass
        return text

    def _branch(self) -> None:
        left = self.debugger.branches.current.name
        self.debugger.branch(f"b{len(self.by_branch)}")
        self.by_branch[left] = self.seen
        self.seen = {each: was for each, was in self.seen.items() if each <= self.debugger.position}

    def _switch(self) -> None:
        left = self.debugger.branches.current.name
        names = [each for each in self.by_branch if each != left]
        if names:
            name = self.random.choice(names)
            self.debugger.switch(name)
            self.by_branch[left], self.seen = self.seen, self.by_branch.pop(name)


def walked(robots: int, steps: int, seed: int, folder: Path) -> BranchingWalk:
    debugger = debugger_with(robots, folder)
    debugger.start()
    debugger.stop_points.add_catchpoint("collision")
    debugger.stop_points.add_breakpoint("walk.c:19", condition="turns % 5 == 4")
    walk = BranchingWalk(debugger, seed)
    walk.go(steps)
    return walk


@pytest.mark.parametrize(("robots", "steps", "seed"), [(1, 40, 1), (10, 40, 2), (100, 16, 5)])
def test_the_state_at_a_position_of_a_branch_is_path_independent(
    robots: int, steps: int, seed: int, tmp_path: Path
) -> None:
    walk = walked(robots, steps, seed, tmp_path)
    assert walk.changes
    assert walk.by_branch
    assert walk.again


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as own:
        made = walked(*(int(each) for each in sys.argv[1:4]), Path(own))
    print(f"{made.again} times where it had been, {made.changes} changes, the same bytes")
