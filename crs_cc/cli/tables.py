"""Tables of a recorded run as CSV files (RFC 4180), with units in the headings.

Text that a spreadsheet would take for a formula gets an apostrophe in front.
"""

from __future__ import annotations

import csv
import itertools
import json
import math
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from crs_cc.cli.csv_cells import text_cell
from crs_cc.cli.written_file import written_file
from crs_cc.recording import topics
from crs_cc.recording.mcap_records import NS
from crs_cc.recording.message_contents import MessageContents, shown
from crs_cc.requests import REQUESTS
from crs_cc.sim.state.messages import EVERYBODY

if TYPE_CHECKING:
    from crs_cc.recording.recording import Frame, Recording

POSES: Final = (
    "time [s]", "name", "x [m]", "y [m]", "heading [deg]", "turret [deg]",
    "odometry x [m]", "odometry y [m]", "odometry heading [deg]",
)  # fmt: skip
SENSORS: Final = (
    "time [s]", "robot", "request",
    *(f"infrared {number} [0 to 15]" for number in range(16)),
    *(f"sonar {number} [in]" for number in range(16)),
    "bumper [bits]", "x [0.1 in]", "y [0.1 in]", "steering [0.1 deg]", "turret [0.1 deg]",
    "right [0.1 in/s]", "left [0.1 in/s]", "turret speed [0.1 deg/s]", "motors [bits]",
    "laser mode", "compass [0.1 deg]", "other values",
)  # fmt: skip
EVENTS: Final = ("time [s]", "kind", "robot", "text", "x [m]", "y [m]")
MESSAGES: Final = (
    "time [s]", "fate", "channel", "sender", "receiver", "group", "type", "size [bytes]", "number",
    "content", "content [hex]",
)  # fmt: skip

_MAX_COLUMN: Final = 1_000_000


def write_tables(recording: Recording, folder: Path) -> None:
    """Write `poses.csv`, `sensors.csv`, `events.csv` and `messages.csv`.

    Raises:
        RecordingError: the recording is not valid.
        OSError: a file cannot be written.
    """
    for name, heading, rows in tables(recording):
        with _table(folder / f"{name}.csv", heading) as writer:
            writer.writerows([text_cell(cell) for cell in row] for row in rows)


def tables(recording: Recording) -> Iterator[tuple[str, Sequence[str], Iterable[Sequence[Any]]]]:
    """Yield name, headings and rows of each table."""
    yield "poses", POSES, _poses(recording)
    yield "sensors", SENSORS, _sensors(recording)
    yield "events", EVENTS, _events(recording)
    yield "messages", MESSAGES, _messages(recording)


@contextmanager
def _table(path: Path, heading: Sequence[str]) -> Iterator[Any]:
    with (
        written_file(path),
        path.open("w", newline="", encoding="utf-8", errors="replace") as file,
    ):
        writer = csv.writer(file)
        writer.writerow(heading)
        yield writer


def _poses(recording: Recording) -> Iterator[Sequence[Any]]:
    believed = recording.frames(topic=topics.ODOMETRY.topic)
    odometry: Frame | None = next(believed, None)
    for frame in recording.frames():
        roster = recording.roster_at(frame.time_ns)
        while odometry is not None and odometry.time_ns < frame.time_ns:
            odometry = next(believed, None)
        own = odometry if odometry is not None and odometry.time_ns == frame.time_ns else None
        names = itertools.chain(roster.robots, roster.objects)
        for row, name in zip(range(frame.values.shape[1]), names, strict=False):
            x_m, y_m, heading_rad, *turret = frame.values[:, row].tolist()
            if math.isnan(x_m):
                continue
            cells = [_seconds(frame.time_ns), name, x_m, y_m, _degrees(heading_rad)]
            cells += [_degrees(turret[0]) if turret else ""]
            if own is not None and row < own.values.shape[1]:
                x_m, y_m, heading_rad = own.values[:, row].tolist()
                cells += [x_m, y_m, _degrees(heading_rad)]
            else:
                cells += ["", "", ""]
            yield cells


def _sensors(recording: Recording) -> Iterator[Sequence[Any]]:
    for found in recording.readings():
        columns = (found.codes, found.robots, found.clock_s, found.states)
        rows = zip(*(column.tolist() for column in columns), strict=True)
        for code, robot, clock_s, state in rows:
            name = REQUESTS[code].name if code in REQUESTS else ""
            at_s = round(clock_s, 6)
            yield (at_s, _robot(recording, robot, round(clock_s * NS)), name, *state[1:44], "")
    empty = [""] * (len(SENSORS) - 4)
    for time_ns, data in recording.data(topics.READING.topic):
        with recording.errors():
            lists = [list(data[name]) for name in ("robot", "time_s", "values")]
            name = str(data.get("request"))[:40]
            cells = [(int(r), float(t), json.dumps(v)) for r, t, v in zip(*lists, strict=True)]
        for robot, clock_s, values in cells:
            yield (clock_s, _robot(recording, robot, time_ns), name, *empty, values)


def _events(recording: Recording) -> Iterator[Sequence[Any]]:
    for time_ns, data in recording.data(topics.EVENT.topic):
        with recording.errors():
            robot = int(data.get("robot", -1))
        name = _robot(recording, robot, time_ns)
        cells = [data.get(each, "") for each in ("kind", "text", "x_m", "y_m")]
        kind, text, x_m, y_m = (each if isinstance(each, str | float) else "" for each in cells)
        yield (_seconds(time_ns), kind, name, text, x_m, y_m)


def _messages(recording: Recording) -> Iterator[Sequence[Any]]:
    names = ("time_s", "fate", "channel", "sender", "receiver", "group", "type", "bytes", "number")
    contents = MessageContents()
    for time_ns, data in recording.data(topics.MESSAGE.topic):
        with recording.errors():
            columns = [data[name] for name in names]
            rows = [tuple(row) for row in zip(*columns, strict=True)][:_MAX_COLUMN]
            if not all(isinstance(cell, str | int | float) for row in rows for cell in row):
                raise ValueError("a message has an invalid value")
            people = [(int(row[3]), int(row[4])) for row in rows]
            said = contents.of(data)
        for row, (sender, receiver), content in zip(rows, people, said, strict=False):
            to = "all" if receiver == EVERYBODY else _robot(recording, receiver, time_ns)
            cells = ("", "") if content is None else (shown(content), content.hex())
            yield (*row[:3], _robot(recording, sender, time_ns), to, *row[5:], *cells)


def _robot(recording: Recording, robot: int, time_ns: int) -> str:
    robots = recording.roster_at(time_ns).robots
    return robots[robot] if 0 <= robot < len(robots) else ""


def _seconds(time_ns: int) -> float:
    return round(time_ns / NS, 6)


def _degrees(angle_rad: float) -> float:
    return round(math.degrees(angle_rad), 3)
