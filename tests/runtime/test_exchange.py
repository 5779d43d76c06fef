"""A program can be moved to another build wherever it has stopped, without any effect."""

from __future__ import annotations

from dataclasses import fields
from pathlib import Path

import numpy as np
import pytest

from crs_cc.core.source import Diagnostics
from crs_cc.runtime.executable import Executable, make_executable
from crs_cc.runtime.fleet import Fleet
from crs_cc.session.build import build_executable
from crs_cc.session.host import Host, HostRequest
from tests.c.execution import cases, name, sources

PROGRAM = """\
#include <stdio.h>
#include <stdlib.h>
struct node { int key; struct node *left, *right; };
static struct node *add(struct node *to, int key)
{
    if (!to) {
        to = malloc(sizeof *to);
        to->key = key;
        to->left = to->right = NULL;
    } else if (key < to->key)
        to->left = add(to->left, key);
    else
        to->right = add(to->right, key);
    return to;
}
static double weigh(const struct node *at, double each)
{
    return at ? weigh(at->left, each / 2) + at->key * each + weigh(at->right, each / 3) : 0;
}
int main(void)
{
    struct node *tree = NULL;
    for (int i = 0; i < 20; i++)
        tree = add(tree, i * 7 % 20);
    printf("%.6f\\n", weigh(tree, 1));
    return 3;
}
"""


class Moving:
    """A program that stops before every so many statements, and may change builds there."""

    def __init__(self, builds: list[Executable]) -> None:
        self.builds = builds
        self.fleet = Fleet(builds[:1])
        self.output = output = bytearray()
        self.host = Host([["moving"]], lambda *written: output.extend(written[2]), lambda *_: b"")
        self.ended = False

    def run(self, statements: int) -> None:
        slot = self.fleet.slots[0]
        slot["run"], slot["fuel"], slot["stop_before_all"] = 1, 10**9, 1
        slot["stop_from"] = slot["statements"] + statements
        self.fleet.run_round()
        if slot["code"]:
            self.host.serve(int(slot["code"]), HostRequest(0, slot["message"]))
        self.ended = self.host.exit_status[0] is not None or slot["status"] != 1


def both(path: Path) -> list[Executable]:
    plain = build_executable(sources(path), Diagnostics(), debug=True)
    watching = make_executable(plain.program, plain.name, debug=True, watching=True)
    return [plain, watching]


@pytest.fixture(scope="module")
def builds(tmp_path_factory: pytest.TempPathFactory) -> list[Executable]:
    path: Path = tmp_path_factory.mktemp("moved") / "moved.c"
    path.write_text(PROGRAM)
    return both(path)


def same(one: Fleet, other: Fleet) -> bool:
    a, b = one.snapshot(0), other.snapshot(0)
    # Bytes, since a slot may hold numbers that are not equal to themselves.
    names = [each.name for each in fields(a)]
    return all(
        np.asarray(getattr(a, x)).tobytes() == np.asarray(getattr(b, x)).tobytes() for x in names
    )


def compare(builds: list[Executable], statements: int, most: int = 200) -> Moving:
    """Run a program twice, once from build to build; all bytes are the same at every stop."""
    staying, moving = Moving(builds), Moving(builds)
    turn = 0
    while not staying.ended and turn < most:
        turn += 1
        staying.run(statements)
        moving.run(statements)
        moving.fleet.exchange(0, builds[turn % 2])
        assert moving.fleet.executable(0) is builds[turn % 2]
        assert same(staying.fleet, moving.fleet), turn
    assert staying.output == moving.output
    return moving


def test_a_program_that_changes_builds_does_the_same(builds: list[Executable]) -> None:
    moving = compare(builds, 7)
    assert moving.output == b"5.824417\n"


@pytest.mark.parametrize("path", cases("valid")[::9], ids=name)
def test_every_kind_of_program_can_change_builds(path: Path) -> None:
    compare(both(path), 53)


def test_changing_back_and_forth_creates_no_more_sandboxes(builds: list[Executable]) -> None:
    fleet = Fleet(builds[:1])
    for turn in range(10):
        fleet.exchange(0, builds[turn % 2])
    assert fleet._shards[0].instances == 3  # the driver, and one of each build


def test_breakpoints_are_kept_when_builds_change(builds: list[Executable]) -> None:
    fleet = Fleet(builds[:1])
    fleet.marks[0][2] = 1
    fleet.exchange(0, builds[1])
    assert fleet.marks[0][2] == 1
    fleet.marks[0][2], fleet.marks[0][5] = 0, 1
    fleet.exchange(0, builds[0])
    assert np.flatnonzero(fleet.marks[0])[0] == 5


def test_a_snapshot_of_one_build_resumes_in_the_other(builds: list[Executable]) -> None:
    one, other = Moving(builds), Moving(builds[::-1])
    one.run(60)
    other.fleet.restore(0, one.fleet.snapshot(0))
    assert same(one.fleet, other.fleet)
    for each in (one, other):
        while not each.ended:
            each.run(1000)
    assert one.output == other.output


def test_programs_can_be_added_and_removed_after_an_exchange(builds: list[Executable]) -> None:
    fleet = Fleet(builds[:1])
    fleet.add(builds[0])
    fresh = fleet.snapshot(1)
    fleet.exchange(0, builds[1])
    fleet.exchange(1, builds[1])
    made = fleet._shards[0].instances
    fleet.truncate(1)
    assert fleet.add(builds[0]) == 1
    assert fleet.executable(1) is builds[0]
    assert fleet._shards[0].instances == made
    again = fleet.snapshot(1)
    assert np.array_equal(again.content, fresh.content)
    fleet.slots["run"], fleet.slots["fuel"] = 1, 10**6
    fleet.run_round()
    assert fleet.slots["code"].all()
