"""C's `switch` as jump tables, and as comparisons for sparse cases."""

from __future__ import annotations

from typing import Final

from crs_cc.ir.instruction import Block, Constant, Operand, Switch
from crs_cc.runtime.codegen.flow_graph import Node
from crs_cc.runtime.codegen.writer import Writer

FEW: Final = 3  # maximum number of cases compared one by one
WASTE: Final = 4  # maximum ratio of entries to cases in a jump table
LARGEST_TABLE: Final = 4096


def lower_switch(writer: Writer, node: Node, switch: Switch, nodes: dict[Block, Node]) -> None:
    """End `node` with the dispatch, through nodes of comparisons if needed."""
    cases = [
        (number, nodes[block]) for number, block in sorted(switch.cases, key=lambda case: case[0])
    ]
    default = nodes[switch.default]
    work = [(node, cases)]
    while work:
        place, part = work.pop()
        writer.code = place.code
        if _dense(part):
            _table(writer, place, switch.value, part, default)
        elif len(part) <= FEW:
            _chain(writer, place, switch.value, part, default)
        else:
            middle = len(part) // 2
            low, high = Node(), Node()
            _compare(writer, switch.value, "lt_s", part[middle][0])
            place.exit, place.targets = "branch", [low, high]
            work += [(low, part[:middle]), (high, part[middle:])]


def _dense(cases: list[tuple[int, Node]]) -> bool:
    if len(cases) <= FEW:
        return False
    span = cases[-1][0] - cases[0][0] + 1
    return span <= min(LARGEST_TABLE, WASTE * len(cases))


def _compare(writer: Writer, value: Operand, test: str, number: int) -> None:
    writer.push(value)
    writer.push(Constant(value.type, number))
    writer.code.append((f"{value.type}.{test}",))


def _chain(
    writer: Writer, node: Node, value: Operand, cases: list[tuple[int, Node]], default: Node
) -> None:
    for number, target in cases:
        _compare(writer, value, "eq", number)
        following = Node()
        node.exit, node.targets = "branch", [target, following]
        node = following
        writer.code = node.code
    node.jump(default)


def _table(
    writer: Writer, node: Node, value: Operand, cases: list[tuple[int, Node]], default: Node
) -> None:
    first = cases[0][0]
    targets = [default] * (cases[-1][0] - first + 1)
    for number, target in cases:
        targets[number - first] = target
    if value.type == "i64":  # a distance of 2**32 or more must not wrap into the table
        inside = Node()
        _distance(writer, value, first)
        writer.code += [("i64.const", len(targets)), ("i64.lt_u",)]
        node.exit, node.targets = "branch", [inside, default]
        node, writer.code = inside, inside.code
    _distance(writer, value, first)
    if value.type == "i64":
        writer.code.append(("i32.wrap_i64",))
    node.exit, node.targets = "table", [*targets, default]


def _distance(writer: Writer, value: Operand, first: int) -> None:
    writer.push(value)
    writer.push(Constant(value.type, first))
    writer.code.append((f"{value.type}.sub",))
