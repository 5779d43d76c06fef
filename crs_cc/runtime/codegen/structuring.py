"""Translate a control flow graph to WebAssembly's nested blocks and loops.

The dominator tree determines the nesting (N. Ramsey, "Beyond Relooper", ICFP 2022): the nodes that
a node dominates are nested in it, and a merge node follows a block that its predecessors
break out of.
"""

from __future__ import annotations

from dataclasses import dataclass
from operator import itemgetter
from typing import Final

from crs_cc.ir.loops import postorder
from crs_cc.runtime.codegen.flow_graph import FAULTED, LANDING, SIDE_EXIT, UNWIND, Node
from crs_cc.runtime.wasm import UNLIKELY, Instr

_SPECIAL: Final = frozenset({UNWIND, FAULTED, LANDING, SIDE_EXIT, "if", "end"})


@dataclass(slots=True)
class _Order:
    """Reverse postorder, dominator tree, merge nodes and loop headers."""

    rank: dict[Node, int]
    children: dict[Node, list[Node]]
    merges: set[Node]
    headers: set[Node]


def _dominators(
    order: list[Node], rank: dict[Node, int], forward: dict[Node, list[Node]]
) -> dict[Node, Node]:
    """Return the immediate dominator of each node (Cooper, Harvey, Kennedy 2001)."""
    parent: dict[Node, Node] = {order[0]: order[0]}
    for node in order[1:]:  # reducible: forward predecessors come before their successors
        common = forward[node][0]
        for source in forward[node][1:]:
            while common is not source:
                if rank[common] > rank[source]:
                    common = parent[common]
                else:
                    source = parent[source]  # noqa: PLW2901 - both walk up to the meeting point
        parent[node] = common
    return parent


def _analyse(entry: Node) -> _Order:
    """Compute dominators, merge nodes and loop headers."""
    order = list(reversed(postorder(entry)))
    rank = {node: number for number, node in enumerate(order)}
    forward: dict[Node, list[Node]] = {node: [] for node in order}
    merges: set[Node] = set()
    headers: set[Node] = set()
    for node in order:
        for target in node.successors():
            if rank[target] <= rank[node]:
                headers.add(target)
            else:
                forward[target].append(node)
        if node.exit == "table":
            merges.update(node.targets)
    merges.update(node for node in order if len(forward[node]) > 1)
    merges.update(node.side_exit for node in order if node.side_exit is not None)
    parent = _dominators(order, rank, forward)
    children: dict[Node, list[Node]] = {node: [] for node in order}
    for node in order[1:]:
        children[parent[node]].append(node)
    return _Order(rank, children, merges, headers)


def emit(entry: Node, fault: list[Instr]) -> list[Instr]:
    """Return the code of a reducible graph.

    Args:
        entry: its entry.
        fault: code to execute on `FAULTED`. After it, and on `UNWIND`, control continues after the
            returned code, which is up to the caller.
    """
    return _Emitter(_analyse(entry)).run(entry, fault)


class _Emitter:
    """Writes nodes as nested blocks; `work` is a stack of what remains to be written."""

    def __init__(self, order: _Order) -> None:
        self.order = order
        self.out: list[Instr] = []
        self.depth = 0
        self.block_depth: dict[Node, int] = {}
        self.loop_depth: dict[Node, int] = {}
        self.work: list[Node | Instr] = []

    def run(self, entry: Node, fault: list[Instr]) -> list[Instr]:
        self.open("block")
        self.open("block")
        self.work += [("end",), *reversed(fault), ("end",), ("unreachable",), entry]
        while self.work:
            each = self.work.pop()
            if isinstance(each, Node):
                self.tree(each)
            else:
                self.out.append(each)
                self.depth -= each[0] == "end"
        return self.out

    def open(self, name: str) -> int:
        self.out.append((name,))
        self.depth += 1
        return self.depth

    def tree(self, node: Node) -> None:
        """Write a node and the nodes that it dominates."""
        if node in self.order.headers:
            self.loop_depth[node] = self.open("loop")
            self.work.append(("end",))
        merges = [child for child in self.order.children[node] if child in self.order.merges]
        merges.sort(key=self.order.rank.__getitem__, reverse=True)
        for child in merges:
            self.block_depth[child] = self.open("block")
            self.work += [child, ("end",)]
        if _SPECIAL.isdisjoint(map(itemgetter(0), node.code)):  # faster, and so most often
            self.out += node.code
        else:
            for instr in node.code:
                self.instruction(instr)
        match node.exit:
            case "jump":
                self._jump(node)
            case "branch":
                self._branch(node)
            case "table":
                self._table(node)

    def instruction(self, instr: Instr) -> None:
        """Write an instruction, which may be a pseudo-instruction or change the depth."""
        if instr[0] not in _SPECIAL:
            self.out.append(instr)
            return
        if instr[0] is UNWIND:
            self.out.append(("br", self.depth - 1))
        elif instr[0] is FAULTED:
            self.out.append(("br", self.depth - 2))
        elif instr[0] is SIDE_EXIT:
            self.out.append(("br", self.depth - self.block_depth[instr[1]]))
        elif instr[0] is LANDING:
            self.out.append(("i32.const", instr[1].number))
        else:
            self.out.append(instr)
            self.depth += 1 if instr[0] == "if" else -1

    def label(self, source: Node, target: Node) -> int | None:
        """Return the relative depth of a jump; None if the target is emitted in place."""
        if self.order.rank[target] <= self.order.rank[source]:
            return self.depth - self.loop_depth[target]
        if target in self.order.merges:
            return self.depth - self.block_depth[target]
        return None

    def _jump(self, node: Node) -> None:
        depth = self.label(node, node.targets[0])
        if depth is None:
            self.work.append(node.targets[0])
        else:
            self.out.append(("br", depth))

    def _branch(self, node: Node) -> None:
        then, otherwise = node.targets
        then_depth, otherwise_depth = self.label(node, then), self.label(node, otherwise)
        if node.unlikely and then_depth is None:
            self.out.append(UNLIKELY)
            self.depth += 1
            after = otherwise if otherwise_depth is None else ("br", otherwise_depth)
            self.work += [after, ("end",), then]
        elif then_depth is not None:
            self.out.append(("br_if", then_depth))
            self._continue(otherwise, otherwise_depth)
        elif otherwise_depth is not None:
            self.out += [("i32.eqz",), ("br_if", otherwise_depth)]
            self._continue(then, then_depth)
        else:
            self.open("if")
            self.work += [("end",), otherwise, ("else",), then]

    def _continue(self, target: Node, depth: int | None) -> None:
        if depth is None:
            self.work.append(target)
        else:
            self.out.append(("br", depth))

    def _table(self, node: Node) -> None:
        depths = [self.label(node, target) for target in node.targets]
        self.out.append(("br_table", tuple(depths[:-1]), depths[-1]))
