"""C programs from files and from text."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from crs_cc.core.errors import CompileError
from crs_cc.core.source import Diagnostic, Diagnostics
from crs_cc.core.suggest import unknown
from crs_cc.runtime.executable import Executable, command_name
from crs_cc.session.build import build_executable
from crs_cc.toolchain.cache import file_of

if TYPE_CHECKING:
    from crs_cc.frontend.preprocess.options import Dialect
    from crs_cc.runtime.diagnosis.report import ErrorReport

ProgramSource = str | os.PathLike[str]

_NAME: Final = "program.c"
"""The name of source text in messages."""

_FILES: Final[set[str]] = set()
"""The files that hold source text."""

_EXAMPLES: Final = {"defines": "SPEED=80", "undefines": "DEBUG", "include_paths": "include"}

_OPTIONS: Final = frozenset(
    {"defines", "undefines", "standard", "checked", "debug", "trap_overflow"}
)

_TEXT: Final = frozenset("\n;{")


def compile_c(
    *sources: ProgramSource,
    dialect: Dialect | None = None,
    include_paths: Sequence[str | os.PathLike[str]] = (),
    root: str | os.PathLike[str] | None = None,
    **options: Any,
) -> Executable:
    """Compile C files or text to one program; `crs check` shows the warnings.

    Args:
        sources: paths of C files; or a single string with C source text, which contains a line
            break, `;` or `{`.
        dialect: the API that they call, the vendor's (`nomad`) or that of the CRS report
            (`report`); by default it is detected.
        include_paths: folders for `#include`, in order.
        root: the folder of the whole project; by default the current directory.
        options: further options of `build_executable`: `defines`, `undefines`, `standard`,
            `checked`, `debug` and `trap_overflow`.

    Raises:
        TypeError: an argument has the wrong type, or there is no such option.
        ValueError: source text is not the only argument.
        CompileError: it is not a valid program.
    """
    for each in sources:
        if not isinstance(each, str | os.PathLike):
            kind = type(each).__name__
            raise TypeError(f"a program must be a path or C source text, not {kind}")
    if wrong := sorted(options.keys() - _OPTIONS):
        raise TypeError(unknown("option", wrong[0], sorted(_OPTIONS | {"include_paths", "root"})))
    for name, value in (*options.items(), ("include_paths", include_paths)):
        if name in _EXAMPLES and isinstance(value, str | bytes | os.PathLike | Mapping):
            raise TypeError(f"{name} must be a list, such as {name}=[{_EXAMPLES[name]!r}]")
    options["include_paths"] = [Path(each) for each in include_paths]
    options["root"] = None if root is None else Path(root)
    texts = [each for each in sources if is_text(each)]
    if texts and len(sources) > 1:
        raise ValueError("source text must be the only argument (several files are given by paths)")
    if not texts:
        paths = [Path(each) for each in sources]
        return build_executable(paths, Diagnostics(), dialect=dialect, **options)
    path = file_of(str(texts[0]))
    _FILES.add(str(path))
    try:
        found = build_executable([path], Diagnostics(), dialect=dialect, **options)
    except CompileError as error:
        raise CompileError([_named(each, str(path)) for each in error.diagnostics]) from None
    return replace(found, name=_NAME, command=command_name(_NAME))


def shown(error: ErrorReport) -> ErrorReport:
    """Return a run-time error with the name of source text instead of that of its file."""
    if error.location.file not in _FILES:
        return error
    return replace(error, location=replace(error.location, file=_NAME))


def _named(message: Diagnostic, file: str) -> Diagnostic:
    """Return a message about a text with the text's name instead of its file's."""
    if message.location.file != file:
        return message
    return replace(message, location=replace(message.location, file=_NAME))


def is_text(source: ProgramSource) -> bool:
    """Return whether a program is given as source text, not as a path.

    >>> is_text("wander.c"), is_text("int main(void) { return 0; }")
    (False, True)
    """
    return isinstance(source, str) and not _TEXT.isdisjoint(source)
