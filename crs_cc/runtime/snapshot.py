"""The state of a program apart from its fleet."""

from __future__ import annotations

from dataclasses import dataclass

from crs_cc.core.arrays import ByteArray, IndexArray, Records


@dataclass(frozen=True, slots=True)
class Snapshot:
    """The whole state of one program, which can be resumed in any fleet of the same program.

    Attributes:
        slot: its slot, one element of dtype `SLOT`.
        chunks: numbers of the non-zero chunks of memory.
        content: those chunks, shape (len(chunks), CHUNK).
        shadow_chunks: the same for the shadow memory; empty in unchecked builds.
        shadow_content: those chunks.
    """

    slot: Records
    chunks: IndexArray
    content: ByteArray
    shadow_chunks: IndexArray
    shadow_content: ByteArray
