"""Lower calls, builtins and variadic arguments."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Final

from crs_cc.core.source import Location
from crs_cc.frontend.check import tree
from crs_cc.frontend.check.declarator import LARGEST_OBJECT
from crs_cc.frontend.check.tree import Expression
from crs_cc.frontend.check.vla import AUTOMATIC_COUNT
from crs_cc.frontend.lower.convert import convert_operand, narrow
from crs_cc.frontend.lower.lowerer import (
    Lowering,
    Place,
    Rules,
    memory_type,
    place,
    value,
    value_type,
)
from crs_cc.frontend.lower.memory import load, store
from crs_cc.ir.instruction import (
    VARARGS,
    Address,
    Argument,
    Binary,
    Branch,
    Call,
    Callers,
    Constant,
    Copy,
    Fill,
    Load,
    LongJump,
    Mark,
    MarkUnset,
    Move,
    Operand,
    Passed,
    Register,
    Request,
    SetJump,
    State,
    Stop,
    Store,
    Unary,
)
from crs_cc.ir.names import in_library
from crs_cc.ir.types import INT, UINT, ULLONG, FunctionType, PointerType, RecordType
from crs_cc.ir.value_type import MEMORY_SIZE


def argument(low: Lowering, expression: Expression) -> Argument:
    """Lower one argument; types narrower than `int` are passed as `int` (i386 convention)."""
    ctype = expression.type
    if isinstance(ctype, RecordType):
        address = low.address(place(low, expression), expression.location)
        return Argument(address, None, ctype.size)
    operand = value(low, expression)
    memory = memory_type(ctype)
    if MEMORY_SIZE[memory] < 4:
        memory = "i32"
    return Argument(operand, memory, MEMORY_SIZE[memory])


def _call(low: Lowering, expression: tree.Call, into: Register | None) -> Register:
    """Lower a call whose value is used."""
    ctype, location = expression.type, expression.location
    result = low.register(value_type(ctype)) if into is None else into
    _end_with_call(low, expression, [], result)
    # The declaration of a narrow result may not match the function: trust only the low bits.
    narrowed = narrow(low, result, ctype, location, into=result)
    assert isinstance(narrowed, Register)
    return narrowed


def _call_effect(low: Lowering, expression: tree.Call) -> None:
    if isinstance(expression.type, RecordType):
        _call_place(low, expression)
    else:
        _end_with_call(low, expression, [], None)


def _call_place(low: Lowering, expression: tree.Call) -> Place:
    """Lower a call that returns a struct, into a slot of its own."""
    slot = low.slot("result", expression.type)
    call_into(low, expression, low.address((slot, 0), expression.location))
    return slot, 0


def call_into(low: Lowering, expression: tree.Call, address: Operand) -> None:
    """Lower a call that returns a struct through an address."""
    _end_with_call(low, expression, [Argument(address, "i32", 4)], None)


def _end_with_call(
    low: Lowering, expression: tree.Call, arguments: list[Argument], result: Register | None
) -> None:
    location, callee = expression.location, expression.callee
    called: str | Register
    if isinstance(callee, tree.FunctionName) and not callee.symbol.may_be_missing:
        called = low.refer(callee.symbol.link_name, callee.location)
    else:
        called = _pointer(low, callee)
    # From the last to the first, as gcc does on i386: some programs rely on it.
    lowered = [argument(low, each) for each in reversed(expression.arguments)]
    arguments = [*arguments, *_with_types(expression, lowered[::-1])]
    then = low.new_block("after")
    low.end(Call(location, called, arguments, result, then, _prototype(expression)))
    low.start(then, location)


def _pointer(low: Lowering, callee: Expression) -> Register:
    """Return the pointer through which a function is called."""
    if isinstance(callee, tree.FunctionName):
        pointer = low.address(place(low, callee), callee.location)
    else:
        pointer = value(low, callee)
    if isinstance(pointer, Register):
        return pointer
    register = low.register("i32")
    low.emit(Move(callee.location, register, pointer))
    return register


def _with_types(expression: tree.Call, arguments: list[Argument]) -> list[Argument]:
    """Return arguments with the C types of those that are variable."""
    ctype = expression.callee.type
    ctype = ctype.target if isinstance(ctype, PointerType) else ctype
    if not isinstance(ctype, FunctionType) or not ctype.variadic:
        return arguments
    named = len(ctype.parameters or ())
    rest = zip(expression.arguments[named:], arguments[named:], strict=True)
    return [*arguments[:named], *(replace(each, ctype=passed.type) for passed, each in rest)]


def _prototype(expression: tree.Call) -> FunctionType | None:
    """Return the prototype by which a program, not the library, calls a pointer, if any."""
    pointer = expression.callee.type
    if not isinstance(pointer, PointerType) or in_library(expression.location):
        return None
    ctype = pointer.target
    is_known = isinstance(ctype, FunctionType) and ctype.parameters is not None
    return ctype if is_known else None  # type: ignore[return-value]


# Variadic functions


def _next_argument(low: Lowering, expression: tree.VarArg) -> Place:
    """Return the place of the next variadic argument and advance the list's pointer."""
    location = expression.location
    step = Constant("i32", (expression.type.size + 3) // 4 * 4)
    variable = expression.list
    if isinstance(variable, tree.ObjectName) and variable.symbol.link_name is None:
        pointer = low.local(variable.symbol)
        if isinstance(pointer, Register):
            at = low.register("i32")
            low.emit(Move(location, at, pointer))
            low.emit(Passed(location, at, expression.type))
            low.emit(Binary(location, pointer, "i32.add", pointer, step))
            return at, 0
    where = low.access(place(low, variable), 4, location)
    at = load(low, where, variable.type, location)
    low.emit(Passed(location, at, expression.type))
    store(low, where, variable.type, low.binary(location, "i32.add", at, step), location)
    return at, 0


def _var_arg(low: Lowering, expression: tree.VarArg, into: Register | None) -> Operand:
    where = _next_argument(low, expression)
    return load(low, where, expression.type, expression.location, into)


# Builtins

_FLOAT: Final = {
    f"__builtin_{name}{suffix}": operator
    for suffix in ("", "f", "l")
    for name, operator in (
        ("sqrt", "sqrt"),
        ("fabs", "abs"),
        ("floor", "floor"),
        ("ceil", "ceil"),
        ("trunc", "trunc"),
        ("rint", "nearest"),
        ("copysign", "copysign"),
    )
}
_COUNTS: Final = {
    f"__builtin_{name}{suffix}": operator
    for suffix in ("", "l", "ll")
    for name, operator in (("clz", "clz"), ("ctz", "ctz"), ("popcount", "popcnt"))
}


def _intrinsic(low: Lowering, expression: tree.Intrinsic, into: Register | None) -> Operand:
    """Lower a builtin; return zero if it has no value."""
    found = _SPECIAL.get(expression.name)
    if found is not None:
        return found(low, expression)
    location = expression.location
    operands = [value(low, each) for each in expression.arguments]
    kind = operands[0].type
    if expression.name in _COUNTS:
        counted = low.register(kind)
        low.emit(Unary(location, counted, f"{kind}.{_COUNTS[expression.name]}", operands[0]))
        source = ULLONG if kind == "i64" else INT
        return convert_operand(low, counted, source, INT, location, into=into)
    result = low.register(kind) if into is None else into
    op = f"{kind}.{_FLOAT[expression.name]}"
    if len(operands) == 1:
        low.emit(Unary(location, result, op, operands[0]))
    else:
        low.emit(Binary(location, result, op, operands[0], operands[1]))
    return result


def _request(low: Lowering, expression: tree.Intrinsic) -> Operand:
    code, message = (value(low, each) for each in expression.arguments)
    result, then = low.register("i32"), low.new_block("after")
    low.end(Request(expression.location, code, message, result, then))
    low.start(then, expression.location)
    return result


def _set_jump(low: Lowering, expression: tree.Intrinsic) -> Operand:
    """Lower `setjmp`: fill in `struct __crs_jump`, apart from the resume point's number."""
    location = expression.location
    pointer, *signals = (value(low, each) for each in expression.arguments)
    unblocked = signals[0] if signals else Constant("i32", 0)
    buffer, result, then = low.register("i32"), low.register("i32"), low.new_block("landed")
    low.move(buffer, pointer, location)
    low.emit(Store(location, buffer, 0, low.activation(), "i32"))
    count = low.register("i32")
    low.emit(Load(location, count, low.refer(AUTOMATIC_COUNT, location), 0, "i32"))
    low.emit(Store(location, buffer, 8, count, "i32"))
    low.emit(Store(location, buffer, 12, unblocked, "i32"))
    place_at = low.binary(location, "i32.add", buffer, Constant("i32", 4))
    low.end(SetJump(location, place_at, low.activation(), result, then))
    low.start(then, location)
    return result


def _long_jump(low: Lowering, expression: tree.Intrinsic) -> Operand:
    activation, where, given = (value(low, each) for each in expression.arguments)
    low.end(LongJump(expression.location, activation, where, given))
    return Constant("i32", 0)


def _array_size(low: Lowering, expression: tree.Intrinsic) -> Operand:
    """Lower `length * element size` with a 64-bit length; stop the program if it is invalid."""
    location = expression.location
    length, element = (value(low, each) for each in expression.arguments)
    most = Constant("i64", LARGEST_OBJECT)
    before = low.binary(location, "i64.sub", length, Constant("i64", 1))
    none = low.binary(location, "i64.lt_s", before, Constant("i64", 0))
    _stop_if(low, none, "non-positive array length", location)
    # A length above the limit cannot be multiplied: the product might overflow.
    huge = low.binary(location, "i64.gt_s", length, most)
    _stop_if(low, huge, "no memory for local array", location)
    wide = convert_operand(low, element, UINT, ULLONG, location)
    bytes_ = low.binary(location, "i64.mul", length, wide)
    huge = low.binary(location, "i64.gt_s", bytes_, most)
    _stop_if(low, huge, "no memory for local array", location)
    return convert_operand(low, bytes_, ULLONG, UINT, location)


def _stop_if(low: Lowering, condition: Operand, kind: str, location: Location) -> None:
    wrong, right = low.new_block("wrong"), low.new_block("right")
    low.end(Branch(location, condition, wrong, right))
    low.start(wrong, location)
    low.end(Stop(location, kind))
    low.start(right, location)


def _copy(low: Lowering, expression: tree.Intrinsic) -> Operand:
    target, source, size = (value(low, each) for each in expression.arguments)
    low.emit(Copy(expression.location, target, source, size))
    return target


def _fill(low: Lowering, expression: tree.Intrinsic) -> Operand:
    target, byte, size = (value(low, each) for each in expression.arguments)
    low.emit(Fill(expression.location, target, byte, size))
    return target


def _stop(low: Lowering, expression: tree.Intrinsic) -> Operand:
    kinds = {
        "__builtin_unreachable": "unreachable code reached",
        "__builtin_trap": "abort called",
        "__crs_stop": expression.kind,
    }
    values = [value(low, each) for each in expression.arguments]
    low.end(Stop(expression.location, kinds[expression.name], *values))
    return Constant("i32", 0)


def _mark(low: Lowering, expression: tree.Intrinsic) -> Operand:
    address, size = (value(low, each) for each in expression.arguments[:2])
    low.emit(Mark(expression.location, address, size, _constant(expression.arguments[2])))
    return Constant("i32", 0)


def _mark_unset(low: Lowering, expression: tree.Intrinsic) -> Operand:
    address, size, origin = (value(low, each) for each in expression.arguments)
    low.emit(MarkUnset(expression.location, address, size, origin))
    return Constant("i32", 0)


def _callers(low: Lowering, expression: tree.Intrinsic) -> Operand:
    address, count = expression.arguments
    low.emit(Callers(expression.location, value(low, address), _constant(count)))
    return Constant("i32", 0)


def _state(low: Lowering, expression: tree.Intrinsic) -> Operand:
    result = low.register("i32")
    low.emit(State(expression.location, result, value(low, expression.arguments[0])))
    return result


def _constant(expression: Expression) -> int:
    assert isinstance(expression, tree.Literal)
    return int(expression.value)


def _va_start(low: Lowering, expression: tree.Intrinsic) -> Operand:
    variable, location = expression.arguments[0], expression.location
    if isinstance(variable, tree.ObjectName) and variable.symbol.link_name is None:
        pointer = low.local(variable.symbol)
        if isinstance(pointer, Register):
            low.emit(Address(location, pointer, VARARGS, 0))
            return pointer
    made = low.register("i32")
    low.emit(Address(location, made, VARARGS, 0))
    store(low, place(low, variable), variable.type, made, location)
    return made


_SPECIAL: Final[dict[str, Callable[[Lowering, tree.Intrinsic], Operand]]] = {
    "__crs_request": _request,
    "__crs_array_size": _array_size,
    "__crs_stop": _stop,
    "__crs_mark": _mark,
    "__crs_mark_unset": _mark_unset,
    "__crs_callers": _callers,
    "__crs_state": _state,
    "__crs_setjmp": _set_jump,
    "__crs_sigsetjmp": _set_jump,
    "__crs_longjmp": _long_jump,
    "__builtin_memcpy": _copy,
    "__builtin_memmove": _copy,
    "__builtin_memset": _fill,
    "__builtin_trap": _stop,
    "__builtin_unreachable": _stop,
    "__builtin_va_start": _va_start,
}


def _intrinsic_effect(low: Lowering, expression: tree.Intrinsic) -> None:
    _intrinsic(low, expression, None)


RULES: Final = Rules(
    value={
        tree.Call: _call,
        tree.VarArg: _var_arg,
        tree.Intrinsic: _intrinsic,
    },
    effect={
        tree.Call: _call_effect,
        tree.Intrinsic: _intrinsic_effect,
    },
    place={
        tree.Call: _call_place,
        tree.VarArg: _next_argument,
    },
)
