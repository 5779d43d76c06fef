"""Odometry, and the odometry in readings, as the difference from the prediction by frames."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import TYPE_CHECKING, cast

import numpy as np
import pytest

from crs_cc.core.source import Diagnostics
from crs_cc.recording import frames, odometry, reading_buffer, topics
from crs_cc.recording.block import Block
from crs_cc.recording.description import RunDescription
from crs_cc.recording.frame_buffer import Shape
from crs_cc.recording.frame_reader import FrameReader
from crs_cc.recording.frames import quantized
from crs_cc.recording.mcap_reader import McapReader
from crs_cc.recording.mcap_records import Message
from crs_cc.recording.mcap_writer import MAX_CHUNK, McapWriter
from crs_cc.recording.odometry import OdometryDecoder
from crs_cc.recording.odometry_prediction import OdometryPrediction
from crs_cc.recording.readings import (
    ODOMETRY_ELEMENTS,
    STATE,
    ReadingDecoder,
    ReadingEncoder,
    Readings,
)
from crs_cc.recording.recorder import Recorder, RecorderOptions
from crs_cc.recording.recording import Recording
from crs_cc.session.build import build_executable
from crs_cc.session.session import Session
from crs_cc.sim.engine.step import Step
from crs_cc.sim.files.world_xml import load_world
from crs_cc.sim.kernels import calm

if TYPE_CHECKING:
    from crs_cc.sim.state.env_state import EnvState

ENCODER = ReadingEncoder()

PROGRAM = """\
#include <Nclient.h>
int main(void)
{
    int i;
    connect_robot(1);
    conf_tm(0);
    for (i = 0; i < 40; i++) {
        vm(150 - i, 300 - 10 * i, 0);
        gs();
        ws(1, 1, 1, 1);
        if (i == 20) {
            dp(500, 100);
            da(900, 900);
        }
    }
    return 0;
}
"""
WORLD = """<world version="1" timestep="50ms" seed="3">
  <area length="30m" width="20m"/>
  <box x="3m" y="5m" length="0.3m" width="0.3m" mass="3kg"/>
  <robot x="8m" y="10m" heading="40deg" setup="noisy"/><robot x="18m" y="10m"/>
</world>
"""


def walk(robots: int, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Return where robots are and believe to be: wheels slip, a robot is absent, one is moved."""
    random = np.random.default_rng(8)
    speed, turn = random.normal(0.02, 0.01, (count, robots)), random.normal(0.1, 0.2, robots)
    heading = np.cumsum(np.tile(turn, (count, 1)), axis=0) + random.uniform(-3, 3, robots)
    true = np.zeros((count, 4, robots + 1))  # and an object
    true[:, 0, :robots] = 5.0 + np.cumsum(speed * np.cos(heading), axis=0)
    true[:, 1, :robots] = np.cumsum(speed * np.sin(heading), axis=0)
    true[:, 2, :robots] = (heading + np.pi) % (2 * np.pi) - np.pi
    estimates = true[:, :3, :robots] + random.normal(0.0, 0.002, (count, 3, robots))
    estimates[count // 2 :, :, 1] = [7.0, -8.0, 3.0]
    true[5 : count // 3, :, 0] = np.nan
    return true, estimates


@pytest.mark.parametrize("largest", [frames.MAX_GROUP, 0])
def test_odometry_is_exact_to_a_tenth_of_a_millimetre(
    largest: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(frames, "MAX_GROUP", largest)
    true, estimates = walk(3, 40)
    times_ns = [50_000_000 * number for number in range(40)]
    made = odometry.messages(times_ns, estimates, true)
    assert len(made) == (1 if largest else 40)
    decoder = OdometryDecoder()
    for time_ns, values in zip(times_ns, true, strict=True):
        decoder.note(time_ns, values)
    found = [each for time_ns, data in made for each in decoder.frames(time_ns, data)]
    assert [time_ns for time_ns, _ in found] == times_ns
    np.testing.assert_allclose([values for _, values in found], estimates, atol=0.5001e-4)


def test_odometry_that_follows_the_motion_takes_nearly_no_space() -> None:
    true, _ = walk(3, 40)
    true[5:13, :, 0] = true[4, :, 0]
    turn = np.array([1.0, -2.0, 0.0])
    cos, sin = np.cos(turn), np.sin(turn)
    x, y = true[:, 0, :3], true[:, 1, :3]
    heading = np.unwrap(true[:, 2, :3], axis=0) + turn
    estimates = np.stack([x * cos - y * sin, x * sin + y * cos, heading], axis=1)
    ((_, data),) = odometry.messages(range(40), estimates, true)
    _, steps = frames.group_in(data)
    off = steps[1:].view(np.int32)
    assert np.abs(off[:, :2]).max() <= 2  # rounding
    assert np.abs(off[:, 2]).max() <= 1  # a full turn is no whole number


def test_odometry_without_the_frames_that_it_depends_on_is_rejected() -> None:
    true, estimates = walk(2, 3)
    ((time_ns, data),) = odometry.messages([1, 2, 3], estimates, true)
    decoder = OdometryDecoder()
    decoder.note(1, true[0])
    with pytest.raises(ValueError, match="is missing"):
        list(decoder.frames(time_ns, data))


def prediction() -> OdometryPrediction:
    true, estimates = walk(3, 40)
    times_ns, known = np.arange(40) * 50_000_000, slice(2, None, 5)
    return OdometryPrediction(
        times_ns, quantized(true), times_ns[known], quantized(estimates[known])
    )


def test_readings_are_exact_for_any_frames() -> None:
    random, expected = np.random.default_rng(9), prediction()
    states = random.integers(-(2**31), 2**31, (300, STATE)).astype(np.int32)
    robots = random.integers(0, 5, 300)  # of which the frames have three
    clock_s = np.sort(random.uniform(0.0, 4.0, 300))
    meant = Readings(np.ones(300, np.int64), robots, clock_s, states)
    data = ReadingEncoder().encode(meant, 0, expected)
    found = ReadingDecoder().decode(data, 0, {0: expected}.__getitem__)
    assert found is not None
    np.testing.assert_array_equal(found.states, states)
    with pytest.raises(ValueError, match="frames of readings are missing"):
        ReadingDecoder().decode(data, 0)


def test_predicted_odometry_in_readings_takes_one_bit() -> None:
    expected, rows = prediction(), 800
    robots, times_us = np.zeros(rows, np.intp) + 2, np.arange(rows) * 2000
    states = np.zeros((rows, STATE), np.int32)
    states[:, ODOMETRY_ELEMENTS] = expected.at(robots, times_us).T
    meant = Readings(np.ones(rows, np.int64), robots, times_us / 1e6, states)
    alone, told = (ReadingEncoder().encode(meant, 0, each) for each in (None, expected))
    assert len(alone) - len(told) > 2 * rows


def test_a_frame_replaces_an_earlier_one_at_the_same_time() -> None:
    """A robot that is moved by hand between two timesteps has two frames at the same time."""
    true, estimates = walk(2, 12)
    true[:, :, 0] = true[0, :, 0]
    block = Block(0.0, Shape(2, 0, has_turret=False))
    poses = np.concatenate([true[:, :, :2].swapaxes(1, 2), estimates.swapaxes(1, 2)], axis=2)
    state = SimpleNamespace(presence=SimpleNamespace(present=np.ones(2, np.bool_)))
    for first, step, rows in ((0, 1, poses[:6]), (5, 1, poses[6:])):  # 5 is there twice
        when = first, step, len(rows)
        block.frames.add_passage(when, 0.05, rows.tobytes(), cast("EnvState", state))
    reader = FrameReader(topics.ODOMETRY.topic)
    made = [Message(channel.topic, at, data) for channel, at, data in block.messages(ENCODER)]
    found = [values for message in made for _, values in reader.frames(message)]
    np.testing.assert_allclose(found, estimates[[0, 5, 10]], atol=0.5001e-4)


def test_messages_that_depend_on_each_other_are_in_one_chunk(tmp_path: Path) -> None:
    path = tmp_path / "run.mcap"
    with path.open("wb") as file:
        writer = McapWriter(file)
        for is_whole in (True, False):
            for number in range(3):
                writer.add(topics.STATE, number, bytes(MAX_CHUNK + 1))
            writer.cut(is_whole=is_whole)
        writer.finish()
    reader = McapReader(path)
    assert [chunk.size > 3 * MAX_CHUNK for chunk in reader.chunks] == [True, False, False, False]
    reader.close()


def test_answers_of_the_kernel_begin_with_the_stored_fields() -> None:
    for name in reading_buffer.ANSWER.names or ():
        assert calm.ANSWER.fields is not None
        assert reading_buffer.ANSWER.fields is not None
        assert calm.ANSWER.fields[name] == reading_buffer.ANSWER.fields[name]


def test_a_recording_matches_the_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Odometry and readings of a run with slip, and a program that moves the frame of odometry."""
    monkeypatch.setattr("crs_cc.recording.recording_file.BLOCK_S", 7.0)
    (tmp_path / "drive.c").write_text(PROGRAM)
    (tmp_path / "room.xml").write_text(WORLD)
    world = load_world(tmp_path / "room.xml")
    executable = build_executable([tmp_path / "drive.c"], Diagnostics())
    path = tmp_path / "run.mcap"
    recorder = Recorder(path, RecorderOptions(), RunDescription().metadata(), {})
    seen: dict[int, np.ndarray] = {}
    states: list[list[np.ndarray]] = [[], []]

    class Observer:
        def step(self, step: Step) -> None:
            odometry = session.environment.last_state.odometry
            seen[session.timesteps * 50_000_000] = np.array(
                [odometry.x_m, odometry.y_m, odometry.heading_rad]
            )
            for each in step.served:
                if each.states is not None:
                    for robot, state in zip(each.robots.tolist(), each.states, strict=True):
                        states[robot].append(state)
            recorder.step(step)

    session = Session(world, [executable] * 2, output=recorder.write, observer=Observer())
    recorder.begin(session)
    while session.advance(1):
        recorder.sample()
    recorder.finish(session.result())
    recording = Recording(path)
    assert len(recording.mcap.chunks) > 2
    estimates = list(recording.frames(topic=topics.ODOMETRY.topic))
    assert len(estimates) > 50
    for frame in estimates[1:]:
        np.testing.assert_allclose(frame.values, seen[frame.time_ns], atol=0.5001e-4)
    later = list(recording.frames(9_900_000_000, topic=topics.ODOMETRY.topic))
    np.testing.assert_array_equal(later[-1].values, estimates[-1].values)
    read = list(recording.readings())
    for robot in range(2):
        found = np.concatenate([each.states[each.robots == robot] for each in read])
        np.testing.assert_array_equal(found, states[robot])
    recording.close()
