"""The grammar: pycparser's, extended to GNU C and to C90, with recovery from errors.

`Grammar` overrides methods of pycparser 3.12's parser for four reasons:

- It reads the tokens from a `TokenStream`, and a node's `coord` is a `Token`, or a `Span` where
  a message may concern a whole operation: pycparser notes the first token of the first operand,
  which is the same for `a / b` and `a / b / c`.
- GNU C: labels as values, ranges, old designators, attributes.
- Errors do not end the parse: what was expected is reported and the statement or declaration is
  skipped. The objects that a `Grammar` holds do this; they are called where something may be
  wrong, and leave tokens that the grammar can go on with.
- Speed, where an operand is just a name or a number.
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterable, Sequence
from typing import Any, Final, NoReturn

from pycparser import c_ast
from pycparser.c_parser import CParser, ParseError

from crs_cc.core.source import Diagnostics
from crs_cc.frontend.error_limit import GiveUp, report
from crs_cc.frontend.parse.attributes import Attributes
from crs_cc.frontend.parse.gnu_attributes import take_attributes
from crs_cc.frontend.parse.keyword_typos import KeywordTypos
from crs_cc.frontend.parse.lexer import Token
from crs_cc.frontend.parse.nodes import (
    PREDECLARED_TYPES,
    TYPE_ARGUMENTS,
    ComputedGoto,
    LabelAddress,
    LocalLabels,
    Node,
    Range,
)
from crs_cc.frontend.parse.omissions import Omissions
from crs_cc.frontend.parse.recovery import skip_broken
from crs_cc.frontend.parse.syntax_errors import SyntaxErrors
from crs_cc.frontend.parse.token_stream import NAMES, TokenStream
from crs_cc.frontend.parse.token_warnings import TokenWarnings

_LEAVES: Final = frozenset({"ID", "INT_CONST_DEC"})
_SUFFIXES: Final = frozenset({"LBRACKET", "LPAREN", "PERIOD", "ARROW", "PLUSPLUS", "MINUSMINUS"})
_PREFIXES: Final = frozenset(
    {"PLUSPLUS", "MINUSMINUS", "AND", "TIMES", "PLUS", "MINUS", "NOT", "LNOT"}
)
_PRECEDENCE: Final = {
    "LOR": 0, "LAND": 1, "OR": 2, "XOR": 3, "AND": 4, "EQ": 5, "NE": 5,
    "LT": 6, "GT": 6, "LE": 6, "GE": 6, "LSHIFT": 7, "RSHIFT": 7, "PLUS": 8, "MINUS": 8,
    "TIMES": 9, "DIVIDE": 9, "MOD": 9,
}  # fmt: skip
"""How tightly each binary operator binds (C17 6.5.5 to 6.5.14)."""

_WITHOUT_TYPE: Final = frozenset({"ID", "TIMES", "LPAREN"})
"""The tokens that start a declaration whose type is left out."""

_EXTERNAL: Final = frozenset({"SEMI", "PPHASH", "PPPRAGMA", "_PRAGMA", "_STATIC_ASSERT"})
"""Other tokens that may start an external declaration."""

_MAX_DERIVATIONS: Final = 200
"""How many pointers, arrays and functions one declarator may stack up."""


class Grammar(CParser):  # type: ignore[misc]
    """A parser for one file."""

    def __init__(
        self, tokens: Sequence[Token], diagnostics: Diagnostics, type_names: Iterable[str] = ()
    ) -> None:
        """Take the tokens, out of which attributes are taken and kept apart.

        Args:
            tokens: the file.
            diagnostics: receives the messages.
            type_names: further names that are types.
        """
        rest, before = take_attributes(tokens, diagnostics)
        stream = self._stream = TokenStream(rest, [*PREDECLARED_TYPES, *type_names])
        super().__init__()
        self._scope_stack = stream.scopes
        self._peek = stream.peek
        self._peek_type = stream.peek_type
        self._accept = stream.accept
        self._mark = stream.mark
        self._reset = stream.reset
        self._diagnostics = diagnostics
        self._errors = SyntaxErrors(stream, diagnostics)
        self._warnings = TokenWarnings(stream, diagnostics)
        self._attributes = Attributes(before, stream, self._attribute_operand)
        self._typos = KeywordTypos(stream, diagnostics)
        self._omissions = Omissions(stream, diagnostics, self._typos, self._starts_declaration)
        self._type_names: dict[int, tuple[Any, int]] = {}

    def translation_unit(self) -> list[Node]:
        """Parse the whole file.

        Raises:
            GiveUp: too many errors, or too deep a nesting; both are reported.
        """
        found: list[Node] = []
        try:
            while self._peek() is not None:
                start = self._stream.index
                try:
                    found.extend(self._parse_external_declaration())
                except ParseError:
                    self._stream.close_scopes(1)
                    found.append(skip_broken(self._stream, start, is_in_block=False))
        except RecursionError:
            text = "the program is nested too deeply here"
            self._diagnostics.error(self._stream.location(), text)
            raise GiveUp from None
        return found

    def expression(self) -> Node | None:
        """Parse an expression and nothing after it; return None if there is an error."""
        with contextlib.suppress(ParseError):
            try:
                node = self._parse_expression()
            except RecursionError:
                text = "the expression is nested too deeply here"
                self._diagnostics.error(self._stream.location(), text)
                return None
            if (left := self._peek()) is None:
                return node
            report(self._diagnostics, left.location, f"unexpected '{left.value}' here")
        return None

    # Tokens

    @property
    def _typedef_checked_token(self) -> Token | None:
        """The token whose kind fits the scopes; pycparser resets it when it changes them."""
        return self._stream.classified

    @_typedef_checked_token.setter
    def _typedef_checked_token(self, token: Token | None) -> None:
        self._stream.classified = token

    def _advance(self) -> Any:
        token = self._peek()
        if token is None:
            self._parse_error("At end of input", None)
        self._stream.index += 1
        return token

    def _expect(self, token_type: str) -> Any:
        token = self._peek()
        if token is None:
            self._parse_error("At end of input", None)
        kind = token.type
        if token_type == kind or (kind == "TYPEID" and token_type in NAMES):
            self._stream.index += 1
            return token
        return self._errors.missing(token_type, token)

    def _tok_coord(self, tok: Token) -> Token:
        return tok

    def _parse_error(self, msg: str, coord: object) -> NoReturn:
        self._errors.unexpected(msg, coord)

    # Declarations

    def _parse_external_declaration(self) -> list[Node]:
        token = self._peek()
        if token is not None and token.type in _WITHOUT_TYPE:
            self._omissions.declare_unknown_type()
            if self._peek_type() in _WITHOUT_TYPE:
                self._omissions.insert_int(token)
        elif token is not None and not (token.type in _EXTERNAL or self._starts_declaration(token)):
            self._stream.index += 1
            text = f"expected a declaration before '{token.value}'"
            report(self._diagnostics, token.location, text)
            raise ParseError
        found: list[Node] = super()._parse_external_declaration()
        if found and isinstance(found[0], c_ast.FuncDef):
            # A message that its end is reached concerns its `}`.
            found[0].body.coord = self._stream.buffer[self._stream.index - 1]
        return found

    def _parse_declaration_specifiers(self, allow_no_type: bool = False) -> Any:
        self._omissions.declare_unknown_type()
        spec, saw_type, place = super()._parse_declaration_specifiers(allow_no_type)
        self._omissions.add_int(spec, place)
        return spec, saw_type, place

    def _parse_specifiers(self, *, allow_storage_and_function: bool) -> Any:
        start = self._stream.index
        spec, saw_type, first = super()._parse_specifiers(
            allow_storage_and_function=allow_storage_and_function
        )
        self._attributes.attach_to_specifiers(spec, self._attributes.take(start))
        return spec, saw_type, first

    def _parse_struct_or_union_specifier(self) -> Node:
        start = self._stream.index
        found = self._attributes.take(start + 1, start + 3)
        node = super()._parse_struct_or_union_specifier()
        self._attributes.attach_to_record(node, found)
        self._omissions.end_members()
        return node

    def _parse_enum_specifier(self) -> Node:
        node = super()._parse_enum_specifier()
        self._omissions.end_members()
        return node

    def _parse_struct_declaration(self) -> list[Node] | None:
        self._omissions.declare_unknown_type()
        found: list[Node] | None = super()._parse_struct_declaration()
        return found

    def _parse_struct_declarator(self) -> Any:
        found = super()._parse_struct_declarator()
        here = self._attributes.take(self._stream.index)
        self._attributes.attach_to_declarator(found["decl"], here)
        return found

    def _parse_id_declarator(self) -> Node:
        declarator = super()._parse_id_declarator()
        arguments = declarator.args if isinstance(declarator, c_ast.FuncDecl) else None
        has_names = arguments is not None and isinstance(arguments.params[0], c_ast.ID)
        if not has_names and self._starts_declaration():
            self._omissions.end_declaration()
        return declarator

    def _parse_declarator_kind(self, kind: str, allow_paren: bool) -> Node:
        start = self._stream.index
        node = super()._parse_declarator_kind(kind, allow_paren)
        self._attributes.attach_to_declarator(node, self._attributes.take(start + 1))
        return node

    def _parse_identifier_list_opt(self) -> Node:
        if self._omissions.declare_unknown_type() or self._starts_declaration():
            return self._parse_parameter_type_list()
        return super()._parse_identifier_list_opt()

    def _type_modify_decl(self, decl: Any, modifier: Any) -> Node:
        tail, depth = decl, 0
        while not isinstance(tail, c_ast.TypeDecl):
            tail, depth = tail.type, depth + 1
        if depth > _MAX_DERIVATIONS:
            self._parse_error("Declarator is nested too deeply", tail.coord)
        return super()._type_modify_decl(decl, modifier)

    def _build_declarations(
        self, spec: Any, decls: Any, typedef_namespace: bool = False
    ) -> list[Node]:
        built: list[Node] = super()._build_declarations(spec, decls, typedef_namespace)
        self._attributes.attach_to_declarations(spec, built)
        return built

    def _parse_attribute_specifier_sequence(self) -> list[Node]:
        return []  # `[[...]]` is C23

    def _attribute_operand(self) -> Node:
        """Parse the argument of an attribute, which is all there is in the stream."""
        node = self._parse_conditional_expression()
        if self._peek() is not None:
            self._parse_error("expected ')'", None)
        return node

    def _parse_initializer_item(self) -> Any:
        """Parse GNU's `name: value` too."""
        token = self._peek()
        if token is None or token.type not in NAMES or self._peek_type(2) != "COLON":
            return super()._parse_initializer_item()
        self._advance()
        self._advance()
        member = c_ast.ID(token.value, token)
        return c_ast.NamedInitializer([member], self._parse_initializer())

    def _parse_designation(self) -> Any:
        """Parse designators and the `=` after them, which GNU's `[3] 4` does without."""
        designators = self._parse_designator_list()
        if self._accept("EQUALS") is None:
            is_old = len(designators) == 1 and isinstance(designators[0], c_ast.ArrayDesignator)
            if not is_old:
                self._expect("EQUALS")
        return designators

    # Statements

    def _parse_block_item(self) -> Any:
        start, depth = self._stream.index, len(self._stream.scopes)
        try:
            self._typos.fix_statement()
            self._omissions.declare_unknown_type()
            if self._peek_type() == "__LABEL__":
                return self._local_labels()
            return super()._parse_block_item()
        except ParseError:
            if self._stream.buffer[self._stream.index] is None:
                raise
            self._stream.close_scopes(depth)
            return skip_broken(self._stream, start, is_in_block=True)

    def _local_labels(self) -> LocalLabels:
        token = self._advance()
        names = [self._expect("ID").value]
        while self._accept("COMMA"):
            names.append(self._expect("ID").value)
        self._expect("SEMI")
        return LocalLabels(names, token)

    def _parse_statement(self) -> Node:
        self._typos.fix_statement()
        return super()._parse_statement()

    def _parse_pragmacomp_or_statement(self) -> Node:
        node = super()._parse_pragmacomp_or_statement()
        self._typos.fix_statement()  # an `else`, for which the `if` looks next
        return node

    def _parse_compound_statement(self, **how: Any) -> Node:
        start = self._stream.index
        node = super()._parse_compound_statement(**how)
        node.coord = self._stream.span(start)
        return node

    def _parse_selection_statement(self) -> Node:
        node = super()._parse_selection_statement()
        self._warnings.selection(node)
        return node

    def _parse_iteration_statement(self) -> Node:
        start = self._stream.index
        node = super()._parse_iteration_statement()
        node.coord = self._stream.span(start)
        self._warnings.iteration(node)
        return node

    def _parse_jump_statement(self) -> Any:
        if self._peek_type() != "GOTO" or self._peek_type(2) != "TIMES":
            return super()._parse_jump_statement()
        token = self._advance()
        self._advance()
        target = self._parse_expression()
        self._expect("SEMI")
        return ComputedGoto(target, token)

    # Expressions

    def _parse_constant_expression(self) -> Any:
        """Parse `first ... last` too, for `case` and designators."""
        first = super()._parse_constant_expression()
        if self._accept("ELLIPSIS") is None:
            return first
        return Range(first, super()._parse_constant_expression(), first.coord)

    def _parse_assignment_expression(self) -> Node:
        start = self._stream.index
        target = self._parse_conditional_expression()
        if not self._is_assignment_op():
            return target
        token = self._advance()
        first = self._stream.index
        value = self._parse_assignment_expression()
        self._warnings.assignment(token, start, first, value)
        return c_ast.Assignment(token.value, target, value, self._stream.span(start))

    def _parse_conditional_expression(self) -> Node:
        """Parse `a ? b : c` and GNU's `a ?: c`."""
        start = self._stream.index
        condition = self._parse_binary_expression()
        if self._accept("CONDOP") is None:
            return condition
        then = None if self._peek_type() == "COLON" else self._parse_expression()
        self._expect("COLON")
        otherwise = self._parse_conditional_expression()
        return c_ast.TernaryOp(condition, then, otherwise, self._stream.span(start))

    def _parse_binary_expression(self, min_prec: int = 0, lhs: Node | None = None) -> Node:
        """Parse operators with a precedence of at least `min_prec`."""
        stream = self._stream
        start = stream.index
        left = self._parse_cast_expression() if lhs is None else lhs
        while True:
            token = stream.peek()
            precedence = -1 if token is None else _PRECEDENCE.get(token.type, -1)
            if precedence < min_prec:
                return left
            stream.index += 1
            second = stream.index
            right = self._parse_binary_expression(precedence + 1)
            self._warnings.operation(token, (left, start), (right, second))
            left = c_ast.BinaryOp(token.value, left, right, stream.span(start))

    def _parse_cast_expression(self) -> Node:
        stream = self._stream
        token = stream.peek()
        if token is None or token.type not in _LEAVES:
            return super()._parse_cast_expression()
        following = stream.buffer[stream.index + 1]
        if following is not None and following.type in _SUFFIXES:
            return self._parse_postfix_expression()
        stream.index += 1
        if token.type == "ID":
            return c_ast.ID(token.value, token)
        return c_ast.Constant("int", token.value, token)

    def _parse_unary_expression(self) -> Node:
        start, kind = self._stream.index, self._peek_type()
        if kind == "_ALIGNOF":
            return self._alignof()
        if kind == "LAND":
            token = self._advance()
            return LabelAddress(self._expect("ID").value, token)
        node = super()._parse_unary_expression()
        if kind in _PREFIXES:
            node.coord = self._stream.span(start)
        return node

    def _alignof(self) -> Node:
        """Parse `_Alignof (type)` and GNU's `__alignof__ expression`."""
        token = self._advance()
        found = self._try_parse_paren_type_name()
        if found is not None and self._peek_type() != "LBRACE":
            return c_ast.UnaryOp("_Alignof", found[0], token)
        if found is not None:
            self._reset(found[1])
        return c_ast.UnaryOp("_Alignof", self._parse_unary_expression(), token)

    def _parse_postfix_expression(self) -> Node:
        start = self._stream.index
        node = self._operand()
        while (suffix := self._peek_type()) in _SUFFIXES:
            node = self._suffix(node, suffix)
            node.coord = self._stream.span(start)
        return node

    def _operand(self) -> Node:
        """Parse a compound literal or a primary expression."""
        found = self._try_parse_paren_type_name()
        if found is None:
            return self._parse_primary_expression()
        ctype, mark, parenthesis, storage = found
        if self._peek_type() != "LBRACE":
            self._reset(mark)
            return self._parse_primary_expression()
        return c_ast.CompoundLiteral(ctype, self._parse_initializer(), storage, parenthesis)

    def _suffix(self, node: Node, suffix: str | None) -> Node:
        """Parse what follows an operand: an index, arguments, a member, `++` or `--`."""
        token = self._advance()
        if suffix == "LBRACKET":
            subscript = self._parse_expression()
            self._expect("RBRACKET")
            return c_ast.ArrayRef(node, subscript)
        if suffix == "LPAREN":
            arguments = None
            if self._peek_type() != "RPAREN":
                arguments = self._parse_argument_expression_list()
            self._expect("RPAREN")
            return c_ast.FuncCall(node, arguments)
        if suffix in {"PLUSPLUS", "MINUSMINUS"}:
            return c_ast.UnaryOp(f"p{token.value}", node)
        name = self._advance()
        if name.type not in NAMES:
            self._parse_error("Invalid struct reference", name)
        return c_ast.StructRef(node, token.value, c_ast.ID(name.value, name))

    def _parse_primary_expression(self) -> Any:
        """Parse builtins whose arguments are types, too."""
        token = self._peek()
        if token is None or token.type != "ID" or token.value not in TYPE_ARGUMENTS:
            return super()._parse_primary_expression()
        self._advance()
        self._expect("LPAREN")
        types = [self._parse_type_name()]
        while self._accept("COMMA"):
            types.append(self._parse_type_name())
        self._expect("RPAREN")
        return c_ast.FuncCall(c_ast.ID(token.value, token), c_ast.ExprList(types, token), token)

    def _try_parse_paren_type_name(self) -> Any:
        """Parse `(type)`, once at each position: nested ones would be tried 2^depth times."""
        token = self._peek()
        if token is None or token.type != "LPAREN":
            return None
        mark = self._stream.index
        known = self._type_names.get(mark)
        if known is not None:
            self._stream.index = known[1]
            return known[0]
        result = super()._try_parse_paren_type_name()
        if result is not None:
            self._type_names[mark] = (result, self._stream.index)
        return result
