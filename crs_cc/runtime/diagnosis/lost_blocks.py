"""Find the blocks of the heap that a program has neither freed nor can reach any more.

As LeakSanitizer does, every aligned word of the global objects, of the frames of the program's
active functions, and of the blocks that are reached is taken for a pointer, also to the middle of a
block. So what is found is lost; a number that looks like a pointer may hide more. Frames of the
library are left out, for they hold what is left of earlier ones.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
import numpy.typing as npt

from crs_cc.ir.names import in_library
from crs_cc.runtime.diagnosis import heap
from crs_cc.runtime.diagnosis.inspect import StoppedProgram
from crs_cc.runtime.layout import HEADER_SIZE, STACK_TOP, argument_offsets
from crs_cc.runtime.link import HEAP_SYMBOLS
from crs_cc.runtime.sites import CallSite

_WORD: Final = 4


@dataclass(frozen=True, slots=True)
class LostBlocks:
    """The blocks that are lost and were allocated at one place.

    Attributes:
        sizes: their sizes [bytes].
        allocated: the calls that allocated them, the innermost first, without those inside the
            library; empty if unknown, as in unchecked builds.
    """

    sizes: tuple[int, ...]
    allocated: tuple[CallSite, ...]


def lost_blocks(stopped: StoppedProgram) -> tuple[LostBlocks, ...]:
    """Return the blocks that are lost, by place, in the order of their addresses."""
    addresses = stopped.compiled.addresses
    blocks = [each for each in heap.blocks(stopped.memory, addresses) if each.in_use]
    if not blocks:
        return ()
    places: dict[tuple[CallSite, ...], list[int]] = {}
    for block in _unreached(stopped, blocks):
        sites = _calls(stopped, block.allocated)
        if sites or not block.allocated:
            places.setdefault(sites, []).append(block.size)
    return tuple(LostBlocks(tuple(sizes), sites) for sites, sizes in places.items())


def _calls(stopped: StoppedProgram, numbers: Sequence[int]) -> tuple[CallSite, ...]:
    sites = stopped.compiled.call_sites
    calls = (sites[number - 1] for number in numbers if number <= len(sites))
    return tuple(each for each in calls if not in_library(each.location))


def _unreached(stopped: StoppedProgram, blocks: Sequence[heap.Block]) -> Iterator[heap.Block]:
    starts = np.array([each.address for each in blocks])
    ends = starts + np.maximum(1, [each.size for each in blocks])
    is_reached = np.zeros(len(blocks), np.bool_)
    found = _pointed(np.concatenate(list(_roots(stopped))), starts, ends)
    while len(found := found[~is_reached[found]]):
        is_reached[found] = True
        words = [_content(stopped, blocks[number]) for number in found]
        found = _pointed(np.concatenate(words), starts, ends)
    return (block for block, reached in zip(blocks, is_reached, strict=True) if not reached)


def _roots(stopped: StoppedProgram) -> Iterator[npt.NDArray[np.uint32]]:
    heap_start = stopped.compiled.addresses[HEAP_SYMBOLS[0]]
    yield stopped.memory[STACK_TOP:heap_start].view("<u4")
    for each in stopped.stack:
        if not in_library(each.location):
            info = stopped.compiled.info(each.function)
            sizes = [parameter.size for parameter in info.function.parameters]
            end = each.fp + HEADER_SIZE + argument_offsets(sizes)[-1]
            yield stopped.memory[each.fp - info.frame.size : end].view("<u4")


def _content(stopped: StoppedProgram, block: heap.Block) -> npt.NDArray[np.uint32]:
    whole = block.size - block.size % _WORD
    return stopped.memory[block.address : block.address + whole].view("<u4")


def _pointed(
    words: npt.NDArray[np.uint32], starts: npt.NDArray[np.int64], ends: npt.NDArray[np.int64]
) -> npt.NDArray[np.int64]:
    """Return the numbers of the blocks that some of the words point into."""
    near = words[(words >= starts[0]) & (words < ends[-1])].astype(np.int64)
    numbers = np.searchsorted(starts, near, "right") - 1
    return np.unique(numbers[near < ends[numbers]])
