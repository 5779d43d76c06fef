"""The kernel that finds and enters changed words, and how Python calls it, see `kernels/main.c`.

Parts of tables are copied into the memory of the kernel and out of it. It is loaded on the first
call, once for each thread.
"""

from __future__ import annotations

import atexit
import functools
import struct
import threading
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Final, NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from crs_cc.runtime.turns import RECORD

if TYPE_CHECKING:
    from crs_cc.runtime.executable import Executable

WORDS: Final = RECORD.itemsize // 8
"""Words of a row of a table."""

ROWS: Final = 1024
"""Rows that the kernel takes at once, as in `kernels/main.c`."""

WORD_BYTES: Final = 8

Words: TypeAlias = npt.NDArray[np.uint64]

Table: TypeAlias = npt.NDArray[np.uint64]
"""A row of `WORDS` words for each program."""

_ADDRESSES, _PACK, _ENTER = range(3)
_ARGUMENTS: Final = tuple(struct.Struct(f"<{1 + count}i") for count in range(4))
_RESULTS: Final = struct.Struct("<7i")
_MOST: Final = ROWS * (1 + WORDS) * WORD_BYTES
"""Of a content [bytes]."""
_ERRORS: Final = (
    "",
    "changes end early",
    "changes of words that are not there",
    "it has changed what is not its own, or a clock goes back",
)


class Rules(NamedTuple):
    """The rules for the words of a row, a number for each: what may change, what is looked for.

    Attributes:
        fixed: the bits that never change.
        most: the greatest value.
        rising: all bits if the value never becomes less, else none.
        wanted: the bits that are looked for.
    """

    fixed: Words
    most: Words
    rising: Words
    wanted: Words


class WordKernel:
    """An instance of the kernel, which takes `ROWS` rows at most at once.

    Attributes:
        known: rows before changes.
        now: the same rows after changes that are to be packed.
    """

    def __init__(self) -> None:
        # Not needed by a run whose programs are all in its process.
        from crs_cc.runtime.kernel_instance import KernelInstance

        instance = KernelInstance(_executable())
        self._memory, self._resume = instance.memory.data, instance.resume
        self._place = int(instance.message[0])
        rules, known, now, content, masks, words, ends = self._call(_ADDRESSES)

        def table(begin: int, rows: int) -> Table:
            end = begin + rows * WORDS * WORD_BYTES
            return instance.memory[begin:end].view(np.uint64).reshape(rows, WORDS)

        self.known, self.now = table(known, ROWS), table(now, ROWS)
        self._table = table(rules, len(Rules._fields))
        self._content, self._masks, self._words = content, masks, words
        self._ends = instance.memory[ends : ends + ROWS * 4].view(np.int32)
        self._rules: Rules | None = None  # in the table

    def pack(self, counts: Sequence[int]) -> list[tuple[bytes, bytes]]:
        """Return how rows differ from those that are known: masks and words of groups of them.

        Args:
            counts: how many rows each group has.
        """
        self._call(_PACK, sum(counts))
        memory, mask, word, row, found = self._memory, self._masks, self._words, 0, []
        for count in counts:
            row += count
            mask_end = mask + count * WORD_BYTES
            word_end = self._words + self._ends.item(row - 1) * WORD_BYTES
            found.append((bytes(memory[mask:mask_end]), bytes(memory[word:word_end])))
            mask, word = mask_end, word_end
        return found

    def enter(self, content: memoryview, rows: int, rules: Rules | None) -> tuple[int, bool]:
        """Enter changes of known rows.

        Args:
            content: the changes; others may follow.
            rows: how many rows they are about.
            rules: what may be changed; everything if None.

        Returns:
            How much of the content is about these rows [bytes], and whether any bit is there that
            the rules want.

        Raises:
            ValueError: the content is not valid, or not allowed.
        """
        if rules is not None and rules is not self._rules:
            self._table[...] = self._rules = rules
        place, size = self._content, min(len(content), _MOST)
        self._memory[place : place + size] = content[:size]
        checks = rules is not None
        error, _, _, used, is_found, *_ = self._call(_ENTER, rows, size // WORD_BYTES, checks)
        if error:
            raise ValueError(_ERRORS[error])
        return used * WORD_BYTES, bool(is_found)

    def _call(self, kind: int, *arguments: int) -> tuple[int, ...]:
        """Run the kernel; return what it says."""
        _ARGUMENTS[len(arguments)].pack_into(self._memory, self._place, kind, *arguments)
        self._resume()
        return _RESULTS.unpack_from(self._memory, self._place)


class _Threads(threading.local):
    """The instance of each thread, made on first use."""

    kernel: WordKernel | None = None


_threads: Final = _Threads()


def word_kernel() -> WordKernel:
    """Return this thread's kernel."""
    found = _threads.kernel
    if found is None:
        found = _threads.kernel = WordKernel()
    return found


@functools.cache
def _executable() -> Executable:
    from crs_cc.toolchain.kernels import build_kernels

    return build_kernels(Path(__file__).parent / "kernels")


@atexit.register
def _release() -> None:
    """Release the instance while wasmtime can still do so."""
    _threads.kernel = None
    _executable.cache_clear()
