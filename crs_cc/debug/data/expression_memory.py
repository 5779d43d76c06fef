"""Scratch memory of an expression, above all addresses of the program."""

from __future__ import annotations

from typing import Final

ALIGN: Final = 16


class EvaluationError(Exception):
    """An expression that cannot be evaluated; the text is the reason."""


class Scratch:
    """A bump allocator.

    >>> scratch = Scratch(0x8000_0000, 64)
    >>> hex(scratch.allocate(5)), hex(scratch.allocate(4))
    ('0x80000000', '0x80000010')
    >>> scratch.write(0x8000_0010, b"abcd")
    >>> scratch.read(0x8000_0011, 2)
    b'bc'
    """

    def __init__(self, start: int, size: int) -> None:
        """Store the first address and the capacity."""
        self._start = start
        self._most = size
        self._bytes = bytearray()

    def __contains__(self, address: int) -> bool:
        return self._start <= address < self._start + self._most

    def allocate(self, size: int) -> int:
        """Return the address of zeroed bytes; raise EvaluationError if the capacity is exceeded."""
        first = -(-len(self._bytes) // ALIGN) * ALIGN
        if first + size > self._most:
            raise EvaluationError("the expression needs too much memory")
        self._bytes.extend(bytes(first + size - len(self._bytes)))
        return self._start + first

    def mark(self) -> int:
        """Return a mark for `release`."""
        return len(self._bytes)

    def release(self, mark: int) -> None:
        """Free all allocations since a mark."""
        del self._bytes[mark:]

    def read(self, address: int, size: int) -> bytes:
        """Return bytes; raise EvaluationError if they are not allocated."""
        at = address - self._start
        self._check(address, at + size)
        return bytes(self._bytes[at : at + size])

    def write(self, address: int, content: bytes) -> None:
        """Change bytes; raise EvaluationError if they are not allocated."""
        at = address - self._start
        self._check(address, at + len(content))
        self._bytes[at : at + len(content)] = content

    def peek(self, address: int, size: int) -> bytes:
        """Return bytes, as many as are allocated."""
        return bytes(self._bytes[max(0, address - self._start) :][:size])

    def _check(self, address: int, end: int) -> None:
        if end > len(self._bytes):
            raise EvaluationError(f"no object at {address:#x}")
