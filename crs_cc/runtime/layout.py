"""The layout of a robot's memory and of stack frames.

    0           NULL_SIZE        STACK_TOP                          MEMORY_BYTES
    | null page | stack  <------ | objects with addresses | heap ... |

The null page is never accessible. The stack grows down. Every call is passed the address `fp` of a
header that its caller set up, followed by the arguments as on i386; its own frame is below it,
with the lower end `sp`, which is the `fp` of the functions that it calls:

    fp + 16   arguments, each rounded up to 4 bytes
    fp + 12   number of the landing at which to resume; 0 for a fresh call
    fp + 8    number of the function, written when it is suspended
    fp + 0    returned value; before that, in checked builds, the call word, see `sites`
              --- the callee's own frame ---
    ...       spill slots of registers, slots
    sp        header and arguments of the functions that it calls

In checked builds every slot and every object is surrounded by inaccessible red zones.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Final

from crs_cc.core.errors import CompileError

if TYPE_CHECKING:
    from crs_cc.ir.instruction import Register, Slot
    from crs_cc.ir.program import Data, Function, Parameter, Program

NULL_SIZE: Final = 4096
STACK_SIZE: Final = 2 * 2**20
STACK_TOP: Final = NULL_SIZE + STACK_SIZE
MEMORY_BYTES: Final = 16 * 2**20
PAGE: Final = 65536
"""WebAssembly's page [bytes]."""

HEADER_SIZE: Final = 16
RESULT, FUNCTION, RESUME = 0, 8, 12  # offsets from fp

BLOCK_HEADER: Final = 32  # of a block of the heap, see `lib/stdlib/malloc.c` [bytes]
ASKED: Final = 8 - BLOCK_HEADER  # offset from a block of the size that was asked for

ALIGN: Final = 16  # of every frame [bytes]
MINIMUM_FRAME: Final = 96
"""With the charge for each local, see `registers`, this bounds the host's stack, which grows with
the program's, to three times the latter."""


def round_up(value: int, align: int) -> int:
    """Return the next multiple of `align`."""
    return -(-value // align) * align


@dataclass(slots=True)
class Frame:
    """The frame of one function.

    Attributes:
        size: its size in bytes, a multiple of 16: fp - sp.
        offsets: offset from sp of the spill slot of each saved register, and of each slot.
        parameters: offset from sp of each parameter.
        varargs: offset from sp of the variable arguments.
        jump_value: offset from sp of the value passed by `longjmp`.
        entered: offset from sp of the number of statements begun at function entry; -1
            where it is not stored. Together with fp it identifies an activation among all in
            which the program ever stops.
    """

    size: int = 0
    offsets: dict[Register | Slot, int] = field(default_factory=dict)
    parameters: list[int] = field(default_factory=list)
    varargs: int = 0
    jump_value: int = 0
    entered: int = -1


def red_zone(size: int) -> int:
    """Return the size of the red zone after an object, which grows with it (indices go wider)."""
    return min(256, max(16, round_up(size // 4, 16)))


def argument_offsets(sizes: list[int]) -> list[int]:
    """Return the offset of each argument, and the end offset."""
    offsets = [0]
    for size in sizes:
        offsets.append(offsets[-1] + round_up(size, 4))
    return offsets


def check_sizes(program: Program) -> None:
    """Check what fits into no robot's memory, whatever else a program contains.

    Raises:
        CompileError: an object is too large for a robot's memory, or a local variable needs a
            stricter alignment than frames have.
    """
    for data in program.data.values():
        if data.size > MEMORY_BYTES - STACK_TOP:
            raise does_not_fit(data)
    for function in program.functions.values():
        for slot in function.slots:
            _check_alignment(slot, function)


def does_not_fit(data: Data) -> CompileError:
    """Return the error for an object that has no room in a robot's memory."""
    name = data.variable.name if data.variable else data.name
    return CompileError.at(
        data.location,
        f"'{name}' does not fit: {data.size} bytes of {MEMORY_BYTES - STACK_TOP}",
        "a robot's memory is limited; use a smaller array",
        "linking",
    )


def lay_out(
    function: Function,
    saved: list[Register],
    arguments_size: int,
    charge: int,
    *,
    checked: bool,
    stamped: bool = False,
) -> Frame:
    """Lay out a frame.

    Args:
        function: the function.
        saved: its registers that need a spill slot.
        arguments_size: the largest of the functions that it calls [bytes].
        charge: the charge for locals, which the host may spill to its stack [bytes].
        checked: insert red zones.
        stamped: reserve space for the time of entry.

    Raises:
        CompileError: a local variable needs a stricter alignment than frames have.
    """
    from crs_cc.ir.instruction import SetJump

    frame = Frame()
    offset = HEADER_SIZE + arguments_size if arguments_size >= 0 else 0
    for register in saved:
        size = 8 if register.type in ("i64", "f64") else 4
        offset = round_up(offset, size)
        frame.offsets[register] = offset
        offset += size
    if any(isinstance(block.terminator, SetJump) for block in function.blocks):
        offset = round_up(offset, 4)
        frame.jump_value = offset
        offset += 4
    if stamped:
        frame.entered = offset = round_up(offset, 8)
        offset += 8
    offset += red_zone(0) if checked and function.slots else 0
    for slot in function.slots:
        _check_alignment(slot, function)
        offset = round_up(offset, max(1, slot.align))
        frame.offsets[slot] = offset
        offset += slot.size
        offset += red_zone(slot.size) if checked else 0
    frame.size = max(MINIMUM_FRAME, round_up(max(offset, HEADER_SIZE + charge), ALIGN))
    _place_parameters(frame, function.parameters)
    return frame


def _check_alignment(slot: Slot, function: Function) -> None:
    if slot.align > ALIGN:
        what = slot.variable.name if slot.variable else slot.name
        raise CompileError.at(
            function.location,
            f"'{what}' in '{function.name}' is aligned to {slot.align} bytes",
            f"the maximum alignment of local variables is {ALIGN} bytes; make it static",
        )


def _place_parameters(frame: Frame, parameters: list[Parameter]) -> None:
    from crs_cc.ir.instruction import Slot

    first = frame.size + HEADER_SIZE
    offsets = [first + each for each in argument_offsets([p.size for p in parameters])]
    frame.parameters, frame.varargs = offsets[:-1], offsets[-1]
    for parameter, offset in zip(parameters, frame.parameters, strict=True):
        if isinstance(parameter.place, Slot):
            frame.offsets[parameter.place] = offset
