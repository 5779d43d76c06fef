"""`goto` out of a nested function, to a label that a function around it declares (GNU C).

The outer function calls `setjmp` at its start, for each such label, and the jump is a `longjmp`.
"""

from __future__ import annotations

from typing import Final

from crs_cc.core.source import Location
from crs_cc.frontend.check import tree
from crs_cc.frontend.check.checker import FunctionState
from crs_cc.frontend.check.scope import ObjectSymbol
from crs_cc.frontend.check.tree import Expression
from crs_cc.ir.types import INT, UINT, VOID, ArrayType, PointerType

_BUFFER: Final = ArrayType(UINT, 4)
"""The library's `struct __crs_jump`: activation, place, and two words that `goto` does not need."""

_WORDS: Final = PointerType(UINT)


def nonlocal_goto(state: FunctionState, jump: tree.Goto) -> Expression | None:
    """Return the jump out of a nested function; None if no function around it has the label.

    Only labels that are declared with `__label__` are known before they are reached.
    """
    location, around, inside = jump.location, state.outer, [state]
    while around is not None:
        declared = (
            names[jump.name] for names in reversed(around.label_names) if jump.name in names
        )
        name = next(declared, None)
        if name is not None:
            buffer = _landing(around, name, location)
            for each in inside:
                each.visible.add(buffer)
            operands: list[Expression] = [_word(buffer, index, location) for index in range(2)]
            operands.append(tree.integer(1, INT, location))
            return tree.Intrinsic(VOID, location, "__crs_longjmp", operands)
        inside.append(around)
        around = around.outer
    return None


def _landing(owner: FunctionState, name: str, location: Location) -> ObjectSymbol:
    """Return the buffer for a label."""
    if name not in owner.landings:
        jump = tree.Goto(location, name)
        owner.gotos.append((jump, list(owner.automatics)))
        owner.landings[name] = ObjectSymbol("", _BUFFER, location, in_memory=True), jump
    return owner.landings[name][0]


def _first(buffer: ObjectSymbol, location: Location) -> Expression:
    name = tree.ObjectName(_BUFFER, location, buffer)
    return tree.AddressOf(_WORDS, location, name)


def _word(buffer: ObjectSymbol, index: int, location: Location) -> Expression:
    offset = tree.integer(index, INT, location)
    at = tree.PointerAdd(_WORDS, location, _first(buffer, location), offset)
    return tree.Dereference(UINT, location, at)


def landings(state: FunctionState, location: Location) -> list[tree.Statement]:
    """Return the statements at a function's start to which functions inside it jump."""
    found: list[tree.Statement] = []
    for buffer, jump in state.landings.values():
        operands = [_first(buffer, location)]
        landed = tree.Intrinsic(INT, location, "__crs_setjmp", operands)
        found.append(tree.If(location, landed, [jump], []))
    return found
