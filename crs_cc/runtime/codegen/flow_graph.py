"""The control flow graph between IR blocks and WebAssembly's nested blocks.

A C function may jump anywhere (`goto`), and a suspended one must be able to resume in the middle of
its loops. WebAssembly allows neither. There are two steps: `dispatch` makes the graph reducible,
`structuring` then writes blocks and loops. Neither recurses, so a graph of any size and
depth is fine.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Final, Literal

from crs_cc.ir.loops import postorder
from crs_cc.runtime.wasm import Instr

UNWIND: Final = "br_unwind"
"""Pseudo-instruction: branch to the code after the function's outermost block."""
FAULTED: Final = "br_faulted"
"""Pseudo-instruction: branch to the code that reports the failure in `SITE` and `ADDRESS`."""
LANDING: Final = "i32.const_landing"
"""Pseudo-instruction `(LANDING, landing)`: push the landing's number."""


SIDE_EXIT: Final = "br_side_exit"
"""Pseudo-instruction `(SIDE_EXIT, node)`: branch to the node's side exit."""


@dataclass(slots=True, eq=False)
class Node:
    """A basic block with its exit.

    Attributes:
        code: instructions; for "branch" and "table" they leave an i32 on the stack.
        exit: "jump" to the only target; "branch" to the first target if not zero, else the second;
            "table" to the target of that number, by default the last; "leave": the code
            itself has left the function.
        targets: the successors.
        side_exit: where `SIDE_EXIT` in its code leads; it has no successors and is no landing.
        unlikely: whether the first target of a branch is.
    """

    code: list[Instr] = field(default_factory=list)
    exit: Literal["jump", "branch", "table", "leave"] = "leave"
    targets: list[Node] = field(default_factory=list)
    side_exit: Node | None = None
    unlikely: bool = False

    def successors(self) -> list[Node]:
        """Return all nodes that may follow."""
        return self.targets if self.side_exit is None else [*self.targets, self.side_exit]

    def jump(self, target: Node) -> None:
        """End the node with a jump."""
        self.exit, self.targets = "jump", [target]


@dataclass(slots=True, eq=False)
class Landing:
    """A node that is reached by number, from the function's entry or by a jump into a loop.

    Attributes:
        number: its number, from 1; known once `add_dispatchers` has run.
        prepaid: the fuel that must have been paid for the node when it is reached, see
            `fuel_charges`; a function that is resumed there pays it again.
        after_call: whether it is behind a call that has returned.
    """

    node: Node
    number: int = 0
    prepaid: int = 0
    after_call: bool = False


def take_apart(entry: Node) -> None:
    """Free the nodes of a graph at once: their cycles would wait for the garbage collector."""
    for node in postorder(entry):
        node.code.clear()
        node.targets.clear()
