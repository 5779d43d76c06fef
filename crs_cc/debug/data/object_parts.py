"""Parts of objects by name: the bytes that a statement reads of one, or that a function copies."""

from __future__ import annotations

import contextlib
import re
from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

from crs_cc.debug.data.statement_text import calls, value_of
from crs_cc.debug.data.values import Value
from crs_cc.debug.errors import DebugError
from crs_cc.ir.types import CHAR, INT, LLONG, SHORT, ArrayType, PointerType

if TYPE_CHECKING:
    from crs_cc.debug.data.evaluate import Evaluator
    from crs_cc.runtime.diagnosis.inspect import StackFrame

Span = tuple[int, int]
"""Address and size [bytes]."""

_NAME: Final = re.compile(r"[\w.]+(?:->[\w.]+)*")
_UNITS: Final = {1: CHAR, 2: SHORT, 4: INT, 8: LLONG}


def bytes_read(evaluator: Evaluator, text: str, frame: StackFrame | None) -> tuple[Span, ...]:
    """Return what a statement reads to compute its value; nothing if that is not known."""
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
    evaluator: Evaluator, pointer: str, span: Span, frame: StackFrame | None
) -> str | None:
    """Return an expression that names bytes behind a pointer: an object if there is one.

    Args:
        evaluator: evaluates it.
        pointer: the pointer, or an array.
        span: the first byte, from the pointer on, and how many.
        frame: the frame in whose scope it is.
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
    for name in names:
        with contextlib.suppress(DebugError):
            found = evaluator.place(name, frame)
            if (found.address, found.size) == (address, size):
                return name
    last = f"..{offset + size - 1}" if size > 1 else ""
    ctype = evaluator.type_of(pointer, frame)
    is_bytes = isinstance(ctype, ArrayType) and ctype.element.size == 1
    base = pointer if is_bytes and _NAME.fullmatch(pointer) else f"((char *)({pointer}))"
    return f"{base}[{offset}{last}]"


def bytes_copied(
    evaluator: Evaluator, passed: Sequence[str], span: Span, frame: StackFrame | None
) -> str | None:
    """Return what `memcpy` has copied to some bytes, as an expression; None if it is not known.

    Args:
        evaluator: evaluates the arguments.
        passed: the arguments of the call.
        span: the bytes: their address, and how many.
        frame: the frame of the caller.
    """
    to = address_of(evaluator, passed[0], frame) if len(passed) > 1 else None
    if to is None or span[0] < to:
        return None
    return bytes_behind(evaluator, passed[1], (span[0] - to, span[1]), frame)
