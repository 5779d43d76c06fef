"""Messages of the XML schema validator, rewritten for the author of the file.

>>> explain("Element 'wal': This element is not expected. Expected is one of ( wall, box ).")
('unexpected element <wal>; expected <wall> or <box>', 'did you mean <wall>?')
>>> explain("Element 'wall': The attribute 'x1' is required but missing.")
("missing attribute 'x1' in <wall>", '')
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable
from typing import Final, TypeAlias

_PREFIX: Final = re.compile(r"Element '([^']*)'(?:, attribute '([^']*)')?: (.*)", re.DOTALL)
_Explainer: TypeAlias = Callable[[str, re.Match[str]], tuple[str, str]]


def explain(message: str) -> tuple[str, str]:
    """Return the text and the hint for a message of the schema validator (libxml2)."""
    parts = _PREFIX.match(message)
    if parts is None:
        return message, ""
    for pattern, explainer in _RULES:
        match = pattern.search(parts[3])
        if match is not None:
            return explainer(parts[1], match)
    return message, ""


def _unexpected(tag: str, match: re.Match[str]) -> tuple[str, str]:
    expected = [name.strip() for name in (match[1] or "").split(",") if name.strip()]
    near = difflib.get_close_matches(tag, expected, n=1)
    names = " or ".join(f"<{name}>" for name in expected) or "nothing more"
    hint = f"did you mean <{near[0]}>?" if near else ""
    return f"unexpected element <{tag}>; expected {names}", hint


def _missing_child(tag: str, match: re.Match[str]) -> tuple[str, str]:
    names = " or ".join(f"<{name.strip()}>" for name in match[1].split(","))
    return f"missing element in <{tag}>; expected {names}", ""


def _missing_attribute(tag: str, match: re.Match[str]) -> tuple[str, str]:
    return f"missing attribute {match[1]!r} in <{tag}>", ""


def _unknown_attribute(tag: str, match: re.Match[str]) -> tuple[str, str]:
    return f"unknown attribute {match[1]!r} in <{tag}>", ""


def _not_of_set(tag: str, match: re.Match[str]) -> tuple[str, str]:
    expected = match[2].replace("'", "").replace(", ", " or ")
    return f"<{tag}>: invalid value {match[1]!r}; expected {expected}", ""


def _text(tag: str, _: re.Match[str]) -> tuple[str, str]:
    return f"text is not allowed in <{tag}>", ""


def _wrong_root(tag: str, _: re.Match[str]) -> tuple[str, str]:
    return f"unexpected root element <{tag}>", ""


_RULES: Final[tuple[tuple[re.Pattern[str], _Explainer], ...]] = (
    (re.compile(r"not expected\.(?: Expected is (?:one of )?\( (.*) \)\.)?"), _unexpected),
    (re.compile(r"Missing child element.*Expected is (?:one of )?\( (.*) \)"), _missing_child),
    (re.compile(r"attribute '([^']*)' is required"), _missing_attribute),
    (re.compile(r"attribute '([^']*)' is not allowed"), _unknown_attribute),
    (re.compile(r"value '([^']*)' is not an element of the set \{(.*)\}"), _not_of_set),
    (re.compile(r"Character content"), _text),
    (re.compile(r"No matching global declaration"), _wrong_root),
)
