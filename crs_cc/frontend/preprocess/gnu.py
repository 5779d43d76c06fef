r"""GNU syntax that the parser does not support: it is removed or replaced by standard syntax.

This works on single keywords and on constructs of a keyword with parentheses. To add another: a
keyword with a standard equivalent goes into `_EQUIVALENTS`, one with parentheses into
`_CONSTRUCTS`, with a method that returns its replacement. Lines without any such keyword are not
rewritten, so syntax without a keyword, such as `case 1 ... 5`, must be excluded by
`spelling.is_plain`.

>>> from crs_cc.frontend.preprocess.source_text import SourceMap
>>> from crs_cc.frontend.preprocess.tokens import spell, tokenise
>>> from crs_cc.core.source import Diagnostics
>>> gnu = GnuSyntax(Report(Diagnostics(), SourceMap()), lambda tokens: [])
>>> line = "static __inline__ int f(void), x asm(\"y\") __attribute((unused));"
>>> spell(gnu.rewrite(tokenise(line, 0), before=lambda: ""))
'static __inline int f(void), x __attribute__((__asm_label__("y"))) __attribute__((unused));'
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Final

from crs_cc.frontend.preprocess.report import Report
from crs_cc.frontend.preprocess.tokens import NAME, Token, tokenise

KEYWORD: Final = "__attribute__"
PACK: Final = "__pragma_pack__"
"""The attribute by which the preprocessor replaces `#pragma pack(...)`."""

ASM_LABEL: Final = "__asm_label__"
"""The attribute by which the preprocessor replaces `asm("name")` after a declarator."""

_EQUIVALENTS: Final = {
    "__inline__": "__inline",
    "__const": "const", "__const__": "const",
    "__volatile": "volatile", "__volatile__": "volatile",
    "__restrict__": "__restrict",
    "__signed": "signed", "__signed__": "signed",
    "__alignof": "_Alignof", "__alignof__": "_Alignof",
    "__complex": "_Complex", "__complex__": "_Complex",
    "__thread": "_Thread_local",
    "__FUNCTION__": "__func__", "__PRETTY_FUNCTION__": "__func__",
    "__builtin_offsetof": "offsetof",
    "__attribute": "__attribute__",
}  # fmt: skip
_DROPPED: Final = frozenset({"__extension__"})
_ASM: Final = frozenset({"asm", "__asm", "__asm__"})
_PRAGMA: Final = frozenset({"_Pragma"})
_CONSTRUCTS: Final = _ASM | _PRAGMA
_ASM_QUALIFIERS: Final = frozenset({
    "const", "goto", "inline", "__inline", "__inline__", "volatile", "__volatile", "__volatile__",
})  # fmt: skip
_BARRIERS: Final = frozenset(
    {"", "nop", "pause", "rep; nop", "rep;nop", "mfence", "lfence", "sfence"}
)
"""Instructions that change nothing for a single thread."""

Pragma = Callable[[list[Token]], list[Token]]
"""Executes the tokens after `#pragma`, and returns their replacement."""

WORDS: Final = frozenset(_EQUIVALENTS) | _DROPPED | _CONSTRUCTS
"""A line without any of these words is not rewritten."""

_STATEMENT_BEGIN: Final = re.compile(r"\s*(?:if|while|for|switch|else|do|return)\b")
_BEFORE_ASM: Final = 200
"""How far back the start of a declaration is looked for [characters, or tokens]."""


@dataclass(slots=True)
class _Construct:
    """A keyword whose parentheses are not closed yet.

    Attributes:
        word: the keyword.
        is_label: for `asm`, whether it names a declared object instead of being a statement.
        inside: the tokens between the parentheses.
        depth: how many parentheses are open.
    """

    word: Token
    is_label: bool = False
    inside: list[Token] = field(default_factory=list)
    depth: int = 0


class GnuSyntax:
    """Rewrites a stream of tokens, which is passed in pieces."""

    def __init__(self, report: Report, pragma: Pragma, *, strict: bool = False) -> None:
        """Set up the rewriting.

        Args:
            report: receives errors.
            pragma: executes `_Pragma`.
            strict: whether the program is in ISO C, where `asm` is a name.
        """
        self._report = report
        self._pragma = pragma
        self._names = frozenset({"asm"}) if strict else frozenset()
        self._construct: _Construct | None = None

    @property
    def is_open(self) -> bool:
        """Return whether the last construct continues in the following tokens."""
        return self._construct is not None

    def rewrite(self, tokens: Sequence[Token], before: Callable[[], str]) -> list[Token]:
        """Return the standard form of tokens.

        Args:
            tokens: the next piece of the program.
            before: returns the text before them, as far as it was written.
        """
        result: list[Token] = []
        for token in tokens:
            if self._construct is not None and self._continue_construct(
                self._construct, token, result
            ):
                continue
            text = token.text
            if text not in WORDS or token.kind != NAME or text in self._names:
                result.append(token)
            elif text in _EQUIVALENTS:
                result.append(Token(NAME, _EQUIVALENTS[text], token.position, token.spaced))
            elif text in _CONSTRUCTS:
                is_label = text in _ASM and _follows_declarator(before(), result)
                self._construct = _Construct(token, is_label)
        return result

    def finish(self) -> None:
        """Report a construct that is open at the end of the program."""
        if self._construct is not None:
            word = self._construct.word
            self._report.error(word.position, f"missing ')' after '{word.text}'")
            self._construct = None

    def _continue_construct(self, construct: _Construct, token: Token, result: list[Token]) -> bool:
        """Return whether a token belongs to the open construct, and consume it if so."""
        if construct.depth == 0 and token.text != "(":
            if construct.word.text in _ASM and token.text in _ASM_QUALIFIERS:
                construct.is_label = False
                return True
            self._construct = None
            if construct.word.text in _ASM:
                self._close_asm(construct)
            else:
                word = construct.word.text
                self._report.error(token.position, f"expected '(' after '{word}'")
            return False
        construct.depth += {"(": 1, ")": -1}.get(token.text, 0)
        construct.inside.append(token)
        if construct.depth == 0:
            self._construct = None
            result += self._close(construct)
        return True

    def _close(self, construct: _Construct) -> list[Token]:
        """Return the replacement of a construct."""
        if construct.word.text in _ASM:
            if construct.is_label:
                return _label(construct)
            sections = _sections(construct.inside[1:-1])
            if "".join(each.text.strip('"') for each in sections[0]).strip() in _BARRIERS:
                return _matched(sections)
            self._close_asm(construct)
            return []
        literal = "".join(each.text for each in construct.inside[1:-1])
        text = literal.removeprefix("L").strip('"').replace('\\"', '"')
        return self._pragma(tokenise(text.replace("\\\\", "\\"), construct.word.position))

    def _close_asm(self, construct: _Construct) -> None:
        """Reject statements."""
        if not construct.is_label:
            self._report.error(
                construct.word.position,
                "inline assembly is not supported",
                "write it in C where __CRS__ is defined",
            )


def _sections(tokens: Sequence[Token]) -> list[list[Token]]:
    """Return the parts of an `asm` statement between its colons: code, outputs, inputs, ..."""
    found: list[list[Token]] = [[]]
    depth = 0
    for token in tokens:
        depth += {"(": 1, ")": -1, "[": 1, "]": -1}.get(token.text, 0)
        if token.text == ":" and depth == 0:
            found.append([])
        else:
            found[-1].append(token)
    return found


def _operands(tokens: Sequence[Token]) -> list[tuple[str, list[Token]]]:
    """Return the constraint and the expression of each operand: `"=r"(x), [name] "m"(y)`."""
    found: list[tuple[str, list[Token]]] = []
    depth = 0
    for token in tokens:
        if depth == 0 and token.text[:1] == '"':
            found.append((token.text.strip('"'), []))
        depth += {"(": 1, ")": -1}.get(token.text, 0)
        if found and (depth > 0 or token.text == ")"):
            found[-1][1].append(token)
    return found


def _matched(sections: list[list[Token]]) -> list[Token]:
    """Return the effect of an `asm` without code: an input moves to the output that it shares.

    An input with the constraint "0" is in the same position as the first output.
    """
    outputs = _operands(sections[1]) if len(sections) > 1 else []
    result: list[Token] = []
    for constraint, value in _operands(sections[2]) if len(sections) > 2 else []:
        if constraint.isdigit() and int(constraint) < len(outputs) and value:
            comma = tokenise(",", value[0].position) if result else []
            equals = tokenise("=", value[0].position)
            result += [*comma, *outputs[int(constraint)][1], *equals, *value]
    return result


def _label(construct: _Construct) -> list[Token]:
    """Return the assembler name of a declared object or function as an attribute."""
    position = construct.word.position
    begin = [each.moved(position, each.spaced) for each in tokenise(f" {KEYWORD}(({ASM_LABEL}", 0)]
    return [*begin, *construct.inside, *tokenise("))", position)]


def _follows_declarator(before: str, tokens: Sequence[Token]) -> bool:
    """Return whether the preceding tokens are a declarator, and not the start of a statement."""
    text = " ".join([before[-_BEFORE_ASM:], *(each.text for each in tokens[-_BEFORE_ASM:])])
    statement = re.split(r"[;{}]", text)[-1]
    last = statement.rstrip()[-1:]
    return (
        (last.isalnum() or last in ("_", "$", ")", "]"))
        and last != ""
        and statement.count("(") == statement.count(")")
        and _STATEMENT_BEGIN.match(statement) is None
    )
