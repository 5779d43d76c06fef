"""Macros, and the parser of `#define` (C17 6.10.3).

The body is analysed once, when the macro is defined: `Macro.parts` describes the replacement of
each of its parts.

>>> from crs_cc.frontend.preprocess.source_text import SourceMap
>>> from crs_cc.frontend.preprocess.tokens import tokenise
>>> from crs_cc.core.source import Diagnostics
>>> report = Report(Diagnostics(), SourceMap())
>>> macro = read_definition(tokenise("JOIN(a, b) x = a ## b + #a", 0), report)
>>> [(part.kind, part.token.text, part.pasted) for part in macro.parts][2:5]
[('raw', 'a', False), ('raw', 'b', True), ('token', '+', False)]
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Final, Literal

from crs_cc.frontend.preprocess.report import Report
from crs_cc.frontend.preprocess.source_text import Position
from crs_cc.frontend.preprocess.tokens import HASH, NAME, PASTE, PUNCTUATOR, Token, shown

VARIADIC: Final = "__VA_ARGS__"
OPTIONAL: Final = "__VA_OPT__"
FEATURE_TESTS: Final = frozenset({"__has_include", "__has_embed", "__has_c_attribute"})
"""The operators of `#if` that ask for features, which `#ifdef` takes for macros."""

RESERVED: Final = frozenset({"defined", VARIADIC, OPTIONAL}) | FEATURE_TESTS
"""Names that cannot be macros."""

PartKind = Literal["token", "argument", "raw", "string", "rest", "optional"]


@dataclass(frozen=True, slots=True)
class Part:
    """A part of a macro's body.

    Attributes:
        kind: its replacement: the token itself; the expanded argument; the argument as written,
            beside `##`; the argument as a string, after `#`; the last argument of GNU's
            `, ## args`; the inside of `__VA_OPT__(...)`.
        token: the token in the body.
        argument: the index of the argument.
        pasted: whether it follows `##`.
        inside: the parts inside `__VA_OPT__`.
        quoted: whether `__VA_OPT__` follows `#`.
    """

    kind: PartKind
    token: Token
    argument: int = -1
    pasted: bool = False
    inside: tuple[Part, ...] = ()
    quoted: bool = False


@dataclass(frozen=True, slots=True)
class Macro:
    """A macro.

    Attributes:
        parameters: the names of its parameters; None for an object-like macro.
        variadic: whether the last parameter receives all remaining arguments.
        body: the tokens of its definition.
        parts: the replacement of the body.
        expanded: the indices of the arguments that must be expanded.
        pastes: whether its body contains `##`.
        position: the position of its definition.
        dynamic: for `__LINE__` and the like, the function that returns its value.
    """

    name: str
    parameters: tuple[str, ...] | None
    variadic: bool
    body: tuple[Token, ...]
    parts: tuple[Part, ...]
    expanded: tuple[int, ...]
    pastes: bool
    position: Position
    dynamic: Callable[[Token], Token] | None = None

    def same_as(self, other: Macro) -> bool:
        """Return whether another definition has the same tokens (C17 6.10.3p2)."""
        return (
            self.dynamic is other.dynamic
            and self.parameters == other.parameters
            and self.variadic == other.variadic
            and [token.text for token in self.body] == [token.text for token in other.body]
            and [token.spaced for token in self.body[1:]]
            == [token.spaced for token in other.body[1:]]
        )

    @property
    def definition(self) -> str:
        """The directive that defines it."""
        names = list(self.parameters or ())
        if self.variadic:
            names[-1] = f"{names[-1].removeprefix(VARIADIC)}..."
        signature = "" if self.parameters is None else f"({', '.join(names)})"
        body = "".join(f"{' ' * token.spaced}{token.text}" for token in self.body)
        return f"#define {self.name}{signature} {body.strip()}".rstrip()


def dynamic_macro(name: str, value: Callable[[Token], Token]) -> Macro:
    """Return an object-like macro whose value is computed at each use."""
    return Macro(name, None, False, (), (), (), False, 0, value)


DEFINED: Final = Macro("defined", None, False, (), (), (), False, 0)
"""A macro for the operator of `#if`: the name after it is not replaced."""


def read_definition(tokens: Sequence[Token], report: Report) -> Macro | None:
    """Parse the tokens after `#define`; return None if they are not a definition."""
    name = tokens[0]
    if name.kind != NAME:
        report.error(name.position, f"macro name must be an identifier, not '{shown(name.text)}'")
        return None
    if name.text in RESERVED:
        report.error(name.position, f"'{name.text}' cannot be the name of a macro")
        return None
    if len(tokens) > 1 and tokens[1].text == "(" and not tokens[1].spaced:
        signature = _read_parameters(tokens, report)
        if signature is None:
            return None
        parameters, variadic, start = signature
    else:
        parameters, variadic, start = None, False, 1
        if len(tokens) > 1 and not tokens[1].spaced:
            report.warning(
                tokens[1].position,
                "missing white space after the macro's name",
                flag="missing-space",
            )
    reader = _BodyReader(tokens[start:], parameters, variadic, report)
    parts = reader.read()
    if parts is None:
        return None
    return Macro(
        name.text,
        parameters,
        variadic,
        tuple(tokens[start:]),
        parts,
        tuple(sorted(reader.expanded)),
        any(part.pasted for part in parts),
        name.position,
    )


def _read_parameters(
    tokens: Sequence[Token], report: Report
) -> tuple[tuple[str, ...], bool, int] | None:
    """Parse the parameters, which start at the third token.

    Returns:
        Their names, whether the last one is variadic, and the index of the body's first token.
    """
    names: dict[str, None] = {}  # in order
    variadic = False
    expected = "a parameter or ')'"
    for index, token in enumerate(tokens[2:], 2):
        if token.text == ")" and expected != "a parameter":
            return tuple(names), variadic, index + 1
        if token.text == "," and expected == "',' or ')'":
            expected = "a parameter"
        elif token.text == "..." and "parameter" in expected:
            names[VARIADIC] = None
            variadic, expected = True, "')'"
        elif token.text == "..." and expected == "',' or ')'" and tokens[index - 1].kind == NAME:
            variadic, expected = True, "')'"  # GNU: a name for the variadic parameter
        elif token.kind == NAME and "parameter" in expected:
            if token.text in names or token.text in (VARIADIC, OPTIONAL):
                report.error(token.position, f"'{shown(token.text)}' cannot be a parameter here")
                return None
            names[token.text] = None
            expected = "',' or ')'"
        else:
            report.error(
                token.position,
                f"expected {expected} in the macro's parameters, found '{shown(token.text)}'",
            )
            return None
    report.error(tokens[-1].position, "missing ')' in the macro's parameters")
    return None


class _BodyReader:
    """Parses a macro's body into parts."""

    def __init__(
        self,
        body: Sequence[Token],
        parameters: tuple[str, ...] | None,
        variadic: bool,
        report: Report,
    ) -> None:
        self.body = body
        self.function_like = parameters is not None
        self.numbers = {name: number for number, name in enumerate(parameters or ())}
        self.variadic = variadic
        self.last = len(self.numbers) - 1
        self.report = report
        self.expanded: set[int] = set()

    def read(self) -> tuple[Part, ...] | None:
        """Return the parts of the whole body, None if it is invalid."""
        return self._read(0, len(self.body), in_option=False)

    def _read(self, index: int, end: int, *, in_option: bool) -> tuple[Part, ...] | None:
        parts: list[Part] = []
        pasted = False
        while index < end:
            token = self.body[index]
            if token.text in PASTE and token.kind == PUNCTUATOR:
                if not parts or index + 1 == end:
                    self.report.error(
                        token.position, f"'{token.text}' cannot be at either end of a macro's body"
                    )
                    return None
                pasted = True
                index += 1
                continue
            if token.text == OPTIONAL and self.variadic and not in_option:
                step = self._read_option(index, end, pasted)
            else:
                step = self._read_part(index, end, parts, pasted)
            if step is None:
                return None
            part, index = step
            parts.append(part)
            pasted = False
        return tuple(parts)

    def _read_part(
        self, index: int, end: int, parts: Sequence[Part], pasted: bool
    ) -> tuple[Part, int] | None:
        """Return the part that starts at a token, and the start of the next; None if invalid."""
        token = self.body[index]
        if token.text in HASH and token.kind == PUNCTUATOR and self.function_like:
            follower = self.body[index + 1] if index + 1 < end else token
            if follower.text == OPTIONAL and self.variadic:
                option = self._read_option(index + 1, end, pasted)
                return None if option is None else (replace(option[0], quoted=True), option[1])
            if follower.text not in self.numbers:
                self.report.error(token.position, "'#' is not followed by a parameter of the macro")
                return None
            return Part("string", token, self.numbers[follower.text], pasted), index + 2
        number = self.numbers.get(token.text)
        if number is None:
            if token.text in (VARIADIC, OPTIONAL):
                self.report.warning(
                    token.position, f"'{token.text}' is not allowed here", flag="stray-token"
                )
            return Part("token", token, pasted=pasted), index + 1
        if index + 1 < end and self.body[index + 1].text in PASTE:
            return Part("raw", token, number, pasted), index + 1
        if pasted and self.variadic and number == self.last and parts[-1].token.text == ",":
            self.expanded.add(number)
            return Part("rest", token, number), index + 1
        if pasted:
            return Part("raw", token, number, pasted), index + 1
        self.expanded.add(number)
        return Part("argument", token, number), index + 1

    def _read_option(self, index: int, end: int, pasted: bool) -> tuple[Part, int] | None:
        """Parse `__VA_OPT__(...)` (C23 6.10.5.2)."""
        token = self.body[index]
        close = _closing(self.body, index + 1, end)
        if close is None:
            self.report.error(token.position, f"'{OPTIONAL}' must be followed by parentheses")
            return None
        inside = self._read(index + 2, close, in_option=True)
        if inside is None:
            return None
        self.expanded.add(self.last)
        return Part("optional", token, self.last, pasted, inside), close + 1


def _closing(body: Sequence[Token], index: int, end: int) -> int | None:
    """Return the index of the `)` that closes the `(` at a token."""
    depth = 0
    for number in range(index, end):
        depth += {"(": 1, ")": -1}.get(body[number].text, 0)
        if depth == 0:
            return number if number > index else None
    return None
