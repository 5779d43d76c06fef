"""Columns of bytes that grow by whole rows: fast to append to, and compact.

>>> columns = Columns(1, 2)
>>> columns.extend([b"ab", b"1122"])
>>> len(columns), [bytes(each) for each in columns.content()]
(2, [b'ab', b'1122'])
"""

from __future__ import annotations

from collections.abc import Sequence

Part = bytes | memoryview
Parts = Sequence[Part]


class Columns:
    """Some columns with the same number of rows."""

    def __init__(self, *row_bytes: int) -> None:
        """Create columns without rows.

        Args:
            row_bytes: the bytes per row of each column, at least 1.
        """
        self._row_bytes = row_bytes
        self._columns = tuple(bytearray() for _ in row_bytes)

    def __len__(self) -> int:
        """Return the number of rows."""
        return len(self._columns[0]) // self._row_bytes[0]

    def append(self, *parts: bytes) -> None:
        """Add the bytes of the same number of rows to each column."""
        for column, part in zip(self._columns, parts, strict=True):
            column.extend(part)

    def content(self) -> tuple[bytearray, ...]:
        """Return the columns, which must not grow while they are in use."""
        return self._columns

    def extend(self, columns: Parts) -> None:
        """Add rows collected elsewhere; raise ValueError if there is an incomplete row."""
        rows = len(columns[0]) // self._row_bytes[0]
        if [*map(len, columns)] != [rows * size for size in self._row_bytes]:
            raise ValueError("inconsistent columns")
        self.append(*map(bytes, columns))
