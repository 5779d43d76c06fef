"""Writes MCAP files, chunk by chunk, so that what has been written can be read after a crash.

>>> import io
>>> file = io.BytesIO()
>>> writer = McapWriter(file)
>>> writer.metadata("run", {"seed": "1"})
>>> writer.add(Channel("/log", "json", "Log"), 5, b"{}")
>>> writer.cut()
>>> writer.finish()
>>> file.getvalue().startswith(MAGIC), file.getvalue().endswith(MAGIC)
(True, True)
"""

from __future__ import annotations

import struct
import zlib
from collections.abc import Mapping
from typing import Final, Protocol

import zstandard

from crs_cc import __version__
from crs_cc.recording.mcap_records import (
    CHUNK_HEAD,
    MAGIC,
    MESSAGE_HEAD,
    PREFIX,
    Channel,
    Op,
    count_map,
    record,
    text,
    text_map,
)

PROFILE: Final = "crs"
LEVEL: Final = 1  # of zstd: level 3 is 2 % smaller and takes twice the time

MAX_CHUNK: Final = 256 * 1024
"""A chunk is cut when it is larger [bytes]."""

_Pending = tuple[int, int, Channel, bytes]  # log time [ns], order, channel, content

_CHUNK_INDEX: Final = struct.Struct("<QQQQ")
_SIZES: Final = struct.Struct("<QQ")


class Target(Protocol):
    """What can be written to."""

    def write(self, data: bytes, /) -> object:
        """Write all of the bytes."""


class McapWriter:
    """Writes one file from start to end.

    Attributes:
        pending: size of the messages that are not in a chunk yet [bytes].
    """

    def __init__(self, file: Target) -> None:
        """Write the header; raise OSError if the file cannot be written, as in all methods."""
        self.pending = 0
        self._file = file
        self._at = 0
        self._compressor = zstandard.ZstdCompressor(level=LEVEL, write_content_size=True)
        self._pending: list[_Pending] = []
        self._channels: dict[str, int] = {}
        self._definitions: list[bytes] = []  # of schemas and channels, repeated in the summary
        self._counts: dict[int, int] = {}
        self._indexes: dict[Op, list[bytes]] = {
            Op.CHUNK_INDEX: [], Op.ATTACHMENT_INDEX: [], Op.METADATA_INDEX: []
        }  # fmt: skip
        self._schemas = 0
        self._first_ns, self._last_ns = 2**64 - 1, 0
        self._write(MAGIC + record(Op.HEADER, text(PROFILE) + text(f"crs_cc {__version__}")))

    def metadata(self, name: str, values: Mapping[str, str]) -> None:
        """Write named strings."""
        written = record(Op.METADATA, text(name) + text_map(values))
        index = struct.pack("<QQ", self._at, len(written)) + text(name)
        self._indexes[Op.METADATA_INDEX].append(index)
        self._write(written)

    def attachment(self, name: str, media_type: str, content: bytes, time_ns: int = 0) -> None:
        """Write a file."""
        times = struct.pack("<QQ", time_ns, 0)
        body = times + text(name) + text(media_type) + struct.pack("<Q", len(content)) + content
        written = record(Op.ATTACHMENT, body + struct.pack("<I", zlib.crc32(body)))
        index = struct.pack("<QQ", self._at, len(written)) + times
        index += struct.pack("<Q", len(content)) + text(name) + text(media_type)
        self._indexes[Op.ATTACHMENT_INDEX].append(index)
        self._write(written)

    def add(self, channel: Channel, time_ns: int, data: bytes) -> None:
        """Add a message to the next chunk."""
        self._pending.append((time_ns, len(self._pending), channel, data))
        self.pending += len(data)

    def cut(self) -> None:
        """Write the messages since the last cut, ordered by time, in chunks of limited size."""
        messages = sorted(self._pending, key=lambda each: each[:2])
        self._pending, self.pending = [], 0
        chunk, size = list[_Pending](), 0
        for each in messages:
            chunk.append(each)
            size += len(each[3])
            if size > MAX_CHUNK:
                self._write_messages(chunk)
                chunk, size = [], 0
        if chunk:
            self._write_messages(chunk)

    def finish(self) -> None:
        """Write the rest and the summary."""
        self.cut()
        self._write(record(Op.DATA_END, struct.pack("<I", 0)))
        start, parts, offsets = self._at, list[bytes](), list[bytes]()
        groups = [
            (Op.SCHEMA, [each for each in self._definitions if each[0] == Op.SCHEMA]),
            (Op.CHANNEL, [each for each in self._definitions if each[0] == Op.CHANNEL]),
            (Op.STATISTICS, [record(Op.STATISTICS, self._statistics())]),
            *((op, [record(op, each) for each in rows]) for op, rows in self._indexes.items()),
        ]
        at = start
        for op, rows in groups:
            length = sum(map(len, rows))
            if rows:
                parts += rows
                offset = struct.pack("<BQQ", op, at, length)
                offsets.append(record(Op.SUMMARY_OFFSET, offset))
            at += length
        summary = b"".join(parts + offsets)
        head = PREFIX.pack(Op.FOOTER, 20) + struct.pack("<QQ", start, at if offsets else 0)
        crc = zlib.crc32(summary + head)
        self._write(summary + head + struct.pack("<I", crc) + MAGIC)

    def _define(self, channel: Channel, content: bytearray) -> int:
        """Add a channel and its schema to a chunk; return its number."""
        schema = 0
        if channel.schema_encoding:
            self._schemas += 1
            schema = self._schemas
            body = struct.pack("<H", schema) + text(channel.schema) + text(channel.schema_encoding)
            body += struct.pack("<I", len(channel.schema_data)) + channel.schema_data
            self._definitions.append(record(Op.SCHEMA, body))
            content += self._definitions[-1]
        number = len(self._channels) + 1
        body = struct.pack("<HH", number, schema) + text(channel.topic) + text(channel.encoding)
        named = {} if schema else {"schema": channel.schema}
        self._definitions.append(record(Op.CHANNEL, body + text_map(named)))
        content += self._definitions[-1]
        self._channels[channel.topic] = number
        self._counts[number] = 0
        return number

    def _write_messages(self, messages: list[_Pending]) -> None:
        """Write messages as a chunk."""
        content, index = bytearray(), dict[int, list[tuple[int, int]]]()
        for time_ns, _, channel, data in messages:
            number = self._channels.get(channel.topic)
            if number is None:
                number = self._define(channel, content)
            sequence = self._counts[number]
            self._counts[number] = sequence + 1
            index.setdefault(number, []).append((time_ns, len(content)))
            content += PREFIX.pack(Op.MESSAGE, MESSAGE_HEAD.size + len(data))
            content += MESSAGE_HEAD.pack(number, sequence & 0xFFFFFFFF, time_ns, time_ns)
            content += data
        self._write_chunk(bytes(content), messages[0][0], messages[-1][0], index)

    def _write_chunk(
        self, content: bytes, first_ns: int, last_ns: int, index: dict[int, list[tuple[int, int]]]
    ) -> None:
        packed = self._compressor.compress(content)
        head = CHUNK_HEAD.pack(first_ns, last_ns, len(content), zlib.crc32(content))
        body = head + text("zstd") + struct.pack("<Q", len(packed)) + packed
        chunk, at = record(Op.CHUNK, body), self._at
        offsets, rows, end = dict[int, int](), list[bytes](), at + len(chunk)
        for number, places in index.items():
            offsets[number] = end
            entries = b"".join(struct.pack("<QQ", *place) for place in places)
            row = struct.pack("<HI", number, len(entries)) + entries
            rows.append(record(Op.MESSAGE_INDEX, row))
            end += len(rows[-1])
        self._write(b"".join([chunk, *rows]))
        self._first_ns, self._last_ns = min(self._first_ns, first_ns), max(self._last_ns, last_ns)
        self._indexes[Op.CHUNK_INDEX].append(
            _CHUNK_INDEX.pack(first_ns, last_ns, at, len(chunk))
            + count_map(offsets)
            + struct.pack("<Q", end - at - len(chunk))
            + text("zstd")
            + _SIZES.pack(len(packed), len(content))
        )

    def _statistics(self) -> bytes:
        first_ns = min(self._first_ns, self._last_ns)
        counts = (
            self._schemas,
            len(self._channels),
            len(self._indexes[Op.ATTACHMENT_INDEX]),
            len(self._indexes[Op.METADATA_INDEX]),
            len(self._indexes[Op.CHUNK_INDEX]),
        )
        total = sum(self._counts.values())
        head = struct.pack("<QHIIIIQQ", total, *counts, first_ns, self._last_ns)
        return head + count_map(self._counts)

    def _write(self, data: bytes) -> None:
        self._file.write(data)
        self._at += len(data)
