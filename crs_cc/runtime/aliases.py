"""The attribute `alias`: every use of another name of a function or object is replaced.

>>> from crs_cc.core.source import Location
>>> from crs_cc.ir.program import Data, Program, Relocation
>>> here = Location("a.c")
>>> table = Data("table", 4, 4, here, bytes(4), [Relocation(0, "other")])
>>> program = Program(data={"table": table}, aliases={"other": "count"})
>>> resolve_aliases(program)
>>> program.data["table"].relocations[0].symbol
'count'
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from crs_cc.ir.instruction import Address, Call, Load, Store
from crs_cc.ir.liveness import all_instructions
from crs_cc.ir.program import Function, Program


def resolve_aliases(program: Program) -> None:
    """Replace the other names in a program whose files are joined."""
    aliases = program.aliases
    if not aliases:
        return
    for function in program.functions.values():
        _rename(function, aliases)
    for data in program.data.values():
        data.relocations = [
            replace(each, symbol=aliases.get(each.symbol, each.symbol)) for each in data.relocations
        ]
    for table in (program.starts, program.ends):
        table[:] = [(priority, aliases.get(name, name)) for priority, name in table]
    for name in aliases:
        program.undefined.pop(name, None)


def _rename(function: Function, aliases: Mapping[str, str]) -> None:
    for block in function.blocks:
        for instruction in all_instructions(block):
            match instruction:
                case Load(base=str(name)) | Store(base=str(name)) | Address(base=str(name)):
                    instruction.base = aliases.get(name, name)
                case Call(callee=str(name)):
                    instruction.callee = aliases.get(name, name)
