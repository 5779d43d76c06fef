"""Preprocessing directives (C17 6.10).

>>> sorted(_IN_SKIPPED_GROUPS - {"if", "ifdef", "ifndef"})
['elif', 'elifdef', 'elifndef', 'else', 'endif']
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from crs_cc.frontend.preprocess import conditionals
from crs_cc.frontend.preprocess.condition import ConditionError, evaluate, resolve_defined
from crs_cc.frontend.preprocess.embed import embed
from crs_cc.frontend.preprocess.feature_tests import HEADER, resolve_features
from crs_cc.frontend.preprocess.gnu import KEYWORD, PACK
from crs_cc.frontend.preprocess.macros import FEATURE_TESTS, RESERVED, Macro, read_definition
from crs_cc.frontend.preprocess.output import WeakName
from crs_cc.frontend.preprocess.regular_file import Refusal
from crs_cc.frontend.preprocess.source_text import OUR_HEADERS, Position
from crs_cc.frontend.preprocess.state import State
from crs_cc.frontend.preprocess.tokens import NAME, NUMBER, STRING, Token, shown, spell, tokenise

_DIRECTIVE: Final = re.compile(r"[ \t\v\f]*(?:#|%:)[ \t\v\f]*(\w*)")
_PRAGMAS_WITH_MEANING: Final = frozenset({"redefine_extname"})
_ASSERTIONS: Final = frozenset({"assert", "unassert"})
MAX_DEFINITIONS: Final = 20_000
"""How many definitions of our headers are remembered."""

_definitions: Final[dict[Position, Macro]] = {}
"""The macros of our headers, by the position after `#define`, which is that of no other text."""

MAX_LINE: Final = (1 << 31) - 1
"""The largest line number that `#line` can set (C17 6.10.4)."""


@dataclass(slots=True)
class _Line:
    """A line with a directive.

    Attributes:
        name: the directive.
        position: the position of its `#`.
        rest: the text after the name.
        rest_position: the position of that text.
    """

    name: str
    position: Position
    rest: str
    rest_position: Position

    def tokens(self) -> list[Token]:
        return tokenise(self.rest, self.rest_position)


def run_directive(state: State, text: str, position: Position) -> bool:
    """Execute a line if it is a directive.

    Returns:
        Whether it is one.

    Raises:
        StopError: preprocessing cannot continue.
        ExhaustedError: macros in it expand to too many tokens.
    """
    match = _DIRECTIVE.match(text)
    if match is None:
        return False
    hash_position = position + len(text) - len(text.lstrip())
    line = _Line(match[1], hash_position, text[match.end() :], position + match.end())
    if state.reader.skipping and line.name not in _IN_SKIPPED_GROUPS:
        return True
    if line.name.isdigit():
        line.rest, line.rest_position = match[1] + line.rest, position + match.start(1)
        _line(state, line)  # the output of another preprocessor: # 12 "file.c"
    elif line.name in _DIRECTIVES:
        _DIRECTIVES[line.name](state, line)
    elif line.name or line.rest.strip():
        name = line.name or line.rest.split()[0]
        close = difflib.get_close_matches(name, _DIRECTIVES, n=1)
        hint = f"did you mean '#{close[0]}'?" if close else ""
        if name in _ASSERTIONS:
            hint = "assertions are obsolete in gcc; define a macro instead"
        state.report.error(hash_position, f"unknown directive '#{shown(name)}'", hint)
    return True


def _define(state: State, line: _Line) -> None:
    macro = _definitions.get(line.rest_position) or _definition(state, line)
    if macro is not None:
        state.define(macro)


def _definition(state: State, line: _Line) -> Macro | None:
    """Return the macro of a definition, and remember it if it is in one of our headers."""
    tokens = line.tokens()
    if not tokens:
        state.report.error(line.position, "'#define' must be followed by a name")
        return None
    before = len(state.report.diagnostics.messages)
    macro = read_definition(tokens, state.report)
    is_faultless = len(state.report.diagnostics.messages) == before
    if macro is not None and is_faultless and line.position >= OUR_HEADERS:
        if len(_definitions) >= MAX_DEFINITIONS:
            _definitions.clear()
        _definitions[line.rest_position] = macro
    return macro


def _undef(state: State, line: _Line) -> None:
    name = _only_name(state, line)
    if name is None:
        return
    if name.text in RESERVED:
        state.report.error(name.position, f"'{name.text}' cannot be undefined")
        return
    macro = state.macros.get(name.text)
    if macro is not None and macro.dynamic is not None:
        state.report.warning(
            name.position, f"undefining builtin macro '{name.text}'", flag="builtin-macro-redefined"
        )
    state.undefine(name.text)


def _only_name(state: State, line: _Line) -> Token | None:
    """Return the only operand of a directive, a name."""
    tokens = line.tokens()
    if not tokens:
        state.report.error(line.position, f"'#{line.name}' must be followed by a name")
        return None
    if tokens[0].kind != NAME:
        state.report.error(
            tokens[0].position,
            f"'#{line.name}' must be followed by a name, not '{shown(tokens[0].text)}'",
        )
        return None
    _require_end(state, line, tokens[1:])
    return tokens[0]


def _require_end(state: State, line: _Line, tokens: list[Token]) -> None:
    if tokens:
        state.report.warning(
            tokens[0].position,
            f"'{shown(tokens[0].text)}' after '#{line.name}' is ignored",
            flag="extra-tokens",
        )


def _include(state: State, line: _Line) -> None:
    header = _header_name(state, line)
    if header is None:
        return
    name, quoted, position, after = header
    _require_end(state, line, after)
    here = state.reader.header if line.name == "include_next" else None
    found = state.headers.find(
        name, quoted=quoted, folder=state.reader.folder, after=here.root if here else None
    )
    if isinstance(found, Refusal):
        ours = state.headers.find_bundled(name, quoted=quoted, folder=state.reader.folder)
        if ours is None:
            state.report.error(position, found.text, found.hint)
            state.report.is_complete = False
            return
        meant, found = ours
        state.report.warning(
            position, f"'{shown(name)}' not found; using '{meant}'", flag="header-name"
        )
    state.include(found, position)
    if line.name == "import":
        state.once.add(found.file)


def _embed(state: State, line: _Line) -> None:
    header = _header_name(state, line)
    if header is None:
        return
    name, quoted, position, after = header
    found = state.headers.find(name, quoted=quoted, folder=state.reader.folder)
    if isinstance(found, Refusal):
        state.report.error(position, found.text, found.hint)
        return
    state.pending += embed(state, found, state.expand(after), position)


def _header_name(state: State, line: _Line) -> tuple[str, bool, Position, list[Token]] | None:
    """Return a file name, whether it is quoted, its position, and the tokens after it (6.10.2)."""
    rest, position = line.rest, line.rest_position
    match = HEADER.match(rest)
    if match is None:
        tokens = state.expand(line.tokens())
        if not tokens:
            state.report.error(line.position, f"'#{line.name}' must be followed by a header's name")
            return None
        rest, position = spell(tokens), tokens[0].position
        match = HEADER.match(rest)
        if match is None:
            state.report.error(position, 'write "name.h" or <name.h>')
            return None
        after = tokenise(rest[match.end() :], position) if line.name == "embed" else []
    else:
        position += len(rest) - len(rest.lstrip())
        after = tokenise(rest[match.end() :], line.rest_position + match.end())
    return match[1] or match[2] or "", match[1] is not None, position, after


def _condition(state: State, line: _Line) -> bool:
    """Return the value of the expression after `#if` or `#elif`."""

    def is_defined(name: str) -> bool:
        return name in state.macros or name in FEATURE_TESTS

    try:
        tokens = resolve_defined(line.tokens(), is_defined)
        tokens = state.expand_condition(resolve_features(state, tokens, expanded=False))
        tokens = resolve_defined(tokens, is_defined)
        tokens = resolve_features(state, tokens, expanded=True)
        if state.is_c23:
            tokens = [_truth(each) for each in tokens]
        return evaluate(tokens)
    except ConditionError as error:
        position = line.position if error.position is None else error.position
        state.report.error(position, f"in '#{line.name}': {error}", error.hint)
        return False


def _truth(token: Token) -> Token:
    """Return the number that C23's `true` is."""
    is_true = token.kind == NAME and token.text == "true"
    return Token(NUMBER, "1", token.position, token.spaced) if is_true else token


def _if(state: State, line: _Line) -> None:
    holds = not state.reader.skipping and _condition(state, line)
    conditionals.open_group(state.reader, f"#{line.name}", line.position, holds=holds)


def _ifdef(state: State, line: _Line) -> None:
    holds = not state.reader.skipping and _names_a_macro(state, line)
    conditionals.open_group(state.reader, f"#{line.name}", line.position, holds=holds)


def _names_a_macro(state: State, line: _Line) -> bool:
    """Return the condition of `#ifdef`, `#ifndef` and their `#elif` forms."""
    name = _only_name(state, line)
    if name is None:
        return False
    is_defined = name.text in state.macros or name.text in FEATURE_TESTS
    return is_defined != line.name.endswith("ndef")


def _elif(state: State, line: _Line) -> None:
    judge = _condition if line.name == "elif" else _names_a_macro
    conditionals.start_elif(
        state.reader, f"#{line.name}", line.position, state.report, lambda: judge(state, line)
    )


def _else(state: State, line: _Line) -> None:
    _require_end(state, line, line.tokens())
    conditionals.start_else(state.reader, line.position, state.report)


def _endif(state: State, line: _Line) -> None:
    _require_end(state, line, line.tokens())
    conditionals.end_group(state.reader, line.position, state.report)


def _error(state: State, line: _Line) -> None:
    state.report.error(line.position, shown(f"#error {line.rest.strip()}".rstrip(), 500))


def _warning(state: State, line: _Line) -> None:
    state.report.warning(
        line.position, shown(f"#warning {line.rest.strip()}".rstrip(), 500), flag="cpp"
    )


def _line(state: State, line: _Line) -> None:
    """Set `__LINE__` and `__FILE__` (C17 6.10.4); messages keep the real location."""
    tokens = state.expand(line.tokens())
    digits = tokens[0].text if tokens else ""
    if not (digits.isdigit() and digits.isascii() and len(digits) <= 10):
        state.report.error(line.position, "'#line' must be followed by a line number")
        return
    number = int(digits)
    if not 0 <= number <= MAX_LINE:
        state.report.error(tokens[0].position, f"a line number is at most {MAX_LINE}")
        return
    if len(tokens) > 1:
        if tokens[1].kind != STRING or tokens[1].text[0] != '"':
            state.report.error(tokens[1].position, "the file name of '#line' must be in quotes")
            return
        state.reader.presumed_name = re.sub(r"\\(.)", r"\1", tokens[1].text[1:-1])
    reader = state.reader
    next_line = reader.text.location(reader.position).line
    reader.line_offset = number - next_line


def _pragma(state: State, line: _Line) -> None:
    state.pending += execute_pragma(state, line.tokens())


def execute_pragma(state: State, tokens: list[Token]) -> list[Token]:
    """Execute a `#pragma`, and return the tokens that represent it in the program."""
    name = tokens[0].text if tokens else ""
    if name == "once":
        if state.reader.header is not None:
            state.once.add(state.reader.header.file)
    elif name == "pack":
        words = [KEYWORD, "(", "(", PACK, *(each.text for each in tokens[1:]), ")", ")"]
        return tokenise(" ".join(words), tokens[0].position)
    elif name in ("push_macro", "pop_macro"):
        _keep_macro(state, tokens)
    elif name == "weak":
        _weak(state, tokens)
    elif name in _PRAGMAS_WITH_MEANING:
        state.report.warning(
            tokens[0].position, f"'#pragma {name}' is ignored", flag="unknown-pragmas"
        )
    return []


def _keep_macro(state: State, tokens: list[Token]) -> None:
    """Execute `#pragma push_macro("NAME")` or `pop_macro`."""
    if [token.text for token in tokens[1:2] + tokens[3:]] != ["(", ")"] or len(tokens) != 4:
        state.report.warning(
            tokens[0].position,
            f"'#pragma {tokens[0].text}' must be followed by a name in quotes",
            flag="pragmas",
        )
        return
    name = tokens[2].text.strip('"')
    kept = state.kept_macros.setdefault(name, [])
    if tokens[0].text == "push_macro":
        kept.append(state.macros.get(name))
    elif kept:
        macro = kept.pop()
        state.undefine(name)
        if macro is not None:
            state.define(macro)


def _weak(state: State, tokens: list[Token]) -> None:
    """Execute `#pragma weak NAME` or `#pragma weak NAME = OTHER`."""
    shape = [NAME if each.kind == NAME else each.text for each in tokens[1:]]
    if shape not in ([NAME], [NAME, "=", NAME]):
        text = "malformed '#pragma weak' is ignored: expected 'name' or 'name = other'"
        state.report.warning(tokens[0].position, text, flag="pragmas")
        return
    location = state.report.source_map.location(tokens[1].position)
    state.weak[tokens[1].text] = WeakName(location, "" if len(shape) == 1 else tokens[3].text)


def _ignore(_state: State, _line: _Line) -> None:
    """Ignore `#ident` and `#sccs`, which put comments into object files."""


_DIRECTIVES: Final[dict[str, Callable[[State, _Line], None]]] = {
    "define": _define,
    "undef": _undef,
    "include": _include,
    "import": _include,
    "embed": _embed,
    "include_next": _include,
    "if": _if,
    "ifdef": _ifdef,
    "ifndef": _ifdef,
    "elif": _elif,
    "elifdef": _elif,
    "elifndef": _elif,
    "else": _else,
    "endif": _endif,
    "error": _error,
    "warning": _warning,
    "line": _line,
    "pragma": _pragma,
    "ident": _ignore,
    "sccs": _ignore,
}
_IN_SKIPPED_GROUPS: Final = frozenset(
    {"if", "ifdef", "ifndef", "elif", "elifdef", "elifndef", "else", "endif"}
)
