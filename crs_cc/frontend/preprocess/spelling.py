r"""Conversion of preprocessing tokens to tokens of C (C17 5.1.1.2, phase 7).

Preprocessing tokens may be anything; after preprocessing there must only be tokens of C. Spellings
that the parser does not know are replaced: digraphs, unknown escape sequences as in `"100\%"`,
bytes that are not UTF-8, letters outside ASCII in names. Others are errors.

>>> is_plain('printf("%d\\n", a[i] >> 2); /'), is_plain('"100\\%"'), is_plain("a <: 0x1G")
(True, False, False)
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Final

from crs_cc.frontend.preprocess.constants import INTEGER, SUFFIX
from crs_cc.frontend.preprocess.report import Report
from crs_cc.frontend.preprocess.tokens import (
    CHARACTER,
    HASH,
    NAME,
    NUMBER,
    PASTE,
    PUNCTUATOR,
    STRING,
    UNCLOSED,
    Token,
    shown,
)

_EXPONENT: Final = "[eE][+-]?[0-9]+"
_FLOATING: Final = (
    rf"(?:(?:[0-9]+\.[0-9]*|\.[0-9]+)(?:{_EXPONENT})?|[0-9]+{_EXPONENT}"
    r"|0[xX](?:[0-9a-fA-F]++\.?[0-9a-fA-F]*+|\.[0-9a-fA-F]+)[pP][+-]?[0-9]+)[fFlL]?"
)
_FLOATING_NUMBER: Final = re.compile(_FLOATING)
_INTEGER: Final = rf"(?:0[xX][0-9a-fA-F]+|0[bB][01]+|0[0-7]*|[1-9][0-9]*){SUFFIX}"

_IMAGINARY: Final = re.compile(rf"(?:{_FLOATING}|{_INTEGER})[ijIJ][fFlL]?")
"""An imaginary constant of GNU C."""

_ESCAPED: Final = r"[0-7abefnrtvxuUE\\?'\"]"
"""The characters with a meaning after a backslash (C17 6.4.4.4), and gcc's `\\e`."""
_IN_STRING: Final = rf"[^\"\\\udc80-\udcff]|\\{_ESCAPED}"
_NUMBERED: Final = r"[0-7]{1,3}|x[0-9a-fA-F]+|u[0-9a-fA-F]{4}|U[0-9a-fA-F]{8}"
_IN_CHARACTER: Final = rf"[^'\\\udc80-\udcff]|\\(?:{_NUMBERED}|{_ESCAPED})"

_PLAIN: Final = re.compile(
    r"(?>(?:[ \t\v\f]++"
    r"|[A-Za-z_$][\w$]*+(?![\"'])"
    rf"|(?:{_FLOATING}|{_INTEGER})(?![\w.]|(?<=[eEpP])[+-])"
    rf"|\"(?:{_IN_STRING})*\""
    rf"|'(?:{_IN_CHARACTER})'"
    r"|[-+*/&|^~!>=?;,.(){}\[\]]|<(?![:%])|:(?!>)|%(?![:>]))*)",
    re.ASCII,
)
_DIGRAPHS: Final = {"<:": "[", ":>": "]", "<%": "{", "%>": "}"}
_TYPOGRAPHY: Final = (
    dict.fromkeys("\u201c\u201d\u201e\u201f\xab\xbb", '"')
    | dict.fromkeys("\u2018\u2019\u201a\u201b", "'")
    | dict.fromkeys("\u2010\u2011\u2012\u2013\u2014\u2212", "-")
    | {"\u2026": "...", "\u2264": "<=", "\u2265": ">=", "\u2260": "!=", "\xd7": "*"}
    | {"\xa0": "a space"}
)
"""The characters that word processors substitute for those of C."""

_ODD_PUNCTUATORS: Final = frozenset(_DIGRAPHS) | HASH | PASTE
_UNKNOWN_ESCAPE: Final = re.compile(rf"\\(?:({_ESCAPED})|(.))|([\udc80-\udcff])")
_ONE_CHARACTER: Final = re.compile(_IN_CHARACTER)
_UNIVERSAL: Final = re.compile(r"\\(?:u([0-9a-fA-F]{4})|U([0-9a-fA-F]{8}))|([^\x00-\x7f])")


def is_plain(line: str) -> bool:
    """Return whether the parser accepts all tokens of a line."""
    return _PLAIN.fullmatch(line) is not None


def respell(tokens: Sequence[Token], report: Report) -> list[Token]:
    """Return tokens for the parser; report and drop those that are not C."""
    result = []
    for token in tokens:
        kind = token.kind
        if kind == PUNCTUATOR and token.text not in _ODD_PUNCTUATORS:
            result.append(token)
            continue
        if kind == NAME:
            text: str | None = _ascii_name(token.text)
        elif kind == NUMBER:
            text = _number(token, report)
        elif kind in (STRING, CHARACTER):
            text = _quoted(token, report)
        else:
            text = _odd(token, report)
        if text is not None:
            result.append(token if text == token.text else token.respelled(text))
    return result


def _odd(token: Token, report: Report) -> str | None:
    """Return the usual spelling of a digraph; report any other unusual token."""
    if token.text in _DIGRAPHS:
        return _DIGRAPHS[token.text]
    if token.kind == PUNCTUATOR:
        report.error(token.position, f"stray '{token.text}' in the program")
    elif token.kind == UNCLOSED:
        quote = token.text[0]
        hint = "close the string at the end of the line and open it again on the next"
        wrong = next((each for each in token.text if _TYPOGRAPHY.get(each) == quote), "")
        if wrong:
            hint = f"write {quote} instead of {wrong}"
        report.error(
            token.position,
            f"missing terminating {quote} on this line",
            hint if quote == '"' or wrong else "",
        )
    else:
        character = token.text[0]
        wanted = _TYPOGRAPHY.get(character)
        hint = f"write {wanted}" if wanted is not None else ""
        report.error(token.position, f"unexpected character '{shown(character)}'", hint)
    return None


def _ascii_name(name: str) -> str:
    """Return a name with each letter outside ASCII replaced by `$u` and its number."""
    if name.isascii() and "\\" not in name:
        return name

    def code(match: re.Match[str]) -> str:
        digits = match[1] or match[2]
        return f"$u{int(digits, 16) if digits else ord(match[3]):04x}"

    return _UNIVERSAL.sub(code, name)


def _number(token: Token, report: Report) -> str:
    text = token.text.replace("'", "")
    if INTEGER.fullmatch(text) or _IMAGINARY.fullmatch(text) or _FLOATING_NUMBER.fullmatch(text):
        return text
    hint = ""
    if text.isdigit():
        problem = "a number that starts with 0 is octal and cannot have the digits 8 and 9"
    elif text[-2:-1] in tuple("eEpP") or "+" in text or "-" in text:
        problem = f"'{shown(text)}' is not a number"
        hint = "put spaces around '+' and '-'"
    elif (start := re.match(f"{_FLOATING}|{_INTEGER}", text)) and start.end():
        problem = f"'{shown(text[start.end() :])}' cannot end the number {shown(start.group())}"
    else:
        problem = f"'{shown(text)}' is not a number"
    report.error(token.position, problem, hint)
    return "0"


def _quoted(token: Token, report: Report) -> str:
    """Return a string literal or character constant with standard escape sequences."""
    text = token.text
    if token.kind == CHARACTER:
        size = len(_ONE_CHARACTER.findall(text.partition("'")[2][:-1]))
        if size == 0 or size > 4:
            problem = "empty character constant" if size == 0 else "character constant is too long"
            hint = "" if size == 0 else 'use double quotes for a string: "..."'
            report.error(token.position, problem, hint)
            return "'0'"

    def known(match: re.Match[str]) -> str:
        if match[1]:
            return match.group()
        character = match[2] or match[3]
        if "\udc80" <= character <= "\udcff":
            return f"\\{ord(character) - 0xDC00:03o}"  # the byte as it is in the file
        report.warning(
            token.position,
            f"unknown escape sequence '\\{shown(character)}'",
            flag="unknown-escape-sequence",
        )
        return character

    return _UNKNOWN_ESCAPE.sub(known, text)
