"""Compilation of C snippets in tests: results and messages."""

from __future__ import annotations

from contextlib import suppress

from crs_cc.core.errors import CompileError
from crs_cc.core.source import Diagnostics
from crs_cc.frontend.preprocess.options import Options
from crs_cc.frontend.unit import compile_text
from crs_cc.ir.program import Function, Program
from crs_cc.ir.text import to_text
from crs_cc.ir.types import CType
from crs_cc.ir.verify import verify


def compiled(source: str) -> Program:
    """Return the verified program of a text without errors."""
    program = compile_text(source, "a.c", Options(), Diagnostics())
    verify(program)
    return program


def function(source: str, name: str = "f") -> Function:
    """Return one function of a text."""
    return compiled(source).functions[name]


def body(source: str, name: str = "f") -> list[str]:
    """Return a function's IR in lines, without comments, markers and declarations."""
    text = to_text(Program({name: function(source, name)}))
    lines = [line.partition(";")[0].strip() for line in text.splitlines()]
    start = lines.index("entry:")
    return [line for line in lines[start:] if line and line != "statement"]


def type_of(source: str, name: str = "x") -> CType:
    """Return the type of a global variable."""
    variable = compiled(source).data[name].variable
    assert variable is not None
    return variable.ctype


def messages(source: str) -> list[str]:
    """Return the messages about a text, each as `line:column severity: text [hint]`."""
    diagnostics = Diagnostics()
    with suppress(CompileError):
        verify(compile_text(source, "a.c", Options(), diagnostics))
    return [
        f"{each.location.line}:{each.location.column} {each.severity}: {each.text}"
        + (f" [{each.hint}]" if each.hint else "")
        for each in diagnostics.messages
    ]
