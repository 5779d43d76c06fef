"""Where things lie in a robot's memory, and how a stack frame looks.

    0           NULL_SIZE        STACK_TOP                          MEMORY_BYTES
    | null page | stack  <------ | objects with addresses | heap ... |

The null page is never accessible. The stack grows down. Every call gets the address `fp` of a
header that its caller set up, with the arguments behind it as on i386; its own frame lies below,
with the lower end `sp`, which is the `fp` of the functions that it calls in turn:

    fp + 16   arguments, each rounded up to 4 bytes
    fp + 12   number of the landing at which to go on; 0 for a fresh start
    fp + 8    number of the function, written when it is suspended
    fp + 0    returned value; before that, in checked builds, the call word, see `sites`
              --- the callee's own frame ---
    ...       homes of registers, slots
    sp        header and arguments of the functions that it calls

In checked builds red zones, which C may not touch, lie around every slot and every object.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Final

from crs_cc.core.errors import CompileError
from crs_cc.ir.program import Function, Parameter, Register, SetJump, Slot

NULL_SIZE: Final = 4096
STACK_SIZE: Final = 2 * 2**20
STACK_TOP: Final = NULL_SIZE + STACK_SIZE
MEMORY_BYTES: Final = 16 * 2**20

HEADER_SIZE: Final = 16
RESULT, FUNCTION, RESUME = 0, 8, 12  # offsets from fp

ALIGN: Final = 16  # of every frame [bytes]
MINIMUM_FRAME: Final = 96
"""With the charge for each local, see `registers`, this keeps the host's stack, which grows with
ours, within three times of ours."""


def round_up(value: int, align: int) -> int:
    """Return the next multiple of `align`."""
    return -(-value // align) * align


@dataclass(slots=True)
class Frame:
    """The frame of one function.

    Attributes:
        size: its size in bytes, a multiple of 16: fp - sp.
        offsets: offset from sp of the home of each register that is saved, and of each slot.
        parameters: offset from sp of each parameter.
        varargs: offset from sp of what follows the parameters.
        jump_value: offset from sp of the value that a `longjmp` brings.
        entered: offset from sp of how many statements had begun when the function was entered; -1
            where that is not noted. Together with fp it tells one activation from all others in
            which the program ever stops.
    """

    size: int = 0
    offsets: dict[Register | Slot, int] = field(default_factory=dict)
    parameters: list[int] = field(default_factory=list)
    varargs: int = 0
    jump_value: int = 0
    entered: int = -1


def red_zone(size: int) -> int:
    """Return how many bytes to leave behind an object: more for larger ones, as indices go wider."""
    return min(256, max(16, round_up(size // 4, 16)))


def argument_offsets(sizes: list[int]) -> list[int]:
    """Return the offset of each argument, and the offset behind the last one."""
    offsets = [0]
    for size in sizes:
        offsets.append(offsets[-1] + round_up(size, 4))
    return offsets


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
        saved: its registers that need a home.
        arguments_size: of the functions that it calls, the most [bytes].
        charge: what to count for the locals, which the host may keep on its stack [bytes].
        checked: leave red zones.
        stamped: note when the function was entered.

    Raises:
        CompileError: a local variable wants to be aligned more strictly than frames are.
    """
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
            f"local variables can be aligned to {ALIGN} bytes at most; make it static",
        )


def _place_parameters(frame: Frame, parameters: list[Parameter]) -> None:
    first = frame.size + HEADER_SIZE
    offsets = [first + each for each in argument_offsets([p.size for p in parameters])]
    frame.parameters, frame.varargs = offsets[:-1], offsets[-1]
    for parameter, offset in zip(parameters, frame.parameters, strict=True):
        if isinstance(parameter.place, Slot):
            frame.offsets[parameter.place] = offset
