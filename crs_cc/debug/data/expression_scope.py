"""The scopes of expressions that are evaluated later."""

from __future__ import annotations

from dataclasses import replace

from crs_cc.debug.data.evaluation import ExpressionScope
from crs_cc.debug.data.expression_compiler import ExpressionContext, PreparedExpression, Use
from crs_cc.debug.data.external_values import ExternalUse
from crs_cc.debug.errors import DebugError
from crs_cc.ir.names import in_library, plain_name
from crs_cc.runtime.diagnosis.inspect import StackFrame, StoppedProgram


def lasting_scope(
    text: str,
    prepared: PreparedExpression,
    names: ExpressionContext,
    stopped: StoppedProgram,
    frame: StackFrame | None,
) -> ExpressionScope:
    """Return the scope of an expression for as long as its variables exist.

    Args:
        text: the expression.
        prepared: the same, compiled.
        names: its scope now.
        stopped: the program.
        frame: the selected frame.

    Raises:
        DebugError: its meaning would change with time.
    """
    if any(isinstance(each, bytes | ExternalUse) for each in prepared.uses):
        raise DebugError(f"'{text}' uses more than the memory of the program")
    uses = [each for each in prepared.uses if isinstance(each, Use)]
    is_local = any(each.storage.in_frame and not each.inside for each in uses)
    inside = [active_call(each.inside, stopped, frame) for each in uses if each.inside]
    if is_local and any(frame and each.fp < frame.fp for each in inside):
        raise DebugError(f"'{text}' uses variables of an inner call: select its frame")
    frames = [*inside, *([frame] if is_local and frame else [])]
    innermost = min(frames, key=lambda each: each.fp, default=None)
    own = frame if is_local else innermost
    return ExpressionScope(replace(names, sizes={}), own, innermost, prepared.compiled.is_place)


def global_scope(
    text: str, prepared: PreparedExpression, names: ExpressionContext
) -> ExpressionContext:
    """Return the scope of an expression that needs no frame.

    Raises:
        DebugError: it uses local variables, or values of the debugger's.
    """
    for each in prepared.uses:
        if isinstance(each, bytes):
            raise DebugError(f"'{text}' uses values that only the debugger has")
        if isinstance(each, Use) and each.storage.in_frame:
            raise DebugError(
                f"'{text}' uses the world and the local variable '{each.storage.variable.name}':"
                " set a breakpoint with a condition instead (break LOCATION if ...)"
            )
    return replace(names, sizes={})


def active_call(function: str, stopped: StoppedProgram, frame: StackFrame | None) -> StackFrame:
    """Return the frame of a function: the nearest outer one, or else the innermost."""
    active = [each for each in stopped.stack if each.function == function]
    if not active:
        raise DebugError(f"'{plain_name(function)}' is not active: it has no variables")
    outside = [each for each in active if frame is None or each.fp >= frame.fp]
    return (outside or active)[0]


def innermost(stopped: StoppedProgram) -> StackFrame | None:
    """Return the innermost frame of the user's own code."""
    return next((each for each in stopped.stack if not in_library(each.location)), None)
