"""From the user's C files to an executable: compile, link, generate code, cache."""

from __future__ import annotations

import contextlib
import functools
import pickle
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from crs_cc.core.errors import CompileError
from crs_cc.core.gc_pause import without_collector
from crs_cc.core.source import Diagnostic, Diagnostics
from crs_cc.frontend.preprocess.regular_file import digest
from crs_cc.runtime.executable import (
    Detail,
    Driver,
    Executable,
    command_name,
    compile_driver,
    load_executable,
    load_module,
)
from crs_cc.session import cache
from crs_cc.session.device_library import device_sources

if TYPE_CHECKING:
    from crs_cc.frontend.preprocess.options import Dialect, Options


@dataclass(frozen=True, slots=True)
class _Entry:
    """A cached executable, with the digests of its sources.

    Attributes:
        digests: of every file that the compiler looked for, see `Diagnostics`.
        machine_code: wasmtime's serialised module.
        source: the pickled IR and source lines, which only messages and debuggers need.
        warnings: the compiler's warnings.
    """

    digests: dict[str, str]
    machine_code: bytes
    source: bytes
    warnings: tuple[Diagnostic, ...]


def build_executable(
    paths: Sequence[Path],
    diagnostics: Diagnostics,
    *,
    include_paths: Sequence[Path] = (),
    defines: Sequence[str] = (),
    undefines: Sequence[str] = (),
    standard: str = "gnu17",
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
        checked: check every access through a pointer.
        debug: allow breakpoints on every statement.
        trap_overflow: stop at signed overflow, in checked builds.
        dialect: the API that it calls; by default it is detected.

    Raises:
        CompileError: the files are not a valid program.
    """
    name = " ".join(map(str, paths))
    flags = {"checked": checked, "debug": debug, "trap_overflow": trap_overflow}
    key = cache.key(
        map(str, (path.resolve() for path in paths)),
        map(str, paths),
        map(str, (path.resolve() for path in include_paths)),
        map(str, include_paths),
        defines,
        undefines,
        standard,
        f"{flags} {dialect}",
        device_sources(),
    )
    entry = cache.load(key, _Entry)
    if entry is not None and _unchanged(entry):
        detail = _reload(entry, flags)
        known = load_executable(name, command_name(paths[0]), entry.machine_code, detail)
        if known is not None:
            diagnostics.messages.extend(entry.warnings)
            return known

    from crs_cc.frontend.dialect import dialect_of
    from crs_cc.session.library import library_options

    options = library_options(tuple(include_paths), tuple(defines), tuple(undefines), standard)
    own = Diagnostics(digests={str(path): digest(path) for path in paths})
    try:
        with without_collector():  # saves a fifth of the time
            options = replace(options, dialect=dialect or dialect_of(paths, options))
            executable = _compile(paths, options, own, name, flags)
            made = executable.detail()
            source = pickle.dumps((made.program, made.lines), pickle.HIGHEST_PROTOCOL)
    finally:
        diagnostics.messages.extend(own.messages)
        diagnostics.lines.update(own.lines)
    cache.store(key, _Entry(own.digests, executable.machine_code, source, tuple(own.messages)))
    return executable


def _compile(
    paths: Sequence[Path],
    options: Options,
    diagnostics: Diagnostics,
    name: str,
    flags: dict[str, bool],
) -> Executable:
    from crs_cc.frontend.unit import compile_file
    from crs_cc.ir.verify import verify
    from crs_cc.runtime.executable import make_executable
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
    files = {function.location.file for function in program.functions.values()}
    lines = {file: diagnostics.lines[file] for file in sorted(files & diagnostics.lines.keys())}
    return make_executable(program, name, command=command_name(paths[0]), lines=lines, **flags)


def build_watching(executable: Executable) -> Executable:
    """Return the watching build of a program, from the cache if possible.

    Both builds have the same debug information, see `codegen.watchpoints`; so this shares that of
    the other.

    Args:
        executable: its debug build.
    """
    name = cache.key("watching", executable.machine_code)
    entry = cache.load(name, bytes)
    names = executable.name, executable.command
    known = entry and load_executable(*names, entry, executable.detail)
    if known:
        return known

    from crs_cc.runtime.executable import make_executable

    old = executable.detail()
    with without_collector():
        made = make_executable(
            old.program,
            executable.name,
            command=executable.command,
            checked=old.compiled.checked,
            debug=True,
            watching=True,
            trap_overflow=old.compiled.trap_overflow,
        )
    cache.store(name, made.machine_code)
    return replace(made, detail=executable.detail)


def build_driver() -> Driver:
    """Return the module that runs a round of any fleet, from the cache if possible."""
    name = cache.key("driver")
    entry = cache.load(name, bytes)
    known = entry and load_module(entry)
    if known:
        return known
    made = compile_driver()
    cache.store(name, bytes(made.serialize()))
    return made


def _unchanged(entry: _Entry) -> bool:
    return all(digest(Path(file)) == known for file, known in entry.digests.items())


def _reload(entry: _Entry, flags: dict[str, bool]) -> Callable[[], Detail]:
    """Return a function that builds a cached program's detail on first use."""

    @functools.cache
    def detail() -> Detail:
        from crs_cc.runtime.codegen.module import compile_program

        program, lines = pickle.loads(entry.source)  # noqa: S301 - see `crs_cc.session.cache`
        return Detail(program, compile_program(program, **flags), lines)

    return detail
