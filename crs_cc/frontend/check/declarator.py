"""Types from specifiers and declarators (C17 6.7.2 to 6.7.7).

pycparser nests declarators from the inside out: `char *names[3]` is an `ArrayDecl` of a
`PtrDecl` of a `TypeDecl` that holds the specifier.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import Any, Final

from pycparser import c_ast

from crs_cc.core.source import Location
from crs_cc.frontend.check import constant, tree, vla
from crs_cc.frontend.check.checker import CheckError, Unit, expression
from crs_cc.frontend.check.conversion import convert, decay
from crs_cc.frontend.check.scope import BrokenName, ObjectSymbol, TypedefName
from crs_cc.frontend.check.unsupported import refused
from crs_cc.frontend.other_language_hint import hint_for_type
from crs_cc.frontend.parse.nodes import Node
from crs_cc.frontend.preprocess.options import is_c23
from crs_cc.ir.types import (
    BASIC_TYPES,
    BOOL,
    COMPLEX,
    DOUBLE,
    UINT,
    VOID,
    ArrayType,
    CType,
    FloatType,
    FunctionType,
    IntegerType,
    PointerType,
    RecordType,
    VoidType,
    is_complete,
    qualify,
    unqualified,
)

LARGEST_OBJECT: Final = (1 << 31) - 1
"""The maximum size of an object [bytes]: differences of pointers into it must fit an `int`."""

_BINARY: Final = "use 'double', or integers of the smallest unit"
_TWO_WORDS: Final = "use 'long long', or a struct of two of them"
_LONGEST_FLOAT: Final = "use 'double', the longest floating type here"
_UNSUPPORTED: Final = {
    "__int128": _TWO_WORDS, "__int128_t": _TWO_WORDS, "__uint128_t": _TWO_WORDS,
    "__float128": _LONGEST_FLOAT, "_Float128": _LONGEST_FLOAT,
    "_Decimal32": _BINARY, "_Decimal64": _BINARY, "_Decimal128": _BINARY,
}  # fmt: skip
"""Types that are refused, with what to do instead."""

_NAMES: Final = {
    "": "int", "unsigned": "unsigned int", "signed char": "signed char",
    "long unsigned": "unsigned long", "long long unsigned": "unsigned long long",
    "short unsigned": "unsigned short", "char unsigned": "unsigned char",
    "double long": "long double",
}  # fmt: skip


@lru_cache(maxsize=256)
def basic_type(names: tuple[str, ...]) -> CType | None:
    """Return the type of a list of basic type specifiers in any order, None if it is invalid.

    >>> print(basic_type(("long", "unsigned", "int", "long")), basic_type(("short", "float")))
    unsigned long long None
    """
    if names == ("void",):
        return VOID
    words = sorted(names)
    if words.count("int") > 1 or ("int" in words and not _allows_int(words)):
        return None
    words = [word for word in words if word != "int"]
    if "signed" in words and "char" not in words:
        if words.count("signed") > 1 or not set(words) <= {"signed", "short", "long"}:
            return None
        words.remove("signed")
    key = "signed char" if words == ["char", "signed"] else " ".join(words)
    return BASIC_TYPES.get(_NAMES.get(key, key))


def _allows_int(words: list[str]) -> bool:
    return set(words) <= {"int", "signed", "unsigned", "short", "long"}


def type_name(unit: Unit, node: Node) -> CType:
    """Return the type of a `Typename` node; raise CheckError if it is not a valid type."""
    return declared_type(unit, node.type)


def declared_type(unit: Unit, node: Node) -> CType:
    """Return the type of a declarator with its specifier."""
    found = _DECLARATORS.get(node.__class__)
    if found is None:
        raise refused(unit, node)
    return found(unit, node)


def _base(unit: Unit, node: Node) -> CType:
    ctype = declared_type(unit, node.type)
    quals = node.quals
    if not quals:
        return ctype
    return qualify(ctype, "const" in quals, "volatile" in quals)


def _identifier(unit: Unit, node: Node) -> CType:
    names = tuple(node.names)
    if names == ("bool",) and is_c23(unit.standard):
        return BOOL
    found = basic_type(names)
    if found is not None:
        return found
    if "_Complex" in names:
        return _complex(names, unit.at(node))
    if len(names) == 1:
        symbol = unit.scope.find(names[0])
        if isinstance(symbol, ObjectSymbol):  # an earlier declarator of this declaration hides it
            symbol = unit.scope.find_type(names[0])
        if isinstance(symbol, TypedefName):
            return symbol.type
        if isinstance(symbol, BrokenName):
            raise CheckError(unit.at(node), "")
    return _unknown(unit, names, unit.at(node))


def _complex(names: tuple[str, ...], location: Location) -> CType:
    """Return the complex type of specifiers; `_Complex` alone means `_Complex double` (GNU C)."""
    rest = list(names)
    rest.remove("_Complex")
    base = basic_type(tuple(rest)) if rest else DOUBLE
    if not isinstance(base, IntegerType | FloatType) or base.name not in COMPLEX:
        raise CheckError(location, f"'{' '.join(names)}' is not a type")
    return COMPLEX[base.name]


def _unknown(unit: Unit, names: tuple[str, ...], location: Location) -> CType:
    for name in names:
        if name in _UNSUPPORTED:
            raise CheckError(location, f"type '{name}' is not supported", _UNSUPPORTED[name])
    if len(names) > 1:
        raise CheckError(location, f"'{' '.join(names)}' is not a type")
    if (names[0], "type") in unit.unknown:
        raise CheckError(location, "")
    unit.unknown.add((names[0], "type"))
    hint = hint_for_type(names[0]) or unit.suggest(names[0], TypedefName)
    raise CheckError(location, f"unknown type name '{names[0]}'", hint)


def _type_of(unit: Unit, node: Node) -> CType:
    """Return the type of a `typeof`, and remember it, since declarators share it."""
    known = unit.specified.get(node)
    if known is None:
        if isinstance(node.expr, c_ast.Typename):
            known = type_name(unit, node.expr)
        else:
            operand = expression(unit, node.expr)
            if isinstance(operand, tree.MemberAccess) and operand.member.bit_width is not None:
                raise CheckError(unit.at(node), "invalid application of 'typeof' to bit-field")
            known = operand.type
        if node.op == "typeof_unqual":
            known = unqualified(known)
        unit.specified[node] = known
    return known


def _pointer(unit: Unit, node: Node) -> CType:
    pointer = PointerType(declared_type(unit, node.type))
    quals = node.quals
    if not quals:
        return pointer
    return qualify(pointer, "const" in quals, "volatile" in quals)


def _array(unit: Unit, node: Node) -> CType:
    element = declared_type(unit, node.type)
    location = unit.at(node)
    if isinstance(element, FunctionType):
        raise CheckError(location, f"array of functions of type '{element}'")
    if not is_complete(element):
        raise CheckError(location, f"array has incomplete element type '{element}'")
    if node.dim is None:
        return ArrayType(element)
    if _is_star(node.dim):
        if unit.prototypes == 0:
            raise CheckError(location, "star modifier used outside of a function prototype")
        return ArrayType(element, None, ObjectSymbol("", UINT, location))
    given = decay(expression(unit, node.dim))
    length = constant.integer_value(given)
    if length is None or vla.is_variable(element):
        return vla.array(unit, element, given)
    if length < 0:
        raise CheckError(unit.at(node.dim), "array size is negative")
    if length * element.size > LARGEST_OBJECT:
        raise CheckError(location, "array is too large")
    return ArrayType(element, length)


def _is_star(node: Node) -> bool:
    """Return whether an array's length is `*`, a variable length in a prototype."""
    return isinstance(node, c_ast.ID) and node.name == "*"


def _function(unit: Unit, node: Node) -> CType:
    result = declared_type(unit, node.type)
    location = unit.at(node)
    if isinstance(result, ArrayType | FunctionType):
        what = "an array" if isinstance(result, ArrayType) else "a function"
        raise CheckError(location, f"function cannot return {what} of type '{result}'")
    if vla.is_variable(result):
        raise CheckError(location, f"function cannot return '{result}', whose size is variable")
    result = unqualified(result)
    if node.args is None:
        return FunctionType(result, () if is_c23(unit.standard) else None)
    if isinstance(node.args.params[0], c_ast.ID):
        return FunctionType(result)
    unit.prototypes += 1
    try:
        with unit.new_scope():
            return _prototype(unit, result, node.args.params)
    finally:
        unit.prototypes -= 1


def _prototype(unit: Unit, result: CType, nodes: list[Node]) -> CType:
    variadic = isinstance(nodes[-1], c_ast.EllipsisParam)
    if variadic:
        nodes = nodes[:-1]
    types = []
    for each in nodes:
        types.append(parameter_type(unit, each))
        if each.name is not None:
            symbol = ObjectSymbol(each.name, types[-1], unit.at(each))
            unit.scope.names[each.name] = symbol
    if len(types) == 1 and isinstance(types[0], VoidType) and nodes[0].name is None:
        types = []
    for each, ctype in zip(nodes, types, strict=False):
        if isinstance(ctype, VoidType):
            raise CheckError(unit.at(each), "parameter has type 'void'")
    return FunctionType(result, tuple(types), variadic)


def parameter_type(unit: Unit, node: Node) -> CType:
    """Return the type of a parameter; arrays and functions become pointers (C17 6.7.6.3p7)."""
    declarator = node.type
    if isinstance(declarator, c_ast.ArrayDecl):
        pointer = PointerType(declared_type(unit, declarator.type))
        if declarator.dim is not None and not _is_star(declarator.dim):
            length = expression(unit, declarator.dim)
            if unit.prototypes == 0 and unit.function is not None:
                unit.function.effects.append(convert(length, VOID))
        quals = declarator.dim_quals or []
        return qualify(pointer, "const" in quals, "volatile" in quals)
    ctype = declared_type(unit, declarator)
    if isinstance(ctype, ArrayType):
        return PointerType(ctype.element)
    if isinstance(ctype, FunctionType):
        return PointerType(ctype)
    if vla.is_variable(ctype):
        text = f"'{ctype}', whose size is variable, cannot be passed by value"
        raise CheckError(unit.at(node), text, "pass a pointer to it")
    return ctype


def require_complete(ctype: CType, location: Location, name: str) -> None:
    """Check that a variable's type is complete; raise CheckError if it is not."""
    if isinstance(ctype, VoidType) or not is_complete(ctype):
        raise CheckError(location, f"variable '{name}' has incomplete type '{ctype}'")
    if vla.is_variable(ctype):
        return
    if isinstance(ctype, RecordType | ArrayType) and ctype.size > LARGEST_OBJECT:
        raise CheckError(location, f"variable '{name}' is too large")


Declarator = Callable[[Unit, Any], CType]
_DECLARATORS: Final[dict[type, Declarator]] = {
    c_ast.TypeDecl: _base,
    c_ast.IdentifierType: _identifier,
    c_ast.PtrDecl: _pointer,
    c_ast.ArrayDecl: _array,
    c_ast.FuncDecl: _function,
    c_ast.Typename: _base,
    c_ast.TypeOf: _type_of,
}


def specifies(*classes: type) -> Callable[[Declarator], Declarator]:
    """Register the checker of a specifier (struct, union, enum)."""

    def enter(function: Declarator) -> Declarator:
        _DECLARATORS.update(dict.fromkeys(classes, function))
        return function

    return enter
