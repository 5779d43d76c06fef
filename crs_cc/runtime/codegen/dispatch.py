"""Make every loop reducible, and every landing reachable from the entry.

A point at which a function can be resumed is a `Landing`. A loop that contains landings is given a
dispatcher as its new header: it jumps to the landing whose number is in the local `label`,
or, when that is 0, to the old header. The function's entry dispatches in the same way,
so a resumed call passes from dispatcher to dispatcher to its landing. A loop that `goto` enters
at several nodes is treated alike: each jump to it sets `label` and goes to the dispatcher.
Loops without landings are unchanged: only loops around calls pay for dispatch.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Final

from crs_cc.runtime.codegen.flow_graph import LANDING, Landing, Node
from crs_cc.runtime.codegen.fuel_charges import charge

MAX_NESTED_LOOPS: Final = 16
"""Loops nested deeper, which only irreducible jumps create, become one flat dispatcher.

It keeps the work linear in the size of the function.
"""


@dataclass(slots=True, eq=False)
class _Dispatcher:
    """A table node under construction: its landings and dispatchers, in order."""

    node: Node
    default: Node
    children: list[Landing | _Dispatcher] = field(default_factory=list)


def add_dispatchers(
    again: Node, start: Node, landings: list[Landing], label: int, damaged: Node
) -> None:
    """Connect `again` to the landings, and make every loop reducible.

    Args:
        again: a node without an exit, where a suspended function resumes.
        start: the entry of a fresh call; no node of its graph may jump there.
        landings: the points of resumption; they are numbered here.
        label: index of the i32 local that holds the number, 0 on all other paths.
        damaged: the target for a number that no landing has.
    """
    root = _Dispatcher(again, damaged, list(landings))
    _Loops(root, start, label).run()
    _number(root)
    _finish(root, label)


class _Loops:
    """Finds loops from the outside in, and adds a dispatcher to each that needs one."""

    def __init__(self, root: _Dispatcher, start: Node, label: int) -> None:
        self.label = label
        self.owner: dict[Landing, _Dispatcher] = {}
        self.landing_of: dict[Node, Landing] = {}
        for landing in root.children:
            if isinstance(landing, Landing):
                self.owner[landing] = root
                self.landing_of[landing.node] = landing
        self.nodes = _reachable([start, *self.landing_of])
        self.predecessors: dict[Node, list[Node]] = {node: [] for node in self.nodes}
        for node in self.nodes:
            for target in dict.fromkeys(node.targets):
                self.predecessors[target].append(node)

    def run(self) -> None:
        """Process the regions of the graph, each a list of nodes without its loop header."""
        regions = [(self.nodes, 0)]
        while regions:
            region, depth = regions.pop()
            for component in _components(region):
                header = self.loop(component, depth)
                regions.append(([node for node in component if node is not header], depth + 1))

    def loop(self, component: list[Node], depth: int) -> Node:
        """Return the header of the loop; create one if it has several entries."""
        inside = set(component)
        heads = [node for node in component if self._header(node, inside)] or component[:1]
        if depth >= MAX_NESTED_LOOPS:
            heads = component
        landings = [self.landing_of[node] for node in component if node in self.landing_of]
        if len(heads) == 1 and all(landing.node is heads[0] for landing in landings):
            return heads[0]
        dispatcher = _Dispatcher(Node(), heads[0])
        if landings:
            self._move_landings(dispatcher, landings)
        if len(heads) == 1:
            self._redirect(heads[0], dispatcher.node, self.predecessors[heads[0]])
        else:
            for head in heads:
                self._redirect_entries(head, dispatcher, inside)
        self._link(dispatcher.node, heads[0])
        return dispatcher.node

    def _header(self, node: Node, inside: set[Node]) -> bool:
        return any(source not in inside for source in self.predecessors[node])

    def _move_landings(self, dispatcher: _Dispatcher, landings: list[Landing]) -> None:
        """Move landings from their owner, the enclosing loop, to `dispatcher`."""
        owner = self.owner[landings[0]]
        moved = set(landings)
        place = owner.children.index(landings[0])
        owner.children[place] = dispatcher
        owner.children = [each for each in owner.children if each not in moved]
        dispatcher.children += landings
        self.owner.update(dict.fromkeys(landings, dispatcher))

    def _redirect_entries(self, head: Node, dispatcher: _Dispatcher, inside: set[Node]) -> None:
        """Redirect all jumps to `head` to the dispatcher, setting the label."""
        landing = self.landing_of.get(head)
        if landing is None:
            landing = Landing(head)
            self.landing_of[head] = landing
            self.owner[landing] = dispatcher
            dispatcher.children.append(landing)
        sources = self.predecessors[head]
        for side in (True, False):
            jumping = [source for source in sources if (source in inside) is side]
            if jumping:
                code = [*charge(-landing.prepaid), (LANDING, landing), ("local.set", self.label)]
                setter = Node(code)
                self.predecessors[setter] = []
                self._redirect(head, setter, jumping)
                setter.jump(dispatcher.node)
                self._link(setter, dispatcher.node)

    def _redirect(self, old: Node, new: Node, sources: list[Node]) -> None:
        for source in list(sources):
            source.targets = [new if target is old else target for target in source.targets]
            self.predecessors[old].remove(source)
            self._link(source, new)

    def _link(self, source: Node, target: Node) -> None:
        self.predecessors.setdefault(target, []).append(source)


def _number(root: _Dispatcher) -> None:
    """Assign numbers to the landings so that those below one dispatcher are consecutive."""
    number = 0
    work: list[Landing | _Dispatcher] = [root]
    while work:
        each = work.pop()
        if isinstance(each, Landing):
            number += 1
            each.number = number
        else:
            work.extend(reversed(each.children))


def _finish(root: _Dispatcher, label: int) -> None:
    """Write the tables."""
    order: list[_Dispatcher] = [root]
    for dispatcher in order:
        order.extend(each for each in dispatcher.children if isinstance(each, _Dispatcher))
    below: dict[_Dispatcher, list[int]] = {}
    for dispatcher in reversed(order):
        targets: list[Node] = []
        numbers: list[int] = []
        for child in dispatcher.children:
            if isinstance(child, Landing):
                code = [("i32.const", 0), ("local.set", label), *charge(child.prepaid)]
                targets.append(Node(code, "jump", [child.node]))
                numbers.append(child.number)
            else:
                targets.extend([child.node] * len(below[child]))
                numbers.extend(below[child])
        below[dispatcher] = numbers
        table = dispatcher.node
        if dispatcher is not root:  # one cheap test when not resuming
            table = Node()
            dispatcher.node.code.append(("local.get", label))
            dispatcher.node.exit = "branch"
            dispatcher.node.targets = [table, dispatcher.default]
        table.code += [("local.get", label), ("i32.const", numbers[0]), ("i32.sub",)]
        table.exit, table.targets = "table", [*targets, dispatcher.default]


def _reachable(roots: list[Node]) -> list[Node]:
    seen = dict.fromkeys(roots)
    work = list(reversed(roots))
    while work:
        for target in work.pop().targets:
            if target not in seen:
                seen[target] = None
                work.append(target)
    return list(seen)


def _components(region: list[Node]) -> list[list[Node]]:
    """Return the strongly connected components that are loops (Tarjan 1972, iterative)."""
    index: dict[Node, int] = dict.fromkeys(region, -1)
    low: dict[Node, int] = {}
    stack: list[Node] = []
    on_stack: set[Node] = set()
    found: list[list[Node]] = []
    counter = 0
    for root in region:
        if index[root] >= 0:
            continue
        work = [(root, iter(root.targets))]
        while work:
            node, rest = work[-1]
            if index[node] < 0:
                index[node] = low[node] = counter
                counter += 1
                stack.append(node)
                on_stack.add(node)
            for child in rest:
                if index.get(child, 0) < 0:
                    work.append((child, iter(child.targets)))
                    break
                if child in on_stack:
                    low[node] = min(low[node], index[child])
            else:
                work.pop()
                if work:
                    low[work[-1][0]] = min(low[work[-1][0]], low[node])
                if low[node] == index[node]:
                    found += _pop_component(node, stack, on_stack)
    return found


def _pop_component(root: Node, stack: list[Node], on_stack: set[Node]) -> list[list[Node]]:
    component: list[Node] = []
    while not component or component[-1] is not root:
        component.append(stack.pop())
        on_stack.discard(component[-1])
    component.reverse()
    return [component] if len(component) > 1 or root in root.targets else []
