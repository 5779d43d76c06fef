"""Stepping behaves as users of gdb expect where control flow is not a plain call and return.

Each program is small enough to be followed by hand; the numbers are those of its lines.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path

import pytest

from crs_cc.debug.engine import Debugger
from crs_cc.debug.errors import DebugError
from crs_cc.debug.stop import Stop
from tests.debug.debuggers import advance, debugger_of, line

Move = Callable[[], Stop]


def walk(debugger: Debugger, moves: Iterable[Move]) -> list[int]:
    """Return the lines that moves lead to."""
    return [line(debugger) for move in moves if move()]


def functions(debugger: Debugger) -> list[str]:
    """Return the user's active functions, the innermost first."""
    return [each.function for each in debugger.view.frames() if not each.is_library]


def number(debugger: Debugger, text: str) -> object:
    """Return the value of an expression."""
    return debugger.view.evaluate_pure(text).number


RECURSION = """\
int fib(int n)
{
    if (n < 2)
        return n;
    return fib(n - 1) + fib(n - 2);
}
int main(void)
{
    int i = fib(4);
    i += fib(2);
    return i;
}
"""


@pytest.fixture
def recursion() -> Debugger:
    """Stands in `fib(3)` within `fib(4)`, in line 5."""
    debugger = debugger_of(RECURSION)
    debugger.start()
    debugger.step(4)
    assert (line(debugger), number(debugger, "n")) == (5, 3)
    return debugger


def test_next_stays_in_its_call_of_a_recursive_function(
    recursion: Debugger,
) -> None:
    assert recursion.next().reason == "step"
    assert line(recursion) == 10  # fib(4) ends in the middle of its line, too
    assert number(recursion, "i") == 3


def test_next_at_the_end_of_a_call_steps_over_a_sibling_call_in_the_line(
    recursion: Debugger,
) -> None:
    recursion.stop_points.add_breakpoint("4", condition="n == 1", temporary=True)
    recursion.resume()
    assert functions(recursion) == ["fib"] * 4 + ["main"]
    recursion.next()  # fib(0) has its frame where that of fib(1) was
    assert (line(recursion), functions(recursion)) == (10, ["main"])


def test_reverse_next_at_the_start_of_a_call_steps_over_its_sibling(recursion: Debugger) -> None:
    recursion.stop_points.add_breakpoint("4", condition="n == 0", temporary=True)
    recursion.resume()
    assert walk(recursion, [lambda: recursion.next(backward=True)] * 2) == [3, 5]
    assert number(recursion, "n") == 2
    assert functions(recursion) == ["fib"] * 3 + ["main"]


def test_finish_leaves_one_call_of_a_recursive_function(recursion: Debugger) -> None:
    assert recursion.finish().text == "fib returned 2"
    assert (line(recursion), number(recursion, "n")) == (5, 4)
    recursion.step()  # fib(2) of the same line
    assert (line(recursion), number(recursion, "n")) == (3, 2)
    assert recursion.finish().text == "fib returned 1"
    assert recursion.finish().text == "fib returned 3"
    assert (line(recursion), functions(recursion)) == (9, ["main"])


def test_reverse_finish_goes_to_each_caller_in_turn(recursion: Debugger) -> None:
    assert walk(recursion, [lambda: recursion.finish(backward=True)] * 2) == [5, 9]
    assert functions(recursion) == ["main"]


SUM = """\
static int f(int x)
{
    return x + 1;
}
static int g(int x)
{
    return x * 3;
}
int main(void)
{
    int a = 5;
    a = f(1) + g(2);
    return a;
}
"""


def test_a_step_behind_a_call_enters_the_next_call_of_the_line() -> None:
    debugger = debugger_of(SUM)
    debugger.start()
    assert walk(debugger, [debugger.step, debugger.step]) == [12, 3]
    assert debugger.finish().text == "f returned 2"
    behind_f = debugger.position
    assert (line(debugger), number(debugger, "a")) == (12, 5)  # not yet assigned
    assert walk(debugger, [debugger.step]) == [7]
    assert debugger.finish().text == "g returned 6"
    assert (line(debugger), number(debugger, "a")) == (12, 5)
    behind_g = debugger.position
    assert walk(debugger, [debugger.next]) == [13]
    assert number(debugger, "a") == 8
    # backward: behind f is where g is called
    assert debugger.goto(behind_g).position == behind_g
    assert walk(debugger, [lambda: debugger.step(backward=True)]) == [7]
    assert debugger.finish(backward=True).position == behind_f
    assert walk(debugger, [lambda: debugger.step(backward=True)]) == [3]
    debugger.goto(behind_f)
    assert walk(debugger, [lambda: debugger.next(backward=True)] * 2) == [12, 11]
    debugger.goto(behind_f)
    assert walk(debugger, [debugger.next]) == [13]


def test_advance_out_of_a_function_stops_right_behind_its_call() -> None:
    debugger = debugger_of(SUM)
    debugger.stop_points.add_breakpoint("3")
    debugger.resume()
    advance(debugger, "2")  # not reached again
    assert (line(debugger), functions(debugger), number(debugger, "a")) == (12, ["main"], 5)


SKIPPED = """\
static int leaf(int x)
{
    return x + 1;
}
static int tree(int x)
{
    return leaf(x) + leaf(x);
}
int main(void)
{
    int a = tree(1);
    a += leaf(tree(2));
    return a;
}
"""


def test_step_does_not_enter_skipped_functions_and_their_callees() -> None:
    debugger = debugger_of(SKIPPED)
    debugger.start()
    skip = debugger.navigator.skips.add("tree")
    assert walk(debugger, [debugger.step] * 3) == [12, 3, 13]
    assert functions(debugger) == ["main"]
    back = [lambda: debugger.step(backward=True)] * 3
    assert walk(debugger, back) == [3, 12, 11]
    skip.enabled = False
    assert walk(debugger, [debugger.step] * 2) == [7, 3]
    skip.enabled = True  # inside of it, stepping goes on as ever
    assert walk(debugger, [debugger.step] * 2) == [3, 12]


def test_advance_stops_where_break_stops_under_the_same_condition() -> None:
    debugger = debugger_of(RECURSION)
    debugger.start()
    advance(debugger, "a.c:4", condition="n == 0")
    assert (line(debugger), number(debugger, "n")) == (4, 0)
    assert list(debugger.stop_points.breakpoints) == []
    with pytest.raises(DebugError):
        advance(debugger, "4", condition="nothing > 0")


TYPES = """\
struct pair { short a, b; };
enum colour { RED, GREEN };
static char narrow(int x) { return x; }
static unsigned char byte(int x) { return x; }
static _Bool truth(int x) { return x; }
static float third(int x) { return x / 3.0; }
static long long wide(int x) { return 10000000000LL * x; }
static enum colour hue(int x) { return x; }
static const char *name(int x) { return "north" + x; }
static struct pair both(int x) { struct pair p = { x, -x }; return p; }
static void nothing(int x) { (void) x; }
int main(void)
{
    narrow(577); byte(-1); truth(7); third(1); wide(2); hue(1); name(1); both(3); nothing(1);
    return 0;
}
"""


def test_finish_shows_a_value_converted_to_the_type_of_the_function() -> None:
    debugger = debugger_of(TYPES)
    values = [
        "65 'A'", "255", "true", "0.33333334", "20000000000", "GREEN", None, "{a = 3, b = -3}",
    ]  # fmt: skip
    names = ["narrow", "byte", "truth", "third", "wide", "hue", "name", "both"]
    for function, value in zip(names, values, strict=True):
        debugger.stop_points.add_breakpoint(function, temporary=True)
        debugger.resume()
        text = debugger.finish().text
        assert value is None or text == f"{function} returned {value}"
        assert value is not None or text.endswith('"orth"')
    debugger.stop_points.add_breakpoint("nothing", temporary=True)
    debugger.resume()
    assert (debugger.finish().text, functions(debugger)) == ("", ["main"])


LONGJMP = """\
#include <setjmp.h>
static jmp_buf back;
static void deep(int n)
{
    if (n == 0)
        longjmp(back, 7);
    deep(n - 1);
    n = 0;
}
int main(void)
{
    int got = setjmp(back);
    if (got == 0) {
        deep(3);
        got = -1;
    }
    return got;
}
"""


def test_next_over_a_longjmp_stops_at_its_target() -> None:
    debugger = debugger_of(LONGJMP)
    debugger.start()
    assert walk(debugger, [debugger.next] * 4) == [13, 14, 13, 17]
    assert number(debugger, "got") == 7
    assert walk(debugger, [lambda: debugger.next(backward=True)] * 4) == [13, 14, 13, 12]


def test_next_and_finish_leave_a_function_that_longjmps() -> None:
    for move in (Debugger.next, Debugger.finish):
        debugger = debugger_of(LONGJMP)
        debugger.stop_points.add_breakpoint("6")
        debugger.resume()
        assert functions(debugger) == ["deep"] * 4 + ["main"]
        stop = move(debugger)
        assert (stop.reason, stop.text) == ("step", "")
        assert (line(debugger), functions(debugger)) == (13, ["main"])
        debugger.step(backward=True)
        assert (line(debugger), functions(debugger)) == (6, ["deep"] * 4 + ["main"])


CALLBACK = """\
#include <stdlib.h>
static int order(const void *a, const void *b)
{
    int x = *(const int *) a;
    return x - *(const int *) b;
}
int main(void)
{
    int v[3] = { 3, 1, 2 };
    int (*by)(const void *, const void *) = order;
    qsort(v, 3, sizeof v[0], by);
    return by(&v[2], v);
}
"""


def test_step_enters_a_library_callback_and_next_does_not() -> None:
    debugger = debugger_of(CALLBACK)
    debugger.start()
    assert walk(debugger, [debugger.next] * 3) == [10, 11, 12]
    debugger.next(backward=True)
    assert walk(debugger, [debugger.step] * 2) == [4, 5]
    assert functions(debugger) == ["order", "main"]
    debugger.finish()  # the library has called it several times
    assert (line(debugger), functions(debugger)) == (11, ["main"])
    assert walk(debugger, [debugger.step] * 2) == [12, 4]  # through the pointer
    assert walk(debugger, [lambda: debugger.finish(backward=True)]) == [12]
    assert walk(debugger, [lambda: debugger.step(backward=True)]) == [5]
    assert functions(debugger) == ["order", "main"]


SIGNAL = """\
#include <signal.h>
#include <unistd.h>
static int rings;
static void ring(int number)
{
    rings += number == SIGALRM;
    alarm(1);
}
int main(void)
{
    int naps = 0;
    signal(SIGALRM, ring);
    alarm(1);
    while (rings < 2) {
        naps++;
        pause();
    }
    return naps;
}
"""


def test_step_enters_a_signal_handler_and_next_does_not() -> None:
    debugger = debugger_of(SIGNAL)
    debugger.start()
    assert walk(debugger, [debugger.next] * 6) == [12, 13, 14, 15, 16, 14]
    assert number(debugger, "rings") == 1
    assert walk(debugger, [lambda: debugger.next(backward=True)]) == [16]
    assert number(debugger, "rings") == 0
    assert walk(debugger, [debugger.step] * 3) == [6, 7, 14]
    back = [lambda: debugger.step(backward=True)]
    assert walk(debugger, back * 3) == [7, 6, 16]


def test_finish_returns_from_a_signal_handler() -> None:
    debugger = debugger_of(SIGNAL)
    debugger.stop_points.add_breakpoint("ring")
    assert debugger.resume().time_s == pytest.approx(1.0, abs=0.01)
    assert functions(debugger) == ["ring", "main"]
    debugger.finish()
    assert (line(debugger), functions(debugger)) == (16, ["main"])
    debugger.step()
    assert line(debugger) == 14
    assert debugger.resume().time_s == pytest.approx(2.0, abs=0.01)
    assert debugger.resume(backward=True).time_s == pytest.approx(1.0, abs=0.01)
    debugger.finish(backward=True)
    assert line(debugger) == 16


LEAVES = """\
#include <stdlib.h>
static int left;
static void bye(void)
{
    left = 1;
}
static void leave(int status)
{
    exit(status);
}
int main(void)
{
    atexit(bye);
    leave(3);
    return 0;
}
"""


def test_exit_runs_atexit_functions_before_the_end() -> None:
    debugger = debugger_of(LEAVES)
    debugger.start()
    assert walk(debugger, [debugger.step] * 3) == [14, 9, 5]
    assert debugger.step().reason == "end"
    assert debugger.view.frames() == []
    assert walk(debugger, [lambda: debugger.step(backward=True)] * 3) == [5, 9, 14]
    assert debugger.next().reason == "end"
    assert debugger.next(backward=True).reason == "step"
    assert debugger.session.result().robots[0].outcome == "running"


FAILS = """\
static int at(const int *v, int i)
{
    return v[i];
}
int main(void)
{
    int v[2] = { 1, 2 }, i, sum = 0;
    for (i = 0; i <= 2; i++)
        sum += at(v, i);
    return sum;
}
"""


def test_reverse_steps_from_an_error_and_forward_to_it_again() -> None:
    debugger = debugger_of(FAILS)
    error = debugger.resume()
    assert (error.reason, line(debugger)) == ("error", 3)
    assert "out of bounds" in error.text
    assert [number(debugger, each) for each in ("i", "v[1]")] == [2, 2]
    back = [lambda: debugger.next(backward=True)]
    assert walk(debugger, back * 4) == [3, 9, 8, 9]
    assert number(debugger, "sum") == 1
    assert debugger.resume() == error
    assert debugger.finish(backward=True).reason == "step"
    assert line(debugger) == 9
    assert debugger.next() == error


READS = """\
#include <stdio.h>
int main(void)
{
    char line[80];
    int n = 0;
    while (fgets(line, sizeof line, stdin))
        n += line[0] == 'a';
    return n;
}
"""


def test_input_is_replayed_and_requested_once() -> None:
    asked: list[int] = []
    lines = [b"ab\n", b"cd\n", b"ae\n", b""]

    def read(robot: int, wanted: int) -> bytes:
        asked.append(wanted)
        return lines[len(asked) - 1]

    debugger = debugger_of(READS, read=read)
    debugger.stop_points.add_breakpoint("8")
    debugger.resume()
    assert (number(debugger, "n"), len(asked)) == (2, 4)
    debugger.goto_statement(2)
    assert walk(debugger, [debugger.next] * 3) == [7, 6, 7]
    assert debugger.view.evaluate_pure("line").text == '"cd\\n"'
    assert len(asked) == 4
    debugger.resume()
    assert (number(debugger, "n"), len(asked)) == (2, 4)


TWO = """\
<?xml version="1.0" encoding="UTF-8"?>
<world version="1" name="two" timestep="0.05s">
  <area length="200in" width="100in"/>
  <robot id="caller" x="30in" y="50in" heading="0deg"/>
  <robot id="hearer" x="100in" y="50in" heading="0deg" {more}/>
</world>
"""

CALLER = """\
#include "Nclient.h"
#include "crs.h"
int main(void)
{
    int i;
    connect_robot(1);
    for (i = 0; i < 3; i++) {
        crs_send(1, 5, &i, sizeof i);
        ws(0, 0, 0, 1);
    }
    return i;
}
"""

HEARER = """\
#include "Nclient.h"
#include "crs.h"
#include <string.h>
int main(void)
{
    struct crs_message heard;
    int got = -1, sum = 0;
    connect_robot(1);
    while (got < 2) {
        crs_receive(&heard, CRS_FOREVER);
        memcpy(&got, heard.data, sizeof got);
        sum += got;
    }
    return sum;
}
"""


def two_robots(folder: Path, more: str = "") -> Debugger:
    """Return a robot that calls another one."""
    (folder / "two.xml").write_text(TWO.format(more=more))
    return debugger_of(CALLER, HEARER, world=str(folder / "two.xml"))


def test_each_robot_is_stepped_while_others_run(tmp_path: Path) -> None:
    debugger = two_robots(tmp_path)
    debugger.start()
    assert walk(debugger, [debugger.next] * 3) == [7, 8, 9]
    debugger.view.select_robot("hearer")
    sums = []
    debugger.stop_points.add_breakpoint("12", robot=1)
    places = []
    while debugger.resume().reason == "breakpoint":
        assert debugger.view.robot == 1
        debugger.next()
        assert line(debugger) == 9
        sums.append(number(debugger, "sum"))
        places.append(debugger.position)
    assert sums == [0, 1, 3]
    debugger.goto(places[1])
    assert walk(debugger, [lambda: debugger.next(backward=True)] * 3) == [12, 11, 10]
    assert number(debugger, "got") == 0
    assert debugger.resume().breakpoints
    assert debugger.next().position == places[1]


def test_a_breakpoint_without_a_robot_stops_any_robot(tmp_path: Path) -> None:
    debugger = two_robots(tmp_path)
    debugger.stop_points.add_breakpoint("a.c:main")
    debugger.stop_points.add_breakpoint("b.c:main")
    assert [(debugger.resume().robot, line(debugger)) for _ in range(2)] == [(0, 6), (1, 7)]
    debugger.stop_points.add_breakpoint("connect_robot", robot=1)
    assert (debugger.resume().robot, functions(debugger)) == (1, ["main"])
    assert debugger.resume(backward=True).robot == 1
    assert debugger.resume(backward=True).robot == 0


def test_an_ended_program_can_only_be_stepped_backward(tmp_path: Path) -> None:
    debugger = two_robots(tmp_path)
    debugger.stop_points.add_breakpoint("12", robot=1, condition="got == 2")
    debugger.resume()
    debugger.view.select_robot("caller")
    assert debugger.view.frames() == []
    here = debugger.position
    for move in (debugger.step, debugger.next, debugger.step_statement, debugger.finish):
        with pytest.raises(DebugError):
            move()
        assert debugger.position == here
    assert walk(debugger, [lambda: debugger.step(backward=True)]) == [11]
    assert debugger.next().reason == "exit"


def test_a_robot_that_joins_later_is_stepped_from_then_on(tmp_path: Path) -> None:
    debugger = two_robots(tmp_path, 'join="0.12s"')
    debugger.view.select_robot("hearer")
    assert debugger.view.frames() == []
    stop = debugger.step()
    assert (stop.time_s, line(debugger)) == (pytest.approx(0.15, abs=1e-3), 7)
    assert walk(debugger, [debugger.next] * 2) == [8, 9]
    assert walk(debugger, [lambda: debugger.step(backward=True)] * 2) == [8, 7]
    debugger.goto_timestep(0)
    debugger.view.select_robot("hearer")
    assert debugger.goto_statement(3).robot == 1
    assert line(debugger) == 8  # line 7 has two
