"""A linked program as one WebAssembly module.

The module imports the mailbox, the memory in which the slots of all robots lie, and nothing else.
It exports its own memory, and `resume(slot) -> status`, which starts or resumes the program:
its argument is the address of the robot's slot; the fuel is read from the slot and what remains
is written back. `prefetch(slot) -> number` loads the memory that this touches first, see `driver`.
The global `heap` is the end of the program's own objects.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from typing import Final

from crs_cc.ir.instruction import ByteState
from crs_cc.ir.names import in_library
from crs_cc.ir.pointer_bases import ALLOCATORS
from crs_cc.ir.program import Data, Program
from crs_cc.requests import slot_offset
from crs_cc.runtime.codegen import (
    frame_states,
    jumps,
    large_functions,
    origins,
    same_object,
    shadow,
)
from crs_cc.runtime.codegen.build import Build
from crs_cc.runtime.codegen.checked_arithmetic import product_fits
from crs_cc.runtime.codegen.convention import (
    Convention,
    convention_of,
    general_form,
    needing_general_form,
)
from crs_cc.runtime.codegen.function_code import generate
from crs_cc.runtime.codegen.indices import (
    BEGUN_GLOBAL,
    MAILBOX,
    MARKS_GLOBAL,
    MEMORY,
    SHADOW,
    SLOT_GLOBAL,
)
from crs_cc.runtime.codegen.library_code import generate_shared
from crs_cc.runtime.codegen.signatures import Shape, pointer_tables, valueless_functions
from crs_cc.runtime.codegen.small_functions import Bodies, small_functions
from crs_cc.runtime.codegen.stop_marks import add_marks
from crs_cc.runtime.codegen.symbols import Symbols
from crs_cc.runtime.codegen.watchpoints import update_bounds, watch
from crs_cc.runtime.compiled import Compiled, FunctionInfo
from crs_cc.runtime.layout import (
    HEADER_SIZE,
    MEMORY_BYTES,
    NULL_SIZE,
    STACK_TOP,
    does_not_fit,
    red_zone,
    round_up,
)
from crs_cc.runtime.link import HEAP_SYMBOLS, ROOT, address_taken_functions
from crs_cc.runtime.wasm import PAGE, TYPE_I32_I32, Code, FuncType, Instr, Module

_TWO_I32: Final[FuncType] = (("i32", "i32"), ("i32",))

_STACK_LINES: Final = 4
"""Cache lines at the top of the stack that are prefetched; more bring nothing."""

SMALL: Final = 1024
"""The states of smaller objects are initialised by a data segment, those of larger ones by code."""


def compile_program(
    program: Program,
    *,
    checked: bool = True,
    debug: bool = False,
    watching: bool = False,
    trap_overflow: bool = False,
) -> Compiled:
    """Generate the code of a linked and verified program.

    Args:
        program: the program; it must define `__crs_start`.
        checked: check every access through a pointer.
        debug: allow breakpoints on every statement.
        watching: compare every access with the watched ranges; in debug builds only.
        trap_overflow: stop at signed overflow; in checked builds only.

    Raises:
        CompileError: the program's objects do not fit into a robot's memory.
    """
    pointers = address_taken_functions(program)
    own = _checks() if checked else [_outside()]
    names = _symbols(program, pointers, len(own), checked=checked, trap_overflow=trap_overflow)
    addresses = names.addresses
    tables = pointer_tables(program, pointers) if checked else {}
    _place_tables(tables, names)
    build = Build(checked, debug, names.first_outlined + 1 if watching else 0, trap_overflow)
    module = _module(own, [names.general[name] for name in pointers], addresses, build)
    infos = _add_program(module, program, names, build)
    _add_exported(module, names, build)
    module.data = [
        (MEMORY, addresses[data.name], _content(data, addresses))
        for data in program.data.values()
        if (data.content and any(data.content)) or data.relocations
    ]
    module.data += [(MEMORY, names.tables[shape], table) for shape, table in tables.items()]
    if checked:
        _add_start(module, program, addresses)
    if debug:
        add_marks(module, names.statements)
    return Compiled(
        module,
        first_function=len(own),
        sites=names.sites,
        call_sites=names.call_sites,
        call_landings=names.call_landings,
        statements=names.statements,
        functions=infos,
        addresses=addresses,
        checked=checked,
        trap_overflow=trap_overflow,
        origins=names.origins,
    )


def check_program(program: Program) -> None:
    """Check what only generating the code of a linked and verified program shows.

    The code of library functions is not generated: they fit.

    Raises:
        CompileError: the program's objects do not fit into a robot's memory, or a local variable
            needs a stricter alignment than frames have.
    """
    pointers, build = address_taken_functions(program), Build(True, False, 0, False)
    names = _symbols(program, pointers, 0, checked=build.checked, trap_overflow=build.trap_overflow)
    _place_tables(pointer_tables(program, pointers), names)
    for function in program.functions.values():
        if not in_library(function.location):
            generate(function, names, build)


def _symbols(
    program: Program, pointers: list[str], first: int, *, checked: bool, trap_overflow: bool
) -> Symbols:
    """Return the symbols of a program.

    Args:
        program: the program.
        pointers: the functions that pointers stand for.
        first: the index in the module of its first function.
        checked: whether accesses are checked.
        trap_overflow: whether it stops at signed overflow.

    Raises:
        CompileError: its objects do not fit into a robot's memory.
    """
    functions, data = program.functions, program.data.values()
    addresses = _place(program)
    addresses.update((name, number) for number, name in enumerate(pointers, start=1))
    numbers = {name: number for number, name in enumerate(functions, start=first)}
    conventions = {name: convention_of(each) for name, each in functions.items()}
    general = _general_forms(program, pointers, numbers, conventions)
    made = sum(number != numbers[name] for name, number in general.items())
    return Symbols(
        addresses=addresses,
        functions=numbers,
        general=general,
        conventions=conventions,
        sizes={each.name: each.size for each in data},
        constants={each.name: int(each.is_constant) for each in data},
        pointers=len(pointers),
        tables={},
        without_value=valueless_functions(program, pointers) if checked else set(),
        bodies=Bodies(small_functions(functions), checked=checked, traps_overflow=trap_overflow),
        keeps_sizes=_keeps_sizes(program),
        first_outlined=first + len(functions) + made,
    )


def _place_tables(tables: Mapping[Shape, bytes], names: Symbols) -> None:
    """Assign addresses to the tables of pointers' shapes, before the heap."""
    heap, end = (names.addresses[name] for name in HEAP_SYMBOLS)
    for shape, table in tables.items():
        names.tables[shape] = heap
        heap = min(round_up(heap + len(table), 16), end)
    names.addresses[HEAP_SYMBOLS[0]] = heap


def _module(
    own: Sequence[Code], pointed: list[int], addresses: dict[str, int], build: Build
) -> Module:
    """Return a module that has nothing of the program yet.

    Args:
        own: the functions that every program has.
        pointed: the functions that pointers stand for.
        addresses: has the begin of the heap.
        build: how the program is compiled.
    """
    return Module(
        functions=list(own),
        memory_imports=[("crs", "mailbox")],
        memories=[MEMORY_BYTES // PAGE, *([shadow.PAGES] if build.checked else [])],
        tables=[len(pointed) + 1],
        globals=[
            ("i32", 0),
            ("i32", 0),
            ("i64", 0),
            ("i32", 0),
            ("i32", 0),
            ("i32", 0),
            *jumps.GLOBALS,
            *large_functions.GLOBALS,
            *same_object.GLOBALS,
            ("i32", addresses[HEAP_SYMBOLS[0]]),
        ],
        elements=[(0, 1, pointed)] if pointed else [],
    )


def _add_program(
    module: Module, program: Program, names: Symbols, build: Build
) -> list[FunctionInfo]:
    """Add the program's functions, and their general forms; return the debug information."""
    infos = []
    for function in program.functions.values():
        code, info = generate_shared(function, names, build)
        module.functions.append(code)
        infos.append(info)
    for name, number in names.general.items():
        own_form = names.functions[name]
        if number != own_form:
            sizes = [each.size for each in program.functions[name].parameters]
            form = general_form(name, own_form, names.conventions[name], sizes)
            module.functions.append(form)
    module.functions += names.outlined
    return infos


def _add_exported(module: Module, names: Symbols, build: Build) -> None:
    """Add the functions that are called from outside, and all exports."""
    statements, marks = len(names.statements), SHADOW + build.checked
    begin = update_bounds(marks, statements) if build.watch else []
    resume = len(module.functions)
    module.functions.append(
        _resume(names.general[ROOT], statements, [*begin, *same_object.forget_all()])
    )
    if build.watch:
        module.functions.append(watch(marks, statements, checked=build.checked))
    module.functions.append(_prefetch(checked=build.checked))
    module.exports = [
        ("memory", "memory", MEMORY),
        ("resume", "func", resume),
        ("prefetch", "func", len(module.functions) - 1),
        ("heap", "global", len(module.globals) - 1),
    ]
    if build.checked:
        module.exports.append(("shadow", "memory", SHADOW))


def _checks() -> list[Code]:
    """Return the functions that checked code calls, in the order of their `indices`."""
    return [
        shadow.inaccessible(), shadow.callers(), product_fits(), shadow.unsealed(),
        same_object.gap(), same_object.unrelated(), frame_states.passed(), origins.unset(),
    ]  # fmt: skip


def _keeps_sizes(program: Program) -> bool:
    """Return whether all allocators are the library's."""
    return all(program.functions[name].trusted for name in ALLOCATORS & program.functions.keys())


def _place(program: Program) -> dict[str, int]:
    """Assign an address after the stack to every object; the heap is the rest.

    Addresses do not depend on whether the build is checked, nor must a program's behaviour.
    """
    addresses: dict[str, int] = {}
    end = STACK_TOP + red_zone(0)
    for data in program.data.values():
        end = round_up(end, max(1, data.align))
        addresses[data.name] = end
        end += max(1, data.size) + red_zone(data.size)
        if end > MEMORY_BYTES:
            raise does_not_fit(data)
    heap = round_up(end, 16)
    addresses.update(zip(HEAP_SYMBOLS, (heap, MEMORY_BYTES), strict=True))
    return addresses


def _general_forms(
    program: Program,
    pointers: list[str],
    numbers: dict[str, int],
    conventions: dict[str, Convention],
) -> dict[str, int]:
    """Return the index of the general form of each function that is called in it."""
    wanted = {ROOT, *pointers, *needing_general_form(program, conventions)}
    following = itertools.count(max(numbers.values()) + 1)
    return {
        name: number if conventions[name].is_general else next(following)
        for name, number in numbers.items()
        if name in wanted
    }


def _content(data: Data, addresses: dict[str, int]) -> bytes:
    """Return an object's initial bytes with addresses relocated."""
    content = bytearray(data.content or bytes(data.size))
    for relocation in data.relocations:
        value = addresses[relocation.symbol] + relocation.addend
        at = relocation.offset
        content[at : at + 4] = (value % 2**32).to_bytes(4, "little")
    return bytes(content)


def _add_start(module: Module, program: Program, addresses: dict[str, int]) -> None:
    """Return a function that initialises the shadow memory of all objects at instantiation."""
    body: list[Instr] = []
    run: list[Data] = []
    for data in [*program.data.values(), None]:
        if data is not None and data.size < SMALL:
            run.append(data)
            continue
        if run:
            body += _marks(module, run, addresses)
            run = []
        if data is not None:
            body += [("i32.const", addresses[data.name]), ("i32.const", _state(data))]
            body += [("i32.const", data.size), ("memory.fill", SHADOW)]
    module.start = len(module.functions)
    module.functions.append(Code("start", ((), ()), [], body))


def _marks(module: Module, run: list[Data], addresses: dict[str, int]) -> list[Instr]:
    """Add the states of some objects, and of the gaps between them, to the module's data."""
    start = addresses[run[0].name]
    states = bytearray()
    for data in run:
        states = states.ljust(addresses[data.name] - start, bytes([ByteState.INACCESSIBLE]))
        states += bytes([_state(data)]) * data.size
    segment = len(module.data)
    module.data.append((-1, 0, bytes(states)))
    code: list[Instr] = [("i32.const", start), ("i32.const", 0), ("i32.const", len(states))]
    return [*code, ("memory.init", segment, SHADOW)]


def _state(data: Data) -> ByteState:
    return ByteState.CONSTANT if data.is_constant else ByteState.WITH_VALUE


def _outside() -> Code:
    """`outside(address, size)`: whether some of the bytes are outside the accessible memory."""
    body = [
        ("local.get", 1), ("i32.eqz",), ("if",), ("i32.const", 0), ("return",), ("end",),
        ("local.get", 1), ("i32.const", MEMORY_BYTES - NULL_SIZE), ("i32.gt_u",),
        ("if",), ("i32.const", 1), ("return",), ("end",),
        ("local.get", 0), ("i32.const", NULL_SIZE), ("i32.sub",),
        ("i32.const", MEMORY_BYTES - NULL_SIZE), ("local.get", 1), ("i32.sub",), ("i32.gt_u",),
    ]  # fmt: skip
    return Code("outside", _TWO_I32, [], body)


def _resume(root: int, statements: int, begin: list[Instr]) -> Code:
    """`resume(slot) -> status`."""
    fuel, begun = slot_offset("fuel"), slot_offset("statements")
    body = [
        ("local.get", 0), ("global.set", SLOT_GLOBAL),
        ("local.get", 0), ("i64.load", MAILBOX, begun), ("global.set", BEGUN_GLOBAL),
        ("local.get", 0), ("i32.load", MAILBOX, slot_offset("stop_before_all")),
        ("i32.const", statements), ("i32.mul",), ("global.set", MARKS_GLOBAL),
        ("local.get", 0), ("i32.const", 0), ("i32.store", MAILBOX, slot_offset("stopped")),
        *begin,
        ("local.get", 0), ("i64.load", MAILBOX, fuel), ("local.set", 1),
        *jumps.call_root(root, STACK_TOP - HEADER_SIZE, status=2),
        ("local.get", 0), ("local.get", 1), ("i64.store", MAILBOX, fuel),
        ("local.get", 0), ("global.get", BEGUN_GLOBAL), ("i64.store", MAILBOX, begun),
        ("local.get", 2),
    ]  # fmt: skip
    return Code("resume", TYPE_I32_I32, ["i64", "i32"], body)


def _prefetch(*, checked: bool) -> Code:
    """`prefetch(slot) -> number`: load the top of the stack and the first object."""
    body: list[Instr] = [("i32.const", 0)]
    for memory in (MEMORY, SHADOW) if checked else (MEMORY,):
        for line in range(-_STACK_LINES, 2):
            body += [("i32.const", STACK_TOP + 64 * line), ("i32.load", memory, 0), ("i32.or",)]
    return Code("prefetch", TYPE_I32_I32, [], body)
