"""Warnings about operands whose order C leaves open, where it matters (C17 6.5p2).

A variable is changed twice, or changed and read, without a sequence point between: `i = i++ + 1`.
crs computes such expressions as unoptimised gcc does; other compilers may not.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

from crs_cc.core.source import Location
from crs_cc.frontend.check import tree
from crs_cc.frontend.check.checker import Unit
from crs_cc.frontend.check.scope import ObjectSymbol
from crs_cc.frontend.check.tree import Expression

_Symbols = dict[ObjectSymbol, Location]
"""Variables, each with the place where it is used, in order."""


@dataclass(slots=True)
class _Effects:
    """What the evaluation of an expression does to variables.

    Attributes:
        reads: the variables that are read.
        changes: the variables that are changed.
        late: those that may be changed after the value of the expression is computed.
    """

    reads: _Symbols = field(default_factory=dict)
    changes: _Symbols = field(default_factory=dict)
    late: _Symbols = field(default_factory=dict)


def warn_order(unit: Unit, expression: Expression) -> None:
    """Check a full expression."""
    _Order(unit).of(expression)


class _Order:
    """Checks one full expression; each variable is mentioned once."""

    def __init__(self, unit: Unit) -> None:
        self._unit = unit
        self._mentioned: set[ObjectSymbol] = set()

    def of(self, it: Expression) -> _Effects:
        """Return the effects of an expression, and warn about conflicts in it."""
        match it:
            case tree.ObjectName(symbol=symbol):
                return _Effects(reads={symbol: it.location})
            case tree.AddressOf(operand=operand) | tree.MemberAccess(record=operand):
                found = self.of(operand)
                if isinstance(it, tree.AddressOf) and isinstance(operand, tree.ObjectName):
                    return _Effects()
                return found
            case (
                tree.Assign(target=target, value=value)
                | tree.CompoundAssign(target=target, value=value)
            ):
                reads = isinstance(it, tree.CompoundAssign)
                return self._assign(it, target, [target, value], reads_target=reads)
            case tree.Increment(target=target):
                return self._assign(it, target, [target], reads_target=True)
            case tree.Comma(first=first, second=second):
                return self._in_turn([first, second])
            case tree.Logical(left=left, right=right):
                return self._in_turn([left, right])
            case tree.Conditional(condition=condition, then=then, otherwise=otherwise):
                return _joined([self._in_turn([condition, each]) for each in (then, otherwise)])
            case tree.Call(callee=callee, arguments=arguments):
                found = self._unordered([callee, *arguments])
                found.late = {}
                return found
        return self._unordered(_operands(it))

    def _assign(
        self, it: Expression, target: Expression, parts: list[Expression], *, reads_target: bool
    ) -> _Effects:
        """Return the effects of an assignment, whose target is changed last."""
        if not isinstance(target, tree.ObjectName):
            return self._unordered(parts)
        found = self._unordered([each for each in parts if each is not target])
        symbol = target.symbol
        if symbol in found.late:
            self._warn(symbol, it.location, "multiple unsequenced modifications to")
        found.changes[symbol] = found.late[symbol] = target.location
        if reads_target:
            found.reads[symbol] = target.location
        return found

    def _in_turn(self, parts: list[Expression]) -> _Effects:
        """Return the effects of operands with a sequence point between them."""
        effects = [self.of(each) for each in parts]
        for each in effects[:-1]:
            each.late = {}
        return _joined(effects)

    def _unordered(self, parts: Iterable[Expression]) -> _Effects:
        """Return the effects of operands in any order, and warn where it matters."""
        effects = [self.of(each) for each in parts]
        for position, one in enumerate(effects):
            for other in effects[position + 1 :]:
                for changing, using in ((one, other), (other, one)):
                    self._compare(changing, using)
        return _joined(effects)

    def _compare(self, changing: _Effects, using: _Effects) -> None:
        for symbol, place in changing.changes.items():
            if symbol in using.changes:
                self._warn(symbol, place, "multiple unsequenced modifications to")
            elif symbol in using.reads:
                self._warn(symbol, place, "unsequenced modification and access to")

    def _warn(self, symbol: ObjectSymbol, location: Location, what: str) -> None:
        if symbol not in self._mentioned:
            self._mentioned.add(symbol)
            self._unit.warning(location, f"{what} '{symbol.name}'", flag="sequence-point")


def _joined(effects: list[_Effects]) -> _Effects:
    found = _Effects()
    for each in effects:
        found.reads.update(each.reads)
        found.changes.update(each.changes)
        found.late.update(each.late)
    return found


def _operands(it: Expression) -> list[Expression]:
    """Return the operands of an expression that are evaluated in any order."""
    match it:
        case tree.Binary(left=left, right=right) | tree.PointerDifference(left=left, right=right):
            return [left, right]
        case tree.PointerAdd(pointer=pointer, index=index):
            return [pointer, index]
        case tree.Unary(operand=operand) | tree.Convert(operand=operand):
            return [operand]
        case tree.Dereference(pointer=pointer):
            return [pointer]
        case tree.Intrinsic(arguments=arguments):
            return arguments
    return []
