"""Changes of programs and of who takes part, and how changes are taken back."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.debug.engine import Debugger
from crs_cc.debug.errors import DebugError
from crs_cc.debug.timeline.change import Change
from crs_cc.debug.timeline.position import BEGINNING, Position
from tests.debug.debuggers import debugger_at

PROGRAM = """\
#include <Nclient.h>
#include <stdio.h>

int main(void)
{
    int i;
    connect_robot(1);
    for (i = 0; i < 300; i++) {
        get_sn();
        printf("%d\\n", i);
        if (i == 20)
            vm(50, 50, 0);
    }
    return 0;
}
"""


@pytest.fixture(scope="module")
def program(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("edits") / "go.c"
    path.write_text(PROGRAM)
    return path


@pytest.fixture
def debugger(program: Path) -> Debugger:
    return debugger_at([program], "wall.xml")


def state(debugger: Debugger, timestep: int) -> tuple[str, bytes]:
    debugger.goto_timestep(timestep)
    return debugger.session.state_hash(), debugger.run.console.text()


def x_m(debugger: Debugger) -> float:
    return float(debugger.session.environment.state.x_m[0])


def test_changes_are_taken_back_with_all_that_followed(debugger: Debugger) -> None:
    plain = state(debugger, 40)
    debugger.goto(BEGINNING)
    debugger.edit_world("drive robot0 0.2")
    moved = state(debugger, 10)
    debugger.edit_world("heat robot0 5")
    debugger.edit_world("degrade robot0 sonar dead")
    later = state(debugger, 40)
    assert len({plain, moved, later}) == 3
    debugger.revert(2)
    assert debugger.position == Position(10, 0)
    assert [each.text for each in debugger.run.history.changes] == [
        "drive robot0 0.2",
        "heat robot0 5",
    ]
    debugger.edit_world("degrade robot0 sonar dead")
    assert state(debugger, 40) == later
    debugger.revert(1)
    assert state(debugger, 10) == moved
    debugger.revert(0)
    assert debugger.position == BEGINNING
    assert debugger.run.history.changes == ()
    assert state(debugger, 40) == plain
    with pytest.raises(DebugError):
        debugger.revert(0)


def test_a_robot_that_joins_is_gone_before_and_back_after(debugger: Debugger) -> None:
    debugger.goto_timestep(5)
    assert debugger.edit_world("join more like robot0 to 1 1 90").startswith("more joins at 1.000")
    joined = state(debugger, 30)
    assert debugger.names == ("robot0", "more")
    assert debugger.session.state.alive.tolist() == [True, True]
    debugger.goto_timestep(2)
    assert debugger.names == ("robot0",)
    assert state(debugger, 30) == joined
    debugger.goto_timestep(8)
    debugger.view.select_robot("more")
    debugger.step()
    assert debugger.view.evaluate_pure("i").text == debugger.view.evaluate_pure("i", robot=1).text
    debugger.revert(0)
    assert debugger.names == ("robot0",)
    for wrong in ("join robot0 like robot0 to 1 1", "join x like nobody to 1 1",
                  "join x like robot0 to 1 1 running other.c", "join x like robot0",
                  "join robot0", "join x"):  # fmt: skip
        with pytest.raises(DebugError):
            debugger.edit_world(wrong)


def test_a_program_that_is_brought_is_part_of_the_change_that_uses_it(debugger: Debugger) -> None:
    uploads = debugger.run.uploads
    for name, text in (("../x.c", ""), ("x.c", "int main(void) { return y; }"),
                       ("x.c", '#include "/etc/passwd"')):  # fmt: skip
        with pytest.raises(DebugError):
            uploads.add(name, text)
    uploads.add("still.c", "int main(void) { for (;;) ; }")
    debugger.goto_timestep(3)
    debugger.edit_world("join more like robot0 to 1 1 running still.c")
    found = state(debugger, 20)
    (change,) = debugger.run.history.changes
    assert Change.of(change.as_data()) == change
    again = debugger_at([debugger.run.programs[0].paths[0]], "wall.xml")
    again.goto_timestep(3)
    again.repeat(change)
    assert state(again, 20)[1] == found[1]
    assert again.names == ("robot0", "more")


def test_a_program_sleeps_and_wakes(debugger: Debugger) -> None:
    debugger.goto_timestep(5)
    before = debugger.run.console.text()
    debugger.edit_world("sleep robot0 1s")
    assert state(debugger, 20)[1] == before
    debugger.edit_world("wake robot0")
    assert len(state(debugger, 24)[1]) > len(before)
    debugger.revert(1)
    assert len(state(debugger, 40)[1]) > len(before)
    with pytest.raises(DebugError):
        debugger.edit_world("sleep robot0 0s")


def test_a_robot_is_driven_and_held(debugger: Debugger) -> None:
    start_m = x_m(debugger)
    debugger.edit_world("drive robot0 0.2 0")
    debugger.goto_timestep(10)
    driven_m = x_m(debugger) - start_m
    assert driven_m > 0.03
    debugger.edit_world("hold robot0")
    debugger.goto_timestep(20)
    held_m = x_m(debugger)
    debugger.goto_timestep(25)
    assert x_m(debugger) == pytest.approx(held_m, abs=1e-3)
    debugger.edit_world("release robot0")
    with pytest.raises(DebugError):
        debugger.edit_world("release robot0")


def test_links_are_shut_at_a_time_and_messages_sent_by_hand(program: Path) -> None:
    debugger = debugger_at([program, program], "pair.xml")
    control = debugger.session.environment.communication
    debugger.edit_world("shut radio from robot0 at 0.5s for 1s")
    debugger.edit_world("shut radio to robot0 at 3s")
    assert control.outages() == [
        (0.5, 1.5, "radio", "robot0", ""),
        (3.0, float("inf"), "radio", "", "robot0"),
    ]
    debugger.edit_world("open radio to robot0")
    assert len(debugger.session.environment.communication.outages()) == 1
    debugger.edit_world("message robot0 to robot1 type 3: go = now: 1")
    debugger.goto_timestep(11)
    debugger.edit_world("message robot0 on radio: lost")
    debugger.goto_timestep(14)
    texts = [each.text for each in debugger.run.event_history.world_events()]
    assert any("robot0 to robot1, type 3, 11 bytes: delivered" in text for text in texts)
    assert any("type 0, 4 bytes: lost: link outage" in text for text in texts)
    for wrong in ("message robot0 to robot0: x", "message robot0", "shut radio for 1s at 2s x"):
        with pytest.raises(DebugError):
            debugger.edit_world(wrong)
