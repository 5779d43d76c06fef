"""Macro replacement (C17 6.10.3), without recursion.

Tokens are read from a stack of contexts: the replacement of a macro is on top of what follows its
call. While a context is on the stack its macro is *active*, and the name of an active macro is
painted when it is read: it is never replaced again. An argument that must be expanded before it is
substituted is a separate job, for which the call waits; so the depth of nested calls takes memory,
not stack. Macros become active and inactive in the same order as in gcc, which decides the cases
that the standard leaves unspecified.

>>> from crs_cc.frontend.preprocess.macros import read_definition
>>> from crs_cc.frontend.preprocess.source_text import SourceMap
>>> from crs_cc.frontend.preprocess.tokens import spell, tokenise
>>> from crs_cc.core.source import Diagnostics
>>> report = Report(Diagnostics(), SourceMap())
>>> macros = {"f": read_definition(tokenise("f(x) x * f(x + 1)", 0), report)}
>>> spell(expand(tokenise("f(f(a))", 0), macros, Budget(), report))
'a * f(a + 1) * f(a * f(a + 1) + 1)'
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from crs_cc.frontend.preprocess.budget import Budget
from crs_cc.frontend.preprocess.macros import DEFINED, Macro
from crs_cc.frontend.preprocess.report import Report
from crs_cc.frontend.preprocess.source_text import Position
from crs_cc.frontend.preprocess.substitute import substitute
from crs_cc.frontend.preprocess.tokens import NAME, Token

MoreTokens = Callable[[], list[Token] | None]
"""Returns the tokens of the next line, None at the end of the file."""

MacroUses = dict[Position, list[Macro]]
"""The macros that were replaced at a position: the one that was called and those in its body."""


def expand(
    tokens: Sequence[Token],
    macros: Mapping[str, Macro],
    budget: Budget,
    report: Report,
    more: MoreTokens | None = None,
    *,
    uses: MacroUses | None = None,
) -> list[Token]:
    """Replace all macros in tokens.

    Args:
        tokens: a line.
        macros: the macros, by name; `more` may change them.
        budget: the limit for expansion.
        report: receives messages about invalid calls.
        more: returns the next line if a call does not end on this one.
        uses: records the macros that are replaced.

    Raises:
        ExhaustedError: the budget is used up.
    """
    uses = {} if uses is None else uses
    return _Expansion(macros, budget, report, more, uses=uses).run(tokens)


@dataclass(slots=True)
class _Context:
    """Tokens to read, and the macro that they come from."""

    tokens: Iterator[Token]
    macro: str = ""


@dataclass(slots=True)
class _Job:
    """A list of tokens that is being expanded: an argument of a call, or a line."""

    contexts: list[_Context]
    call: _Call | None = None
    output: list[Token] = field(default_factory=list)
    owes_space: bool = False


@dataclass(slots=True)
class _Call:
    """A macro call that waits for its arguments to be expanded."""

    job: _Job
    macro: Macro
    name: Token
    arguments: list[list[Token]]
    waiting: list[int]
    expanded: dict[int, list[Token]] = field(default_factory=dict)


class _Expansion:
    """The expansion of one line."""

    def __init__(
        self,
        macros: Mapping[str, Macro],
        budget: Budget,
        report: Report,
        more: MoreTokens | None,
        *,
        uses: MacroUses,
    ) -> None:
        self.macros = macros
        self.budget = budget
        self.report = report
        self.more = more
        self.uses = uses
        self.active: set[str] = set()

    def run(self, tokens: Sequence[Token]) -> list[Token]:
        job = _Job([_Context(iter(tokens))])
        while True:
            name = self._read_to_macro(job)
            if name is not None:
                job = self._invoke(job, name, self.macros[name.text])
            elif job.call is not None:
                job = self._finish_argument(job, job.call)
            else:
                return job.output

    def _read_to_macro(self, job: _Job) -> Token | None:
        """Output tokens up to the next macro; return its name, None at the end."""
        output, macros, active = job.output, self.macros, self.active
        while job.contexts:
            for token in job.contexts[-1].tokens:
                if job.owes_space:
                    token = token.moved(token.position, spaced=True)  # noqa: PLW2901 - the same token
                    job.owes_space = False
                if token.text not in macros or token.painted or token.kind != NAME:
                    output.append(token)
                elif token.text in active:
                    output.append(_painted(token))
                else:
                    return token
            active.discard(job.contexts.pop().macro)
        return None

    def _read(self, job: _Job) -> Token | None:
        """Return the next token, None at the end of the contexts."""
        contexts = job.contexts
        while contexts:
            for token in contexts[-1].tokens:
                return token
            self.active.discard(contexts.pop().macro)
        return None

    def _read_on(self, job: _Job) -> Token | None:
        """Return the next token, from the next line if necessary, None at the end of the file."""
        while (token := self._read(job)) is None:
            if job.call is not None or self.more is None or (line := self.more()) is None:
                return None
            job.contexts.append(_Context(iter(line)))
        return token

    def _invoke(self, job: _Job, name: Token, macro: Macro) -> _Job:
        """Start to replace a macro; return the job to continue with."""
        if macro.dynamic is not None:
            job.output.append(macro.dynamic(name))
            return job
        if macro is DEFINED:
            job.output += [name, *self._operand(job)]
            return job
        if macro.parameters is None:
            return self._replace(_Call(job, macro, name, [], []))
        follower = self._read_on(job)
        if follower is None or follower.text != "(":
            if follower is not None:
                job.contexts.append(_Context(iter([follower])))
            job.output.append(name)
            return job
        arguments = self._collect(job, name, macro)
        if arguments is None:
            job.output.append(name)
            return job
        return self._advance(_Call(job, macro, name, arguments, [*macro.expanded]))

    def _operand(self, job: _Job) -> list[Token]:
        """Read `NAME` or `( NAME` after `defined` without replacement."""
        tokens = []
        while (token := self._read(job)) is not None:
            tokens.append(token)
            if token.text != "(":
                break
        return tokens

    def _collect(self, job: _Job, name: Token, macro: Macro) -> list[list[Token]] | None:
        """Read the arguments of a call up to its `)`; return None if they do not match."""
        assert macro.parameters is not None
        arguments: list[list[Token]] = [[]]
        most = len(macro.parameters) if macro.variadic else None
        depth = 0
        while (token := self._read_on(job)) is not None:
            text = token.text
            if text == "(":
                depth += 1
            elif text == ")":
                if depth == 0:
                    return self._fit(name, macro, arguments)
                depth -= 1
            elif text == "," and depth == 0 and len(arguments) != most:
                arguments.append([])
                continue
            elif text in self.active and token.kind == NAME:
                token = _painted(token)
            arguments[-1].append(token)
        self.report.error(name.position, f"unterminated call of macro '{macro.name}': missing ')'")
        return None

    def _fit(
        self, name: Token, macro: Macro, arguments: list[list[Token]]
    ) -> list[list[Token]] | None:
        """Return the arguments of a call, one for each parameter; None if their number is wrong."""
        assert macro.parameters is not None
        for argument in arguments:
            self.budget.spend(argument, name.position)
        wanted = len(macro.parameters)
        if wanted == 0 and arguments == [[]]:
            return []
        if macro.variadic and len(arguments) == wanted - 1:
            return [*arguments, []]  # GNU and C23: the variadic argument may be left out
        if len(arguments) == wanted:
            return arguments
        fewest = wanted - macro.variadic
        number = f"{'at least ' if macro.variadic else ''}{fewest}"
        plural = "" if fewest == 1 else "s"
        self.report.error(
            name.position,
            f"macro '{macro.name}' requires {number} argument{plural}, but has {len(arguments)}",
        )
        return None

    def _advance(self, call: _Call) -> _Job:
        """Expand the next argument that needs it, or replace the call."""
        while call.waiting:
            number = call.waiting[-1]
            argument = call.arguments[number]
            if any(token.text in self.macros for token in argument):
                return _Job([_Context(iter(argument))], call)
            call.expanded[number] = argument
            call.waiting.pop()
        return self._replace(call)

    def _finish_argument(self, job: _Job, call: _Call) -> _Job:
        """Pass an expanded argument to the call that waits for it."""
        call.expanded[call.waiting.pop()] = job.output
        return self._advance(call)

    def _replace(self, call: _Call) -> _Job:
        """Push a macro's replacement, to be read next."""
        job, name = call.job, call.name
        tokens = substitute(
            call.macro,
            name,
            call.arguments,
            call.expanded,
            budget=self.budget,
            report=self.report,
        )
        self.uses.setdefault(name.position, []).append(call.macro)
        if tokens:
            job.contexts.append(_Context(iter(tokens), name.text))
            self.active.add(name.text)
        else:
            job.owes_space = job.owes_space or name.spaced
        return job


def _painted(token: Token) -> Token:
    return Token(token.kind, token.text, token.position, token.spaced, painted=True)
