"""Random walks through runs, forward and backward, with changes of the world on the way.

Wherever a walk comes twice without a change between, all bytes must be what they were.
"""

from __future__ import annotations

import contextlib
import random
from collections.abc import Callable
from pathlib import Path

import pytest

from crs_cc.debug.engine import Debugger
from crs_cc.debug.errors import DebugError
from crs_cc.debug.timeline.position import Position
from tests.debug.debuggers import debugger_at

SAMPLES = Path(__file__).parents[2] / "samples" / "scout_c"
FAULTS = ("sonar.3 dead", "sonar stuck 1m", "drive gain 0.5", "odometry dropouts 0.3 for 2s")


class Walk:
    """A walk through a run.

    Attributes:
        seen: what the run was at each instant where the walk has been since the last change of
            what was before: its state and what the programs had written.
        changes: how often the world was changed.
    """

    def __init__(self, debugger: Debugger, seed: int) -> None:
        self.debugger = debugger
        self.random = random.Random(seed)
        self.seen: dict[Position, tuple[str, bytes]] = {}
        self.changes = 0

    def go(self, steps: int) -> None:
        moves = [self._tick, self._tick, self._step, self._goto, self._change]
        moves += [self._resume] * any(self.debugger.stop_points.breakpoints)
        for _ in range(steps):
            with contextlib.suppress(DebugError):
                self.random.choice(moves)()
            here = (self.debugger.session.state_hash(), self.debugger.run.console.text())
            assert self.seen.setdefault(self.debugger.position, here) == here

    def _tick(self) -> None:
        self.debugger.tick(self.random.randint(1, 12), backward=self.random.random() < 0.4)

    def _step(self) -> None:
        step: Callable[..., object] = self.random.choice([self.debugger.step, self.debugger.next])
        step(self.random.randint(1, 4), backward=self.random.random() < 0.4)

    def _resume(self) -> None:
        self.debugger.resume(backward=self.random.random() < 0.7)

    def _goto(self) -> None:
        self.debugger.goto(self.random.choice(list(self.seen)))

    def _change(self) -> None:
        here = self.debugger.position
        self.debugger.edit_world(self._text())
        assert self.debugger.position == here
        self.changes += 1
        self.seen = {each: was for each, was in self.seen.items() if each < here}

    def _text(self) -> str:
        environment = self.debugger.session.environment
        area, chance = environment.world.area, self.random
        robot = chance.choice(environment.world.robots).id
        x_m = chance.uniform(area.x_min_m, area.x_max_m)
        y_m = chance.uniform(area.y_min_m, area.y_max_m)
        carried = chance.choice([robot, *environment.pushables])
        return chance.choice(
            [
                f"move {carried} to {x_m:.2f} {y_m:.2f} {chance.randint(0, 360)}",
                f"turn {robot} to {chance.randint(0, 360)}",
                f"degrade {robot} {chance.choice(FAULTS)}",
                f"heal {robot}",
                f"charge {robot} {chance.randint(0, 100)}",
                f"shut from {robot}",
                f"remove {chance.choice(environment.names)}",
            ]
        )


@pytest.mark.parametrize(
    ("program", "world", "seed", "steps"),
    [
        ("square.c", "room.xml", 1, 12),
        ("wander.c", "complex-3r.xml", 2, 60),
        ("clear_aisle.c", "warehouse.xml", 4, 60),
        ("platoon.c", "platoon.xml", 5, 60),
    ],
)
def test_the_state_at_a_position_is_path_independent(
    program: str, world: str, seed: int, steps: int
) -> None:
    debugger = debugger_at([SAMPLES / program], world)
    debugger.start()
    walk = Walk(debugger, seed)
    if steps > 50:
        debugger.stop_points.add_catchpoint("bumper")
        debugger.stop_points.add_catchpoint("degradation")
        debugger.stop_points.add_breakpoint("vm")
    walk.go(steps)
    assert walk.changes
