"""Diagnosis of a WebAssembly trap in a checked program: a read past the end of the shadow memory.

An access of several bytes at one of the last addresses extends beyond 4 GiB, so that the
host's guard page catches it before our check. It was the shadow that was read; the next check
in the code has the site. The active functions are given their current landings as if they had
been suspended, so that the program can be inspected as usual.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import wasmtime

from crs_cc.core.arrays import ByteArray
from crs_cc.runtime.codegen.indices import SITE
from crs_cc.runtime.codegen.large_functions import REPLACED
from crs_cc.runtime.compiled import Compiled
from crs_cc.runtime.layout import HEADER_SIZE, RESUME, STACK_TOP
from crs_cc.runtime.sites import call_site
from crs_cc.runtime.wasm import TYPE_CALL, Code, encode

MAX_FRAMES: Final = 20
"""Maximum number of frames of the host's stack reported by wasmtime."""

_OWN_PARAMETERS: Final = len(TYPE_CALL[0])


def blamed_site(trap: wasmtime.Trap, memory: ByteArray, compiled: Compiled) -> int | None:
    """Return the number of the site that was being checked; None for another trap."""
    last = compiled.first_function + len(compiled.functions)
    frames = [(each.func_index, each.func_offset) for each in trap.frames]
    while frames and frames[0][0] < compiled.first_function:
        del frames[0]
    if not frames or frames[0][0] >= last:
        return None
    site = _next_site(compiled.module.functions[frames[0][0]], frames[0][1])
    active = [index for index, _ in frames if compiled.first_function <= index < last]
    if site is not None and len(trap.frames) < MAX_FRAMES:
        _store_landings(active[::-1], memory, compiled)
    return site


def _next_site(code: Code, offset: int) -> int | None:
    at, number = code.start(), None
    passed = len(code.type[0]) - _OWN_PARAMETERS
    sets_site = (("local.set", SITE + passed), ("global.set", REPLACED[SITE]))
    for instr in code.body:
        if instr in sets_site and at > offset:
            return number
        number = instr[1] if instr[0] == "i32.const" else None
        at += len(encode(instr))
    return None


def _store_landings(active: Sequence[int], memory: ByteArray, compiled: Compiled) -> None:
    """Store in each active function, the outermost first, its current call."""
    fp = STACK_TOP - HEADER_SIZE
    for index in active[:-1]:
        info = compiled.functions[index - compiled.first_function]
        callee = fp - info.frame.size
        word = int(memory[callee : callee + 8].view("<u8")[0])
        landing = compiled.call_landing(info.function.name, call_site(word))
        memory[fp + RESUME : fp + RESUME + 4].view("<u4")[0] = landing
        fp = callee
    memory[fp + RESUME : fp + RESUME + 4].view("<u4")[0] = 0
