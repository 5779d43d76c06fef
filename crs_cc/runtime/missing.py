"""Names declared with the attribute `weak` that no file defines: their address is 0, as for ld.

The front end accesses such objects and calls such functions through their address only, so that
it is checked like any pointer.

>>> from crs_cc.core.source import Location
>>> from crs_cc.ir.program import Data, Program, Relocation
>>> here = Location("a.c")
>>> hooks = Data("hooks", 8, 4, here, bytes(8), [Relocation(0, "later"), Relocation(4, "now")])
>>> set_addresses_to_zero(Program(data={"hooks": hooks}), {"later"})
>>> hooks.relocations
[Relocation(offset=4, symbol='now', addend=0)]
"""

from __future__ import annotations

from collections.abc import Set as AbstractSet

from crs_cc.ir.instruction import Address, Block, Constant, Load, Move, Store
from crs_cc.ir.program import Data, Program


def set_addresses_to_zero(program: Program, missing: AbstractSet[str]) -> None:
    """Replace the addresses of missing functions and objects in a linked program."""
    if not missing:
        return
    for function in program.functions.values():
        for block in function.blocks:
            _clear_block(block, missing)
    for data in program.data.values():
        if any(each.symbol in missing for each in data.relocations):
            _clear_data(data, missing)


def _clear_block(block: Block, missing: AbstractSet[str]) -> None:
    for position, instruction in enumerate(block.instructions):
        match instruction:
            case Address(location, result, str(name), offset) if name in missing:
                zero = Move(location, result, Constant("i32", offset))
                block.instructions[position] = zero
            case Load(within=str(name)) | Store(within=str(name)) if name in missing:
                instruction.within = None


def _clear_data(data: Data, missing: AbstractSet[str]) -> None:
    assert data.content is not None
    content = bytearray(data.content)
    for each in data.relocations:
        if each.symbol in missing:
            address = each.addend & 0xFFFFFFFF
            content[each.offset : each.offset + 4] = address.to_bytes(4, "little")
    data.content = bytes(content)
    data.relocations = [each for each in data.relocations if each.symbol not in missing]
