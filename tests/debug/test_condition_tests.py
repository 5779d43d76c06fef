"""Conditions that programs test themselves change how long a run takes, and nothing else."""

from __future__ import annotations

import random
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from crs_cc.debug.condition_tests import ConditionTests
from crs_cc.debug.engine import Debugger
from tests.debug.debuggers import debugger_at, debugger_of

RECURSION = """\
static int down(int n)
{
    if (n == 0)
        return 0;
    return 1 + down(n - 1);
}
int main(void) { return down(2000) != 2000; }
"""
PROGRAM = """\
#include <stdlib.h>
struct node { short key; unsigned char tag; struct node *next; double weight; };
static struct node *head;
static int calls;
static long long total = -5;
static float share;
static const int table[4] = {3, 1, 4, 1};
static int push(int key, char tag)
{
    int later;
    struct node *made = malloc(sizeof *made);
    calls++;
    made->key = (short) key;
    made->tag = (unsigned char) tag;
    made->next = head;
    if (key % 3)
        made->weight = key / 2.0;
    later = key * 2;
    share = later / 7.0f;
    total += later;
    head = made;
    return later;
}
static int sum(int count, const int values[count])
{
    int found = 0;
    for (int i = 0; i < count; i++) {
        int square = values[i] * values[i];
        found += square;
    }
    return found;
}
static int down(int n) { return n ? down(n - 1) + 1 : 0; }
int main(void)
{
    int values[6] = {0};
    for (int i = 0; i < 6; i++) {
        values[i] = push(i - 2, 'a' + i);
        down(i);
        sum(i, values);
    }
    return 0;
}
"""
CONDITIONS = {
    "a.c:19": (
        "key == 3", "later > 0", "head && head->key > 0", "head->key > 0", "made->weight > 0.4",
        "key % calls == 1", "10 / key > 1", "made->tag == 'c'", "total < -5", "share >= 0.25f",
        "key = 3", "calls++ == 3", "table[key] == 4", "(long long) key << 40 > 0", "!head",
        "made->next ? made->next->tag < 'c' : 1", "sizeof(int) == 8", "abs(key) == 2", "key > $old",
        "tag", "made == head", "(unsigned) key > 5u", "table[calls & 3] == 1", "\"ab\"[key] == 'b'",
        "*(int *) 0 == 0", "main::values[1] == 0", "share", "(int) (share * 9) == 5",
        "-key / -1 == 2", "key == 1 || later", "key == 1 && later", "~key & 1", "-share < 0",
    ),
    "a.c:29": ("square > 1", "values[i] == i", "count == 3 && !i", "sizeof values[0] == i"),
    "a.c:31": ("count == 2", "found > 3", "found % 2"),
    "down": ("n == 0", "n == 2", "calls == 4 && n"),
}  # fmt: skip


def stops(debugger: Debugger, *, backward: bool = False) -> list[tuple[object, ...]]:
    """Return all that is told of the stops up to the end of the run, or back to its beginning."""
    found: list[tuple[object, ...]] = []
    while True:
        stop = debugger.resume(backward=backward)
        hits = [each.hits for each in debugger.stop_points.breakpoints]
        found.append((stop.position, stop.reason, stop.breakpoints, stop.text, hits))
        if stop.reason != "breakpoint" or len(found) > 200:
            return found


def both_ways(
    make: Callable[[], Debugger], *, tests: bool, **conditions: list[str]
) -> tuple[object, ...]:
    """Return the stops forward and backward, and the state at the end."""
    debugger = make()
    if not tests:
        debugger.navigator._set_tests = lambda _robot, _conditions: None
    for place, texts in conditions.items():
        for text in texts:
            debugger.stop_points.add_breakpoint(place, condition=text)
    debugger.start()
    forward = stops(debugger)
    state = debugger.session.state_hash()
    return forward, state, stops(debugger, backward=True)


@pytest.mark.parametrize("place", CONDITIONS)
def test_stops_are_those_of_conditions_that_the_debugger_tests(place: str) -> None:
    def make() -> Debugger:
        debugger = debugger_of(PROGRAM)
        debugger.evaluate("$old = 1")
        return debugger

    untested = both_ways(make, tests=True)
    for condition in CONDITIONS[place]:
        own = {place: [condition]}
        found = both_ways(make, tests=True, **own)
        assert found == both_ways(make, tests=False, **own), condition
        assert found[1] == untested[1], condition


@pytest.mark.parametrize("seed", range(4))
def test_several_conditions_at_one_place_and_steps_between(seed: int) -> None:
    chance = random.Random(seed)
    own = {place: chance.sample(texts, 2) for place, texts in CONDITIONS.items()}
    moves = [chance.choice(["step", "next", "finish", "resume", "back"]) for _ in range(40)]

    def walk(*, tests: bool) -> list[object]:
        debugger = debugger_of(PROGRAM)
        if not tests:
            debugger.navigator._set_tests = lambda _robot, _conditions: None
        debugger.evaluate("$old = 1")
        for place, texts in own.items():
            for text in texts:
                debugger.stop_points.add_breakpoint(place, condition=text)
        debugger.stop_points.add_breakpoint("down", condition="n == 1", ignore=2)
        debugger.start()
        found: list[object] = []
        for move in moves:
            if move == "back":
                debugger.resume(backward=True)
            elif move != "finish" or len(debugger.view.frames()) > 1:
                getattr(debugger, move)()
            if debugger.view.is_over:
                debugger.goto_statement(1)
            found.append((debugger.stop, debugger.session.state_hash()))
        return found

    assert walk(tests=True) == walk(tests=False)


def test_a_false_condition_does_not_stop_the_program() -> None:
    debugger = debugger_of(RECURSION)
    debugger.start()
    debugger.stop_points.add_breakpoint("down", condition="n == 0")
    before = debugger.run.sites_passed(0)
    events = 0
    advance = debugger.run._advance

    def counted(limit: object) -> object:
        nonlocal events
        events += 1
        return advance(limit)  # type: ignore[arg-type]

    debugger.run._advance = counted  # type: ignore[assignment, method-assign]
    assert debugger.resume().reason == "breakpoint"
    assert debugger.view.evaluate_pure("n").number == 0
    assert debugger.run.sites_passed(0) - before > 2000
    assert events < 10


def test_in_a_watching_build() -> None:
    def make() -> Debugger:
        debugger = debugger_of(PROGRAM)
        debugger.start()
        debugger.stop_points.add_watchpoint("total")
        return debugger

    own = {"a.c:19": ["key == 1", "later == 2"], "down": ["n == 1"]}
    assert both_ways(make, tests=True, **own) == both_ways(make, tests=False, **own)


def test_each_robot_tests_its_own_variables() -> None:
    path = Path(__file__).parents[2] / "samples" / "scout_c" / "platoon.c"

    def make() -> Debugger:
        return debugger_at([path], "platoon.xml")

    def run(*, tests: bool) -> list[object]:
        debugger = make()
        if not tests:
            debugger.navigator._set_tests = lambda _robot, _conditions: None
        debugger.stop_points.add_breakpoint("vm", condition="State[34] > 200")
        debugger.start()
        return [debugger.resume() for _ in range(12)]

    assert run(tests=True) == run(tests=False)


class OneProgram:
    """A program that exists as long as something refers to it."""


class Fleet:
    """A fleet of one program after the other; `given` is whose tests it was given last."""

    current: OneProgram | None

    def executable(self, _robot: int) -> OneProgram | None:
        return self.current

    def set_tests(self, _robot: int, tests: str) -> None:
        self.given = tests


def test_a_program_is_not_given_the_tests_of_one_that_is_gone(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    fleet = Fleet()
    view: Any = SimpleNamespace(session=SimpleNamespace(fleet=fleet))
    tests = ConditionTests(view)
    for number in range(10):
        monkeypatch.setattr(tests, "_compiled", lambda *_, number=number: f"tests {number}")
        fleet.current = None
        fleet.current = OneProgram()  # where the one before was, unless that is kept
        tests.set(0, {1: ("1",)})
        assert fleet.given == f"tests {number}"
