"""Control-flow warnings: reads of uninitialised variables, and missing returns.

There is a warning only if it holds on every path: a variable counts as unassigned where no path
from its declaration assigns it. An earlier iteration of a loop may have assigned it, so inside a
loop that assigns it somewhere there are no warnings after a condition. Nothing is known after a
label.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Final

from crs_cc.frontend.check import tree
from crs_cc.frontend.check.checker import Unit
from crs_cc.frontend.check.scope import ENTRIES, ObjectSymbol
from crs_cc.frontend.check.tree_parts import parts
from crs_cc.ir.types import VoidType

_NEVER_RETURN: Final = frozenset({"exit", "_exit", "_Exit", "quick_exit", "abort", "longjmp"})

Unassigned = set[ObjectSymbol]


def warn_paths(unit: Unit, function: tree.FunctionDefinition) -> None:
    """Warn about reads of uninitialised variables and a missing `return`."""
    paths = _Paths(unit, _assigned_in_loops(function.body))
    ends = paths.block(function.body)
    symbol = function.symbol
    is_entry = symbol.name in ENTRIES and symbol.is_external
    returns = not isinstance(symbol.type.result, VoidType) and not function.returns_implicit_int
    if ends and returns and not is_entry and not symbol.is_noreturn:
        text = f"control can reach the end of non-void function '{symbol.name}'"
        unit.warning(function.end, text, flag="return-type")


@dataclass(slots=True)
class _Breakable:
    """An open loop or switch.

    Attributes:
        is_loop: whether it is a loop.
        assigned: the variables that a loop assigns somewhere.
        is_left: whether it contains a `break`.
        is_continued: whether it contains a `continue`.
    """

    is_loop: bool
    assigned: Unassigned
    is_left: bool = False
    is_continued: bool = False


@dataclass(slots=True)
class _Paths:
    """The walk through one function.

    Attributes:
        assigned: the variables that each loop and switch assigns somewhere.
        unassigned: the variables that no path to this point assigns.
        open: the loops and switches around it.
        log: every variable that was assigned on the walk.
    """

    unit: Unit
    assigned: dict[Any, Unassigned]
    unassigned: Unassigned = field(default_factory=set)
    open: list[_Breakable] = field(default_factory=list)
    log: list[ObjectSymbol] = field(default_factory=list)

    def block(self, statements: list[tree.Statement]) -> bool:
        """Walk through statements; return whether their end can be reached."""
        reached = True
        for each in statements:
            reached = self.statement(each, reached)
        return reached

    def statement(self, node: tree.Statement, reached: bool) -> bool:
        """Walk through a statement; return whether its end can be reached."""
        match node:
            case tree.ExpressionStatement():
                self.value(node.expression)
                return reached and not _ends(node.expression)
            case tree.Declare():
                self._declare(node)
            case tree.If():
                return self._if(node, reached)
            case tree.Loop():
                return self._loop(node, reached)
            case tree.Switch():
                return self._switch(node)
            case tree.Label():
                self.unassigned.clear()
                for each in self.open:
                    each.is_continued = True
                return True
            case tree.CaseLabel():
                return True
            case tree.Return() | tree.Goto() | tree.ComputedGoto() | tree.Break() | tree.Continue():
                return self._jump(node)
        return reached

    def _declare(self, node: tree.Declare) -> None:
        symbol = node.symbol
        if node.initialiser is not None:
            self.unassigned.discard(symbol)  # `int x = x;` silences the warning
            for each in parts(node):
                self.value(each)
        elif not symbol.in_memory and symbol.link_name is None and symbol.name:
            self.unassigned.add(symbol)

    def _if(self, node: tree.If, reached: bool) -> bool:
        self.value(node.condition)
        constant = _constant(node.condition)
        mark, before = len(self.log), set(self.unassigned)
        removed = self._forget_assigned_in_loops()
        uncertain = set(self.unassigned)
        then_ends = self.block(node.then)
        after_then, self.unassigned = self.unassigned, uncertain
        otherwise_ends = self.block(node.otherwise)
        if then_ends and otherwise_ends:
            self.unassigned &= after_then
            self.unassigned |= removed.difference(self.log[mark:])
        elif then_ends:
            self.unassigned = after_then  # the condition may depend on the iteration
        self.unassigned &= before
        if constant is not None:
            return reached and (then_ends if constant else otherwise_ends)
        return reached and (then_ends or otherwise_ends)

    def _forget_assigned_in_loops(self) -> Unassigned:
        """Remove, and return, the variables that an earlier iteration may have assigned."""
        removed: Unassigned = set()
        for each in self.open:
            removed |= self.unassigned & each.assigned
        self.unassigned -= removed
        return removed

    def _loop(self, node: tree.Loop, reached: bool) -> bool:
        self.block(node.start)
        loop = _Breakable(True, self.assigned[node])
        constant = True if node.condition is None else _constant(node.condition)
        if node.tests_first and node.condition is not None:
            self.value(node.condition)
        self.open.append(loop)
        before = set(self.unassigned)
        ends = self.block(node.body)
        if node.step is not None:
            self.value(node.step)
        if not node.tests_first and node.condition is not None:
            self.value(node.condition)
        self.open.pop()
        self.unassigned &= before
        if loop.is_left:
            self.unassigned -= loop.assigned
        is_endless = bool(constant) and not loop.is_left
        runs_once = not node.tests_first and not loop.is_left and not loop.is_continued
        if runs_once and not ends:
            return False
        return reached and not is_endless

    def _switch(self, node: tree.Switch) -> bool:
        self.value(node.value)
        before = set(self.unassigned)
        switch = _Breakable(False, set())
        self.open.append(switch)
        reached = False
        for each in node.body:
            if isinstance(each, tree.CaseLabel):
                self.unassigned = before & self.unassigned if reached else set(before)
                self._forget_assigned_in_loops()
            reached = self.statement(each, reached)
        self.open.pop()
        self.unassigned &= before
        self.unassigned -= self.assigned[node]
        has_default = any(each.first is None for each in node.labels)
        return reached or switch.is_left or not has_default or _is_tangled(node)

    def _jump(self, node: Any) -> bool:
        for each in parts(node):
            self.value(each)
        if isinstance(node, tree.Break) and self.open:
            self.open[-1].is_left = True
        if isinstance(node, tree.Continue):
            next(each for each in reversed(self.open) if each.is_loop).is_continued = True
        return False

    # Expressions

    def value(self, node: Any) -> None:
        """Walk through an expression in its order of evaluation."""
        match node:
            case tree.ObjectName():
                self._read(node)
            case tree.Assign(target=tree.ObjectName(symbol=symbol)):
                self.value(node.value)
                self.unassigned.discard(symbol)
                self.log.append(symbol)
            case tree.Intrinsic(name="__builtin_va_start", arguments=[tree.ObjectName() as first]):
                self.unassigned.discard(first.symbol)
            case tree.Logical():
                self.value(node.left)
                self._maybe(node.right)
            case tree.Conditional():
                self.value(node.condition)
                self._maybe(node.then)
                self._maybe(node.otherwise)
            case tree.StatementExpression():
                self.block(node.body)
                if node.value is not None:
                    self.value(node.value)
            case _:
                for each in parts(node):
                    self.value(each)
                if (target := _target(node)) is not None:
                    self.log.append(target)

    def _maybe(self, node: Any) -> None:
        """Walk through an expression that is not always evaluated."""
        mark, removed = len(self.log), self._forget_assigned_in_loops()
        self.value(node)
        if removed:
            self.unassigned |= removed.difference(self.log[mark:])

    def _read(self, node: tree.ObjectName) -> None:
        if node.symbol in self.unassigned:
            self.unassigned.discard(node.symbol)  # warn once
            text = f"variable '{node.symbol.name}' is uninitialized when used here"
            hint = f"declared at {node.symbol.location}"
            self.unit.warning(node.location, text, hint, flag="uninitialized")


def _assigned_in_loops(body: list[tree.Statement]) -> dict[Any, Unassigned]:
    """Return for each loop and switch the variables that are assigned somewhere in it."""
    found: dict[Any, Unassigned] = {}
    open_: list[Unassigned] = [set()]
    stack: list[Any] = list(reversed(body))
    while stack:
        node = stack.pop()
        if node is _CLOSE:
            inner = open_.pop()
            open_[-1] |= inner
            continue
        symbol = _target(node)
        if symbol is not None:
            open_[-1].add(symbol)
        if isinstance(node, tree.Loop | tree.Switch):
            found[node] = set()
            open_.append(found[node])
            stack.append(_CLOSE)
        stack.extend(reversed(list(parts(node))))
    return found


_CLOSE: Final = object()
"""A marker on the stack, after the parts of a loop or switch."""


def _target(node: Any) -> ObjectSymbol | None:
    """Return the variable that an expression assigns, if it assigns one."""
    if isinstance(node, tree.Assign | tree.CompoundAssign | tree.Increment):
        target = node.target
        return target.symbol if isinstance(target, tree.ObjectName) else None
    return None


def _constant(condition: tree.Expression) -> bool | None:
    """Return the value of a constant condition, None for any other."""
    return bool(condition.value) if isinstance(condition, tree.Literal) else None


def _ends(value: tree.Expression) -> bool:
    """Return whether an expression never comes to its end."""
    match value:
        case tree.Call(callee=tree.FunctionName(symbol=symbol)):
            return symbol.is_noreturn or (symbol.is_external and symbol.name in _NEVER_RETURN)
        case tree.Intrinsic(name=name):
            return name in {"__builtin_unreachable", "__builtin_trap", "__crs_stop"}
        case tree.Convert(operand=inner):
            return _ends(inner)
        case tree.Comma():
            return _ends(value.first) or _ends(value.second)
        case tree.Conditional():
            return _ends(value.then) and _ends(value.otherwise)
        case tree.StatementExpression(body=[*_, tree.ExpressionStatement(expression=last)]):
            return _ends(last)
    return False


def _is_tangled(node: tree.Switch) -> bool:
    """Return whether labels of a switch are nested deeper in its body, as in Duff's device."""
    return sum(isinstance(each, tree.CaseLabel) for each in node.body) != len(node.labels)
