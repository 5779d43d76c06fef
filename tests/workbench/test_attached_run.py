"""Changes that pages make in a live run."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from crs_cc.cli.run_changes import RunChanges
from crs_cc.debug.errors import DebugError
from crs_cc.debug.timeline.change import Change
from crs_cc.debug.timeline.position import Position
from crs_cc.session.session import Session
from crs_cc.workbench import control
from crs_cc.workbench.attached_run import AttachedRun
from crs_cc.workbench.feed import Feed
from crs_cc.workbench.instruments import NOT_ASKED, inspect
from crs_cc.workbench.player import Player
from crs_cc.workbench.screen import Screen
from crs_cc.workbench.watcher import Watcher
from tests.session.programs import HALL, ROAM, build


@pytest.fixture(scope="module")
def make(tmp_path_factory: pytest.TempPathFactory) -> Callable[[], Session]:
    program = build(tmp_path_factory.mktemp("attached"), ROAM)
    return lambda: Session(HALL, [program, program])


def attached(
    session: Session, made: Callable[[Change], None], repeats_until_s: float = 0.0
) -> AttachedRun:
    watcher = Watcher(Feed({}, 0.05))
    watcher.begin(session)
    return AttachedRun(session, watcher, made, repeats_until_s)


def test_a_saved_script_makes_the_changes_again_at_their_timesteps(
    make: Callable[[], Session], tmp_path: Path
) -> None:
    session, again = make(), make()
    made: list[Change] = []
    run = attached(session, made.append)
    screen = Screen(run, Feed({}, 0.05), Player(0.05))
    for heading in range(9):
        session.advance(1)
        said = control.edit(screen, f"turn left to {heading}")["text"]
        assert said == f"left now has heading {heading}.0 deg."
        run.note(made[-1])
    screen.server.close()
    script = tmp_path / "changes.txt"
    script.write_text(control.export(screen, "inputs")["text"])
    assert "0.35s: turn left to 6\n" in script.read_text()
    found: list[Change] = []
    changes = RunChanges(script, again.environment.timestep_s)
    while again.timesteps < session.timesteps:
        again.advance(1)
        changes.apply_due(again, found.append)
    assert found == made
    assert found[-1].position == Position(9, 0)
    assert again.state_hash() == session.state_hash()


def test_rejected_changes_are_neither_made_nor_recorded(make: Callable[[], Session]) -> None:
    session = make()
    session.advance(1)
    made: list[Change] = []
    run, before = attached(session, made.append), session.state_hash()
    for text, reason in (
        ("join x like left to 1 1", "robots cannot be added to a run that only goes forward"),
        ("turn left", "expected: turn"),
        ("turn x to 5", "unknown robot or movable object 'x'"),
        ("", "missing change"),
    ):
        with pytest.raises(DebugError, match=reason):
            run.edit(text, is_playing=True)
    assert made == []
    assert session.state_hash() == before


def test_a_run_is_not_changed_while_it_repeats_a_recorded_one(make: Callable[[], Session]) -> None:
    session = make()
    made: list[Change] = []
    run = attached(session, made.append, repeats_until_s=0.1)
    session.advance(1)
    with pytest.raises(DebugError, match=r"repeats a recorded one until 0\.10 s: change it then"):
        run.edit("turn left to 5", is_playing=True)
    session.advance(1)
    run.edit("turn left to 5", is_playing=True)
    assert [each.text for each in made] == ["turn left to 5"]


def test_readings_are_shown_without_inspectable_programs(make: Callable[[], Session]) -> None:
    session = make()
    session.advance(8)
    screen = Screen(attached(session, [].append), Feed({}, 0.05), Player(0.05))
    screen.server.close()
    found = inspect(screen, 0, "battery\nsonar.8\nturns")
    assert 90.0 < found["values"][0] <= 100.0
    assert found["values"][1] == pytest.approx(0.8, abs=0.05)
    assert found["values"][2] == NOT_ASKED
    assert found["state"] == []
    assert len(found["sensors"]["sonar"]["elements"]) == 16
    with pytest.raises(DebugError, match="no robot 2"):
        inspect(screen, 2, "speed")
