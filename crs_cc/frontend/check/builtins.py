"""Built-in functions: calls that become instructions, for operations that C cannot express.

__crs_request(code, message)       posts a request and waits, see `crs_cc.requests`
__crs_stop("null pointer", at)     ends the program with an error, see `requests.ERROR_KINDS`; the
                                   address is optional
__crs_mark, _unset, callers, state for the allocator, see `ir.instruction.Mark` and the following
__crs_setjmp(buffer)               returns again after a jump, see `ir.instruction.SetJump`
__crs_sigsetjmp(buffer, unblocked) the same, with signals for `siglongjmp`
__crs_longjmp(activation, place, value)
__builtin_sqrt, floor, clz, ...    one WebAssembly instruction each
__builtin_memcpy, memmove, memset  whole blocks of memory
__builtin_va_start, va_copy, ...   arguments of variadic functions; a `va_list` is a `char *`
__builtin_expect, unreachable, trap, constant_p, choose_expr, types_compatible_p, ...

Arithmetic ones are in `builtins_number`, `__sync_` and `__atomic_` ones in `builtins_atomic`. Any
other name with the prefix `__builtin_` means the library function without the prefix.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

from pycparser import c_ast

from crs_cc.core.source import Location
from crs_cc.frontend.check import complex_numbers, constant, tree, vla
from crs_cc.frontend.check.builtins_atomic import ATOMIC_BUILTINS
from crs_cc.frontend.check.builtins_number import NUMBER_BUILTINS, folded
from crs_cc.frontend.check.checker import CheckError, Unit, expression
from crs_cc.frontend.check.conversion import (
    assigned,
    convert,
    promote_argument,
    usual_arithmetic_conversions,
)
from crs_cc.frontend.check.declarator import type_name
from crs_cc.frontend.check.expressions import rvalue
from crs_cc.frontend.check.operators import modifiable
from crs_cc.frontend.check.tree import Expression
from crs_cc.frontend.check.type_compat import compatible, is_promoted
from crs_cc.frontend.parse.nodes import Node
from crs_cc.ir.types import (
    CHAR,
    DOUBLE,
    FLOAT,
    INT,
    LDOUBLE,
    LONG,
    UINT,
    ULLONG,
    ULONG,
    VOID,
    CType,
    FloatType,
    PointerType,
    RecordType,
    VoidType,
    is_complete,
    qualify,
    unqualified,
)
from crs_cc.requests import ERROR_KINDS

_ADDRESS: Final = PointerType(VOID)
_CONST_ADDRESS: Final = PointerType(qualify(VOID, const=True, volatile=False))
VA_LIST: Final = PointerType(CHAR)


@dataclass(frozen=True, slots=True)
class Builtin:
    """The prototype and the checker of a builtin."""

    result: CType
    parameters: tuple[CType, ...]


def _table() -> dict[str, Builtin]:
    table = {
        "__crs_request": Builtin(INT, (INT, _ADDRESS)),
        "__crs_mark": Builtin(VOID, (_ADDRESS, UINT, INT)),
        "__crs_mark_unset": Builtin(VOID, (_ADDRESS, UINT, INT)),
        "__crs_callers": Builtin(VOID, (_ADDRESS, INT)),
        "__crs_state": Builtin(INT, (_CONST_ADDRESS,)),
        "__crs_setjmp": Builtin(INT, (_ADDRESS,)),
        "__crs_sigsetjmp": Builtin(INT, (_ADDRESS, ULONG)),
        "__builtin_alloca": Builtin(_ADDRESS, (UINT,)),
        "__crs_longjmp": Builtin(VOID, (UINT, UINT, INT)),
        "__builtin_memcpy": Builtin(_ADDRESS, (_ADDRESS, _CONST_ADDRESS, UINT)),
        "__builtin_memmove": Builtin(_ADDRESS, (_ADDRESS, _CONST_ADDRESS, UINT)),
        "__builtin_memset": Builtin(_ADDRESS, (_ADDRESS, INT, UINT)),
        "__builtin_unreachable": Builtin(VOID, ()),
        "__builtin_trap": Builtin(VOID, ()),
    }
    for suffix, ctype in (("", UINT), ("l", ULONG), ("ll", ULLONG)):
        for name in ("clz", "ctz", "popcount"):
            table[f"__builtin_{name}{suffix}"] = Builtin(INT, (ctype,))
    for suffix, real in (("", DOUBLE), ("f", FLOAT), ("l", LDOUBLE)):
        for name in ("sqrt", "fabs", "floor", "ceil", "trunc", "rint"):
            table[f"__builtin_{name}{suffix}"] = Builtin(real, (real,))
        table[f"__builtin_copysign{suffix}"] = Builtin(real, (real, real))
    return table


BUILTINS: Final = _table()
_TRUSTED: Final = frozenset({"__crs_mark", "__crs_mark_unset", "__crs_callers", "__crs_state"})

_CONSTANTS: Final = {
    f"__builtin_{name}{suffix}": (ctype, value)
    for name, value in (("inf", math.inf), ("huge_val", math.inf), ("nan", math.nan))
    for suffix, ctype in (("", DOUBLE), ("f", FLOAT), ("l", LDOUBLE))
}


def call_builtin(unit: Unit, name: str, node: Node) -> Expression | None:
    """Check a call of a builtin; return None for any other name."""
    location = unit.at(node)
    nodes = [] if node.args is None else node.args.exprs
    special = _SPECIAL.get(name) or NUMBER_BUILTINS.get(name) or ATOMIC_BUILTINS.get(name)
    if special is not None:
        return special(unit, nodes, location)
    if name in _CONSTANTS:
        ctype, value = _CONSTANTS[name]
        return tree.Literal(ctype, location, value)
    name = _SYNONYMS.get(name, name)
    builtin = BUILTINS.get(name)
    if builtin is None or (name in _TRUSTED and not unit.trusted):
        return None
    _count(nodes, len(builtin.parameters), location)
    arguments = [
        assigned(unit, rvalue(unit, each), ctype, "pass")
        for each, ctype in zip(nodes, builtin.parameters, strict=True)
    ]
    if name == "__builtin_alloca":
        return vla.alloca(unit, arguments[0], location)
    return folded(tree.Intrinsic(builtin.result, location, name, arguments))


def _count(nodes: list[Node], wanted: int, location: Location) -> None:
    if len(nodes) != wanted:
        what = "few" if len(nodes) < wanted else "many"
        text = f"too {what} arguments to function call, expected {wanted}, have {len(nodes)}"
        raise CheckError(location, text)


def _expect(unit: Unit, nodes: list[Node], location: Location) -> Expression:
    if len(nodes) not in {2, 3}:
        _count(nodes, 2, location)
    return assigned(unit, rvalue(unit, nodes[0]), LONG, "pass")


def _first(unit: Unit, nodes: list[Node], location: Location) -> Expression:
    """Return the first argument; the others are advice for the optimiser."""
    if not nodes:
        _count(nodes, 1, location)
    values = [rvalue(unit, each) for each in nodes]
    return values[0]


def _prefetch(unit: Unit, nodes: list[Node], location: Location) -> Expression:
    return convert(_first(unit, nodes, location), VOID)


def _constant_p(unit: Unit, nodes: list[Node], location: Location) -> Expression:
    _count(nodes, 1, location)
    value = rvalue(unit, nodes[0])
    is_text = isinstance(value, tree.AddressOf) and isinstance(value.operand, tree.StringLiteral)
    return tree.integer(int(is_text or isinstance(value, tree.Literal)), INT, location)


def _complex(unit: Unit, nodes: list[Node], location: Location) -> Expression:
    """Return a complex number of two parts, whose zeros keep their signs."""
    _count(nodes, 2, location)
    real, imaginary = usual_arithmetic_conversions(*(rvalue(unit, each) for each in nodes))
    if not isinstance(real.type, FloatType):
        text = f"'__builtin_complex' needs floating-point numbers, not '{real.type}'"
        raise CheckError(location, text)
    return complex_numbers.build(real.type, real, imaginary, location)


def _string_length(unit: Unit, nodes: list[Node], location: Location) -> Expression | None:
    """Return the length of a string literal; None for any other argument."""
    _count(nodes, 1, location)
    node = nodes[0]
    is_text = isinstance(node, c_ast.Constant) and node.type == "string"
    text = expression(unit, node) if is_text else None
    if not isinstance(text, tree.StringLiteral):
        return None
    return tree.integer(text.content.index(b"\0"), UINT, location)


def _choose(unit: Unit, nodes: list[Node], location: Location) -> Expression:
    _count(nodes, 3, location)
    chosen = constant.integer(unit, nodes[0], "first argument of '__builtin_choose_expr'")
    return expression(unit, nodes[1] if chosen else nodes[2])


def _types_compatible(unit: Unit, nodes: list[Node], location: Location) -> Expression:
    _count(nodes, 2, location)
    left, right = (unqualified(type_name(unit, each)) for each in nodes)
    return tree.integer(int(compatible(left, right)), INT, location)


def _classify(unit: Unit, nodes: list[Node], location: Location) -> Expression:
    """Return gcc's number for the kind of a type."""
    _count(nodes, 1, location)
    ctype = rvalue(unit, nodes[0]).type
    kinds = {VoidType: 0, PointerType: 5, FloatType: 8}
    number = kinds.get(type(ctype), 1)
    if isinstance(ctype, RecordType):
        number = 12 if ctype.record.kind == "struct" else 13
    return tree.integer(number, INT, location)


def _object_size(unit: Unit, nodes: list[Node], location: Location) -> Expression:
    """Return gcc's value for an object of unknown size, as without optimisation."""
    _count(nodes, 2, location)
    rvalue(unit, nodes[0])
    kind = constant.integer(unit, nodes[1], "second argument of '__builtin_object_size'")
    return tree.integer(0 if kind & 2 else UINT.largest, UINT, location)


def _stop(unit: Unit, nodes: list[Node], location: Location) -> Expression:
    _count(nodes[:1], 1, location)
    kind = expression(unit, nodes[0])
    text = kind.content[:-1].decode() if isinstance(kind, tree.StringLiteral) else ""
    if text not in ERROR_KINDS[1:]:
        raise CheckError(location, "'__crs_stop' needs the name of an error kind")
    addresses = [assigned(unit, rvalue(unit, each), _CONST_ADDRESS, "pass") for each in nodes[1:2]]
    return tree.Intrinsic(VOID, location, "__crs_stop", addresses, text)


def _list(unit: Unit, node: Node) -> Expression:
    """Check an argument that must be a `va_list` variable."""
    found = expression(unit, node)
    if unqualified(found.type) != VA_LIST:
        raise CheckError(found.location, f"expected a 'va_list', not '{found.type}'")
    return modifiable(found)


def _va_start(unit: Unit, nodes: list[Node], location: Location) -> Expression:
    _count(nodes, 2, location)
    if unit.function is None or not unit.function.is_variadic:
        raise CheckError(location, "'va_start' used in function with fixed args")
    return tree.Intrinsic(VOID, location, "__builtin_va_start", [_list(unit, nodes[0])])


def _va_copy(unit: Unit, nodes: list[Node], location: Location) -> Expression:
    _count(nodes, 2, location)
    target, source = _list(unit, nodes[0]), assigned(unit, rvalue(unit, nodes[1]), VA_LIST, "pass")
    return convert(tree.Assign(VA_LIST, location, target, source), VOID)


def _va_end(unit: Unit, nodes: list[Node], location: Location) -> Expression:
    _count(nodes, 1, location)
    return convert(_list(unit, nodes[0]), VOID)


def _va_arg(unit: Unit, nodes: list[Node], location: Location) -> Expression:
    arguments, ctype = _list(unit, nodes[0]), unqualified(type_name(unit, nodes[1]))
    if not is_complete(ctype):
        raise CheckError(location, f"'va_arg' of incomplete type '{ctype}'")
    if isinstance(ctype, RecordType) or is_promoted(ctype):
        return tree.VarArg(ctype, location, arguments)
    promoted = promote_argument(tree.VarArg(ctype, location, arguments)).type
    text = f"'{ctype}' is promoted to '{promoted}' when passed through '...'"
    unit.warning(location, text, f"so pass '{promoted}' not '{ctype}' to 'va_arg'", flag="varargs")
    return convert(tree.VarArg(promoted, location, arguments), ctype)


_SYNONYMS: Final = {"__builtin_setjmp": "__crs_setjmp"}

_SPECIAL: Final = {
    "__builtin_assume_aligned": _first,
    "__builtin_choose_expr": _choose,
    "__builtin_complex": _complex,
    "__builtin_classify_type": _classify,
    "__builtin_constant_p": _constant_p,
    "__builtin_expect": _expect,
    "__builtin_expect_with_probability": _expect,
    "__builtin_object_size": _object_size,
    "__builtin_prefetch": _prefetch,
    "__builtin_strlen": _string_length,
    "__builtin_types_compatible_p": _types_compatible,
    "__crs_stop": _stop,
    "__builtin_va_start": _va_start,
    "__builtin_va_copy": _va_copy,
    "__builtin_va_end": _va_end,
    "__builtin_va_arg": _va_arg,
}
