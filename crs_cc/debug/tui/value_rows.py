"""The rows of the variables pane: groups of values with their expanded parts."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Final

from crs_cc.debug.commands.shell import Shell
from crs_cc.debug.data.values import Value
from crs_cc.debug.engine import Debugger
from crs_cc.debug.errors import DebugError
from crs_cc.debug.tui.screen_data import Key, ValueRow
from crs_cc.debug.world import rows
from crs_cc.debug.world.robot_rows import robot_rows
from crs_cc.debug.world.state_rows import state_rows
from crs_cc.debug.world.world_rows import world_rows

_CHUNK: Final = 100
"""Parts of a value that come at once; those behind have a row of their own to unfold."""


def variables(shell: Shell, unfolded: frozenset[Key]) -> tuple[ValueRow, ...]:
    """Return the groups.

    Args:
        shell: the command line of the run, with its displays.
        unfolded: the expanded rows.
    """
    tree = _Tree(shell, unfolded)
    debugger = shell.debugger
    frame, robot = debugger.view.current_frame(), debugger.names[debugger.view.robot]
    groups: list[tuple[str, str, Callable[[Key], Iterable[ValueRow]]]] = []
    if frame is not None:
        groups.append(("locals", frame.function, tree.locals))
    if shell.context.displays:
        groups.append(("watched", "displayed", tree.displays))
    groups += [
        ("globals", "globals", tree.globals),
        ("state", "State", tree.state),
        ("robot", robot, tree.robot),
        ("world", "world", tree.world),
    ]
    return tuple(
        ValueRow(
            (name,), title, "", True, _some(parts((name,)), name) if (name,) in unfolded else ()
        )
        for name, title, parts in groups
    )


def _some(parts: Iterable[ValueRow], name: str) -> tuple[ValueRow, ...]:
    """Return the rows of a group, or a row stating that it is empty."""
    return tuple(parts) or (ValueRow((name, ""), "", "nothing"),)


class _Tree:
    """Builds rows and their expanded children."""

    def __init__(self, shell: Shell, unfolded: frozenset[Key]) -> None:
        self._shell = shell
        self._debugger: Debugger = shell.debugger
        self._unfolded = unfolded

    def locals(self, group: Key) -> Iterator[ValueRow]:
        """Return the variables of the selected frame, with the same keys at each depth."""
        debugger = self._debugger
        frame = debugger.view.current_frame()
        if frame is None:
            return
        depth = len(debugger.view.frames()) - frame.number
        key = (*group, str(debugger.view.robot), f"{frame.function}@{depth}")
        seen: dict[str, int] = {}
        for each in debugger.view.variables():
            seen[each.name] = seen.get(each.name, 0) + 1  # nested blocks
            yield self._value((*key, f"{each.name}#{seen[each.name]}"), each.name, each.value)

    def globals(self, group: Key) -> Iterator[ValueRow]:
        """Return the program's variables."""
        for each in self._debugger.view.globals_():
            key = (*group, str(self._debugger.view.robot), each.name)
            yield self._value(key, each.name, each.value)

    def displays(self, group: Key) -> Iterator[ValueRow]:
        """Return the displays; those that cannot be evaluated have no value."""
        for number, display in self._shell.context.displays.items():
            key = (*group, str(number))
            try:
                value = self._debugger.view.evaluate_pure(display.expression)
            except DebugError:
                yield ValueRow(key, display.expression, "-")
            else:
                yield self._value(key, display.expression, value)

    def state(self, group: Key) -> Iterator[ValueRow]:
        """Return `State[]` by names; empty if the program has none."""
        debugger = self._debugger
        return self._rows(
            state_rows(debugger.view.vendor_state()), (*group, str(debugger.view.robot))
        )

    def robot(self, group: Key) -> Iterator[ValueRow]:
        """Return the rows about the robot."""
        found = robot_rows(self._debugger.session, self._debugger.view.robot)
        return self._rows(found, (*group, str(self._debugger.view.robot)))

    def world(self, group: Key) -> Iterator[ValueRow]:
        """Return the rows about the world."""
        return self._rows(world_rows(self._debugger.session.environment), group)

    def _rows(self, found: Iterable[rows.Row], above: Key) -> Iterator[ValueRow]:
        for each in found:
            key = (*above, each.name)
            parts = self._rows(each.children, key) if key in self._unfolded else ()
            yield ValueRow(key, each.name, each.text, bool(each.children), tuple(parts))

    def _value(self, key: Key, name: str, value: Value) -> ValueRow:
        has_parts = value.child_count > 0
        parts = self._parts(key, value, 0) if has_parts and key in self._unfolded else ()
        return ValueRow(key, name, value.text, has_parts, tuple(parts))

    def _parts(self, key: Key, value: Value, start: int) -> Iterator[ValueRow]:
        for name, part in value.children(start, _CHUNK):
            yield self._value((*key, name), name, part)
        more = value.child_count - start - _CHUNK
        if more > 0:
            rest = (*key, f"{start + _CHUNK}...")
            parts = self._parts(key, value, start + _CHUNK) if rest in self._unfolded else ()
            yield ValueRow(rest, f"{more} more", "", True, tuple(parts))
