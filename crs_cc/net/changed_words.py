"""Encoding of the words that have changed in the slots of programs.

Both ends of a connection have the same table, with a row of 64-bit words for each program: its slot
and its clock. Changes are a mask for each row, with a bit for each of its words, followed by the
words that have changed. So only the used part of a slot is sent, and both tables have the same bits
afterwards.

>>> here, there = KnownRows(3), KnownRows(3)
>>> table = np.zeros((3, WORDS), np.uint64)
>>> table[1, 5], table[2, 0] = 7, 9
>>> content = here.pack(table)
>>> len(content), there.enter(content)
(40, False)
>>> bool((there.table() == table).all()), here.pack(table)  # what has been packed is known
(True, b'')
"""

from __future__ import annotations

import numpy as np

from crs_cc.net.word_kernel import ROWS, WORD_BYTES, WORDS, Rules, Table, WordKernel

__all__ = ["WORDS", "KnownRows", "Rules", "Table"]


class KnownRows:
    """The rows as both ends of a connection know them, in the memories of kernels.

    Attributes:
        kernels: the kernels, each with `ROWS` rows at most.
    """

    def __init__(self, rows: int, kernel: WordKernel | None = None) -> None:
        """Create rows of zeros.

        Args:
            rows: the number of rows.
            kernel: a kernel for all rows; by default new ones.
        """
        counts = [min(ROWS, rows - first) for first in range(0, rows, ROWS)]
        self.kernels = [WordKernel(count) for count in counts] if kernel is None else [kernel]
        self._parts = list(zip(self.kernels, counts, strict=True))

    def table(self) -> Table:
        """Return the rows; those of one kernel are a view."""
        tables = [kernel.known[:count] for kernel, count in self._parts]
        return tables[0] if len(tables) == 1 else np.concatenate(tables)

    def set(self, table: Table) -> None:
        """Set all rows to those of a table, which the other side has, too."""
        first = 0
        for kernel, count in self._parts:
            kernel.known[:count] = table[first : first + count]
            first += count

    def pack(self, table: Table) -> bytes:
        """Return the words of a table that differ from the known ones, and update the latter."""
        if len(self._parts) == 1:
            [(kernel, count)] = self._parts
            kernel.now[:count] = table
            return kernel.pack(count)
        packed, first = [], 0
        for kernel, count in self._parts:
            kernel.now[:count] = table[first : first + count]
            packed.append(kernel.pack(count))
            first += count
        if not any(packed):
            return b""
        # The masks of a part in which nothing has changed say so.
        counts = [count for _, count in self._parts]
        return b"".join(
            part or bytes(count * WORD_BYTES) for part, count in zip(packed, counts, strict=True)
        )

    def enter(self, content: bytes | memoryview, rules: Rules | None = None) -> bool:
        """Apply the changes of the other side.

        Args:
            content: the changes.
            rules: the permitted changes; all if None.

        Returns:
            Whether any changed word has a bit that the rules look for.

        Raises:
            ValueError: the content is invalid, or a change not permitted; nothing is applied.
        """
        if not content:
            return False
        if len(content) % WORD_BYTES:
            raise ValueError("changes end early")
        rest, has_wanted = memoryview(content), False
        if len(self._parts) == 1:
            [(kernel, count)] = self._parts
            return kernel.enter_all(rest, count, rules)
        for kernel, count in self._parts:
            used, is_wanted = kernel.check(rest, count, rules)
            has_wanted |= is_wanted
            rest = rest[used:]
        if rest:
            raise ValueError("changes of a size other than announced")
        for kernel, count in self._parts:
            kernel.enter(count)
        return has_wanted
