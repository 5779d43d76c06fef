"""`crs compile`: show the intermediate forms of a C program."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Final

import click

from crs_cc.cli.compiler_options import CompilerOptions, compiler_options, gathered
from crs_cc.cli.gcc_options import CompilerCommand
from crs_cc.cli.inputs import check_readable
from crs_cc.cli.messages import show
from crs_cc.core.source import Diagnostics

if TYPE_CHECKING:
    from crs_cc.ir.program import Program


_EXAMPLES: Final = """
\b
Examples:
  crs compile wander.c
  crs compile --emit wat --unchecked wander.c | less
"""


@click.command(
    "compile",
    cls=CompilerCommand,
    epilog=_EXAMPLES,
    short_help="Show the code generated for a program.",
)
@click.argument("files", nargs=-1, required=True, metavar="PROGRAM.c...")
@click.option(
    "--emit",
    type=click.Choice(["ir", "wat"]),
    default="ir",
    show_default=True,
    help="ir: the typed intermediate representation of the files. "
    "wat: the WebAssembly of the whole program, including the library.",
)
@click.option("-q", "--quiet", is_flag=True, help="Suppress warnings.")
@click.option("--unchecked", is_flag=True, help="wat: omit the checks of memory accesses.")
@compiler_options
def compile_(
    files: Sequence[str], emit: str, quiet: bool, unchecked: bool, compiler: CompilerOptions
) -> int:
    """Write the code generated for a C program to stdout."""
    paths = [Path(name) for name in files]
    diagnostics = Diagnostics()
    with gathered(diagnostics, compiler.warnings, quiet=quiet):
        for path in paths:
            check_readable(path)
        if emit == "ir":
            text = _ir(paths, compiler, diagnostics)
        else:
            text = _wat(paths, compiler, diagnostics, checked=not unchecked)
    if not quiet:
        show(diagnostics.messages)
    click.echo(text.encode("utf-8", "surrogateescape"), nl=False)
    return 0


def compile_source(
    path: Path, compiler: CompilerOptions, diagnostics: Diagnostics, together: Sequence[Path]
) -> Program:
    """Compile a single C file.

    Args:
        path: the file.
        compiler: how to compile it.
        diagnostics: receives the messages.
        together: all files, which decide the dialect of those that do not show it.

    Raises:
        CompileError: the C source is invalid.
    """
    from crs_cc.frontend.dialect import dialect_of, form
    from crs_cc.frontend.unit import compile_file
    from crs_cc.ir.verify import verify
    from crs_cc.session.library import library_options

    options = library_options(
        compiler.include_paths,
        compiler.defines,
        compiler.undefines,
        compiler.standard,
        compiler.root,
        named_from=compiler.named_from,
    )
    dialect = compiler.dialect or form(path, options) or dialect_of(together, options)
    program = compile_file(path, replace(options, dialect=dialect), diagnostics)
    verify(program)
    return program


def _ir(paths: Sequence[Path], compiler: CompilerOptions, diagnostics: Diagnostics) -> str:
    from crs_cc.ir.text import to_text

    programs = [compile_source(path, compiler, diagnostics, paths) for path in paths]
    return "\n".join(map(to_text, programs))


def _wat(
    paths: Sequence[Path], compiler: CompilerOptions, diagnostics: Diagnostics, *, checked: bool
) -> str:
    return compiler.build(paths, diagnostics, compiler.dialect, checked=checked).wat()
