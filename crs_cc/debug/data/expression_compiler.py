"""Compilation of the user's expressions for the current location of a program.

It is done once per location, as conditions of breakpoints are evaluated often.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, Final

from crs_cc.core.errors import CompileError
from crs_cc.core.source import Diagnostics, Location
from crs_cc.debug.data.external_values import ExternalUse, ExternalValues, external_use
from crs_cc.debug.data.notation import (
    NAME,
    ConvenienceVariable,
    QualifiedName,
    SpecialName,
    display_name,
    restore_names,
    rewritten,
    with_world,
)
from crs_cc.debug.data.scope import Scopes, Storage, concrete
from crs_cc.debug.data.values import Value
from crs_cc.debug.errors import DebugError
from crs_cc.debug.program import DebugProgram
from crs_cc.frontend.expression import BlockNames, CompiledExpression, FileNames
from crs_cc.ir.instruction import Variable
from crs_cc.ir.names import in_library, plain_name
from crs_cc.ir.types import CType, PointerType, is_variably_modified

MAX_LENGTH: Final = 10_000
"""Longer expressions are refused [characters]."""
_MAX: Final = 1000
"""So many expressions are kept compiled."""

_LOSES_POINTER: Final = "incompatible pointer to integer conversion"
"""A warning of the compiler's that is an error here: the change would not be what is meant."""

_WORD: Final = re.compile(r"[A-Za-z_$][\w$]*")
_MEMBER: Final = re.compile(r"(?:\.|->)\s*[A-Za-z_]\w*")

NOWHERE: Final = Location("")
TypeOf = Callable[[Variable], CType]
"""Returns the type of a variable of a program."""

Sizes = Mapping[Location, int]


class UnknownSizeError(DebugError):
    """The type of an expression depends on a size that is unknown before run time."""


@dataclass(frozen=True, slots=True)
class ExpressionContext:
    """The scope of an expression.

    Attributes:
        function: the linker's name of the function; "" for none.
        place: its current location.
        sizes: the sizes of its variably modified types, see `scope.FrameAddresses`.
    """

    function: str = ""
    place: Location = NOWHERE
    sizes: Sizes = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Use:
    """A variable that an expression uses.

    Attributes:
        inside: the function whose innermost frame has it; "" for the selected frame.
    """

    storage: Storage
    inside: str = ""


@dataclass(frozen=True, slots=True)
class PreparedExpression:
    """A compiled expression.

    Attributes:
        compiled: the expression.
        uses: its arguments: addresses of variables, values from outside, and bytes of convenience
            variables.
        sizes: the sizes of types for which it was compiled.
        external: the values from outside among its arguments.
    """

    compiled: CompiledExpression
    uses: tuple[Use | ExternalUse | bytes, ...]
    sizes: Sizes
    external: tuple[ExternalUse, ...] = ()


class SourceNames:
    """The names in a program's source files; read from the files on first use."""

    def __init__(self, program: DebugProgram) -> None:
        self._program = program
        self._paths = program.files
        self._files: dict[str, FileNames | str] = {}

    def of(self, function: str, file: str) -> FileNames:
        """Return the names that the C file of a function declares.

        Args:
            function: the linker's name of the function.
            file: the file of the function, maybe a header.

        Raises:
            DebugError: the file has changed since the program was built.
        """
        unit = function.rpartition(":")[0]
        known = next((each for each in (unit, file) if each in self._paths), None)
        if known is None:  # it is in a header
            files = [self._file(each) for each in self._paths]
            return next((each for each in files if each.defines(function)), files[0])
        return self._file(known)

    def _file(self, name: str) -> FileNames:
        """Return the names of a C file; it is read only once, even on failure."""
        if name not in self._files:
            try:
                found = FileNames(self._paths[name], self._program.options)
            except CompileError as error:
                first = error.diagnostics[0]
                self._files[name] = f"{first.location}: {first.text}; has it changed?"
            else:
                self._files[name] = self._change(found) or found
        names = self._files[name]
        if isinstance(names, str):
            raise DebugError(names)
        return names

    def types(self, function: str, file: str) -> TypeOf:
        """Return a function for the types of variables, in terms of the C file of a function.

        If the file has changed since the program was built, types are those of the program:
        they look the same but are not identical to the compiler.
        """
        try:
            return self.of(function, file).type_of
        except DebugError:
            return lambda variable: variable.ctype

    def _change(self, found: FileNames) -> str:
        """Return a message if the file has changed since the program was built, else ""."""
        for file, lines in self._program.executable.detail().lines.items():
            if file in found.lines and list(found.lines[file]) != list(lines):
                return f"{file} has changed since the program was built: names cannot be resolved"
        return ""


class ExpressionCompiler:
    """Compiles expressions and caches them."""

    def __init__(
        self,
        names: SourceNames,
        scopes: Scopes,
        kept: Mapping[str, Value],
    ) -> None:
        """Store the names of files and functions, and the convenience variables."""
        self._names = names
        self._scopes = scopes
        self._kept = kept
        self._known: dict[tuple[Any, ...], PreparedExpression] = {}

    def of(
        self, text: str, standing: ExpressionContext, external: ExternalValues
    ) -> PreparedExpression:
        """Compile an expression; raise DebugError if it is invalid there.

        Args:
            text: the expression.
            standing: where its names have their meaning.
            external: the world and the other robots.
        """
        key = text, standing.function, standing.place
        found = self._known.get(key)
        if found is not None and found.sizes == standing.sizes and _is_current(found, external):
            return found
        if len(text) > MAX_LENGTH:
            raise DebugError("the expression is too long")
        found = self._compile(text, standing, external)
        if not any(isinstance(each, bytes) for each in found.uses):
            if len(self._known) >= _MAX:
                self._known.clear()
            self._known[key] = found
        return found

    def _compile(
        self, text: str, standing: ExpressionContext, external: ExternalValues
    ) -> PreparedExpression:
        names = self._names.of(standing.function, standing.place.file)
        rest, special = self.rewritten(text, standing, external)
        used, blocks = set(_WORD.findall(_MEMBER.sub(" ", rest))), names.in_blocks(standing.place)
        known = self._visible(standing, names, used, blocks)
        found: list[tuple[str, Use | ExternalUse | bytes, CType]] = [
            (name, Use(storage), self._type(names, storage, standing)) for name, storage in known
        ]
        found += [
            (NAME.format(number), *self._special(each, names, standing, external))
            for number, each in enumerate(special)
        ]
        pairs = [(name, ctype) for name, _, ctype in found]
        try:
            warnings = Diagnostics()
            function = plain_name(standing.function)
            compiled = names.compile(rest, function, pairs, warnings, blocks)
        except CompileError as error:
            first = error.diagnostics[0]
            hint = f" ({first.hint})" if first.hint else ""
            raise DebugError(restore_names(f"{first.text}{hint}", special)) from None
        except RecursionError:
            raise DebugError("the expression is nested too deeply") from None
        for warning in warnings.messages:
            if warning.text.startswith(_LOSES_POINTER):
                raise DebugError(
                    restore_names(f"{warning.text} (cast it if that is meant)", special)
                )
        uses = tuple(use for _, use, _ in found)
        outside = tuple(each for each in uses if isinstance(each, ExternalUse))
        return PreparedExpression(compiled, uses, standing.sizes, outside)

    def rewritten(
        self, text: str, standing: ExpressionContext, external: ExternalValues
    ) -> tuple[str, tuple[SpecialName, ...]]:
        """Return an expression in C, and its names that C does not have.

        Raises:
            DebugError: the names of the file are not known.
        """
        names = self._names.of(standing.function, standing.place.file)

        blocks = names.in_blocks(standing.place)

        def is_in_c(name: str) -> bool:
            is_known = names.knows(name) or name in blocks.names
            return is_known or bool(self._visible(standing, names, {name}, blocks))

        def is_robot(name: str) -> bool:
            return external.is_robot(name) and not self._scopes.functions(name)

        return rewritten(with_world(text, external.is_object, is_in_c), is_robot)

    def _special(
        self,
        name: SpecialName,
        names: FileNames,
        standing: ExpressionContext,
        external: ExternalValues,
    ) -> tuple[Use | ExternalUse | bytes, CType]:
        """Return the value and the type of a name that is not C."""
        match name:
            case QualifiedName():
                outer = self._outer(name)
                return outer, self._type(names, outer.storage, standing)
            case ConvenienceVariable():
                value = self._value(name)
                return value.content, value.type
        try:
            use = external_use(external, name)
        except DebugError as wrong:
            raise DebugError(f"{display_name(name)}: {wrong}") from None
        return use, use.type

    def _type(self, names: FileNames, storage: Storage, standing: ExpressionContext) -> CType:
        """Return the type of the variable in a storage."""
        variable = storage.variable
        ctype = names.type_of(variable)
        if is_variably_modified(ctype):
            made = concrete(ctype, standing.sizes)
            if made is None:
                text = f"'{variable.name}' does not exist yet: its size is not known"
                raise UnknownSizeError(text)
            ctype = made
        if variable.is_indirect:
            assert isinstance(ctype, PointerType)
            ctype = ctype.target
        return ctype

    def _visible(
        self, standing: ExpressionContext, names: FileNames, used: set[str], blocks: BlockNames
    ) -> list[tuple[str, Storage]]:
        """Return the variables that names refer to at a location.

        Of what is visible there, the last declaration hides the others. A variable that is declared
        later counts if its name has no other meaning.
        """
        place = standing.place
        if not standing.function or in_library(place):
            return []
        found: dict[str, Storage] = {}
        later: dict[str, Storage] = {}
        for storage in self._scopes.of(standing.function):
            variable = storage.variable
            if variable.name not in used or not variable.reaches(place):
                continue
            inner = blocks.names.get(variable.name)
            if storage.is_visible(place):
                if inner is None or inner.location < variable.location:
                    found.setdefault(variable.name, storage)
            elif inner is None and not names.knows(variable.name):
                later.setdefault(variable.name, storage)
        return list((later | found).items())

    def _outer(self, wanted: QualifiedName) -> Use:
        """Find `file::name` or `function::name`."""
        if "." in wanted.inside:
            storage = self._scopes.static(wanted.name, wanted.inside)
            if storage is None:
                raise DebugError(f"no variable '{wanted.name}' in {wanted.inside}")
            return Use(storage)
        functions = self._scopes.functions(wanted.inside)
        if not functions:
            raise DebugError(f"no function '{wanted.inside}'")
        for function in functions:
            for storage in self._scopes.of(function):
                if storage.variable.name == wanted.name:
                    return Use(storage, function if storage.in_frame else "")
        raise DebugError(f"'{wanted.inside}' has no variable '{wanted.name}'")

    def _value(self, wanted: ConvenienceVariable) -> Value:
        name = wanted.name
        if name.startswith("$"):  # counted back from the last one
            back = name.removeprefix("$") or "1"
            last = max((int(each) for each in self._kept if each.isdigit()), default=0)
            name = str(last - int(back)) if back.isdigit() and len(back) < 9 else name
        value = self._kept.get(name)
        if value is None:
            raise DebugError(f"no convenience variable ${wanted.name}")
        if not value.is_initialised or not value.content:
            raise DebugError(f"${wanted.name} has no value: it is {value.text}")
        return value


def _is_current(found: PreparedExpression, external: ExternalValues) -> bool:
    """Return whether the types of values from outside are as they were."""
    return all(external.state(each.name) == each.state for each in found.external)
