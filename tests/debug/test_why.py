"""Where values came from, compared with what single-stepping shows."""

from __future__ import annotations

import time
from collections.abc import Iterator

import pytest

from crs_cc.debug.cause import Cause
from crs_cc.debug.engine import Debugger
from crs_cc.debug.why import Why
from tests.debug.debuggers import debugger_of

COMPUTES = """\
int seed = 7, a, b, c, total, tab[4];
struct pair { int first, second; } pair;
static int next(void)
{
    seed = seed * 1103515245 + 12345;
    return (seed >> 16) & 3;
}
static int twice(int x)
{
    int y = x;
    y += x;
    return y;
}
static void swap(int *one, int *other)
{
    int kept = *one;
    *one = *other;
    *other = kept;
}
int main(void)
{
    int i;
    for (i = 0; i < 14; i++) {
        switch (next()) {
        case 0: a = b + i; break;
        case 1: tab[i & 3] = twice(a) - c; break;
        case 2: swap(&b, &tab[i & 3]); break;
        default: pair.second = c; c = pair.first + i; pair.first = a;
        }
        total += a;
    }
    return total;
}
"""
OBJECTS = ("seed", "a", "b", "c", "total", "pair.first", "pair.second",
           "tab[0]", "tab[1]", "tab[2]", "tab[3]")  # fmt: skip


def explained(debugger: Debugger, text: str) -> Cause:
    here = debugger.position
    cause = Why(debugger.view, debugger.navigator).explain(text)
    assert debugger.position == here
    return cause


def nodes(cause: Cause) -> Iterator[Cause]:
    yield cause
    for each in cause.causes:
        yield from nodes(each)


def shape(cause: Cause) -> list[str]:
    return [each.text for each in nodes(cause)]


def test_every_node_is_a_write_that_single_stepping_shows() -> None:
    debugger = debugger_of(COMPUTES)
    debugger.start()
    values: dict[str, list[str]] = {name: [] for name in OBJECTS}
    number: dict[object, int] = {}
    while not debugger.view.is_over:
        number[debugger.position] = len(number)
        for name, found in values.items():
            found.append(debugger.view.evaluate_pure(name).text)
        debugger.step_statement()
    debugger.stop_points.add_breakpoint("31")
    debugger.goto_time(0.0)
    debugger.resume()

    def check(cause: Cause, until: int) -> int:
        name, _, value = cause.text.partition(" = ")
        at = until if cause.position is None else number[cause.position]
        assert at <= until
        checked = 0
        if name in values and cause.how != "...":
            start = 0 if cause.position is None else at + 1
            start = until if cause.times > 1 else start
            assert set(values[name][start : until + 1]) == {value}, cause
            checked = 1
        return checked + sum(check(each, at) for each in cause.causes)

    here = number[debugger.position]
    assert sum(check(explained(debugger, name), here) for name in OBJECTS) > 30


CHAIN = """\
int speed, gap = 5, limit;
static int clip(int value, int most)
{
    return value > most ? most : value; /* ; */
}
int main(void)
{
    int wanted;
    limit = 3 * gap;
    gap = 0;
    wanted = limit + 5;
    speed = clip(wanted, 100);
    return speed;
}
"""


def test_a_value_is_followed_through_calls_arguments_and_copies() -> None:
    debugger = debugger_of(CHAIN)
    debugger.stop_points.add_breakpoint("13")
    debugger.resume()
    cause = explained(debugger, "speed")
    assert shape(cause) == [
        "speed = 20", "clip returned", "value = 20", "wanted = 20", "limit = 15", "gap = 5",
        "most = 100",
    ]  # fmt: skip
    assert cause.how == "speed = clip(wanted, 100)"
    assert [each.how for each in nodes(cause)][-2:] == [
        "its initial value",
        "speed = clip(wanted, 100)",
    ]


def test_a_change_by_the_user_is_a_cause() -> None:
    debugger = debugger_of(CHAIN)
    debugger.stop_points.add_breakpoint("11")
    debugger.resume()
    debugger.evaluate("limit = 70")
    debugger.stop_points.add_breakpoint("13")
    debugger.resume()
    assert [each.how for each in nodes(explained(debugger, "speed")) if "70" in each.text] == [
        "you changed it: limit = 70"
    ]


SAMPLES = """\
#include <unistd.h>
#include "Nclient.h"
int front;
int main(void)
{
    connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400);
    for (;;) {
        vm(100, 100, 0);
        front = State[17];
        usleep(300000);
    }
}
"""
SENDS = """\
#include <crs.h>
#include "Nclient.h"
int near_in, told;
int main(void)
{
    int i;
    connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400);
    for (i = 0; i < 12; i++) {
        gs();
        near_in = State[17];
        if (crs_my_number() == 0) {
            int report = near_in + 1000;
            crs_send(1, 7, &report, sizeof report);
        } else {
            struct crs_message message;
            if (crs_receive(&message, 2000))
                told = *(int *)message.data;
        }
        usleep(500000);
    }
    return 0;
}
"""


def test_a_value_from_another_robot_leads_to_the_object_that_its_beam_met() -> None:
    debugger = debugger_of("#include <unistd.h>\n" + SENDS, world="pair.xml")
    debugger.goto_time(5.0)
    debugger.view.select_robot(1)
    started_s = time.perf_counter()
    cause = explained(debugger, "told")
    assert time.perf_counter() - started_s < 20.0
    texts = shape(cause)
    assert any(each.endswith("sent it") for each in texts)
    assert any(each.startswith("report = ") for each in texts)
    assert any("STATE_SONAR_0: sonar 0 fired at" in each for each in texts)
    assert {each.robot for each in nodes(cause)} == {0, 1}
    for each in nodes(cause):
        if each.position is not None:
            debugger.goto(each.position)
            assert debugger.position == each.position


@pytest.mark.parametrize("text", ["speed + limit", "2 * (gap + wanted)"])
def test_of_a_computed_value_the_operands_are_explained(text: str) -> None:
    debugger = debugger_of(CHAIN)
    debugger.stop_points.add_breakpoint("13")
    debugger.resume()
    cause = explained(debugger, text)
    assert len(cause.causes) == 2


def test_a_reading_names_the_degradation_that_bent_it() -> None:
    debugger = debugger_of(SAMPLES, world="faulty.xml")
    debugger.goto_time(8.0)
    true = shape(explained(debugger, "front"))
    assert true[-1].endswith("from edge-east")
    debugger.goto_time(14.0)
    *_, measured, bent = shape(explained(debugger, "front"))
    assert measured.endswith("from nothing that was there")
    assert bent == "STATE_SONAR_0: bent by the degradation stuck: sonar 0, stuck"


MEMBERS = """\
#include <stdio.h>
#include <string.h>
struct pair { int first, second; } from = {1, 2}, to;
int number;
int main(void)
{
    memcpy(&to, &from, sizeof to);
    from.second = 3;
    memcpy(&to, &from, sizeof to);
    if (!sscanf("7", "%d", &number))
        return 1;
    return to.second + number; /* line 12 */
}
"""


def test_a_copied_member_is_not_explained_by_what_the_copy_replaced() -> None:
    """All but the first member had the target, as it was before, among their causes."""
    debugger = debugger_of(MEMBERS)
    debugger.stop_points.add_breakpoint("12")
    debugger.resume()
    for member, value in ("first", 1), ("second", 3):
        causes = explained(debugger, f"to.{member}").causes
        assert [each.text for each in causes] == [f"from.{member} = {value}"]
    # the statement was shown without its negation
    assert explained(debugger, "number").how == '!sscanf("7", "%d", &number)'


LOOPS = """\
int total, steps[5] = { 1, 2, 3, 4, 5 };
char from[12] = "hello world", to[12];
int main(void)
{
    int i;
    const char *next = from;
    char *put = to;
    for (i = 0; i < 20; i++)
        total += steps[i % 5];
    while (*next)
        *put++ = *next++;
    return total; /* line 12 */
}
"""


def test_changes_of_an_object_by_itself_in_a_loop_are_one_node() -> None:
    debugger = debugger_of(LOOPS)
    debugger.stop_points.add_breakpoint("12")
    debugger.resume()
    total = explained(debugger, "total")
    assert shape(total) == [
        "total = 60", "total = 55", "total = 0", "steps[i % 5] = 1", "i = 0",
        "steps[i % 5] = 5", "i = 19", "i = 0",
    ]  # fmt: skip
    assert [each.times for each in nodes(total) if each.times > 1] == [19, 19]
    assert all("the first one here" in each.how for each in nodes(total) if each.times > 1)
    copied = explained(debugger, "to[4]")
    names = [each.partition(" = ")[0] for each in shape(copied)]
    assert "*put" not in names  # it is not read
    assert names.count("next") <= 4
