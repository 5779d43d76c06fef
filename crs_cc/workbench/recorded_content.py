"""What a recording holds, as the page gets it and within bounds: frames, events and output."""

from __future__ import annotations

import math
import zlib
from base64 import b64encode
from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from crs_cc.debug.timeline.note import KIND, Note
from crs_cc.plot.x11_colours import HEX
from crs_cc.recording import topics
from crs_cc.recording.content import content_of
from crs_cc.recording.field_sketches import sketches_in
from crs_cc.recording.marks import drawn_marks
from crs_cc.recording.mcap_records import NS
from crs_cc.recording.message_contents import MessageContents, shown
from crs_cc.workbench.devices_in_view import field_map
from crs_cc.workbench.frame_blocks import packed

if TYPE_CHECKING:
    from crs_cc.recording.recording import Frame, Recording

MAX_EVENTS: Final = 20_000
MAX_NOTES: Final = 500
MAX_MARKS: Final = 5_000
MAX_OUTPUT: Final = 4 * 2**20
MAX_FIELDS: Final = 4 * 2**20
"""Size of the sketches of fields; chosen by us. It is six minutes of a field of noise, which does
not compress, and hours of trails."""

_SKETCH: Final = 200  # bytes of a sketch besides its shares
_MAX_NOTE: Final = 400  # characters
_MAX_CONTENT: Final = 60  # bytes of a message that an event shows

_ARROWS: Final = {"sent": "sent", "delivered": "arrived", "corrupted": "corrupted"}

Block = tuple[float, float, bytes]
"""Times of the first and the last frame [s], and the packed frames."""


def frame_blocks(recording: Recording, most_bytes: int) -> tuple[list[Block], int]:
    """Return the frames in blocks of about a second, and which share of them: each how manyth.

    Args:
        recording: the recording.
        most_bytes: the size of all blocks; more frames are thinned.

    Raises:
        RecordingError: the recording is damaged.
    """
    stride = 1
    while True:
        blocks: list[Block] = []
        size = 0
        for frames in _seconds(recording, stride):
            block = packed(
                [each.time_s for each in frames], np.array([each.values for each in frames])
            )
            size += len(block)
            if size > most_bytes:
                break
            blocks.append((frames[0].time_s, frames[-1].time_s, block))
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


def events_in(recording: Recording) -> tuple[list[list[Any]], int]:
    """Return the first events and the user's notes, and how many events are left out."""
    found: list[list[Any]] = []
    lost = 0
    for time_ns, data in recording.data(topics.EVENT.topic):
        if data.get("kind") in ("drawing", "erasing"):
            continue
        if len(found) >= MAX_EVENTS:
            lost += 1
            continue
        place = [data.get("x_m"), data.get("y_m")]
        numbers = [each if isinstance(each, float | int) else None for each in place]
        with recording.errors():
            kind, text = str(data.get("kind"))[:40], str(data.get("text"))[:400]
            robot, robots = int(data.get("robot", -1)), recording.roster_at(time_ns).robots
            if 0 <= robot < len(robots) and robots[robot] not in text:
                text = f"{robots[robot]}{' ' if kind == 'collision' else ': '}{text}"
            found.append([time_ns / NS, kind, robot, text, *numbers])
    contents = MessageContents()
    for time_ns, data in recording.data(topics.MESSAGE.topic):
        with recording.errors():
            rows = list(_messages(data, recording.roster_at(time_ns).robots, contents))
        lost += max(0, len(found) + len(rows) - MAX_EVENTS)
        found += rows[: MAX_EVENTS - len(found)]
    found += _notes(recording)
    return sorted(found, key=lambda each: float(each[0])), lost


def _notes(recording: Recording) -> Iterator[list[Any]]:
    """Yield the user's first notes, as events."""
    notes = (each for _, each in recording.data(topics.INPUT.topic) if each.get("kind") == KIND)
    for data in islice(notes, MAX_NOTES):
        with recording.errors():
            note = Note.of(data)
        yield [note.time_s, KIND, note.robot, note.text[:_MAX_NOTE], None, None]


def marks_in(recording: Recording, radius_m: float) -> tuple[list[list[Any]], int]:
    """Return the strokes of the last marks that programs drew, and how many marks are left out.

    Args:
        recording: the recording.
        radius_m: of a robot, which programs can draw.
    """
    marked = drawn_marks(recording)
    shown, found = marked[-MAX_MARKS:], list[list[Any]]()
    for each in shown:
        until_s = each.until_s if math.isfinite(each.until_s) else None
        for stroke in each.drawing.strokes_m(radius_m):
            points = stroke.round(3).tolist()
            found.append([each.since_s, until_s, HEX[each.drawing.colour], points])
    return found, len(marked) - len(shown)


def fields_in(
    recording: Recording, most_bytes: int = MAX_FIELDS
) -> tuple[list[dict[str, Any]], int]:
    """Return the sketches of pheromone fields, and which share of them: each how manyth.

    Args:
        recording: the recording.
        most_bytes: the size of all; more sketches are thinned, each field by itself.
    """
    stride = 1
    while True:
        found: list[dict[str, Any]] = []
        numbers: dict[str, int] = {}
        size = 0
        for time_ns, sketch in sketches_in(recording):
            number = numbers[sketch.name] = numbers.get(sketch.name, -1) + 1
            if number % stride:
                continue
            shares = b64encode(zlib.compress(sketch.shares.tobytes())).decode("ascii")
            size += _SKETCH + len(shares)
            if size > most_bytes:
                break
            evaporation_s = sketch.evaporation_s if math.isfinite(sketch.evaporation_s) else None
            rest = {"t": time_ns / NS, "evaporation": evaporation_s, "packed": shares}
            found.append(field_map(sketch) | rest)
        if size <= most_bytes or stride > 2**20:
            return found, stride
        stride *= 2


def _messages(
    data: dict[str, Any], robots: tuple[str, ...], contents: MessageContents
) -> Iterator[list[Any]]:
    """Yield the outcomes of messages, as events."""
    columns = (data["time_s"], data["fate"], data["sender"], data["receiver"], contents.of(data))
    for time_s, fate, sender, receiver, content in zip(*columns, strict=True):
        names = [robots[each] if 0 <= each < len(robots) else "all" for each in (sender, receiver)]
        kind = f"message-{_ARROWS.get(str(fate), 'lost')}"
        text = f"{names[0]} to {names[1]}: {str(fate)[:40]}"
        if content and fate == "sent":
            text += f" {shown(content[:_MAX_CONTENT])!r}"
        yield [float(time_s), kind, int(sender), text, None, None]


def output_in(recording: Recording) -> tuple[list[list[Any]], int]:
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
