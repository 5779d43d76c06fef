"""The options of every command that compiles C, and the collection of its messages."""

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
    """Options of the compiler.

    Attributes:
        include_paths: the folders searched by `#include`, in order.
        defines: macros, each `NAME` or `NAME=VALUE`.
        undefines: predefined macros to remove.
        standard: the C standard of the program.
        dialect: the API that it calls, `nomad` or `report`; None to detect it.
    """

    include_paths: tuple[Path, ...] = ()
    defines: tuple[str, ...] = ()
    undefines: tuple[str, ...] = ()
    standard: str = "gnu17"
    dialect: Dialect | None = None


def _folders(
    _ctx: click.Context, _option: click.Parameter, paths: tuple[Path, ...]
) -> tuple[Path, ...]:
    """Drop folders that do not exist, with a warning: makefiles often name some."""
    for path in paths:
        if not path.is_dir():
            say(f"warning: -I {path}: no such folder")
    return tuple(path for path in paths if path.is_dir())


_OPTIONS = (
    click.option(
        "-I", "--include", "include_paths", metavar="DIR", multiple=True,
        type=click.Path(path_type=Path), callback=_folders,
        help="Add DIR to the search path of #include; may be repeated.",
    ),
    click.option(
        "-D", "--define", "defines", metavar="NAME[=VALUE]", multiple=True,
        help="Define a macro as VALUE, by default 1; may be repeated.",
    ),
    click.option(
        "-U", "--undefine", "undefines", metavar="NAME", multiple=True,
        help="Undefine a predefined macro; may be repeated.",
    ),
    click.option(
        "-std", "standard", metavar="NAME", default="gnu17", show_default=True,
        type=click.Choice(list(STANDARDS)),
        help="The C standard: c89, gnu89, c99, gnu99, c11, gnu11, c17 or gnu17. It selects the "
        "predefined macros and, without 'gnu', trigraphs; the language accepted is the same.",
    ),
    click.option(
        "--dialect", type=click.Choice(DIALECTS),
        help="The API that the program calls: nomad, the vendor's, or report, that of the CRS "
        "report, where a program may consist of the statements of its body. By default report for "
        "a program with a function runcode that includes no Nomadic header and has no main.",
    ),
)  # fmt: skip


def compiler_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Add the compiler options to a command, which receives them as `compiler`."""

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
    """Add the warnings found before it to an error that leaves the block."""
    try:
        yield
    except CrsError as error:
        messages = merged(diagnostics.messages, error.diagnostics)
        if quiet:
            messages = [each for each in messages if each.severity != "warning"]
        raise type(error)(messages) from None


def merged(first: Sequence[Diagnostic], second: Sequence[Diagnostic]) -> list[Diagnostic]:
    """Return the messages of both in order, without duplicates."""
    return list(dict.fromkeys([*first, *second]))
