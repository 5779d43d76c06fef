"""Hints at code in other languages.

>>> hint_for_type("boolean")
"use 'bool' from <stdbool.h>"
"""

from __future__ import annotations

import itertools
from typing import Final

CPLUSPLUS: Final = "this is C++, but crs compiles C"

_TYPES: Final = {
    "string": "C has no string type: use 'char *' or an array of char",
    "boolean": "use 'bool' from <stdbool.h>",
    "byte": "use 'unsigned char'",
}
"""Types of other languages, in lower case, and their equivalents in C."""

_WORDS: Final = frozenset(
    {
        "catch", "class", "cout", "delete", "friend", "namespace", "new", "operator", "private",
        "protected", "public", "std", "template", "this", "throw", "try", "using", "virtual",
    }
)  # fmt: skip
"""Words with a meaning in C++ that are names in C."""


def hint_for_type(name: str) -> str:
    """Return a hint for an unknown type; "" if it is not one of a known language."""
    return CPLUSPLUS if name in _WORDS else _TYPES.get(name.lower(), "")


def is_cplusplus(words: list[str]) -> bool:
    """Return whether the tokens around an error, in order, look like C++.

    >>> is_cplusplus(["p", "=", "new", "Robot"]), is_cplusplus(["Robot", ":", ":", "turn"])
    (True, True)
    >>> is_cplusplus(["a", "?", "b", ":", "c"])
    False
    """
    return any(word in _WORDS for word in words) or (":", ":") in itertools.pairwise(words)
