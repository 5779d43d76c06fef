"""What the names in a program stand for, and the numbers of the places in its code."""

from __future__ import annotations

from dataclasses import dataclass, field

from crs_cc.runtime.codegen.signatures import Shape
from crs_cc.runtime.sites import CallSite, Site, StatementSite


@dataclass(slots=True)
class Names:
    """What names stand for in the whole program.

    Attributes:
        addresses: address of each global object; function pointer of each function that needs one.
        functions: index in the module of each function.
        sizes: size of each global object.
        parameters: size of the parameters of each function, as `layout` places them.
        tables: addresses of the tables that `signatures` makes.
        without_value: functions that may end without a value which somebody uses.
        pointers: how many function pointers there are; they are numbered from 1.
        sites: every place that can fail.
        call_sites: every place that calls, by its number less 1.
        statements: the statements before which a debugger can stop.
        accesses: how many instructions have a number, see `watching.accesses`.
    """

    addresses: dict[str, int]
    functions: dict[str, int]
    sizes: dict[str, int]
    parameters: dict[str, int]
    pointers: int
    tables: dict[Shape, int]
    without_value: set[str]
    sites: list[Site] = field(default_factory=list)
    call_sites: list[CallSite] = field(default_factory=list)
    statements: list[StatementSite] = field(default_factory=list)
    accesses: int = 0

    def number(self, site: Site) -> int:
        """Enter a place that can fail; gives its number."""
        self.sites.append(site)
        return len(self.sites) - 1

    def call_number(self, site: CallSite) -> int:
        """Enter a place that calls; gives its number."""
        self.call_sites.append(site)
        return len(self.call_sites)

    def statement_number(self, site: StatementSite) -> int:
        """Enter a statement; gives its number."""
        self.statements.append(site)
        return len(self.statements) - 1
