"""Passages of many timesteps are recorded as the same timesteps one by one."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from mcap.reader import make_reader

from crs_cc.core.arrays import FloatArray, Records
from crs_cc.core.source import Diagnostics
from crs_cc.recording.block import Block
from crs_cc.recording.description import RunDescription
from crs_cc.recording.frame_buffer import Shape
from crs_cc.recording.recorder import Recorder, RecorderOptions
from crs_cc.recording.recording import Recording
from crs_cc.recording.saved import COLUMNS, Second
from crs_cc.session.build import build_executable
from crs_cc.session.session import Session
from crs_cc.sim.engine.passage import Passage
from crs_cc.sim.engine.step import Served, Step
from crs_cc.sim.files.world_xml import load_world
from crs_cc.sim.kernels.calm import ANSWER, FRAME
from crs_cc.sim.model.world import Pose

PROGRAM = """\
#include <Nclient.h>

int main(void)
{
    int i;
    connect_robot(1);
    for (i = 0; i < 20; i++) {
        gs();
        vm(100 + i, 20 * i, 0);
        ws(1, 1, 1, 1);
        if (i == 10)
            sleep(2);
    }
    return 0;
}
"""
WORLD = """<world version="1" timestep="50ms">
  <area length="30m" width="20m"/>
  <box x="3m" y="5m" length="0.3m" width="0.3m" mass="3kg"/>
  <robot x="8m" y="10m"/><robot x="18m" y="10m"/>
</world>
"""


class Passages:
    """Tells a recorder of timesteps some at a time, but of every seventh alone.

    So it does of those in which something else happens, as a session does.
    """

    def __init__(self, recorder: Recorder) -> None:
        self.recorder = recorder
        self.passages = 0
        self._last = 0
        self._waiting: list[tuple[FloatArray, list[Served]]] = []

    def run(self, session: Session) -> None:
        """Run a session to its end."""
        self._session, self._last = session, session.timesteps
        while session.advance(1):
            is_quiet = self._last != session.timesteps
            if is_quiet or session.timesteps % 20 == 0:
                self.tell()
                self.recorder.sample()
        self.tell()

    def step(self, step: Step) -> None:
        timesteps = self._session.timesteps
        alone = timesteps % 7 == 0 or any(each.states is None for each in step.served)
        if alone or timesteps != self._last + 1:
            self.tell()
        self._last = timesteps
        if alone:
            self.recorder.step(step)
            return
        state = self._session.environment.last_state
        pose = np.zeros((2, FRAME))
        pose[:, :2] = state.bodies.position_m[:2]
        pose[:, 2] = state.heading_rad
        odometry = state.odometry
        pose[:, 4], pose[:, 5], pose[:, 6] = odometry.x_m, odometry.y_m, odometry.heading_rad
        self._waiting.append((pose, [each for each in step.served if each.states is not None]))

    def tell(self) -> None:
        """Tell of what is waiting."""
        if self._waiting:
            frames, served = zip(*self._waiting, strict=True)
            moved = np.array(frames).tobytes()
            logged = b"".join(answers(each).tobytes() for each in served[1:])
            first, step_s = self._last - len(frames), self._session.environment.timestep_s
            # What was answered in the first timestep, as if by other means.
            self.recorder.passed(Passage(first, len(frames), step_s, moved, logged, served[0]))
            self.passages += 1
        self._waiting = []


def answers(served: Sequence[Served]) -> Records:
    """Return answers as the kernel of calm time logs them, as far as they are recorded."""
    found = [np.zeros(0, ANSWER)]
    for each in served:
        rows = np.zeros(len(each.robots), ANSWER)
        rows["code"], rows["robot"] = each.code, each.robots
        rows["clock_s"], rows["state"] = each.clock_s, each.states
        found.append(rows)
    return np.concatenate(found)


def test_a_robot_that_is_added_while_nothing_moves_is_recorded(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The saved data has no frames then; the new roster replaces it, and does not follow it."""
    monkeypatch.setattr("crs_cc.recording.recording_file.BLOCK_S", 3.0)
    (tmp_path / "wait.c").write_text("#include <unistd.h>\nint main(void) { sleep(9); return 0; }")
    (tmp_path / "room.xml").write_text(WORLD)
    world = load_world(tmp_path / "room.xml")
    executable = build_executable([tmp_path / "wait.c"], Diagnostics())
    path = tmp_path / "run.mcap"
    recorder = Recorder(path, RecorderOptions(), RunDescription().metadata(), {})
    session = Session(world, [executable] * 2, output=recorder.write, observer=recorder)
    recorder.begin(session)
    while session.advance(20):
        recorder.sample()
        if session.timesteps > 90 and len(session.fleet) == 2:
            late = dataclasses.replace(world.robots[0], id="late", start=Pose(2.0, 2.0))
            session.add_robot(late, executable)
    recorder.finish(session.result())
    with path.open("rb") as file:
        summary = make_reader(file).get_summary()
        assert summary is not None
        for index in summary.metadata_indexes:
            file.seek(index.offset)
            assert index.name.encode() in file.read(index.length)
    recording = Recording(path)
    assert [len(each.robots) for each in recording.rosters] == [2, 3]
    assert len({each.timesteps for each in recording.hashes()}) > 9
    recording.close()


@pytest.mark.parametrize("every_s", [0.05, 0.15])
def test_passages_are_recorded_like_single_timesteps(every_s: float, tmp_path: Path) -> None:
    (tmp_path / "drive.c").write_text(PROGRAM)
    (tmp_path / "room.xml").write_text(WORLD)
    world = load_world(tmp_path / "room.xml")
    executable = build_executable([tmp_path / "drive.c"], Diagnostics())
    made = []
    for name, are_told in (("single.mcap", False), ("passages.mcap", True)):
        options = RecorderOptions(every_s=every_s)
        recorder = Recorder(tmp_path / name, options, RunDescription().metadata(), {})
        passages = Passages(recorder)
        observer = passages if are_told else recorder
        session = Session(world, [executable] * 2, output=recorder.write, observer=observer)
        recorder.begin(session)
        if are_told:
            passages.run(session)
        else:
            while session.advance(round(recorder.seconds_left() / world.timestep_s)):
                recorder.sample()
        recorder.finish(session.result())
        made.append((tmp_path / name).read_bytes())
    assert passages.passages > 10
    assert made[0] == made[1]
    recording = Recording(tmp_path / "passages.mcap")
    assert len(list(recording.frames())) > 20
    assert sum(len(each.robots) for each in recording.readings()) > 80
    recording.close()


@pytest.mark.parametrize("robots", [1, 2])
def test_the_order_of_readings_does_not_depend_on_how_often_they_were_saved(
    robots: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "drive.c").write_text(PROGRAM)
    (tmp_path / "room.xml").write_text(WORLD)
    world = load_world(tmp_path / "room.xml")
    world = dataclasses.replace(world, robots=world.robots[:robots])
    executable = build_executable([tmp_path / "drive.c"], Diagnostics())
    made = []
    for name in ("often", "once"):
        if name == "once":
            nothing = Second(Shape(robots, 0, has_turret=False), 0, [b""] * COLUMNS, [], [], [])
            monkeypatch.setattr(Block, "take_unsaved", lambda _block, nothing=nothing: nothing)
        path = tmp_path / f"{name}.mcap"
        recorder = Recorder(path, RecorderOptions(), RunDescription().metadata(), {})
        programs = [executable] * robots
        session = Session(world, programs, output=recorder.write, observer=recorder)
        recorder.begin(session)
        while session.advance(round(recorder.seconds_left() / world.timestep_s), calmly=True):
            recorder.sample()
        recorder.finish(session.result())
        made.append(path.read_bytes())
    assert made[0] == made[1]
    recording = Recording(tmp_path / "often.mcap")
    for robot in range(robots):
        times_s = [each.clock_s[each.robots == robot] for each in recording.readings()]
        assert (np.diff(np.concatenate(times_s)) > 0.0).all()
    recording.close()
