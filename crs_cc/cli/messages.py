"""Diagnostics on stderr, with the source line and a caret.

The format is that of `source.Diagnostic.render`, adapted to a terminal: coloured if colours are
enabled, without control characters that a hostile file could smuggle in, and with very long
lines cut to the part around the caret.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from typing import Final, TextIO

import click

from crs_cc.core.source import Diagnostic, underline
from crs_cc.core.warning_names import MINOR

MAX_MESSAGES: Final = 50
WARNINGS_BEFORE_RUN: Final = 2
MAX_LINE_LENGTH: Final = 160
_COLOURS: Final = {"error": "red", "warning": "magenta", "note": "cyan"}
_BIDIRECTIONAL: Final = (*range(0x202A, 0x202F), *range(0x2066, 0x206A))
_CONTROLS: Final = dict.fromkeys(
    (*range(10), *range(11, 32), *range(127, 160), *_BIDIRECTIONAL), "?"
)


def is_terminal(stream: TextIO | None) -> bool:
    """Return whether a stream is open and a terminal."""
    return stream is not None and not stream.closed and stream.isatty()


def is_coloured(stream: TextIO | None) -> bool:
    """Return whether to write colours: on a terminal, unless NO_COLOR or TERM=dumb is set."""
    forbidden = os.environ.get("NO_COLOR") or os.environ.get("TERM") == "dumb"
    return is_terminal(stream) and not forbidden


def say(text: str) -> None:
    """Write a line to stderr."""
    click.echo(text, err=True, color=is_coloured(sys.stderr))


def show(diagnostics: Sequence[Diagnostic]) -> None:
    """Write messages to stderr, the first `MAX_MESSAGES` of them."""
    for diagnostic in diagnostics[:MAX_MESSAGES]:
        say(render(diagnostic, coloured=is_coloured(sys.stderr)))
    if len(diagnostics) > MAX_MESSAGES:
        say(f"... and {len(diagnostics) - MAX_MESSAGES} more messages")


def show_before_run(diagnostics: Sequence[Diagnostic]) -> None:
    """Write messages to stderr as `show` does, but only the first few warnings.

    A program of 1989 has dozens of harmless ones, which must not bury the program's output.
    Warnings of old habits are the first to be left out.
    """
    warnings = [each for each in diagnostics if each.severity == "warning"]
    warnings.sort(key=lambda each: each.flag in MINOR)
    if len(warnings) <= WARNINGS_BEFORE_RUN:
        show(diagnostics)
        return
    left_out = set(map(id, warnings[WARNINGS_BEFORE_RUN:]))
    show([each for each in diagnostics if id(each) not in left_out])
    say(left_out_text(len(left_out)))


def left_out_text(count: int) -> str:
    """Return the message about warnings that are not shown before a run."""
    return f"... and {count} more warning{'s' * (count > 1)}; crs check shows all"


def render(diagnostic: Diagnostic, *, coloured: bool) -> str:
    """Return a message for the terminal, see `Diagnostic.render`."""
    place = str(diagnostic.location).translate(_CONTROLS | {10: "?"})
    kind, text = diagnostic.severity, diagnostic.named_text.translate(_CONTROLS)
    line, column = _excerpt(diagnostic)
    caret, hint = _caret(diagnostic, len(line) - column), diagnostic.hint.translate(_CONTROLS)
    if coloured:
        place, text = click.style(place, bold=True), click.style(text, bold=True)
        caret = click.style(caret, fg="green", bold=True)
        head = click.style(f"{kind}:", fg=_COLOURS[kind], bold=True)
    else:
        head = f"{kind}:"
    rows = [f"{place}: {head} {text}"]
    if line.strip():
        rows.append(f"    {line}")
        if column:
            rows.append(" " * (3 + column) + caret)
    if hint:
        rows.append(f"    hint: {hint}")
    return "\n".join(rows)


def printable(text: str) -> str:
    """Return a text as one line without control characters."""
    return text.translate(_CONTROLS | {9: " ", 10: "?"})


def as_data(diagnostic: Diagnostic) -> dict[str, str | int]:
    """Return a message as plain data for JSON."""
    place = diagnostic.location
    return {
        "severity": diagnostic.severity,
        "stage": diagnostic.stage,
        "file": place.file,
        "line": place.line,
        "column": place.column,
        "text": diagnostic.text,
        "hint": diagnostic.hint,
        "flag": diagnostic.flag,
    }


def _caret(diagnostic: Diagnostic, room: int) -> str:
    """Return the caret and the underline, clipped to the excerpt."""
    return underline(diagnostic.source_line, diagnostic.location)[: max(0, room) + 1]


def _excerpt(diagnostic: Diagnostic) -> tuple[str, int]:
    """Return as much of the source line as fits on a screen, and the caret's column in it."""
    line = printable(diagnostic.source_line).rstrip()
    column = diagnostic.location.column
    if len(line) <= MAX_LINE_LENGTH:
        return line, column
    start = max(0, min(column - MAX_LINE_LENGTH // 2, len(line) - MAX_LINE_LENGTH))
    return line[start : start + MAX_LINE_LENGTH], max(0, column - start)
