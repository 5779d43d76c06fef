"""A program that has stopped on the way is, byte for byte, one that has not."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.core.source import Diagnostics
from crs_cc.runtime.executable import Executable
from crs_cc.session.build import build_executable
from crs_cc.session.session import Session
from crs_cc.sim.files.world_xml import load_world

ROOT = Path(__file__).parents[2]


def sample(name: str) -> Executable:
    path = ROOT / "samples" / "scout_c" / name
    return build_executable([path], Diagnostics(), debug=True)


def state_at(program: Executable, world: str, statements: int, *, first_stop: int) -> str:
    """Return the state hash when so many statements have begun.

    Args:
        program: what all robots run.
        world: where.
        statements: how many statements of the first robot.
        first_stop: from how many on it stops before each.
    """
    model = load_world(ROOT / "worlds" / world)
    session = Session(model, [program] * len(model.robots), seed=1)
    slots = session.fleet.slots
    slots["stop_before_all"][0], slots["stop_from"][0] = 1, first_stop
    while slots["statements"][0] < statements:
        if not session.begin_round():
            assert session.end_cycle()
            continue
        session.run_programs()
        if session.state.halted is None:
            session.end_round()
    return session.state_hash()


@pytest.mark.parametrize(
    ("program", "world", "statements"),
    [
        ("behaviours.c", "cluttered.xml", 900),
        ("grid_map.c", "studio.xml", 2500),
        ("wander.c", "pair.xml", 800),
        ("potential.c", "cluttered.xml", 2500),
    ],
)
def test_stopping_leaves_no_trace(program: str, world: str, statements: int) -> None:
    built = sample(program)
    at_once = state_at(built, world, statements, first_stop=statements)
    assert state_at(built, world, statements, first_stop=0) == at_once
    assert state_at(built, world, statements, first_stop=statements // 2) == at_once
