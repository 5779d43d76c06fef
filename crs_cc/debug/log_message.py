"""The messages of log points: text with expressions in braces.

`{speed}` is replaced by the value as `print` shows it. A conversion specification in front of the
expression, as in `{%5.1f speed}`, formats it as `printf` does; `{%*d width, speed}` has its width
from an expression, too.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from typing import Final

from crs_cc.debug.commands.arguments import split_arguments
from crs_cc.debug.commands.c_format import CONVERSION, formatted_text
from crs_cc.debug.data.notation import slice_in
from crs_cc.debug.data.values import Value
from crs_cc.debug.errors import DebugError

_BRACES: Final = re.compile(r"\{([^{}]*)\}")


def message(text: str, evaluate: Callable[[str], Value]) -> str:
    """Return the message of a log point; a value that cannot be had is the reason in `<>`.

    Args:
        text: the text with expressions in braces.
        evaluate: returns the value of an expression, or raises DebugError.
    """

    def shown(found: re.Match[str]) -> str:
        conversion, expressions = _parts(found[1])
        try:
            values = [evaluate(each) for each in expressions]
            return formatted_text(conversion, values) if conversion else values[0].text
        except DebugError as error:
            return f"<{error}>"

    return _BRACES.sub(shown, text)


def expressions_in(text: str) -> Iterator[str]:
    """Return the expressions in the text of a log point; of a slice, its parts.

    Raises:
        DebugError: one is missing.
    """
    for found in _BRACES.findall(text):
        for each in _parts(found)[1]:
            if not each:
                raise DebugError("an expression is missing in {}")
            part = slice_in(each)
            yield from (each,) if part is None else filter(None, (part.base, part.first, part.last))


def _parts(content: str) -> tuple[str, list[str]]:
    """Return the conversion specification in braces, which may be empty, and the expressions."""
    text = content.strip()
    found = CONVERSION.match(text)
    if found is None or found["kind"] is None:
        return "", [text]
    return found[0], split_arguments(text[found.end() :])
