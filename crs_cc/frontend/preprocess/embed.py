"""`#embed "file"`: the bytes of a file as a list of numbers (C23 6.10.3).

>>> numbers(b"ab")
'97,98'
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

from crs_cc.frontend.preprocess.condition import ConditionError
from crs_cc.frontend.preprocess.constants import constant
from crs_cc.frontend.preprocess.regular_file import Refusal
from crs_cc.frontend.preprocess.tokens import NUMBER, Token, shown

if TYPE_CHECKING:
    from crs_cc.frontend.preprocess.includes import Header
    from crs_cc.frontend.preprocess.source_text import Position
    from crs_cc.frontend.preprocess.state import State

MAX_EMBEDDED: Final = 1 << 17
"""The maximum size of an embedded file [bytes]: each byte becomes an initialiser."""

_PARAMETERS: Final = frozenset({"limit", "prefix", "suffix", "if_empty"})


def numbers(content: bytes) -> str:
    """Return bytes as a list of numbers."""
    return ",".join(map(str, content))


def embed(state: State, header: Header, tokens: Sequence[Token], position: Position) -> list[Token]:
    """Return the tokens that replace `#embed`; report its errors.

    Args:
        state: the run.
        header: the file.
        tokens: the parameters after its name, with their macros replaced.
        position: the position of the file's name.
    """
    try:
        parameters = _read(tokens)
        limit = _limit(parameters.get("limit"))
    except ConditionError as error:
        state.report.error(
            position if error.position is None else error.position, str(error), error.hint
        )
        return []
    content = header.read()
    if isinstance(content, Refusal):
        state.report.error(position, f"'{header.path}' {content.text}", content.hint)
        return []
    content = content[:limit]
    if not content:
        return parameters.get("if_empty", [])
    if len(content) > MAX_EMBEDDED:
        text = f"'{header.path}' is larger than {MAX_EMBEDDED} bytes"
        state.report.error(
            position, text, "limit(...) takes the first bytes; or read it at run time"
        )
        return []
    literal = Token(NUMBER, numbers(content), position, spaced=True)
    return [*parameters.get("prefix", []), literal, *parameters.get("suffix", [])]


def _read(tokens: Sequence[Token]) -> dict[str, list[Token]]:
    """Return the tokens in the parentheses of each parameter."""
    found: dict[str, list[Token]] = {}
    index = 0
    while index < len(tokens):
        name = tokens[index]
        if name.text.strip("_") not in _PARAMETERS:
            raise ConditionError(
                name.position, f"unknown parameter '{shown(name.text)}' of '#embed'"
            )
        inside: list[Token] = []
        depth, index = 0, index + 1
        while index < len(tokens):
            depth += {"(": 1, ")": -1}.get(tokens[index].text, 0)
            inside.append(tokens[index])
            index += 1
            if depth <= 0:
                break
        if depth or len(inside) < 2:
            text = f"'{name.text}' must be followed by its value in parentheses"
            raise ConditionError(name.position, text)
        found[name.text.strip("_")] = inside[1:-1]
    return found


def _limit(tokens: Sequence[Token] | None) -> int | None:
    if tokens is None:
        return None
    is_number = len(tokens) == 1 and tokens[0].kind == NUMBER
    value = constant(tokens[0]) if is_number else None
    if value is None or value.problem:
        position = tokens[0].position if tokens else None
        raise ConditionError(position, "'limit' of '#embed' must be a number")
    return value.number
