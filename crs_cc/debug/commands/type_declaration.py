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
>>> print("\n".join(declared(RecordType(point), is_laid_out=True)))
struct point {                      /* 8 bytes */
    char *name;                     /* at 0, 4 bytes */
    int on : 1;                     /* at 4, bit 0 */
}
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from crs_cc.ir.types import (
    ArrayType,
    CType,
    EnumType,
    FunctionType,
    Member,
    PointerType,
    RecordType,
    spell,
)

_INDENT: Final = "    "
_COLUMN: Final = 36
"""Where the comments with offsets begin."""


def declared(
    ctype: CType, declarator: str = "", *, is_laid_out: bool = False, offset: int = 0
) -> Iterator[str]:
    """Return the C declaration of a type, with the definition of its struct, union or enum.

    Args:
        ctype: the type.
        declarator: what is declared.
        is_laid_out: whether comments give offsets and sizes.
        offset: the offset of what is declared [bytes].
    """
    core = ctype
    while not isinstance(core, RecordType | EnumType):
        match core:
            case PointerType(target=inner) | ArrayType(element=inner) | FunctionType(result=inner):
                core = inner
            case _:
                yield spell(ctype, declarator)
                return
    inside = list(_members(core, offset if is_laid_out else None))
    if not inside:
        yield spell(ctype, declarator)
        return
    head = str(core)
    size = f"{core.size} bytes" if is_laid_out and isinstance(core, RecordType) else ""
    yield _commented(f"{head} {{", size)
    yield from inside
    yield f"}}{spell(ctype, declarator).removeprefix(head)}"


def _has_no_name(ctype: CType) -> bool:
    """Return whether a type is an anonymous struct or union."""
    if isinstance(ctype, ArrayType):
        return _has_no_name(ctype.element)
    return isinstance(ctype, RecordType) and not (ctype.record.tag or ctype.record.alias)


def _commented(line: str, comment: str) -> str:
    return f"{line:{_COLUMN - 1}} /* {comment} */" if comment else line


def _members(core: RecordType | EnumType, offset: int | None) -> Iterator[str]:
    """Return the lines in the braces; with offsets, if that of the whole is given [bytes]."""
    if isinstance(core, EnumType):
        for name, value in (core.definition.constants or {}).items():
            yield f"{_INDENT}{name} = {value},"
        return
    for member in core.record.members or ():
        width = "" if member.bit_width is None else f" : {member.bit_width}"
        at = member.offset + (offset or 0)
        if _has_no_name(member.type):
            is_laid_out = offset is not None
            lines = list(
                declared(member.type, member.name or "", is_laid_out=is_laid_out, offset=at)
            )
        else:
            lines = [spell(member.type, member.name or "")]
        yield from (f"{_INDENT}{line}" for line in lines[:-1])
        last = f"{_INDENT}{lines[-1]}{width};"
        yield last if offset is None else _commented(last, _place(member, at))


def _place(member: Member, offset: int) -> str:
    """Return offset and size of a member."""
    if member.bit_width is not None:
        bit = member.bit_offset
        return f"at {offset + bit // 8}, bit {bit % 8}"
    return f"at {offset}, {member.type.size} byte{'s' * (member.type.size != 1)}"
