"""What is found out about a function of the C library is remembered: it never changes.

All programs of a process link the same functions of the library, which are most of each program.

>>> from crs_cc.core.source import Location
>>> asked = []
>>> @remembered
... def length(function: Function) -> int:
...     asked.append(function.name)
...     return len(function.name)
>>> puts, main = Function("puts", Location("<library>/puts.c")), Function("main", Location("a.c"))
>>> [length(each) for each in (puts, main, puts, main)], asked
([4, 4, 4, 4], ['puts', 'main', 'main'])
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import TypeVar

from crs_cc.ir.names import in_library
from crs_cc.ir.program import Function

_Fact = TypeVar("_Fact")


def remembered(find: Callable[[Function], _Fact]) -> Callable[[Function], _Fact]:
    """Make a function that looks at nothing but an IR function remember what it found, not None."""
    known: dict[Function, _Fact] = {}

    @functools.wraps(find)
    def fact(function: Function) -> _Fact:
        found = known.get(function)
        if found is None:
            found = find(function)
            if in_library(function.location):
                known[function] = found
        return found

    return fact
