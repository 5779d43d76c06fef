"""The IR verifier, which finds errors of the compiler early.

The code generator accepts verified programs only. For any C source, the front end must produce a
program that passes; a violation is a bug of the compiler.

>>> from crs_cc.ir.instruction import Block, Branch, Constant
>>> from crs_cc.ir.program import Function, Program
>>> from crs_cc.core.source import Location
>>> here = Location("loop.c", 1, 1)
>>> loop = Block("loop")
>>> loop.terminator = Branch(here, Constant("f64", 1.0), loop, loop)
>>> verify(Program({"main": Function("main", here, blocks=[loop])}))
Traceback (most recent call last):
    ...
crs_cc.core.errors.InternalError: loop.c:1:1: error: malformed IR in 'main', block 'loop': \
condition has type f64, not i32
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from crs_cc.core.errors import InternalError
from crs_cc.core.source import Diagnostic, Location
from crs_cc.ir.instruction import Block, Slot
from crs_cc.ir.program import Data, Function, Program
from crs_cc.ir.value_type import MEMORY_SIZE, VALUE_TYPE
from crs_cc.ir.verify_block import BlockVerifier


def verify(program: Program) -> None:
    """Check a program for well-formedness, see `ir.program`.

    Raises:
        InternalError: with a message for each violation, with function and block.
    """
    violations = [*_names(program), *_all_data(program)]
    for function in program.functions.values():
        violations.extend(_function(program, function))
    if violations:
        raise InternalError(violations)


def _violation(location: Location, where: str, what: str) -> Diagnostic:
    return Diagnostic("error", location, f"malformed IR in {where}: {what}")


def _names(program: Program) -> Iterator[Diagnostic]:
    for table in (program.functions, program.data):
        for name, item in table.items():
            if name != item.name:
                text = f"is stored under the name '{name}'"
                yield _violation(item.location, f"'{item.name}'", text)
    for name, data in program.data.items():
        if name in program.functions:
            yield _violation(data.location, f"'{name}'", "is both a function and an object")
    for name, place in program.undefined.items():
        if name in program.functions or name in program.data:
            yield _violation(place, f"'{name}'", "is defined and listed as undefined")


def _all_data(program: Program) -> Iterator[Diagnostic]:
    for data in program.data.values():
        for what in _data(program, data):
            yield _violation(data.location, f"object '{data.name}'", what)


def _data(program: Program, data: Data) -> Iterator[str]:
    yield from _extent(data.size, data.align)
    if data.content is not None and len(data.content) != data.size:
        yield f"has {len(data.content)} bytes of content, but size {data.size}"
    for relocation in data.relocations:
        if not 0 <= relocation.offset <= data.size - 4:
            yield f"relocation at {relocation.offset} is outside its {data.size} bytes"
        if not _is_known(program, relocation.symbol):
            yield f"relocation names '{relocation.symbol}', which is undefined"


def _is_known(program: Program, name: str) -> bool:
    return name in program.functions or name in program.data or name in program.undefined


def _extent(size: int, align: int) -> Iterator[str]:
    if size < 0:
        yield f"has negative size {size}"
    if align < 1 or align & (align - 1):
        yield f"has alignment {align}, which is not a power of two"


def _function(program: Program, function: Function) -> Iterator[Diagnostic]:
    where = f"'{function.name}'"
    for what in (*_frame(function), *_parameters(function), *_graph(function)):
        yield _violation(function.location, where, what)
    verifier = BlockVerifier(program, function)
    for block in function.blocks:
        for place, what in verifier.check(block):
            yield _violation(place or function.location, f"{where}, block '{block.label}'", what)


def _frame(function: Function) -> Iterator[str]:
    for index, times in Counter(each.index for each in function.registers).items():
        if times > 1:
            yield f"has {times} registers of number {index}"
    for slot in function.slots:
        for what in _extent(slot.size, slot.align):
            yield f"slot '{slot.name}' {what}"


def _parameters(function: Function) -> Iterator[str]:
    registers = set(map(id, function.registers))
    slots = set(map(id, function.slots))
    for number, parameter in enumerate(function.parameters):
        place, memory, size = parameter.place, parameter.memory, parameter.size
        what = f"parameter {number}"
        if memory is None:
            if not isinstance(place, Slot):
                yield f"{what} is a struct, but is in a register"
        elif size != MEMORY_SIZE[memory]:
            yield f"{what} is stored as {memory}, but has size {size}"
        if isinstance(place, Slot):
            if id(place) in slots:
                yield f"{what} is in slot '{place.name}', which is also listed as a local"
            if place.size > (size + 3) // 4 * 4:
                yield f"{what} has size {size}, but its slot {place.size}"
        else:
            if id(place) not in registers:
                yield f"{what} is in a register of another function"
            if memory is not None and place.type != VALUE_TYPE[memory]:
                yield f"{what} is stored as {memory}, but its register has type {place.type}"


def _graph(function: Function) -> Iterator[str]:
    if not function.blocks:
        yield "has no entry block"
        return
    for label, times in Counter(block.label for block in function.blocks).items():
        if times > 1:
            yield f"has {times} blocks labelled '{label}'"
    reached: dict[int, Block] = {}
    waiting = [function.blocks[0]]
    while waiting:
        block = waiting.pop()
        if id(block) not in reached:
            reached[id(block)] = block
            waiting.extend(block.successors())
    for block in function.blocks:
        if id(block) not in reached:
            yield f"block '{block.label}' is unreachable"
