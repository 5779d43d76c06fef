"""The results of evaluating C expressions, and of resolving names in them."""

from __future__ import annotations

from dataclasses import dataclass

from crs_cc.debug.data.expression_compiler import ExpressionContext
from crs_cc.debug.data.values import Value
from crs_cc.debug.timeline.change import MemoryPatch
from crs_cc.ir.types import CType
from crs_cc.runtime.diagnosis.inspect import StackFrame


@dataclass(frozen=True, slots=True)
class Evaluation:
    """The result of an evaluation.

    Attributes:
        patches: what has changed in the program's memory; empty if nothing has.
        printed: what the program's functions have printed: the stream and bytes of each piece.
    """

    value: Value
    patches: tuple[MemoryPatch, ...] = ()
    printed: tuple[tuple[int, bytes], ...] = ()

    @property
    def changed(self) -> bool:
        """Return whether the program's memory or output has changed."""
        return bool(self.patches or self.printed)


@dataclass(frozen=True, slots=True)
class ObjectLocation:
    """The object that an expression names.

    Attributes:
        address: its first byte.
        size: its size [bytes].
        frame: the frame whose variables the expression uses, and with which the object ends;
            None if it uses only globals.
    """

    address: int
    size: int
    type: CType
    frame: StackFrame | None


@dataclass(frozen=True, slots=True)
class ExpressionScope:
    """The scope of an expression's names, independent of the further execution.

    Attributes:
        names: the scope.
        frame: the frame with its local variables; None if it uses none.
        innermost: the frame with whose return they end; other than `frame` if it uses variables
            of several calls.
        is_place: whether the expression names an object.
    """

    names: ExpressionContext
    frame: StackFrame | None
    innermost: StackFrame | None
    is_place: bool
