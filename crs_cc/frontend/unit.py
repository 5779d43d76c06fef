"""The front end's entry: one C file in, one `Program` out.

    preprocess -> parse -> check -> lower

>>> from crs_cc.frontend.preprocess.options import Options
>>> from crs_cc.core.source import Diagnostics
>>> source = "int twice(int n) { return 2 * n; }"
>>> program = compile_text(source, "twice.c", Options(), Diagnostics())
>>> list(program.functions)
['twice']
"""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Final, TypeVar

from crs_cc.core.errors import CompileError
from crs_cc.core.source import Diagnostics, Location
from crs_cc.frontend.body import suggest_dialect, with_body
from crs_cc.frontend.check.checker import Unit
from crs_cc.frontend.check.unit import check_unit
from crs_cc.frontend.error_limit import CompilationAborted
from crs_cc.frontend.lower.unit import lower_unit
from crs_cc.frontend.parse.header_memory import lex_program
from crs_cc.frontend.parse.parser import parse
from crs_cc.frontend.preprocess.macro_notes import add_macro_notes
from crs_cc.frontend.preprocess.options import Options
from crs_cc.frontend.preprocess.preprocessor import Preprocessed, preprocess, preprocess_text
from crs_cc.frontend.warn.suspicious import warn_unit
from crs_cc.ir.program import Program

Result = TypeVar("Result")

MAX_SHOWN: Final = 20
"""How many errors are reported per file; most of the others are consequences."""

_STACK_BYTES: Final = 256 << 20
_RECURSION_LIMIT: Final = 60_000
"""Enough for thousands of nested parentheses."""


def compile_file(path: Path, options: Options, diagnostics: Diagnostics) -> Program:
    """Compile a C file.

    Returns:
        The program, not verified yet.

    Raises:
        CompileError: when there are errors in the file.
    """
    unit = _unit(options.name(path), options, diagnostics)
    return _compile(lambda: preprocess(path, options, diagnostics), unit, _stages)


def check_file(path: Path, options: Options, diagnostics: Diagnostics) -> tuple[Unit, Preprocessed]:
    """Preprocess and check a C file; return its checked and its preprocessed form.

    Raises:
        CompileError: when there are errors in the file.
    """

    def names(unit: Unit, source: Preprocessed) -> tuple[Unit, Preprocessed]:
        _check(unit, source)
        return unit, source

    unit = _unit(options.name(path), options, diagnostics)
    return _compile(lambda: preprocess(path, options, diagnostics), unit, names)


def compile_text(text: str, name: str, options: Options, diagnostics: Diagnostics) -> Program:
    """Compile C text as if it were the file `name`.

    Raises:
        CompileError: when there are errors in it.
    """
    unit = _unit(name, options, diagnostics)
    return _compile(lambda: preprocess_text(text, name, options, diagnostics), unit, _stages)


def _unit(name: str, options: Options, diagnostics: Diagnostics) -> Unit:
    place = Location(name)
    return Unit(
        name,
        diagnostics,
        place,
        trusted=options.trusted,
        headers=options.system_paths,
        dialect=options.dialect,
        standard=options.standard,
    )


def _compile(
    preprocessed: Callable[[], Preprocessed],
    unit: Unit,
    stages: Callable[[Unit, Preprocessed], Result],
) -> Result:
    diagnostics = unit.diagnostics
    sources: list[Preprocessed] = []
    results: list[Result] = []
    diagnostics.stage = "preprocessing"

    def work() -> None:
        sources.append(preprocessed())
        results.append(stages(unit, sources[0]))

    try:
        _with_deep_stack(work)
    except RecursionError:
        unit.diagnostics.error(unit.location, "the program is nested too deeply here")
    except CompilationAborted:
        pass  # the reason is in the diagnostics
    _drop_consequences(diagnostics)
    diagnostics.sort()
    diagnostics.shorten(MAX_SHOWN)
    if diagnostics.errors:
        if sources:
            add_macro_notes(diagnostics, sources[0], unit.headers)
        raise CompileError(diagnostics.errors)
    return results[0]


def _drop_consequences(diagnostics: Diagnostics) -> None:
    """Drop messages of later stages about lines that the preprocessor has rejected."""
    rejected = {
        (each.location.file, each.location.line)
        for each in diagnostics.errors
        if each.stage == "preprocessing"
    }
    diagnostics.messages[:] = [
        each
        for each in diagnostics.messages
        if each.stage == "preprocessing" or (each.location.file, each.location.line) not in rejected
    ]


def _check(unit: Unit, source: Preprocessed) -> None:
    if not source.is_complete:
        _stop_on_errors(unit)
    unit.diagnostics.stage = "parsing"
    tokens, headers = lex_program(source, unit.diagnostics, unit.standard)
    if unit.dialect == "report":
        tokens = with_body(tokens, unit.name, unit.diagnostics)
    try:
        nodes = parse(tokens, unit.diagnostics, unit.standard, headers)
    finally:
        if unit.dialect != "report" and unit.diagnostics.errors:
            suggest_dialect(tokens, unit.diagnostics)
    unit.macros = tuple(source.macros)
    unit.weak = source.weak
    unit.diagnostics.stage = "types"
    check_unit(unit, nodes)
    _stop_on_errors(unit)


def _stages(unit: Unit, source: Preprocessed) -> Program:
    _check(unit, source)
    warn_unit(unit)
    program = lower_unit(unit)
    _stop_on_errors(unit)
    return program


def _stop_on_errors(unit: Unit) -> None:
    if unit.diagnostics.errors:
        raise CompilationAborted


def _with_deep_stack(work: Callable[[], None]) -> None:
    """Run `work` in a thread whose stack is large enough for deeply nested programs.

    The thread is joined at once, so the result is deterministic.

    Raises:
        Exception: whatever `work` raised.
    """
    raised: list[BaseException] = []

    def run() -> None:
        try:
            work()
        except BaseException as problem:
            raised.append(problem)

    limit, stack = sys.getrecursionlimit(), threading.stack_size(_STACK_BYTES)
    sys.setrecursionlimit(max(limit, _RECURSION_LIMIT))
    try:
        thread = threading.Thread(target=run, daemon=True)
        thread.start()
        thread.join()
    finally:
        threading.stack_size(stack)
        sys.setrecursionlimit(limit)
    if raised:
        raise raised.pop()  # kept, it would be in a reference cycle with this frame
