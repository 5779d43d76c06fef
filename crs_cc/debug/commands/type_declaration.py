r"""Definitions of types in lines of C, for `ptype`.

>>> from crs_cc.ir.types import CHAR, INT, Member, PointerType, Record
>>> point = Record("struct", "point")
>>> members = [Member("name", PointerType(CHAR)), Member("on", INT, bit_width=1)]
>>> point.complete(members)
>>> print("\n".join(declared(PointerType(RecordType(point)))))
struct point {
    char *name;
    int on : 1;
} *
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from crs_cc.ir.types import (
    ArrayType,
    CType,
    EnumType,
    FunctionType,
    PointerType,
    RecordType,
    spell,
)

_INDENT: Final = "    "


def declared(ctype: CType, declarator: str = "") -> Iterator[str]:
    """Return the C declaration of a type, with the definition of its struct, union or enum."""
    core = ctype
    while not isinstance(core, RecordType | EnumType):
        match core:
            case PointerType(target=inner) | ArrayType(element=inner) | FunctionType(result=inner):
                core = inner
            case _:
                yield spell(ctype, declarator)
                return
    inside = list(_members(core))
    if not inside:
        yield spell(ctype, declarator)
        return
    head = str(core)
    yield f"{head} {{"
    yield from inside
    yield f"}}{spell(ctype, declarator).removeprefix(head)}"


def _has_no_name(ctype: CType) -> bool:
    """Return whether a type is an anonymous struct or union."""
    if isinstance(ctype, ArrayType):
        return _has_no_name(ctype.element)
    return isinstance(ctype, RecordType) and not (ctype.record.tag or ctype.record.alias)


def _members(core: RecordType | EnumType) -> Iterator[str]:
    """Return the lines in the braces."""
    if isinstance(core, EnumType):
        for name, value in (core.definition.constants or {}).items():
            yield f"{_INDENT}{name} = {value},"
        return
    for member in core.record.members or ():
        width = "" if member.bit_width is None else f" : {member.bit_width}"
        if _has_no_name(member.type):
            lines = list(declared(member.type, member.name or ""))
        else:
            lines = [spell(member.type, member.name or "")]
        yield from (f"{_INDENT}{line}" for line in lines[:-1])
        yield f"{_INDENT}{lines[-1]}{width};"
