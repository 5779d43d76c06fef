"""The symbols of a program, and the numbers of its sites."""

from __future__ import annotations

from dataclasses import dataclass, field

from crs_cc.core.source import Location
from crs_cc.ir.instruction import Variable
from crs_cc.runtime.codegen.convention import Convention
from crs_cc.runtime.codegen.signatures import Shape
from crs_cc.runtime.codegen.small_functions import Bodies
from crs_cc.runtime.sites import CallSite, Site, StatementSite
from crs_cc.runtime.wasm import Code


@dataclass(slots=True)
class Symbols:
    """The symbols and sites of the whole program.

    Attributes:
        addresses: address of each global object; function pointer of each function that needs one.
        functions: index in the module of each function.
        general: index of the general form of each function that has one, see `convention`.
        conventions: how each function is called.
        sizes: size of each global object.
        constants: 1 for each global object that must not be written, else 0.
        tables: addresses of the tables that `signatures` makes.
        bodies: the functions that can be inlined, and the small ones.
        without_value: functions that may end without a value although it is used.
        pointers: number of function pointers, which are numbered from 1.
        keeps_sizes: whether blocks of the heap are preceded by their sizes, as the library has it.
        sites: every site that can fail.
        call_sites: every call site, by its number minus 1.
        call_landings: the landing of each of these calls in its function.
        statements: the statements on which breakpoints can be set.
        origins: the variables that bytes without value come from, see `origins`.
        accesses: number of numbered accesses, see `watchpoints.accesses`.
        first_outlined: index in the module of the first of the outlined functions.
        outlined: functions that resume others.
    """

    addresses: dict[str, int]
    functions: dict[str, int]
    general: dict[str, int]
    conventions: dict[str, Convention]
    sizes: dict[str, int]
    constants: dict[str, int]
    pointers: int
    tables: dict[Shape, int]
    without_value: set[str]
    bodies: Bodies
    keeps_sizes: bool = False
    sites: list[Site] = field(default_factory=list)
    call_sites: list[CallSite] = field(default_factory=list)
    call_landings: list[int] = field(default_factory=list)
    statements: list[StatementSite] = field(default_factory=list)
    origins: list[Variable] = field(default_factory=list)
    accesses: int = 0
    first_outlined: int = 0
    outlined: list[Code] = field(default_factory=list)
    _origin_numbers: dict[tuple[str, Location], int] = field(default_factory=dict)

    @property
    def next_outlined(self) -> int:
        """The index in the module of the outlined function that comes next."""
        return self.first_outlined + len(self.outlined)

    def number(self, site: Site) -> int:
        """Add a site that can fail, and return its number."""
        self.sites.append(site)
        return len(self.sites) - 1

    def call_number(self, site: CallSite) -> int:
        """Add a call site, and return its number."""
        self.call_sites.append(site)
        return len(self.call_sites)

    def origin_number(self, variable: Variable) -> int:
        """Return the number of a variable that bytes without value come from."""
        key = variable.name, variable.location
        if key not in self._origin_numbers:
            self._origin_numbers[key] = len(self.origins)
            self.origins.append(variable)
        return self._origin_numbers[key]

    def statement_number(self, site: StatementSite) -> int:
        """Add a site to stop at, and return its number."""
        self.statements.append(site)
        return len(self.statements) - 1
