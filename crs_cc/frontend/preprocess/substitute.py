r"""The replacement of a macro call: the body with the arguments (C17 6.10.3.1 to 3).

>>> from crs_cc.frontend.preprocess.macros import read_definition
>>> from crs_cc.frontend.preprocess.source_text import SourceMap
>>> from crs_cc.frontend.preprocess.tokens import spell, tokenise
>>> from crs_cc.core.source import Diagnostics
>>> report = Report(Diagnostics(), SourceMap())
>>> macro = read_definition(tokenise("show(x, n) print(#x, x ## n)", 0), report)
>>> name, *_ = tokenise("show", 0)
>>> arguments = [tokenise(r"'\n'  + x", 4), tokenise("1", 20)]
>>> spell(substitute(macro, name, arguments, {}, budget=Budget(), report=report))
'print("\'\\\\n\' + x", \'\\n\' + x1)'
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from crs_cc.frontend.preprocess.budget import Budget
from crs_cc.frontend.preprocess.macros import Macro, Part
from crs_cc.frontend.preprocess.report import Report
from crs_cc.frontend.preprocess.source_text import Position
from crs_cc.frontend.preprocess.tokens import (
    CHARACTER,
    PLACEMARKER,
    STRING,
    UNCLOSED,
    Token,
    shown,
    spell,
    tokenise,
)


def substitute(
    macro: Macro,
    name: Token,
    arguments: Sequence[list[Token]],
    expanded: Mapping[int, list[Token]],
    *,
    budget: Budget,
    report: Report,
) -> list[Token]:
    """Return the tokens of a macro's body with the parameters replaced by the arguments.

    Args:
        macro: the macro.
        name: its name in the call, whose position becomes that of the body's tokens.
        arguments: the arguments as written.
        expanded: the expanded arguments, by index.
        budget: the limit for expansion.
        report: receives messages about tokens that cannot be pasted.

    Raises:
        ExhaustedError: the budget is used up.
    """
    position = name.position
    budget.spend(macro.body, position)
    if macro.parameters is None and not macro.pastes:
        tokens = [each.moved(position, each.spaced) for each in macro.body]
        return _spaced(tokens, name.spaced)
    call = _Substitution(position, arguments, expanded, budget, report)
    return _without_placemarkers(_spaced(call.body(macro.parts), name.spaced))


def stringise(tokens: Sequence[Token]) -> str:
    """Return tokens as a string literal (C17 6.10.3.2)."""
    quoted = [
        Token(token.kind, _escaped(token.text), token.position, token.spaced)
        if token.kind in (STRING, CHARACTER)
        else token
        for token in tokens
    ]
    return f'"{spell(quoted)}"'


def _escaped(text: str) -> str:
    return text.replace("\\", "\\\\").replace('"', '\\"')


@dataclass(slots=True)
class _Substitution:
    """The substitution for one call."""

    position: Position
    arguments: Sequence[list[Token]]
    expanded: Mapping[int, list[Token]]
    budget: Budget
    report: Report

    def body(self, parts: Sequence[Part]) -> list[Token]:
        result: list[Token] = []
        for part in parts:
            if part.kind == "token":
                tokens = [part.token.moved(self.position, part.token.spaced)]
            elif part.kind == "rest" and not self.arguments[part.argument]:
                result.pop()  # GNU: without variadic arguments the comma is removed
                continue
            else:
                tokens = self._tokens(part)
                self.budget.spend(tokens, self.position)
            if part.pasted:
                self._paste(result, tokens[0])
                result.extend(tokens[1:])
            else:
                result.extend(tokens)
        return result

    def _tokens(self, part: Part) -> list[Token]:
        """Return the replacement of a part, which has at least one token."""
        spaced = part.token.spaced
        if part.kind == "string":
            argument = self.arguments[part.argument]
            self.budget.spend(argument, self.position)
            text = stringise(argument)
            return [Token(STRING, text, self.position, spaced)]
        if part.kind == "raw":
            tokens = self.arguments[part.argument]
        elif part.kind == "optional":
            tokens = self.body(part.inside) if self.expanded[part.argument] else []
            if part.quoted:
                tokens = _without_placemarkers(tokens)
                self.budget.spend(tokens, self.position)
                return [Token(STRING, stringise(tokens), self.position, spaced)]
        else:
            tokens = self.expanded[part.argument]
        return _spaced(tokens, spaced) or [Token(PLACEMARKER, "", self.position, spaced)]

    def _paste(self, result: list[Token], right: Token) -> None:
        """Paste a token to the last one (C17 6.10.3.3)."""
        left = result[-1]
        if right.kind == PLACEMARKER:
            return
        if left.kind == PLACEMARKER:
            result[-1] = right.moved(right.position, left.spaced)
            return
        joined = tokenise(left.text + right.text, left.position)
        self.budget.spend(joined, self.position)
        if len(joined) == 1 and joined[0].kind != UNCLOSED:
            result[-1] = joined[0].moved(left.position, left.spaced)
            return
        self.report.error(
            self.position,
            f"'{shown(left.text)}' and '{shown(right.text)}' cannot be pasted into one token",
        )
        result.append(right)


def _without_placemarkers(tokens: list[Token]) -> list[Token]:
    """Remove placemarkers, but not the white space before them."""
    result = []
    owes_space = False
    for token in tokens:
        if token.kind == PLACEMARKER:
            owes_space = owes_space or token.spaced
            continue
        result.append(token.moved(token.position, spaced=True) if owes_space else token)
        owes_space = False
    return result


def _spaced(tokens: list[Token], spaced: bool) -> list[Token]:
    """Return tokens with or without white space before the first one."""
    if not tokens or tokens[0].spaced == spaced:
        return tokens
    return [tokens[0].moved(tokens[0].position, spaced), *tokens[1:]]
