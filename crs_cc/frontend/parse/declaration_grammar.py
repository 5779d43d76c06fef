"""The grammar's declarations: attributes, nested functions, and what old code leaves out."""

from __future__ import annotations

from typing import Any, Final

from pycparser import c_ast
from pycparser.c_parser import ParseError

from crs_cc.frontend.error_limit import report
from crs_cc.frontend.parse.expression_grammar import ExpressionGrammar
from crs_cc.frontend.parse.nodes import Node
from crs_cc.frontend.parse.token_stream import NAMES
from crs_cc.frontend.preprocess.options import is_c23

_WITHOUT_TYPE: Final = frozenset({"ID", "TIMES", "LPAREN"})
"""The tokens that start a declaration whose type is left out."""

_EXTERNAL: Final = frozenset({"SEMI", "PPHASH", "PPPRAGMA", "_PRAGMA", "_STATIC_ASSERT"})
"""Other tokens that may start an external declaration."""

_MAX_DERIVATIONS: Final = 200
"""How many pointers, arrays and functions one declarator may stack up."""


def _name(declarator: Node) -> str:
    """Return the name in a declarator."""
    while not isinstance(declarator, c_ast.TypeDecl):
        declarator = declarator.type
    return str(declarator.declname)


class DeclarationGrammar(ExpressionGrammar):
    """A parser for the declarations and expressions of one file."""

    _is_typedef = False
    """Whether the declaration whose declarators are parsed is a `typedef`."""

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
        return found

    def _parse_declaration_specifiers(self, allow_no_type: bool = False) -> Any:
        self._omissions.declare_unknown_type()
        spec, saw_type, place = super()._parse_declaration_specifiers(allow_no_type)
        if not self._is_inferred_auto(spec):
            self._omissions.add_int(spec, place)
        self._is_typedef = "typedef" in spec["storage"]
        return spec, saw_type, place

    def _is_inferred_auto(self, spec: Any) -> bool:
        return is_c23(self._standard) and bool(super()._is_inferred_auto(spec))

    def _parse_init_declarator(self, id_only: bool = False) -> Any:
        """Parse a declarator with its initialiser, in which a name hides a type (C17 6.2.1p7)."""
        is_typedef = self._is_typedef
        declarator = self._parse_id_declarator() if id_only else self._parse_declarator()
        found = {"decl": declarator}
        name = _name(declarator)
        if not is_typedef and self._is_type_in_scope(name):
            self._add_identifier(name, declarator.coord)
        if self._accept("EQUALS"):
            found["init"] = self._parse_initializer()
        self._is_typedef = is_typedef
        return found

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
        start = self._stream.index
        found = self._attributes.take(start + 1, start + 3)
        node = super()._parse_enum_specifier()
        node.attributes = found + self._attributes.take(self._stream.index)
        self._omissions.end_members()
        return node

    def _parse_declaration_end(self, decls: list[Node]) -> list[Node]:
        """Parse the semicolon, or the body of a GNU nested function."""
        kinds = {self._peek_type()} if len(decls) == 1 and len(self._stream.scopes) > 1 else set()
        if kinds <= {"LBRACE"} and kinds and isinstance(decls[0].type, c_ast.FuncDecl):
            return [self._nested_function(decls[0])]
        found: list[Node] = super()._parse_declaration_end(decls)
        return found

    def _nested_function(self, declaration: Node) -> Node:
        """Parse the body of a function inside a function."""
        self._errors.enter_nested()
        self._push_scope()
        arguments = declaration.type.args
        for each in [] if arguments is None else arguments.params:
            if getattr(each, "name", None):
                self._add_identifier(each.name, each.coord)
        body = self._parse_compound_statement(new_scope=False)
        self._pop_scope()
        return c_ast.FuncDef(declaration, None, body, declaration.coord)

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
