"""The attributes of `launch`, in one table.

Those that describe the run become a command line of `crs debug`, so that they have the same
meaning and are validated by the same code.

>>> values = {"program": "wander.c", "world": "room.xml", "seed": 3, "cwd": "/home/me"}
>>> launch = read_launch(Arguments(values))
>>> launch.command_line, launch.folder
(('--seed=3', 'wander.c', 'room.xml'), '/home/me')
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Final, Literal

from crs_cc.debug.dap.arguments import Arguments, RefusalError

Kind = Literal["string", "integer", "boolean", "array"]


@dataclass(frozen=True, slots=True)
class LaunchAttribute:
    """An attribute of `launch`.

    Attributes:
        kind: its type in JSON; an `array` contains strings, and a single string counts as one.
        meaning: its description for users.
        option: the option of `crs debug` that it becomes; empty for those of the editor only,
            and for positional arguments.
        choices: the valid values; empty for any.
    """

    name: str
    kind: Kind
    meaning: str
    option: str = ""
    default: Any = None
    choices: tuple[str, ...] = ()


ATTRIBUTES: Final = (
    LaunchAttribute(
        "program",
        "array",
        "The C file, or several files of one program. Optional if the world names a program for"
        " each robot.",
    ),
    LaunchAttribute("world", "string", "The world file. Default: an empty world."),
    LaunchAttribute(
        "token",
        "string",
        "The token that `crs debug --dap PORT` requires; not used with `stdio`.",
    ),
    LaunchAttribute("args", "array", "Arguments of the program, after `argv[0]`."),
    LaunchAttribute(
        "cwd",
        "string",
        "The directory that file names are relative to. Default: the working directory of `crs`.",
    ),
    LaunchAttribute(
        "stopOnEntry", "boolean", "Stop before the first statement of the program.", default=False
    ),
    LaunchAttribute(
        "stopAtEnd",
        "boolean",
        "Stop when all programs have ended, so that you can step back; continuing then ends the"
        " session.",
        default=True,
    ),
    LaunchAttribute("seed", "integer", "Random seed. Default: that of the world.", "--seed"),
    LaunchAttribute(
        "robot", "string", "The robot definition, where the world does not name one.", "--robot"
    ),
    LaunchAttribute("setup", "string", "The setup of all robots, such as `noisy`.", "--setup"),
    LaunchAttribute(
        "link",
        "string",
        "Simulate the delay of the link to the robot (serial), or none (ideal).",
        "--link",
        choices=("serial", "ideal"),
    ),
    LaunchAttribute(
        "client",
        "string",
        "The vendor's library to imitate: for its simulator, or for the robot itself.",
        "--client",
        choices=("nclient", "ndirect"),
    ),
    LaunchAttribute(
        "files",
        "array",
        "Files that the programs can read, each as `FILE` or `NAME=FILE`.",
        "--file",
    ),
    LaunchAttribute("input", "string", "A file of input lines with simulated times.", "--input"),
    LaunchAttribute("stdin", "string", "The standard input of the programs.", "--stdin"),
    LaunchAttribute("include", "array", "Directories searched by `#include`.", "--include"),
    LaunchAttribute(
        "define", "array", "Macro definitions, each as `NAME` or `NAME=VALUE`.", "--define"
    ),
    LaunchAttribute("undefine", "array", "Macros to undefine.", "--undefine"),
    LaunchAttribute("standard", "string", "The C standard, such as `gnu17`.", "-std"),
    LaunchAttribute(
        "dialect",
        "string",
        "The dialect of the program.",
        "--dialect",
        choices=("nomad", "report"),
    ),
    LaunchAttribute(
        "unchecked",
        "boolean",
        "Disable the checks of memory accesses.",
        "--unchecked",
        default=False,
    ),
    LaunchAttribute(
        "trapOverflow",
        "boolean",
        "Stop a program on signed overflow.",
        "--trap-overflow",
        default=False,
    ),
)

_OF_EDITORS: Final = (
    *("type", "name", "request", "noDebug", "debugServer", "preLaunchTask", "postDebugTask"),
    *("internalConsoleOptions", "presentation", "serverReadyAction", "console", "consoleMode"),
    *("suppressMultipleSessionWarning", "linux", "osx", "windows"),
)
"""Attributes of editors' own in a configuration."""

_KNOWN: Final = frozenset({attribute.name for attribute in ATTRIBUTES} | set(_OF_EDITORS))


@dataclass(frozen=True, slots=True)
class Launch:
    """The run that an editor asks for, and where it stops automatically.

    Attributes:
        command_line: arguments of `crs debug`.
        folder: the working directory, empty for the current one.
        stop_on_entry: whether to stop before the first statement.
        stop_at_end: whether to stop when all programs have ended.
        debugs: whether to stop at all.
        unknown: unknown attributes.
    """

    command_line: tuple[str, ...]
    folder: str = ""
    stop_on_entry: bool = False
    stop_at_end: bool = True
    debugs: bool = True
    unknown: tuple[str, ...] = ()


def read_launch(arguments: Arguments) -> Launch:
    """Read the arguments of `launch`.

    Raises:
        RefusalError: an attribute is of the wrong type, or one is missing.
    """
    by_name = {each.name: _values(arguments, each) for each in ATTRIBUTES}
    files = by_name["program"] + by_name["world"]
    if not files:
        raise RefusalError("launch specifies neither a program nor a world")
    line = [
        f"{each.option}={value}" if value else each.option
        for each in ATTRIBUTES
        for value in by_name[each.name]
        if each.option
    ]
    line += [f"./{file}" if file.startswith("-") else file for file in files]  # no option
    if by_name["args"]:
        line += ["--", *by_name["args"]]
    folder = arguments.text("cwd", "")
    if any("\0" in word for word in (*line, folder)):
        raise RefusalError("an attribute of launch contains a NUL character")
    return Launch(
        tuple(line),
        folder,
        arguments.flag("stopOnEntry", default=False),
        arguments.flag("stopAtEnd", default=True),
        not arguments.flag("noDebug", default=False),
        tuple(name for name in arguments.names() if name not in _KNOWN and name[0:1] != "_"),
    )


def _values(arguments: Arguments, attribute: LaunchAttribute) -> list[str]:
    """Return an attribute as words of a command line."""
    name = attribute.name
    if name not in arguments:
        return []
    if attribute.kind == "boolean":
        return [""] if arguments.flag(name) else []
    if attribute.kind == "integer":
        return [str(arguments.natural(name))]
    values = arguments.texts(name) if attribute.kind == "array" else [arguments.text(name)]
    if "" in values and name != "args":
        raise RefusalError(f"'{name}' is empty")
    if attribute.choices and values[0] not in attribute.choices:
        raise RefusalError(f"'{name}' must be {' or '.join(attribute.choices)}")
    return values
