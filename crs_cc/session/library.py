"""The C library as the linker sees it: compiled once, kept in the cache, loaded by need."""

from __future__ import annotations

import functools
from collections.abc import Sequence
from pathlib import Path

from crs_cc.errors import CompileError, InternalError
from crs_cc.frontend.options import Options
from crs_cc.frontend.unit import compile_text
from crs_cc.ir.program import Data, Function, Program
from crs_cc.ir.verify import verify
from crs_cc.runtime import link
from crs_cc.runtime.heap import ALLOCATOR
from crs_cc.session import cache
from crs_cc.source import Diagnostics, Location

SOURCES = Path(link.__file__).parent / "lib"
HEADERS = SOURCES / "include"


class CachedLibrary:
    """The library's units, each loaded when one of its names is looked for.

    Raises:
        InternalError: the library itself does not compile, or defines a name twice.
    """

    def __init__(self) -> None:
        self._units: dict[str, Program] = {}
        self._index: dict[str, str] = cache.load(_entry("index"), dict) or self._compile_all()

    def find(self, name: str) -> Function | Data | None:
        """Gives the library's definition of a name."""
        unit = self._index.get(name)
        if unit is None:
            return None
        if unit not in self._units:
            known = cache.load(_entry(unit), Program)
            self._units[unit] = _compile(SOURCES / unit) if known is None else known
        found = self._units[unit]
        return found.functions.get(name) or found.data.get(name)

    def names(self) -> Sequence[str]:
        """Gives the names that programs can use."""
        return [name for name in self._index if ":" not in name and not name.startswith("__")]

    def _compile_all(self) -> dict[str, str]:
        index: dict[str, str] = {}
        for path in sorted(SOURCES.rglob("*.c")):
            unit = path.relative_to(SOURCES).as_posix()
            program = _compile(path)
            self._units[unit] = program
            cache.store(_entry(unit), program)
            for name in (*program.functions, *program.data):
                if name in index:
                    text = f"the library defines '{name}' in {index[name]} and {unit}"
                    raise InternalError.at(Location(unit), text)
                index[name] = unit
        cache.store(_entry("index"), index)
        return index


@functools.cache
def library() -> CachedLibrary:
    """Gives the library of this process."""
    return CachedLibrary()


def _entry(unit: str) -> str:
    return cache.key("library", unit)


def _compile(path: Path) -> Program:
    diagnostics = Diagnostics()
    try:
        name = link.LIBRARY + path.relative_to(SOURCES).as_posix()
        trusted = name == ALLOCATOR
        options = Options(system_paths=(HEADERS, path.parent), trusted=trusted)
        program = compile_text(path.read_text(), name, options, diagnostics)
    except CompileError as error:
        raise InternalError(error.diagnostics) from error
    verify(program)
    return program
