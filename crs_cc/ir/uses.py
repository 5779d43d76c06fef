"""The functions and objects that a function uses by name."""

from __future__ import annotations

from typing import Literal, TypeAlias

from crs_cc.core.source import Location
from crs_cc.ir.instruction import Address, Call, Load, Store
from crs_cc.ir.liveness import all_instructions
from crs_cc.ir.program import Function
from crs_cc.ir.remembered import remembered

Use: TypeAlias = tuple[str, Literal["call", "access", "address"]]
"""A name, and what is done with it: to take its address is allowed for functions and objects."""


@remembered
def uses(function: Function) -> dict[Use, Location]:
    """Return all uses of names in a function, in order, and where each comes first."""
    found: dict[Use, Location] = {}
    for block in function.blocks:
        for instruction in all_instructions(block):
            match instruction:
                case Load(base=str(name)) | Store(base=str(name)):
                    found.setdefault((name, "access"), instruction.location)
                case Address(base=str(name)):
                    found.setdefault((name, "address"), instruction.location)
                case Call(callee=str(name)):
                    found.setdefault((name, "call"), instruction.location)
    return found
