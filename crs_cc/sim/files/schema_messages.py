"""What the XML schema says about a file, in words for the person who wrote the file.

>>> explain("Element 'wal': This element is not expected. Expected is one of ( wall, box ).")
('<wal> is not expected here; expected <wall> or <box>', 'did you mean <wall>?')
>>> explain("Element 'wall': The attribute 'x1' is required but missing.")
("<wall> lacks the attribute 'x1'", '')
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable
from typing import Final, TypeAlias

_PREFIX: Final = re.compile(r"Element '([^']*)'(?:, attribute '([^']*)')?: (.*)", re.DOTALL)
_Explainer: TypeAlias = Callable[[str, re.Match[str]], tuple[str, str]]


def explain(message: str) -> tuple[str, str]:
    """Gives the text and the hint for a message of the schema validator (libxml2)."""
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
    return f"<{tag}> is not expected here; expected {names}", hint


def _missing_child(tag: str, match: re.Match[str]) -> tuple[str, str]:
    names = " or ".join(f"<{name.strip()}>" for name in match[1].split(","))
    return f"<{tag}> ends too early; expected {names} in it", ""


def _missing_attribute(tag: str, match: re.Match[str]) -> tuple[str, str]:
    return f"<{tag}> lacks the attribute {match[1]!r}", ""


def _unknown_attribute(tag: str, match: re.Match[str]) -> tuple[str, str]:
    return f"<{tag}> has no attribute {match[1]!r}", ""


def _not_of_set(tag: str, match: re.Match[str]) -> tuple[str, str]:
    expected = match[2].replace("'", "").replace(", ", " or ")
    return f"<{tag}>: {match[1]!r} is not expected; expected {expected}", ""


def _text(tag: str, _: re.Match[str]) -> tuple[str, str]:
    return f"<{tag}> holds text where only elements may stand", ""


def _wrong_root(tag: str, _: re.Match[str]) -> tuple[str, str]:
    return f"the outermost element is <{tag}>", ""


_RULES: Final[tuple[tuple[re.Pattern[str], _Explainer], ...]] = (
    (re.compile(r"not expected\.(?: Expected is (?:one of )?\( (.*) \)\.)?"), _unexpected),
    (re.compile(r"Missing child element.*Expected is (?:one of )?\( (.*) \)"), _missing_child),
    (re.compile(r"attribute '([^']*)' is required"), _missing_attribute),
    (re.compile(r"attribute '([^']*)' is not allowed"), _unknown_attribute),
    (re.compile(r"value '([^']*)' is not an element of the set \{(.*)\}"), _not_of_set),
    (re.compile(r"Character content"), _text),
    (re.compile(r"No matching global declaration"), _wrong_root),
)
