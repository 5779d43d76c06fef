"""Recovers an unfinished or damaged recording: its intact parts are written to a new file."""

from __future__ import annotations

import struct
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from crs_cc.core.errors import RecordingError
from crs_cc.recording.foxglove.messages import known_channel
from crs_cc.recording.mcap_records import NS
from crs_cc.recording.mcap_writer import LEVEL, MAX_CHUNK, SMALL_LEVEL, McapWriter
from crs_cc.recording.topics import TOPICS

if TYPE_CHECKING:
    from crs_cc.recording.recording import Recording


@dataclass(frozen=True, slots=True)
class Recovered:
    """What was found.

    Attributes:
        chunks: chunks that are intact.
        damaged: chunks that are not.
        messages: messages written.
        lost_bytes: bytes at the end that are no whole record.
        end_s: the instant of the last message [s].
    """

    chunks: int
    damaged: int
    messages: int
    lost_bytes: int
    end_s: float


def recover(recording: Recording, target: Path) -> Recovered:
    """Write the intact part of a recording to another file.

    Raises:
        OSError: it cannot be written.
    """
    source = recording.mcap
    chunks = damaged = messages = end_ns = 0
    with target.open("wb") as file:
        writer = McapWriter(file)
        for name, values in source.metadata.items():
            writer.metadata(name, values)
        for name in source.attachments:
            with suppress(RecordingError):
                writer.attachment(name, source.attachment(name))
        for chunk in source.chunks:
            try:
                found = list(source.messages(chunk))
            except (RecordingError, struct.error):
                damaged += 1
                continue
            for message in found:
                channel = TOPICS.get(message.topic) or known_channel(
                    message.topic, source.schemas.get(message.topic, "")
                )
                if channel is not None:
                    writer.add(channel, message.time_ns, message.data)
                    end_ns = max(end_ns, message.time_ns)
                    messages += 1
            if not chunk.is_saved or writer.pending > MAX_CHUNK:
                _cut(writer)
            chunks += 1
        _cut(writer)
        writer.finish()
    lost = source.size - source.intact_bytes
    return Recovered(chunks, damaged, messages, 0 if source.is_complete else lost, end_ns / NS)


def _cut(writer: McapWriter) -> None:
    """Write the pending messages as one chunk, as they may depend on each other."""
    writer.cut(SMALL_LEVEL if writer.pending <= MAX_CHUNK else LEVEL, is_whole=True)
