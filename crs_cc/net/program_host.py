"""A host: runs the programs of some robots for a remote environment.

It runs programs as granted, see `host_link`. Output of programs is written when the next grant
arrives, so that nothing is written twice when programs continue from an earlier state.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from crs_cc.core.arrays import IndexArray
from crs_cc.net import memories
from crs_cc.net.changed_words import WORDS
from crs_cc.net.channel import HEAD_BYTES, Channel, ConnectionLostError, Kind
from crs_cc.net.error_data import data_of
from crs_cc.net.frames import GRANT
from crs_cc.net.host_link import RESTORE
from crs_cc.net.hosted_programs import HostedPrograms
from crs_cc.net.memories import Memory
from crs_cc.requests import CODES, DATA_SIZE, FAILED
from crs_cc.runtime.fleet import Fleet
from crs_cc.runtime.snapshot import Snapshot
from crs_cc.runtime.turns import RECORD

if TYPE_CHECKING:
    from crs_cc.runtime.executable import Driver, Executable
    from crs_cc.session.host import Input, Output, Waiting

_WRITE: Final = CODES["WRITE"]
_RAN: Final = Kind.RAN


@dataclass(frozen=True, slots=True)
class Streams:
    """The standard streams of the programs of a host.

    Attributes:
        write: receives their output.
        read: returns their input.
        waiting: returns how much of it there is.
    """

    write: Output
    read: Input
    waiting: Waiting


class ProgramHost:
    """The programs of a host, for the lifetime of one connection.

    Attributes:
        shown: the number of the last grant whose output has been written.
    """

    def __init__(
        self,
        executables: Sequence[Executable],
        driver: Driver,
        streams: Streams,
        shown: int = 0,
        threads: int | None = None,
    ) -> None:
        """Load the programs.

        Args:
            executables: one for each robot.
            driver: the module that runs rounds.
            streams: the programs' streams.
            shown: the number of the last grant whose output has already been written.
            threads: how many threads may run programs, see `HostedPrograms`.
        """
        self.shown = shown
        self._streams = streams
        self._programs = HostedPrograms(executables, driver, threads)
        self._writes: list[tuple[int, int, bytes]] = []

    @property
    def fleet(self) -> Fleet:
        """The programs."""
        return self._programs.fleet

    def serve(self, channel: Channel) -> Any:
        """Serve the environment until the run ends; return its final message.

        Raises:
            ConnectionLostError: the environment is gone, or sends an invalid message.
        """
        grant, end = Kind.GRANT, Kind.END
        answers: dict[Kind, Callable[[bytes], tuple[Kind, bytes] | None]] = {
            Kind.RESTORE: self._restore,
            Kind.SAVE: lambda _content: (Kind.SAVED, self._memories()),
            Kind.READ: lambda content: (Kind.INPUT, self._input(content)),
        }
        allowed = grant, end, *answers
        while True:
            buffer = self._programs.buffer
            size = channel.receive_frame(grant, buffer)
            try:
                if size:
                    self._grant(buffer[HEAD_BYTES:size], channel)
                    continue
                kind, content = channel.receive(*allowed)
                if kind is end:
                    return json.loads(content)
                if kind is grant:
                    self._grant(memoryview(content), channel)
                elif (answer := answers[kind](content)) is not None:
                    channel.send(*answer)
            except (ValueError, RecursionError) as error:
                raise ConnectionLostError(
                    f"invalid message from the environment: {error}"
                ) from None

    # -- rounds ----------------------------------------------------------------------------------

    def _grant(self, content: memoryview, channel: Channel) -> None:
        """Run the programs as granted, and answer."""
        if len(content) < GRANT.size:
            raise ValueError("a grant ends early")
        number, _, is_wanted = GRANT.unpack_from(content)
        if number > self.shown:
            self.shown = number
            for robot, stream, text in self._writes:
                self._streams.write(robot, stream, text)
        frame, is_notable = self._programs.run(content)
        self._writes = []
        if is_notable:
            requesting = self._requesting()
            self._writes = self._written(requesting)
            if is_wanted:
                self._report_failures(requesting, channel)
        if is_wanted:
            channel.send_frame(_RAN, frame)

    def _requesting(self) -> IndexArray:
        """Return the programs that make a request."""
        return self.fleet.timing["asks"].nonzero()[0]

    def _written(self, requesting: IndexArray) -> list[tuple[int, int, bytes]]:
        """Return the output requested by programs: robot, stream and content."""
        if not len(requesting):
            return []
        codes = self.fleet.codes[requesting].tolist()
        if _WRITE not in codes:
            return []
        found = []
        for robot, code in zip(requesting.tolist(), codes, strict=True):
            if code != _WRITE or not self.fleet.timing["alive"][robot]:
                continue
            message = self.fleet.slots["message"][robot]
            stream, size = int(message["i"][0]), int(message["size"])
            if stream in (1, 2) and 0 <= size <= DATA_SIZE:
                found.append((robot, stream, message["data"][:size].tobytes()))
        return found

    def _report_failures(self, requesting: IndexArray, channel: Channel) -> None:
        for robot in requesting[self.fleet.slots["status"][requesting] == FAILED].tolist():
            data = data_of(self.fleet.report(robot)) | {"robot": robot}
            channel.send(Kind.FAILED, json.dumps(data).encode())

    # -- state and input -------------------------------------------------------------------------

    def _restore(self, content: bytes) -> None:
        """Bring the programs to the state of those of a lost host."""
        rows_end = RESTORE.size + len(self.fleet) * RECORD.itemsize
        if len(content) < rows_end:
            raise ValueError("the state of programs ends early")
        _number, has_memories = RESTORE.unpack_from(content)
        rows = np.frombuffer(content, np.uint64, len(self.fleet) * WORDS, RESTORE.size)
        rows = rows.reshape(-1, WORDS)
        if has_memories:
            slots = rows.reshape(-1).view(RECORD)["slot"]
            for robot, memory in enumerate(memories.unpack(content[rows_end:], len(self.fleet))):
                self.fleet.restore(robot, Snapshot(slots[robot : robot + 1], *memory))
        self._programs.set(rows)
        self._writes = self._written(self._requesting())

    def _memories(self) -> bytes:
        """Return the programs' memories."""
        snapshots = map(self.fleet.snapshot, range(len(self.fleet)))
        return memories.pack(
            Memory(each.chunks, each.content, each.shadow_chunks, each.shadow_content)
            for each in snapshots
        )

    def _input(self, content: bytes) -> bytes:
        """Return standard input, or how much of it there is as JSON."""
        try:
            robot, wanted, clock_s = json.loads(content)
            robot, wanted = int(robot), int(wanted)
        except TypeError:
            raise ValueError("a question about input is not valid") from None
        if not 0 <= robot < len(self.fleet):
            raise ValueError("input of an unknown robot")
        if wanted >= 0:
            return self._streams.read(robot, min(wanted, DATA_SIZE))
        size, wait_s = self._streams.waiting(robot, float(clock_s))
        return json.dumps([size, None if math.isinf(wait_s) else wait_s]).encode()
