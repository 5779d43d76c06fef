"""A recorded run as one HTML page that opens from disk, without a network.

The page holds the modules of the viewer as `data:` URLs in an import map, and the run as JSON. Its
frames stay packed, in a block for each second, and are unpacked when they are viewed. Data that
would make the page too large for a browser is thinned, and the page states so.
"""

from __future__ import annotations

import json
import math
from base64 import b64encode
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from crs_cc.recording import topics
from crs_cc.recording.mcap_records import NS
from crs_cc.recording.shapes import robot_data
from crs_cc.workbench.messages import plain_text
from crs_cc.workbench.page_comparison import OtherRecording, compared_run
from crs_cc.workbench.recorded_content import (
    events_in,
    fields_in,
    frame_blocks,
    marks_in,
    output_in,
)
from crs_cc.workbench.static_files import FOLDER, MODULES, STYLES, html
from crs_cc.workbench.world_data import world_data

if TYPE_CHECKING:
    from collections.abc import Sequence

    from crs_cc.core.arrays import FloatArray
    from crs_cc.recording.recording import Recording
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.workbench.feed import Feed

MAX_BYTES: Final = 50 * 2**20
"""The maximum size of a page. Firefox and Chromium open it; with 1 GB, they do not."""

MAX_PATHS: Final = 50
MAX_POINTS: Final = 1000

_POLICY: Final = (
    "default-src 'none'; script-src 'unsafe-inline' data:; style-src 'unsafe-inline'; img-src blob:"
)
_SHARE: Final = 0.9 * 0.75  # for frames, before base 64
_FIELDS: Final = 0.08  # for sketches of fields


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


def html_page(
    recording: Recording,
    world: WorldModel,
    most_bytes: int = MAX_BYTES,
    *,
    other: OtherRecording | None = None,
) -> str:
    """Return the page of a recorded run.

    Args:
        recording: the run.
        world: its world.
        most_bytes: of the page.
        other: a run to compare it with, whose frames take half of the room.

    Raises:
        RecordingError: a recording is damaged.
        DebugError: the other run has no robot in common with it.
    """
    most = int(most_bytes * _SHARE) // (1 if other is None else 2)
    blocks, stride = frame_blocks(recording, most)
    if not blocks:
        raise recording.mcap.error("no frames: there is nothing to show")
    events, lost_events = events_in(recording)
    output, lost_output = output_in(recording)
    radius_m = world.robots[0].model.radius_m if world.robots else 0.0
    marks, lost_marks = marks_in(recording, radius_m)
    fields, field_stride = fields_in(recording, int(most_bytes * _FIELDS))
    left_out = [f"all but 1 in {stride} frames"] if stride > 1 else []
    compared = None if other is None else compared_run(recording, other, most)
    if compared is not None and compared["thinned"] > 1:
        left_out += [f"all but 1 in {compared['thinned']} frames of {compared['name']}"]
    left_out += [f"{lost_events} events"] if lost_events else []
    left_out += [f"{lost_output} pieces of output"] if lost_output else []
    left_out += [f"{lost_marks} marks of programs"] if lost_marks else []
    left_out += [f"all but 1 in {field_stride} sketches of fields"] if field_stride > 1 else []
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
        "world": _drawn(world_data(world, recording.rosters[-1].robots), fields),
        "fields": fields or None,
        "paths": _paths(recording, world),
        "marks": marks or None,
        "events": events,
        "output": output,
        "blocks": [[*span, b64encode(block).decode("ascii")] for *span, block in blocks],
        "other": compared,
    }
    return page_of(data)


def feed_contents(feed: Feed) -> dict[str, Any]:
    """Return the data of a feed, as the contents of a page.

    Raises:
        ValueError: it is too much for one.
    """
    contents = [(begin_s, end_s, feed.frames.content(number) or b"")
                for number, begin_s, end_s in feed.frames.index()]  # fmt: skip
    if sum(len(content) for _, _, content in contents) > MAX_BYTES * _SHARE:
        raise ValueError("the run is too long for one page: record it and use crs replay --html")
    known = feed.contents()
    return {
        **known,
        "world": _drawn(known["world"], known.get("fields")),
        "note": f"seed {known['seed']}, saved at {known['end_s']:.2f} s",
        "blocks": [
            [begin_s, end_s, b64encode(content).decode("ascii")]
            for begin_s, end_s, content in contents
            if content
        ],
    }


def _drawn(world: dict[str, Any], sketches: Sequence[Any] | None) -> dict[str, Any]:
    """Return a world as a page draws it that knows these sketches of fields."""
    return world if sketches else {**world, "fields": []}


def page_of(data: dict[str, Any]) -> str:
    """Return the page with these contents."""
    text = plain_text(data).replace("<", "\\u003c")
    style = "\n".join((FOLDER / name).read_text("utf-8") for name in STYLES)
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
