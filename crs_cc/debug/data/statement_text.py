"""The operands that a statement reads, found in its text.

>>> operands("tab[i + 1].x * *p + turn(speed, 3) - left->v")
['tab[i + 1].x', 'i', '*p', 'p', 'speed', 'left->v', 'left']
>>> source_of("speed = 2 * left; next = 1;"), source_of("total += x) {"), source_of("i++)")
(['left'], ['total', 'x'], ['i'])
>>> source_of("tab[i] = 3;"), source_of("return a + b;"), source_of("strcpy(name, other);")
(['i'], ['a', 'b'], ['name', 'other'])
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import Final

from crs_cc.debug.data.notation import operand_end, tokens

_WORDS: Final = frozenset({
    "auto", "case", "char", "const", "do", "double", "else", "enum", "float", "for", "if", "int",
    "long", "register", "return", "short", "signed", "sizeof", "static", "struct", "switch",
    "union", "unsigned", "void", "volatile", "while",
})  # fmt: skip
_NAME: Final = re.compile(
    r'"(?:[^"\\]|\\.)*"|\'(?:[^\'\\]|\\.)*\'|\.?\d[\w.]*|(?:\.|->)\s*\w+|(?P<name>[A-Za-z_]\w*)'
)
_ASSIGNS: Final = re.compile(r"(?<![=!<>])(?P<op><<|>>|[-+*/%&|^])?=(?!=)")
_STEP: Final = re.compile(r"\+\+|--")


def source_of(text: str, value_operands: Sequence[str] | None = None) -> list[str]:
    """Return the operands that a value was computed from.

    Args:
        text: the source from the assignment, declarator, `return` or call that made it; what comes
            after that does not matter.
        value_operands: the operands of its value, if they are known better.
    """
    text = cut(text)
    for found in _ASSIGNS.finditer(text):
        if _depth(text, found.start()) == 0:
            target, value = text[: found.start()], text[found.end() :]
            is_again = found["op"] is not None
            own = operands(target) if is_again else _inside(target)
            return list(dict.fromkeys([*own, *(value_operands or operands(value))]))
    return list(value_operands or operands(text))


def value_of(text: str) -> str:
    """Return the expression that a statement assigns or returns; empty for anything else.

    >>> value_of("told = *(int *)message.data;"), value_of("return a + 1;"), value_of("a += 2;")
    ('*(int *)message.data', 'a + 1', '')
    """
    if (found := cut(text).strip()).startswith("return"):
        return found.removeprefix("return").strip()
    return assignment(text)[1]


def assignment(text: str) -> tuple[str, str]:
    """Return target and value of an assignment or initialiser; empty for anything else.

    >>> assignment("left->at = points[i];"), assignment("a += 2;")
    (('left->at', 'points[i]'), ('', ''))
    """
    text = cut(text).strip()
    for found in _ASSIGNS.finditer(text):
        if _depth(text, found.start()) == 0:
            parts = text[: found.start()], text[found.end() :]
            return ("", "") if found["op"] is not None else (parts[0].strip(), parts[1].strip())
    return "", ""


def is_count(text: str) -> bool:
    """Return whether a statement changes a variable by itself: `i++`."""
    return bool(_STEP.search(cut(text))) and len(operands(cut(text))) == 1


def operands(text: str) -> list[str]:
    """Return the names, members, elements and targets of pointers that an expression reads."""
    return list(dict.fromkeys(_operands(text)))


def arguments(text: str) -> list[str]:
    """Return the arguments of the first call in a text.

    >>> arguments("speed = turn(a, f(b, c)) + 1")
    ['a', 'f(b, c)']
    """
    opened = re.search(r"[\w)]\s*\(", text)
    if opened is None:
        return []
    inside, parts = text[opened.end() :], [""]
    for piece, _, depth in tokens(inside):
        if depth < 0:
            break
        if piece == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += piece
    return [each.strip() for each in parts]


def argument(text: str, function: str, number: int) -> str:
    """Return an argument of a call; that of the first call if it is not clear which one is meant.

    >>> argument("speed = turn(a, f(b, c)) + 1", "f", 1), argument("(*op)(a + 1)", "turn", 0)
    ('c', 'a + 1')
    """
    found = list(re.finditer(rf"\b{re.escape(function)}\s*\(", text))
    passed = arguments(text[found[0].start() :] if len(found) == 1 else text)
    return passed[number] if number < len(passed) else ""


def cut(text: str) -> str:
    """Return a text up to the end of its statement, declarator or condition."""
    for token, at, depth in tokens(text):
        if depth < 0 or (depth == 0 and token in {";", ",", "{"} and at):
            return text[:at]
    return text


def without_call(text: str, function: str) -> str:
    """Return a text without the last call of a function.

    >>> without_call("a + turn(b, c(d)) * e", "turn")
    'a +  * e'
    """
    found = list(re.finditer(rf"\b{re.escape(function)}\s*\(", text))
    if not found:
        return text
    inside = text[found[-1].end() :]
    end = next((at for piece, at, depth in tokens(inside) if depth < 0), len(inside))
    return text[: found[-1].start()] + inside[end + 1 :]


def calls(text: str) -> list[str]:
    """Return the names that are called in a text."""
    return re.findall(r"([A-Za-z_]\w*)\s*\(", text)


def _operands(text: str) -> Iterator[str]:
    for found in _NAME.finditer(text):
        name, start = found["name"], found.start()
        if name is None or name in _WORDS or re.match(r"\s*\(", text[found.end() :]):
            continue
        if re.search(r"&\s*$", text[:start]) and not re.search(r"[\w)\]&]\s*&\s*$", text[:start]):
            continue  # only its address
        end = operand_end(text, start)
        stars = re.search(r"(?:^|[^\w)\]\s])\s*(?P<stars>\*+)\s*$", text[:start])
        operand = text[start:end]
        if stars is not None:
            yield stars["stars"] + operand
        yield operand
        if "->" in operand:
            yield operand[: operand.rindex("->")]


def _inside(target: str) -> list[str]:
    """Return the operands that determine the assigned object: its indices and pointers."""
    own = _STEP.sub("", target).strip()
    return [each for each in operands(target) if each != own and not own.endswith(f" {each}")]


def _depth(text: str, at: int) -> int:
    return sum((each in "([{") - (each in ")]}") for each in text[:at])
