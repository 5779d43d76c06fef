"""The file of a recording while it is written: a block that grows, and chunks that are complete.

Every second of simulated time is written, so a run that is killed loses at most its last second. In
a small world, a second has so little data that most of a chunk would be its header and index. So it
is saved as it is, and the data of up to two minutes is then replaced by one chunk. If the disk is
full, the recording ends and the run continues.
"""

from __future__ import annotations

import os
import stat
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any, BinaryIO, Final

from crs_cc.recording import topics
from crs_cc.recording.block import Block, Encoded
from crs_cc.recording.entries import SPAN_NS
from crs_cc.recording.frame_buffer import Shape
from crs_cc.recording.mcap_records import NS, Channel, ns
from crs_cc.recording.mcap_writer import LEVEL, MAX_CHUNK, SMALL_LEVEL, McapWriter
from crs_cc.recording.readings import ReadingEncoder

BLOCK_S: Final = SPAN_NS / NS
"""The maximum simulated time in a chunk: longer ones would save little. The data of each second is
saved before that, so that a killed run loses no more."""

MAX_ROWS: Final = 20_000
"""Limit of the readings that are collected before they are encoded; some megabytes."""


class RecordingFile:
    """A recording that is written.

    Attributes:
        failed: the error that ended it, if any.
        written_s: the time up to which the run has been written [s].
        block: the data that was collected since the last chunk.
    """

    def __init__(
        self, path: Path, run: Mapping[str, str], attachments: Mapping[str, bytes]
    ) -> None:
        """Create the file, see `Recorder`.

        Raises:
            OSError: it cannot be written.
        """
        self.failed: OSError | None = None
        self.written_s = 0.0
        self.block = Block(0.0, Shape(0, 0, has_turret=False))
        self._file: BinaryIO = path.open("wb", buffering=0)
        self._writer = McapWriter(_UnbufferedFile(self._file))
        self._writer.define(topics.TOPICS.values())
        self._writer.metadata(topics.RUN, run)
        for name, content in attachments.items():
            self._writer.attachment(name, content)
        self._can_save = stat.S_ISREG(os.fstat(self._file.fileno()).st_mode)
        self._encoder = ReadingEncoder()

    def add(self, channel: Channel, time_ns: int, data: bytes) -> None:
        """Add a message directly, not to the block."""
        self._writer.add(channel, time_ns, data)

    def metadata(self, name: str, values: Mapping[str, str]) -> None:
        """Write named strings."""
        self._try(lambda: self._writer.metadata(name, values))

    def begin_block(self, now_s: float, shape: Shape) -> None:
        """Begin an empty block at a time [s], after those that are complete."""
        self.block = Block(now_s, shape, self.block.frames_after)

    @property
    def is_large(self) -> bool:
        """Whether the block exceeds a limit, and must be written before the second is over."""
        block = self.block
        return (
            block.readings.count > MAX_ROWS
            or block.entries_size > MAX_CHUNK
            or self._writer.pending > MAX_CHUNK
        )

    def flush_early(self, now_s: float) -> None:
        """Write the collected data at a time before the end of a second [s]."""
        if self.block.seconds:  # which may have been saved
            self.complete(now_s)
            return
        self._write(self.block.take(self._encoder))
        if self._writer.pending > MAX_CHUNK:
            self._cut(now_s, LEVEL)

    def end_second(self, now_s: float, second_s: float) -> None:
        """Write the data of a second, given its end and its length [s]."""
        block = self.block
        lasted_s = now_s - block.begin_s
        size = block.size + self._writer.pending
        is_long = lasted_s + second_s > BLOCK_S + 1e-6
        if is_long or not self._can_save or size * (lasted_s + second_s) > MAX_CHUNK * lasted_s:
            self.complete(now_s)
            return
        block.seconds += 1
        begin_ns, now_ns = ns(self.written_s), ns(now_s)
        self._try(lambda: self._writer.save(begin_ns, now_ns, block.take_unsaved().parts()))
        self._note_written(now_s)

    def complete(self, now_s: float) -> None:
        """Encode and write the block, and begin another at a time [s]."""
        block = self.block
        self._write(block.messages(self._encoder))
        level = SMALL_LEVEL if block.seconds else LEVEL
        self.begin_block(now_s, block.shape)
        self._cut(now_s, level, is_whole=block.is_whole)

    def finish(self) -> None:
        """Write the index."""
        self._try(self._writer.finish)

    def close(self) -> None:
        """Close the file."""
        self._file.close()

    def _write(self, messages: Iterable[Encoded]) -> None:
        for message in messages:
            self._writer.add(*message)

    def _cut(self, now_s: float, level: int, *, is_whole: bool = False) -> None:
        self._try(lambda: self._writer.cut(level, is_whole=is_whole))
        self._note_written(now_s)

    def _note_written(self, now_s: float) -> None:
        if self.failed is None:
            self.written_s = now_s

    def _try(self, write: Callable[[], Any]) -> None:
        if self.failed is None:
            try:
                write()
            except OSError as error:
                self.failed = error


class _UnbufferedFile:
    """An unbuffered file, of which each write is complete or raises."""

    def __init__(self, file: BinaryIO) -> None:
        self._file = file

    def write(self, data: bytes) -> int:
        view = memoryview(data)
        while view:
            view = view[self._file.write(view) :]
        return len(data)

    def seek(self, offset: int) -> int:
        return self._file.seek(offset)

    def truncate(self, size: int) -> int:
        return self._file.truncate(size)
