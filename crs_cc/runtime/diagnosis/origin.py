"""The origins of uninitialised bytes, see `codegen.origins`.

A word that was copied to the same place in a word has the whole number of its origin, and so have
four bytes in a row that were copied together to any address. A single byte has a quarter of it,
which is enough if only one variable or heap block of the program has such a quarter.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Final, TypeAlias

from crs_cc.ir.instruction import Variable
from crs_cc.ir.names import in_library
from crs_cc.runtime.codegen.origins import FIRST_VARIABLE, WORD, part_in, part_of
from crs_cc.runtime.diagnosis.heap import blocks
from crs_cc.runtime.diagnosis.inspect import StoppedProgram
from crs_cc.runtime.link import ROOT
from crs_cc.runtime.sites import CallSite

Origin: TypeAlias = Variable | CallSite
_Parts: TypeAlias = Mapping[int, int]
"""Parts of a number by the addresses of their bytes."""

_SCALAR: Final = 8


def origin_of(stopped: StoppedProgram, address: int, size: int) -> Origin | None:
    """Return the variable, or the call that allocated the block, that bytes come from.

    Args:
        stopped: the program.
        address: the first byte without value.
        size: the number of bytes that were read together.
    """
    known = _known(stopped)
    for parts in _evidence(stopped, address, min(max(size, 1), _SCALAR)):
        found = [number for number in known if parts and _fits(number, parts)]
        if len(found) == 1:
            origin = known[found[0]]
            return None if in_library(origin.location) else origin
    return None


def _known(stopped: StoppedProgram) -> dict[int, Origin]:
    """Return all possible origins by their numbers.

    What the library allocates before `main` has values: the arguments.
    """
    compiled, before_main = stopped.compiled, stopped.program.functions[ROOT].location.file
    known: dict[int, Origin] = dict(enumerate(compiled.origins, FIRST_VARIABLE))
    for block in blocks(stopped.memory, compiled.addresses):
        number = next(iter(block.allocated), 0)
        site = compiled.call_sites[number - 1] if number <= len(compiled.call_sites) else None
        if number and site is not None and site.location.file != before_main:
            known[number] = site
    return known


def _evidence(stopped: StoppedProgram, address: int, size: int) -> Iterator[_Parts]:
    """Yield evidence for the number, the strongest first: of a word, of all bytes, of one."""
    first = address & -WORD
    for start in (first, *range(max(0, address - WORD + 1), address + 1)):
        yield _parts(stopped, range(start, start + WORD), whole=True)
    yield _parts(stopped, range(address, address + size))
    yield _parts(stopped, range(address, address + 1))


def _parts(stopped: StoppedProgram, addresses: range, *, whole: bool = False) -> _Parts:
    """Return the parts in the states of some bytes; none if the whole is wanted, and one lacks."""
    states = stopped.shadow[addresses.start : addresses.stop].tolist()
    parts = {at: part_in(state) for at, state in zip(addresses, states, strict=False)}
    found = {at: part for at, part in parts.items() if part is not None}
    return {} if (whole and len(found) < WORD) or not any(found.values()) else found


def _fits(number: int, parts: _Parts) -> bool:
    """Return whether bytes may come from an origin, in one copy to some place in a word."""
    return any(
        all(part_of(number, (at - shift) % WORD) == part for at, part in parts.items())
        for shift in range(WORD)
    )
