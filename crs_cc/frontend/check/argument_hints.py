"""Hints for calls of library functions whose stream or format is missing or misplaced.

`fprintf("hello")` lacks its stream, `fputs(stream, "hello")` has it at the wrong end, and
`printf(speed)` has no format. The type mismatch alone does not help a beginner.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from crs_cc.frontend.check.conversion import is_integer
from crs_cc.frontend.check.format_string import KNOWN, fitting
from crs_cc.frontend.check.scope import FunctionSymbol
from crs_cc.frontend.check.tree import Expression
from crs_cc.ir.types import CType, FloatType, FunctionType, PointerType, RecordType

_WITH_STREAM: Final = {
    "printf": "fprintf", "puts": "fputs", "putchar": "fputc", "vprintf": "vfprintf",
    "scanf": "fscanf", "gets": "fgets", "getchar": "fgetc", "vscanf": "vfscanf",
}  # fmt: skip
_ORDINALS: Final = ("first", "second", "third", "fourth", "fifth")


def argument_hint(
    callee: FunctionSymbol, function: FunctionType, arguments: Sequence[Expression]
) -> str:
    """Return a hint for a call whose arguments do not match; "" if there is none."""
    parameters = function.parameters or ()
    given = [_is_stream(value.type) for value in arguments]
    wanted = [_is_stream(ctype) for ctype in parameters]
    if any(given) and not any(wanted):
        other = _WITH_STREAM.get(callee.name)
        return f"for a stream use '{other}'" if other and callee.is_external else ""
    if any(wanted):
        return _stream_hint(callee.name, wanted, given)
    return _format_hint(callee, arguments)


def _stream_hint(name: str, wanted: list[bool], given: list[bool]) -> str:
    """Return a hint at the position of the stream; "" if it is right."""
    at = wanted.index(True)
    if given[at : at + 1] == [True] or (any(given) and len(given) < len(wanted)):
        return ""
    text = f"'{name}' takes a stream"
    if len(wanted) > 1:
        place = "last" if at == len(wanted) - 1 else _ORDINALS[at]
        text = f"'{name}' takes the stream as its {place} argument"
    return text if any(given) else f"{text}, such as stdout or the result of fopen"


def _format_hint(callee: FunctionSymbol, arguments: Sequence[Expression]) -> str:
    form = KNOWN.get(callee.name) if callee.is_external else None
    if form is None or form.string >= len(arguments):
        return ""
    ctype = arguments[form.string].type
    if not is_integer(ctype) and not isinstance(ctype, FloatType):
        return ""
    if form.string == 0 and form.kind == "printf":
        return f'the format comes first: {callee.name}("{fitting(ctype)}", ...)'
    return f"'{callee.name}' takes the format as its {_ORDINALS[form.string]} argument"


def _is_stream(ctype: CType) -> bool:
    """Return whether a type is a pointer to the library's `FILE`."""
    target = ctype.target if isinstance(ctype, PointerType) else None
    return isinstance(target, RecordType) and target.record.alias == "FILE"
