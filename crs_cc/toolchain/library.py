"""The C library for the linker: each unit is compiled on first use, and cached.

`runtime/lib/index.txt` lists the unit that defines each name, so that only the units that a program
uses are compiled. A test compares it to the sources, and updates it with `--update-goldens`. What
is not in this package, such as the functions of devices, is added by the caller.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from crs_cc.core.errors import CompileError, InternalError
from crs_cc.core.source import Diagnostics, Location
from crs_cc.frontend.preprocess.options import Options
from crs_cc.frontend.unit import compile_text
from crs_cc.ir.names import LIBRARY
from crs_cc.ir.program import Data, Function, Program
from crs_cc.ir.verify import verify
from crs_cc.runtime import link
from crs_cc.toolchain import cache

SOURCES = Path(link.__file__).parent / "lib"
HEADERS = SOURCES / "include"


@dataclass(frozen=True, slots=True)
class AddedUnit:
    """A unit that is not in the library's folder.

    Attributes:
        text: its C source.
        names: the public names that it defines.
        defines: macros that it is compiled with.
        state: everything that its code depends on, for the cache.
    """

    text: str
    names: tuple[str, ...]
    defines: tuple[str, ...]
    state: str


class CachedLibrary:
    """The library's units, each loaded when one of its names is looked up.

    Raises:
        InternalError: the library itself does not compile.
    """

    def __init__(
        self,
        headers: tuple[tuple[str, str], ...] = (),
        added: Mapping[str, AddedUnit] | None = None,
    ) -> None:
        """Read the index.

        Args:
            headers: name and text of headers that are in no folder.
            added: units that are in no folder, by name.
        """
        self._headers, self._added = headers, added or {}
        self._units: dict[str, Program] = {}
        self._index: dict[str, str] = {}  # name to unit
        for line in (SOURCES / "index.txt").read_text("utf-8").splitlines():
            unit, _, names = line.partition(":")
            self._index |= dict.fromkeys(names.split(), unit)
        for unit, each in self._added.items():
            self._index |= dict.fromkeys(each.names, unit)
        self._known = frozenset(self._index.values())

    def find(self, name: str) -> Function | Data | None:
        """Return the library's definition of a name; static names are prefixed by the unit's."""
        own, colon, _ = name.removeprefix(LIBRARY).partition(":")
        unit = own if colon and name.startswith(LIBRARY) else self._index.get(name)
        if unit is None or unit not in self._known:
            return None
        if unit not in self._units:
            self._units[unit] = _unit(unit, self._headers, self._added.get(unit))
        found = self._units[unit]
        return found.functions.get(name) or found.data.get(name)

    def names(self) -> Sequence[str]:
        """Return the public names."""
        return [name for name in self._index if not name.startswith("__")]


def index_of_sources(headers: tuple[tuple[str, str], ...]) -> str:
    """Return the contents of `index.txt`: a line for each unit, with the names that it defines.

    Args:
        headers: name and text of headers that are in no folder.

    Raises:
        InternalError: the library does not compile, or defines a name twice.
    """
    lines, known = [], dict[str, str]()
    for path in sorted(SOURCES.rglob("*.c")):
        unit = path.relative_to(SOURCES).as_posix()
        program = _unit(unit, headers, None)
        names = [name for name in (*program.functions, *program.data) if ":" not in name]
        for name in names:
            if name in known:
                text = f"the library defines '{name}' in {known[name]} and {unit}"
                raise InternalError.at(Location(unit), text)
            known[name] = unit
        lines.append(f"{unit}: {' '.join(names)}\n")
    return "".join(lines)


def _unit(unit: str, headers: tuple[tuple[str, str], ...], added: AddedUnit | None) -> Program:
    """Load a unit from the cache, or compile and cache it."""
    texts = (text for header in headers for text in header)
    entry = cache.key("library", unit, texts, added.state if added else "")
    program = cache.load(entry, Program)
    if program is None:
        program = _compile(unit, headers, added)
        cache.store(entry, program)
    return program


def _compile(unit: str, headers: tuple[tuple[str, str], ...], added: AddedUnit | None) -> Program:
    path, name = SOURCES / unit, LIBRARY + unit
    options = Options(
        system_paths=(HEADERS, path.parent),
        generated=headers,
        defines=added.defines if added else (),
        trusted=name == link.ALLOCATOR,
    )
    return compile_bundled(added.text if added else path.read_text("utf-8"), name, options)


def compile_bundled(text: str, name: str, options: Options) -> Program:
    """Compile and verify a C file of this package; raise InternalError if it does not compile."""
    try:
        program = compile_text(text, name, options, Diagnostics())
    except CompileError as error:
        raise InternalError(error.diagnostics) from error
    verify(program)
    return program
