"""The attribute `mode`, which selects a GNU C number type by its size."""

from __future__ import annotations

from typing import Final

from crs_cc.frontend.check.alignment import attributes
from crs_cc.frontend.check.checker import CheckError
from crs_cc.frontend.parse.nodes import Node
from crs_cc.ir.types import (
    DOUBLE,
    FLOAT,
    INT,
    LLONG,
    SCHAR,
    SHORT,
    UCHAR,
    UINT,
    ULLONG,
    USHORT,
    CType,
    EnumType,
    FloatType,
    IntegerType,
    qualify,
)

_INTEGERS: Final = {
    "QI": (UCHAR, SCHAR), "byte": (UCHAR, SCHAR), "HI": (USHORT, SHORT),
    "SI": (UINT, INT), "word": (UINT, INT), "pointer": (UINT, INT), "DI": (ULLONG, LLONG),
}  # fmt: skip
_FLOATS: Final = {"SF": FLOAT, "DF": DOUBLE}


def with_mode(node: Node, ctype: CType) -> CType:
    """Return the type of a declaration, changed by its attribute `mode`.

    Raises:
        CheckError: there is no such type.
    """
    for each in attributes(node):
        if each.name == "mode":
            name = each.words[0].value.strip("_") if each.words else ""
            changed = _changed(ctype, name)
            if changed is None:
                raise CheckError(each.location, f"'{ctype}' has no mode '{name}'")
            ctype = changed
    return ctype


def _changed(ctype: CType, name: str) -> CType | None:
    found: CType | None = None
    if isinstance(ctype, IntegerType | EnumType) and name in _INTEGERS:
        found = _INTEGERS[name][ctype.signed]
    elif isinstance(ctype, FloatType):
        found = _FLOATS.get(name)
    return found and qualify(found, ctype.const, ctype.volatile)
