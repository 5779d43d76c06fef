"""Tokens to pycparser's syntax tree, with messages for all syntax errors of a file.

A node's `coord` is a `Token` or a `Span` of tokens, which know their location in the user's file.

>>> from crs_cc.frontend.parse.lexer import lex
>>> from crs_cc.core.source import Diagnostics, Location
>>> diagnostics = Diagnostics()
>>> def locate(line, column): return Location("a.c", line, column)
>>> nodes = parse(lex("main() { return 0 }", locate, diagnostics), diagnostics)
>>> for message in diagnostics.messages:
...     print(message.render())
a.c:1:1: warning: type specifier missing, defaults to 'int' [-Wimplicit-int]
a.c:1:18: error: expected ';' after '0'
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from crs_cc.core.source import Diagnostics
from crs_cc.frontend.parse.grammar import Grammar
from crs_cc.frontend.parse.header_memory import HeaderTokens
from crs_cc.frontend.parse.lexer import Token
from crs_cc.frontend.parse.nodes import Node


def parse(
    tokens: Sequence[Token],
    diagnostics: Diagnostics,
    standard: str = "gnu17",
    headers: Mapping[Token, HeaderTokens] | None = None,
) -> list[Node]:
    """Return the external declarations of a preprocessed file.

    Args:
        tokens: the file.
        diagnostics: receives the messages.
        standard: the C standard, a key of `STANDARDS`.
        headers: the parts of the file that come from our headers, by their first tokens.

    Returns:
        The declarations; a `Broken` for each one with a syntax error.

    Raises:
        CompilationAborted: too many errors, or too deep a nesting.
    """
    grammar = Grammar(tokens, diagnostics, standard, headers=headers)
    try:
        return grammar.translation_unit()
    finally:
        grammar.__dict__.clear()  # its parts refer to it: tokens would stay until a collection


def parse_expression(
    tokens: Sequence[Token],
    type_names: Iterable[str],
    diagnostics: Diagnostics,
    standard: str = "gnu17",
) -> Node | None:
    """Return the tree of a single expression; None if it has a syntax error."""
    return Grammar(tokens, diagnostics, standard, type_names).expression()
