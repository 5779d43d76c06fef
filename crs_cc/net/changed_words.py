"""What has changed in the slots of some programs, as bytes.

Both ends of a connection have a table with a row of 64-bit words for each program: its slot and its
clock. Whoever changes rows sends the words that are new, with a bit for each word that is sent. So
the used part of a slot crosses and nothing else, and both tables have the same bits afterwards.

>>> here, there = np.zeros((3, 56), np.uint64), np.zeros((3, 56), np.uint64)
>>> known = here.copy()
>>> here[1, 5], here[2, 0] = 7, 9
>>> content = pack(known, here)
>>> len(content), apply(content, there).tolist(), bool((there == here).all())
(42, [1, 2], True)
>>> pack(known, here) == pack(known, known)  # what has been packed is known
True
"""

from __future__ import annotations

import struct
from typing import Final, TypeAlias

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import IndexArray
from crs_cc.runtime.turns import RECORD

WORDS: Final = RECORD.itemsize // 8
"""Words of a row."""

Table: TypeAlias = npt.NDArray[np.uint64]
"""A row of `WORDS` words for each program."""

_COUNT: Final = struct.Struct("<I")
_MASK_BYTES: Final = WORDS // 8
_ROW: Final = np.dtype("<u4")
_WORD: Final = np.dtype("<u8")


def pack(known: Table, now: Table) -> bytes:
    """Return what has changed in a table since the last call, and note it.

    Args:
        known: the table as the other side knows it; becomes equal to `now`.
        now: the table.
    """
    changed = known != now
    rows = changed.any(axis=1).nonzero()[0]
    if not rows.size:
        return _COUNT.pack(0)
    changed, words = changed[rows], now[rows]
    known[rows] = words
    masks = np.packbits(changed, axis=1, bitorder="little")
    parts = _COUNT.pack(len(rows)), rows.astype(_ROW).tobytes(), masks.tobytes()
    return b"".join((*parts, words[changed].tobytes()))


def apply(content: bytes, table: Table) -> IndexArray:
    """Change a table as the other side has changed its own; return the rows.

    Raises:
        ValueError: the content does not fit to the table, which is unchanged then.
    """
    rows, masks, words = _parts(content, len(table))
    if rows.size:
        found = table[rows]
        found[masks] = words
        table[rows] = found
    return rows


def _parts(
    content: bytes, count: int
) -> tuple[IndexArray, npt.NDArray[np.bool_], npt.NDArray[np.uint64]]:
    if len(content) < _COUNT.size:
        raise ValueError("changes end early")
    (changed,) = _COUNT.unpack_from(content)
    masks_at = _COUNT.size + changed * _ROW.itemsize
    words_at = masks_at + changed * _MASK_BYTES
    if changed > count or words_at > len(content):
        raise ValueError("changes of more programs than there are")
    rows = np.frombuffer(content, _ROW, changed, _COUNT.size).astype(np.intp)
    packed = np.frombuffer(content, np.uint8, words_at - masks_at, masks_at)
    bits = np.unpackbits(packed.reshape(changed, _MASK_BYTES), axis=1, bitorder="little")
    masks = bits.view(np.bool_)
    if changed and (rows[-1] >= count or (rows[1:] <= rows[:-1]).any()):
        raise ValueError("changes of programs that are not there")
    if len(content) - words_at != int(np.count_nonzero(masks)) * _WORD.itemsize:
        raise ValueError("changes of another size than declared")
    return rows, masks, np.frombuffer(content, _WORD, offset=words_at)
