"""A compiled program: its module, and what finds functions, variables and places in its memory."""

from __future__ import annotations

from dataclasses import dataclass, field

from crs_cc.core.source import Location
from crs_cc.ir.program import Function, Register
from crs_cc.runtime.layout import Frame
from crs_cc.runtime.sites import CallSite, Site, StatementSite
from crs_cc.runtime.wasm import Module


@dataclass(slots=True)
class FunctionInfo:
    """What a debugger needs to read a stopped function's frame.

    Attributes:
        function: the IR function.
        frame: where its registers and slots lie.
        landings: where in the source each landing is, by its number; the entry for 0.
        callees: for landings at calls, by the landing's number, the callee: its name, or the
            register that holds the function pointer.
        calls: the landing of each call, by the number of its call site (checked builds only).
        flags: for registers that may have no value, the register that tells: not zero if one does.
        unset: in debug builds, by the landing's number, the variables that have no value there.
    """

    function: Function
    frame: Frame
    landings: dict[int, Location]
    callees: dict[int, str | Register]
    calls: dict[int, int]
    flags: dict[Register, Register] = field(default_factory=dict)
    unset: dict[int, frozenset[Register]] = field(default_factory=dict)


@dataclass(slots=True)
class Compiled:
    """A module and what is needed to read a robot's memory.

    Attributes:
        module: the WebAssembly module.
        sites: every place that can fail, by the number in the slot's `error_site`.
        call_sites: every place that calls, by its number less 1; see `sites`.
        statements: the statements before which a debugger can stop, by their numbers.
        functions: the functions in the order of the numbers in their frames.
        addresses: address of each global object and function pointer of each function.
        first_function: index in the module of the first function of the program.
        checked: whether accesses are tested.
        trap_overflow: whether it stops at signed overflow.
    """

    module: Module
    first_function: int
    sites: list[Site]
    call_sites: list[CallSite]
    statements: list[StatementSite]
    functions: list[FunctionInfo]
    addresses: dict[str, int]
    checked: bool = True
    trap_overflow: bool = False
    _numbers: dict[str, int] = field(default_factory=dict, repr=False)

    @property
    def numbers(self) -> dict[str, int]:
        """The number of each function among `functions`."""
        if not self._numbers:
            self._numbers.update(
                (info.function.name, number) for number, info in enumerate(self.functions)
            )
        return self._numbers

    def info(self, function: str) -> FunctionInfo:
        """Return what is known of a function."""
        return self.functions[self.numbers[function]]
