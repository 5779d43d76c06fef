"""The value of an expression together with the memory that it depends on."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, TypeAlias

Content: TypeAlias = tuple[bytes, bytes]
"""The bytes of an object, and their `ByteState`s (none in unchecked builds)."""

Span: TypeAlias = tuple[int, int]
"""First address and size of a range of bytes."""


@dataclass(frozen=True, slots=True)
class Observation:
    """The value of an expression, and what it depends on.

    Attributes:
        content: the bytes of the value; none if it cannot be read.
        place: the object that the expression names; None for a computed value.
        reads: what the evaluation has read.
        is_elsewhere: whether it has used objects that the program does not use.
    """

    content: Content
    place: Span | None = None
    reads: tuple[Span, ...] = ()
    is_elsewhere: bool = False


UNREADABLE: Final = Observation((b"", b""))
