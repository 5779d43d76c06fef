"""The grammar: pycparser's, extended to GNU C and to C90, with recovery from errors.

`Grammar` and its bases override methods of pycparser 3.12's parser for four reasons:

- It reads the tokens from a `TokenStream`, and a node's `coord` is a `Token`, or a `Span` where
  a message may concern a whole operation: pycparser notes the first token of the first operand,
  which is the same for `a / b` and `a / b / c`.
- GNU C: labels as values, ranges, old designators, attributes, nested functions.
- Errors do not end the parse: what was expected is reported and the statement or declaration is
  skipped. The objects that a `Grammar` holds do this; they are called where something may be
  wrong, and leave tokens that the grammar can go on with.
- Speed, where an operand is just a name or a number.
"""

from __future__ import annotations

import contextlib
from collections.abc import Sequence
from typing import Any

from pycparser import c_ast
from pycparser.c_parser import ParseError

from crs_cc.frontend.error_limit import CompilationAborted, report
from crs_cc.frontend.parse.declaration_grammar import DeclarationGrammar
from crs_cc.frontend.parse.header_memory import HeaderTokens, Parse
from crs_cc.frontend.parse.nodes import ComputedGoto, LocalLabels, Node
from crs_cc.frontend.parse.recovery import skip_broken


class Grammar(DeclarationGrammar):
    """A parser for one file."""

    def translation_unit(self) -> list[Node]:
        """Parse the whole file.

        Raises:
            CompilationAborted: too many errors, or too deep a nesting; both are reported.
        """
        found: list[Node] = []
        try:
            while (token := self._peek()) is not None:
                header = self._headers.get(token)
                found.extend(self._declarations() if header is None else self._header(header))
        except RecursionError:
            text = "the program is nested too deeply here"
            self._diagnostics.error(self._stream.location(), text)
            raise CompilationAborted from None
        return found

    def _declarations(self) -> list[Node]:
        """Parse an external declaration, or skip it if it has a syntax error."""
        start = self._stream.index
        try:
            return self._parse_external_declaration()
        except ParseError:
            self._stream.close_scopes(1)
            return [skip_broken(self._stream, start, is_in_block=False)]

    def _header(self, header: HeaderTokens) -> Sequence[Node]:
        """Parse the declarations of a header, or remember them from an earlier file."""
        known = header.recall(self._stream)
        if known is not None:
            return known
        found: list[Node] = []
        parse = Parse(header, self._stream)
        while self._peek() is not None and not parse.is_over():
            found.extend(self._declarations())
        if not self._diagnostics.messages:
            parse.remember(found)
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

    # Statements

    def _parse_block_item(self) -> Any:
        start, depth = self._stream.index, len(self._stream.scopes)
        try:
            self._typos.fix_statement()
            self._omissions.declare_unknown_type()
            if self._peek_type() == "__LABEL__":
                return self._local_labels()
            if self._peek_type() == "TYPEID" and self._peek_type(2) == "COLON":
                return self._typedef_label()
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
        if self._peek_type() == "TYPEID" and self._peek_type(2) == "COLON":
            return self._typedef_label()
        return super()._parse_statement()

    def _typedef_label(self) -> Node:
        """Parse a label that has the name of a type, and its statement (C17 6.2.3)."""
        token = self._advance()
        self._expect("COLON")
        if self._starts_statement():
            following = self._parse_pragmacomp_or_statement()
        else:
            following = c_ast.EmptyStatement(token)
        return c_ast.Label(token.value, following, token)

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
