"""GNU C's `__sync_` and `__atomic_` builtins, as plain operations: a program has one thread.

Each becomes an expression of loads, stores and ordinary operators; memory orders have no effect.
Arithmetic on pointers counts bytes, as in gcc.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final, TypeAlias

from crs_cc.core.source import Location
from crs_cc.frontend.check import tree
from crs_cc.frontend.check.builtins_number import kept, then
from crs_cc.frontend.check.checker import CheckError, Unit
from crs_cc.frontend.check.conversion import assigned, convert, is_scalar
from crs_cc.frontend.check.expressions import rvalue
from crs_cc.frontend.check.operators import operate
from crs_cc.frontend.check.tree import Expression
from crs_cc.frontend.parse.nodes import Node
from crs_cc.ir.types import BOOL, INT, UINT, VOID, CType, PointerType, RecordType, unqualified

AtomicBuiltin: TypeAlias = Callable[[Unit, list[Node], Location], Expression]

ATOMIC_BUILTINS: Final[dict[str, AtomicBuiltin]] = {}
"""The checker of each builtin in this file."""

_OPERATORS: Final = {
    "add": "+", "sub": "-", "or": "|", "and": "&", "xor": "^", "nand": "&",
}  # fmt: skip


class _Object:
    """The object that a builtin's argument points to; the pointer is evaluated once."""

    def __init__(self, pointer: Expression) -> None:
        target = pointer.type.target if isinstance(pointer.type, PointerType) else VOID
        if not is_scalar(target) and not isinstance(target, RecordType):
            text = f"address argument to atomic builtin must be a pointer ('{pointer.type}' given)"
            raise CheckError(pointer.location, text)
        self.type: CType = unqualified(target)
        self.location = pointer.location
        self.keep, self._pointer = kept(pointer)

    def place(self) -> Expression:
        """Return the object."""
        return tree.Dereference(self.type, self.location, self._pointer)

    def store(self, value: Expression) -> Expression:
        """Return the assignment of a value of its type."""
        return tree.Assign(self.type, self.location, self.place(), value)

    def combined(self, unit: Unit, op: str, old: Expression, value: Expression) -> Expression:
        """Return `old op value` in its type."""
        is_pointer = isinstance(self.type, PointerType)
        if is_pointer:
            old, value = convert(old, UINT), convert(value, UINT)
        made = operate(unit, _OPERATORS[op], old, value, self.location)
        if op == "nand":
            made = tree.Unary(made.type, self.location, "~", made)
        return convert(made, self.type)


def _arguments(unit: Unit, nodes: list[Node], least: int, location: Location) -> list[Expression]:
    if len(nodes) < least:
        text = f"too few arguments to atomic builtin, expected {least}, have {len(nodes)}"
        raise CheckError(location, text)
    return [rvalue(unit, each) for each in nodes]


def _nothing(location: Location) -> Expression:
    return convert(tree.integer(0, INT, location), VOID)


def _fetch(op: str, *, gives_new: bool) -> AtomicBuiltin:
    """Return the checker of `fetch_and_op`, or of `op_and_fetch`."""

    def check(unit: Unit, nodes: list[Node], location: Location) -> Expression:
        pointer, value, *_ = _arguments(unit, nodes, 2, location)
        target = _Object(pointer)
        keep_value, value = kept(_converted(unit, value, target.type))
        keep_old, old = kept(target.place())
        keep_new, new = kept(target.combined(unit, op, old, value))
        result = new if gives_new else old
        return then(target.keep, keep_value, keep_old, keep_new, target.store(new), result)

    return check


def _converted(unit: Unit, value: Expression, ctype: CType) -> Expression:
    """Convert a value to an object's type; what is added to a pointer is a number."""
    if isinstance(ctype, PointerType) and not isinstance(value.type, PointerType):
        return convert(value, ctype)
    return assigned(unit, value, ctype, "pass")


def _load(unit: Unit, nodes: list[Node], location: Location) -> Expression:
    pointer, *_ = _arguments(unit, nodes, 1, location)
    target = _Object(pointer)
    keep, value = kept(target.place())
    return then(target.keep, keep, value)


def _store(unit: Unit, nodes: list[Node], location: Location) -> Expression:
    pointer, value, *_ = _arguments(unit, nodes, 2, location)
    target = _Object(pointer)
    store = target.store(_converted(unit, value, target.type))
    return convert(then(target.keep, store), VOID)


def _exchange(unit: Unit, nodes: list[Node], location: Location) -> Expression:
    pointer, value, *_ = _arguments(unit, nodes, 2, location)
    target = _Object(pointer)
    keep_value, value = kept(_converted(unit, value, target.type))
    keep_old, old = kept(target.place())
    return then(target.keep, keep_value, keep_old, target.store(value), old)


def _copying(count: int) -> AtomicBuiltin:
    """Return the checker of `__atomic_load`, `store` (2) or `exchange` (3) through pointers."""

    def check(unit: Unit, nodes: list[Node], location: Location) -> Expression:
        pointers = [_Object(each) for each in _arguments(unit, nodes, count, location)[:count]]
        target, value = pointers[0], kept(pointers[1].place())
        parts = [*(each.keep for each in pointers), value[0]]
        if count == 3:
            parts.append(pointers[2].store(target.place()))
        return convert(then(*parts, target.store(value[1])), VOID)

    return check


def _load_into(unit: Unit, nodes: list[Node], location: Location) -> Expression:
    """Check `__atomic_load(from, to, order)`."""
    source, target = (_Object(each) for each in _arguments(unit, nodes, 2, location)[:2])
    return convert(then(source.keep, target.keep, target.store(source.place())), VOID)


def _compare_and_swap(*, gives_old: bool) -> AtomicBuiltin:
    """Return the checker of `__sync_val_compare_and_swap`, or of the one with a truth value."""

    def check(unit: Unit, nodes: list[Node], location: Location) -> Expression:
        pointer, wanted, value, *_ = _arguments(unit, nodes, 3, location)
        target = _Object(pointer)
        keep_wanted, wanted = kept(_converted(unit, wanted, target.type))
        keep_value, value = kept(_converted(unit, value, target.type))
        keep_old, old = kept(target.place())
        keep_same, same = kept(operate(unit, "==", old, wanted, location))
        chosen = tree.Conditional(target.type, location, same, value, old)
        result = old if gives_old else convert(same, BOOL)
        keeps = (target.keep, keep_wanted, keep_value, keep_old, keep_same)
        return then(*keeps, target.store(chosen), result)

    return check


def _compare_exchange(*, is_indirect: bool) -> AtomicBuiltin:
    """Return the checker of `__atomic_compare_exchange`, or `_n` unless `is_indirect`."""

    def check(unit: Unit, nodes: list[Node], location: Location) -> Expression:
        pointer, wanted, value, *_ = _arguments(unit, nodes, 3, location)
        target, expected = _Object(pointer), _Object(wanted)
        if not is_scalar(target.type):
            raise CheckError(location, f"compare-exchange of a '{target.type}' is not supported")
        given = _Object(value) if is_indirect else None
        new = given.place() if given is not None else _converted(unit, value, target.type)
        keep_new, new = kept(new)
        keep_old, old = kept(target.place())
        keep_same, same = kept(operate(unit, "==", old, expected.place(), location))
        keeps = [target.keep, expected.keep, *([given.keep] if given is not None else [])]
        swap = target.store(tree.Conditional(target.type, location, same, new, old))
        note = expected.store(convert(old, expected.type))
        return then(*keeps, keep_new, keep_old, keep_same, swap, note, convert(same, BOOL))

    return check


def _test_and_set(unit: Unit, nodes: list[Node], location: Location) -> Expression:
    pointer, *_ = _arguments(unit, nodes, 1, location)
    target = _Object(convert(pointer, PointerType(BOOL)))
    keep_old, old = kept(target.place())
    return then(target.keep, keep_old, target.store(tree.integer(1, BOOL, location)), old)


def _clear(unit: Unit, nodes: list[Node], location: Location) -> Expression:
    """Check `__sync_lock_release` and `__atomic_clear`."""
    pointer, *_ = _arguments(unit, nodes, 1, location)
    target = _Object(pointer)
    zero = convert(tree.integer(0, INT, location), target.type)
    return convert(then(target.keep, target.store(zero)), VOID)


def _fence(unit: Unit, nodes: list[Node], location: Location) -> Expression:
    _arguments(unit, nodes, 0, location)
    return _nothing(location)


def _is_lock_free(unit: Unit, nodes: list[Node], location: Location) -> Expression:
    _arguments(unit, nodes, 1, location)
    return tree.integer(1, BOOL, location)


def _enter() -> None:
    table = ATOMIC_BUILTINS
    for op in _OPERATORS:
        old, new = _fetch(op, gives_new=False), _fetch(op, gives_new=True)
        table |= {f"__sync_fetch_and_{op}": old, f"__sync_{op}_and_fetch": new}
        table |= {f"__atomic_fetch_{op}": old, f"__atomic_{op}_fetch": new}
    table["__sync_bool_compare_and_swap"] = _compare_and_swap(gives_old=False)
    table["__sync_val_compare_and_swap"] = _compare_and_swap(gives_old=True)
    table["__atomic_compare_exchange_n"] = _compare_exchange(is_indirect=False)
    table["__atomic_compare_exchange"] = _compare_exchange(is_indirect=True)
    table |= {"__sync_lock_test_and_set": _exchange, "__atomic_exchange_n": _exchange}
    table |= {"__atomic_load_n": _load, "__atomic_store_n": _store}
    table |= {"__atomic_load": _load_into, "__atomic_store": _copying(2)}
    table |= {"__atomic_exchange": _copying(3), "__atomic_test_and_set": _test_and_set}
    table |= {"__sync_lock_release": _clear, "__atomic_clear": _clear}
    table |= {"__sync_synchronize": _fence, "__atomic_thread_fence": _fence}
    table |= {"__atomic_signal_fence": _fence, "__atomic_is_lock_free": _is_lock_free}
    table["__atomic_always_lock_free"] = _is_lock_free


_enter()
