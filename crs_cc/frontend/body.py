"""Wraps a control program that consists of bare statements in a function.

The report's dialect allows it: "the commands in code running on a real scout can be copied without
the C headers into the control code class", where they become the method `runcode`. There may be
functions before and after the body; declarations right before its first statement belong to it.
The function is inserted as tokens at the locations of the body's first and last token, so that no
line or column changes.

>>> from crs_cc.frontend.parse.lexer import lex
>>> from crs_cc.core.source import Diagnostics, Location
>>> def tokens_of(text):
...     return lex(text, lambda line, column: Location("a.c", line, column), Diagnostics())
>>> source = "void f() { st(); } int far = 9; vm(far);"
>>> " ".join(token.value for token in with_body(tokens_of(source), "a.c", Diagnostics()))
'void f ( ) { st ( ) ; } int runcode ( void ) { int far = 9 ; vm ( far ) ; }'
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import Final, Literal, TypeAlias

from crs_cc.core.source import Diagnostics
from crs_cc.frontend.check.scope import ENTRIES
from crs_cc.frontend.error_limit import report
from crs_cc.frontend.parse.lexer import Token

Kind: TypeAlias = Literal["declaration", "function", "statement", "stray"]

_CONTROLS: Final = frozenset({
    "BREAK", "CASE", "CONTINUE", "DEFAULT", "DO", "ELSE", "FOR", "GOTO", "IF", "LBRACE", "RETURN",
    "SWITCH", "WHILE",
})  # fmt: skip
_DECLARES: Final = frozenset({
    "AUTO", "CHAR", "CONST", "DOUBLE", "ENUM", "EXTERN", "FLOAT", "INLINE", "INT", "LONG",
    "REGISTER", "SEMI", "SHORT", "SIGNED", "STATIC", "STRUCT", "TYPEDEF", "TYPEOF", "UNION",
    "UNSIGNED", "VOID", "VOLATILE", "_ALIGNAS", "_ATOMIC", "_BOOL", "_NORETURN", "_STATIC_ASSERT",
    "_THREAD_LOCAL",
})  # fmt: skip
_TYPES: Final = _DECLARES - {"SEMI"}
"""What may follow the parameters of an old-style definition."""

_AFTER_DECLARATOR: Final = frozenset({"COMMA", "EQUALS", "LBRACKET", "LPAREN", "SEMI"})
_CLOSED_BY: Final = {"LPAREN": "RPAREN", "LBRACKET": "RBRACKET", "LBRACE": "RBRACE"}

_HINT: Final = (
    "statements must be inside a function; for a program without functions use --dialect report"
)


@dataclass(slots=True)
class Item:
    """An item at the outermost level of a file.

    Attributes:
        kind: its kind, judged by its first tokens and braces; an unmatched `}` is stray.
        start: the index of its first token.
        stop: the index after its last token.
        name: the name of a function.
    """

    kind: Kind
    start: int
    stop: int = 0
    name: str = ""


def with_body(tokens: Sequence[Token], file: str, diagnostics: Diagnostics) -> list[Token]:
    """Return a file's tokens with the statements at its outermost level wrapped in `runcode`.

    Args:
        tokens: the file, its headers included.
        file: the name of the file itself.
        diagnostics: receives messages about unmatched braces.

    Returns:
        The tokens, unchanged if there are no such statements or one of
        `check.scope.ENTRIES` is defined.

    Raises:
        CompilationAborted: too many errors.
    """
    items = list(items_of(tokens))
    statements = [number for number, item in enumerate(items) if item.kind == "statement"]
    if not statements or any(item.name in ENTRIES for item in items):
        return list(tokens)
    first, last = statements[0], statements[-1]
    while first > 0 and _belongs(items[first - 1], tokens, file):
        first -= 1
    while last + 1 < len(items) and items[last + 1].kind == "stray":
        last += 1
    start, stop = items[first].start, items[last].stop
    body = _balanced(tokens[start:stop], diagnostics)
    begin = [("INT", "int"), ("ID", "runcode"), ("LPAREN", "("), ("VOID", "void"), ("RPAREN", ")")]
    head = [tokens[start].copy(*each) for each in (*begin, ("LBRACE", "{"))]
    end = tokens[stop - 1].copy("RBRACE", "}")
    return [*tokens[:start], *head, *body, end, *tokens[stop:]]


def suggest_dialect(tokens: Sequence[Token], diagnostics: Diagnostics) -> None:
    """Add a hint to the first error in a file that looks like the body of a program."""
    items = list(items_of(tokens))
    is_body = any(item.kind == "statement" for item in items)
    first = diagnostics.errors[0]
    if is_body and not first.hint and not any(item.name in ENTRIES for item in items):
        index = diagnostics.messages.index(first)
        diagnostics.messages[index] = replace(first, hint=_HINT)


def _belongs(item: Item, tokens: Sequence[Token], file: str) -> bool:
    """Return whether an item right before the body is part of it."""
    return item.kind == "declaration" and tokens[item.start].location.file == file


def _balanced(body: Sequence[Token], diagnostics: Diagnostics) -> list[Token]:
    """Return the body with balanced braces; report those that do not match."""
    kept: list[Token] = []
    opened: list[Token] = []
    for token in body:
        if token.type == "LBRACE":
            opened.append(token)
        elif token.type == "RBRACE":
            if not opened:
                text = "extraneous closing brace ('}')"
                hint = "there is no matching '{'"
                report(diagnostics, token.location, text, hint)
                continue
            opened.pop()
        kept.append(token)
    if opened:
        place = opened[-1].location
        diagnostics.error(
            body[-1].location, "unexpected end of file", f"to close the '{{' at {place}"
        )
    return kept + [token.copy("RBRACE", "}") for token in opened]


def items_of(tokens: Sequence[Token]) -> Iterator[Item]:
    """Yield the items of a file in order; together they cover all tokens."""
    start = 0
    while start < len(tokens):
        item = _item(tokens, start)
        yield item
        start = item.stop


def _item(tokens: Sequence[Token], start: int) -> Item:
    item = Item(_kind(tokens, start), start)
    is_control = tokens[start].type in _CONTROLS
    brackets = _Brackets()
    ends_with_brace, is_set, is_old_style = is_control, False, False
    for index in range(start, len(tokens)):
        token = tokens[index]
        if not brackets.opened:
            is_set = is_set or token.type == "EQUALS"
            closes = index > start and tokens[index - 1].type == "RPAREN"
            is_old_style = is_old_style or (
                closes and not (is_control or is_set) and token.type in _TYPES
            )
            if token.type == "LBRACE" and not (is_control or is_set) and (closes or is_old_style):
                item.kind, item.name = "function", _name(tokens[start:index])
                ends_with_brace = True
        brackets.read(token.type)
        ends = token.type == "SEMI" and not is_old_style
        ends = ends or (token.type == "RBRACE" and (ends_with_brace or index == start))
        if not brackets.opened and ends:
            item.stop = index + 1
            return item
    item.stop = len(tokens)
    return item


@dataclass(slots=True)
class _Brackets:
    """The open parentheses, brackets and braces.

    Unmatched closing ones are ignored; a closing brace also closes what was opened inside it.
    """

    opened: list[str] = field(default_factory=list)
    braces: int = 0

    def read(self, kind: str) -> None:
        """Advance by one token of a type."""
        if kind in _CLOSED_BY:
            self.opened.append(kind)
            self.braces += kind == "LBRACE"
        elif kind == "RBRACE" and self.braces:
            self.braces -= 1
            while self.opened.pop() != "LBRACE":
                pass
        elif self.opened and _CLOSED_BY[self.opened[-1]] == kind:
            self.opened.pop()


def _kind(tokens: Sequence[Token], start: int) -> Kind:
    """Return the kind of the item that starts at a token, before any brace is read."""
    first, *others = (token.type for token in tokens[start : start + 2])
    if first in _DECLARES or tokens[start].value in ("__attribute__", "__auto_type"):
        return "declaration"
    if first == "RBRACE":
        return "stray"
    if first != "ID" or not others:
        return "statement"
    index = start + 1
    while index < len(tokens) and tokens[index].type == "TIMES":
        index += 1
    is_name = index < len(tokens) and tokens[index].type == "ID"
    following = tokens[index + 1].type if index + 1 < len(tokens) else ""
    declares = is_name and (index == start + 1 or following in _AFTER_DECLARATOR)
    return "declaration" if declares else "statement"


def _name(tokens: Sequence[Token]) -> str:
    """Return the name of a function, given its declarator."""
    for name, following in pairwise(tokens):
        if name.type == "ID" and following.type == "LPAREN":
            return name.value
    return ""
