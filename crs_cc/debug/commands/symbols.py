"""Commands for declarations in the source: files, functions, variables, types, macros."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from crs_cc.core.source import Location
from crs_cc.debug.commands.answer import Answer, SourceLine
from crs_cc.debug.commands.arguments import OutputFormat, parse_pattern, require_argument
from crs_cc.debug.commands.command import Command, Group
from crs_cc.debug.commands.context import CommandContext
from crs_cc.debug.commands.formats import formatted
from crs_cc.debug.commands.source_search import FORWARD_SEARCH, REVERSE_SEARCH
from crs_cc.debug.commands.stack import find_line, function_body, functions, line_count
from crs_cc.debug.data.scope import is_own
from crs_cc.debug.errors import DebugError
from crs_cc.debug.locations import find_location
from crs_cc.ir.names import plain_name
from crs_cc.ir.types import spell

_MAX: Final = 200
"""So many names are listed."""


def _listed(lines: list[str], what: str, text: str) -> Answer:
    """Answer with some lines, and how many more there are."""
    if not lines:
        raise DebugError(f"no {what} matches '{text}'" if text else f"no {what}")
    yield from lines[:_MAX]
    if len(lines) > _MAX:
        yield f"(and {len(lines) - _MAX} more)"


def _info_functions(context: CommandContext, text: str) -> Answer:
    pattern = parse_pattern(text)
    found = sorted((place, name) for name, place in functions(context) if pattern.search(name))
    lines = [f"{place.file}:{place.line}: {name}" for place, name in found]
    return _listed(lines, "function", text)


def _info_line(context: CommandContext, text: str) -> Answer:
    place = context.debugger.view.location()
    if text:
        place = function_body(context, text) or find_line(context, text)
    if place is None:
        raise DebugError("no current line: specify a line or a function")
    lines = context.debugger.view.source(place.file)
    yield f"{place.file}:{place.line}"
    if 0 < place.line <= len(lines):
        yield SourceLine(place.line, lines[place.line - 1])


def _info_source(context: CommandContext, _text: str) -> Answer:
    here = context.debugger.view.location()
    for file, lines in _sources(context):
        mark = "=>" if here is not None and here.file == file else "  "
        yield f"{mark} {file}, {lines} lines"


def _info_sources(context: CommandContext, text: str) -> Answer:
    """List all files, headers included."""
    view = context.debugger.view
    detail = context.debugger.run.programs[view.robot].executable.detail()
    pattern = parse_pattern(text)
    files = sorted(file for file in detail.lines if pattern.search(file))
    return _listed(files, "source file", text)


def _sources(context: CommandContext) -> Iterator[tuple[str, int]]:
    """Return the C files of the selected robot's program, with their numbers of lines."""
    view = context.debugger.view
    for file in context.debugger.run.programs[view.robot].files:
        yield file, line_count(view.source(file))


def _info_types(context: CommandContext, text: str) -> Answer:
    found, pattern = [], parse_pattern(text)
    for place, ctype, alias in context.debugger.view.file_names().types():
        shown = f"typedef {spell(ctype, alias)};" if alias else f"{ctype};"
        if place.line and is_own(place) and pattern.search(alias or str(ctype)):
            found.append((place, shown))
    lines = [f"{place.file}:{place.line}: {shown}" for place, shown in sorted(found)]
    return _listed(lines, "type", text)


def _info_scope(context: CommandContext, text: str) -> Answer:
    debugger = context.debugger
    view = debugger.view
    place = find_location(
        require_argument(text, "a line or a function"),
        debugger.run.programs,
        [view.robot],
        view.current_file(),
    )
    sites = debugger.run.programs[view.robot].executable.detail().compiled.statements
    numbers = place.statements.get(view.robot, frozenset())
    if place.location is None or not numbers:
        raise DebugError(f"'{text}' is a robot function and has no source")
    site = sites[min(numbers)]
    found = view.declared_at(site.function, site.location)
    name = plain_name(site.function)
    if not found:
        yield f"No variables of '{name}' at {site.location.file}:{site.location.line}."
        return
    yield f"Variables of '{name}' at {site.location.file}:{site.location.line}:"
    for each in found:
        variable = each.variable
        yield f"  {each.kind} {spell(variable.ctype, variable.name)}, line {variable.location.line}"


def _info_symbol(context: CommandContext, text: str) -> Answer:
    view = context.debugger.view
    number = view.evaluate_pure(require_argument(text, "an address, such as &total")).number
    name = ""
    if isinstance(number, int):
        name = view.evaluator(view.robot).inspector().symbol_at(number)
    yield name or f"No variable or function is at {text}."


def _info_address(context: CommandContext, text: str) -> Answer:
    name = require_argument(text, "the name of a variable or a function")
    value = context.debugger.view.evaluate_pure(f"&({name})")
    yield f"{name} is at {formatted(value, OutputFormat('a'))}"


def _info_macro(context: CommandContext, text: str) -> Answer:
    name = require_argument(text, "the name of a macro")
    found = context.debugger.view.file_names().macro(name)
    if found is None:
        raise DebugError(f"no macro '{name}' at the end of {context.debugger.view.current_file()}")
    yield f"{_place(found[0])}: {found[1]}"


def _place(place: Location) -> str:
    return f"{place.file}:{place.line}" if place.file else "predefined"


def _macro_expand(context: CommandContext, text: str) -> Answer:
    yield context.debugger.view.file_names().expanded(require_argument(text, "an expression"))


SYMBOLS: Final = Group(
    "symbols",
    "What the source contains and declares.",
    (
        FORWARD_SEARCH,
        REVERSE_SEARCH,
        Command(
            "info line", "[LOCATION]", "Show the location of a line or a function.", _info_line,
            text="Default is the current line.",
            completes="place",
        ),
        Command(
            "info functions", "[REGEX]", "List the functions whose names match REGEX.",
            _info_functions, completes="place",
        ),
        Command(
            "info types", "[REGEX]", "List the types whose names match REGEX.", _info_types,
            text="Structs, unions, enums and typedef names of the current file and its headers.",
        ),
        Command(
            "info scope", "LOCATION", "List the local variables visible at a location.",
            _info_scope, completes="place",
        ),
        Command("info source", "", "List the C files of the program.", _info_source),
        Command(
            "info sources", "[REGEX]", "List all source files, headers included.", _info_sources,
            text="With REGEX, those whose names match it.",
        ),
        Command(
            "info symbol", "ADDRESS", "Show which variable or function is at an address.",
            _info_symbol, completes="expression",
        ),
        Command(
            "info address", "NAME", "Show the address of a variable or a function.",
            _info_address, completes="expression",
        ),
        Command(
            "info macro", "NAME", "Show the definition of a macro.", _info_macro, completes="macro",
            text="Macros are taken as defined at the end of the current file.",
        ),
        Command(
            "macro expand", "EXPRESSION", "Show an expression with its macros replaced.",
            _macro_expand, ("macro exp",), completes="expression",
        ),
    ),
)  # fmt: skip
