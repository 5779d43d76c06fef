"""Attaches GNU attributes to the declarations and structs that they belong to.

They go into the `attributes` of pycparser's `Decl`, `Typedef`, `Struct` and `Union` nodes, which
pycparser itself fills for C23 only.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Final

from pycparser import c_ast

from crs_cc.frontend.parse.gnu_attributes import Attribute
from crs_cc.frontend.parse.lexer import Token
from crs_cc.frontend.parse.nodes import Node
from crs_cc.frontend.parse.token_stream import TokenStream
from crs_cc.frontend.preprocess.gnu import PACK

_OPERANDS: Final = frozenset({"aligned", "constructor", "destructor"})
"""Attributes whose argument is an expression."""

_SHARED: Final = "gnu_attributes"
"""The key of the attributes in pycparser's dictionary of declaration specifiers."""


class Attributes:
    """The attributes of a file, by the token that they precede."""

    def __init__(
        self,
        before: Mapping[Token, list[Attribute]],
        stream: TokenStream,
        parse_operand: Callable[[], Node],
    ) -> None:
        """Set up the collection.

        Args:
            before: the attributes.
            stream: the file.
            parse_operand: parses an expression that is all there is in the stream.
        """
        self._before = dict(before)
        self._stream = stream
        self._parse_operand = parse_operand

    def take(self, start: int, stop: int | None = None) -> list[Attribute]:
        """Remove and return the attributes before some tokens.

        Args:
            start: the position of the first token.
            stop: the position after the last one; if not given, after the next token.
        """
        if not self._before:
            return []
        found: list[Attribute] = []
        stream = self._stream
        for token in stream.buffer[start : stream.index + 1 if stop is None else stop]:
            found += self._before.pop(token, [])
        for each in found:
            if each.name in _OPERANDS and each.words and each.value is None:
                with stream.reading(each.words):
                    each.value = self._parse_operand()
        return found

    def attach_to_record(self, node: Node, found: list[Attribute]) -> None:
        """Attach the attributes before a struct or union, and those after its members."""
        if node.decls is None:
            found = [each for each in found if each.name != PACK]
        else:
            found += self.take(self._stream.index)
        node.attributes = found

    def attach_to_specifiers(self, spec: Any, found: list[Attribute]) -> None:
        """Attach attributes to declaration specifiers."""
        if spec is not None and found:
            spec[_SHARED] = found

    def attach_to_declarator(self, declarator: Node, found: list[Attribute]) -> None:
        """Attach attributes to a declarator's name until its declaration is built."""
        if found:
            while not isinstance(declarator, c_ast.TypeDecl):
                declarator = declarator.type
            declarator.attributes = [*(declarator.attributes or []), *found]

    def attach_to_declarations(self, spec: Any, built: list[Node]) -> None:
        """Attach to each declaration the attributes of its specifiers and of its declarator."""
        shared = spec.get(_SHARED, [])
        for node in built:
            inner = node.type
            while isinstance(inner, c_ast.PtrDecl | c_ast.ArrayDecl | c_ast.FuncDecl):
                inner = inner.type
            own = inner.attributes if isinstance(inner, c_ast.TypeDecl) else None
            if shared or own:
                node.attributes = [*shared, *(own or [])]
