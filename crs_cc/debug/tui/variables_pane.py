"""The variables pane: a tree of values; changes since the last stop are highlighted."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Final

from rich.text import Text
from textual.message import Message
from textual.widgets import Tree
from textual.widgets.tree import TreeNode

from crs_cc.debug.tui.printable import printable
from crs_cc.debug.tui.screen_data import Key, ValueRow

_NAME: Final = "cyan"
_CHANGED: Final = "bold yellow"
_MARK: Final = "•"


class VariablesPane(Tree[ValueRow]):
    """Shows rows; posts `Unfolded` when the user expands or collapses one."""

    class Unfolded(Message):
        """The user has expanded or collapsed a row."""

        def __init__(self, key: Key, is_open: bool) -> None:
            super().__init__()
            self.key = key
            self.is_open = is_open

    def __init__(self, **arguments: str) -> None:
        super().__init__("variables", **arguments)  # type: ignore[arg-type]
        self.show_root = False
        self.guide_depth = 2
        self.border_title = "variables"
        self._before: dict[Key, str] = {}
        self._now: dict[Key, str] = {}
        self._rows: tuple[ValueRow, ...] = ()

    def show(self, rows: tuple[ValueRow, ...], *, moved: bool = True) -> None:
        """Show these rows.

        Args:
            rows: groups of values; those with parts in them are expanded.
            moved: whether the run has moved, so that changes are to be highlighted.
        """
        if moved:
            self._before = self._now
        elif rows == self._rows:
            return
        is_same_tree = _shape(rows) == _shape(self._rows)
        self._rows = rows
        self._now = {each.key: each.text for each in _all(rows)}
        if is_same_tree:
            self._relabel()
            return
        line, top = self.cursor_line, self.scroll_y
        cursor = self.cursor_node.data.key if self.cursor_node and self.cursor_node.data else ()
        with self.prevent(Tree.NodeExpanded, Tree.NodeCollapsed):
            self.clear()
            self._add(self.root, rows)
            self.root.expand()
        self.call_after_refresh(self._return_to, cursor, line, top)

    def _add(self, parent: TreeNode[ValueRow], rows: Iterable[ValueRow]) -> None:
        for row in rows:
            if row.has_parts:
                node = parent.add(self._label(row), row, expand=bool(row.parts))
                self._add(node, row.parts)
            else:
                parent.add_leaf(self._label(row), row)

    def _relabel(self) -> None:
        """Show the values in the tree that is there; only those that have changed are drawn."""
        for node, row in zip(_nodes(self.root), _all(self._rows), strict=True):
            node.data, label = row, self._label(row)
            if label != node.label:
                node.set_label(label)

    def _label(self, row: ValueRow) -> Text:
        if len(row.key) == 1:  # a group
            return Text(row.name, style="bold")
        before = self._before.get(row.key)
        changed = before is not None and before != row.text
        text = Text(no_wrap=True)
        text.append(printable(row.name), style=_NAME)
        if not row.name:
            text.append(row.text, style="dim")
        elif row.text:
            text.append(f" {_MARK} " if changed else " = ", style=_CHANGED if changed else "dim")
            text.append(printable(row.text), style=_CHANGED if changed else "")
        return text

    def _return_to(self, key: Key, line: int, top: float) -> None:
        """Restore the cursor: on the same value, or else in the same line."""
        for node in _nodes(self.root):
            if node.data is not None and node.data.key == key:
                line = node.line
        self.cursor_line = line
        self.scroll_to(y=top, animate=False)

    def on_tree_node_expanded(self, event: Tree.NodeExpanded[ValueRow]) -> None:
        """Post that a value is expanded."""
        self._post_unfolded(event.node, is_open=True)

    def on_tree_node_collapsed(self, event: Tree.NodeCollapsed[ValueRow]) -> None:
        """Post that a value is collapsed."""
        self._post_unfolded(event.node, is_open=False)

    def _post_unfolded(self, node: TreeNode[ValueRow], *, is_open: bool) -> None:
        if node.data is not None:
            self.post_message(self.Unfolded(node.data.key, is_open))


def _all(rows: Iterable[ValueRow]) -> Iterator[ValueRow]:
    for row in rows:
        yield row
        yield from _all(row.parts)


def _shape(rows: Iterable[ValueRow]) -> list[tuple[Key, bool, bool]]:
    """Return all of a tree but the values."""
    return [(each.key, each.has_parts, bool(each.parts)) for each in _all(rows)]


def _nodes(node: TreeNode[ValueRow]) -> Iterator[TreeNode[ValueRow]]:
    for each in node.children:
        yield each
        yield from _nodes(each)
