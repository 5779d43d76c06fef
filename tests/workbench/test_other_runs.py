"""Runs that are compared with others: branches, and recordings that are named or brought."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from crs_cc.cli.debug_options import DebugOptions
from crs_cc.cli.inputs import Inputs
from crs_cc.cli.main import main
from crs_cc.cli.start_view import open_others, screen_of
from crs_cc.cli.view_recording import recording_screen
from crs_cc.core.errors import RecordingError
from crs_cc.debug.errors import DebugError
from crs_cc.recording.recording import Recording
from crs_cc.workbench import comparing, control, instruments, other_runs
from crs_cc.workbench.commands import TABLE
from crs_cc.workbench.other_runs import MAX_RUNS
from crs_cc.workbench.screen import Screen
from crs_cc.workbench.trajectories import Trajectories

PROGRAM = """\
#include <Nclient.h>
#include <stdio.h>

int turns, limit = LIMIT;

int main(void)
{
    connect_robot(1);
    while (State[STATE_CONF_X] < limit) {
        turns++;
        printf("turn %d\\n", turns);
        vm(100, 100, 0);
    }
    st();
    puts("there");
    for (;;)
        gs();
}
"""
WORLD = """<world version="1" timestep="50ms">
  <area length="9m" width="9m"/><robot id="ada" x="2m" y="3m"/>{}
</world>
"""
SECOND = '<robot id="bob" x="2m" y="6m"/>'


@pytest.fixture(scope="module")
def runs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Ada drives 40 or 80 tenths of inches, alone or with bob, in timesteps of 50 or 100 ms."""
    folder = tmp_path_factory.mktemp("compared")
    (folder / "drive.c").write_text(PROGRAM)
    (folder / "world.xml").write_text(WORLD.format(""))
    (folder / "two.xml").write_text(WORLD.format(SECOND))
    (folder / "slow.xml").write_text(WORLD.format("").replace("50ms", "100ms"))
    (folder / "other.xml").write_text(WORLD.format("").replace("ada", "eve"))
    for name, world, limit in (
        ("near", "world", 40), ("far", "world", 80), ("two", "two", 80), ("slow", "slow", 40),
        ("other", "other", 40),
    ):  # fmt: skip
        words = [f"{folder / 'drive.c'}", f"{folder / world}.xml", "-D", f"LIMIT={limit}"]
        target = str(folder / f"{name}.mcap")
        assert main(["run", "-q", *words, "--max-time", "4", "--record", target]) == 0
    return folder


@pytest.fixture
def stack() -> Iterator[ExitStack]:
    with ExitStack() as made:
        yield made


def shown(runs: Path, name: str, stack: ExitStack, *others: str) -> Screen:
    """Show a recording, with others beside it."""
    recording = Recording(runs / f"{name}.mcap")
    stack.callback(recording.close)
    screen = recording_screen(recording, 0, stack)
    stack.callback(screen.server.close)
    open_others(screen, [runs / f"{each}.mcap" for each in others])
    return screen


def asked(screen: Screen, command: str, **fields: Any) -> Any:
    return TABLE[command](screen, fields)


def differ(screen: Screen, name: str) -> dict[str, Any]:
    found = asked(screen, "next_difference", name=name, anew=True)
    while not found["is_done"]:
        found = asked(screen, "next_difference", name=name, anew=False)
    return dict(found)


def test_two_recordings_are_compared_by_motion_and_output(runs: Path, stack: ExitStack) -> None:
    screen = shown(runs, "near", stack, "far")
    found = asked(screen, "compare", name="far.mcap")
    rows = {each["what"]: each for each in found["differences"]}
    assert rows["print"]["here"] == "not then"  # it is elsewhere already
    assert rows["print"]["there"] == "turn 44"
    assert rows["pose.x"]["robot"] == "ada"
    assert rows["pose.x"]["t"] > rows["print"]["t"] > 0.5
    assert rows["pose.x"]["by"].endswith(" m")
    begin_s = found["differences"][0]["t"]
    assert found["paths"]["ada"][0][2] == pytest.approx(begin_s, abs=0.051)
    assert found["paths"]["ada"][-1][0] > found["own"]["ada"][-1][0] + 0.05
    (number, *_) = found["blocks"][0]
    assert screen.feed.frames.content(number) is None
    assert screen.others.block(number)
    assert asked(screen, "frames", block=number).startswith(b"B")


def test_variables_of_recordings_are_compared_by_running_both_again(
    runs: Path, stack: ExitStack
) -> None:
    screen = shown(runs, "near", stack, "far")
    screen.run.seek(1.0)
    found = differ(screen, "far.mcap")
    assert found["t"] == 0.0
    (row,) = found["found"]
    assert (row["t"], row["robot"], row["what"], row["is_variable"]) == (0.0, "ada", "limit", True)
    assert (row["here"], row["there"], row["by"]) == ("40", "80", "40")
    assert screen.run.time_s == 1.0


def test_a_change_by_the_user_is_found_in_its_timestep(
    runs: Path, tmp_path: Path, stack: ExitStack
) -> None:
    changed = tmp_path / "changed.mcap"
    commands = ["goto 0.7s", "set var turns = 1000", "goto 2s", f"save run {changed}"]
    words = [word for command in commands for word in ("-ex", command)]
    assert main(["debug", str(runs / "far.mcap"), "--batch", *words]) == 0
    screen = shown(runs, "far", stack)
    open_others(screen, [changed])
    found = differ(screen, "changed.mcap")
    assert found["t"] == pytest.approx(0.75)
    (turns,) = [each for each in found["found"] if each["what"] == "turns"]
    assert float(turns["by"]) > 900
    assert int(turns["there"]) > 1000 > int(turns["here"])


def test_a_run_is_the_same_as_its_recording_and_differs_once_it_is_changed(
    runs: Path, stack: ExitStack
) -> None:
    files = Inputs((runs / "drive.c",), runs / "world.xml")
    compiler = DebugOptions(inputs=files).compiler.__class__(defines=("LIMIT=40",))
    screen = screen_of(DebugOptions(inputs=files, quiet=True, compiler=compiler), 0)
    stack.callback(screen.server.close)
    open_others(screen, [runs / "near.mcap"])
    assert asked(screen, "compare", name="near.mcap")["differences"] == []
    screen.run.advance(60)
    here = screen.run.debugger().session.state_hash()
    same = asked(screen, "compare", name="near.mcap")
    assert (same["differences"], same["until"]) == ([], pytest.approx(3.0))
    found = differ(screen, "near.mcap")
    assert (found["found"], found["t"]) == ([], pytest.approx(3.0))
    assert screen.run.debugger().session.state_hash() == here
    screen.run.seek(0.5)
    control.edit(screen, "turn ada to 90")
    screen.run.advance(40)
    first, *_ = asked(screen, "compare", name="near.mcap")["differences"]
    assert first["t"] == pytest.approx(0.55, abs=0.051)
    exact = differ(screen, "near.mcap")
    pose = next(each for each in exact["found"] if each["what"] == "pose")
    assert pose["t"] == pytest.approx(0.55, abs=0.051)
    assert pose["by"].endswith(" deg")
    assert not any(each["is_variable"] for each in exact["found"])  # the program turns as often
    assert exact["t"] == pytest.approx(2.5)
    ways_m = instruments.history(
        screen, robot=0, expressions="apart from near.mcap", begin_s=0.0, end_s=2.5, count=500
    )["series"][0]
    assert max(way for at, way in zip(*ways_m, strict=True) if at <= 0.5) == 0.0
    assert ways_m[1][-1] > 0.05
    (now,) = instruments.inspect(screen, 0, "apart from near.mcap")["values"]
    assert now == pytest.approx(ways_m[1][-1])


def test_branches_are_compared_by_their_variables(runs: Path, stack: ExitStack) -> None:
    files = Inputs((runs / "drive.c",), runs / "world.xml")
    compiler = DebugOptions(inputs=files).compiler.__class__(defines=("LIMIT=400",))
    screen = screen_of(DebugOptions(inputs=files, quiet=True, compiler=compiler), 0)
    stack.callback(screen.server.close)
    screen.run.advance(60)
    screen.run.seek(1.0)
    asked(screen, "console", line="set var turns = turns + 5")
    screen.run.advance(20)
    here = screen.run.debugger().session.state_hash()
    known = screen.feed.contents()
    found = differ(screen, "main")
    assert found["t"] == pytest.approx(1.0)
    assert {"robot": "ada", "what": "turns", "by": "5"}.items() <= found["found"][0].items()
    assert screen.run.debugger().session.state_hash() == here
    assert screen.feed.contents() == known
    control.switch(screen, "main")
    assert screen.run.time_s == pytest.approx(screen.feed.end_s - 1.0, abs=0.1)
    assert differ(screen, "run2")["t"] == pytest.approx(1.0)


def test_robots_are_matched_by_name(runs: Path, stack: ExitStack) -> None:
    screen = shown(runs, "two", stack, "far", "other")
    found = asked(screen, "compare", name="far.mcap")
    assert found["differences"] == []
    assert asked(screen, "compare", name="far.mcap")["paths"] == {}
    with pytest.raises(DebugError, match="no robot of the same name"):
        asked(screen, "compare", name="other.mcap")


def test_incomparable_runs_are_reported(runs: Path, stack: ExitStack) -> None:
    screen = shown(runs, "near", stack, "slow")
    assert asked(screen, "compare", name="slow.mcap")["until"] == pytest.approx(4.0)
    with pytest.raises(DebugError, match=r"the timestep of slow.mcap is 0.1 s, not 0.05 s"):
        asked(screen, "next_difference", name="slow.mcap", anew=True)
    with pytest.raises(DebugError, match="unknown run 'gone'"):
        asked(screen, "compare", name="gone")
    screen.player.play()
    with pytest.raises(DebugError, match="pause it first"):
        asked(screen, "next_difference", name="slow.mcap", anew=True)


def sent(screen: Screen, name: str, content: bytes, size: int = 20_000) -> None:
    for offset in range(0, len(content), size):
        data = b64encode(content[offset : offset + size]).decode()
        asked(screen, "upload_piece", name=name, offset=offset, data=data)


def test_a_page_uploads_a_recording_in_pieces(
    runs: Path, stack: ExitStack, monkeypatch: pytest.MonkeyPatch
) -> None:
    screen = shown(runs, "near", stack)
    content = (runs / "far.mcap").read_bytes()
    sent(screen, "far.mcap", content)
    assert asked(screen, "open", name="far.mcap") == {"name": "far.mcap"}
    (listed,) = screen.others.listing()
    assert listed["title"] == "drive.c in world.xml, seed 0"
    assert asked(screen, "compare", name="far.mcap")["differences"]
    asked(screen, "close", name="far.mcap")
    assert screen.others.listing() == []
    monkeypatch.setattr(other_runs, "MAX_BYTES", 1000)
    with pytest.raises(ValueError, match="too large"):
        sent(screen, "far.mcap", content)
    assert screen.others._folder is not None
    assert list(Path(screen.others._folder.name).iterdir()) == []  # nothing is left of either
    with pytest.raises(DebugError, match=r"no recording 'far.mcap' is open"):
        asked(screen, "close", name="far.mcap")


def test_invalid_recordings_are_rejected(runs: Path, stack: ExitStack) -> None:
    screen = shown(runs, "near", stack)
    with pytest.raises(ValueError, match="is not the name of a recording"):
        sent(screen, "../far.mcap", b"x")
    with pytest.raises(ValueError, match="is not the name of a recording"):
        sent(screen, "far.txt", b"x")
    with pytest.raises(ValueError, match="not valid base64"):
        asked(screen, "upload_piece", name="far.mcap", offset=0, data="?")
    with pytest.raises(ValueError, match="does not follow"):
        asked(screen, "upload_piece", name="far.mcap", offset=7, data="AAAA")
    with pytest.raises(DebugError, match=r"no recording 'far.mcap' has been uploaded"):
        asked(screen, "open", name="far.mcap")
    sent(screen, "far.mcap", b"not a recording")
    with pytest.raises(DebugError, match=r"^far.mcap: "):
        asked(screen, "open", name="far.mcap")
    with pytest.raises(RecordingError):
        open_others(screen, [runs / "drive.c"])
    content = (runs / "far.mcap").read_bytes()
    for number in range(MAX_RUNS):
        sent(screen, f"{number}.mcap", content)
        asked(screen, "open", name=f"{number}.mcap")
    sent(screen, "more.mcap", content)
    with pytest.raises(DebugError, match=f"at most {MAX_RUNS} recordings"):
        asked(screen, "open", name="more.mcap")


def test_a_trajectory_is_interpolated_and_constant_while_nothing_moved() -> None:
    poses = np.zeros((3, 3, 1))
    poses[:, 0, 0] = [0.0, 1.0, 3.0]
    poses[:, 2, 0] = [3.1, -3.1, -3.1]
    known = Trajectories(np.array([0.0, 0.1, 5.0]), poses, 0.1)
    found = known.interpolate(np.array([-1.0, 0.05, 4.0, 4.85, 4.925, 5.0, 6.0]))
    assert found[:, 0, 0].tolist() == pytest.approx(
        [np.nan, 0.5, 1.0, 1.0, 2.0, 3.0, np.nan], nan_ok=True
    )
    assert abs(found[1, 2, 0]) == pytest.approx(np.pi, abs=0.01)  # by the shorter way


def test_read_only_pages_may_view_comparisons_but_not_upload_files() -> None:
    assert not TABLE["compare"].controls
    assert all(
        TABLE[name].controls for name in ("upload_piece", "open", "close", "next_difference")
    )
    assert {each.name for each in comparing.COMPARING} <= set(TABLE)
