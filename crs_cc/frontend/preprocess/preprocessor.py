r"""The C preprocessor: from a file to C without directives, comments and macros.

A line without macros is copied. Any other is split into tokens, its macros are replaced, GNU
syntax is rewritten, and the tokens are written out. `Preprocessed.location` maps positions of the
result to the user's file, line and column.

>>> messages = Diagnostics()
>>> program = preprocess_text("#define FAST 200\nvm(FAST, 0);\n", "a.c", Options(), messages)
>>> program.text
'vm(200, 0);\n'
>>> str(program.location(1, 9))
'a.c:2:10'
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Final

from crs_cc.core.source import Diagnostics, Location
from crs_cc.frontend.preprocess import conditionals
from crs_cc.frontend.preprocess.budget import ExhaustedError
from crs_cc.frontend.preprocess.directives import execute_pragma, run_directive
from crs_cc.frontend.preprocess.dynamic import dynamic_macros
from crs_cc.frontend.preprocess.gnu import GnuSyntax
from crs_cc.frontend.preprocess.includes import Headers
from crs_cc.frontend.preprocess.options import DIALECT_HEADERS, Options, is_c23
from crs_cc.frontend.preprocess.output import Preprocessed, Writer
from crs_cc.frontend.preprocess.predefined import ORIGIN, predefined_macros
from crs_cc.frontend.preprocess.regular_file import Refusal, read_regular_file
from crs_cc.frontend.preprocess.report import Report, StopError
from crs_cc.frontend.preprocess.source_text import Position, SourceMap, decode, is_binary
from crs_cc.frontend.preprocess.spelling import is_plain, respell
from crs_cc.frontend.preprocess.state import State
from crs_cc.frontend.preprocess.tokens import Token, tokenise

__all__ = ["Options", "Preprocessed", "preprocess", "preprocess_text"]

_WORD: Final = re.compile(r"[A-Za-z_$][\w$]*")
_COMMAND_LINE: Final = "<command line>"


def preprocess(path: Path, options: Options, diagnostics: Diagnostics) -> Preprocessed:
    """Preprocess a C file (C17 5.1.1.2, phases 1 to 4).

    Args:
        path: the file.
        options: header directories and macro definitions.
        diagnostics: receives all messages, and the lines of each file that is read. If there are
            errors, the result must not be compiled.
    """
    content = read_regular_file(path)
    if isinstance(content, Refusal):
        diagnostics.error(Location(options.name(path)), content.text, content.hint)
        return replace(_preprocess("", path, options, diagnostics), is_complete=False)
    if is_binary(content):
        diagnostics.error(
            Location(options.name(path)), "is not a text file", "give the name of a C source file"
        )
        return replace(_preprocess("", path, options, diagnostics), is_complete=False)
    return _preprocess(decode(content), path, options, diagnostics)


def preprocess_text(
    text: str, name: str, options: Options, diagnostics: Diagnostics
) -> Preprocessed:
    """Preprocess a program that is given as text.

    Args:
        text: the program.
        name: its file name, for messages and as the directory of headers in quotes.
        options: header directories and macro definitions.
        diagnostics: receives all messages, and the lines of each file that is read.
    """
    try:
        content = decode(text.encode("utf-8", "surrogateescape"))
    except UnicodeEncodeError:  # lone surrogates, which represent no byte
        content = decode(text.encode("utf-8", "replace"))
    return _preprocess(content, Path(name), options, diagnostics)


def _preprocess(
    content: str, path: Path, options: Options, diagnostics: Diagnostics
) -> Preprocessed:
    run = _Run(path.parent, options, diagnostics)
    result = run.finish(lambda: run.read(content, path))
    state = run.state
    return replace(
        result, macros=dict(state.macros), uses=state.uses, weak=state.weak, more=run.read_more
    )


class _Run:
    """One run over a main file and its headers."""

    def __init__(self, folder: Path, options: Options, diagnostics: Diagnostics) -> None:
        self.folder = folder
        report = Report(diagnostics, SourceMap())
        report.source_map.add(ORIGIN, "")
        self.state = state = State(report, Headers(folder, options, diagnostics.digests))
        state.strict = options.is_strict
        state.is_c23 = is_c23(options.standard)
        self.options = options
        self.writer = Writer()
        self.gnu = GnuSyntax(
            report, lambda tokens: execute_pragma(state, tokens), strict=options.is_strict
        )

    def read(self, content: str, path: Path) -> None:
        """Read all files."""
        state = self.state
        for macro in (*predefined_macros(self.options.standard), *dynamic_macros(state)):
            state.define(macro)
        main = state.add_text(self.options.name(path), content)
        state.open(main, path.parent, None, main.start)
        self._include_dialect(path.parent)
        self._define_options(path.parent)
        self._read_all()

    def read_more(self, name: str, content: str) -> Preprocessed:
        """Preprocess another text with the macros at the end of the main file."""
        self.writer = Writer()

        def read() -> None:
            text = self.state.add_text(name, content)
            self.state.open(text, self.folder, None, text.start)
            self._read_all()

        return self.finish(read)

    def finish(self, read: Callable[[], None]) -> Preprocessed:
        """Return the output after `read`, which may have stopped early."""
        report = self.state.report
        try:
            read()
        except ExhaustedError as error:
            hint = "macros that use each other twice double the text at every step"
            location = report.source_map.location(error.position)
            report.diagnostics.error(location, "macro expansion is too large", hint)
            report.is_complete = False
        except StopError:  # the reason is in the diagnostics
            report.is_complete = False
        return replace(self.writer.finish(report.source_map), is_complete=report.is_complete)

    def _read_all(self) -> None:
        while self.state.readers:
            line = self._next_line()
            if line is None:
                self._close_file()
            else:
                self._write(*line)
        self.gnu.finish()

    def _define_options(self, folder: Path) -> None:
        """Open a text with the directives for `-D` and `-U`, to be read before the main file."""
        lines: list[str] = []
        for definition in self.options.defines:
            name, equals, value = definition.partition("=")
            lines.append(f"#define {name} {value if equals else '1'}")
        lines += [f"#undef {name}" for name in self.options.undefines]
        if not lines:
            return
        text = self.state.add_text(
            _COMMAND_LINE, "\n".join(each.replace("\n", " ") for each in lines)
        )
        self.state.open(text, folder, None, text.start)

    def _include_dialect(self, folder: Path) -> None:
        """Open the header of a dialect, to be read before the main file."""
        name = DIALECT_HEADERS.get(self.options.dialect)
        if name is not None:
            found = self.state.headers.find(name, quoted=False, folder=folder)
            assert not isinstance(found, Refusal), found.text
            self.state.include(found, self.state.reader.text.start)

    def _next_line(self) -> tuple[str, Position] | None:
        """Return the next line of the innermost file that is not a directive, None at its end."""
        state = self.state
        while (line := state.reader.next_line()) is not None:
            text, position = line
            if ("#" in text or "%:" in text) and run_directive(state, text, position):
                self.writer.tokens(state.pending)
                state.pending.clear()
                continue
            if text and not state.reader.skipping and not text.isspace():
                return line
        return None

    def _close_file(self) -> None:
        conditionals.close_all(self.state.readers.pop(), self.state.report)

    def _write(self, text: str, position: Position) -> None:
        """Preprocess a line, with the following ones that it needs, and write the result."""
        untouched = self.state.watched.isdisjoint(_WORD.findall(text))
        if untouched and is_plain(text) and not self.gnu.is_open:
            self.writer.line(text, position)
            return
        tokens = tokenise(text, position)
        if not untouched:
            depth = len(self.state.readers)
            tokens = self.state.expand(tokens, lambda: self._more(depth))
        tokens = self.gnu.rewrite(tokens, lambda: self.writer.tail(500))
        self.writer.tokens(respell(tokens, self.state.report))

    def _more(self, depth: int) -> list[Token] | None:
        """Return the tokens of the next line for a call that continues, None at the file's end.

        Args:
            depth: how many files were open at the start of the call.
        """
        while (line := self._next_line()) is None:
            if len(self.state.readers) <= depth:
                return None
            self._close_file()
        tokens = tokenise(*line)
        return [tokens[0].moved(tokens[0].position, spaced=True), *tokens[1:]]
