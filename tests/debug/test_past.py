"""Questions about the recorded run are answered as single-stepping would answer them."""

from __future__ import annotations

import pytest

from crs_cc.debug.engine import Debugger
from crs_cc.debug.errors import DebugError
from crs_cc.debug.past import Past
from crs_cc.debug.timeline.input_log import InputLog
from tests.debug.debuggers import debugger_of, line

DRIVES = """\
#include "Nclient.h"
int speed, total;
int twice(int x)
{
    int y = x;
    y += x;
    return y;
}
int main(void)
{
    int i;
    connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400);
    for (i = 0; i < 5; i++) {
        speed = twice(20 * i);
        total = total + (speed > 100);
        scout_vm(speed, 0);
        ws(1, 1, 0, 1);
    }
    return 0;
}
"""


@pytest.fixture
def debugger() -> Debugger:
    """Return a debugger of a program that has ended, after an edit on the way."""
    debugger = debugger_of(DRIVES)
    debugger.goto_time(1.0)
    debugger.evaluate("total = 40")
    debugger.goto_end()
    return debugger


def past(debugger: Debugger) -> Past:
    return Past(debugger.view, debugger.stop_points)


def stepped(debugger: Debugger, expression: str) -> list[str]:
    """Return the values of an expression by single-stepping, without repetitions."""
    debugger.goto_time(0.0)
    found: list[str] = []
    while True:
        text = debugger.view.evaluate_pure(expression).text
        if not found or found[-1] != text:
            found.append(text)
        if debugger.view.is_over or debugger.step_statement().reason != "step":
            return found


@pytest.mark.parametrize("expression", ["speed", "total", "speed + total", "speed > 100"])
def test_a_history_has_the_values_that_single_stepping_shows(
    debugger: Debugger, expression: str
) -> None:
    here = debugger.position
    found = past(debugger).values(expression, past(debugger).whole())
    assert debugger.position == here
    edited = [each.text for each in found]
    expected = stepped(debugger, expression)
    assert [each for each in expected if each in edited] == expected
    assert edited[0] == expected[0]
    assert edited[-1] == expected[-1]


def test_a_history_goes_to_before_the_statement_that_wrote(debugger: Debugger) -> None:
    for each in past(debugger).values("speed", past(debugger).whole())[1:]:
        debugger.goto(each.position)
        assert each.location is not None
        assert each.location.line == 14
        assert line(debugger) == 7  # the last statement that starts before, that of the call
        assert debugger.view.time_s == pytest.approx(each.time_s, abs=1e-3)


def test_times_at_which_a_condition_became_true(debugger: Debugger) -> None:
    whole = past(debugger).whole()
    assert len(past(debugger).times("speed > 100", whole)) == 1
    assert len(past(debugger).times("speed >= 0", whole)) == 1
    (found,) = past(debugger).times("robot0.x > 0.1", whole)
    debugger.goto(found.position)
    assert debugger.session.environment.state.x_m[0] > 0.1
    debugger.tick(backward=True)
    assert debugger.session.environment.state.x_m[0] <= 0.1


def test_a_message_added_after_the_fact_is_that_of_a_log_point(debugger: Debugger) -> None:
    place = debugger.stop_points.location("16")
    whole = past(debugger).whole()
    found = past(debugger).messages(place, "{i}: {speed} at {robot0.x > 0.1}", whole)
    said: list[str] = []
    debugger.stop_points.print_log = said.append
    debugger.stop_points.add_breakpoint("16", log="{i}: {speed} at {robot0.x > 0.1}")
    debugger.goto_time(0.0)
    debugger.resume()
    assert [each.text for each in found] == said
    assert len(said) == 5


def test_a_part_of_the_past_has_the_value_at_its_start(debugger: Debugger) -> None:
    whole = past(debugger).values("speed", past(debugger).whole())
    part = past(debugger).values("speed", past(debugger).part(2.0, 3.0))
    assert part[0].text == [each.text for each in whole if each.time_s <= 2.0][-1]
    assert [each.text for each in part[1:]] == [
        each.text for each in whole if 2.0 < each.time_s < 3.0
    ]


PRINTS = """\
#include <stdio.h>
#include "Nclient.h"
int main(void)
{
    int i;
    connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400);
    for (i = 0; i < 4; i++) {
        printf("turn %d\\n", i);
        scout_vm(300, 0);
        sleep(1);
    }
    return 0;
}
"""


def test_every_printed_line_leads_to_its_statement() -> None:
    debugger = debugger_of("#include <unistd.h>\n" + PRINTS, world="pair.xml")
    debugger.goto_end()
    lines = debugger.run.console.text().decode().splitlines()
    for number, text in enumerate(lines, 1):
        robot, statement = past(debugger).printed(number)
        if text.startswith("turn"):
            debugger.view.select_robot(robot)
            debugger.goto_statement(statement)
            assert line(debugger) == 9
            assert debugger.view.evaluate_pure("i").text == text.removeprefix("turn ")
            debugger.goto_end()
    with pytest.raises(DebugError, match="no line 99 has been printed"):
        past(debugger).printed(99)


def test_an_event_is_where_a_catchpoint_stops() -> None:
    debugger = debugger_of("#include <unistd.h>\n" + PRINTS, world="pair.xml")
    debugger.goto_end()
    found = past(debugger).events("collision", past(debugger).whole())
    assert found
    debugger.stop_points.add_catchpoint("collision")
    debugger.goto_time(0.0)
    caught = []
    while (stop := debugger.resume()).breakpoints:
        caught.append(stop.position)
    assert list(dict.fromkeys(one.position for one, _ in found)) == caught


def test_a_range_that_ends_before_it_begins_is_refused(debugger: Debugger) -> None:
    with pytest.raises(DebugError, match="ends before it starts"):
        past(debugger).part(3.0, 1.0)


def test_answers_are_the_same_whether_the_world_is_replayed_or_not(debugger: Debugger) -> None:
    place = debugger.stop_points.location("5")

    def answers() -> list[object]:
        asked, part = past(debugger), past(debugger).part(0.3, None)
        return [
            *asked.values("speed + total", part),
            *asked.times("speed > 30", part),
            *asked.messages(place, "x is {x}", part),
        ]

    without_world = answers()
    debugger.run.input_log = InputLog()
    with_world = answers()
    assert len(with_world) > 8
    assert without_world == with_world


ALL_AT_ONCE = """\
#include <stdio.h>
int calls;
int main(void)
{
    while (calls < 4) {
        calls++;
        printf("%d\\n", calls);
    }
    calls = 9;
    return 0;
}
"""


def test_the_past_reaches_to_where_the_run_was_last_in_its_timestep() -> None:
    debugger = debugger_of(ALL_AT_ONCE)
    debugger.goto_end()
    values = [str(each) for each in (0, 1, 2, 3, 4, 9)]

    def all_values() -> list[str]:
        return [each.text for each in past(debugger).values("calls", past(debugger).whole())]

    assert all_values() == values
    places = [past(debugger).printed(number) for number in (1, 4)]
    for _, statement in reversed(places):
        debugger.goto_statement(statement)
        assert all_values() == values
        assert [past(debugger).printed(number) for number in (1, 4)] == places
    debugger.evaluate("calls = 20")
    assert all_values() == ["0", "1", "20"], "what followed is forgotten"
