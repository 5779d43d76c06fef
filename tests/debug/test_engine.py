"""Stepping, breaking and going backward, on programs small enough to be followed by hand."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from crs_cc.debug.engine import Debugger
from crs_cc.debug.errors import DebugError
from crs_cc.debug.stop import Stop
from crs_cc.sim.engine.step import Step
from tests.debug.debuggers import debugger_of, line

LOOP = """\
#include <stdio.h>
int total;
static int twice(int what)
{
    int result = what;
    result += what;
    return result;
}
int main(void)
{
    int i;
    for (i = 0; i < 3; i++) {
        total += twice(i);
        printf("%d\\n", total);
    }
    return total;
}
"""


@pytest.fixture
def loop() -> Debugger:
    debugger = debugger_of(LOOP)
    debugger.start()
    return debugger


def lines(debugger: Debugger, move: object, most: int = 100) -> list[int]:
    """Return the lines that it comes to, until there is no further one."""
    found = []
    while len(found) < most and move().reason == "step":  # type: ignore[operator]
        found.append(line(debugger))
    return found


ROUND = [13, 5, 6, 7, 14]


def test_step_enters_calls_and_next_steps_over_them(loop: Debugger) -> None:
    assert line(loop) == 12
    assert lines(loop, loop.step) == [*ROUND, 12, *ROUND, 12, *ROUND, 12, 16]
    assert loop.stop.reason == "end"


def test_next_steps_over_calls(loop: Debugger) -> None:
    assert lines(loop, loop.next) == [13, 14, 12, 13, 14, 12, 13, 14, 12, 16]


@pytest.mark.parametrize("verb", ["step", "next", "step_statement"])
def test_backward_steps_visit_the_same_lines(loop: Debugger, verb: str) -> None:
    move = getattr(loop, verb)
    places = [loop.position]
    while move().reason == "step":
        places.append(loop.position)
    back = []
    while move(backward=True).reason == "step":
        back.append(loop.position)
    assert back == places[::-1]


def test_finish_goes_to_the_caller_and_back(loop: Debugger) -> None:
    loop.stop_points.add_breakpoint("twice")
    loop.resume()
    before = loop.position
    assert [each.function for each in loop.view.frames()] == ["twice", "main"]
    loop.resume()
    assert loop.finish().text == "twice returned 2"
    assert line(loop) == 13
    loop.goto(before)
    loop.finish(backward=True)
    assert line(loop) == 13


def test_breakpoints_stop_forward_and_backward(loop: Debugger) -> None:
    point = loop.stop_points.add_breakpoint("6")
    places = []
    while loop.resume().reason == "breakpoint":
        assert loop.stop.breakpoints == (point.number,)
        places.append(loop.position)
    assert len(places) == point.hits == 3
    back = []
    while loop.resume(backward=True).reason == "breakpoint":
        back.append(loop.position)
    assert back == places[::-1]
    assert point.hits == 3


def test_a_line_without_code_means_the_next_line_with_code(loop: Debugger) -> None:
    point = loop.stop_points.add_breakpoint("8")
    assert point.location
    assert point.location.note == "no code at line 8; moved to line 12"


def test_invalid_breakpoints_are_refused(loop: Debugger) -> None:
    for place in ("99", "nowhere", "other.c:3", "", "3x", ":", "-1"):
        with pytest.raises(DebugError):
            loop.stop_points.add_breakpoint(place)


PRINTS = """\
#include <stdio.h>
#include "Nclient.h"
int main(void)
{
    printf("here\\n");
    connect_robot(1);
    while (1)
        gs();
}
"""


@pytest.mark.parametrize("how", ["timestep", "time", "statement"])
def test_goto_shows_new_output_once(how: str) -> None:
    shown: list[bytes] = []

    def show(_robot: int, _stream: int, content: bytes) -> None:
        shown.append(content)

    debugger = debugger_of(PRINTS, output=show)
    debugger.start()
    goes = {
        "timestep": lambda: debugger.goto_timestep(1),
        "time": lambda: debugger.goto_time(0.1),
        "statement": lambda: debugger.goto_statement(3),
    }
    goes[how]()
    written = debugger.run.console.text()
    assert written.startswith(b"here\n")
    assert b"".join(shown) == written
    debugger.goto_statement(1)
    goes[how]()
    assert b"".join(shown) == written


def test_compare_shows_no_output_of_the_other_branch() -> None:
    shown: list[bytes] = []
    debugger = debugger_of(PRINTS, output=lambda _robot, _stream, content: shown.append(content))
    debugger.start()
    debugger.branch("other")
    debugger.goto_timestep(1)
    before = list(shown)
    assert before
    debugger.compare("main")
    assert shown == before


def test_output_goes_back_with_the_run(loop: Debugger) -> None:
    loop.stop_points.add_breakpoint("16")
    loop.resume()
    assert loop.run.console.text() == b"0\n2\n6\n"
    loop.goto_statement(4)
    assert loop.run.console.text() == b""


def test_goto_a_statement_and_a_timestep(loop: Debugger) -> None:
    loop.goto_statement(5)
    assert loop.position.statements == 4
    with pytest.raises(DebugError):
        loop.goto_statement(1000)
    assert loop.position.statements == 4
    loop.goto_timestep(0)
    assert loop.stop.reason == "beginning"


def test_until_leaves_loops(loop: Debugger) -> None:
    loop.next(2)
    assert line(loop) == 14
    loop.until()
    assert line(loop) == 16


def test_advance_stops_at_its_location_or_in_the_caller(loop: Debugger) -> None:
    loop.advance(loop.stop_points.add_breakpoint("6", temporary=True, robot=loop.view.robot))
    assert line(loop) == 6
    assert not list(loop.stop_points.breakpoints)
    loop.advance(loop.stop_points.add_breakpoint("16", temporary=True, robot=loop.view.robot))
    assert line(loop) == 13


def test_conditions_apply_forward_and_backward(loop: Debugger) -> None:
    loop.stop_points.add_breakpoint("6", condition="what == 1 && total < 10")
    assert loop.resume().reason == "breakpoint"
    assert loop.view.evaluate_pure("what").number == 1
    here = loop.position
    assert loop.resume().reason == "end"
    assert loop.resume(backward=True).position == here
    assert loop.resume(backward=True).reason == "beginning"


def test_a_condition_must_be_valid_at_its_location(loop: Debugger) -> None:
    with pytest.raises(DebugError):
        loop.stop_points.add_breakpoint("6", condition="i == 1")
    point = loop.stop_points.add_breakpoint("13", condition="i == 1")
    with pytest.raises(DebugError):
        loop.stop_points.set_condition(point.number, "what")
    assert loop.resume().reason == "breakpoint"
    assert loop.view.evaluate_pure("i").number == 1


def test_ignored_hits_and_log_points(loop: Debugger) -> None:
    said: list[str] = []
    loop.stop_points.print_log = said.append
    loop.stop_points.add_breakpoint("14", ignore=1)
    loop.stop_points.add_breakpoint("7", log="{what} twice is {result}, {total}")
    with pytest.raises(DebugError, match="nothing"):
        loop.stop_points.add_breakpoint("7", log="{nothing}")
    loop.resume()
    assert loop.view.evaluate_pure("i").number == 1
    assert [text.partition(", ")[0] for text in said] == ["0 twice is 0", "1 twice is 2"]


def test_inspection_has_no_side_effects(loop: Debugger) -> None:
    with pytest.raises(DebugError):
        loop.view.evaluate_pure("total = 3")
    assert loop.view.evaluate_pure("total").number == 0
    loop.evaluate("total = 3")
    assert loop.view.evaluate_pure("total").number == 3


def test_a_refused_expression_sets_no_convenience_variable(loop: Debugger) -> None:
    loop.view.evaluate_pure("$old = 7")
    for name in ("new", "old"):
        with pytest.raises(DebugError):
            loop.view.evaluate_pure(f"${name} = total = 5")
    assert loop.view.evaluate_pure("$old").number == 7
    assert loop.view.evaluate_pure("$new").text == "void"


def test_a_function_of_the_library_stops_before_the_statements_that_call_it(
    loop: Debugger,
) -> None:
    point = loop.stop_points.add_breakpoint("printf")
    assert loop.resume().breakpoints == (point.number,)
    assert line(loop) == 14
    assert [loop.resume().reason for _ in range(3)] == ["breakpoint", "breakpoint", "end"]
    with pytest.raises(DebugError):
        loop.stop_points.add_breakpoint("scanf")


ENDLESS = """\
#include "Nclient.h"
int main(void)
{
    connect_robot(1);
    for (;;)
        get_rc();
}
"""


def test_a_late_interrupt_can_be_discarded() -> None:
    debugger = debugger_of(PRINTS)
    debugger.start()
    debugger.interrupt()
    debugger.forget_interrupt()
    assert debugger.step().reason == "step"


@pytest.mark.parametrize(
    "move",
    [
        lambda debugger: debugger.resume(),
        lambda debugger: debugger.next(1000),
        lambda debugger: debugger.goto_timestep(1000),
        lambda debugger: debugger.goto_statement(100_000),
    ],
)
def test_all_forward_moves_can_be_interrupted(move: Callable[[Debugger], Stop]) -> None:
    debugger = debugger_of(ENDLESS)
    debugger.start()
    hear = debugger.run._latest.step

    def step(step: Step) -> None:
        hear(step)
        if debugger.session.timesteps == 3:
            debugger.interrupt()

    debugger.run._latest.step = step  # type: ignore[method-assign]
    assert move(debugger).reason == "interrupt"
    assert debugger.position.timestep == 3
    debugger.interrupt()
    assert debugger.goto_timestep(2).reason == "goto"  # that is but a short way
    assert debugger.step().reason == "step"


@pytest.mark.parametrize("verb", ["step", "next", "step_statement"])
@pytest.mark.parametrize("backward", [False, True])
def test_an_interrupt_between_repeated_steps_is_noticed(
    verb: str, backward: bool, loop: Debugger, monkeypatch: pytest.MonkeyPatch
) -> None:
    loop.goto_statement(10)
    navigator = loop.navigator
    way = "backward_to" if backward else "forward"
    go, moves = getattr(navigator, way), 0

    def move(*arguments: object) -> Stop:
        nonlocal moves
        stop: Stop = go(*arguments)
        moves += 1
        if moves == 2:
            loop.interrupt()  # when the move is done, but before its end is noticed
        return stop

    monkeypatch.setattr(navigator, way, move)
    stop = getattr(loop, verb)(5, backward=backward)
    assert (stop.reason, moves) == ("interrupt", 2)
    assert not loop.run.interrupted
    assert getattr(loop, verb)(backward=backward).reason == "step"


def test_backward_from_inside_a_round_with_a_world_event(loop: Debugger) -> None:
    loop.stop_points.add_catchpoint("collision")
    loop.next(3)
    assert loop.resume(backward=True).reason == "beginning"


def test_default_robot_for_conditions_of_robot_independent_events() -> None:
    source = "#include <unistd.h>\nint mine = {};\nint main(void) {{ sleep(1); return mine; }}\n"
    sources = [source.format(number) for number in (1, 2, 3)]
    debugger = debugger_of(*sources, world="platoon.xml")
    said: list[str] = []
    debugger.stop_points.print_log = said.append
    debugger.start()
    point = debugger.stop_points.add_catchpoint("tick", condition="mine == 1")
    debugger.stop_points.add_catchpoint("tick", log="{mine}", robot=None)
    assert debugger.tick(1).breakpoints == (point.number,)
    assert said == ["1"]


WAITING = """\
#include <unistd.h>
static int work(int n)
{
    sleep(1);
    return n;
}
static void busy(void)
{
    int i;
    for (i = 0; i < 100; i++)
        ;
}
int main(void)
{
    busy();
    return work(3);
}
"""


def test_the_clock_after_going_back_is_that_of_the_position() -> None:
    debugger = debugger_of(WAITING)
    debugger.start()
    debugger.goto_timestep(5)
    stop = debugger.finish(backward=True)
    assert line(debugger) == 16
    assert stop.time_s < 0.01
    state, here = debugger.session.state_hash(), debugger.position
    debugger.goto_timestep(3)
    debugger.goto(here)
    assert debugger.session.state_hash() == state


OFTEN = """\
int main(void)
{
    int i, sum = 0;
    for (i = 0; i < 20000; i++)
        sum += i & 1;
    return sum;
}
"""


def test_backward_to_a_breakpoint_with_very_many_hits() -> None:
    debugger = debugger_of(OFTEN)
    debugger.stop_points.add_breakpoint("6", temporary=True)
    debugger.resume()
    debugger.stop_points.add_breakpoint("5")
    debugger.resume(backward=True)
    assert (line(debugger), debugger.view.evaluate_pure("i").number) == (5, 19999)
