"""The C library for the linker: each unit is compiled on first use, and cached.

`runtime/lib/index.txt` lists the unit that defines each name, so that only the units that a program
uses are compiled. A test compares it to the sources, and updates it with `--update-goldens`.
"""

from __future__ import annotations

import functools
from collections.abc import Sequence
from pathlib import Path

from crs_cc.core.errors import CompileError, InternalError
from crs_cc.core.source import Diagnostics, Location
from crs_cc.frontend.preprocess.options import Options
from crs_cc.frontend.unit import compile_text
from crs_cc.ir.names import LIBRARY
from crs_cc.ir.program import Data, Function, Program
from crs_cc.ir.verify import verify
from crs_cc.runtime import link
from crs_cc.session import cache
from crs_cc.session.device_library import (
    defines,
    device_headers,
    device_sources,
    source,
    units,
)

SOURCES = Path(link.__file__).parent / "lib"
HEADERS = SOURCES / "include"


def library_options(
    include_paths: tuple[Path, ...] = (),
    defines: tuple[str, ...] = (),
    undefines: tuple[str, ...] = (),
    standard: str = "gnu17",
) -> Options:
    """Return the options of a program that uses the library's headers; see `Options`."""
    return Options(
        include_paths, (HEADERS,), defines, undefines, standard, generated=device_headers()
    )


class CachedLibrary:
    """The library's units, each loaded when one of its names is looked up.

    Raises:
        InternalError: the library itself does not compile.
    """

    def __init__(self) -> None:
        self._units: dict[str, Program] = {}
        self._index: dict[str, str] = {}  # name to unit
        for line in (SOURCES / "index.txt").read_text("utf-8").splitlines():
            unit, _, names = line.partition(":")
            self._index |= dict.fromkeys(names.split(), unit)
        for unit, device in units().items():
            self._index |= dict.fromkeys((each.name for each in device.functions), unit)
        self._known = frozenset(self._index.values())

    def find(self, name: str) -> Function | Data | None:
        """Return the library's definition of a name; static names are prefixed by the unit's."""
        own, colon, _ = name.removeprefix(LIBRARY).partition(":")
        unit = own if colon and name.startswith(LIBRARY) else self._index.get(name)
        if unit is None or unit not in self._known:
            return None
        if unit not in self._units:
            self._units[unit] = _load(unit)
        found = self._units[unit]
        return found.functions.get(name) or found.data.get(name)

    def names(self) -> Sequence[str]:
        """Return the public names."""
        return [name for name in self._index if not name.startswith("__")]


@functools.cache
def library() -> CachedLibrary:
    """Return the library of this process."""
    return CachedLibrary()


def index_of_sources() -> str:
    """Return the contents of `index.txt`: a line for each unit, with the names that it defines.

    Raises:
        InternalError: the library does not compile, or defines a name twice.
    """
    lines, known = [], dict[str, str]()
    for path in sorted(SOURCES.rglob("*.c")):
        unit = path.relative_to(SOURCES).as_posix()
        program = _compile(unit)
        names = [name for name in (*program.functions, *program.data) if ":" not in name]
        for name in names:
            if name in known:
                text = f"the library defines '{name}' in {known[name]} and {unit}"
                raise InternalError.at(Location(unit), text)
            known[name] = unit
        lines.append(f"{unit}: {' '.join(names)}\n")
    return "".join(lines)


def _load(unit: str) -> Program:
    """Load a unit from the cache, or compile and cache it."""
    entry = cache.key("library", unit, device_sources() if unit in units() else "")
    program = cache.load(entry, Program)
    if program is None:
        program = _compile(unit)
        cache.store(entry, program)
    return program


def _compile(unit: str) -> Program:
    device, name = units().get(unit), LIBRARY + unit
    path = SOURCES / unit
    diagnostics = Diagnostics()
    try:
        options = Options(
            system_paths=(HEADERS, path.parent),
            generated=device_headers(),
            defines=defines(device) if device else (),
            trusted=name == link.ALLOCATOR,
        )
        text = source(device) if device else path.read_text("utf-8")
        program = compile_text(text, name, options, diagnostics)
    except CompileError as error:
        raise InternalError(error.diagnostics) from error
    verify(program)
    return program
