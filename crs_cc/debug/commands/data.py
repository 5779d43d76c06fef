"""Commands for expressions, variables and memory."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import TYPE_CHECKING, Final

from crs_cc.core.suggest import unknown
from crs_cc.debug.commands.answer import Answer, NestedCommand
from crs_cc.debug.commands.arguments import (
    OutputFormat,
    parse_format,
    parse_numbers,
    parse_pattern,
    require_argument,
    split_arguments,
)
from crs_cc.debug.commands.c_format import formatted_text, string_literal
from crs_cc.debug.commands.command import Command, Group
from crs_cc.debug.commands.context import CommandContext
from crs_cc.debug.commands.display import Display, remove_displays
from crs_cc.debug.commands.formats import MAX_TEXT_LENGTH, dump, formatted, place_text, quoted
from crs_cc.debug.commands.settings import SETTINGS, WITHOUT_EFFECT, parse_setting
from crs_cc.debug.commands.show import SHOW
from crs_cc.debug.commands.stack import frame, variable_text
from crs_cc.debug.commands.type_declaration import declared
from crs_cc.debug.errors import DebugError
from crs_cc.ir.types import ArrayType, RecordType, VoidType

if TYPE_CHECKING:
    from crs_cc.debug.data.values import Value
    from crs_cc.debug.data.variables import Variable

_MAX_STRINGS: Final = 100
_OPTION: Final = re.compile(r"-(elements|pretty)(?:\s+(on|off|unlimited|\d+))?\s+")
_OPTIONS: Final = re.compile(rf"(?:{_OPTION.pattern})+--\s+")


def _print(context: CommandContext, text: str) -> Answer:
    if options := _OPTIONS.match(text):
        chosen = [(f"print {name}", value or "on") for name, value in _OPTION.findall(options[0])]
        with _changed(context, chosen):
            yield from _print(context, text[options.end() :])
        return
    wanted, expression = parse_format(text)
    value = context.debugger.evaluate(expression or "$")
    shown = formatted(value, wanted)
    yield shown if isinstance(value.type, VoidType) else f"${context.record(value)} = {shown}"


@contextmanager
def _changed(context: CommandContext, changes: list[tuple[str, str]]) -> Iterator[None]:
    """Change settings for a while."""
    try:
        with context.settings.temporarily(changes):
            context.apply_settings()
            yield
    finally:
        context.apply_settings()


def _printf(context: CommandContext, text: str) -> Answer:
    literal, *expressions = split_arguments(require_argument(text, '"FORMAT",EXPRESSION...'))
    pattern = string_literal(literal)
    values = [context.debugger.view.evaluate_pure(each) for each in expressions]
    yield formatted_text(pattern, values).removesuffix("\n")


def _call(context: CommandContext, text: str) -> Answer:
    value = context.debugger.evaluate(require_argument(text, "an expression"))
    if not isinstance(value.type, VoidType):
        yield f"${context.record(value)} = {formatted(value, OutputFormat())}"


def _set(context: CommandContext, text: str) -> Answer:
    words = require_argument(text, "an assignment, such as speed = 3").split(maxsplit=1)
    setting, value = parse_setting(text)
    if setting is not None and not value.startswith("="):
        context.settings.change(setting.name, value)
        context.apply_settings()
        return
    if words[0] in {"var", "variable"}:
        text = require_argument(
            words[1] if len(words) > 1 else "", "an assignment, such as speed = 3"
        )
    elif words[0] in WITHOUT_EFFECT and (len(words) == 1 or words[1][:1].isalnum()):
        yield f"'{words[0]}' has no effect here: {WITHOUT_EFFECT[words[0]]}"
        return
    if "=" not in text:
        raise DebugError(
            f"'{text}' is neither an assignment (VARIABLE = EXPRESSION) nor a setting"
            f" (known: {', '.join(each.name for each in SETTINGS)})"
        )
    context.debugger.evaluate(text)
    yield from ()


def _with(context: CommandContext, text: str) -> Answer:
    setting, _, command = text.partition(" -- ")
    command = require_argument(command, "a command: with SETTING VALUE -- COMMAND")
    found, value = parse_setting(setting)
    if found is None:
        raise DebugError(unknown("setting", setting, [each.name for each in SETTINGS]))
    with _changed(context, [(found.name, value)]):
        yield NestedCommand(command)


def _whatis(context: CommandContext, text: str) -> Answer:
    yield str(context.debugger.view.type_of(require_argument(text, "an expression or a type")))


def _ptype(context: CommandContext, text: str) -> Answer:
    is_laid_out = text.startswith("/o")
    named = require_argument(text.removeprefix("/o"), "an expression or a type")
    yield from declared(context.debugger.view.type_of(named), is_laid_out=is_laid_out)


def _examine(context: CommandContext, text: str) -> Answer:
    wanted, expression = parse_format(text)
    if expression:
        value = context.debugger.view.evaluate_pure(expression)
        address = _address(value)
    elif context.examined is not None:
        address, known = context.examined
        wanted = replace(known, count=wanted.count)
    else:
        raise DebugError("an address is missing: x ADDRESS")
    if wanted.letter == "s":
        yield from _strings(context, address, wanted)
        return
    yield from dump(
        context.debugger.view.evaluator(context.debugger.view.robot).inspector(), address, wanted
    )
    size = wanted.size or 4
    context.examined = address + size * wanted.count, wanted
    context.keep_examined(address + size * (wanted.count - 1), size)


def _address(value: Value) -> int:
    """Return the address that a value denotes: a pointer, an integer, or that of an object."""
    if isinstance(value.type, ArrayType | RecordType):
        if value.address is None:
            raise DebugError("expression has no address")
        return value.address
    if not isinstance(value.number, int):
        raise DebugError(f"{value.text} is not an address")
    return value.number & 0xFFFF_FFFF


def _strings(context: CommandContext, address: int, wanted: OutputFormat) -> Answer:
    inspector = context.debugger.view.evaluator(context.debugger.view.robot).inspector()
    for _ in range(min(wanted.count, _MAX_STRINGS)):
        content = inspector.read(address, MAX_TEXT_LENGTH + 1)
        if not content:
            raise DebugError(f"cannot access memory at {address:#x}")
        yield f"{place_text(inspector, address)}: {quoted(content)}"
        address += min(len(content.partition(b"\0")[0]), MAX_TEXT_LENGTH) + 1
    context.examined = address, wanted


def _display(context: CommandContext, text: str) -> Answer:
    if not text:
        yield from context.show_displays()
        return
    wanted, expression = parse_format(text)
    display = Display(require_argument(expression, "an expression"), wanted)
    shown = display.text(context.debugger)
    number = max(context.displays, default=0) + 1
    context.displays[number] = display
    yield f"{number}: {shown}"


def _undisplay(context: CommandContext, text: str) -> Answer:
    remove_displays(context.displays, parse_numbers(text))
    yield from ()


def _info_display(context: CommandContext, _text: str) -> Answer:
    if not context.displays:
        yield "No displays."
    for number, display in context.displays.items():
        disabled = "" if display.is_enabled else "  (disabled)"
        yield f"{number}: {display.name}{disabled}"


def _variable(context: CommandContext, each: Variable) -> str:
    hidden = "  (shadowed)" if each.is_hidden else ""
    return f"{each.name} = {variable_text(context, each)}{hidden}"


def _info_locals(context: CommandContext, _text: str) -> Answer:
    here = frame(context)
    variables = context.debugger.view.variables(frame=here.number)
    found = [each for each in variables if each.scope != "parameter"]
    if not found:
        yield "No locals."
    yield from (_variable(context, each) for each in found)


def _info_args(context: CommandContext, _text: str) -> Answer:
    here = frame(context)
    found = [
        each
        for each in context.debugger.view.variables(frame=here.number)
        if each.scope == "parameter"
    ]
    if not found:
        yield "No arguments."
    yield from (_variable(context, each) for each in found)


def _info_globals(context: CommandContext, text: str) -> Answer:
    pattern = parse_pattern(text)
    found = [each for each in context.debugger.view.globals_() if pattern.search(each.name)]
    if not found:
        raise DebugError(f"no global variable matches '{text}'")
    yield from (_variable(context, each) for each in found)


_FORMATS: Final = (
    "FMT is a letter: x hexadecimal, z the same with leading zeros, d signed, u unsigned, o octal,"
    " t binary, c character, f floating-point, s string, a address."
)
_CHANGES: Final = (
    "Assignments and function calls change the program and start a new history from here."
)

DATA: Final = Group(
    "data",
    "Expressions, variables and memory.",
    (
        Command(
            "print", "[-OPTION... --] [/FMT] [EXPRESSION]", "Print the value of a C expression.",
            _print,
            ("p", "inspect"),
            text="It can use all operators, casts, macros and the program's functions. "
            "Extensions: a[2..5] and *p@4 are slices, turn::count and 'map.c'::size are "
            "variables of other functions and files, $3 is a printed value, $ the last one, $$ "
            "the one before, $$4 the fourth before the last; $_ is the address that x examined "
            "last and $__ its contents, $_exitcode the exit status of the program; $name = 7 "
            f"sets a convenience variable. Without EXPRESSION, print $. {_FORMATS} The options "
            "-pretty and -elements N override the print settings for this value; -- ends the "
            f"options. {_CHANGES}",
            completes="expression",
        ),
        Command(
            "printf", '"FORMAT",EXPRESSION...', "Print values as the function printf would.",
            _printf, text="FORMAT is that of C; %s prints the string in an array or at a pointer.",
            completes="expression",
        ),
        Command(
            "call", "EXPRESSION", "Evaluate a C expression, and print its value unless void.",
            _call, text=_CHANGES, completes="expression",
        ),
        Command(
            "set", "[var] VARIABLE = EXPRESSION|SETTING VALUE",
            "Assign to a variable or memory, or change a setting.", _set,
            text=f"{_CHANGES} Settings are {', '.join(each.name for each in SETTINGS)}; settings"
            " made at a terminal are kept for later sessions.", completes="expression",
        ),
        Command(
            "with", "SETTING VALUE -- COMMAND", "Execute a command with a setting changed.", _with,
            completes="setting",
        ),
        SHOW,
        Command(
            "display", "[/FMT] [EXPRESSION]", "Show an expression now and at every stop.", _display,
            text=f"Omitted where it cannot be evaluated. {_FORMATS}",
            completes="expression",
        ),
        Command(
            "undisplay", "[N...]", "Delete displays; default is all.",
            _undisplay, completes="display",
        ),
        Command("info display", "", "List the displayed expressions.", _info_display),
        Command(
            "whatis", "EXPRESSION", "Print the type of an expression.", _whatis,
            completes="expression",
        ),
        Command(
            "ptype", "[/o] EXPRESSION|TYPE", "Print the definition of a type.", _ptype,
            text="With /o, also offsets and sizes of members.",
            completes="expression",
        ),
        Command(
            "x", "[/NFU] [ADDRESS]", "Examine memory.", _examine,
            text="N units in format F, of size U: b one byte, h two, w four, g eight. "
            + _FORMATS + " ?? marks uninitialised memory, -- memory that belongs to no object."
            " Without ADDRESS, continue after the last address examined.",
            repeats="on", completes="expression",
        ),
        Command(
            "info locals", "", "Show the local variables of the selected frame.",
            _info_locals, ("info lo",),
        ),
        Command("info args", "", "Show the arguments of the selected frame.", _info_args),
        Command(
            "info globals", "[REGEX]", "Show the global variables whose names match REGEX.",
            _info_globals, ("info variables",), completes="expression",
        ),
    ),
)  # fmt: skip
