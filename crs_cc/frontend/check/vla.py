"""Variable length arrays and variably modified types (C17 6.7.6.2).

The size of such an array type is kept in a hidden variable, the type's extent, which is set where
the type is written. An array variable of such a type is a pointer to memory that the library
allocates (`__crs_automatic`) and frees at the end of the scope; memory from `alloca` is freed at
the end of the function. The library allocates as a stack: it frees everything after a mark.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Final

from crs_cc.core.source import Location
from crs_cc.frontend.check import tree
from crs_cc.frontend.check.checker import Automatic, CheckError, FunctionState, Unit
from crs_cc.frontend.check.conversion import convert, decay, is_integer
from crs_cc.frontend.check.scope import FunctionSymbol, ObjectSymbol
from crs_cc.frontend.check.tree import Expression
from crs_cc.ir.types import (
    CHAR,
    INT,
    LLONG,
    UINT,
    VOID,
    ArrayType,
    CType,
    FunctionType,
    PointerType,
    Record,
    RecordType,
)

_BYTES: Final = PointerType(CHAR)
_ALLOCATE: Final = FunctionType(PointerType(VOID), (UINT, _BYTES))
_RELEASE: Final = FunctionType(VOID, (INT,))
EXTENT: Final = "[size]"
"""The name of extents, for debuggers; it is not a valid identifier in C."""

AUTOMATIC_COUNT: Final = "__crs_automatic_count"
"""The library's counter of allocated blocks."""


def is_variable(ctype: CType) -> bool:
    """Return whether a type is a variable length array, or a struct with one in it."""
    return _extent(ctype) is not None


def _extent(ctype: CType) -> ObjectSymbol | None:
    """Return the variable with the size of a type, if that is variable."""
    found = ctype.record if isinstance(ctype, RecordType) else ctype
    if not isinstance(found, ArrayType | Record) or found.extent is None:
        return None
    assert isinstance(found.extent, ObjectSymbol)
    return found.extent


def size(ctype: CType, location: Location) -> Expression:
    """Return the size of a type as an expression of type `unsigned int`."""
    extent = _extent(ctype)
    if extent is not None:
        return tree.ObjectName(UINT, location, extent)
    return tree.integer(ctype.size, UINT, location)


def array(unit: Unit, element: CType, length: Expression) -> ArrayType:
    """Return a variable length array type, and record the computation of its size.

    Raises:
        CheckError: the length is not an integer, or it is at file scope.
    """
    location = length.location
    if not is_integer(length.type):
        raise CheckError(location, f"size of array has non-integer type '{length.type}'")
    extent = ObjectSymbol(EXTENT, UINT, location)
    if unit.prototypes == 0:
        if unit.function is None:
            raise CheckError(
                location, "variable length array declaration not allowed at file scope"
            )
        operands = [convert(decay(length), LLONG), size(element, location)]
        computed = tree.Intrinsic(UINT, location, "__crs_array_size", operands)
        unit.function.effects.append(set_extent(extent, computed))
    return ArrayType(element, None, extent)


def set_extent(symbol: ObjectSymbol, value: Expression) -> Expression:
    """Return the assignment of a value to a hidden variable."""
    target = tree.ObjectName(symbol.type, value.location, symbol)
    return tree.Assign(symbol.type, value.location, target, value)


@contextmanager
def effects(unit: Unit) -> Iterator[list[Expression]]:
    """Collect the side effects of the types that are checked in this context."""
    state = unit.function
    if state is None:
        yield []
        return
    outer, state.effects = state.effects, []
    try:
        yield state.effects
    finally:
        state.effects = outer


def after(done: list[Expression], result: Expression) -> Expression:
    """Return an expression that is evaluated after side effects."""
    for each in reversed(done):
        result = tree.Comma(result.type, result.location, each, result)
    return result


# Pointers to such arrays


def moved(pointer: Expression, index: Expression, minus: bool, location: Location) -> Expression:
    """Return `pointer + index`, or `-`, for a pointer whose target may have a variable size."""
    assert isinstance(pointer.type, PointerType)
    target = pointer.type.target
    if not is_variable(target):
        return tree.PointerAdd(pointer.type, location, pointer, index, minus)
    steps = scaled(index, target)
    inner = tree.PointerAdd(_BYTES, location, convert(pointer, _BYTES), steps, minus)
    return tree.Convert(pointer.type, location, inner)


def scaled(index: Expression, target: CType) -> Expression:
    """Return `index * sizeof(target)` as an `int`."""
    bytes_ = convert(size(target, index.location), INT)
    return tree.Binary(INT, index.location, "*", index, bytes_)


def difference(left: Expression, right: Expression, location: Location) -> Expression:
    """Return `left - right` for two pointers of the same type."""
    assert isinstance(left.type, PointerType)
    target = left.type.target
    if not is_variable(target):
        step = max(1, target.size)
        return tree.PointerDifference(INT, location, left, right, step)
    bytes_ = tree.PointerDifference(INT, location, left, right, 1)
    step_ = convert(size(target, location), INT)
    return tree.Binary(INT, location, "/", bytes_, step_)


def step(target: Expression, sign: int, *, is_postfix: bool) -> Expression:
    """Return `++` (sign 1) or `--` (-1) of a pointer to an array of variable size."""
    ctype, location = target.type, target.location
    assert isinstance(ctype, PointerType)
    one = scaled(tree.integer(1, INT, location), ctype.target)
    op = "+" if sign > 0 else "-"
    changed = tree.CompoundAssign(ctype, location, op, target, one, _BYTES)
    if not is_postfix:
        return changed
    return moved(changed, tree.integer(1, INT, location), sign > 0, location)


# Memory


def declare(
    unit: Unit, symbol: ObjectSymbol, ctype: CType, out: list[tree.Statement] | None
) -> None:
    """Declare a local variable of a variably modified type, and allocate an array."""
    assert unit.function is not None
    state, location = unit.function, symbol.location
    mark = None
    if is_variable(ctype) and out is not None:
        symbol.type, symbol.in_memory, symbol.is_indirect = PointerType(ctype), False, True
        mark = _new_mark(location)
        out.append(_statement(_take_mark(mark)))
        got = allocate(size(ctype, location), symbol.name, location)
        out.append(tree.Declare(location, symbol, None))
        out.append(_statement(set_extent(symbol, convert(got, symbol.type))))
    state.automatics.append(Automatic(symbol.name, location, mark))


def _statement(expression: Expression) -> tree.Statement:
    return tree.ExpressionStatement(expression.location, expression)


def _new_mark(location: Location) -> ObjectSymbol:
    return ObjectSymbol("", INT, location)


def _take_mark(mark: ObjectSymbol) -> Expression:
    count = ObjectSymbol(AUTOMATIC_COUNT, INT, mark.location, AUTOMATIC_COUNT)
    return set_extent(mark, tree.ObjectName(INT, mark.location, count))


def _call(name: str, ctype: FunctionType, arguments: list[Expression], at: Location) -> Expression:
    callee = tree.FunctionName(ctype, at, FunctionSymbol(name, ctype, at, name))
    return tree.Call(ctype.result, at, callee, arguments)


def allocate(bytes_: Expression, name: str, location: Location) -> Expression:
    """Return the call that allocates memory for variable `name` until the end of the scope."""
    content = name.encode("utf-8", "surrogateescape") + b"\0"
    text = tree.StringLiteral(ArrayType(CHAR, len(content)), location, content)
    return _call("__crs_automatic", _ALLOCATE, [bytes_, decay(text)], location)


def alloca(unit: Unit, bytes_: Expression, location: Location) -> Expression:
    """Return the call of `alloca`, whose memory is freed at the end of the function."""
    assert unit.function is not None
    if unit.function.alloca_mark is None:
        unit.function.alloca_mark = _new_mark(location)
    return allocate(bytes_, "alloca", location)


def release(automatics: list[Automatic], first: int, location: Location) -> Expression | None:
    """Return what ends the scope of all variables from number `first` on, if anything does.

    The attributes `cleanup` are obeyed from the last variable to the first, then all memory is
    freed.
    """
    left = automatics[first:]
    calls = [each.cleanup() for each in reversed(left) if each.cleanup is not None]
    marks = [each.mark for each in left if each.mark is not None]
    calls += [_release(each, location) for each in marks[:1]]
    return after(calls[:-1], calls[-1]) if calls else None


def _release(mark: ObjectSymbol, location: Location) -> Expression:
    return _call("__crs_release", _RELEASE, [tree.ObjectName(INT, location, mark)], location)


@contextmanager
def block(state: FunctionState, out: list[tree.Statement], location: Location) -> Iterator[None]:
    """End the lifetime of a block's variables after it."""
    first = len(state.automatics)
    try:
        yield
    finally:
        leave(state, first, out, location)
        del state.automatics[first:]


def leave(state: FunctionState, first: int, out: list[tree.Statement], location: Location) -> None:
    """Append the actions for leaving the scope of the variables from number `first` on."""
    done = release(state.automatics, first, location)
    if done is not None:
        out.append(_statement(done))


def finish(state: FunctionState, body: list[tree.Statement]) -> None:
    """Make every `return` of a function free its memory from `alloca`."""
    mark = state.alloca_mark
    if mark is None:
        return
    for each in state.returns:
        done = [] if each.release is None else [each.release]
        each.release = after(done, _release(mark, each.location))
    body.insert(0, _statement(_take_mark(mark)))
    body.append(_statement(_release(mark, mark.location)))


def jump(
    unit: Unit, what: str, location: Location, source: list[Automatic], target: list[Automatic]
) -> Expression | None:
    """Check a jump, and return its actions (C17 6.8.6.1p1, 6.8.4.2p2)."""
    common = 0
    for left, right in zip(source, target, strict=False):
        if left is not right:
            break
        common += 1
    entered = next((each for each in target[common:] if each.cleanup is None), None)
    if entered is not None:
        text = (
            f"{what} jumps into the scope of '{entered.name}', which has a variably modified type"
        )
        unit.error(location, text, f"declared at {entered.location}")
        return None
    return release(source, common, location)
