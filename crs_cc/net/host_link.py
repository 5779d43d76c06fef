"""The environment's end of a connection to a host, which runs the programs of some robots.

The environment sends a grant: a time up to which programs may run, and the answers that they wait
for. The host runs them until one makes a request or all have reached this time, and replies with
what has changed. Grants are logged since the programs' memories were last fetched. If the host is
lost, another one receives these memories and repeats the logged grants. This gives the same bits,
because a program depends on nothing but its answers.
"""

from __future__ import annotations

import json
import struct
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Final, TypeAlias, TypeVar

import numpy as np

from crs_cc.core.arrays import IndexArray
from crs_cc.core.host_system import KeptProcessor
from crs_cc.net import memories
from crs_cc.net.changed_words import WORDS, Table
from crs_cc.net.channel import HEAD_BYTES, Channel, ConnectionLostError, Kind
from crs_cc.net.error_data import report_of
from crs_cc.net.frames import GRANT
from crs_cc.net.memories import Memory
from crs_cc.net.shared_rows import SharedRows

if TYPE_CHECKING:
    from crs_cc.runtime.diagnosis.report import ErrorReport

RESTORE: Final = struct.Struct("<Q?")
"""Number of the last grant, and whether memories follow the rows of the table."""

MAX_LOG_GRANTS: Final = 500
MIN_LOG_BYTES: Final = 512 * 2**10
"""Memories are fetched again after this number of grants, or when the log is larger than the
memories and than this size [bytes]. So fetching takes less time than granting. Chosen by us."""

_GRANT, _RAN, _FAILED = Kind.GRANT, Kind.RAN, Kind.FAILED
"""Looked up once, because access to a member of an enumeration runs Python code."""

_NOT_VALID: Final = "invalid answer: "

HOST_LOST: Final = "the host is lost"
"""The beginning of the error message of a program that does not continue."""

Replace: TypeAlias = Callable[["HostLink", str], Channel]
"""Returns a connection to a host that replaces a lost one, given the reason for the loss; raises
HostGoneError if its programs do not continue."""

Result = TypeVar("Result")


class HostGoneError(Exception):
    """A host is lost, and its programs do not continue."""


def _not_replaced(_link: HostLink, reason: str) -> Channel:
    raise HostGoneError(reason)


class HostLink:
    """The programs of one host.

    Attributes:
        names: its robots.
        robots: their numbers.
        selection: the same, as an index of what all robots have.
        number: its number among the hosts of a run.
        reports: run-time errors of programs, by position in `robots`.
        ended: whether the host has been dismissed.
    """

    def __init__(
        self, names: tuple[str, ...], robots: IndexArray, channel: Channel, replace: Replace
    ) -> None:
        """Take a connection to a host that is ready.

        Args:
            names: the robots.
            robots: their numbers in the world.
            channel: the connection.
            replace: returns a connection to another host in its place, see `Replace`.
        """
        self.names, self.robots = names, robots
        self.selection = _selection(robots)
        self.number, self.ended = 0, False
        self.reports: dict[int, ErrorReport] = {}
        self._channel = channel
        self._replace = replace
        self._rows: SharedRows | None = None
        self._log: list[bytes] = []
        self._log_bytes = 0
        self._awaits_answer = False
        self._saved: list[Memory] | None = None
        self._last_memories = [_NO_MEMORY] * len(robots)  # those that were fetched last
        self._begin_log()
        self._recover(lambda: self._channel.send(Kind.RESTORE, self._start))

    def attach(self, rows: SharedRows) -> None:
        """Take part in a run; required before anything else."""
        self._rows, self.number = rows, rows.add(self.robots)
        self._buffer = rows.buffer(self.number)

    # -- rounds ----------------------------------------------------------------------------------

    @property
    def is_log_long(self) -> bool:
        """Whether memories are to be fetched again, to shorten the log of grants."""
        return self._log_bytes >= self._max_log_bytes or len(self._log) >= MAX_LOG_GRANTS

    def grant(self) -> None:
        """Send the grant that has been packed, and log it.

        Raises:
            HostGoneError: the host is lost, and its programs do not continue.
        """
        assert self._rows is not None
        self._saved = None
        frame = self._rows.packed(self.number)
        self._log.append(bytes(frame[HEAD_BYTES:]))
        self._log_bytes += len(frame)
        self._awaits_answer = True
        try:
            self._channel.send_frame(_GRANT, frame)
        except ConnectionLostError as error:
            self._reconnect(str(error))  # which sends this grant, too

    @property
    def is_local(self) -> bool:
        """Whether the host is a process on this machine, see `local_socket`."""
        return self._channel.is_local

    def collect(self, *, keeps_processor: bool = False) -> None:
        """Receive the host's answer to a grant, for `SharedRows.take`.

        Args:
            keeps_processor: whether this thread stays on its processor, see `KeptProcessor`.

        Raises:
            HostGoneError: the host is lost, and its programs do not continue.
        """
        assert self._rows is not None
        while True:
            try:
                if keeps_processor:
                    with KeptProcessor():
                        size = self._channel.receive_frame(_RAN, self._buffer)
                else:
                    size = self._channel.receive_frame(_RAN, self._buffer)
                if size:
                    self._rows.put_received(self.number, size)
                else:
                    self._rows.put(self.number, self._answer())
            except ConnectionLostError as error:
                self._reconnect(str(error))
            except (ValueError, RecursionError) as error:
                self._reconnect(f"{_NOT_VALID}{error}")
            else:
                self._awaits_answer = False
                return

    def collect_again(self, reason: str) -> None:
        """Disconnect the host, because its answer is invalid, and receive that of another one."""
        self._awaits_answer = True
        self._reconnect(_NOT_VALID + reason)
        self.collect()

    def _answer(self) -> bytes:
        """Receive the host's answer, and the errors of programs that precede it."""
        while True:
            kind, content = self._channel.receive(_RAN, _FAILED)
            if kind is _RAN:
                return content
            self._note_failure(json.loads(content))

    def _note_failure(self, data: Any) -> None:
        robot = data.get("robot") if isinstance(data, dict) else None
        if not isinstance(robot, int) or not 0 <= robot < len(self.robots):
            raise ValueError("failure of an unknown robot")
        self.reports[robot] = report_of(data)

    # -- memories and input ----------------------------------------------------------------------

    def memories(self) -> list[Memory]:
        """Fetch the current memories of the programs."""
        self.request_memories()
        return self.receive_memories()

    @property
    def has_run(self) -> bool:
        """Whether anything has been granted."""
        return self._rows is not None and self._rows.last_grant(self.number) > 0

    @property
    def is_saved(self) -> bool:
        """Whether the current memories have been fetched."""
        return self._saved is not None

    def request_memories(self) -> None:
        """Request the memories, unless they have been fetched."""
        if self._saved is None:
            self._recover(lambda: self._channel.send(Kind.SAVE))

    def receive_memories(self) -> list[Memory]:
        """Return the memories that were requested."""
        if self._saved is None:
            self._saved = self._recover(self._receive_saved, again=self.request_memories)
            self._last_memories = self._saved
            self._begin_log()
            self._log.clear()
            self._log_bytes = 0
        return self._saved

    def _receive_saved(self) -> list[Memory]:
        content = self._channel.receive(Kind.SAVED).content
        try:
            return memories.unpack(content, len(self.robots))
        except ValueError as error:
            raise ConnectionLostError(str(error)) from None

    def read(self, robot: int, wanted: int, clock_s: float) -> bytes:
        """Return a host's reply about standard input.

        Args:
            robot: the robot's number.
            wanted: the maximum number of bytes; -1 to ask how much there is.
            clock_s: the program's clock [s].
        """
        question = json.dumps([self.position(robot), wanted, clock_s]).encode()

        def ask() -> bytes:
            self._channel.send(Kind.READ, question)
            return self._channel.receive(Kind.INPUT).content

        return self._recover(ask)

    def position(self, robot: int) -> int:
        """Return the position of a robot among those of this host."""
        return int(np.searchsorted(self.robots, robot))

    # -- the end, and losses ---------------------------------------------------------------------

    def end(self, outcome: Any) -> None:
        """Fetch the programs' memories, and dismiss the host.

        Args:
            outcome: the result of its programs, as JSON.
        """
        if self.ended:
            return
        self.memories()
        self._detach()
        try:
            self._channel.send(Kind.END, json.dumps(outcome).encode())
        except ConnectionLostError:
            pass  # it knows how its programs have ended, or is gone itself
        finally:
            self._channel.close()

    def give_up(self) -> None:
        """Leave the programs in the state in which their memories were last fetched."""
        self._detach()
        self._channel.close()
        self._saved = self._saved or self._last_memories

    def _detach(self) -> None:
        self.ended = True
        if self._rows is not None:
            self._rows.remove(self.number)

    def close(self) -> None:
        """Close the connection; it is not replaced, and who would have done that can be freed."""
        self._channel.close()
        self._replace = _not_replaced

    def _recover(
        self, action: Callable[[], Result], again: Callable[[], object] | None = None
    ) -> Result:
        """Perform an action, and repeat it with another host if this one is lost.

        Args:
            action: the action.
            again: is called first with another host.

        Raises:
            HostGoneError: the programs do not continue.
        """
        while True:
            try:
                return action()
            except ConnectionLostError as error:
                self._reconnect(str(error))
                if again is not None:
                    again()

    def _reconnect(self, reason: str) -> None:
        """Replace the lost host, and bring the new one to the same state."""
        while True:
            self._channel.close()
            self._channel = self._replace(self, reason)
            try:
                self._channel.send(Kind.RESTORE, self._start)
                for number, grant in enumerate(self._log, 1):
                    wanted = self._awaits_answer and number == len(self._log)
                    head = *GRANT.unpack_from(grant)[:2], wanted
                    self._channel.send(Kind.GRANT, GRANT.pack(*head) + grant[GRANT.size :])
            except ConnectionLostError as error:
                reason = str(error)
            else:
                return

    def _begin_log(self) -> None:
        """Begin the log of grants with the current state."""
        self._start = self._restore_message()
        self._max_log_bytes = max(MIN_LOG_BYTES, len(self._start))

    def _restore_message(self) -> bytes:
        """Return the message that brings a host to the current state of the programs."""
        number = 0
        known: Table = np.zeros((len(self.robots), WORDS), np.uint64)
        if self._rows is not None:
            known, number = self._rows.known(self.number), self._rows.last_grant(self.number)
        rows = RESTORE.pack(number, number > 0) + known.tobytes()
        return rows + (memories.pack(self._last_memories) if number else b"")


def _selection(robots: IndexArray) -> slice | IndexArray:
    """Return an index of robots: a slice if they are evenly spaced, which copies nothing."""
    steps = np.diff(robots)
    if steps.size and (steps != steps[0]).any():
        return robots
    step = int(steps[0]) if steps.size else 1
    return slice(int(robots[0]), int(robots[-1]) + 1, step)


_NO_MEMORY: Final = memories.unpack(bytes(8), 1)[0]
