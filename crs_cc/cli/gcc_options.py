"""Options of gcc that are common in makefiles, and are ignored.

>>> without_gcc_options(["-O2", "-ansi", "-Wall", "wander.c", "-lm"])
['-std=c89', '-Wall', 'wander.c']
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Final

import click

_IGNORED: Final = re.compile(
    r"-O([0-3sgz]|fast)? | -g(gdb|dwarf(-\d)?|stabs)?[0-3]? | -p | -pg | -pipe | -c | -s "
    r"| -m(32|64|arch=.+|tune=.+|cpu=.+|[a-z]{3,}) | -f[a-z][\w=.+-]* | -W[lpa],.* "
    r"| -l(m|c|n|X11|Nclient) | -(static|shared|rdynamic|pthread|nostdinc|M{1,2}D?|MP)",
    re.VERBOSE,
)
"""Optimisation, debug information, code generation and linking have no meaning here."""

_REPLACED: Final = {
    "-ansi": "-std=c89",
    "-pedantic": "-Wpedantic",
    "-pedantic-errors": "-Wpedantic",
    "-w": "-Wno-all",
    "-W": "-Wextra",
}


def without_gcc_options(arguments: Sequence[str]) -> list[str]:
    """Return the arguments without ineffective options, the others in the form that crs accepts."""
    kept = [each for each in arguments if not _IGNORED.fullmatch(each)]
    return [_REPLACED.get(each, each) for each in kept]


class CompilerCommand(click.Command):
    """A command that compiles C, and accepts the options of gcc."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Parse the arguments without those that change nothing."""
        return super().parse_args(ctx, without_gcc_options(args))
