"""What the compiler remembers of one program for the next, before there is any submission.

Headers are parsed, and the code of library functions generated, once in a process. Each submission
is compiled in a copy of the worker process, which has what that process remembers.
"""

from __future__ import annotations

from typing import Final

from crs_cc.core.gc_pause import gc_paused
from crs_cc.core.source import Diagnostics
from crs_cc.frontend.unit import compile_text
from crs_cc.ir.verify import verify
from crs_cc.runtime.codegen.module import compile_program
from crs_cc.runtime.link import link
from crs_cc.session.library import library, library_options

_PROGRAM: Final = """
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "Nclient.h"
int main(void)
{
    long distances[16];
    connect_robot(1);
    zr(), conf_tm(0), conf_sn(15, 0), sp(100, 100, 0), ac(100, 100, 0), da(0, 0), tk("here");
    pr(100, 100, 0), vm(100, 100, 0), mv(1, 100, 1, 100, 0, 0), st();
    scout_pr(100, 0), scout_vm(100, 0);
    gs(), get_sn(), get_bp(), get_rc(), get_rv(), ws(1, 1, 0, 20);
    memcpy(distances, &State[17], sizeof distances);
    printf("%d %ld %f\\n", State[0], distances[0], sin(1.0) + atan2(1.0, 2.0));
    disconnect_robot(1);
    exit(abs(rand() % 2));
}
"""
"""A program that includes and calls what many do."""


def fill() -> None:
    """Let the compiler remember what many programs include and call."""
    with gc_paused():
        unit = compile_text(_PROGRAM, "program.c", library_options(), Diagnostics())
        verify(unit)
        program = link([unit], library(), Diagnostics())
        for _ in range(2):  # code is kept when it is asked for again
            compile_program(program)
