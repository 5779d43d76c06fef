"""What has changed in the slots of some programs, as bytes.

Both ends of a connection have a table with a row of 64-bit words for each program: its slot and its
clock. Whoever changes rows sends a bit for each word of the table, and the words that are new. So
the used part of a slot crosses and nothing else, and both tables have the same bits afterwards.

>>> here, there = np.zeros((3, WORDS), np.uint64), np.zeros((3, WORDS), np.uint64)
>>> known = here.copy()
>>> here[1, 5], here[2, 0] = 7, 9
>>> content = pack(known, here)
>>> changes = unpack(content, len(there))
>>> len(content), changes.places.tolist(), changes.words.tolist()
(37, [61, 112], [7, 9])
>>> changes.enter(there)
>>> bool((there == here).all()), pack(known, here)  # what has been packed is known
(True, b'')
"""

from __future__ import annotations

from typing import Final, NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import IndexArray
from crs_cc.runtime.turns import RECORD

WORDS: Final = RECORD.itemsize // 8
"""Words of a row."""

Words: TypeAlias = npt.NDArray[np.uint64]

Table: TypeAlias = npt.NDArray[np.uint64]
"""A row of `WORDS` words for each program."""

_WORD: Final = np.dtype("<u8")


class Changes(NamedTuple):
    """Words of a table that have changed.

    Attributes:
        places: their numbers in the table, counted through all rows, in order.
        words: the words.
    """

    places: IndexArray
    words: Words

    def enter(self, table: Table) -> None:
        """Enter them into a table of as many rows."""
        table.put(self.places, self.words)


_NOTHING: Final = Changes(np.zeros(0, np.intp), np.zeros(0, np.uint64))


def pack(known: Table, now: Table) -> bytes:
    """Return what has changed in a table since the last call, and note it.

    Args:
        known: the table as the other side knows it; becomes equal to `now`.
        now: the table.
    """
    changed = known != now
    words = now[changed]
    if not words.size:
        return b""
    known[...] = now
    return b"".join((np.packbits(changed, bitorder="little").tobytes(), words.tobytes()))


def unpack(content: bytes, rows: int) -> Changes:
    """Return what the other side has changed in its table of a number of rows.

    Raises:
        ValueError: the content does not fit to the table.
    """
    if not content:
        return _NOTHING
    count = rows * WORDS
    words_at = -(-count // 8)
    if len(content) < words_at or (len(content) - words_at) % _WORD.itemsize:
        raise ValueError("changes end early")
    packed = np.frombuffer(content, np.uint8, words_at)
    bits = np.unpackbits(packed, count=count, bitorder="little")
    places, words = bits.view(np.bool_).nonzero()[0], np.frombuffer(content, _WORD, offset=words_at)
    if len(places) != len(words):
        raise ValueError("changes of another size than declared")
    return Changes(places, words)
