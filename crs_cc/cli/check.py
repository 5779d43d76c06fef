"""`crs check`: check C, world and robot files without running anything."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Final

import click

from crs_cc.cli.compiler_options import CompilerOptions, compiler_options, merged
from crs_cc.cli.gcc_options import CompilerCommand
from crs_cc.cli.inputs import check_readable, is_world
from crs_cc.cli.messages import as_data, say, show
from crs_cc.core.errors import CompileError, CrsError, InternalError, WorldError
from crs_cc.core.source import Diagnostic, Diagnostics
from crs_cc.frontend.preprocess.options import Dialect

if TYPE_CHECKING:
    from crs_cc.ir.program import Program
    from crs_cc.sim.model.world import WorldModel

_EXAMPLES: Final = """
\b
Examples:
  crs check wander.c
  crs check *.c room.xml
  crs check rover.xml            a robot definition
  crs check --json wander.c | jq '.[].text'
"""


@click.command(cls=CompilerCommand, epilog=_EXAMPLES, short_help="Check C, world and robot files.")
@click.argument("files", nargs=-1, required=True, metavar="FILE.c|FILE.xml...")
@click.option("--json", "as_json", is_flag=True, help="Write the messages to stdout as JSON.")
@click.option(
    "-q",
    "--quiet",
    is_flag=True,
    help="Suppress warnings, the closing line and the contents of worlds.",
)
@compiler_options
def check(files: Sequence[str], as_json: bool, quiet: bool, compiler: CompilerOptions) -> int:
    """Check C, world and robot files without running anything.

    For a world, robot definition or included file, also list its contents. The programs that a
    world names for its robots are compiled, as in crs run, and there are warnings about goals that
    no robot can reach. Each C file is checked on its own, so that a part of a program can be
    checked too. If one of the C files defines main (or runcode), they are also linked, as in crs
    run. The exit status is 0 if there are no errors (warnings are allowed), else that of the first
    error: 121 for C, 122 for a world.
    """
    status = 0
    messages: list[Diagnostic] = []
    programs: list[Program] = []
    sources = Diagnostics()
    contents: list[str] = []
    together = [Path(name) for name in files if not is_world(name)]
    checked = {path.resolve() for path in together}
    for name in files:
        if is_world(name):
            checked.add(Path(name).resolve())
            found, error_status = _world_messages(Path(name), contents, compiler, checked)
        else:
            found, error_status = _messages(Path(name), compiler, programs, sources, together)
        selected = compiler.warnings.select(found)
        kept = [each for each in selected if each.severity == "error" or not quiet]
        messages = merged(messages, kept)
        status = status or error_status or _status(kept)
    if not status and programs:
        sources.messages += messages
        found, status = (_linked if _has_entry(programs) else _sized)(programs, sources)
        messages = compiler.warnings.select(found)
        status = status or _status(messages)
    if as_json:
        import json

        click.echo(json.dumps([as_data(message) for message in messages], indent=2))
        return status
    show(messages)
    if not quiet:
        for line in contents:
            click.echo(line)
        say(_closing_line(messages, len(checked)))
    return status


def _status(messages: Sequence[Diagnostic]) -> int:
    """Return the exit status of messages about C, of which -Werror makes errors."""
    return CompileError.exit_status if any(each.severity == "error" for each in messages) else 0


def _has_entry(programs: Sequence[Program]) -> bool:
    """Return whether exactly one of the files has an entry point, so that they are a program."""
    from crs_cc.frontend.check.scope import ENTRIES

    return sum(not ENTRIES.isdisjoint(each.functions) for each in programs) == 1


def _world_messages(
    path: Path, contents: list[str], compiler: CompilerOptions, checked: set[Path]
) -> tuple[Sequence[Diagnostic], int]:
    """Return the messages about an XML file and the programs that it names, and the exit status.

    Args:
        path: the file.
        contents: receives lines that describe its contents.
        compiler: how to compile the programs.
        checked: receives the paths of the programs.
    """
    from crs_cc.cli.describe import describe
    from crs_cc.sim.files.world_xml import load_any
    from crs_cc.sim.model.world import WorldModel

    try:
        check_readable(path)
        found = load_any(path)
        contents += [f"{path}: {line}" for line in describe(found)]
    except WorldError as error:
        return error.diagnostics, error.exit_status
    if not isinstance(found, WorldModel):
        return (), 0
    messages = _goal_messages(path, found)
    status = 0
    programs = [(robot.program, robot.dialect) for robot in found.robots if robot.program]
    for program, dialect in dict.fromkeys(programs):
        checked.add(Path(program).resolve())
        about, error_status = _program_messages(Path(program), dialect, compiler)
        messages = merged(messages, about)
        status = status or error_status
    return messages, status


def _goal_messages(path: Path, world: WorldModel) -> list[Diagnostic]:
    """Return warnings about goals of a world that no robot can reach."""
    from crs_cc.builder.document import Document
    from crs_cc.builder.reaching import unreachable
    from crs_cc.sim.files.xml_document import read_file

    try:
        document = Document(read_file(path), str(path))
    except WorldError:
        return []  # an encoding that only the loader reads
    return unreachable(document, world)


def _program_messages(
    path: Path, dialect: Dialect | None, compiler: CompilerOptions
) -> tuple[Sequence[Diagnostic], int]:
    """Return the messages about a program of one C file, and their exit status."""
    diagnostics = Diagnostics()
    try:
        check_readable(path)
        compiler.build([path], diagnostics, compiler.dialect or dialect)
    except CompileError as error:
        return merged(diagnostics.messages, error.diagnostics), error.exit_status
    return diagnostics.messages, 0


def _messages(
    path: Path,
    compiler: CompilerOptions,
    programs: list[Program],
    sources: Diagnostics,
    together: Sequence[Path],
) -> tuple[Sequence[Diagnostic], int]:
    """Return the messages about a C file, and the exit status of its errors.

    Args:
        path: the file.
        compiler: how to compile it.
        programs: receives its IR.
        sources: receives its lines.
        together: all C files.
    """
    diagnostics = Diagnostics()
    try:
        check_readable(path)
        from crs_cc.cli.compile import compile_source

        programs.append(compile_source(path, compiler, diagnostics, together))
        sources.lines.update(diagnostics.lines)
    except InternalError:
        raise
    except CrsError as error:
        return merged(diagnostics.messages, error.diagnostics), error.exit_status
    return diagnostics.messages, 0


def _linked(programs: Sequence[Program], diagnostics: Diagnostics) -> tuple[list[Diagnostic], int]:
    """Return all messages, linking included, and the exit status.

    Code is generated too, because only that shows whether the program's objects fit into a robot's
    memory, and its local variables into frames.
    """
    from crs_cc.runtime.codegen.module import check_program
    from crs_cc.runtime.link import link
    from crs_cc.session.library import library

    try:
        check_program(link(programs, library(), diagnostics))
    except CompileError as error:
        return merged(diagnostics.messages, error.diagnostics), error.exit_status
    return diagnostics.messages, 0


def _sized(programs: Sequence[Program], diagnostics: Diagnostics) -> tuple[list[Diagnostic], int]:
    """Return all messages, those about parts that fit into no robot included, and the exit status.

    Without an entry point it is not known which of their functions and objects will be linked.
    """
    from crs_cc.runtime.layout import check_sizes

    try:
        for program in programs:
            check_sizes(program)
    except CompileError as error:
        return merged(diagnostics.messages, error.diagnostics), error.exit_status
    return diagnostics.messages, 0


def _closing_line(messages: Sequence[Diagnostic], files: int) -> str:
    errors = sum(message.severity == "error" for message in messages)
    warnings = sum(message.severity == "warning" for message in messages)
    return (
        f"{_count(files, 'file')} checked: {_count(errors, 'error')}, {_count(warnings, 'warning')}"
    )


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}{'' if number == 1 else 's'}"
