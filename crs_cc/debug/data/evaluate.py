"""Evaluation of C expressions in a stopped program.

Names have the meaning that they would have in the source at the current location: the
variables of open blocks, then the names of the file. An expression is compiled once per location,
as conditions of breakpoints are evaluated often.

Side effects of an expression apply to the program; a failed evaluation has none.
"""

from __future__ import annotations

import contextlib
import copy
import functools
import re
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any, Final, Self

from crs_cc.core.source import Location
from crs_cc.debug.data.convenience_functions import (
    ConvenienceFunctions,
    checkable,
    unset_variable,
)
from crs_cc.debug.data.evaluation import Evaluation, ExpressionScope, ObjectLocation
from crs_cc.debug.data.expression_compiler import (
    ExpressionCompiler,
    ExpressionContext,
    PreparedExpression,
    SourceNames,
    UnknownSizeError,
    Use,
)
from crs_cc.debug.data.expression_memory import EvaluationError
from crs_cc.debug.data.expression_scope import (
    active_call,
    global_scope,
    innermost,
    lasting_scope,
)
from crs_cc.debug.data.external_values import ExternalUse, ExternalValues, NoExternalValues
from crs_cc.debug.data.instruction_steps import SCRATCH
from crs_cc.debug.data.interpret import Interpreter, check_address, result_bytes
from crs_cc.debug.data.memory import MemoryReads, SavedRegister, StoppedMemory
from crs_cc.debug.data.memory_inspection import FULL, MemoryInspector
from crs_cc.debug.data.notation import (
    NAME,
    ExternalName,
    Slice,
    convenience_assignment,
    display_name,
    slice_in,
)
from crs_cc.debug.data.observation import UNREADABLE, Observation
from crs_cc.debug.data.observed_value import observed
from crs_cc.debug.data.operators import unsigned
from crs_cc.debug.data.scope import FrameAddresses, Scopes, Storage
from crs_cc.debug.data.slices import row_of
from crs_cc.debug.data.unlinked_definitions import UnlinkedDefinitions
from crs_cc.debug.data.unused_objects import Edits, UnusedObjects, no_edits
from crs_cc.debug.data.values import Value
from crs_cc.debug.data.variables import Variable, globals_of, variables_of
from crs_cc.debug.errors import DebugError
from crs_cc.debug.timeline.change import UNLINKED
from crs_cc.debug.world.state_fields import StateField
from crs_cc.frontend.expression import EXPRESSION, CompiledExpression
from crs_cc.ir.instruction import ByteState
from crs_cc.ir.names import in_library
from crs_cc.ir.program import Program
from crs_cc.ir.types import LONG, VOID, ArrayType, CType, FunctionType, PointerType
from crs_cc.runtime.diagnosis.inspect import StackFrame, StoppedProgram

_MAY_BE_OUTSIDE: Final = re.compile(r"::|\$world|\w\s*\.\s*\w|distance\s*\(")
_WITHOUT: Final = bytes([ByteState.WITHOUT_VALUE])


class Evaluator:
    """Evaluates expressions in a robot's program.

    Attributes:
        convenience_values: the values of `$name` by name; that of `$` has an empty name.
        full_style: how values are written at length.
        settings: the values of the settings of the debugger by name, for convenience functions.
    """

    def __init__(
        self,
        stopped: Callable[[], StoppedProgram],
        names: SourceNames,
        convenience_values: dict[str, Value] | None = None,
        fields: tuple[StateField, ...] = (),
        *,
        edits: Edits = no_edits,
        robot: int = 0,
    ) -> None:
        """Create an evaluator.

        Args:
            stopped: returns the current state of the program.
            names: the names of its source files.
            convenience_values: the convenience variables, shared with other programs.
            fields: the fields of `State[]` for its robot.
            edits: returns the changes of objects that the program does not use.
            robot: the number of its robot.
        """
        self.convenience_values = {} if convenience_values is None else convenience_values
        self.full_style = FULL
        self._replaced: list[tuple[str, Value | None]] = []  # by the last expression
        self._contexts: dict[tuple[str, Location], ExpressionContext] = {}
        self.settings: Mapping[str, int] = {}
        self._robot = robot
        self._stopped = stopped
        self._names = names
        self._fields = fields
        now = stopped()
        self._scopes = Scopes(now.program, now.compiled)
        self._external: ExternalValues = NoExternalValues()
        self._preparation = ExpressionCompiler(names, self._scopes, self.convenience_values)
        self._memory = StoppedMemory(now, lambda *at: MemoryInspector(stopped()).explain(*at))
        self._unused = UnusedObjects((now.program.unused or Program()).data, edits)
        self._interpreter = Interpreter(
            now.program,
            now.compiled.addresses,
            self._memory,
            UnlinkedDefinitions(now.program).get,
            self._unused,
        )

    def seeing(self, external: ExternalValues) -> Self:
        """Return this evaluator for expressions that may also use the world and other robots.

        It shares all else, what was evaluated last too. To keep them here would be a reference
        cycle, as they are evaluated in the programs of all robots.
        """
        made = copy.copy(self)
        made._external = external
        return made

    def evaluate(self, text: str, frame: StackFrame | None = None) -> Evaluation:
        """Evaluate an expression.

        Args:
            text: the expression; or a slice, or `$name = expression`, see `notation`.
            frame: the frame whose scope applies; by default the innermost of the user's.

        Raises:
            DebugError: it is invalid here, or cannot be evaluated.
        """
        keeping = convenience_assignment(text)
        if keeping is not None:
            found = self.evaluate(keeping[1], frame)
            self._replaced.append((keeping[0], self.convenience_values.get(keeping[0])))
            self.convenience_values[keeping[0]] = found.value
            return found
        self._replaced.clear()
        stopped = self._stopped()
        frame = frame or innermost(stopped)
        if unset_variable(text, self.convenience_values):
            return Evaluation(Value(self.inspector(), VOID, b""))
        wanted = slice_in(text)
        if wanted is not None:
            return Evaluation(self._slice(wanted, frame))
        alone = self.external_name(text, frame)
        if alone is not None:
            return Evaluation(self._external.value(alone))
        prepared, result = self._run(text, stopped, frame)
        try:
            value = self._value(prepared.compiled, result)
            self._check_pointer(value)
        except EvaluationError as wrong:
            self._memory.undo()
            raise DebugError(str(wrong)) from None
        patches = self._memory.patches() if self._memory.has_changed() else ()
        patches += self._unused.patches()
        return Evaluation(value, patches, tuple(self._interpreter.printed))

    def _check_pointer(self, value: Value) -> None:
        """Raise EvaluationError if a pointer was assigned that the program could not use."""
        is_above = isinstance(value.type, PointerType) and (value.number or 0) >= SCRATCH
        if is_above and self._memory.has_changed():
            raise EvaluationError(
                f"{value.text} cannot be assigned: it is not in the memory of the program"
            )

    def undo(self) -> None:
        """Undo the side effects of the last expression, on convenience variables, too."""
        self._memory.undo()
        self._unused.begin()
        while self._replaced:
            name, before = self._replaced.pop()
            if before is None:
                del self.convenience_values[name]
            else:
                self.convenience_values[name] = before

    def holds(self, text: str, frame: StackFrame | None = None) -> bool:
        """Return whether a condition is true; its side effects are undone.

        Raises:
            DebugError: as for `evaluate`.
        """
        stopped = self._stopped()
        _, result = self._run(f"!!({text})", stopped, frame or innermost(stopped))
        self._memory.undo()
        return bool(result)

    def has_effects(self, text: str, frame: StackFrame | None = None) -> bool:
        """Return whether an expression would change the program, as far as it can be evaluated."""
        with contextlib.suppress(DebugError):
            return self.evaluate(text, frame).changed
        return False

    def check(self, text: str, function: str, place: Location) -> None:
        """Check that an expression is valid at a location; raise DebugError if it is not."""
        with contextlib.suppress(UnknownSizeError):
            self.prepared(checkable(text), function, place)

    def assigns(self, text: str, function: str, place: Location) -> bool:
        """Return whether an expression that is valid at a location is an assignment."""
        with contextlib.suppress(UnknownSizeError):
            return self.prepared(checkable(text), function, place).compiled.is_assignment
        return False

    def prepared(self, text: str, function: str, place: Location) -> PreparedExpression:
        """Compile an expression at a location; raise DebugError if it is invalid there."""
        return self._preparation.of(text, ExpressionContext(function, place), self._external)

    def type_of(self, text: str, frame: StackFrame | None = None) -> CType:
        """Return the type of an expression, which is not evaluated.

        Raises:
            DebugError: it is invalid here.
        """
        frame = frame or innermost(self._stopped())
        wanted = slice_in(text)
        if wanted is not None:
            return self._slice(wanted, frame).type
        alone = self.external_name(text, frame)
        if alone is not None:
            return self._external.value(alone).type
        return self._prepared(text, frame).compiled.type

    def scope_of(self, text: str, frame: StackFrame | None = None) -> ExpressionScope:
        """Return where the names of an expression have their meaning.

        Raises:
            DebugError: it is invalid here, or its meaning would change with time.
        """
        stopped = self._stopped()
        frame = frame or innermost(stopped)
        return lasting_scope(text, self._prepared(text, frame), self._here(frame), stopped, frame)

    def observe(
        self, text: str, scope: ExpressionContext, frame: StackFrame | None = None
    ) -> Observation:
        """Return the value of an expression with all memory that it depends on.

        It is a function of this memory: other than for `evaluate`, uninitialised and freed objects
        have the values that are there.

        Args:
            text: the expression; its side effects are undone.
            scope: the function and location that give its names their meaning.
            frame: the frame of that function; its own location does not matter.

        Raises:
            DebugError: it is invalid there.
        """
        stopped = self._stopped()
        known = replace(FrameAddresses.of(stopped, frame), place=None)
        has_sizes = frame is not None and frame.function == scope.function
        extents = self._scopes.extents(scope.function) if has_sizes else ()
        sizes = known.sizes(extents, stopped.memory)
        self._memory.reads = reads = MemoryReads()
        reads.spans |= {(known.address(each), LONG.size) for each in extents}
        try:
            prepared = self._preparation.of(text, replace(scope, sizes=sizes), self._external)
            result = self._result(prepared, known, frame)
            seen = observed(prepared.compiled, result, self._memory, self._interpreter)
            return replace(seen, is_elsewhere=True) if self._unused.is_used else seen
        except (EvaluationError, DebugError, RecursionError) as wrong:
            if isinstance(wrong, DebugError) and not reads.spans:
                raise
            return Observation(UNREADABLE.content, None, reads.in_program())
        finally:
            self._memory.undo()
            self._memory.reads = None

    def place(self, text: str, frame: StackFrame | None = None) -> ObjectLocation:
        """Return the location of the object that an expression names.

        Raises:
            DebugError: it names no object.
        """
        stopped = self._stopped()
        frame = frame or innermost(stopped)
        wanted = slice_in(text)
        prepared, result = self._run(text if wanted is None else wanted.base, stopped, frame)
        self._memory.undo()
        is_local = any(isinstance(use, Use) and use.storage.in_frame for use in prepared.uses)
        depends_on = frame if is_local else None
        if wanted is not None:
            value = self._slice(wanted, frame)
            return ObjectLocation(value.address or 0, value.type.size, value.type, depends_on)
        compiled = prepared.compiled
        address = unsigned(result or 0, 32) if compiled.is_place else SCRATCH
        if address >= SCRATCH:
            raise DebugError(f"'{text}' is a value, not an object in memory")
        return ObjectLocation(address, compiled.type.size, compiled.type, depends_on)

    def is_unused(self, text: str, frame: StackFrame | None = None) -> bool:
        """Return whether an expression names an object that the program does not use."""
        stopped = self._stopped()
        prepared, result = self._run(text, stopped, frame or innermost(stopped))
        self.undo()
        return prepared.compiled.is_place and unsigned(result or 0, 32) >= UNLINKED

    def variables(self, frame: StackFrame | None = None) -> list[Variable]:
        """Return the variables of a frame, those of the innermost block first.

        Parameters come last; variables that are declared later are left out.
        """
        stopped = self._stopped()
        frame = frame or innermost(stopped)
        if frame is None or in_library(frame.location):
            return []
        type_of = self._names.types(frame.function, frame.location.file)
        return variables_of(self._scopes, type_of, self.inspector(), frame)

    def declared_at(self, function: str, place: Location) -> list[Storage]:
        """Return the variables of a function that are visible at a place, the innermost first.

        Args:
            function: the linker's name of the function.
            place: the location.
        """
        own = self._scopes.of(function)
        return [each for each in own if each.variable.reaches(place) and each.is_visible(place)]

    def globals_(self) -> list[Variable]:
        """Return the global variables of the user's files, sorted by name."""
        storages = [*self._scopes.globals_(), *self._unused.storages()]
        return globals_of(storages, self.inspector())

    def inspector(self) -> MemoryInspector:
        """Return an inspector of the program's current memory."""
        scratch = self._interpreter.scratch
        name_above = self._interpreter.name_of
        return MemoryInspector(self._stopped(), scratch, self._fields, self.full_style, name_above)

    def uses_external_values(self, text: str, frame: StackFrame | None = None) -> bool:
        """Return whether an expression uses the world, or the programs of other robots.

        Raises:
            DebugError: it is invalid here.
        """
        return bool(self._prepared(text, frame).external)

    def global_scope(self, text: str, frame: StackFrame | None = None) -> ExpressionContext:
        """Return where the names of an expression have their meaning, whatever is called.

        Raises:
            DebugError: it is invalid here, or uses local variables or values of the debugger's.
        """
        return global_scope(text, self._prepared(text, frame), self._here(frame))

    def _prepared(self, text: str, frame: StackFrame | None) -> PreparedExpression:
        return self._preparation.of(self._expanded(text, frame), self._here(frame), self._external)

    def _here(self, frame: StackFrame | None) -> ExpressionContext:
        """Return the scope of a frame, by default the innermost of the user's."""
        stopped = self._stopped()
        frame = frame or innermost(stopped)
        return self._standing(stopped, frame, FrameAddresses.of(stopped, frame))

    def external_name(self, text: str, frame: StackFrame | None = None) -> ExternalName | None:
        """Return the value from outside that an expression is; None if it is more than that."""
        if not _MAY_BE_OUTSIDE.search(text):
            return None
        rest, special = self._preparation.rewritten(text, self._here(frame), self._external)
        is_alone = rest.strip() == NAME.format(0) and len(special) == 1
        return special[0] if is_alone and isinstance(special[0], ExternalName) else None

    def _standing(
        self, stopped: StoppedProgram, frame: StackFrame | None, known: FrameAddresses
    ) -> ExpressionContext:
        if frame is None:
            return ExpressionContext()
        sizes = known.sizes(self._scopes.extents(frame.function), stopped.memory)
        if not sizes:  # as mostly: then nothing of it changes
            place = frame.function, frame.location
            if place not in self._contexts:
                self._contexts[place] = ExpressionContext(*place)
            return self._contexts[place]
        return ExpressionContext(frame.function, frame.location, sizes)

    def _run(
        self, text: str, stopped: StoppedProgram, frame: StackFrame | None
    ) -> tuple[PreparedExpression, Any]:
        """Evaluate an expression; return it compiled, and its value or address."""
        known, text = FrameAddresses.of(stopped, frame), self._expanded(text, frame)
        prepared = self._preparation.of(text, self._standing(stopped, frame, known), self._external)
        try:
            return prepared, self._result(prepared, known, frame)
        except EvaluationError as wrong:
            self._memory.undo()
            raise DebugError(str(wrong)) from None
        except RecursionError:
            self._memory.undo()
            raise DebugError("too many nested calls") from None

    def _result(
        self, prepared: PreparedExpression, known: FrameAddresses, frame: StackFrame | None
    ) -> Any:
        """Evaluate a compiled expression; return its value or address.

        Raises:
            DebugError: a variable does not exist now.
            EvaluationError: it cannot be evaluated.
        """
        stopped = self._stopped()
        arguments: list[int | bytes] = []
        saved: list[SavedRegister] = []
        for use in prepared.uses:
            if isinstance(use, bytes | ExternalUse):
                arguments.append(use if isinstance(use, bytes) else self._content(use))
                continue
            where = (
                known
                if not use.inside
                else FrameAddresses.of(stopped, active_call(use.inside, stopped, frame))
            )
            own = where.saved(use.storage)
            if own is not None:
                saved.append(own)
            arguments.append(where.address(use.storage))
            if use.storage.variable.is_indirect:
                arguments[-1] = self._pointer(use, own, arguments[-1])
        self._memory.begin(saved)
        return self._interpreter.evaluate(prepared.compiled.program, EXPRESSION, arguments)

    def _content(self, use: ExternalUse) -> bytes:
        """Return the bytes of a value from outside."""
        value = self._external.value(use.name)
        if not value.is_initialised:
            raise EvaluationError(f"'{display_name(use.name)}' is uninitialised")
        return value.content

    def _pointer(self, use: Use, saved: SavedRegister | None, address: int | bytes) -> int:
        """Return the address of an array that is held by a hidden pointer."""
        assert isinstance(address, int)
        if self._memory.reads is not None:
            self._memory.reads.spans.add((address, PointerType.size))
        memory = self._stopped().memory
        if saved is not None and not saved.has_value(memory):
            raise DebugError(f"'{use.storage.variable.name}' does not exist yet")
        return int(memory[address : address + 4].view("<u4")[0])

    def _value(self, compiled: CompiledExpression, result: Any) -> Value:
        ctype, inspector = compiled.type, self.inspector()
        if isinstance(ctype, FunctionType):
            ctype = PointerType(ctype)
        if not compiled.is_place:
            check_address(ctype, result)
            return Value(inspector, ctype, result_bytes(ctype, result))
        address = unsigned(result, 32)
        if address >= SCRATCH:
            content = self._interpreter.read_scratch(address, ctype.size)
            return Value(inspector, ctype, content, b"", address if address >= UNLINKED else None)
        if not isinstance(ctype, ArrayType) or ctype.size:
            self._memory.read(address, 1, judged=False)
        return inspector.value(address, ctype)

    def _slice(self, wanted: Slice, frame: StackFrame | None) -> Value:
        """Return a slice as an array."""
        row = row_of(wanted, functools.partial(self._part, frame=frame))
        try:
            if row.address >= UNLINKED:
                self._interpreter.read_scratch(row.address, row.type.size)
            else:
                self._memory.read(row.address, row.type.size, judged=False)
        except EvaluationError as wrong:
            raise DebugError(str(wrong)) from None
        return replace(self.inspector().value(row.address, row.type), first=row.first)

    def _part(self, text: str, frame: StackFrame | None) -> Value:
        """Evaluate a part of a slice, without side effects."""
        found = self.evaluate(text, frame)
        if found.changed:
            self._memory.undo()
            raise DebugError(f"'{text}' would change the program")
        return found.value

    def _expanded(self, text: str, frame: StackFrame | None) -> str:
        """Return an expression with the calls of convenience functions replaced by their values."""
        stack = self._stopped().stack
        functions = ConvenienceFunctions(self._part, stack, self._robot, self.settings)
        return functions.expanded(text, frame)
