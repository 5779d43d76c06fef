"""Commands about robots and the world, and those that change it."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.debug.commands import world
from crs_cc.debug.commands.shell import Shell
from crs_cc.debug.errors import DebugError
from crs_cc.debug.world.run_edits import ALL_EDITS
from tests.debug.debuggers import debugger_at, debugger_of

DRIVES = """\
#include "Nclient.h"
int main(void)
{
    int i;
    connect_robot(1);
    for (i = 0; i < 400; i++) {
        vm(100, 100, 0);
        gs();
    }
    return 0;
}
"""

SILENT = """\
int main(void)
{
    return 0;
}
"""


@pytest.fixture(scope="module")
def drives(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("drives") / "drives.c"
    path.write_text(DRIVES)
    return path


@pytest.fixture
def shell(drives: Path) -> Shell:
    debugger = debugger_at([drives], "wall.xml")
    debugger.start()
    return Shell(debugger)


def said(shell: Shell, *commands: str) -> list[str]:
    return [line.text for command in commands for line in shell.execute(command)]


def here(shell: Shell) -> tuple[str, bytes]:
    session = shell.debugger.session
    return session.state_hash(), shell.debugger.run.console.text()


def test_state_is_shown_by_names_without_missing_devices(shell: Shell) -> None:
    rows = said(shell, "break 7 if i == 12", "continue", "info state")
    assert "[33] STATE_BUMPER        none" in rows
    names = [row.split()[1] for row in rows if row.startswith("[")]
    assert "STATE_VEL_RIGHT" in names
    assert not any("_IR_" in name or "TURRET" in name for name in names)


def test_info_state_of_a_program_without_state() -> None:
    shell = Shell(debugger_of(SILENT))
    shell.debugger.start()
    assert said(shell, "info State") == ["robot0's program has no State[]"]


OWN_STATE = """\
#include <math.h>
double State[3] = {0.5, 2};
int main(void)
{
    State[2] = NAN;
    return 0;
}
"""


def test_a_users_own_state_array_is_not_the_vendors() -> None:
    shell = Shell(debugger_of(OWN_STATE))
    said(shell, "next", "next")
    assert said(shell, "print State[2]")[0].endswith("nan")
    assert said(shell, "info state") == ["robot0's program has no State[]"]


def test_a_map_is_drawn_whole_or_around_a_robot(shell: Shell) -> None:
    whole = said(shell, "map")
    assert 8 <= len(whole) <= 24
    assert max(map(len, whole)) <= 78
    close = said(shell, "map robot0 2m")
    assert len(close) == 24
    assert close != whole
    assert said(shell, "map nobody") == ["unknown robot 'nobody' (known: robot0)"]
    assert said(shell, "map robot0 wide")[0].startswith("'wide' is not a length")
    assert said(shell, "map robot0 0") == ["the map's height must be 0.01 to 100000 m"]


def test_a_change_of_the_world_is_replayed(shell: Shell) -> None:
    said(shell, "tick 12")
    before = here(shell)
    unchanged = [said(shell, "tick 8"), here(shell)]
    said(shell, "goto tick 12")
    assert here(shell) == before
    assert said(shell, "move robot0 to 2 3.5 90") == ["robot0 is now at 2.000, 3.500 m, 90.0 deg."]
    assert said(shell, "degrade robot0 sonar.0 stuck 20cm", "shut all") == [
        "robot0: sonar 0, stuck at 0.2m (degradation0).", "every link is now blocked."
    ]  # fmt: skip
    changed = here(shell)
    assert changed != before
    said(shell, "tick 8")
    after = here(shell)
    assert after != unchanged[1]
    said(shell, "reverse-tick 8")
    assert here(shell) == changed
    said(shell, "tick 8")
    assert here(shell) == after
    said(shell, "goto tick 3", "goto tick 20")
    assert here(shell) == after


def test_the_world_can_be_changed_inside_a_timestep(shell: Shell) -> None:
    said(shell, "break 8 if i == 9", "continue", "delete")
    session = shell.debugger.session
    assert session.state.halted == 0
    said(shell, "move robot0 to 1 3.5", "remove robot0")
    assert session.environment.state.x_m[0] == 1.0
    changed = here(shell)
    said(shell, "tick")
    after = here(shell)
    assert not session.environment.state.presence.present[0]
    said(shell, "reverse-tick", "tick")
    assert here(shell) == after
    said(shell, "reverse-stepi")
    assert changed != after


def test_invalid_changes_have_no_effect(shell: Shell) -> None:
    said(shell, "tick 5")
    before = here(shell)
    assert said(shell, "move robot0 to 99 99") == [
        "cannot move 'robot0': it would overlap the edge of the world"
    ]
    assert said(shell, "degrade robot0 sonar.99 dead")[0].startswith(
        "element: unknown '99' of sonar"
    )
    assert here(shell) == before
    with pytest.raises(DebugError):
        shell.debugger.edit_world("fly")


def test_every_change_has_help(shell: Shell) -> None:
    for name, each in ALL_EDITS.items():
        assert said(shell, f"help {name}")[0] == f"{name} {each.syntax} - {each.summary}"
    assert any("bumper-pressed" in line for line in said(shell, "help catch"))


def test_caught_events_are_reported(shell: Shell) -> None:
    answer = said(shell, "move robot0 to 5.5 3 0", "catch collision", "continue")
    assert any("robot0 touched" in line for line in answer)


@pytest.mark.parametrize("across", ["1e-300", "1e-9", "0", "-1", "nan", "1e300"])
def test_a_map_of_invalid_size_is_refused(across: str) -> None:
    with pytest.raises(DebugError):
        world._across_m(across)
