"""A linked program as one WebAssembly module.

The module imports the mailbox, the memory in which the slots of all robots lie, and nothing else.
It exports its own memory, and `resume(slot) -> status`, which starts the program or lets it go on:
the address of the robot's slot comes in, the fuel is taken from the slot and what is left of it
is written back.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from crs_cc.errors import CompileError
from crs_cc.ir.program import Data, Program
from crs_cc.requests import FAILED, slot_offset
from crs_cc.runtime import jumps
from crs_cc.runtime.function_code import FunctionInfo, generate
from crs_cc.runtime.layout import HEADER_SIZE, MEMORY_BYTES, NULL_SIZE, STACK_TOP, round_up
from crs_cc.runtime.link import HEAP_SYMBOLS, ROOT, pointed_functions
from crs_cc.runtime.selection import MAILBOX, SLOT_GLOBAL, Names
from crs_cc.runtime.sites import CallSite, Site
from crs_cc.runtime.wasm import PAGE, TYPE_I32_I32, Code, FuncType, Module

HELPERS: Final = 2  # `fault` and `outside` come first in every module
_TWO_I32: Final[FuncType] = (("i32", "i32"), ("i32",))


@dataclass(slots=True)
class Compiled:
    """A module and what is needed to read a robot's memory.

    Attributes:
        module: the WebAssembly module.
        sites: every place that can fail, by the number in the slot's `error_site`.
        call_sites: every place that calls, by its number less 1; see `sites`.
        functions: the functions in the order of the numbers in their frames.
        addresses: address of each global object and function pointer of each function.
    """

    module: Module
    sites: list[Site]
    call_sites: list[CallSite]
    functions: list[FunctionInfo]
    addresses: dict[str, int]

    def info(self, function: str) -> FunctionInfo:
        """Gives how the frames of a function look."""
        return next(each for each in self.functions if each.function.name == function)


def compile_program(program: Program, *, checked: bool = True, debug: bool = False) -> Compiled:
    """Generates the code of a linked and verified program.

    Args:
        program: the program; it must define `__crs_start`.
        checked: test every access through a pointer.
        debug: make every statement a place to stop at.

    Raises:
        CompileError: the program's objects do not fit into a robot's memory.
    """
    addresses = _place(program)
    pointers = pointed_functions(program)
    addresses.update((name, number) for number, name in enumerate(pointers, start=1))
    numbers = {name: number for number, name in enumerate(program.functions, start=HELPERS)}
    sizes = {data.name: data.size for data in program.data.values()}
    names = Names(addresses, numbers, sizes, len(pointers))
    module = Module(
        functions=[_fault(), _outside()],
        memory_imports=[("crs", "mailbox")],
        memory_pages=MEMORY_BYTES // PAGE,
        tables=[len(pointers) + 1],
        globals=[("i32", 0), *jumps.GLOBALS],
        elements=[(0, 1, [numbers[name] for name in pointers])] if pointers else [],
    )
    infos = []
    for function in program.functions.values():
        code, info = generate(function, names, checked=checked, debug=debug)
        module.functions.append(code)
        infos.append(info)
    module.functions.append(_resume(numbers[ROOT]))
    module.data = [
        (1, addresses[data.name], _content(data, addresses))
        for data in program.data.values()
        if (data.content and any(data.content)) or data.relocations
    ]
    module.exports = [
        ("memory", "memory", 1),
        ("resume", "func", len(module.functions) - 1),
    ]
    return Compiled(module, names.sites, names.call_sites, infos, addresses)


def _place(program: Program) -> dict[str, int]:
    """Gives every object its address, behind the stack; the heap takes the rest."""
    addresses: dict[str, int] = {}
    end = STACK_TOP
    for data in program.data.values():
        end = round_up(end, max(1, data.align))
        addresses[data.name] = end
        end += max(1, data.size)
        if end > MEMORY_BYTES:
            raise CompileError.at(
                data.location,
                f"'{data.name}' does not fit: {data.size} bytes of {MEMORY_BYTES - STACK_TOP}",
                "a robot's memory is limited; use a smaller array",
                "linking",
            )
    heap = round_up(end, 16)
    addresses.update(zip(HEAP_SYMBOLS, (heap, MEMORY_BYTES), strict=True))
    return addresses


def _content(data: Data, addresses: dict[str, int]) -> bytes:
    """Gives an object's initial bytes with the addresses filled in."""
    content = bytearray(data.content or bytes(data.size))
    for relocation in data.relocations:
        value = addresses[relocation.symbol] + relocation.addend
        at = relocation.offset
        content[at : at + 4] = (value % 2**32).to_bytes(4, "little")
    return bytes(content)


def _fault() -> Code:
    """`fault(site, value) -> FAILED`: notes in the slot what went wrong where."""
    body = [
        ("global.get", SLOT_GLOBAL), ("local.get", 0),
        ("i32.store", MAILBOX, slot_offset("error_site")),
        ("global.get", SLOT_GLOBAL), ("local.get", 1),
        ("i32.store", MAILBOX, slot_offset("error_address")),
        ("i32.const", FAILED),
    ]  # fmt: skip
    return Code("fault", _TWO_I32, [], body)


def _outside() -> Code:
    """`outside(address, size)`: whether some of the bytes lie outside the accessible memory."""
    body = [
        ("local.get", 1), ("i32.eqz",), ("if",), ("i32.const", 0), ("return",), ("end",),
        ("local.get", 1), ("i32.const", MEMORY_BYTES - NULL_SIZE), ("i32.gt_u",),
        ("if",), ("i32.const", 1), ("return",), ("end",),
        ("local.get", 0), ("i32.const", NULL_SIZE), ("i32.sub",),
        ("i32.const", MEMORY_BYTES - NULL_SIZE), ("local.get", 1), ("i32.sub",), ("i32.gt_u",),
    ]  # fmt: skip
    return Code("outside", _TWO_I32, [], body)


def _resume(root: int) -> Code:
    """`resume(slot) -> status`."""
    fuel = slot_offset("fuel")
    body = [
        ("local.get", 0), ("global.set", SLOT_GLOBAL),
        ("local.get", 0), ("i64.load", MAILBOX, fuel), ("local.set", 1),
        *jumps.call_root(root, STACK_TOP - HEADER_SIZE, fuel=1, status=2),
        ("local.get", 0), ("local.get", 1), ("i64.store", MAILBOX, fuel),
        ("local.get", 2),
    ]  # fmt: skip
    return Code("resume", TYPE_I32_I32, ["i64", "i32"], body)
