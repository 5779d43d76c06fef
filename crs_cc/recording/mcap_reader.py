"""Reads untrusted MCAP files: in bounded memory, and as far as they are intact.

The summary is not used: the records are walked from the start, by their lengths, without reading
chunks and attachments. So an unfinished or damaged file is read like any other, up to the damage.
A chunk is decompressed into at most the size that it declares, which is limited.
"""

from __future__ import annotations

import io
import struct
import zlib
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO, Final

import zstandard

from crs_cc.core.errors import RecordingError
from crs_cc.core.source import Location
from crs_cc.recording.block import saved_messages
from crs_cc.recording.mcap_records import (
    CHUNK_HEAD,
    MAGIC,
    MESSAGE_HEAD,
    PREFIX,
    SAVED,
    SCHEMA,
    ZSTD,
    ZSTD_NAME,
    Message,
    Op,
)

MAX_CHUNK_BYTES: Final = 64 * 2**20
"""Of a chunk when uncompressed: a second of 200,000 robots has half of it."""

MAX_FILE_BYTES: Final = 64 * 2**20
"""Of an attachment, as of a file that is named on the command line."""

MAX_METADATA_BYTES: Final = 16 * 2**20
_MAX_WINDOW: Final = 2**27
_PRIVATE: Final = 0x80  # opcodes of applications, from here on, are skipped
_SKIPPED: Final = frozenset(op for op in Op) - {Op.CHUNK, Op.ATTACHMENT, Op.METADATA}


@dataclass(frozen=True, slots=True)
class FileRange:
    """The position of a record's content in the file.

    Attributes:
        at: its offset.
        size: its length.
    """

    at: int
    size: int


@dataclass(frozen=True, slots=True)
class Chunk:
    """A chunk of messages.

    Attributes:
        extent: its content.
        first_ns: the log time of its first message.
        last_ns: that of its last.
        size: its size when uncompressed.
        crc: of its records when uncompressed, 0 for unknown.
        is_saved: whether it is what a run saved that was killed, see `crs_cc.recording.saved`.
    """

    extent: FileRange
    first_ns: int
    last_ns: int
    size: int
    crc: int
    is_saved: bool = False


class McapReader:
    """The contents of one file.

    Attributes:
        path: the file.
        chunks: the chunks, in the order of the file.
        attachments: files, by name.
        metadata: named strings, by name.
        is_complete: whether the file ends as it should.
        intact_bytes: how much of the file can be read.
        size: the size of the file.
        schemas: the names of the schemas of topics, in the chunks that have been read.
    """

    def __init__(self, path: Path) -> None:
        """Walk through the records of a file.

        Raises:
            RecordingError: it is no MCAP file.
            OSError: it cannot be read.
        """
        self.path = path
        self.chunks: list[Chunk] = []
        self.attachments: dict[str, FileRange] = {}
        self.metadata: dict[str, dict[str, str]] = {}
        self.is_complete = False
        self.intact_bytes = 0
        self.schemas: dict[str, str] = {}
        self._topics: dict[int, str] = {}
        self._file: BinaryIO = path.open("rb")
        try:
            self.size = self._file.seek(0, io.SEEK_END)
            self._file.seek(0)
            self._walk()
        except BaseException:
            self._file.close()
            raise

    def close(self) -> None:
        """Close the file."""
        self._file.close()

    def error(self, text: str, hint: str = "") -> RecordingError:
        """Return an error about the file."""
        return RecordingError.at(Location(str(self.path)), text, hint)

    def attachment(self, name: str) -> bytes:
        """Return the content of an attached file.

        Raises:
            RecordingError: it is missing or damaged.
        """
        extent = self.attachments.get(name)
        if extent is None:
            raise self.error(f"no attachment {name[:80]!r}")
        if extent.size > MAX_FILE_BYTES + 2**16:
            raise self.error(f"the attachment {name[:80]!r} is larger than 64 MiB")
        body = self._read(extent)
        try:
            cursor = _Cursor(body, 16)
            cursor.text()
            is_packed = cursor.text() == ZSTD
            content = cursor.take(cursor.number("<Q"))
            crc = cursor.number("<I")
        except ValueError:
            raise self.error(f"the attachment {name[:80]!r} is damaged") from None
        if crc and crc != zlib.crc32(body[:-4]):
            raise self.error(f"the attachment {name[:80]!r} is damaged (wrong checksum)")
        return self._unpacked(name, content) if is_packed else content

    def _unpacked(self, name: str, packed: bytes) -> bytes:
        """Return the content of a compressed attachment."""
        try:
            source = zstandard.ZstdDecompressor(max_window_size=_MAX_WINDOW).stream_reader(packed)
            content = source.read(MAX_FILE_BYTES + 1)
        except zstandard.ZstdError:
            raise self.error(f"the attachment {name[:80]!r} is damaged") from None
        if len(content) > MAX_FILE_BYTES:
            raise self.error(f"the attachment {name[:80]!r} is larger than 64 MiB")
        return content

    def messages(self, chunk: Chunk) -> Iterator[Message]:
        """Yield the messages in a chunk; raise RecordingError if it is damaged."""
        try:
            if chunk.is_saved:
                yield from self._saved(chunk)
            else:
                yield from self._messages(self._content(chunk))
        except (ValueError, struct.error, zstandard.ZstdError) as wrong:
            text = f"the chunk at byte {chunk.extent.at} is damaged: {wrong}"
            raise self.error(text, "crs replay --recover writes what can be read") from None

    def _saved(self, chunk: Chunk) -> Iterator[Message]:
        if chunk.extent.size > MAX_CHUNK_BYTES:
            raise ValueError(f"it has {chunk.extent.size} bytes (at most {MAX_CHUNK_BYTES})")
        content = self._read(chunk.extent)[CHUNK_HEAD.size :]
        for channel, time_ns, data in saved_messages(content):
            yield Message(channel.topic, time_ns, data)

    def raw(self, extent: FileRange) -> bytes:
        """Return the content of a record."""
        return self._read(extent)

    def _messages(self, content: bytes) -> Iterator[Message]:
        at = 0
        while at < len(content):
            op, size = PREFIX.unpack_from(content, at)
            at += PREFIX.size
            if size > len(content) - at:
                raise ValueError("a record is longer than the chunk")
            if op == Op.MESSAGE:
                channel, _, time_ns, _ = MESSAGE_HEAD.unpack_from(content[at : at + size])
                topic = self._topics.get(channel)
                if topic is not None:
                    data = content[at + MESSAGE_HEAD.size : at + size]
                    yield Message(topic, time_ns, data)
            elif op == Op.CHANNEL:
                cursor = _Cursor(content[at : at + size], 0)
                number = cursor.number("<H")
                cursor.number("<H")
                self._topics[number] = cursor.text()
                cursor.text()
                self.schemas[self._topics[number]] = cursor.text_map().get(SCHEMA, "")
            at += size

    def _content(self, chunk: Chunk) -> bytes:
        cursor = _Cursor(self._read(chunk.extent), CHUNK_HEAD.size)
        compression = cursor.text()
        packed = cursor.take(cursor.number("<Q"))
        if chunk.size > MAX_CHUNK_BYTES:
            raise ValueError(f"it has {chunk.size} bytes (at most {MAX_CHUNK_BYTES})")
        if compression == "zstd":
            source = zstandard.ZstdDecompressor(max_window_size=_MAX_WINDOW).stream_reader(packed)
            content = source.read(chunk.size)
            if len(content) != chunk.size or source.read(1):
                raise ValueError("its size differs from the declared size")
        elif compression:
            raise ValueError(f"unknown compression {compression[:20]!r}")
        else:
            content = packed
        if chunk.crc and zlib.crc32(content) != chunk.crc:
            raise ValueError("wrong checksum")
        return content

    def _read(self, extent: FileRange) -> bytes:
        self._file.seek(extent.at)
        return self._file.read(extent.size)

    def _walk(self) -> None:
        if self._file.read(len(MAGIC)) != MAGIC:
            raise self.error("not an MCAP file", "a recording is made by crs run --record")
        at = self.intact_bytes = len(MAGIC)
        while True:
            self._file.seek(at)
            head = self._file.read(PREFIX.size)
            if len(head) < PREFIX.size:
                return
            op, size = PREFIX.unpack(head)
            extent = FileRange(at + PREFIX.size, size)
            if size > self.size - extent.at or not self._note(op, extent):
                return
            at = self.intact_bytes = extent.at + size
            if op == Op.FOOTER:
                self.is_complete = (
                    self._file.seek(at) == at and self._file.read(len(MAGIC) + 1) == MAGIC
                )
                return

    def _note(self, op: int, extent: FileRange) -> bool:
        """Note a record; return whether it is intact as far as can be seen."""
        try:
            if op in (Op.CHUNK, SAVED):
                self._note_chunk(extent, is_saved=op == SAVED)
            elif op == Op.ATTACHMENT:
                cursor = _Cursor(self._read(FileRange(extent.at, min(extent.size, 2**16))), 16)
                name = cursor.text()
                is_packed = cursor.text() == ZSTD
                self.attachments[name.removesuffix(ZSTD_NAME) if is_packed else name] = extent
            elif op == Op.METADATA:
                if extent.size > MAX_METADATA_BYTES:
                    return False
                cursor = _Cursor(self._read(extent), 0)
                name = cursor.text()
                self.metadata[name] = cursor.text_map()
            elif op not in _SKIPPED and op < _PRIVATE:
                return False
        except (ValueError, struct.error):
            return False
        return True

    def _note_chunk(self, extent: FileRange, *, is_saved: bool) -> None:
        head = self._read(FileRange(extent.at, CHUNK_HEAD.size))
        first_ns, last_ns, size, crc = CHUNK_HEAD.unpack(head)
        self.chunks.append(Chunk(extent, first_ns, last_ns, size, crc, is_saved))


class _Cursor:
    """Reads a record's fields, and raises ValueError where it is too short."""

    def __init__(self, data: bytes, at: int) -> None:
        self._data = data
        self._at = at

    def take(self, size: int) -> bytes:
        if size > len(self._data) - self._at:
            raise ValueError("a field is longer than its record")
        self._at += size
        return self._data[self._at - size : self._at]

    def number(self, form: str) -> int:
        """Return an unsigned number, in the notation of `struct`."""
        value: int = struct.unpack(form, self.take(struct.calcsize(form)))[0]
        return value

    def text(self) -> str:
        return self.take(self.number("<I")).decode("utf-8", "replace")

    def text_map(self) -> dict[str, str]:
        values = {}
        end = self.number("<I") + self._at
        while self._at < end:
            key = self.text()
            values[key] = self.text()
        return values
