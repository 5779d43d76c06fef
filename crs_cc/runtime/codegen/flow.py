"""Code as a graph of nodes: the form between IR blocks and WebAssembly's nesting.

A C function may jump anywhere (`goto`), and a suspended one must be able to go on in the middle of
its loops. WebAssembly has neither. Two steps lead there: `dispatch` makes every loop enterable at
one node only, `nesting` then writes blocks and loops. Neither recurses, so a graph of any size and
depth is fine.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Final, Literal

from crs_cc.runtime.wasm import Instr

UNWIND: Final = "br_unwind"
"""Pseudo-instruction: leaves to the code behind the function's outermost block."""
FAULTED: Final = "br_faulted"
"""Pseudo-instruction: leaves to the code that notes the failure in locals `SITE` and `ADDRESS`."""
LANDING: Final = "i32.const_landing"
"""Pseudo-instruction `(LANDING, landing)`: pushes the landing's number."""


@dataclass(slots=True, eq=False)
class Node:
    """Straight code and where it goes next.

    Attributes:
        code: instructions; for "branch" and "table" they leave an i32 on the stack.
        exit: "jump" to the one target; "branch" to the first target if not zero, else the second;
            "table" to the target of that number, the last one for all others; "leave": the code
            itself has left the function.
        targets: the nodes that come next.
    """

    code: list[Instr] = field(default_factory=list)
    exit: Literal["jump", "branch", "table", "leave"] = "leave"
    targets: list[Node] = field(default_factory=list)

    def jump(self, target: Node) -> None:
        """End the node with a jump."""
        self.exit, self.targets = "jump", [target]


@dataclass(slots=True, eq=False)
class Landing:
    """A node that the function's entry, or a jump into a tangled loop, reaches by its number.

    Attributes:
        node: where the code goes on.
        number: its number, from 1; known once `add_dispatchers` has run.
    """

    node: Node
    number: int = 0
