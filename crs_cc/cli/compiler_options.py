"""The options of every command that compiles C, and the collection of its messages."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from crs_cc.cli.messages import say
from crs_cc.core.errors import CompileError, CrsError
from crs_cc.core.file_names import displayed
from crs_cc.core.source import Diagnostic, Diagnostics
from crs_cc.core.warning_names import Selection, unknown_option
from crs_cc.frontend.preprocess.options import DIALECTS, STANDARDS, Dialect

if TYPE_CHECKING:
    from crs_cc.runtime.executable import Executable


@dataclass(frozen=True, slots=True)
class CompilerOptions:
    """Options of the compiler.

    Attributes:
        include_paths: the folders searched by `#include`, in order.
        defines: macros, each `NAME` or `NAME=VALUE`.
        undefines: predefined macros to remove.
        standard: the C standard of the program.
        dialect: the API that it calls, `nomad` or `report`; None to detect it.
        warnings: which warnings are shown, and which are errors.
        root: the folder of the user's whole project; None for the current directory.
        named_from: a folder that is left out of the names of files in messages.
    """

    include_paths: tuple[Path, ...] = ()
    defines: tuple[str, ...] = ()
    undefines: tuple[str, ...] = ()
    standard: str = "gnu17"
    dialect: Dialect | None = None
    warnings: Selection = field(default_factory=Selection)
    root: Path | None = None
    named_from: Path | None = None

    def build(
        self,
        paths: Sequence[Path],
        diagnostics: Diagnostics,
        dialect: Dialect | None,
        **build: bool,
    ) -> Executable:
        """Compile and link C files, see `build_executable`.

        Args:
            paths: the files.
            diagnostics: receives the warnings.
            dialect: the API that they call; None to detect it.
            build: `checked`, `debug` and `trap_overflow`, if they are not as usual.

        Raises:
            CompileError: the files are not a valid program.
        """
        from crs_cc.session.build import build_executable

        return build_executable(
            paths,
            diagnostics,
            include_paths=self.include_paths,
            defines=self.defines,
            undefines=self.undefines,
            standard=self.standard,
            root=self.root,
            named_from=self.named_from,
            dialect=dialect,
            **build,
        )


def _folders(
    _ctx: click.Context, _option: click.Parameter, paths: tuple[Path, ...]
) -> tuple[Path, ...]:
    """Drop folders that do not exist, with a warning: makefiles often name some."""
    for path in paths:
        if not path.is_dir():
            say(f"warning: -I {path}: no such folder")
    return tuple(path for path in paths if path.is_dir())


def _selection(
    _ctx: click.Context, _option: click.Parameter, options: tuple[str, ...]
) -> Selection:
    """Return the selection of -W options; a name with a typing error is reported."""
    for option in options:
        if (meant := unknown_option(option)) is not None:
            say(f"warning: -W{option}: no such warning (did you mean '{meant}'?)")
    return Selection.of(options)


_OPTIONS = (
    click.option(
        "-I", "--include", "include_paths", metavar="DIR", multiple=True,
        type=click.Path(path_type=Path), callback=_folders,
        help="Add DIR to the #include search path; may be repeated.",
    ),
    click.option(
        "--root", metavar="DIR", type=click.Path(path_type=Path, exists=True, file_okay=False),
        help="Project root: C files may include any file below it, for example '../include/x.h'. "
        "Default: the current directory, for programs in or below it; none for others.",
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
        help="The C standard: c89, gnu89, c99, gnu99, c11, gnu11, c17, gnu17, c23 or gnu23. It "
        "determines predefined macros and keywords; the c* standards also enable trigraphs.",
    ),
    click.option(
        "-W", "warnings", metavar="[no-|error=]NAME", multiple=True, callback=_selection,
        help="Select warnings as in gcc. All warnings are enabled by default. -Wno-NAME disables "
        "the warning NAME, -Wno-unused disables those named unused-*, and -Wno-all (or -w) "
        "disables all of them. -Werror turns all warnings into errors; -Werror=NAME does so for "
        "NAME only. gcc options such as -O2, -g and -lm are ignored.",
    ),
    click.option(
        "--dialect", type=click.Choice(DIALECTS),
        help="The API that the program uses: nomad (Nomadic's) or report (that of the CRS report; "
        "see docs/glossary.md). With report, a program may consist of just the statements of a "
        "function body. Default: report if the program defines runcode, has no main and "
        "includes no Nomadic header; otherwise nomad.",
    ),
)  # fmt: skip


def compiler_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Add the compiler options to a command, which receives them as `compiler`."""

    @functools.wraps(command)
    def with_options(
        *,
        include_paths: tuple[Path, ...],
        defines: tuple[str, ...],
        undefines: tuple[str, ...],
        standard: str,
        dialect: Dialect | None,
        warnings: Selection,
        root: Path | None,
        **others: Any,
    ) -> Any:
        macros = tuple(map(displayed, defines)), tuple(map(displayed, undefines))
        return command(
            compiler=CompilerOptions(include_paths, *macros, standard, dialect, warnings, root),
            **others,
        )

    for option in reversed(_OPTIONS):
        with_options = option(with_options)
    return with_options


@contextmanager
def gathered(
    diagnostics: Diagnostics, warnings: Selection, *, quiet: bool = False
) -> Iterator[None]:
    """Collect the messages of a block, and keep the selected ones.

    Args:
        diagnostics: what the block records; an error that leaves it gets these messages, too.
        warnings: the selection.
        quiet: leave warnings out of errors.

    Raises:
        CompileError: a warning is an error.
    """
    failed: type[CrsError] = CompileError
    try:
        yield
        messages = warnings.select(diagnostics.messages)
    except CrsError as error:
        failed = type(error)
        messages = warnings.select(merged(diagnostics.messages, error.diagnostics))
    diagnostics.messages[:] = messages
    if any(each.severity == "error" for each in messages):
        raise failed([each for each in messages if not quiet or each.severity != "warning"])


def merged(first: Sequence[Diagnostic], second: Sequence[Diagnostic]) -> list[Diagnostic]:
    """Return the messages of both in order, without duplicates."""
    return list(dict.fromkeys([*first, *second]))
