"""The linker name of an object or a function: `int vm(double) asm("vm_2");`.

>>> from crs_cc.frontend.parse.gnu_attributes import Attribute
>>> from crs_cc.frontend.parse.lexer import lex
>>> from crs_cc.core.source import Diagnostics, Location
>>> words = lex('"vm" "_2"', lambda line, column: Location("a.c", line, column), Diagnostics())
>>> label_among([Attribute(ASM_LABEL, Location("a.c"), words)])
'vm_2'
"""

from __future__ import annotations

import re
from typing import Final

from crs_cc.frontend.check.alignment import attributes
from crs_cc.frontend.check.checker import CheckError
from crs_cc.frontend.parse.gnu_attributes import Attribute
from crs_cc.frontend.parse.nodes import Node
from crs_cc.frontend.preprocess.gnu import ASM_LABEL

_NAME: Final = re.compile(r"[A-Za-z_.$][\w.$]*", re.ASCII)


def asm_label(node: Node) -> str:
    """Return the linker name in a declaration, "" if there is none.

    Raises:
        CheckError: it is not a valid name.
    """
    return label_among(attributes(node))


def alias(node: Node) -> str:
    """Return the name in a declaration's attribute `alias`, "" if it has none."""
    found = (each for each in attributes(node) if each.name == "alias")
    return next(("".join(word.value.strip('"') for word in each.words) for each in found), "")


def label_among(found: list[Attribute]) -> str:
    """Return the linker name among attributes, "" if there is none.

    Raises:
        CheckError: it is not a valid name.
    """
    for each in found:
        if each.name == ASM_LABEL:
            label = "".join(word.value.strip('"') for word in each.words)
            if _NAME.fullmatch(label) is None:
                raise CheckError(each.location, "expected a string literal in 'asm'")
            return label
    return ""
