"""The pages that are connected: what waits to be sent to each.

Messages arrive in order. Of what is only worth its latest state (a frame, the table of robots) the
newest one is kept: so a slow page loses frames and never delays the run.
"""

from __future__ import annotations

import asyncio
import time
from collections import deque
from dataclasses import dataclass, field
from typing import Final, Literal

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.recording.frames import Numbers, encode
from crs_cc.workbench.messages import frame_message

Role = Literal["view", "control"]

MAX_PENDING_BYTES: Final = 64 * 2**20
"""What may wait for a page; more ends its connection. Chosen by us: above any first message."""

MAX_COMMANDS_PER_S: Final = 200
"""Commands of a page in a second; a hand that drags a slider makes 60."""


@dataclass(slots=True)
class LiveFrame:
    """A frame to be sent: the difference from the previous one, and the whole if a page needs it.

    Attributes:
        number: its number, rising by 1.
        whole: its numbers as they are written.
        change: the message with the difference; None if there is no frame before of its shape.
    """

    number: int
    time_s: float
    values: FloatArray
    whole: Numbers
    change: bytes | None
    _complete: bytes | None = None

    def message(self, before: int) -> bytes:
        """Return the message for a page that has got a frame with this number last."""
        if self.change is not None and before == self.number - 1:
            return self.change
        if self._complete is None:
            self._complete = frame_message(self.time_s, encode(np.array([self.values]))[0])
        return self._complete


@dataclass(slots=True, eq=False)
class Client:
    """A page that is connected; used by the server's thread only.

    Attributes:
        role: what its token allows.
        since: the number of broadcast messages whose content its first message had.
        frame_number: the number of the last frame that it was sent.
        wake: set when there is something to send.
        is_lost: whether its connection must end.
        is_sending: whether a message is on its way to it.
    """

    role: Role
    since: int = 0
    frame_number: int = -1
    wake: asyncio.Event = field(default_factory=asyncio.Event)
    is_lost: bool = False
    is_sending: bool = False
    _messages: deque[str | bytes] = field(default_factory=deque)
    _bytes: int = 0
    _latest: dict[str, str | LiveFrame] = field(default_factory=dict)
    _allowance: float = MAX_COMMANDS_PER_S
    _asked_s: float = field(default_factory=time.monotonic)

    @property
    def is_idle(self) -> bool:
        """Whether nothing is queued or being sent."""
        return not (self.is_sending or self._messages or self._latest)

    def put(self, message: str | bytes) -> None:
        """Add a message that must arrive."""
        self._messages.append(message)
        self._bytes += len(message)
        if self._bytes > MAX_PENDING_BYTES:
            self.is_lost = True
        self.wake.set()

    def put_latest(self, kind: str, message: str | LiveFrame) -> None:
        """Set the message of a kind, in place of one that has not been sent."""
        self._latest[kind] = message
        self.wake.set()

    def next_message(self) -> str | bytes | None:
        """Return the next message to send; None if there is none."""
        if self._messages:
            message = self._messages.popleft()
            self._bytes -= len(message)
            return message
        if not self._latest:
            self.wake.clear()
            return None
        latest = self._latest.pop(next(iter(self._latest)))
        if isinstance(latest, LiveFrame):
            content = latest.message(self.frame_number)
            self.frame_number = latest.number
            return content
        return latest

    def may_send(self) -> bool:
        """Return whether it may send another command now."""
        now_s = time.monotonic()
        earned = (now_s - self._asked_s) * MAX_COMMANDS_PER_S
        self._allowance = min(MAX_COMMANDS_PER_S, self._allowance + earned) - 1.0
        self._asked_s = now_s
        return self._allowance >= 0.0
