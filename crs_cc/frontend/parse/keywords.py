"""The keywords of each C standard, with pycparser's names for the kinds of their tokens.

A word that a later standard made a keyword is a name in programs for an earlier one: `restrict` in
C90, `bool` before C23.

>>> [word in keywords("gnu89") for word in ("inline", "restrict", "bool")]
[True, False, False]
>>> [word in keywords("c23") for word in ("inline", "restrict", "bool")]
[True, True, True]
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Final

from crs_cc.frontend.preprocess.options import is_c23, is_c90

_OF_ALL: Final = {
    "auto": "AUTO", "break": "BREAK", "case": "CASE", "char": "CHAR", "const": "CONST",
    "continue": "CONTINUE", "default": "DEFAULT", "do": "DO", "double": "DOUBLE", "else": "ELSE",
    "enum": "ENUM", "extern": "EXTERN", "float": "FLOAT", "for": "FOR", "goto": "GOTO", "if": "IF",
    "int": "INT", "long": "LONG", "offsetof": "OFFSETOF", "register": "REGISTER",
    "return": "RETURN", "short": "SHORT", "signed": "SIGNED", "sizeof": "SIZEOF",
    "static": "STATIC", "struct": "STRUCT", "switch": "SWITCH", "typedef": "TYPEDEF",
    "union": "UNION", "unsigned": "UNSIGNED", "void": "VOID", "volatile": "VOLATILE",
    "while": "WHILE", "_Alignas": "_ALIGNAS", "_Alignof": "_ALIGNOF", "_Atomic": "_ATOMIC",
    "_Bool": "_BOOL", "_Complex": "_COMPLEX", "_Generic": "_GENERIC", "_Noreturn": "_NORETURN",
    "_Static_assert": "_STATIC_ASSERT", "_Thread_local": "_THREAD_LOCAL",
    "__builtin_offsetof": "OFFSETOF", "__builtin_va_arg": "__BUILTIN_VA_ARG", "__imag": "__IMAG",
    "__imag__": "__IMAG", "__inline": "INLINE", "__int128": "__INT128", "__label__": "__LABEL__",
    "__real": "__REAL", "__real__": "__REAL", "__restrict": "RESTRICT", "__typeof__": "TYPEOF",
    "__typeof": "TYPEOF",
}  # fmt: skip
_OF_C99: Final = {"inline": "INLINE", "restrict": "RESTRICT"}
_OF_GNU: Final = {"inline": "INLINE", "typeof": "TYPEOF"}
_OF_C23: Final = {
    "alignas": "_ALIGNAS", "alignof": "_ALIGNOF", "bool": "_BOOL", "constexpr": "CONSTEXPR",
    "false": "BOOL_CONST", "nullptr": "NULLPTR", "static_assert": "_STATIC_ASSERT",
    "thread_local": "_THREAD_LOCAL", "true": "BOOL_CONST", "typeof": "TYPEOF",
    "typeof_unqual": "TYPEOF_UNQUAL",
}  # fmt: skip

INLINE: Final = frozenset({"inline", "__inline"})
"""The spellings of `inline`."""


@cache
def keywords(standard: str) -> Mapping[str, str]:
    """Return the keywords of a standard, a key of `STANDARDS`, and the kinds of their tokens."""
    return {
        **_OF_ALL,
        **({} if is_c90(standard) else _OF_C99),
        **(_OF_GNU if standard.startswith("gnu") else {}),
        **(_OF_C23 if is_c23(standard) else {}),
    }
