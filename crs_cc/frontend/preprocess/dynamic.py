"""Macros whose value depends on their position: `__LINE__`, `__FILE__`, `__COUNTER__`.

>>> from pathlib import Path
>>> from crs_cc.frontend.preprocess.includes import Headers
>>> from crs_cc.frontend.preprocess.report import Report
>>> from crs_cc.frontend.preprocess.source_text import SourceMap
>>> from crs_cc.frontend.preprocess.options import Options
>>> from crs_cc.core.source import Diagnostics
>>> state = State(Report(Diagnostics(), SourceMap()), Headers(Path("."), Options()))
>>> {macro.name for macro in dynamic_macros(state)} >= {"__LINE__", "__FILE__"}
True
"""

from __future__ import annotations

import weakref
from collections.abc import Callable
from itertools import count

from crs_cc.frontend.preprocess.macros import Macro, dynamic_macro
from crs_cc.frontend.preprocess.state import State
from crs_cc.frontend.preprocess.tokens import NUMBER, STRING, Token


def dynamic_macros(run: State) -> list[Macro]:
    """Return these macros for a run; they do not keep it, as it keeps them."""
    state: State = weakref.proxy(run)
    counter = count()

    def line(token: Token) -> str:
        return str(state.report.source_map.location(token.position).line + state.reader.line_offset)

    values: dict[str, Callable[[Token], str]] = {
        "__LINE__": line,
        "__COUNTER__": lambda _: str(next(counter)),
        "__INCLUDE_LEVEL__": lambda _: str(len(state.readers) - 1),
    }
    names: dict[str, Callable[[Token], str]] = {
        "__FILE__": lambda _: state.reader.presumed_name,
        "__BASE_FILE__": lambda _: state.readers[0].name,
    }
    return [
        *(dynamic_macro(name, _maker(NUMBER, value)) for name, value in values.items()),
        *(dynamic_macro(name, _maker(STRING, _quoting(value))) for name, value in names.items()),
    ]


def _maker(kind: str, value: Callable[[Token], str]) -> Callable[[Token], Token]:
    def make(token: Token) -> Token:
        return Token(kind, value(token), token.position, token.spaced)

    return make


def _quoting(name: Callable[[Token], str]) -> Callable[[Token], str]:
    def quote(token: Token) -> str:
        escaped = name(token).replace("\\", "\\\\").replace('"', '\\"')
        return f'"{escaped}"'

    return quote
