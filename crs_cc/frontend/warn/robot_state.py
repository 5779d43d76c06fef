"""Warnings about `State`, the robot's readings: waits that ask for none, and units mixed up.

`State` changes only when a call of the Nomadic client has a reply. A loop whose end depends on an
element of it alone, and that calls nothing that may ask the robot, never ends or never waits.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, Final

from crs_cc.frontend.check import tree
from crs_cc.frontend.check.checker import Unit
from crs_cc.frontend.check.fold import COMPARISONS, compare
from crs_cc.frontend.check.scope import ObjectSymbol
from crs_cc.frontend.check.tree_parts import walk

_STATE: Final = "State"
_HEADER: Final = "Nclient.h"

_WITHOUT_REQUESTS: Final = frozenset({
    "abs", "fabs", "fflush", "fprintf", "fputs", "getpid", "gettimeofday", "labs", "nanosleep",
    "printf", "putc", "putchar", "puts", "rand", "sleep", "sprintf", "sqrt", "time", "usleep",
})  # fmt: skip
"""Library functions that do not call the robot; with a handler of signals, some might."""

_HANDLERS: Final = frozenset({"signal", "sigaction", "setitimer", "alarm", "sigset"})


@dataclass(frozen=True, slots=True)
class _Range:
    """Elements of `State` and their values (`robot_api.names`).

    Attributes:
        first: the first element.
        last: the last one.
        least: their smallest value.
        most: their largest value.
        text: what they are, with the unit.
    """

    first: int
    last: int
    least: int
    most: int
    text: str


_RANGES: Final = (
    _Range(1, 16, 0, 15, "infrared readings are 0 to 15"),
    _Range(17, 32, 0, 255, "sonar readings are 0 to 255 inches, not tenths of inches"),
    _Range(36, 36, 0, 3599, "headings are 0 to 3599 tenths of degrees"),
)


def warn_state(unit: Unit) -> None:
    """Check every function of a file that uses the robot's `State`."""
    state = unit.externals.get(_STATE)
    if not isinstance(state, ObjectSymbol) or not state.location.file.endswith(_HEADER):
        return
    requesting = _RequestingFunctions(unit)
    for function in unit.functions:
        readings = _readings(function, state)
        for node in walk(function.body):
            if isinstance(node, tree.Binary) and node.op in COMPARISONS:
                _warn_range(unit, node, state, readings)
            elif isinstance(node, tree.Loop):
                _warn_loop(unit, node, state, requesting)


def _element(value: Any, state: ObjectSymbol) -> int | None:
    """Return the index of an element of State, the first possible one if a variable is added."""
    match value:
        case tree.Convert(operand=inner):
            return _element(inner, state)
        case tree.Dereference(
            pointer=tree.PointerAdd(
                pointer=tree.AddressOf(operand=tree.ObjectName(symbol=symbol)), index=index
            )
        ) if symbol is state:
            terms = (index.left, index.right) if isinstance(index, tree.Binary) else (index,)
            numbers = [int(each.value) for each in terms if isinstance(each, tree.Literal)]
            is_sum = not isinstance(index, tree.Binary) or index.op == "+"
            return numbers[0] if numbers and is_sum else None
    return None


def _readings(
    function: tree.FunctionDefinition, state: ObjectSymbol
) -> Mapping[ObjectSymbol, _Range | None]:
    """Return the local variables to which only readings of one kind are assigned."""
    found: dict[ObjectSymbol, _Range | None] = {}
    for node in walk(function.body):
        for symbol, value in _assigned(node):
            kind = _range(_element(value, state))
            found[symbol] = kind if found.get(symbol, kind) is kind else None
    return found


def _assigned(node: Any) -> Iterator[tuple[ObjectSymbol, Any]]:
    """Yield the variables that a node sets, each with its value, None if that is unknown."""
    match node:
        case tree.Declare(symbol=symbol, initialiser=tree.Initialiser(values=[first])):
            yield symbol, first.value
        case tree.Assign(target=tree.ObjectName(symbol=symbol)):
            yield symbol, node.value
        case (
            tree.CompoundAssign(target=tree.ObjectName(symbol=symbol))
            | tree.Increment(target=tree.ObjectName(symbol=symbol))
            | tree.AddressOf(operand=tree.ObjectName(symbol=symbol))
        ):
            yield symbol, None


def _range(element: int | None) -> _Range | None:
    if element is None:
        return None
    return next((each for each in _RANGES if each.first <= element <= each.last), None)


def _warn_range(
    unit: Unit,
    node: tree.Binary,
    state: ObjectSymbol,
    readings: Mapping[ObjectSymbol, _Range | None],
) -> None:
    """Warn about the comparison of a reading with a number that no reading reaches."""
    sides = _plain(node.left), _plain(node.right)
    known = next(filter(None, (_kind(each, state, readings) for each in sides)), None)
    bound = next((each.value for each in sides if isinstance(each, tree.Literal)), None)
    if known is None or bound is None or known.least - 1 <= bound <= known.most + 1:
        return
    pair = (bound, known.least) if isinstance(sides[0], tree.Literal) else (known.least, bound)
    outcome = "true" if compare(node.op, *pair) else "false"
    text = f"this comparison with {bound} is always {outcome}: {known.text}"
    unit.warning(node.location, text, flag="sensor-range")


def _plain(value: Any) -> Any:
    return _plain(value.operand) if isinstance(value, tree.Convert) else value


def _kind(
    value: Any, state: ObjectSymbol, readings: Mapping[ObjectSymbol, _Range | None]
) -> _Range | None:
    """Return what kind of reading an expression is, None if it is none."""
    if isinstance(value, tree.ObjectName):
        return readings.get(value.symbol)
    return _range(_element(value, state))


# Loops


class _RequestingFunctions:
    """The functions of a file that may post requests to the robot."""

    def __init__(self, unit: Unit) -> None:
        self._bodies = {each.symbol: each.body for each in unit.functions}
        self._known: dict[Any, bool] = {}
        self._has_handlers = any(
            isinstance(node, tree.Call)
            and isinstance(node.callee, tree.FunctionName)
            and node.callee.symbol.name in _HANDLERS
            for each in unit.functions
            for node in walk(each.body)
        )

    def may_request(self, nodes: list[Any]) -> bool:
        """Return whether statements or expressions call a function that may post a request."""
        return self._has_handlers or any(
            isinstance(node, tree.Call | tree.ComputedGoto) and self._is_request(node)
            for node in walk(nodes)
        )

    def _is_request(self, node: Any) -> bool:
        if not isinstance(node, tree.Call) or not isinstance(node.callee, tree.FunctionName):
            return True
        symbol = node.callee.symbol
        if symbol not in self._bodies:
            return symbol.name not in _WITHOUT_REQUESTS
        if symbol not in self._known:
            self._known[symbol] = False  # what it calls recursively adds nothing
            self._known[symbol] = self.may_request(self._bodies[symbol])
        return self._known[symbol]


def _warn_loop(
    unit: Unit, loop: tree.Loop, state: ObjectSymbol, requesting: _RequestingFunctions
) -> None:
    condition = next((each for each in _ends(loop) if _depends_on(each, state)), None)
    inside = [*(each for each in (loop.condition, loop.step) if each is not None), *loop.body]
    if condition is None or requesting.may_request(inside) or _changes(inside, state):
        return
    text = "this loop waits for 'State' to change, but asks the robot for nothing"
    hint = "call gs, or another function that reads sensors, in the loop"
    unit.warning(condition.location, text, hint, flag="stale-state")


def _ends(loop: tree.Loop) -> Iterator[Any]:
    """Yield the conditions on which a loop ends; of an endless loop those of its breaks."""
    if loop.condition is not None and not isinstance(loop.condition, tree.Literal):
        yield loop.condition
        return
    for each in loop.body:
        if isinstance(each, tree.If) and any(
            isinstance(last, tree.Break | tree.Return) for last in (*each.then, *each.otherwise)
        ):
            yield each.condition


def _changes(nodes: list[Any], state: ObjectSymbol) -> bool:
    """Return whether the program itself writes to State."""
    writes = (tree.Assign, tree.CompoundAssign, tree.Increment)
    return any(
        isinstance(node, writes) and _names(node.target, state) for node in walk(nodes)
    )  # fmt: skip


def _names(value: Any, state: ObjectSymbol) -> bool:
    return any(
        isinstance(node, tree.ObjectName) and node.symbol is state for node in walk([value])
    )  # fmt: skip


def _depends_on(condition: Any, state: ObjectSymbol) -> bool:
    """Return whether a condition has a part with elements of State and constants only.

    Parts that are joined by `&&` and `||` are independent.
    """
    if isinstance(condition, tree.Logical):
        return _depends_on(condition.left, state) or _depends_on(condition.right, state)
    return _names(condition, state) and _is_constant(condition, state)


def _is_constant(value: Any, state: ObjectSymbol) -> bool:
    """Return whether an expression depends on nothing but certain elements of State."""
    match value:
        case tree.Literal():
            return True
        case tree.Binary():
            return _is_constant(value.left, state) and _is_constant(value.right, state)
        case tree.Unary() | tree.Convert():
            return _is_constant(value.operand, state)
        case tree.Dereference(pointer=tree.PointerAdd(index=tree.Literal())):
            return _element(value, state) is not None
    return False
