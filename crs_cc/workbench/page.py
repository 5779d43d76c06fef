"""A recorded run as one HTML page that opens from disk, without a network.

The page holds the modules of the viewer as `data:` URLs in an import map, and the run as JSON. Its
frames stay packed, a block for each second, and are unpacked as they are looked at. What would make
the page too large for a browser is thinned, and the page says so.
"""

from __future__ import annotations

import json
import math
from base64 import b64encode
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from crs_cc.recording import topics
from crs_cc.recording.content import content_of
from crs_cc.recording.mcap_records import NS
from crs_cc.recording.shapes import robot_data
from crs_cc.workbench.frame_blocks import packed
from crs_cc.workbench.static_files import FOLDER, MODULES, html
from crs_cc.workbench.world_data import world_data

if TYPE_CHECKING:
    from crs_cc.core.arrays import FloatArray
    from crs_cc.recording.recording import Frame, Recording
    from crs_cc.sim.model.world import WorldModel

MAX_BYTES: Final = 50 * 2**20
"""Of a page: Firefox and Chromium open it; of pages with 1 GB, users say that they do not."""

MAX_EVENTS: Final = 20_000
MAX_OUTPUT: Final = 4 * 2**20
MAX_PATHS: Final = 50
MAX_POINTS: Final = 1000

_POLICY: Final = (
    "default-src 'none'; script-src 'unsafe-inline' data:; style-src 'unsafe-inline'; img-src blob:"
)
_SHARE: Final = 0.9 * 0.75  # for frames, before base 64


@dataclass(slots=True)
class _Paths:
    """The paths of the first robots, thinned evenly."""

    points: list[FloatArray] = field(default_factory=list)
    stride: int = 1
    count: int = 0

    def add(self, places: FloatArray) -> None:
        """Add positions, (2, robots)."""
        if self.count % self.stride == 0:
            self.points.append(places[:, :MAX_PATHS])
            if len(self.points) > MAX_POINTS:
                del self.points[1::2]
                self.stride *= 2
        self.count += 1

    def of(self, robot: int) -> list[list[float]]:
        """Return the path of a robot."""
        found = [each[:, robot] for each in self.points if robot < each.shape[1]]
        return [[round(float(x), 3), round(float(y), 3)] for x, y in found if not math.isnan(x)]


def html_page(recording: Recording, world: WorldModel, most_bytes: int = MAX_BYTES) -> str:
    """Return the page of a recorded run.

    Raises:
        RecordingError: the recording is damaged.
    """
    blocks, stride = _blocks(recording, int(most_bytes * _SHARE))
    if not blocks:
        raise recording.mcap.error("no frames: there is nothing to show")
    events, lost_events = _events(recording)
    output, lost_output = _output(recording)
    left_out = [f"every frame but each {stride}th"] if stride > 1 else []
    left_out += [f"{lost_events} events"] if lost_events else []
    left_out += [f"{lost_output} pieces of output"] if lost_output else []
    run = recording.description
    names = ", ".join(Path(source).name for source in run.sources) or "programs"
    where = Path(run.world).name or "an empty world"
    note = f"seed {run.seed}, recorded with crs {recording.versions.get('crs', '?')[:20]}"
    note += f"; left out: {', '.join(left_out)}" if left_out else ""
    data = {
        "programs": names,
        "world_name": where,
        "note": note,
        "end_s": recording.end_ns / NS,
        "frame_s": run.frame_s * stride,
        "rosters": [
            {"t": each.time_ns / NS, "robots": each.robots, "objects": each.objects}
            for each in recording.rosters
        ],
        "world": world_data(world, recording.rosters[-1].robots),
        "paths": _paths(recording, world),
        "events": events,
        "output": output,
        "blocks": blocks,
    }
    text = json.dumps(data, separators=(",", ":"), allow_nan=False).replace("<", "\\u003c")
    style = (FOLDER / "style.css").read_text("utf-8")
    head = (
        f'<meta http-equiv="Content-Security-Policy" content="{_POLICY}">\n<style>\n{style}</style>'
    )
    start = '<script type="module">import "crs/app.js";</script>'
    return html(head=head, start=start, imports=_import_map(), run=text)


def _import_map() -> str:
    """Return the viewer's modules as an import map of `data:` URLs."""
    files = {f"crs/{name}": (FOLDER / name).read_bytes() for name in MODULES}
    three = (FOLDER / "three" / "three.module.js").read_bytes()
    files["three"] = three.replace(b"'./three.core.js'", b"'three/core'")
    files["three/core"] = (FOLDER / "three" / "three.core.js").read_bytes()
    urls = {
        name: f"data:text/javascript;base64,{b64encode(content).decode('ascii')}"
        for name, content in files.items()
    }
    return json.dumps({"imports": urls})


def _blocks(recording: Recording, most_bytes: int) -> tuple[list[list[Any]], int]:
    """Return the frames in blocks of about a second, and which share of them: each how manyth."""
    stride = 1
    while True:
        blocks: list[list[Any]] = []
        size = 0
        for frames in _seconds(recording, stride):
            block = packed(
                [each.time_s for each in frames], np.array([each.values for each in frames])
            )
            size += len(block)
            if size > most_bytes:
                break
            span = [frames[0].time_s, frames[-1].time_s]
            blocks.append([*span, b64encode(block).decode("ascii")])
        if size <= most_bytes or stride > 2**20:
            return blocks, stride
        stride *= 2


def _seconds(recording: Recording, stride: int) -> Iterator[list[Frame]]:
    """Yield the frames by second and roster, each `stride`th of them."""
    frames: list[Frame] = []
    for number, frame in enumerate(recording.frames()):
        if number % stride:
            continue
        first = frames[0] if frames else frame
        is_other = frame.values.shape != first.values.shape
        if is_other or frame.time_ns // NS != first.time_ns // NS or len(frames) >= 20:
            yield frames
            frames = []
        frames.append(frame)
    if frames:
        yield frames


def _paths(recording: Recording, world: WorldModel) -> list[dict[str, Any]]:
    """Return the true paths of the first robots, and those that odometry believed."""
    true, believed = _Paths(), _Paths()
    for frame in recording.frames():
        robots = len(recording.roster_at(frame.time_ns).robots)
        true.add(frame.values[:2, :robots])
    starts = {robot.id: robot.start for robot in world.robots}
    names = recording.rosters[-1].robots[:MAX_PATHS]
    begin = [starts.get(name) for name in names]
    turn = np.array([0.0 if start is None else start.heading_rad for start in begin])
    base = np.array([[0.0, 0.0] if s is None else [s.x_m, s.y_m] for s in begin]).T
    for frame in recording.frames(topic=topics.ODOMETRY.topic):
        own = frame.values[:2, : len(names)]
        count = own.shape[1]
        cos, sin = np.cos(turn[:count]), np.sin(turn[:count])
        along = np.array([own[0] * cos - own[1] * sin, own[0] * sin + own[1] * cos])
        believed.add(base[:, :count] + along)
    colours = [each["colour"] for each in robot_data(world, names)]
    paths = []
    for row, name in enumerate(names):
        paths.append({"points": true.of(row), "colour": colours[row], "believed": False})
        if starts.get(name) is not None:
            paths.append({"points": believed.of(row), "colour": colours[row], "believed": True})
    return paths


def _events(recording: Recording) -> tuple[list[list[Any]], int]:
    """Return the first events, and how many are left out."""
    found: list[list[Any]] = []
    lost = 0
    for time_ns, data in recording.data(topics.EVENT.topic):
        if data.get("kind") == "drawing":
            continue
        if len(found) >= MAX_EVENTS:
            lost += 1
            continue
        place = [data.get("x_m"), data.get("y_m")]
        numbers = [each if isinstance(each, float | int) else None for each in place]
        with recording.errors():
            kind, text = str(data.get("kind"))[:40], str(data.get("text"))[:400]
            found.append([time_ns / NS, kind, int(data.get("robot", -1)), text, *numbers])
    return found, lost


def _output(recording: Recording) -> tuple[list[list[Any]], int]:
    """Return the first pieces of output, and how many are left out."""
    found: list[list[Any]] = []
    lost = size = 0
    for time_ns, data in recording.data(topics.OUTPUT.topic):
        with recording.errors():
            text = content_of(data).decode("utf-8", "replace")
            robot, stream = int(data.get("robot", -1)), int(data.get("stream", 1))
        size += len(text) + 32
        if size > MAX_OUTPUT:
            lost += 1
            continue
        robots = recording.roster_at(time_ns).robots
        name = robots[robot] if 0 <= robot < len(robots) else ""
        found.append([time_ns / NS, name, stream, text])
    return found, lost
