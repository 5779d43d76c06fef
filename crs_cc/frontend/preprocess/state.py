"""The state of a preprocessor run: macros, open files, and remaining limits.

>>> from crs_cc.frontend.preprocess.macros import read_definition
>>> from crs_cc.frontend.preprocess.source_text import SourceMap
>>> from crs_cc.frontend.preprocess.tokens import tokenise
>>> from crs_cc.frontend.preprocess.options import Options
>>> from crs_cc.core.source import Diagnostics
>>> state = State(Report(Diagnostics(), SourceMap()), Headers(Path("."), Options()))
>>> state.define(read_definition(tokenise("SPEED 200", 0), state.report))
>>> [token.text for token in state.expand(tokenise("vm(SPEED)", 0))]
['vm', '(', '200', ')']
"""

from __future__ import annotations

from collections import ChainMap
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path, PurePath, PurePosixPath
from typing import Final

from crs_cc.frontend.preprocess import gnu
from crs_cc.frontend.preprocess.budget import Budget
from crs_cc.frontend.preprocess.expand import MacroUses, MoreTokens, expand
from crs_cc.frontend.preprocess.includes import Header, Headers
from crs_cc.frontend.preprocess.macros import DEFINED, Macro
from crs_cc.frontend.preprocess.output import WeakName
from crs_cc.frontend.preprocess.reader import Reader
from crs_cc.frontend.preprocess.regular_file import Refusal
from crs_cc.frontend.preprocess.report import Report
from crs_cc.frontend.preprocess.source_text import (
    Position,
    SourceText,
    decode,
    is_binary,
    printable,
    without_trigraphs,
)
from crs_cc.frontend.preprocess.tokens import Token

MAX_DEPTH: Final = 200
"""The maximum nesting depth of headers, as in gcc."""
MAX_CHARACTERS: Final = 32 << 20
"""The maximum size of all source in a run, counting each inclusion [characters]."""
FILE_COST: Final = 2048
"""The minimum size that an opened file counts for [characters]."""


@dataclass(slots=True, weakref_slot=True)
class State:
    """The state of a run.

    Attributes:
        report: receives messages about errors.
        headers: finds header files.
        macros: the macros, by name.
        watched: the words that a line must not contain in order to be copied unchanged.
        readers: the open files, the innermost last.
        once: the files with `#pragma once`.
        budget: the limit for macro expansion.
        characters_left: the remaining size of source.
        strict: whether the program is in ISO C, with trigraphs.
        is_c23: whether `true` is 1 in conditions.
        kept_macros: the stack of `#pragma push_macro` for each name.
        weak: the names of `#pragma weak`.
        pending: tokens from a directive, to be added to the program.
        uses: the macros that the program uses, by position.
    """

    report: Report
    headers: Headers
    macros: dict[str, Macro] = field(default_factory=dict)
    watched: set[str] = field(default_factory=lambda: set(gnu.WORDS))
    readers: list[Reader] = field(default_factory=list)
    once: set[Path] = field(default_factory=set)
    budget: Budget = field(default_factory=Budget)
    characters_left: int = MAX_CHARACTERS
    strict: bool = False
    is_c23: bool = False
    kept_macros: dict[str, list[Macro | None]] = field(default_factory=dict)
    weak: dict[str, WeakName] = field(default_factory=dict)
    pending: list[Token] = field(default_factory=list)
    uses: MacroUses = field(default_factory=dict)
    _texts: dict[Path, SourceText] = field(default_factory=dict)

    @property
    def reader(self) -> Reader:
        """The file that is being read."""
        return self.readers[-1]

    def define(self, macro: Macro) -> None:
        """Define a macro; report a redefinition that differs."""
        known = self.macros.get(macro.name)
        if known is not None and not known.same_as(macro):
            self.report.warning(
                macro.position, f"'{macro.name}' macro redefined", flag="macro-redefined"
            )
            if known.position:
                self.report.note(known.position, "previous definition is here")
        self.macros[macro.name] = macro
        self.watched.add(macro.name)

    def undefine(self, name: str) -> None:
        """Undefine a macro if there is one with this name."""
        if self.macros.pop(name, None) is not None and name not in gnu.WORDS:
            self.watched.discard(name)

    def expand(self, tokens: Sequence[Token], more: MoreTokens | None = None) -> list[Token]:
        """Replace all macros in tokens; `more` returns the next lines for a call that continues."""
        return expand(tokens, self.macros, self.budget, self.report, more, uses=self.uses)

    def expand_condition(self, tokens: Sequence[Token]) -> list[Token]:
        """Replace all macros in the expression of `#if`, except the operands of `defined`."""
        macros = ChainMap({DEFINED.name: DEFINED}, self.macros)
        return expand(tokens, macros, self.budget, self.report)

    def include(self, header: Header, position: Position) -> None:
        """Open a header, to be read next.

        Raises:
            StopError: headers are nested too deeply, or there is too much source.
        """
        if header.file in self.once:
            return
        if len(self.readers) > MAX_DEPTH:
            self.report.fatal(position, f"#include nested more than {MAX_DEPTH} deep")
        text = self._texts.get(header.file)
        if text is None:
            content = header.read()
            if isinstance(content, Refusal):
                self.report.error(position, f"'{header.path}' {content.text}", content.hint)
                return
            if is_binary(content):
                self.report.error(position, f"'{header.path}' is not a text file")
                return
            text = self._texts[header.file] = self.add_text(
                self.headers.options.name(header.path),
                decode(content),
                is_ours=header.content is not None or header.root in self.headers.system_paths,
            )
        self.open(text, header.path.parent, header, position)

    def add_text(self, name: str, content: str, *, is_ours: bool = False) -> SourceText:
        """Record the text of a file, so that messages can show its lines."""
        self.report.diagnostics.lines[name] = printable(content).split("\n")
        if self.strict:
            content = without_trigraphs(content)
        text = self.report.source_map.add(name, content, is_ours=is_ours)
        if text.unclosed_comment is not None:
            self.report.error(text.unclosed_comment, "unterminated comment: missing '*/'")
        return text

    def open(
        self, text: SourceText, folder: Path, header: Header | None, position: Position
    ) -> None:
        """Start to read a text; raise StopError if there is too much source."""
        self.characters_left -= text.size + FILE_COST
        self.budget.grow(text.size)
        if self.characters_left < 0:
            self.report.fatal(
                position, f"more than {MAX_CHARACTERS >> 20} million characters of source"
            )
        name = PurePath(text.name).name if header is None else header.name
        if header is not None and header.is_beside:
            name = str(PurePosixPath(self.reader.name).parent / name)
        self.readers.append(Reader(text, name, folder, header))
