"""Watchpoints under the engine: forward and backward, in one robot or several."""

from __future__ import annotations

import re

import pytest

from crs_cc.debug.engine import Debugger
from crs_cc.debug.errors import DebugError
from crs_cc.debug.watch import MAX
from tests.debug.debuggers import debugger_of, line

LOOP = """\
#include <stdio.h>
#include <stdlib.h>
int total, flag;
struct { int x, order[3]; } goal;
static int twice(int what)
{
    int result = what;
    result += what;
    return result;
}
int main(void)
{
    int i, *p = NULL;
    for (i = 1; i < 4; i++) {
        total += twice(i);
        goal.order[i % 3] = i;
    }
    flag = total;
    p = malloc(sizeof *p);
    *p = 4;
    free(p);
    flag = 7;
}
"""


@pytest.fixture
def loop() -> Debugger:
    debugger = debugger_of(LOOP)
    debugger.start()
    return debugger


def texts(debugger: Debugger, *, backward: bool = False) -> list[str]:
    """Return what is said at each stop up to the end, or to the beginning."""
    found = []
    while (stop := debugger.resume(backward=backward)).reason == "watchpoint":
        found.append(stop.text)
    assert stop.reason == ("beginning" if backward else "end")
    return found


def go(debugger: Debugger, place: str) -> None:
    point = debugger.stop_points.add_breakpoint(place)
    debugger.resume()
    debugger.stop_points.remove(point.number)


def test_a_watchpoint_stops_after_a_write_and_in_reverse_before_it(loop: Debugger) -> None:
    point = loop.stop_points.add_watchpoint("total")
    loop.resume()
    assert loop.stop.text == "total: 0 -> 2, written at a.c:15"
    assert loop.stop.breakpoints == (point.number,)
    assert line(loop) == 16
    assert loop.evaluate("total").text == "2"
    loop.resume(backward=True)
    assert loop.stop.text == "total: 0 -> 2, written at a.c:15"
    assert loop.evaluate("total").text == "0"
    assert (loop.view.current_frame().function, line(loop)) == ("main", 15)  # type: ignore[union-attr]
    loop.resume()
    assert (line(loop), point.hits) == (16, 2)


def test_both_directions_find_the_same(loop: Debugger) -> None:
    for what, kind in (("total", "change"), ("goal", "write"), ("flag", "access"), ("i", "write")):
        loop.stop_points.add_watchpoint(what, kind)  # type: ignore[arg-type]
    forward = texts(loop)
    assert forward[:4] == [
        "i: uninitialised -> 1, written at a.c:14",
        "total: 0 -> 2, written at a.c:15",
        "goal.order[1]: 0 -> 1, written at a.c:16",
        "i: 1 -> 2, written at a.c:14",
    ]
    assert forward[-2:] == [
        "flag: 0 -> 12, written at a.c:18",
        "flag: 12 -> 7, written at a.c:22; i went out of scope: 'main' has returned at a.c:11",
    ]
    assert texts(loop, backward=True) == forward[::-1]
    assert texts(loop) == forward


def test_backward_finds_the_access_just_before(loop: Debugger) -> None:
    go(loop, "18")
    # The loop's last statement but for `i++` wrote it.
    loop.stop_points.add_watchpoint("goal.order[0]")
    loop.step_statement(backward=True)
    assert loop.resume(backward=True).text == "goal.order[0]: 0 -> 3, written at a.c:16"
    assert line(loop) == 16


def test_backward_from_the_end_finds_the_last_write(loop: Debugger) -> None:
    loop.stop_points.add_watchpoint("flag")
    loop.goto_timestep(1)
    assert loop.view.is_over
    assert loop.resume(backward=True).text == "flag: 12 -> 7, written at a.c:22"
    assert line(loop) == 22


def test_a_local_watchpoint_lasts_as_long_as_its_function(loop: Debugger) -> None:
    go(loop, "8")
    point = loop.stop_points.add_watchpoint("result", "write")
    assert point.watch
    assert point.watch.note == "lasts until 'twice' returns"
    forward = [
        "result: 1 -> 2, written at a.c:8",
        "result went out of scope: 'twice' has returned at a.c:9",
    ]
    assert texts(loop) == forward
    first = loop.resume(backward=True), loop.resume(backward=True), loop.resume(backward=True)
    assert [each.text for each in first[:2]] == forward[::-1]
    assert re.fullmatch("result: .* -> 1, written at a.c:7", first[2].text)
    assert loop.resume(backward=True).reason == "beginning"
    assert texts(loop)[1:] == forward


def test_stepping_stops_at_watchpoints(loop: Debugger) -> None:
    loop.stop_points.add_watchpoint("goal")
    reasons = []
    while (stop := loop.next()).reason in {"step", "watchpoint"} and line(loop) < 18:
        reasons.append((stop.reason, line(loop)))
    turn = [("step", 15), ("step", 16), ("watchpoint", 14)]
    assert reasons == [("step", 14), *turn * 3]
    assert [loop.step(backward=True).reason for _ in range(8)] == ["step"] * 8


def test_conditions_ignored_hits_and_log_points(loop: Debugger) -> None:
    said: list[str] = []
    loop.stop_points.print_log = said.append
    loop.stop_points.add_watchpoint("total", condition="total > 2")
    quiet = loop.stop_points.add_watchpoint("goal.x", "write", ignore=1)
    logged = loop.stop_points.add_watchpoint("goal.order[2]", log="order {goal.order[2]}")
    assert texts(loop) == ["total: 2 -> 6, written at a.c:15", "total: 6 -> 12, written at a.c:15"]
    assert (quiet.hits, logged.hits, said) == (0, 1, ["order 2"])


def test_the_condition_of_a_local_watchpoint_is_evaluated_in_its_frame(loop: Debugger) -> None:
    loop.step()
    # `i` is a variable of main, and it is main that stops.
    loop.stop_points.add_watchpoint("total", condition="i == 2")
    assert texts(loop) == ["total: 2 -> 6, written at a.c:15"]


def test_disabled_watchpoints_do_not_stop(loop: Debugger) -> None:
    point = loop.stop_points.add_watchpoint("total")
    loop.stop_points.enable(point.number, on=False)
    assert texts(loop) == []
    loop.stop_points.enable(point.number)
    assert len(texts(loop, backward=True)) == 3
    loop.stop_points.remove(point.number)
    assert texts(loop) == []


def test_a_temporary_watchpoint_is_deleted_when_hit(loop: Debugger) -> None:
    loop.stop_points.add_watchpoint("total", temporary=True)
    assert len(texts(loop)) == 1
    assert not list(loop.stop_points.breakpoints)


def test_an_assignment_by_the_user_is_not_an_access(loop: Debugger) -> None:
    go(loop, "16")
    loop.stop_points.add_watchpoint("total")
    loop.evaluate("total = 50")
    assert texts(loop) == [
        "total: 50 -> 54, written at a.c:15",
        "total: 54 -> 60, written at a.c:15",
    ]
    assert len(texts(loop, backward=True)) == 3
    assert texts(loop)[0] == "total: 0 -> 2, written at a.c:15"


def test_invalid_watchpoints_are_refused(loop: Debugger) -> None:
    go(loop, "18")
    for wrong in ("nothing", "", "1", "twice", "main", "goal.order[4]", "total = 3", "i++"):
        with pytest.raises(DebugError):
            loop.stop_points.add_watchpoint(wrong)
    for wrong in ("total + 1", "*p", "-total"):
        with pytest.raises(DebugError):
            loop.stop_points.add_watchpoint(wrong, location=True)
    with pytest.raises(DebugError, match="is a value, not an object"):
        loop.stop_points.add_watchpoint("total + 1", "write")
    with pytest.raises(DebugError, match="access kind"):
        loop.stop_points.add_watchpoint("total", "look")  # type: ignore[arg-type]
    for _ in range(MAX):
        loop.stop_points.add_watchpoint("total")
    with pytest.raises(DebugError, match=f"at most {MAX} objects"):
        loop.stop_points.add_watchpoint("total")
    first = next(iter(loop.stop_points.breakpoints))
    loop.stop_points.enable(first.number, on=False)
    loop.stop_points.add_watchpoint("total")
    with pytest.raises(DebugError, match=f"at most {MAX} objects"):
        loop.stop_points.enable(first.number)


def test_a_heap_block_is_watched(loop: Debugger) -> None:
    go(loop, "20")
    loop.stop_points.add_watchpoint("*p", "write")
    assert re.fullmatch(r"\*p: .* -> 4, written at a.c:20", texts(loop)[0])


def test_before_the_first_statement_global_objects_can_be_watched() -> None:
    debugger = debugger_of(LOOP)
    debugger.stop_points.add_watchpoint("total")
    assert len(texts(debugger)) == 3


def test_a_restored_run_is_the_same_with_and_without_watching(loop: Debugger) -> None:
    go(loop, "18")
    here = loop.position
    loop.goto_timestep(0)
    loop.goto(here)
    state = loop.session.state_hash()
    loop.stop_points.add_watchpoint("total", "access")
    texts(loop, backward=True)
    loop.goto(here)
    assert loop.session.state_hash() == state


ROBOTS = """\
#include "Nclient.h"
#include <unistd.h>
int shared;
int main(void)
{
    int i;
    connect_robot(1);
    for (i = 0; i < 4; i++) {
        shared += i;
        vm(100, 0, 0);
        sleep(1);
        gs();
    }
    disconnect_robot(1);
    return 0;
}
"""


@pytest.fixture
def robots() -> Debugger:
    debugger = debugger_of(ROBOTS, world="pair.xml")
    debugger.start()
    return debugger


def test_each_robot_has_its_own_watchpoints(robots: Debugger) -> None:
    one = robots.stop_points.add_watchpoint("shared", robot=1)
    found = []
    while robots.resume().reason == "watchpoint":
        found.append((robots.stop.robot, robots.stop.breakpoints, robots.stop.text))
    text = "shared: {} -> {}, written at a.c:9"
    changes = [(0, 1), (1, 3), (3, 6)]
    assert found == [(1, (one.number,), text.format(*each)) for each in changes]
    other = robots.stop_points.add_watchpoint("shared", robot=0)
    back = []
    while robots.resume(backward=True).reason == "watchpoint":
        back.append((robots.stop.breakpoints, robots.stop.text))
    numbers = [(other.number,), (one.number,)]
    assert sorted(back) == sorted(
        (each, text.format(*pair)) for each in numbers for pair in changes
    )


def test_accesses_of_other_robots_in_a_round_are_reported(robots: Debugger) -> None:
    """All of them wait for replies at once, so that each is in the middle of a statement."""
    for robot in range(2):
        robots.stop_points.add_watchpoint("shared", robot=robot)
        robots.stop_points.add_watchpoint("State[STATE_CONF_X]", robot=robot)
    found: dict[bool, list[str]] = {}
    for backward in (False, True):
        rows = found[backward] = []
        while (stop := robots.resume(backward=backward)).reason == "watchpoint":
            rows += stop.text.split("; ")
    assert len(found[False]) == 16
    assert sorted(found[True]) == sorted(found[False])


def test_replies_of_the_world_count_as_writes(robots: Debugger) -> None:
    robots.stop_points.add_watchpoint("State[STATE_CONF_X]")
    robots.resume()
    assert re.fullmatch(
        r"State\[STATE_CONF_X\]: 0 -> \d+, written by \w+ at a.c:\d+", robots.stop.text
    )
    forward = [robots.stop.text]
    while robots.resume().reason == "watchpoint":
        forward.append(robots.stop.text)
    assert len(forward) > 2
    back = []
    while robots.resume(backward=True).reason == "watchpoint":
        back.append(robots.stop.text)
    assert back == forward[::-1]
