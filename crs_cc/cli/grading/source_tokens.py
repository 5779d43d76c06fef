"""The tokens of a submission after preprocessing, with their source locations."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from crs_cc.core.source import Diagnostics, Location
from crs_cc.frontend.preprocess.preprocessor import Preprocessed, preprocess
from crs_cc.frontend.preprocess.tokens import Token, tokenise
from crs_cc.ir.names import in_library
from crs_cc.session.library import library_options


@dataclass(frozen=True, slots=True)
class SourceTokens:
    """The tokens of one file of a program, without those of headers that come with crs.

    Attributes:
        tokens: the tokens, whose places are columns.
        lines: the line of the preprocessed text that each comes from.
    """

    source: Preprocessed
    tokens: Sequence[Token]
    lines: Sequence[int]

    def location(self, number: int) -> Location:
        """Return the place of a token in the submission."""
        return self.source.location(self.lines[number], self.tokens[number].position + 1)


def tokens_of(path: Path) -> SourceTokens:
    """Return the tokens of a C file in the current directory, and of headers of its own."""
    source = preprocess(path, library_options(()), Diagnostics())
    found = list(_tokens(source))
    return SourceTokens(source, [token for _, token in found], [line for line, _ in found])


def _tokens(source: Preprocessed) -> Iterator[tuple[int, Token]]:
    for number, text in enumerate(source.text.splitlines(), 1):
        if text.strip() and _is_own(source.location(number, 0)):
            for token in tokenise(text, 0):
                yield number, token


def _is_own(place: Location) -> bool:
    """Return whether a place is in the submission: its files have relative names."""
    return not (in_library(place) or Path(place.file).is_absolute())
