"""What has changed in the slots of some programs, as bytes.

Both ends of a connection have a table with a row of 64-bit words for each program: its slot and its
clock. Whoever changes rows sends a mask for each
row, with a bit for each of its words, and the words that are new. So
the used part of a slot crosses and nothing else, and both tables have the same bits afterwards.

>>> here, there = np.zeros((3, WORDS), np.uint64), np.zeros((3, WORDS), np.uint64)
>>> known = here.copy()
>>> here[1, 5], here[2, 0] = 7, 9
>>> content = pack(known, here)
>>> len(content), enter(content, there)
(40, False)
>>> bool((there == here).all()), pack(known, here)  # what has been packed is known
(True, b'')
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from crs_cc.net.word_kernel import ROWS, WORD_BYTES, WORDS, Rules, Table, word_kernel

__all__ = ["WORDS", "Rules", "Table", "enter", "pack", "pack_all"]


def pack(known: Table, now: Table) -> bytes:
    """Return what has changed in a table since the last call, and note it.

    Args:
        known: the table as the other side knows it; becomes equal to `now`.
        now: the table.
    """
    return pack_all([(known, now)])[0]


def pack_all(tables: Sequence[tuple[Table, Table]]) -> list[bytes]:
    """Return what has changed in several tables, see `pack`; several small ones cost as one."""
    found: list[bytes] = []
    together: list[tuple[Table, Table]] = []
    rows = 0
    for known, now in tables:
        if rows + len(known) > ROWS:
            found += _packed(together)
            together, rows = [], 0
        if len(known) > ROWS:
            found.append(_in_parts(known, now))
        else:
            together.append((known, now))
            rows += len(known)
    return found + _packed(together)


def _packed(tables: Sequence[tuple[Table, Table]]) -> list[bytes]:
    """Pack tables that the kernel can take at once."""
    return [masks + words if words else b"" for masks, words in _compared(tables)]


def _in_parts(known: Table, now: Table) -> bytes:
    """Pack a table that is too large for the kernel."""
    parts = [
        _compared([(known[first : first + ROWS], now[first : first + ROWS])])[0]
        for first in range(0, len(known), ROWS)
    ]
    if not any(words for _, words in parts):
        return b""
    return b"".join(masks + words for masks, words in parts)


def _compared(tables: Sequence[tuple[Table, Table]]) -> list[tuple[bytes, bytes]]:
    """Return masks and words of tables that the kernel can take at once, and note them."""
    kernel, last, counts = word_kernel(), 0, []
    for known, now in tables:
        first, last = last, last + len(known)
        kernel.known[first:last], kernel.now[first:last] = known, now
        known[...] = kernel.now[first:last]
        counts.append(len(known))
    return kernel.pack(counts)


def enter(content: bytes, table: Table, rules: Rules | None = None) -> bool:
    """Enter what the other side has changed in its table.

    Args:
        content: the changes.
        table: the table, of as many rows.
        rules: what it may change; everything if None.

    Returns:
        Whether any word that has been sent has a bit that the rules want.

    Raises:
        ValueError: the content does not fit to the table, or is not allowed; nothing is entered.
    """
    if not content:
        return False
    if len(content) % WORD_BYTES:
        raise ValueError("changes end early")
    kernel, rest, has_wanted = word_kernel(), memoryview(content), False
    entered: list[Table] = []
    for first in range(0, len(table), ROWS):
        rows = min(ROWS, len(table) - first)
        kernel.known[:rows] = table[first : first + rows]
        used, is_wanted = kernel.enter(rest, rows, rules)
        has_wanted |= is_wanted
        rest = rest[used:]
        entered.append(kernel.known[:rows] if rows == len(table) else kernel.known[:rows].copy())
    if rest:
        raise ValueError("changes of another size than announced")
    table[...] = entered[0] if len(entered) == 1 else np.concatenate(entered)
    return has_wanted
