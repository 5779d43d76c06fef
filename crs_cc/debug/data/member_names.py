"""Names of the members and elements that some bytes of a struct or an array are.

>>> from crs_cc.ir.types import CHAR, INT, Member, Record
>>> point, row = Record("struct", "point"), Record("struct", "row")
>>> point.complete([Member("x", INT), Member("y", INT)])
>>> row.complete([Member("of", ArrayType(RecordType(point), 3)), Member("name", CHAR)])
>>> [member_name(RecordType(row), at, size) for at, size in [(12, 4), (8, 8), (24, 1), (4, 8)]]
['.of[1].y', '.of[1]', '.name', None]
"""

from __future__ import annotations

import re
from typing import Final

from crs_cc.ir.types import ArrayType, CType, RecordType

_SIMPLE: Final = re.compile(r"[\w.]+(?:(?:->|\[[^\[\]]*\])[\w.]*)*")


def member_name(ctype: CType, offset: int, size: int) -> str | None:
    """Return the member suffix for a range of bytes; None if it is not a complete member.

    Args:
        ctype: the type of the whole.
        offset: the first byte.
        size: how many.
    """
    if (offset, size) == (0, ctype.size):
        return ""
    if isinstance(ctype, ArrayType) and ctype.element.size:
        number, rest = divmod(offset, ctype.element.size)
        inner = member_name(ctype.element, rest, size)
        return None if inner is None else f"[{number}]{inner}"
    if isinstance(ctype, RecordType):
        for name, member in ctype.record.named.items():
            end = member.offset + member.type.size
            if member.bit_width is None and member.offset <= offset and offset + size <= end:
                inner = member_name(member.type, offset - member.offset, size)
                if inner is not None:
                    return f".{name}{inner}"
    return None


def behind(pointer: str, name: str) -> str:
    """Return an expression for a member of what a pointer points to.

    >>> behind("&report", ".x"), behind("&(*(struct at *) data)", ".x"), behind("at + 1", ".x")
    ('report.x', '((struct at *) data)->x', '(at + 1)->x')
    >>> behind("&(left ? a : b)", ".x"), behind("p", ".x[2]"), behind("tab", "[2].x")
    ('(left ? a : b).x', 'p->x[2]', 'tab[2].x')
    """
    pointer = pointer.strip()
    if pointer.startswith("&"):
        whole = pointer.removeprefix("&").strip()
        if whole.startswith("(") and whole.endswith(")") and _is_enclosed(whole):
            whole = whole[1:-1].strip()
        if not whole.startswith("*"):
            return f"{_grouped(whole)}{name}"
        pointer = whole.removeprefix("*").strip()
    return f"{_grouped(pointer)}{'->' + name[1:] if name.startswith('.') else name}"


def _grouped(text: str) -> str:
    return text if _SIMPLE.fullmatch(text) else f"({text})"


def _is_enclosed(text: str) -> bool:
    """Return whether the first parenthesis of a text is closed by its last character."""
    depth = 0
    for at, each in enumerate(text):
        depth += (each == "(") - (each == ")")
        if depth == 0:
            return at == len(text) - 1
    return False
