"""Parts of objects by name: the bytes that a statement reads of one, or that a function copies."""

from __future__ import annotations

import contextlib
import re
from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

from crs_cc.debug.data.member_names import behind, member_name
from crs_cc.debug.data.statement_text import assignment, calls, operands, value_of
from crs_cc.debug.data.values import Value
from crs_cc.debug.errors import DebugError
from crs_cc.ir.types import (
    CHAR,
    INT,
    LLONG,
    SHORT,
    ArrayType,
    CType,
    FloatType,
    IntegerType,
    PointerType,
    RecordType,
)

if TYPE_CHECKING:
    from crs_cc.debug.data.evaluate import Evaluator
    from crs_cc.runtime.diagnosis.inspect import StackFrame

Span = tuple[int, int]
"""Address and size [bytes]."""

_NAME: Final = re.compile(r"[\w.]+(?:->[\w.]+)*")
_UNITS: Final = {1: CHAR, 2: SHORT, 4: INT, 8: LLONG}


def bytes_read(evaluator: Evaluator, text: str, frame: StackFrame | None) -> tuple[Span, ...]:
    """Return the objects that a statement reads to compute its value; none if unknown."""
    value = value_of(text)
    if not value or calls(value):
        return ()
    with contextlib.suppress(DebugError):
        found = evaluator.observe(value, evaluator.scope_of(value, frame).names, frame)
        return found.reads if found.place is None else (*found.reads, found.place)
    return ()


def part_read(
    evaluator: Evaluator, name: str, read: Sequence[Span], frame: StackFrame | None
) -> str:
    """Return which part of an array is read, as an expression; all of it if that is not known.

    Args:
        evaluator: evaluates it.
        name: an operand.
        read: the bytes that are read.
        frame: the frame in whose scope it is.
    """
    if not read:
        return name
    value = evaluator.evaluate(name, frame).value
    evaluator.undo()
    if not isinstance(value.type, ArrayType) or value.address is None:
        return name
    begin, end = value.address, value.address + value.type.size
    within = [(at, at + size) for at, size in read if begin <= at and at + size <= end]
    if not within:
        return name
    width = value.type.element.size
    first = (min(at for at, _ in within) - begin) // width
    last = (max(at for _, at in within) - begin - 1) // width
    if last - first + 1 == value.type.size // width:
        return name
    return f"{name}[{first}]" if first == last else f"{name}[{first}..{last}]"


def address_of(evaluator: Evaluator, pointer: str, frame: StackFrame | None) -> int | None:
    """Return where an array is, or to where a pointer points; None for anything else."""
    with contextlib.suppress(DebugError):
        value = evaluator.evaluate(pointer, frame).value
        evaluator.undo()
        if isinstance(value.type, ArrayType):
            return value.address
        if isinstance(value.type, PointerType) and isinstance(value.number, int):
            return value.number
    return None


def bytes_behind(
    evaluator: Evaluator,
    pointer: str,
    span: Span,
    frame: StackFrame | None,
    shown_as: CType | None = None,
) -> str | None:
    """Return an expression for the bytes at a pointer: an object if there is one.

    Args:
        evaluator: evaluates it.
        pointer: the pointer, or an array.
        span: the first byte, from the pointer on, and how many.
        frame: the frame in whose scope it is.
        shown_as: the type with which bytes that are no object are shown, if it is arithmetic.
    """
    begin, (offset, size) = address_of(evaluator, pointer, frame), span
    if begin is None:
        return None
    address = begin + offset
    names = [pointer.strip().removeprefix("&").strip()] if offset == 0 else []
    if size in _UNITS:
        content = address.to_bytes(4, "little")
        shown = Value(evaluator.inspector(), PointerType(_UNITS[size]), content).text
        names += [shown.removeprefix("&")]
    ctype = evaluator.type_of(pointer, frame)
    if isinstance(ctype, PointerType | ArrayType):
        whole = ctype.target if isinstance(ctype, PointerType) else ctype
        member = member_name(whole, offset, size)
        names += [behind(pointer, member)] if member else []
    for name in names:
        with contextlib.suppress(DebugError):
            found = evaluator.place(name, frame)
            if (found.address, found.size) == (address, size):
                return name
    if isinstance(shown_as, IntegerType | FloatType) and shown_as.size == size:
        place = f"({pointer} + {offset})" if offset else pointer
        return f"*({shown_as} *) {place if offset or _NAME.fullmatch(pointer) else f'({place})'}"
    last = f"..{offset + size - 1}" if size > 1 else ""
    is_bytes = isinstance(ctype, ArrayType) and ctype.element.size == 1
    base = pointer if is_bytes and _NAME.fullmatch(pointer) else f"((char *)({pointer}))"
    return f"{base}[{offset}{last}]"


def part_assigned(
    evaluator: Evaluator, text: str, span: Span, frame: StackFrame | None
) -> Span | None:
    """Return which bytes of an assigned struct are some bytes of its target.

    Args:
        evaluator: evaluates the target.
        text: the statement.
        span: the bytes of the target: their address, and how many.
        frame: the frame in whose scope it is.

    Returns:
        The first byte from the start of the struct, and how many; None if all of it is asked for,
        or it is not a struct.
    """
    target, _ = assignment(text)
    with contextlib.suppress(DebugError):
        found = evaluator.evaluate(target, frame).value
        evaluator.undo()
        if isinstance(found.type, RecordType) and found.address is not None:
            return part_within(found.address, found.type.size, span)
    return None


def part_within(address: int, size: int, span: Span) -> Span | None:
    """Return which part of an object some bytes are; None if they are all of it, or elsewhere.

    >>> part_within(100, 8, (104, 4)), part_within(100, 8, (100, 8)), part_within(100, 8, (106, 4))
    ((4, 4), None, None)
    """
    first = span[0] - address
    is_part = 0 <= first <= first + span[1] <= size and span[1] < size
    return (first, span[1]) if is_part else None


def part_operands(
    evaluator: Evaluator, value: str, part: Span, frame: StackFrame | None
) -> list[str]:
    """Return the source of a part of a struct's value; empty if unknown.

    That is the same part of the object that has the value, and what was read to find the object.
    """
    named = bytes_behind(evaluator, f"&({value})", part, frame)
    if named is None:
        return []
    with contextlib.suppress(DebugError):
        whole = evaluator.place(value, frame)
        begin, end = whole.address, whole.address + whole.size
        others = [
            each for each in operands(value) if not _overlaps(evaluator, each, begin, end, frame)
        ]
        return [named, *others]
    return [named]


def holds(evaluator: Evaluator, name: str, address: int, frame: StackFrame | None) -> bool:
    """Return whether an operand is an object at an address, or one around it."""
    return _overlaps(evaluator, name, address, address + 1, frame)


def _overlaps(
    evaluator: Evaluator, name: str, begin: int, end: int, frame: StackFrame | None
) -> bool:
    with contextlib.suppress(DebugError):
        found = evaluator.place(name, frame)
        return found.address < end and begin < found.address + max(found.size, 1)
    return False


def bytes_copied(
    evaluator: Evaluator,
    passed: Sequence[str],
    span: Span,
    frame: StackFrame | None,
    shown_as: CType | None = None,
) -> str | None:
    """Return the source that `memcpy` copied to some bytes, as an expression; None if unknown.

    Args:
        evaluator: evaluates the arguments.
        passed: the arguments of the call.
        span: the bytes: their address, and how many.
        frame: the frame of the caller.
        shown_as: the type with which bytes that are no object are shown, if it is arithmetic.
    """
    to = address_of(evaluator, passed[0], frame) if len(passed) > 1 else None
    if to is None or span[0] < to:
        return None
    return bytes_behind(evaluator, passed[1], (span[0] - to, span[1]), frame, shown_as)
