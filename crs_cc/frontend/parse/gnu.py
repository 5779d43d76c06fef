"""What GNU C adds to the grammar: labels as values, ranges, old designators, `typeof`.

This stands between pycparser's parser, which knows standard C, and ours (`parse`), which knows our
tokens and messages. Nodes that pycparser has no class for are here.
"""

from __future__ import annotations

from typing import Any, Final

from pycparser import c_ast
from pycparser.c_parser import CParser

TYPE_ARGUMENTS: Final = frozenset({"__builtin_types_compatible_p"})
"""Functions whose arguments are types."""

AUTO_TYPE: Final = "__auto_type"
"""The name that stands for the type of a variable's initial value."""


class GnuNode(c_ast.Node):  # type: ignore[misc]
    """A node without a class in pycparser; nobody asks for its children."""

    __slots__ = ("coord",)

    def __init__(self, coord: Any) -> None:
        self.coord = coord

    def children(self) -> tuple[()]:
        """Gives the nodes inside: none."""
        return ()


class LabelAddress(GnuNode):
    """`&&name`."""

    __slots__ = ("name",)

    def __init__(self, name: str, coord: Any) -> None:
        super().__init__(coord)
        self.name = name


class ComputedGoto(GnuNode):
    """`goto *target;`."""

    __slots__ = ("target",)

    def __init__(self, target: Any, coord: Any) -> None:
        super().__init__(coord)
        self.target = target


class LocalLabels(GnuNode):
    """`__label__ names;`: labels that belong to the present block."""

    __slots__ = ("names",)

    def __init__(self, names: list[str], coord: Any) -> None:
        super().__init__(coord)
        self.names = names


class Range(GnuNode):
    """`first ... last`, in a `case` or a designator."""

    __slots__ = ("first", "last")

    def __init__(self, first: Any, last: Any, coord: Any) -> None:
        super().__init__(coord)
        self.first = first
        self.last = last


class GnuParser(CParser):  # type: ignore[misc]
    """pycparser's parser with GNU C's additions."""

    def _parse_unary_expression(self) -> Any:
        token = self._peek()
        if token is not None and token.type == "LAND":
            self._advance()
            name = self._expect("ID")
            return LabelAddress(name.value, self._tok_coord(token))
        return super()._parse_unary_expression()

    def _parse_primary_expression(self) -> Any:
        token = self._peek()
        if token is None or token.type != "ID" or token.value not in TYPE_ARGUMENTS:
            return super()._parse_primary_expression()
        self._advance()
        self._expect("LPAREN")
        types = [self._parse_type_name()]
        while self._accept("COMMA"):
            types.append(self._parse_type_name())
        self._expect("RPAREN")
        coord = self._tok_coord(token)
        name = c_ast.ID(token.value, coord)
        return c_ast.FuncCall(name, c_ast.ExprList(types, coord), coord)

    def _parse_jump_statement(self) -> Any:
        if self._peek_type() != "GOTO" or self._peek_type(2) != "TIMES":
            return super()._parse_jump_statement()
        token = self._advance()
        self._advance()
        target = self._parse_expression()
        self._expect("SEMI")
        return ComputedGoto(target, self._tok_coord(token))

    def _parse_block_item(self) -> Any:
        token = self._peek()
        if token is None or token.type != "__LABEL__":
            return super()._parse_block_item()
        self._advance()
        names = [self._expect("ID").value]
        while self._accept("COMMA"):
            names.append(self._expect("ID").value)
        self._expect("SEMI")
        return LocalLabels(names, self._tok_coord(token))

    # `case` and designators ask for a constant expression, which may turn out to be a range.

    def _parse_constant_expression(self) -> Any:
        first = super()._parse_constant_expression()
        dots = self._accept("ELLIPSIS")
        if dots is None:
            return first
        return Range(first, super()._parse_constant_expression(), first.coord)

    def _parse_initializer_item(self) -> Any:
        token = self._peek()
        if token is None or token.type not in {"ID", "TYPEID"} or self._peek_type(2) != "COLON":
            return super()._parse_initializer_item()
        self._advance()
        self._advance()
        member = c_ast.ID(token.value, self._tok_coord(token))
        return c_ast.NamedInitializer([member], self._parse_initializer())

    def _parse_designation(self) -> Any:
        """Parses designators and the `=` behind them, without which `[3] 4` is understood."""
        designators = self._parse_designator_list()
        if self._accept("EQUALS") is None:
            is_old = len(designators) == 1 and isinstance(designators[0], c_ast.ArrayDesignator)
            if not is_old:
                self._expect("EQUALS")
        return designators
