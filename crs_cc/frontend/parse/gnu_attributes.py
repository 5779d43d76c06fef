"""Attributes: GNU's `__attribute__((packed, aligned(8)))`, C23's `[[noreturn]]`, `#pragma pack`.

An attribute may appear nearly everywhere, but the grammar does not depend on it. So attributes are
removed from the tokens before parsing and kept by the token that they precede; the parser attaches
them when it has read a declarator or a specifier (see `attributes`).

>>> from crs_cc.frontend.parse.lexer import lex
>>> from crs_cc.core.source import Diagnostics, Location
>>> messages = Diagnostics()
>>> source = "int x __attribute__((aligned(4 * 2), packed, unused));"
>>> tokens = lex(source, lambda line, column: Location("a.c", line, column), messages)
>>> rest, before = take_attributes(tokens, messages)
>>> [each.value for each in rest], [each.name for each in before[rest[2]]]
(['int', 'x', ';'], ['aligned', 'packed', 'unused'])
"""

from __future__ import annotations

import difflib
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, Final, TypeAlias

from crs_cc.core.source import Diagnostics, Location
from crs_cc.frontend.parse.lexer import Token
from crs_cc.frontend.preprocess.gnu import ASM_LABEL, KEYWORD, PACK

Node: TypeAlias = Any

_INTERNAL: Final = frozenset({PACK, ASM_LABEL})

_IMPLEMENTED: Final = frozenset({
    "alias", "aligned", "cleanup", "constructor", "destructor", "format", "gnu_inline", "mode",
    "noreturn", "packed", "transparent_union", "weak", "unused", "used", "maybe_unused",
})  # fmt: skip
"""Attributes that are implemented."""

_IGNORED: Final = frozenset({
    "access", "alloc_align", "alloc_size", "always_inline", "artificial", "assume_aligned", "cdecl",
    "carries_dependency", "cold", "common", "const", "deprecated", "designated_init", "error",
    "externally_visible", "fallthrough", "fastcall", "flatten", "format_arg", "hot",
    "interrupt", "may_alias", "leaf", "likely", "malloc", "naked", "nodiscard",
    "no_instrument_function", "no_reorder", "no_sanitize", "no_sanitize_address", "no_split_stack",
    "noclone", "nocommon", "noinit", "noinline", "noipa", "nonnull", "nonstring", "noplt",
    "nothrow", "optimize", "pure", "regparm", "reproducible", "retain", "returns_nonnull",
    "returns_twice", "section", "sentinel", "stack_protect", "stdcall", "symver", "target",
    "target_clones", "tls_model", "unavailable", "unlikely", "unsequenced",
    "visibility", "warn_if_not_aligned", "warn_unused_result", "warning",
})  # fmt: skip
"""Attributes that can be ignored: they do not change a program's behaviour."""

_BYTES: Final = "read and write the bytes one by one"
_UNSUPPORTED: Final = {
    "vector_size": "there are no vector types: use an array, and a loop over its elements",
    "hardbool": "use '_Bool'",
    "ifunc": "call the chosen function through a pointer",
    "weakref": "declare the function itself with the attribute 'weak'",
    "scalar_storage_order": _BYTES,
    "ms_struct": _BYTES,
    "gcc_struct": "it is the default: leave the attribute out",
}
"""Attributes that cannot be ignored: a program would behave differently."""


@dataclass(slots=True, eq=False)
class Attribute:
    """One attribute.

    Attributes:
        name: its name, without the underscores around it.
        words: the tokens of its arguments, without commas.
        value: its first argument as an expression, set by the parser; the alignment for `PACK`.
    """

    name: str
    location: Location
    words: list[Token] = field(default_factory=list)
    value: Node = None


def take_attributes(
    tokens: Sequence[Token], diagnostics: Diagnostics
) -> tuple[list[Token], dict[Token, list[Attribute]]]:
    """Separate a file's attributes from its other tokens.

    Returns:
        The other tokens, and the attributes by the token that they precede. `#pragma pack` is
        attached to the token after the keyword `struct` or `union`.
    """
    rest: list[Token] = []
    before: dict[Token, list[Attribute]] = {}
    waiting: list[Attribute] = []
    pack = _Pack()
    index = 0
    for start in [number for number, token in enumerate(tokens) if token.value in _OPENING]:
        is_bracketed = tokens[start].type == "LBRACKET"
        if start < index or (is_bracketed and not _opens_attributes(tokens, start)):
            continue
        waiting = _keep(tokens[index:start], rest, before, waiting, pack.align)
        inside, index = _inside(tokens, start if is_bracketed else start + 1)
        if inside is None:
            text = f"expected '((' after '{KEYWORD}'"
            diagnostics.error(tokens[start].location, text)
            continue
        for attribute in _split(inside):
            if attribute.name == PACK:
                pack.apply(attribute, diagnostics)
            elif attribute.name == ASM_LABEL or _accepts(attribute, diagnostics):
                waiting.append(attribute)
    _keep(tokens[index:], rest, before, waiting, pack.align)
    return rest, before


def _keep(
    tokens: Sequence[Token],
    rest: list[Token],
    before: dict[Token, list[Attribute]],
    waiting: list[Attribute],
    align: int,
) -> list[Attribute]:
    """Append tokens between attributes, the first of which those that are waiting precede.

    Returns:
        The attributes that wait for the next token.
    """
    rest += tokens
    if waiting and tokens:
        before[tokens[0]] = waiting
        waiting = []
    if align:
        for number, token in enumerate(tokens, 1):
            if token.type in {"STRUCT", "UNION"}:
                found = [Attribute(PACK, token.location, value=align)]
                if number == len(tokens):
                    return found
                before[tokens[number]] = found
    return waiting


_OPENING: Final = frozenset({KEYWORD, "["})
_DEPTH: Final = {"LPAREN": 1, "RPAREN": -1, "LBRACKET": 1, "RBRACKET": -1}


def _inside(tokens: Sequence[Token], start: int) -> tuple[Sequence[Token] | None, int]:
    """Return the tokens inside `((...))` or `[[...]]`, and the index after them; None if none."""
    depth = 0
    for index in range(start, len(tokens)):
        depth += _DEPTH.get(tokens[index].type, 0)
        if depth < min(2, index - start + 1) and index - start < 2:
            return None, index
        if depth == 0:
            return tokens[start + 2 : index - 1], index + 1
    return None, len(tokens)


def _opens_attributes(tokens: Sequence[Token], index: int) -> bool:
    """Return whether `[` starts `[[...]]`; nothing else in C starts with two brackets."""
    return index + 1 < len(tokens) and tokens[index + 1].type == "LBRACKET"


def _split(tokens: Sequence[Token]) -> list[Attribute]:
    """Return the attributes of a comma-separated list."""
    found: list[Attribute] = []
    depth, is_first = 0, True
    for token in tokens:
        if depth == 0 and token.type == "COMMA":
            is_first = True
        elif depth == 0 and token.type == "COLON":  # `gnu::packed`
            if not is_first:
                found.pop()
            is_first = True
        elif is_first:
            name = token.value
            if (
                len(name) > 4
                and name.startswith("__")
                and name.endswith("__")
                and name not in _INTERNAL
            ):
                name = name[2:-2]
            found.append(Attribute(name, token.location))
            is_first = False
        else:
            depth -= token.type == "RPAREN"
            if depth > 0 and (depth > 1 or token.type != "COMMA"):
                found[-1].words.append(token)
            depth += token.type == "LPAREN"
    return found


def _accepts(attribute: Attribute, diagnostics: Diagnostics) -> bool:
    """Return whether an attribute is implemented; report it if it is unknown or unsupported."""
    name = attribute.name
    if name in _UNSUPPORTED:
        text = f"attribute '{name}' is not supported"
        diagnostics.error(attribute.location, text, _UNSUPPORTED[name])
    elif name not in _IMPLEMENTED and name not in _IGNORED:
        close = difflib.get_close_matches(name, sorted(_IMPLEMENTED | _IGNORED), n=1)
        hint = f"did you mean '{close[0]}'?" if close else ""
        diagnostics.warning(
            attribute.location, f"unknown attribute '{name}' is ignored", hint, flag="attributes"
        )
    return name in _IMPLEMENTED


@dataclass(slots=True)
class _Pack:
    """The state of `#pragma pack` at some point of the file.

    Attributes:
        align: the maximum alignment of members; 0 if there is none.
    """

    align: int = 0
    _stack: list[tuple[str, int]] = field(default_factory=list)

    def apply(self, pragma: Attribute, diagnostics: Diagnostics) -> None:
        """Apply `pack(push, 1)`, `pack(pop)`, `pack(2)` or `pack()`."""
        words = [each.value for each in pragma.words]
        action = words.pop(0) if words and words[0] in {"push", "pop"} else ""
        label = words.pop(0) if action and words and words[0].isidentifier() else ""
        number = words.pop(0) if words else ""
        if words or (number and number not in {"0", "1", "2", "4", "8", "16"}):
            diagnostics.warning(
                pragma.location, "invalid '#pragma pack' is ignored", flag="pragmas"
            )
            return
        if action == "push":
            self._stack.append((label, self.align))
        elif action == "pop" and not self._pop(label):
            diagnostics.warning(
                pragma.location, "'#pragma pack(pop)' without a push before it", flag="pragmas"
            )
        if number or not action:
            self.align = int(number or 0)

    def _pop(self, label: str) -> bool:
        """Restore the state before the last push (with this label); return whether there is one."""
        while self._stack:
            name, self.align = self._stack.pop()
            if not label or name == label:
                return True
        return False
