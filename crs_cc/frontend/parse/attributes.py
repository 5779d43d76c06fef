"""Gives each declaration and each struct the attributes that stand around it.

They go into the `attributes` of pycparser's `Decl`, `Typedef`, `Struct` and `Union` nodes, which
it fills for C23 only.
"""

from __future__ import annotations

from typing import Any

from pycparser import c_ast

from crs_cc.frontend.parse.gnu_attributes import Attribute
from crs_cc.frontend.parse.suspicious import Node, WarningParser
from crs_cc.frontend.preprocess.gnu import PACK

_OPERANDS = frozenset({"aligned", "constructor", "destructor"})
"""Attributes whose argument is an expression."""


class AttributeParser(WarningParser):
    """The parser of declarations that collects attributes.

    `_before` has them by the token that they stand before; whoever collects takes them out.
    """

    _before: dict[Any, list[Attribute]]

    def _taken(self, start: int, stop: int) -> list[Attribute]:
        """Takes the attributes before some tokens, by the tokens' numbers."""
        if not self._before:
            return []
        found: list[Attribute] = []
        for token in self._buffer[start:stop]:
            found += self._before.pop(token, [])
        for each in found:
            if each.name in _OPERANDS and each.words and each.value is None:
                each.value = self._operand(each)
        return found

    def _operand(self, attribute: Attribute) -> Node:
        """Parses an attribute's argument."""
        outside = self._buffer, self._index
        self._buffer, self._index = [*attribute.words, *[None] * 64], 0
        try:
            node = self._parse_conditional_expression()
            if self._peek() is not None:
                self._parse_error("expected ')'", None)
            return node
        finally:
            self._buffer, self._index = outside

    def _parse_unary_expression(self) -> Node:
        """Parses GNU's `__alignof__ expression` as `sizeof expression` is parsed, too."""
        token = self._accept("_ALIGNOF")
        if token is None:
            return super()._parse_unary_expression()
        found = self._try_parse_paren_type_name()
        if found is not None and self._peek_type() != "LBRACE":
            return c_ast.UnaryOp("_Alignof", found[0], token)
        if found is not None:
            self._reset(found[1])
        return c_ast.UnaryOp("_Alignof", self._parse_unary_expression(), token)

    def _parse_struct_or_union_specifier(self) -> Node:
        start = self._index
        begin = self._taken(start + 1, start + 3)
        node = super()._parse_struct_or_union_specifier()
        if node.decls is None:
            begin = [each for each in begin if each.name != PACK]
        else:
            begin += self._taken(self._index, self._index + 1)
        node.attributes = begin
        return node

    def _parse_specifiers(self, *, allow_storage_and_function: bool) -> Any:
        start = self._index
        spec, saw_type, first = super()._parse_specifiers(
            allow_storage_and_function=allow_storage_and_function
        )
        found = self._taken(start, self._index + 1)
        if spec is not None and found:
            spec["gnu_attributes"] = found
        return spec, saw_type, first

    def _parse_declarator_kind(self, kind: str, allow_paren: bool) -> Node:
        start = self._index
        node = super()._parse_declarator_kind(kind, allow_paren)
        self._add(node, self._taken(start + 1, self._index + 1))
        return node

    def _parse_struct_declarator(self) -> Any:
        found = super()._parse_struct_declarator()
        self._add(found["decl"], self._taken(self._index, self._index + 1))
        return found

    def _add(self, declarator: Node, found: list[Attribute]) -> None:
        """Keeps the attributes of a declarator with its name until its declaration is made."""
        if found:
            while not isinstance(declarator, c_ast.TypeDecl):
                declarator = declarator.type
            declarator.attributes = [*(declarator.attributes or []), *found]

    def _build_declarations(
        self, spec: Any, decls: Any, typedef_namespace: bool = False
    ) -> list[Node]:
        built: list[Node] = super()._build_declarations(spec, decls, typedef_namespace)
        shared = spec.get("gnu_attributes", [])
        for node in built:
            inner = node.type
            while isinstance(inner, c_ast.PtrDecl | c_ast.ArrayDecl | c_ast.FuncDecl):
                inner = inner.type
            own = inner.attributes if isinstance(inner, c_ast.TypeDecl) else None
            if shared or own:
                node.attributes = [*shared, *(own or [])]
        return built
