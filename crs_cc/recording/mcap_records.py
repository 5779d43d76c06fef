"""The records of MCAP, the container format of recordings.

Source: the MCAP specification, version 0, https://mcap.dev/spec. A file is a magic number, records,
and the magic number again; a record is an opcode, the length of its content and the content. All
numbers are little-endian. Messages are in chunks, which are compressed; a summary at the end says
where these are. Both the `mcap` package of Python and `@mcap/core` read what is written here.

>>> record(Op.DATA_END, struct.pack("<I", 0)).hex()
'0f040000000000000000000000'
"""

from __future__ import annotations

import struct
from collections.abc import Mapping
from dataclasses import dataclass
from enum import IntEnum
from typing import Final

MAGIC: Final = b"\x89MCAP0\r\n"
PREFIX: Final = struct.Struct("<BQ")
"""Opcode and length of a record's content."""

MESSAGE_HEAD: Final = struct.Struct("<HIQQ")
"""Channel, sequence number, log time and publish time [ns] of a message."""

CHUNK_HEAD: Final = struct.Struct("<QQQI")
"""First and last log time [ns], size and CRC of the records of a chunk when uncompressed."""

SCHEMA: Final = "schema"
"""What the metadata of a channel call the name of its schema."""

HIDDEN: Final = 0x80
"""The opcode of a record that is skipped: from 0x80 on they belong to applications."""

SAVED: Final = 0x81
"""The opcode of saved data until a chunk replaces it: a chunk's header, and data as in `saved`."""

ZSTD: Final = "application/zstd"
"""The media type of an attachment that is compressed; its name has `ZSTD_NAME` behind it."""

ZSTD_NAME: Final = ".zst"

NS: Final = 1_000_000_000


class Op(IntEnum):
    """The opcodes."""

    HEADER = 0x01
    FOOTER = 0x02
    SCHEMA = 0x03
    CHANNEL = 0x04
    MESSAGE = 0x05
    CHUNK = 0x06
    MESSAGE_INDEX = 0x07
    CHUNK_INDEX = 0x08
    ATTACHMENT = 0x09
    ATTACHMENT_INDEX = 0x0A
    STATISTICS = 0x0B
    METADATA = 0x0C
    METADATA_INDEX = 0x0D
    SUMMARY_OFFSET = 0x0E
    DATA_END = 0x0F


@dataclass(frozen=True, slots=True)
class Channel:
    """A channel of messages.

    Attributes:
        topic: its name, such as `/crs/frame`.
        encoding: of its messages: `json`, or one of ours.
        schema: the name of its schema; empty for none. Channels with the same name share it.
        schema_encoding: of the schema.
        schema_data: the schema.
        names_schema: whether the channel's metadata name it, too: the schema may be in a chunk that
            is lost.
    """

    topic: str
    encoding: str
    schema: str = ""
    schema_encoding: str = ""
    schema_data: bytes = b""
    names_schema: bool = False


@dataclass(frozen=True, slots=True)
class Message:
    """A message.

    Attributes:
        topic: its channel's.
        time_ns: its instant in simulated time.
        data: its content.
    """

    topic: str
    time_ns: int
    data: bytes

    @property
    def time_s(self) -> float:
        """Return its instant [s]."""
        return self.time_ns / NS


ENDLESS_S: Final = 2.0**33
"""No run takes so long."""


def ns(time_s: float) -> int:
    """Return a time as it is in a recording."""
    return max(0, round(time_s * NS))


def record(op: Op, content: bytes) -> bytes:
    """Return a record."""
    return PREFIX.pack(op, len(content)) + content


def text(value: str) -> bytes:
    """Return a string with its length."""
    data = value.encode("utf-8", "replace")
    return struct.pack("<I", len(data)) + data


def text_map(values: Mapping[str, str]) -> bytes:
    """Return a map of strings with its length."""
    content = b"".join(text(key) + text(value) for key, value in values.items())
    return struct.pack("<I", len(content)) + content


def count_map(values: Mapping[int, int]) -> bytes:
    """Return a map from channels to numbers of 64 bits with its length."""
    content = b"".join(struct.pack("<HQ", *item) for item in values.items())
    return struct.pack("<I", len(content)) + content
