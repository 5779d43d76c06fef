"""Hostile programs harm themselves alone.

Each program in `hostile/` says in a comment `// ends: ...` what becomes of it: `running` (it has no
end), `exit 0`, the kind of a run-time error, `failed` (some error) or `any`.
"""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import pytest

from crs_cc.core.errors import CrsError
from crs_cc.requests import ERROR_KINDS
from crs_cc.session.session import Session
from crs_cc.sim.files.world_xml import parse_world
from tests.c.execution import HERE, Outcome, Run, Stepping, build, cases, mark, name

FUEL, FUEL_OF_A_ROUND, ROUNDS = 10_000_000, 1_000_000, 4000

HALL = parse_world(
    b"""<world version="1">
    <area length="20m" width="4m"/>
    <robot id="neighbour" x="1m" y="2m"/>
    <robot id="hostile" x="19m" y="2m" heading="180deg"/>
    </world>""",
    "hall.xml",
)
TIMESTEPS = 6
"""After so many, hostile programs have failed, or filled all that they can fill."""


def ending(outcome: Outcome) -> str:
    if outcome.failure is not None:
        return outcome.failure.kind
    return "running" if outcome.status is None else f"exit {outcome.status}"


@pytest.mark.parametrize("path", cases("hostile"), ids=name)
def test_a_hostile_program_ends_as_it_must(path: Path, request: pytest.FixtureRequest) -> None:
    if mark(path, "deep"):
        request.getfixturevalue("users_settings")
    match = re.search(r"// ends: (.*)", path.read_text())
    assert match is not None
    end = ending(Run(build(path), Stepping(FUEL_OF_A_ROUND)).up_to(FUEL, ROUNDS))
    allowed = {
        "failed": set(ERROR_KINDS),
        "any": {*ERROR_KINDS, "running", *(f"exit {status}" for status in range(256))},
    }.get(match[1], {match[1]})
    assert end in allowed - {"internal trap"}


def run_beside(path: Path, *, checked: bool) -> tuple[object, ...]:
    """Return everything that is known of a robot with another program beside it."""
    written: list[bytes] = []

    def output(robot: int, _stream: int, content: bytes) -> None:
        if robot == 0:
            written.append(content)

    programs = [build(HERE / "neighbour.c"), build(path, checked=checked)]
    session = Session(HALL, programs, output=output)
    for _ in range(TIMESTEPS):
        session.step()
    robot = session.result().robots[0]
    memory = session.fleet.snapshot(0)
    return robot, b"".join(written), memory.chunks.tobytes(), memory.content.tobytes()


@cache
def beside_a_quiet_one() -> tuple[object, ...]:
    return run_beside(HERE / "valid/functions/main_without_return.c", checked=True)


@pytest.mark.parametrize("checked", [True, False], ids=["checked", "unchecked"])
@pytest.mark.parametrize("path", cases("hostile"), ids=name)
def test_a_hostile_program_changes_nothing_for_its_neighbour(path: Path, checked: bool) -> None:
    assert run_beside(path, checked=checked) == beside_a_quiet_one()


def test_an_endless_loop_changes_nothing_for_its_neighbour() -> None:
    _robot, output, *_ = beside_a_quiet_one()
    assert b"at" in output  # type: ignore[operator]
    assert run_beside(HERE / "hostile/endless_loop.c", checked=True) == beside_a_quiet_one()


@pytest.mark.parametrize("size", [1000, 40_000])
def test_random_bytes_are_no_program(tmp_path: Path, size: int) -> None:
    source = tmp_path / "random.c"
    state = size
    content = bytearray()
    for _ in range(size):
        state = (state * 1664525 + 1013904223) % 2**32
        content.append(state >> 24)
    source.write_bytes(content)
    with pytest.raises(CrsError):
        build(source)
