"""Measures what recording a run costs: time, and bytes for a robot and frame.

One robot runs samples/scout_c/wander.c in worlds/cluttered.xml; fleets run the program of
bench/environment.py on a jittered grid, at 20 Hz. Each run is made without and with a recorder, in
turns, and the fastest of each counts. The same frames are then written as JSON lines and as Parquet
(if pyarrow is installed), and timed alone, as is the encoding of frames here.

    python bench/record.py [--seconds S] [--repeat N] [ROBOTS ...]
"""

from __future__ import annotations

import argparse
import json
import tempfile
import time
from pathlib import Path

import numpy as np
from environment import PROGRAM, SETUPS, world_text

from crs_cc.core.source import Diagnostics
from crs_cc.recording.description import RunDescription
from crs_cc.recording.frames import messages
from crs_cc.recording.mcap_records import NS
from crs_cc.recording.mcap_writer import McapWriter
from crs_cc.recording.recorder import Recorder, RecorderOptions
from crs_cc.recording.recording import Recording
from crs_cc.recording.topics import FRAME
from crs_cc.runtime.executable import Executable
from crs_cc.session.build import build_executable
from crs_cc.session.session import Session
from crs_cc.sim.files.world_xml import load_world
from crs_cc.sim.model.world import WorldModel

ROOT = Path(__file__).parents[1]
TIMESTEP = "50ms"
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


def run_s(
    world: WorldModel, program: Executable, seconds: float, recorder: Recorder | None
) -> float:
    """Return the processor time of a run [s], its start left out."""
    write = recorder.write if recorder else (lambda _robot, _stream, _content: None)
    session = Session(
        world, [program] * len(world.robots), output=write, observer=recorder, threads=1
    )
    start = time.process_time()
    if recorder:
        recorder.begin(session)
    while session.time_s < seconds - 1e-9:
        session.step()
        if recorder:
            recorder.sample()
    used_s = time.process_time() - start
    if recorder:
        recorder.finish(session.result())
    return used_s


def measure(robots: int, seconds: float, repeat: int, folder: Path) -> None:
    """Print what recording a run costs."""
    world, program = made(robots, folder)
    steps = round(seconds / world.timestep_s)
    plain_s = {name: float("inf") for name in ("off", "none", "read")}
    sizes = {}
    for _ in range(repeat):
        for name in ("off", "none", "read"):
            path = folder / f"{name}.mcap"
            recorder = None
            if name != "off":
                options = RecorderOptions(sensors=name)
                recorder = Recorder(path, options, RunDescription().metadata(), {})
            plain_s[name] = min(plain_s[name], run_s(world, program, seconds, recorder))
            if recorder:
                sizes[name] = path.stat().st_size
    for name in ("none", "read"):
        more = plain_s[name] / plain_s["off"] - 1.0
        each = sizes[name] / robots / steps
        print(f"{robots:7,}  sensors {name:5} {100 * more:+7.1f} % {each:9.2f} bytes/robot/frame")
    write_alone(folder / "none.mcap", robots, folder)


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
    parser.add_argument("--repeat", type=int, default=3, help="runs of each kind (default 3)")
    options = parser.parse_args()
    for robots in options.robots:
        seconds = options.seconds if robots <= FEW else min(options.seconds, 3.0)
        with tempfile.TemporaryDirectory() as folder:
            measure(robots, seconds, options.repeat, Path(folder))
    print("Processor time, one core. Ratios can be compared; times are of this machine.")


if __name__ == "__main__":
    main()
