"""Measures what recording a run costs: time, and bytes for a robot and frame.

One robot runs samples/scout_c/wander.c in worlds/cluttered.xml; fleets run the program of
bench/environment.py on a jittered grid, at 20 Hz. Runs without and with a recorder go side by side,
a second of each in turns (those of more than 100 robots one after the other), from before the first
timestep to the results and the end of the file. The fastest of each second are compared, the
medians, and the means; seconds that are saved hardly count in the first two. Of the bytes of a
recording, those of where the robots are and of where they believe to be are also counted alone. The
same frames are then written as JSON lines and as Parquet (if pyarrow is installed), and timed
alone, as is the encoding of frames here.

    python bench/record.py [--seconds S] [--repeat N] [ROBOTS ...]
"""

from __future__ import annotations

import argparse
import gc
import itertools
import json
import math
import os
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
import zstandard
from environment import PROGRAM, SETUPS, world_text

from crs_cc.core.source import Diagnostics
from crs_cc.recording.description import RunDescription
from crs_cc.recording.frames import messages
from crs_cc.recording.mcap_records import NS
from crs_cc.recording.mcap_writer import LEVEL, SMALL_LEVEL, McapWriter
from crs_cc.recording.recorder import Recorder, RecorderOptions
from crs_cc.recording.recording import Recording
from crs_cc.recording.topics import FRAME, ODOMETRY
from crs_cc.runtime.executable import Executable
from crs_cc.session.build import build_executable
from crs_cc.session.session import Session
from crs_cc.sim.files.world_xml import load_world
from crs_cc.sim.model.world import WorldModel

ROOT = Path(__file__).parents[1]
TIMESTEP = "50ms"
KINDS = ["off", "none", "read"]  # what is recorded of sensors
FEW = 100  # robots of which several runs fit into a second


def made(robots: int, folder: Path) -> tuple[WorldModel, Executable]:
    """Return a world of some robots, and their program."""
    if robots == 1:
        program = build_executable([ROOT / "samples" / "scout_c" / "wander.c"], Diagnostics())
        return load_world(ROOT / "worlds" / "cluttered.xml"), program
    attributes, defines = SETUPS["scout"]
    text = world_text(robots, attributes).replace('timestep="100ms"', f'timestep="{TIMESTEP}"')
    (folder / "world.xml").write_text(text)
    (folder / "wander.c").write_text(PROGRAM)
    program = build_executable([folder / "wander.c"], Diagnostics(), defines=defines)
    return load_world(folder / "world.xml"), program


class Run:
    """A run that is recorded or not.

    Attributes:
        used_s: the processor time of each of its parts [s]: its begin, its seconds, its end.
    """

    def __init__(self, world: WorldModel, program: Executable, recorder: Recorder | None) -> None:
        write = recorder.write if recorder else (lambda _robot, _stream, _content: None)
        programs = [program] * len(world.robots)
        self.used_s: list[float] = []
        self._session = Session(world, programs, output=write, observer=recorder, threads=1)
        self._recorder = recorder

    def begin(self) -> None:
        start = time.process_time()
        if self._recorder:
            self._recorder.begin(self._session)
        self.used_s.append(time.process_time() - start)

    def advance(self, until_s: float) -> None:
        """Advance the run to a time."""
        start = time.process_time()
        timestep_s = self._session.environment.timestep_s
        while (left_s := until_s - self._session.time_s) > 1e-9:
            if self._recorder:
                left_s = min(left_s, self._recorder.seconds_left())
            self._session.advance(max(1, round(left_s / timestep_s)), calmly=True)
            if self._recorder:
                self._recorder.sample()
        self.used_s.append(time.process_time() - start)

    def finish(self) -> None:
        start = time.process_time()
        result = self._session.result()
        if self._recorder:
            self._recorder.finish(result)
        self.used_s.append(time.process_time() - start)


def parts_s(
    world: WorldModel, program: Executable, kinds: list[str], seconds: float, folder: Path
) -> np.ndarray:
    """Return the processor time of the parts of runs side by side [s], (kinds, parts)."""
    gc.collect()  # programs of runs before
    runs = []
    for name in kinds:
        recorder = None
        if name != "off":
            options = RecorderOptions(sensors=name)
            path = folder / f"{name}.mcap"
            recorder = Recorder(path, options, RunDescription().metadata(), {})
        runs.append(Run(world, program, recorder))
    orders = list(itertools.permutations(range(len(runs))))
    for run in runs:
        run.begin()
    for second in range(1, math.ceil(seconds) + 1):
        for number in orders[second % len(orders)]:
            runs[number].advance(min(second, seconds))
    for run in runs:
        run.finish()
    return np.array([run.used_s for run in runs])


def measure(robots: int, seconds: float, repeat: int, folder: Path) -> None:
    """Print what recording a run costs."""
    world, program = made(robots, folder)
    steps = round(seconds / world.timestep_s)
    # There is no address space for all programs of many robots, three times.
    turns = [KINDS] if robots <= FEW else [[name] for name in KINDS]
    used_s = np.array(
        [
            np.concatenate([parts_s(world, program, kinds, seconds, folder) for kinds in turns])
            for _ in range(repeat)
        ]
    )
    for number, name in enumerate(KINDS[1:], 1):
        more = [
            100.0 * (kinds_s[number] / kinds_s[0] - 1.0)
            for of in (np.min, np.median, np.mean)
            for kinds_s in [of(used_s, axis=0).sum(axis=1)]
        ]
        whole = (folder / f"{name}.mcap").stat().st_size / robots / steps
        print(f"{robots:7,}  sensors {name:5} fastest {more[0]:+5.1f}%, median {more[1]:+5.1f}%,"
              f" mean {more[2]:+5.1f} %{whole:9.2f} bytes/robot/frame")  # fmt: skip
    true, believed = (
        frame_bytes(folder / "none.mcap", topic) / robots / steps
        for topic in (FRAME.topic, ODOMETRY.topic)
    )
    print(f"{'':9}of these, frames alone: {true:.2f} where they are, {believed:.2f} where they"
          f" believe to be, {true + believed:.2f} in all")  # fmt: skip
    write_alone(folder / "none.mcap", robots, folder)


def frame_bytes(path: Path, topic: str) -> int:
    """Return how many bytes the messages of a topic take when they are compressed alone."""
    recording, size = Recording(path), 0
    for chunk in recording.mcap.chunks:
        found = [each.data for each in recording.mcap.messages(chunk) if each.topic == topic]
        level = SMALL_LEVEL if len(recording.rosters[0].robots) < FEW else LEVEL
        size += len(zstandard.compress(b"".join(found), level)) if found else 0
    recording.close()
    return size


def write_alone(path: Path, robots: int, folder: Path) -> None:
    """Print what the frames of a recording cost in several formats."""
    recording = Recording(path)
    frames = list(recording.frames())
    names = recording.rosters[-1].robots
    recording.close()
    writers = {"MCAP, as here": as_mcap, "JSON lines": as_json, "Parquet": as_parquet}
    for name, write in writers.items():
        target = folder / "alone"
        start = time.process_time()
        try:
            write(target, frames, names)
        except ImportError:
            print(f"{'':9}{name:16} (not installed)")
            continue
        each_ms = (time.process_time() - start) / len(frames) * 1e3
        size = target.stat().st_size / robots / len(frames)
        print(f"{'':9}{name:16}{each_ms:9.3f} ms/frame {size:9.2f} bytes/robot/frame")


def as_mcap(path: Path, frames: list, names: tuple[str, ...]) -> None:
    del names
    with path.open("wb") as file:
        writer = McapWriter(file)
        per_chunk = 600 if frames[0].values.shape[1] < FEW else 20
        for begin in range(0, len(frames), per_chunk):
            block = frames[begin : begin + per_chunk]
            values = np.array([frame.values for frame in block])
            for time_ns, data in messages([frame.time_ns for frame in block], values):
                writer.add(FRAME, time_ns, data)
            writer.cut()
        writer.finish()


def as_json(path: Path, frames: list, names: tuple[str, ...]) -> None:
    with path.open("w") as file:
        for frame in frames:
            rows = frame.values.T.round(4).tolist()
            poses = dict(zip(names, rows, strict=False))
            file.write(json.dumps({"t": frame.time_ns / NS, "poses": poses}) + "\n")


def as_parquet(path: Path, frames: list, names: tuple[str, ...]) -> None:
    import pyarrow as pa
    import pyarrow.parquet as pq

    del names
    schema = pa.schema([("t", pa.float64()), ("robot", pa.int32()),
                        *((name, pa.float32()) for name in ("x", "y", "heading"))])  # fmt: skip
    with pq.ParquetWriter(path, schema, compression="zstd") as writer:
        for begin in range(0, len(frames), 20):
            block = frames[begin : begin + 20]
            rows = block[0].values.shape[1]
            columns = np.concatenate([frame.values[:3] for frame in block], axis=1)
            arrays = [
                np.repeat([frame.time_s for frame in block], rows),
                np.tile(np.arange(rows, dtype=np.int32), len(block)),
                *columns.astype(np.float32),
            ]
            writer.write_table(pa.table(arrays, schema=schema))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", 1)[0])
    parser.add_argument("robots", nargs="*", type=int, default=[1, 100, 10_000])
    parser.add_argument("--seconds", type=float, default=20.0, help="simulated time (default 20)")
    parser.add_argument("--repeat", type=int, default=5, help="runs of each kind (default 5)")
    options = parser.parse_args()
    gc.set_threshold(100_000)  # as `crs` does
    for robots in options.robots:
        seconds = options.seconds if robots <= FEW else min(options.seconds, 3.0)
        with tempfile.TemporaryDirectory() as folder:
            measure(robots, seconds, options.repeat, Path(folder))
    print("Processor time, one core. Ratios can be compared; times are of this machine.")


if __name__ == "__main__":
    try:
        main()
        sys.stdout.flush()
    except BrokenPipeError:  # what reads the table wants no more
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
