"""An opened recording: its description, and its contents at any time.

Nothing in the file is trusted: whatever is not as it should be is a `RecordingError`, and what is
read at a time is a chunk.
"""

from __future__ import annotations

import json
from bisect import bisect_right
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final, Self

from crs_cc.recording import readings, topics
from crs_cc.recording.description import RunDescription
from crs_cc.recording.entries import SPAN_NS, entries_of
from crs_cc.recording.frame_reader import FrameReader, OdometryPredictions
from crs_cc.recording.frames import COLUMNS, MAX_ROWS, is_key
from crs_cc.recording.hashes import Hash, hashes_in
from crs_cc.recording.mcap_reader import McapReader
from crs_cc.recording.mcap_records import NS, Message
from crs_cc.recording.source_tree import INPUTS, SOURCES, write_tree

if TYPE_CHECKING:
    from crs_cc.core.arrays import FloatArray
    from crs_cc.recording.readings import Readings

MAX_TREE_BYTES: Final = 256 * 2**20
_LATEST_NS: Final = 2**62


@dataclass(frozen=True, slots=True)
class Roster:
    """The robots and objects in the frames from a time on.

    Attributes:
        time_ns: the time.
        robots: the robots' names, the first rows of a frame.
        objects: the names of movable objects, the other rows.
        columns: the names of the columns.
    """

    time_ns: int
    robots: tuple[str, ...]
    objects: tuple[str, ...]
    columns: tuple[str, ...]

    @classmethod
    def of(cls, values: dict[str, str]) -> Self:
        """Return the roster in a recording; raise ValueError if it is not valid."""
        made = cls(
            int(values.get("time_ns", "")[:20]),
            _names(values.get("robots", "")),
            _names(values.get("objects", "")),
            tuple(values.get("columns", "").split()),
        )
        rows = len(made.robots) + len(made.objects)
        if made.columns not in (COLUMNS[:3], COLUMNS) or rows > MAX_ROWS or made.time_ns < 0:
            raise ValueError("a roster is not valid")
        return made


@dataclass(frozen=True, slots=True)
class Frame:
    """Where everything is at an instant.

    Attributes:
        time_ns: the instant.
        values: x, y [m], heading and turret [rad] in the rows, (columns, rows of the roster).
    """

    time_ns: int
    values: FloatArray

    @property
    def time_s(self) -> float:
        """Return the instant [s]."""
        return self.time_ns / NS


class Recording:
    """A recording in a file.

    Attributes:
        path: the file.
        description: what was run.
        versions: of crs, Python and packages that recorded it.
        rosters: the robots and objects from given times on, by time.
        result: how the run ended; None if the recording is not complete.
    """

    def __init__(self, path: Path) -> None:
        """Open a file and read its description.

        Raises:
            RecordingError: it is not a recording, or of another version.
            OSError: it cannot be read.
        """
        self.path = path
        self._mcap = McapReader(path)
        try:
            self._read_metadata()
        except BaseException:
            self.close()
            raise

    def _read_metadata(self) -> None:
        metadata = self._mcap.metadata
        if topics.RUN not in metadata:
            raise self._mcap.error("not a crs recording", "make one with crs run --record")
        with self.errors():
            self.description = RunDescription.of(metadata[topics.RUN])
            rosters = [each for name, each in metadata.items() if name.startswith(topics.ROSTER)]
            self.rosters = sorted(map(Roster.of, rosters), key=lambda each: each.time_ns)
        if not self.rosters:
            raise self._mcap.error("no roster: nothing was recorded")
        known = metadata[topics.RUN].items()
        self.versions = {name: value for name, value in known if name not in ("run", "format")}
        self.result = metadata.get(topics.RESULT)

    @property
    def is_complete(self) -> bool:
        """Return whether the run was recorded up to its end."""
        return self._mcap.is_complete and self.result is not None

    @property
    def mcap(self) -> McapReader:
        """Return the container."""
        return self._mcap

    @property
    def end_ns(self) -> int:
        """Return the time of the last message."""
        return max((chunk.last_ns for chunk in self._mcap.chunks), default=0)

    @contextmanager
    def errors(self) -> Iterator[None]:
        """Convert errors in the file's values to errors of the recording."""
        try:
            yield
        except (ValueError, KeyError, RecursionError, OverflowError, TypeError) as wrong:
            text = str(wrong) if isinstance(wrong, ValueError) else f"invalid values ({wrong!r})"
            raise self._mcap.error(text[:400]) from None

    def roster_at(self, time_ns: int) -> Roster:
        """Return the robots and objects at a time."""
        place = bisect_right([each.time_ns for each in self.rosters], time_ns)
        return self.rosters[max(0, place - 1)]

    def messages(
        self, *wanted: str, since_ns: int = 0, until_ns: int = _LATEST_NS
    ) -> Iterator[Message]:
        """Yield the messages of some topics in a span of time, both ends included.

        Raises:
            RecordingError: a chunk is damaged.
        """
        for chunk in self._mcap.chunks:
            if chunk.last_ns >= since_ns and chunk.first_ns <= until_ns:
                for message in self._mcap.messages(chunk):
                    if message.topic in wanted and since_ns <= message.time_ns <= until_ns:
                        yield message

    def data(
        self, topic: str, since_ns: int = 0, until_ns: int = _LATEST_NS
    ) -> Iterator[tuple[int, dict[str, Any]]]:
        """Yield the entries of a topic in JSON, each with its time.

        Raises:
            RecordingError: one is not valid.
        """
        last_ns = min(_LATEST_NS, until_ns + SPAN_NS)
        for message in self.messages(topic, since_ns=since_ns, until_ns=last_ns):
            with self.errors():
                found = entries_of(message.data)
            for time_ns, entry in found:
                if since_ns <= time_ns <= until_ns:
                    yield time_ns, entry

    def frames(
        self, since_ns: int = 0, until_ns: int = _LATEST_NS, topic: str = topics.FRAME.topic
    ) -> Iterator[Frame]:
        """Yield the frames in a span of time, and the last one before it, if there is one.

        Frames that cannot be decoded because one before them is lost are left out.

        Raises:
            RecordingError: a chunk is damaged.
        """
        last, decoder = None, FrameReader(topic)
        begin_ns = self._key_before(since_ns, topic)
        if topic == topics.ODOMETRY.topic:
            begin_ns = self._key_before(begin_ns, topics.FRAME.topic)
        for message in self.messages(*decoder.topics, since_ns=begin_ns, until_ns=until_ns):
            found = [Frame(*each) for each in decoder.frames(message)]
            for frame in found:
                if not self._fits(frame, topic):
                    text = f"a frame at {frame.time_s:.3f} s does not fit the roster"
                    raise self._mcap.error(text)
                if frame.time_ns < since_ns:
                    last = frame
                elif frame.time_ns <= until_ns:
                    if last is not None:
                        yield last
                        last = None
                    yield frame
        if last is not None:
            yield last

    def frame_at(self, time_ns: int, topic: str = topics.FRAME.topic) -> Frame | None:
        """Return the last frame up to a time."""
        last = None
        for last in self.frames(time_ns, time_ns, topic):  # noqa: B007 - the last one counts
            pass
        return last

    def readings(self, since_ns: int = 0, until_ns: int = _LATEST_NS) -> Iterator[Readings]:
        """Yield the readings in a span of time, and some before it, a message at a time.

        Raises:
            RecordingError: they cannot be decoded.
        """
        second_ns = max(0, since_ns - SPAN_NS - 2 * NS)
        begin_ns = second_ns // readings.PERIOD_NS * readings.PERIOD_NS
        decoder = readings.ReadingDecoder()
        for chunk in self._mcap.chunks:
            if chunk.last_ns >= begin_ns and chunk.first_ns <= until_ns:
                messages = list(self._mcap.messages(chunk))
                predictions = OdometryPredictions(messages)
                for message in messages:
                    is_wanted = begin_ns <= message.time_ns <= until_ns
                    if message.topic == topics.STATE.topic and is_wanted:
                        with self.errors():
                            found = decoder.decode(message.data, message.time_ns, predictions.of)
                        if found is not None and message.time_ns >= second_ns:
                            yield found

    def hashes(self) -> Iterator[Hash]:
        """Yield the hashes.

        Raises:
            RecordingError: one is not valid.
        """
        for _, data in self.data(topics.HASH.topic):
            with self.errors():
                rows = list(hashes_in(data))
            yield from rows

    def sources(self) -> dict[str, bytes]:
        """Return the files that the run was loaded from, by name."""
        return self._attached(SOURCES)

    def inputs(self) -> dict[str, bytes]:
        """Return the files that its programs could read, by name."""
        return self._attached(INPUTS)

    def write_sources(self, folder: Path) -> None:
        """Write the files that the run was loaded from below a folder.

        Raises:
            RecordingError: a name leads elsewhere.
        """
        with self.errors():
            write_tree(self.sources(), folder)

    def close(self) -> None:
        """Close the file."""
        self._mcap.close()

    def _attached(self, prefix: str) -> dict[str, bytes]:
        names = [name for name in self._mcap.attachments if name.startswith(prefix)]
        found, size = dict[str, bytes](), 0
        for name in names:
            found[name.removeprefix(prefix)] = content = self._mcap.attachment(name)
            size += len(content)
            if size > MAX_TREE_BYTES:
                raise self._mcap.error("the attachments are larger than 256 MiB")
        return found

    def _fits(self, frame: Frame, topic: str) -> bool:
        """Return whether a frame has the rows of the roster of its time, or of the one before."""
        columns, rows = frame.values.shape
        for roster in self.rosters:
            robots, solids = len(roster.robots), len(roster.objects)
            if topic == topics.ODOMETRY.topic:
                if (columns, rows) == (3, robots):
                    return True
            elif (columns, rows) == (len(roster.columns), robots + solids):
                return True
        return False

    def _key_before(self, time_ns: int, topic: str) -> int:
        """Return the time of the last key frame up to a time."""
        chunks = [each for each in self._mcap.chunks if each.first_ns <= time_ns]
        for chunk in reversed(chunks):
            keys = [
                message.time_ns
                for message in self._mcap.messages(chunk)
                if message.topic == topic and is_key(message.data) and message.time_ns <= time_ns
            ]
            if keys:
                return max(keys)
        return 0


def _names(text: str) -> tuple[str, ...]:
    found = json.loads(text)
    if not isinstance(found, list) or not all(isinstance(each, str) for each in found):
        raise ValueError("a list of names is not valid")
    return tuple(found)
