"""The data of a run that is displayed, for connected pages and those that connect later.

The run adds data to the feed, which stores a limited amount and forwards it. Data that is already
stored is not sent again, so going back and forth in a run changes nothing here until the run
diverges (`truncate`).
"""

from __future__ import annotations

import copy
import threading
import time
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.workbench.frame_store import Block, FrameStore
from crs_cc.workbench.message_log import MessageLog
from crs_cc.workbench.messages import VERSION, message
from crs_cc.workbench.trace import Trace

if TYPE_CHECKING:
    from crs_cc.workbench.clients import Client
    from crs_cc.workbench.server import Server

MAX_EVENTS: Final = 20_000
MAX_OUTPUT: Final = 4 * 2**20
_FRAME_S: Final = 0.03  # minimum real time between sent frames: no screen shows more
_SLACK_S: Final = 1e-9

Event = tuple[float, str, int, str, float | None, float | None]
"""Time [s], kind, robot or -1, text, and the place [m] if there is one."""

Output = tuple[float, int, int, str]
"""Time [s], robot, stream, text."""


Roster = tuple[float, tuple[str, ...], tuple[str, ...]]
"""Time [s], robots and objects in the frames from then on."""


class Feed:
    """The data of a run.

    Attributes:
        description: the constant data: title, world, capabilities.
        frames: the poses.
        messages: the messages and their outcomes.
        trace: the robots' activity and measurements.
        frame_s: the minimum simulated time between two frames.
        server: broadcasts new data; None to store it only.
        end_s: the latest time with data [s].
    """

    def __init__(self, description: dict[str, Any], frame_s: float, first: int = 0) -> None:
        """Create an empty feed.

        Args:
            description: the constant data, as JSON.
            frame_s: the minimum simulated time between two frames.
            first: the number of its first block of frames.
        """
        self.description = description
        self.frames = FrameStore(first=first)
        self.messages = MessageLog()
        self.trace = Trace()
        self.server: Server | None = None
        self.end_s = 0.0
        self._lock = threading.Lock()
        self.frame_s = frame_s
        self._events: list[Event] = []
        self._output: list[Output] = []
        self._output_size = 0
        self._rosters: list[Roster] = []
        self._sent_s = -1.0

    def greet(self, client: Client) -> None:
        """Send a page its first message, with the whole contents; thread-safe."""
        with self._lock:
            self._flush()  # the others must know the block that this page receives
            client.since = self.server.sent if self.server else 0
            known = self._contents()
            text = message("hello", version=VERSION, role=client.role, **known)
        client.put(text)

    def contents(self) -> dict[str, Any]:
        """Return the contents, except the frames; thread-safe."""
        with self._lock:
            return self._contents()

    def _contents(self) -> dict[str, Any]:
        return {**self.description, "frame_s": self.frame_s, **self._course()}

    def _course(self) -> dict[str, Any]:
        """Return the known course of the run."""
        return {
            "end_s": self.end_s,
            "rosters": [roster_fields(each) for each in self._rosters],
            "events": list(self._events),
            "output": list(self._output),
            "blocks": self.frames.index(),
        }

    def rosters(self) -> list[Roster]:
        """Return the rosters of the frames, with their start times."""
        return list(self._rosters)

    def flush(self) -> None:
        """Send the frames recorded so far: the run has stopped, and pages may go back."""
        with self._lock:
            self._flush()

    def _flush(self) -> None:
        self._broadcast_block(self.frames.flush())

    def _broadcast_block(self, block: Block | None) -> None:
        """Announce a block of frames to pages, if there is a new one."""
        if block is not None:
            self._broadcast("block", block=[block.number, block.begin_s, block.end_s])

    def roster(self, time_s: float, robots: Sequence[str], objects: Sequence[str]) -> None:
        """Record the roster of the frames from a time on."""
        new = time_s, tuple(robots), tuple(objects)
        if self._rosters and (self._rosters[-1][1:] == new[1:] or time_s <= self._rosters[-1][0]):
            return
        with self._lock:
            self._rosters.append(new)
            self._broadcast("roster", roster=roster_fields(new))

    def frame(self, time_s: float, values: FloatArray, *, is_last: bool = False) -> None:
        """Record the poses of all robots and objects.

        Args:
            time_s: when.
            values: numbers [m, rad], (columns, rows).
            is_last: whether the run stops here, so that the frame must be shown.
        """
        last_s = self.frames.end_s
        self.end_s = max(self.end_s, time_s)
        if time_s > last_s + _SLACK_S and (
            last_s < 0.0 or time_s - last_s >= self.frame_s - _SLACK_S
        ):
            with self._lock:
                self._broadcast_block(self.frames.add(time_s, values))
        if self.server is None or not self.server.page_count:
            return
        now_s = time.monotonic()
        if is_last or now_s - self._sent_s >= _FRAME_S:
            self._sent_s = now_s
            self.server.broadcast_frame(time_s, values)

    def event(
        self, time_s: float, kind: str, robot: int, text: str,
        place: tuple[float, float] | None = None,
    ) -> None:  # fmt: skip
        """Record an event."""
        event: Event = (round(time_s, 6), kind, robot, text, *(place or (None, None)))
        with self._lock:
            self._events.append(event)
            if len(self._events) > MAX_EVENTS:
                del self._events[: MAX_EVENTS // 2]
            self._broadcast("event", event=event)

    def write(self, time_s: float, robot: int, stream: int, content: bytes) -> None:
        """Record the output of a program."""
        piece: Output = round(time_s, 6), robot, stream, content.decode("utf-8", "replace")
        with self._lock:
            self._output.append(piece)
            self._output_size += len(content) + 32
            while self._output_size > MAX_OUTPUT:
                gone = self._output[: len(self._output) // 4 + 1]
                del self._output[: len(gone)]
                self._output_size -= sum(len(each[3].encode()) + 32 for each in gone)
            self._broadcast("output", output=piece)

    def fill(self, events: Sequence[Any], output: Sequence[Any]) -> None:
        """Set all events and all output of a finished run."""
        self._events, self._output = list(events), list(output)

    def truncate(self, time_s: float) -> None:
        """Discard data after a time, as the run diverges from it."""
        after_s = time_s + _SLACK_S
        with self._lock:
            self.end_s = time_s
            self.frames.truncate(time_s)
            self.messages.truncate(time_s)
            self.trace.truncate(time_s)
            self._events = [each for each in self._events if each[0] <= after_s]
            self._output = [each for each in self._output if each[0] <= after_s]
            self._output_size = sum(len(each[3].encode()) + 32 for each in self._output)
            self._rosters = [each for each in self._rosters if each[0] <= after_s]
            self._broadcast("truncate", time_s=time_s, blocks=self.frames.index())

    def fork(self) -> Feed:
        """Return an independent copy that is not sent to pages."""
        with self._lock:
            other = copy.copy(self)
            other._lock, other.server = threading.Lock(), None
            other.frames, other.messages = self.frames.fork(), self.messages.fork()
            other.trace = self.trace.fork()
            other._events, other._output = self._events[:], self._output[:]
            other._rosters = self._rosters[:]
        return other

    def replace_with(self, other: Feed) -> None:
        """Replace the contents with those of another feed, and notify all pages."""
        copied = other.fork()
        with self._lock:
            self.frames, self.messages, self.trace = copied.frames, copied.messages, copied.trace
            self._events, self._output = copied._events, copied._output
            self._rosters, self._output_size = copied._rosters, copied._output_size
            self.end_s = copied.end_s
            self._broadcast("replace", **self._course())

    def events(self) -> list[Event]:
        """Return the stored events."""
        return list(self._events)

    def output(self) -> list[Output]:
        """Return the stored output."""
        return list(self._output)

    def _broadcast(self, kind: str, **fields: Any) -> None:
        if self.server is not None and self.server.page_count:
            self.server.broadcast(message(kind, **fields))


def roster_fields(roster: Roster) -> dict[str, Any]:
    """Return a roster as sent to pages."""
    time_s, robots, objects = roster
    return {"t": time_s, "robots": robots, "objects": objects}


def rounded(values: FloatArray, digits: int = 4) -> list[Any]:
    """Return numbers for JSON, with null for those that are not finite."""
    found: list[Any] = np.round(values, digits).tolist()
    return found
