"""Remembers, for the process, the syntax trees of our headers, most of what a small program is.

A tree is used again only where it could not be another: for lines of the same text from the same
places of a header (whatever macros and options made them so), where each name in them is a type or
not, or is unknown, as it was before. Trees are remembered only from files without any message
so far, and never change. Their nodes' locations are those in the header, which are the same in
every program.
"""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from dataclasses import dataclass, field
from typing import Final, TypeVar

from pycparser import c_ast

from crs_cc.core.source import Diagnostics
from crs_cc.frontend.parse.gnu_attributes import Attribute
from crs_cc.frontend.parse.lexer import Token, lex
from crs_cc.frontend.parse.nodes import Node, Prototype
from crs_cc.frontend.parse.token_stream import NAMES, TokenStream
from crs_cc.frontend.preprocess.gnu import PACK
from crs_cc.frontend.preprocess.output import HeaderLines, Preprocessed

Key = TypeVar("Key")
Value = TypeVar("Value")

MAX_PIECES: Final = 200
"""How many pieces of headers are remembered: all of ours, some of them in several forms."""

MAX_TREES: Final = 8
"""How many trees of a piece are remembered, which differ in what was declared before."""


@dataclass(frozen=True, slots=True)
class _Tree:
    """The declarations of a piece.

    Attributes:
        nodes: the declarations.
        kinds: the types of the tokens that they were made of.
        declared: the names that they declare, and whether as types.
    """

    nodes: tuple[Node, ...]
    kinds: tuple[str, ...]
    declared: dict[str, bool]


@dataclass(frozen=True, slots=True)
class _Piece:
    """A piece of a header: lines that are not interrupted by another file.

    Attributes:
        words: the tokens: type, text, line (counted from 0) and column of each.
        names: the identifiers among them.
        trees: the trees, by what each name was before.
    """

    words: tuple[tuple[str, str, int, int], ...]
    names: tuple[str, ...]
    trees: dict[tuple[bool | None, ...], _Tree] = field(default_factory=dict)

    def meanings(self, stream: TokenStream) -> tuple[bool | None, ...]:
        """Return for each name whether it is a type, None for an unknown one."""
        return tuple(map(stream.scopes[0].get, self.names))


_pieces: dict[Hashable, _Piece] = {}


def remembered() -> tuple[int, int]:
    """Return the number of pieces of headers that are remembered, and the most trees of one."""
    return len(_pieces), max((len(each.trees) for each in _pieces.values()), default=0)


@dataclass(frozen=True, slots=True)
class HeaderTokens:
    """The tokens of lines of a header in a file: the last one, and the piece."""

    last: Token
    piece: _Piece

    def recall(self, stream: TokenStream) -> tuple[Node, ...] | None:
        """Return the declarations and move after them; None if they are not known."""
        known = self.piece.trees.get(self.piece.meanings(stream))
        if known is None:
            return None
        stop = stream.index + len(known.kinds)
        if stream.buffer[stop - 1 : stop] != [self.last]:  # tokens were added or taken out
            return None
        for token, kind in zip(stream.buffer[stream.index : stop], known.kinds, strict=True):
            token.type = kind
        stream.scopes[0].update(known.declared)
        stream.classified = None
        stream.index = stop
        return known.nodes


class Parse:
    """A parse of the lines of a header, which starts at the next token."""

    def __init__(self, tokens: HeaderTokens, stream: TokenStream) -> None:
        self._tokens = tokens
        self._stream = stream
        self._start = stream.index
        self._before = tokens.piece.meanings(stream)

    def is_over(self) -> bool:
        """Return whether the last token of the lines was the last one of a declaration."""
        return self._stream.buffer[self._stream.index - 1] is self._tokens.last

    def remember(self, nodes: list[Node]) -> None:
        """Remember the declarations of a correct file, unless they may be changed later."""
        if not self.is_over() or not all(map(_is_constant, nodes)):
            return
        piece, stream = self._tokens.piece, self._stream
        after = zip(piece.names, self._before, piece.meanings(stream), strict=True)
        declared = {name: now for name, before, now in after if now is not None and now != before}
        kinds = tuple(token.type for token in stream.buffer[self._start : stream.index])
        tree = _Tree(tuple(map(_shared, nodes)), kinds, declared)
        _put(piece.trees, self._before, tree, MAX_TREES)


def lex_program(
    source: Preprocessed, diagnostics: Diagnostics, standard: str
) -> tuple[list[Token], dict[Token, HeaderTokens]]:
    """Return the tokens of a program, and those of our headers among them by the first of each.

    Args:
        source: the program.
        diagnostics: receives errors; invalid tokens are left out.
        standard: the C standard, which determines the keywords.
    """
    tokens: list[Token] = []
    headers: dict[Token, HeaderTokens] = {}
    line = 1
    for lines in source.pieces():
        if isinstance(lines, HeaderLines):
            text = lines.text
            found, piece = _lex_header(lines, diagnostics, standard)
            if found and piece is not None:
                headers[found[0]] = HeaderTokens(found[-1], piece)
        else:
            text = lines
            found = lex(text, source.location, diagnostics, standard, line)
        tokens += found
        line += text.count("\n") + 1
    return tokens, headers


def _lex_header(
    lines: HeaderLines, diagnostics: Diagnostics, standard: str
) -> tuple[list[Token], _Piece | None]:
    first, locate, content = lines.first, lines.location, lines.content()
    piece = _pieces.get((content, standard))
    if piece is not None:
        made = [
            Token(kind, word, first + line, column, locate)
            for kind, word, line, column in piece.words
        ]
        return made, piece
    before = len(diagnostics.messages)
    tokens = lex(lines.text, locate, diagnostics, standard, first)
    if content is None or len(diagnostics.messages) > before:
        return tokens, None
    words = tuple((each.type, each.value, each.lineno - first, each.column) for each in tokens)
    names = tuple(dict.fromkeys(each.value for each in tokens if each.type in NAMES))
    piece = _Piece(words, names)
    _put(_pieces, (content, standard), piece, MAX_PIECES)
    return tokens, piece


def unaffected(
    headers: Mapping[Token, HeaderTokens], attributes: Mapping[Token, list[Attribute]]
) -> Mapping[Token, HeaderTokens]:
    """Return those headers whose declarations have no attributes from before the header.

    Args:
        headers: the parts of a file that come from our headers, by their first tokens.
        attributes: all attributes of the file, by the token that they precede.
    """
    if any(each.name == PACK for found in attributes.values() for each in found):
        return {}
    return {first: header for first, header in headers.items() if first not in attributes}


def _is_constant(node: Node) -> bool:
    """Return whether nothing changes the tree of a declaration: it has neither body nor value."""
    if isinstance(node, c_ast.Decl):
        return node.init is None
    return isinstance(node, c_ast.Typedef)


def _shared(node: Node) -> Node:
    """Return the node of a declaration for later programs."""
    return Prototype(node) if isinstance(node.type, c_ast.FuncDecl) else node


def _put(known: dict[Key, Value], key: Key, value: Value, most: int) -> None:
    """Enter a value, and forget the oldest ones of too many."""
    for oldest in list(known)[: max(0, len(known) - most + 1)]:
        known.pop(oldest, None)  # perhaps another thread has
    known[key] = value
