"""Descriptions of differences: the element or member that differs, and by how much."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Final

from crs_cc.debug.branch_comparison import Difference

_NUMBER: Final = re.compile(r"(?<![\w.])-?(?:\d[\d,]*\d|\d)?\.?\d+(?:e[-+]?\d+)?(?![\w.])")
_WORDS: Final = re.compile(r"[^\W\d_]+")
_UNITS: Final = frozenset({"m", "cm", "mm", "in", "deg", "rad", "s", "ms", "V", "W", "J", "C"})


def narrowed(difference: Difference) -> Difference:
    """Return the difference of the one element or member in which two values differ.

    >>> narrowed(Difference("ada", "ring", "{1, 2, 3}", "{1, 5, 3}"))
    Difference(robot='ada', name='ring[1]', here='2', there='5')
    >>> narrowed(Difference("ada", "goal", "{x = 1, to = {4, 4}}", "{x = 1, to = {4, 5}}"))
    Difference(robot='ada', name='goal.to[1]', here='4', there='5')
    >>> narrowed(Difference("ada", "ring", "{1, 2, 3}", "{7, 5, 3}")).name
    'ring'
    """
    here, there = _elements(difference.here), _elements(difference.there)
    differing = [at for at, each in enumerate(zip(here, there, strict=False)) if each[0] != each[1]]
    if len(here) != len(there) or len(differing) != 1:
        return difference
    at = differing[0]
    (member, is_member, one), (other, _, two) = (
        here[at].partition(" = "),
        there[at].partition(" = "),
    )
    if is_member and member == other and member.isidentifier():
        part, values = f".{member}", (one, two)
    elif "<repeats" in difference.here + difference.there:
        return difference  # places are not those of elements
    else:
        part, values = f"[{at}]", (here[at], there[at])
    name = difference.name + part
    return narrowed(replace(difference, name=name, here=values[0], there=values[1]))


def _elements(text: str) -> list[str]:
    """Return the elements of a value in braces; none of another one."""
    if not (text.startswith("{") and text.endswith("}")):
        return []
    found, depth, quote, begin = list[str](), 0, "", 1
    for at, letter in enumerate(text[1:-1], 1):
        if quote:
            quote = "" if letter == quote and text[at - 1] != "\\" else quote
        elif letter in "\"'":
            quote = letter
        elif letter == "," and not depth:
            found.append(text[begin:at].strip())
            begin = at + 1
        depth += 0 if quote else (letter in "{[(") - (letter in "}])")
    return [*found, text[begin:-1].strip()]


def by(here: str, there: str) -> str:
    """Return the difference of two values; empty if they are not numbers with the same units.

    >>> by("1.250 m", "1.5 m"), by("3", "7"), by("yes", "no"), by("1 m", "2 deg")
    ('0.25 m', '4', '', '')
    >>> by("3.200, 4.678 m, 90.0 deg", "3.200, 4.700 m, 88.0 deg")
    '0, 0.022 m, 2 deg'
    """
    numbers = _NUMBER.findall(here), _NUMBER.findall(there)
    form = _NUMBER.sub("#", here)
    if not numbers[0] or form != _NUMBER.sub("#", there):
        return ""
    if not _UNITS.issuperset(_WORDS.findall(form)):
        return ""
    ways = iter(abs(_number(one) - _number(other)) for one, other in zip(*numbers, strict=True))
    return _NUMBER.sub(lambda _: f"{next(ways):.6g}", here)


def _number(text: str) -> float:
    return float(text.replace(",", ""))
