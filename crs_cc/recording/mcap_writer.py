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
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from typing import Final, Protocol

import zstandard

from crs_cc import __version__
from crs_cc.recording.columns import Part
from crs_cc.recording.mcap_records import (
    CHUNK_HEAD,
    HIDDEN,
    MAGIC,
    MESSAGE_HEAD,
    PREFIX,
    SAVED,
    SCHEMA,
    ZSTD,
    ZSTD_NAME,
    Channel,
    Op,
    count_map,
    record,
    text,
    text_map,
)

PROFILE: Final = "crs"
LEVEL: Final = 1  # of zstd: level 3 is 2% smaller and takes twice the time
SMALL_LEVEL: Final = 9  # for seconds of which many are one chunk: 12% smaller
_SMALL: Final = zstandard.ZstdCompressionParameters(
    strategy=zstandard.STRATEGY_LAZY2,
    window_log=18,
    hash_log=15,
    chain_log=15,
    search_log=4,
    min_match=5,
    target_length=16,
    write_content_size=True,
)
"""Of chunks at `SMALL_LEVEL`: as small as at zstd's level 9, in three quarters of the time."""

MAX_CHUNK: Final = 256 * 1024
"""A chunk is cut when it is larger [bytes]."""

BLOCK: Final = 300
"""Messages from this size on [bytes] are separate zstd blocks: each has its own table of byte
frequencies. In one block, those of few robots take 5% more."""

_Pending = tuple[int, int, Channel, bytes]  # log time [ns], order, channel, content

_CHUNK_INDEX: Final = struct.Struct("<QQQQ")
_SIZES: Final = struct.Struct("<QQ")


class Target(Protocol):
    """An output file whose end can be rewritten."""

    def write(self, data: bytes, /) -> object:
        """Write all of the bytes."""

    def seek(self, offset: int, /) -> object:
        """Go to a place, from the start of the file."""

    def truncate(self, size: int, /) -> object:
        """Cut the file off."""


class McapWriter:
    """Writes one file from start to end.

    What is saved is in the file, but not as small as it can be: the next `cut` replaces it. The
    file can be read at each moment in between, so nothing of it is lost when a run is killed.

    Attributes:
        pending: size of the messages that are not in a chunk yet, or only saved [bytes].
    """

    def __init__(self, file: Target) -> None:
        """Write the header; raise OSError if the file cannot be written, as in all methods."""
        self.pending = 0
        self._file = file
        self._at = 0
        self._saved_to = 0  # the end of what is saved, from `_at` on; 0 for nothing
        self._saved = 0  # how many of the pending messages are saved
        self._pending: list[_Pending] = []
        self._numbers: dict[str, int] = {}
        self._schemas: dict[str, bytes] = {}  # by name
        self._channels: dict[int, bytes] = {}
        self._is_described: set[str] = set()  # schemas that are in a chunk
        self._counts: dict[int, int] = {}
        self._indexes: dict[Op, list[bytes]] = {
            Op.CHUNK_INDEX: [], Op.ATTACHMENT_INDEX: [], Op.METADATA_INDEX: []
        }  # fmt: skip
        self._first_ns, self._last_ns = 2**64 - 1, 0
        self._write(MAGIC + record(Op.HEADER, text(PROFILE) + text(f"crs_cc {__version__}")))

    def define(self, channels: Iterable[Channel]) -> None:
        """Define channels before their use, so that their numbers do not depend on timing."""
        for channel in channels:
            self._number(channel)

    def metadata(self, name: str, values: Mapping[str, str]) -> None:
        """Write named strings."""
        written = record(Op.METADATA, text(name) + text_map(values))
        index = struct.pack("<QQ", self._at, len(written)) + text(name)
        self._indexes[Op.METADATA_INDEX].append(index)
        self._write(written)

    def attachment(self, name: str, content: bytes) -> None:
        """Write a file, compressed if that is shorter."""
        media_type = "application/octet-stream"
        level = SMALL_LEVEL if len(content) <= MAX_CHUNK else LEVEL
        packed = zstandard.ZstdCompressor(level=level).compress(content)
        if len(packed) + len(ZSTD_NAME) < len(content):
            name, media_type, content = name + ZSTD_NAME, ZSTD, packed
        times = bytes(16)
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

    def save(self, first_ns: int, last_ns: int, parts: Iterable[Part]) -> None:
        """Write the new data since the last call, to be replaced by the next `cut`.

        Args:
            first_ns: when it begins.
            last_ns: when it ends.
            parts: what is not pending: what replaces it will be added.
        """
        gathered = list(parts)
        size = sum(map(len, gathered))
        head = PREFIX.pack(SAVED, CHUNK_HEAD.size + size)
        written = b"".join([head, CHUNK_HEAD.pack(first_ns, last_ns, size, 0), *gathered])
        if len(self._pending) > self._saved:
            messages = sorted(self._pending[self._saved :], key=lambda each: each[:2])
            content, _ = self._content(messages, dict(self._counts))
            records = b"".join(content)
            written += _chunk(records, "", records, messages)
        end = self._saved_to or self._at
        try:
            self._file.write(written)
        except OSError:
            with suppress(OSError):
                self._file.truncate(end)
            raise
        self._saved_to = end + len(written)
        self._saved = len(self._pending)

    def cut(self, level: int = LEVEL, *, is_whole: bool = False) -> None:
        """Write the messages since the last cut, ordered by time, in chunks of limited size.

        Args:
            level: of compression, `LEVEL` or `SMALL_LEVEL`.
            is_whole: whether they depend on each other: they are one chunk of whatever size.
        """
        messages = sorted(self._pending, key=lambda each: each[:2])
        self._pending, self.pending, self._saved = [], 0, 0
        begin, records, chunk, size = self._at, list[bytes](), list[_Pending](), 0
        for number, each in enumerate(messages, 1):
            chunk.append(each)
            size += len(each[3])
            if (size > MAX_CHUNK and not is_whole) or number == len(messages):
                records.append(self._packed(chunk, begin, level))
                begin += len(records[-1])
                chunk, size = [], 0
        if self._saved_to:
            self._replace(b"".join(records))
        elif records:
            self._write(b"".join(records))

    def finish(self) -> None:
        """Write the rest and the summary."""
        self.cut()
        self._write(record(Op.DATA_END, struct.pack("<I", 0)))
        indexes = (record(op, row) for op, rows in self._indexes.items() for row in rows)
        statistics = record(Op.STATISTICS, self._statistics())
        schemas = [data for name, data in self._schemas.items() if name in self._is_described]
        channels = [data for number, data in self._channels.items() if self._counts[number]]
        parts = [*schemas, *channels, statistics, *indexes]
        start, summary = self._at, b"".join(parts)
        head = PREFIX.pack(Op.FOOTER, 20) + struct.pack("<QQ", start, 0)  # 0: no summary offsets
        crc = zlib.crc32(summary + head)
        self._write(summary + head + struct.pack("<I", crc) + MAGIC)

    def _number(self, channel: Channel) -> int:
        """Return the number of a channel, which is defined if it is new."""
        number = self._numbers.get(channel.topic)
        if number is not None:
            return number
        number, schema = len(self._numbers) + 1, 0
        if channel.schema:
            schema = self._schema(channel)
        body = struct.pack("<HH", number, schema) + text(channel.topic) + text(channel.encoding)
        named = {SCHEMA: channel.schema} if channel.names_schema else {}
        self._channels[number] = record(Op.CHANNEL, body + text_map(named))
        self._numbers[channel.topic] = number
        self._counts[number] = 0
        return number

    def _schema(self, channel: Channel) -> int:
        """Return the number of a channel's schema, which is defined if it is new."""
        if channel.schema not in self._schemas:
            body = struct.pack("<H", len(self._schemas) + 1)
            body += text(channel.schema) + text(channel.schema_encoding)
            body += struct.pack("<I", len(channel.schema_data)) + channel.schema_data
            self._schemas[channel.schema] = record(Op.SCHEMA, body)
        return list(self._schemas).index(channel.schema) + 1

    def _content(
        self, messages: Sequence[_Pending], counts: dict[int, int]
    ) -> tuple[list[bytes], dict[int, list[bytes]]]:
        """Return the parts of a chunk, and for each channel the rows of its index.

        The channels are defined in each chunk, so that none depends on another one.

        Args:
            messages: the messages, by time.
            counts: how many messages each channel has, which is updated.
        """
        parts, index, at = list[bytes](), dict[int, list[bytes]](), 0
        described = {"", *self._is_described}
        for time_ns, _, channel, data in messages:
            number = self._number(channel)
            if number not in index:
                index[number] = []
                is_new = channel.schema not in described
                described.add(channel.schema)
                schema = self._schemas[channel.schema] if is_new else b""
                parts.append(schema + self._channels[number])
                at += len(parts[-1])
            sequence = counts.get(number, 0)
            counts[number] = sequence + 1
            index[number].append(_SIZES.pack(time_ns, at))
            parts.append(
                PREFIX.pack(Op.MESSAGE, MESSAGE_HEAD.size + len(data))
                + MESSAGE_HEAD.pack(number, sequence & 0xFFFFFFFF, time_ns, time_ns)
                + data
            )
            at += len(parts[-1])
        return parts, index

    def _packed(self, messages: list[_Pending], at: int, level: int) -> bytes:
        """Return messages as a chunk with its indexes, for a place in the file."""
        parts, index = self._content(messages, self._counts)
        self._is_described.update(channel.schema for _, _, channel, _ in messages)
        content, packed = b"".join(parts), _compressed(parts, _compressor(level))
        chunk = _chunk(content, "zstd", packed, messages)
        offsets, rows, end = dict[int, int](), list[bytes](), at + len(chunk)
        for number, places in index.items():
            offsets[number] = end
            entries = b"".join(places)
            row = struct.pack("<HI", number, len(entries)) + entries
            rows.append(record(Op.MESSAGE_INDEX, row))
            end += len(rows[-1])
        first_ns, last_ns = messages[0][0], messages[-1][0]
        self._first_ns, self._last_ns = min(self._first_ns, first_ns), max(self._last_ns, last_ns)
        self._indexes[Op.CHUNK_INDEX].append(
            _CHUNK_INDEX.pack(first_ns, last_ns, at, len(chunk))
            + count_map(offsets)
            + struct.pack("<Q", end - at - len(chunk))
            + text("zstd")
            + _SIZES.pack(len(packed), len(content))
        )
        return b"".join([chunk, *rows])

    def _replace(self, records: bytes) -> None:
        """Replace the saved data by records, so that the file is valid at any time.

        They are first written behind it, hidden in a record that readers skip. Then 9 bytes at the
        place hide what is saved and show them; there they are copied to the place, while hidden,
        until another 9 bytes show the copy.
        """
        begin, end, head = self._at, self._saved_to, PREFIX.size
        place = max(end + head, begin + len(records) + head)  # of the first copy
        hidden = PREFIX.pack(HIDDEN, place - end - head + len(records))
        try:
            self._file.write(hidden + bytes(place - end - head) + records)
        except OSError:
            with suppress(OSError):
                self._file.truncate(end)
            raise
        self._write_at(begin, PREFIX.pack(HIDDEN, place - begin - head))
        after = begin + len(records)
        rest = PREFIX.pack(HIDDEN, place + len(records) - after - head)
        self._write_at(begin + head, records[head:] + rest)
        self._write_at(begin, records[:head])
        self._file.truncate(after)
        self._file.seek(after)
        self._at, self._saved_to = after, 0

    def _write_at(self, at: int, data: bytes) -> None:
        self._file.seek(at)
        self._file.write(data)

    def _statistics(self) -> bytes:
        first_ns = min(self._first_ns, self._last_ns)
        used = {number: count for number, count in self._counts.items() if count}
        counts = (
            len(self._is_described - {""}),
            len(used),
            len(self._indexes[Op.ATTACHMENT_INDEX]),
            len(self._indexes[Op.METADATA_INDEX]),
            len(self._indexes[Op.CHUNK_INDEX]),
        )
        total = sum(used.values())
        head = struct.pack("<QHIIIIQQ", total, *counts, first_ns, self._last_ns)
        return head + count_map(used)

    def _write(self, data: bytes) -> None:
        self._file.write(data)
        self._at += len(data)


def _compressor(level: int) -> zstandard.ZstdCompressor:
    if level == SMALL_LEVEL:
        return zstandard.ZstdCompressor(compression_params=_SMALL)
    return zstandard.ZstdCompressor(level=level, write_content_size=True)


def _compressed(parts: Sequence[bytes], compressor: zstandard.ZstdCompressor) -> bytes:
    """Return parts as one frame of zstd, in which the statistics of one do not spoil another's."""
    stream = compressor.compressobj(size=sum(map(len, parts)))
    packed = []
    for part in parts:
        packed.append(stream.compress(part))
        if len(part) >= BLOCK:
            packed.append(stream.flush(zstandard.COMPRESSOBJ_FLUSH_BLOCK))
    return b"".join([*packed, stream.flush()])


def _chunk(content: bytes, compression: str, packed: bytes, messages: Sequence[_Pending]) -> bytes:
    """Return a chunk of messages: its record."""
    head = CHUNK_HEAD.pack(messages[0][0], messages[-1][0], len(content), zlib.crc32(content))
    body = head + text(compression) + struct.pack("<Q", len(packed)) + packed
    return record(Op.CHUNK, body)
