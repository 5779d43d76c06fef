"""C expressions, evaluated where a program has stopped.

An expression means what it would mean in the source at the place where the function stands: the
variables of its open blocks, then the names of its file. It is compiled once for each place, as the
conditions of breakpoints are evaluated often.

What an expression changes, the program finds changed; a mistake inside changes nothing.
"""

from __future__ import annotations

import re
import struct
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Final

from crs_cc.debug.errors import DebugError
from crs_cc.debug.interpret import SCRATCH, EvaluationError, Interpreter
from crs_cc.debug.memory import StoppedMemory
from crs_cc.debug.operators import unsigned
from crs_cc.debug.program import DebugProgram
from crs_cc.debug.scope import Frame, Home, Kind, Scopes
from crs_cc.debug.sight import Sight
from crs_cc.debug.values import Value
from crs_cc.errors import CompileError
from crs_cc.frontend.expression import EXPRESSION, CompiledExpression, FileNames
from crs_cc.ir.names import in_library, plain_name
from crs_cc.ir.types import ArrayType, CType, FloatType, FunctionType, PointerType, VoidType
from crs_cc.runtime.diagnosis.inspect import StackFrame, Stopped
from crs_cc.source import Diagnostics, Location

LONGEST: Final = 10_000
"""Longer expressions are refused [characters]."""

_NAME: Final = re.compile(r"[A-Za-z_$][\w$]*")
_NOWHERE: Final = Location("")


@dataclass(frozen=True, slots=True)
class Evaluation:
    """What an expression has come to.

    Attributes:
        value: its value.
        changed: whether the program's memory is another one now.
    """

    value: Value
    changed: bool


@dataclass(frozen=True, slots=True)
class Place:
    """An object that an expression names, to be watched.

    Attributes:
        address: its first byte.
        size: [bytes].
        type: its type.
        frame: the active function whose variables the expression uses: with it the place ends;
            None when it uses global ones only.
    """

    address: int
    size: int
    type: CType
    frame: StackFrame | None


@dataclass(frozen=True, slots=True)
class Variable:
    """A variable of a stopped program.

    Attributes:
        name: its name.
        value: its value.
        scope: "parameter", "local", "static" (of a function) or "global".
        is_hidden: whether its name means another one where the function stands.
    """

    name: str
    value: Value
    scope: Kind
    is_hidden: bool = False


@dataclass(frozen=True, slots=True)
class _Prepared:
    """An expression compiled for a place, and the variables that it uses."""

    compiled: CompiledExpression
    homes: tuple[Home, ...]
    types: tuple[CType, ...]


class Names:
    """What the names in a program's files mean; read from the files when first asked for."""

    def __init__(self, program: DebugProgram) -> None:
        self._program = program
        self._files: dict[str, FileNames] = {}

    def of(self, function: str, file: str) -> FileNames:
        """Gives the names that the C file of a function knows.

        Args:
            function: the linker's name of the function.
            file: where it stands, which may be a header.

        Raises:
            DebugError: the file cannot be compiled any more.
        """
        paths = {str(path): path for path in self._program.paths}
        unit = function.rpartition(":")[0]
        name = next((each for each in (unit, file) if each in paths), next(iter(paths)))
        if name not in self._files:
            try:
                self._files[name] = FileNames(paths[name], self._program.options)
            except CompileError as error:
                first = error.diagnostics[0]
                raise DebugError(f"{first.location}: {first.text}; has it changed?") from None
        return self._files[name]


class Evaluator:
    """Evaluates expressions in a robot's program."""

    def __init__(self, stopped: Callable[[], Stopped], names: Names) -> None:
        """Takes what tells where the program stands now, and what its names mean."""
        self._stopped = stopped
        self._names = names
        now = stopped()
        self._program, self._compiled = now.program, now.compiled
        self._scopes = Scopes(now.program, now.compiled)
        self._memory = StoppedMemory(now, self._explain)
        self._interpreter = Interpreter(now.program, now.compiled.addresses, self._memory)
        self._prepared: dict[tuple[Any, ...], _Prepared] = {}

    def evaluate(self, text: str, frame: StackFrame | None = None) -> Evaluation:
        """Evaluates an expression.

        Args:
            text: the expression.
            frame: the active function to look from; by default the innermost of the user's files.

        Raises:
            DebugError: it means nothing here, or cannot be evaluated.
        """
        frame = frame or self._innermost()
        prepared = self._prepare(text, frame)
        result = self._run(prepared, frame)
        try:
            value = self._value(prepared.compiled, result)
        except EvaluationError as wrong:
            self._memory.undo()
            raise DebugError(str(wrong)) from None
        return Evaluation(value, self._memory.has_changed())

    def undo(self) -> None:
        """Takes back what the last expression changed."""
        self._memory.undo()

    def holds(self, text: str, frame: StackFrame | None = None) -> bool:
        """Tells whether a condition is true; whatever it does is taken back.

        Raises:
            DebugError: as for `evaluate`.
        """
        frame = frame or self._innermost()
        prepared = self._prepare(f"!!({text})", frame)
        result = self._run(prepared, frame)
        self._memory.undo()
        return bool(result)

    def check(self, text: str, function: str, place: Location) -> None:
        """Finds out whether an expression will mean something at a place.

        Raises:
            DebugError: it does not.
        """
        self._prepare_at(text, function, place)

    def type_of(self, text: str, frame: StackFrame | None = None) -> CType:
        """Gives the type of an expression, which is not evaluated.

        Raises:
            DebugError: it means nothing here.
        """
        return self._prepare(text, frame or self._innermost()).compiled.type

    def place(self, text: str, frame: StackFrame | None = None) -> Place:
        """Gives where the object lies that an expression names.

        Raises:
            DebugError: it names none.
        """
        frame = frame or self._innermost()
        prepared = self._prepare(text, frame)
        result, compiled = self._run(prepared, frame), prepared.compiled
        self._memory.undo()
        address = unsigned(result or 0, 32)
        if not compiled.is_place or address >= SCRATCH:
            raise DebugError(f"'{text}' is a value and no object in memory")
        is_local = any(home.in_frame for home in prepared.homes)
        return Place(address, compiled.type.size, compiled.type, frame if is_local else None)

    def variables(self, frame: StackFrame | None = None) -> list[Variable]:
        """Gives the variables of an active function, those of the innermost block first.

        Parameters come last; variables that are declared behind the place are left out.
        """
        frame = frame or self._innermost()
        if frame is None or in_library(frame.location):
            return []
        names = self._names.of(frame.function, frame.location.file)
        known, sight, seen = Frame.of(self._stopped(), frame), self.sight(), set[str]()
        found = []
        for home in self._scopes.of(frame.function):
            variable = home.variable
            if variable.is_visible(frame.location):
                value = sight.value(known.address(home), names.type_of(variable))
                found.append(Variable(variable.name, value, home.kind, variable.name in seen))
                seen.add(variable.name)
        return sorted(found, key=lambda each: each.scope == "parameter")

    def globals_(self) -> list[Variable]:
        """Gives the global variables of the user's own files, by their names."""
        sight = self.sight()
        return [
            Variable(home.variable.name, sight.value(home.at, home.variable.ctype), home.kind)
            for home in self._scopes.globals_()
        ]

    # -- compiling ---------------------------------------------------------------------------

    def _innermost(self) -> StackFrame | None:
        stack = self._stopped().stack
        return next((each for each in stack if not in_library(each.location)), None)

    def _prepare(self, text: str, frame: StackFrame | None) -> _Prepared:
        function, place = ("", _NOWHERE) if frame is None else (frame.function, frame.location)
        return self._prepare_at(text, function, place)

    def _prepare_at(self, text: str, function: str, place: Location) -> _Prepared:
        if len(text) > LONGEST:
            raise DebugError("the expression is too long")
        key = text, function, place
        found = self._prepared.get(key)
        if found is None:
            found = self._prepared[key] = self._compile(text, function, place)
        return found

    def _compile(self, text: str, function: str, place: Location) -> _Prepared:
        names = self._names.of(function, place.file)
        used = set(_NAME.findall(text))
        homes: dict[str, Home] = {}
        for home in self._visible(function, place, names):
            if home.variable.name in used:
                homes.setdefault(home.variable.name, home)
        types = tuple(names.type_of(home.variable) for home in homes.values())
        pairs = list(zip(homes, types, strict=True))
        try:
            compiled = names.compile(text, plain_name(function), pairs, Diagnostics())
        except CompileError as error:
            first = error.diagnostics[0]
            hint = f" ({first.hint})" if first.hint else ""
            raise DebugError(f"{first.text}{hint}") from None
        except RecursionError:
            raise DebugError("the expression is nested too deeply") from None
        return _Prepared(compiled, tuple(homes.values()), types)

    def _visible(self, function: str, place: Location, names: FileNames) -> Sequence[Home]:
        """Gives the variables that names may mean at a place, the innermost first.

        One whose declaration is still to come counts if its name means nothing else.
        """
        if not function or in_library(place):
            return ()
        every = [each for each in self._scopes.of(function) if each.variable.reaches(place)]
        now = [each for each in every if each.variable.is_visible(place)]
        later = [
            each
            for each in every
            if not each.variable.is_visible(place) and not names.knows(each.variable.name)
        ]
        return [*now, *later]

    # -- running -----------------------------------------------------------------------------

    def _run(self, prepared: _Prepared, frame: StackFrame | None) -> Any:
        known = Frame.of(self._stopped(), frame)
        arguments = [known.address(home) for home in prepared.homes]
        saved = [each for each in map(known.saved, prepared.homes) if each is not None]
        self._memory.begin(saved)
        try:
            return self._interpreter.evaluate(prepared.compiled.program, EXPRESSION, arguments)
        except (EvaluationError, RecursionError) as wrong:
            self._memory.undo()
            too_deep = "too many calls inside each other"
            text = too_deep if isinstance(wrong, RecursionError) else str(wrong)
            raise DebugError(text) from None

    def _value(self, compiled: CompiledExpression, result: Any) -> Value:
        ctype, sight = compiled.type, self.sight()
        if isinstance(ctype, FunctionType):
            ctype = PointerType(ctype)
        if not compiled.is_place:
            return Value(sight, ctype, _bytes(ctype, result))
        address = unsigned(result, 32)
        if address >= SCRATCH:
            return Value(sight, ctype, self._interpreter.scratch(address, ctype.size))
        if not isinstance(ctype, ArrayType) or ctype.size:
            self._memory.read(address, 1, judged=False)
        return sight.value(address, ctype)

    def sight(self) -> Sight:
        """Gives what looks at the program's memory as it is now."""
        return Sight(self._stopped(), self._interpreter.scratch)

    def _explain(self, address: int, size: int, reading: bool) -> str:
        return self.sight().explain(address, size, reading)


def _bytes(ctype: CType, result: Any) -> bytes:
    """Gives a value as it would lie in memory."""
    if isinstance(ctype, VoidType) or result is None:
        return b""
    if isinstance(ctype, FloatType):
        return struct.pack("<f" if ctype.size == 4 else "<d", result)
    return unsigned(int(result), 8 * ctype.size).to_bytes(ctype.size, "little")
