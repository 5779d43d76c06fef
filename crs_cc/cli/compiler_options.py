"""The options of every command that compiles C, and how its messages are gathered."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import click

from crs_cc.cli.messages import say
from crs_cc.core.errors import CrsError
from crs_cc.core.file_names import displayed
from crs_cc.core.source import Diagnostic, Diagnostics
from crs_cc.frontend.preprocess.options import DIALECTS, STANDARDS, Dialect


@dataclass(frozen=True, slots=True)
class CompilerOptions:
    """How to compile.

    Attributes:
        include_paths: folders in which `#include` looks, in this order.
        defines: macros, each `NAME` or `NAME=VALUE`.
        undefines: macros that are not to be defined.
        standard: the C that the program is written in.
        dialect: whose functions it calls, `nomad` or `report`; None to judge by what it looks like.
    """

    include_paths: tuple[Path, ...] = ()
    defines: tuple[str, ...] = ()
    undefines: tuple[str, ...] = ()
    standard: str = "gnu17"
    dialect: Dialect | None = None


def _folders(
    _ctx: click.Context, _option: click.Parameter, paths: tuple[Path, ...]
) -> tuple[Path, ...]:
    """Leave out folders that do not exist, with a warning: makefiles name such."""
    for path in paths:
        if not path.is_dir():
            say(f"warning: -I {path}: no such folder")
    return tuple(path for path in paths if path.is_dir())


_OPTIONS = (
    click.option(
        "-I", "--include", "include_paths", metavar="DIR", multiple=True,
        type=click.Path(path_type=Path), callback=_folders,
        help="Look for #include files in DIR too; may be repeated.",
    ),
    click.option(
        "-D", "--define", "defines", metavar="NAME[=VALUE]", multiple=True,
        help="Define a macro, as 1 or as VALUE; may be repeated.",
    ),
    click.option(
        "-U", "--undefine", "undefines", metavar="NAME", multiple=True,
        help="Do not define a macro; may be repeated.",
    ),
    click.option(
        "-std", "standard", metavar="NAME", default="gnu17", show_default=True,
        type=click.Choice(list(STANDARDS)),
        help="Predefine the macros of c89, gnu89, c99, gnu99, c11, gnu11, c17 or gnu17; "
        "those without 'gnu' also have trigraphs. The language is the same.",
    ),
    click.option(
        "--dialect", type=click.Choice(DIALECTS),
        help="Whose functions the program calls: nomad, the vendor's, or report, those of the CRS "
        "report; then it may be just the statements of its body. If not given: report for "
        "a program with a function runcode that includes no Nomadic header and has no main.",
    ),
)  # fmt: skip


def compiler_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Return a command the options of the compiler, which it takes as `compiler`."""

    @functools.wraps(command)
    def with_options(
        include_paths: tuple[Path, ...],
        defines: tuple[str, ...],
        undefines: tuple[str, ...],
        standard: str,
        dialect: Dialect | None,
        **others: Any,
    ) -> Any:
        macros = tuple(map(displayed, defines)), tuple(map(displayed, undefines))
        return command(
            compiler=CompilerOptions(include_paths, *macros, standard, dialect),
            **others,
        )

    for option in reversed(_OPTIONS):
        with_options = option(with_options)
    return with_options


@contextmanager
def gathered(diagnostics: Diagnostics, *, quiet: bool = False) -> Iterator[None]:
    """Complete an error that leaves the block by the warnings found before it, or has none."""
    try:
        yield
    except CrsError as error:
        messages = merged(diagnostics.messages, error.diagnostics)
        if quiet:
            messages = [each for each in messages if each.severity != "warning"]
        raise type(error)(messages) from None


def merged(first: Sequence[Diagnostic], second: Sequence[Diagnostic]) -> list[Diagnostic]:
    """Return the messages of both, each once, in order."""
    return list(dict.fromkeys([*first, *second]))
