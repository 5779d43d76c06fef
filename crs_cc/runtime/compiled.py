"""A compiled program: its module and its debug information."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from crs_cc.core.source import Location
from crs_cc.ir.instruction import Register, Variable
from crs_cc.ir.program import Function
from crs_cc.runtime.layout import Frame
from crs_cc.runtime.sites import CallSite, Site, StatementSite
from crs_cc.runtime.wasm import Module


@dataclass(slots=True)
class FunctionInfo:
    """Debug information of a function, for reading the frames of a stopped program.

    Attributes:
        function: the IR function.
        frame: the layout of its registers and slots.
        landings: the source location of each landing, by number; 0 is the entry.
        callees: for landings at calls, by the landing's number, the callee: its name, or the
            register that holds the function pointer.
        flags: for registers that may be uninitialised, the flag register: not zero if initialised.
        unset: in debug builds, by the landing's number, the variables uninitialised there.
    """

    function: Function
    frame: Frame
    landings: dict[int, Location]
    callees: dict[int, str | Register]
    flags: dict[Register, Register] = field(default_factory=dict)
    unset: dict[int, frozenset[Register]] = field(default_factory=dict)


@dataclass(slots=True)
class Compiled:
    """A module and the debug information for reading a robot's memory.

    Attributes:
        module: the WebAssembly module.
        sites: every site that can fail, by the number in the slot's `error_site`.
        call_sites: every call site of a checked build, by its number minus 1; see `runtime.sites`.
        call_landings: the landing of each of these calls in its function.
        statements: the sites at which the program can be stopped, by number: statements, and
            returns from calls.
        functions: the functions, by the numbers in their frames.
        addresses: address of each global object and function pointer of each function.
        first_function: index in the module of the first function of the program.
        checked: whether accesses are checked.
        trap_overflow: whether it stops at signed overflow.
        origins: the variables that bytes without value come from, see `codegen.origins`.
    """

    module: Module
    first_function: int
    sites: list[Site]
    call_sites: list[CallSite]
    call_landings: list[int]
    statements: list[StatementSite]
    functions: list[FunctionInfo]
    addresses: dict[str, int]
    checked: bool = True
    trap_overflow: bool = False
    origins: list[Variable] = field(default_factory=list)
    _numbers: dict[str, int] = field(default_factory=dict, repr=False)

    @property
    def numbers(self) -> dict[str, int]:
        """The number of each function among `functions`."""
        if not self._numbers:
            self._numbers.update(
                (info.function.name, number) for number, info in enumerate(self.functions)
            )
        return self._numbers

    def breakable(self) -> Iterator[tuple[int, StatementSite]]:
        """Return the statements on which breakpoints can be set, with their numbers."""
        return ((n, site) for n, site in enumerate(self.statements) if not site.after_call)

    def call_landing(self, function: str, number: int) -> int:
        """Return the landing of a call by the number of its site; 0 if the function has none."""
        is_site = 0 < number <= len(self.call_sites)
        if not is_site or self.call_sites[number - 1].function != function:
            return 0
        return self.call_landings[number - 1]

    def info(self, function: str) -> FunctionInfo:
        """Return the debug information of a function."""
        return self.functions[self.numbers[function]]
