"""Variables and watched expressions of a stopped program, its robot and its world, in rows.

A row has a key that stays the same from stop to stop, so that a page can ask for the parts of the
rows that its user has unfolded, and mark those that have changed. `ask` is the expression by which
its past can be asked for, `last` whether it is an object that has been written.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from crs_cc.debug.data.part_expression import child_expression
from crs_cc.debug.errors import DebugError
from crs_cc.debug.world.robot_rows import robot_rows
from crs_cc.debug.world.state_rows import vendor_state_rows
from crs_cc.debug.world.world_rows import world_rows
from crs_cc.ir.types import ArrayType, RecordType

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator

    from crs_cc.debug.commands.shell import Shell
    from crs_cc.debug.data.values import Value
    from crs_cc.debug.data.variables import Variable
    from crs_cc.debug.world.rows import Row as TextRow
    from crs_cc.workbench.context import Context

Row = dict[str, Any]

_CHUNK: Final = 100
"""Parts of a value that come at once; those behind have a row of their own to unfold."""

_MAX_ROWS: Final = 3000
"""In an answer, chosen by us: some hundred kilobytes."""


def values(screen: Context, unfolded: str) -> list[Row]:
    """Return the groups of rows, with the parts of those that are unfolded.

    Args:
        screen: the screen.
        unfolded: the keys of the rows that are, one in a line.
    """
    where = screen.run.where()
    if where is None:
        return []
    return _Tree(screen.run.shell(), frozenset(unfolded.split("\n"))).groups()


class _Tree:
    """Builds rows and their unfolded parts."""

    def __init__(self, shell: Shell, unfolded: frozenset[str]) -> None:
        self._shell, self._unfolded = shell, unfolded
        self._debugger = shell.debugger
        self._left = _MAX_ROWS

    def groups(self) -> list[Row]:
        """Return the groups; those without anything are left out, except the watched ones."""
        view = self._debugger.view
        frame = view.current_frame()
        function = "" if frame is None else frame.function
        name = self._debugger.names[view.robot]
        found: list[tuple[str, str, Callable[[str], Iterable[Row]]]] = [
            ("watched", "Watched", self._displays),
            ("locals", f"Variables of {function}", self._locals),
            ("globals", "Global variables", self._globals),
            ("state", "State[] as the program has it", self._state),
            ("robot", f"Robot {name}", self._robot),
            ("world", "World", self._world),
        ]
        rows = []
        for key, title, parts in found:
            is_open = key in self._unfolded
            own = list(parts(key)) if is_open else []
            if key == "locals" and frame is None:
                continue
            rows.append({"key": key, "name": title, "parts": True, "children": own})
        return rows

    def _locals(self, group: str) -> Iterator[Row]:
        """Yield the variables of the selected frame, with the same keys at each depth."""
        view = self._debugger.view
        frame = view.current_frame()
        if frame is not None:
            depth = len(view.frames()) - frame.number
            yield from self._variables(f"{group}/{frame.function}@{depth}", view.variables())

    def _globals(self, group: str) -> Iterator[Row]:
        """Yield the program's variables."""
        return self._variables(group, self._debugger.view.globals_())

    def _variables(self, above: str, found: Iterable[Variable]) -> Iterator[Row]:
        seen: dict[str, int] = {}
        for each in found:
            seen[each.name] = seen.get(each.name, 0) + 1  # nested blocks
            expression = "" if each.is_hidden else each.name
            row = self._value(f"{above}/{each.name}#{seen[each.name]}", each.name, each.value,
                              expression)  # fmt: skip
            yield row | {"scope": each.scope}

    def _displays(self, group: str) -> Iterator[Row]:
        """Yield the watched expressions, with the reason of those that have no value here."""
        for number, display in self._shell.context.displays.items():
            key = f"{group}/{number}"
            try:
                value = self._debugger.view.evaluate_pure(display.expression)
            except DebugError as error:
                row = {"key": key, "name": display.expression, "error": str(error)}
            else:
                row = self._value(key, display.expression, value, display.expression)
            yield row | {"number": number}

    def _state(self, group: str) -> Iterator[Row]:
        """Yield `State[]` by names; nothing if the program has none."""
        view = self._debugger.view
        for row in self._rows(vendor_state_rows(view, view.robot), group):
            index = row["name"].partition("]")[0].removeprefix("[")
            yield row | {"set": f"State[{index}]", "ask": f"State[{index}]", "last": True}

    def _robot(self, group: str) -> Iterator[Row]:
        """Yield the values of the robot."""
        return self._rows(robot_rows(self._debugger.session, self._debugger.view.robot), group)

    def _world(self, group: str) -> Iterator[Row]:
        """Yield the values of the world."""
        return self._rows(world_rows(self._debugger.session.environment), group)

    def _rows(self, found: Iterable[TextRow], above: str) -> Iterator[Row]:
        for each in found:
            key = f"{above}/{each.name}"
            row: Row = {"key": key, "name": each.name, "value": each.text}
            if each.children:
                is_open = key in self._unfolded
                row |= {
                    "parts": True,
                    "children": list(self._rows(each.children, key)) if is_open else [],
                }
            yield row

    def _value(self, key: str, name: str, value: Value, expression: str) -> Row:
        self._left -= 1
        row: Row = {"key": key, "name": name, "value": value.text, "type": str(value.type)}
        if expression and not isinstance(value.type, ArrayType | RecordType):
            row["set"] = expression
        if expression:
            row |= {"ask": expression, "last": value.address is not None}
        if value.child_count:
            is_open = key in self._unfolded and self._left > 0
            children = list(self._parts(key, value, expression, 0)) if is_open else []
            row |= {"parts": True, "children": children}
        return row

    def _parts(self, key: str, value: Value, expression: str, start: int) -> Iterator[Row]:
        for name, part in value.children(start, _CHUNK):
            own = child_expression(expression, name.partition(" ")[0] if name[0] == "[" else name)
            yield self._value(f"{key}/{name}", name, part, own)
        more = value.child_count - start - _CHUNK
        if more > 0 and self._left > 0:
            rest = f"{key}/{start + _CHUNK}..."
            is_open = rest in self._unfolded
            parts = list(self._parts(key, value, expression, start + _CHUNK)) if is_open else []
            yield {"key": rest, "name": f"{more} more", "parts": True, "children": parts}
