"""Building an executable from the user's C files: compile, link, generate code, cache."""

from __future__ import annotations

import contextlib
import functools
import pickle
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

from crs_cc.core.errors import CompileError
from crs_cc.core.gc_pause import gc_paused
from crs_cc.core.source import Diagnostic, Diagnostics, Location
from crs_cc.frontend.preprocess.regular_file import digest
from crs_cc.ir.names import in_library
from crs_cc.runtime.executable import (
    Detail,
    Driver,
    Executable,
    Module,
    code_format,
    command_name,
    compile_driver,
    compile_module,
    load_executable,
    load_module,
)
from crs_cc.session.device_library import device_sources
from crs_cc.toolchain import cache

if TYPE_CHECKING:
    from crs_cc.frontend.preprocess.options import Dialect, Options
    from crs_cc.ir.program import Program

_Names: TypeAlias = tuple[str, str]  # the program's name and command, see `Executable`
_Lines: TypeAlias = dict[str, list[str]]


@dataclass(frozen=True, slots=True)
class _Linked:
    """A cached program, from which each build generates its own code.

    Attributes:
        digests: of every file that the compiler looked for, see `Diagnostics`.
        content: the pickled program and source lines, without the library's definitions, see
            `_pack`; builds whose code is cached need them only for messages and debuggers.
        warnings: the compiler's warnings.
    """

    digests: dict[str, str]
    content: bytes
    warnings: tuple[Diagnostic, ...]


def build_executable(
    paths: Sequence[Path],
    diagnostics: Diagnostics,
    *,
    include_paths: Sequence[Path] = (),
    defines: Sequence[str] = (),
    undefines: Sequence[str] = (),
    standard: str = "gnu17",
    root: Path | None = None,
    named_from: Path | None = None,
    checked: bool = True,
    debug: bool = False,
    trap_overflow: bool = False,
    dialect: Dialect | None = None,
) -> Executable:
    """Compile and link C files, or load the program from the cache if nothing has changed.

    Args:
        paths: the C files.
        diagnostics: receives the warnings.
        include_paths: folders for `#include`, in order.
        defines: macros as `NAME`, `NAME=value` or `NAME(x)=value`.
        undefines: predefined macros to remove.
        standard: its C standard, see `frontend.preprocess.options.STANDARDS`.
        root: the folder of the whole project; the current directory if it is not given.
        named_from: a folder that is left out of the names of files in messages.
        checked: check every access through a pointer.
        debug: allow breakpoints on every statement.
        trap_overflow: stop at signed overflow, in checked builds.
        dialect: the API that it calls; by default it is detected.

    Raises:
        CompileError: the files are not a valid program.
    """
    if not paths:
        raise CompileError.at(Location(""), "no C files", "name at least one")
    names = " ".join(map(str, paths)), command_name(paths[0])
    flags = {"checked": checked, "debug": debug, "trap_overflow": trap_overflow}
    key = cache.key(
        map(str, (path.resolve() for path in paths)),
        map(str, paths),
        map(str, (path.resolve() for path in include_paths)),
        map(str, include_paths),
        defines,
        undefines,
        standard,
        str(root and root.resolve()),
        str(named_from),
        str(dialect),
        device_sources(),
    )
    entry = cache.load(key, _Linked)
    if entry is not None and _unchanged(entry):
        diagnostics.messages.extend(entry.warnings)
        diagnostics.digests.update(entry.digests)
        return _build(entry, key, names, flags, diagnostics)

    from crs_cc.frontend.dialect import dialect_of
    from crs_cc.session.library import library_options

    macros = tuple(defines), tuple(undefines)
    options = library_options(tuple(include_paths), *macros, standard, root, named_from=named_from)
    own = Diagnostics(digests={str(path): digest(path) for path in paths})
    try:
        with gc_paused():  # saves a fifth of the time
            options = replace(options, dialect=dialect or dialect_of(paths, options))
            program, lines = _compile(paths, options, own)
            entry = _Linked(own.digests, _pack(program, lines), tuple(own.messages))
            executable = _make(program, names, lines, flags, _code_key(key, entry, flags))
    finally:
        diagnostics.messages.extend(own.messages)
        diagnostics.lines.update(own.lines)
        diagnostics.digests.update(own.digests)
    cache.store(key, entry)
    return executable


def _compile(
    paths: Sequence[Path], options: Options, diagnostics: Diagnostics
) -> tuple[Program, _Lines]:
    """Return the linked program, and the lines of its files."""
    from crs_cc.frontend.unit import compile_file
    from crs_cc.ir.verify import verify
    from crs_cc.runtime.link import link
    from crs_cc.session.library import library

    units = []
    for path in paths:
        # Separate diagnostics: errors in one file do not stop the next.
        found = Diagnostics(digests=diagnostics.digests)
        with contextlib.suppress(CompileError):
            units.append(compile_file(path, options, found))
        diagnostics.messages.extend(found.messages)
        diagnostics.lines.update(found.lines)
    if diagnostics.errors:
        raise CompileError(diagnostics.messages)
    for unit in units:
        verify(unit)
    program = link(units, library(), diagnostics)
    unused = program.unused.functions if program.unused else {}
    files = {each.location.file for each in (program.functions | unused).values()}
    lines = {file: diagnostics.lines[file] for file in sorted(files & diagnostics.lines.keys())}
    return program, lines


def _build(
    entry: _Linked, key: str, names: _Names, flags: dict[str, bool], diagnostics: Diagnostics
) -> Executable:
    """Return a build of a cached program, whose code may be cached, too."""
    place = _code_key(key, entry, flags)
    machine_code = _known_code(place)
    known = machine_code and load_executable(*names, machine_code, _reload(entry, flags))
    if known:
        return known
    with gc_paused():
        program, lines = _unpack(entry)
        diagnostics.lines.update(lines)
        return _make(program, names, lines, flags, place)


def _make(
    program: Program, names: _Names, lines: _Lines, flags: dict[str, bool], place: str
) -> Executable:
    """Compile a linked program, and remember its machine code under a name of the cache.

    The cache holds machine code by the WebAssembly that it was compiled from, which is the same for
    sources that differ only in comments, names of variables, or their folder. Under the name is
    only the name of that entry.
    """
    from crs_cc.runtime.executable import make_executable

    def module(wasm: bytes) -> tuple[Module, bytes]:
        entry = cache.key("machine code", wasm, code_format())
        cache.store(place, entry)
        machine_code = cache.load(entry, bytes)
        if machine_code and (known := load_module(machine_code)):
            return known, machine_code
        made, machine_code = compile_module(wasm)
        cache.store(entry, machine_code)
        return made, machine_code

    return make_executable(
        program, names[0], command=names[1], lines=lines, module_of=module, **flags
    )


def _known_code(place: str) -> bytes | None:
    """Return the machine code that `_make` has stored, if it is still in the cache."""
    entry = cache.load(place, str)
    return cache.load(entry, bytes) if entry else None


def _code_key(key: str, entry: _Linked, flags: dict[str, bool]) -> str:
    return cache.key("code", key, entry.content, str(flags), code_format())


def build_watching(executable: Executable) -> Executable:
    """Return the watching build of a program, from the cache if possible.

    Both builds have the same debug information, see `codegen.watchpoints`; so this shares that of
    the other.
    """
    place = cache.key("watching", executable.machine_code)
    machine_code = _known_code(place)
    names = executable.name, executable.command
    known = machine_code and load_executable(*names, machine_code, executable.detail)
    if known:
        return known
    old = executable.detail()
    flags = {"checked": old.compiled.checked, "trap_overflow": old.compiled.trap_overflow}
    with gc_paused():
        made = _make(old.program, names, {}, {**flags, "debug": True, "watching": True}, place)
    return replace(made, detail=executable.detail)


def build_driver() -> Driver:
    """Return the module that runs a round of any fleet, from the cache if possible."""
    name = cache.key("driver", code_format())
    entry = cache.load(name, bytes)
    known = entry and load_module(entry)
    if known:
        return known
    made = compile_driver()
    cache.store(name, bytes(made.serialize()))
    return made


def _unchanged(entry: _Linked) -> bool:
    return all(digest(Path(file)) == known for file, known in entry.digests.items())


def _reload(entry: _Linked, flags: dict[str, bool]) -> Callable[[], Detail]:
    """Return a function that builds a cached program's detail on first use."""

    @functools.cache
    def detail() -> Detail:
        from crs_cc.runtime.codegen.module import compile_program

        with gc_paused():
            program, lines = _unpack(entry)
            return Detail(program, compile_program(program, **flags), lines)

    return detail


def _pack(program: Program, lines: _Lines) -> bytes:
    """Pickle a program and its lines, with None for the library's definitions."""
    from crs_cc.session.library import library

    find = library().find
    own = [
        {
            name: None if in_library(each.location) and find(name) is each else each
            for name, each in table.items()
        }
        for table in (program.functions, program.data)
    ]
    return pickle.dumps((*own, program.unused, lines), pickle.HIGHEST_PROTOCOL)


def _unpack(entry: _Linked) -> tuple[Program, _Lines]:
    """Return what `_pack` packed; programs of one process share the library's definitions."""
    from crs_cc.ir.program import Program
    from crs_cc.session.library import library

    packed = pickle.loads(entry.content)  # noqa: S301 - see `crs_cc.toolchain.cache`
    functions, data, unused, lines = packed
    for definitions in (functions, data):
        for name, each in definitions.items():
            definitions[name] = each or library().find(name)
    return Program(functions, data, unused=unused), lines
