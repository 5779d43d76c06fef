"""Comparison of two branches at the same timestep.

Both are moved to the start of the same timestep; there the displayed state of each robot, its
program's global variables and the amount of its output are compared.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from crs_cc.debug.view import View
from crs_cc.debug.world.robot_rows import robot_rows
from crs_cc.debug.world.rows import Row

Facts = dict[tuple[str, str], str]
"""Comparable state by robot and name."""


@dataclass(frozen=True, slots=True)
class Difference:
    """A difference to another branch.

    Attributes:
        robot: the robot's name.
        name: what differs.
        here: its value in this branch; empty if it does not exist.
        there: its value in the other branch.
    """

    robot: str
    name: str
    here: str
    there: str


def facts(view: View) -> Facts:
    """Return the comparable state of a run by robot and name."""
    found = {}
    for number, robot in enumerate(view.names):
        for name, text in _of_robot(view, number):
            found[robot, name] = text
    return found


def variables(view: View) -> frozenset[tuple[str, str]]:
    """Return which of them are variables of programs: by robot and name."""
    return frozenset(
        (robot, variable.name)
        for number, robot in enumerate(view.names)
        for variable in view.globals_(robot=number)
    )


def _of_robot(view: View, robot: int) -> Iterator[tuple[str, str]]:
    yield from _flat(robot_rows(view.session, robot), "")
    for variable in view.globals_(robot=robot):
        yield variable.name, variable.value.text
    yield "bytes written", f"{len(view.run.console.text(robot)):,}"


def _flat(rows: Sequence[Row], above: str) -> Iterator[tuple[str, str]]:
    for row in rows:
        name = f"{above} {row.name}".strip()
        yield name, row.text
        yield from _flat(row.children, name)


def differences(here: Facts, there: Facts) -> list[Difference]:
    """Return the differences, in the order of this branch."""
    keys = dict.fromkeys([*here, *there])
    return [
        Difference(robot, name, here.get((robot, name), ""), there.get((robot, name), ""))
        for robot, name in keys
        if here.get((robot, name)) != there.get((robot, name))
    ]
