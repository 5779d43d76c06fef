"""Writes `docs/editors.md` and the extension for VS Code from the attributes of `launch`.

`--update-goldens` rewrites them.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from crs_cc import __version__
from crs_cc.debug.commands.table import NAMES
from crs_cc.debug.dap.arguments import Arguments
from crs_cc.debug.dap.breakpoint_requests import FILTERS
from crs_cc.debug.dap.launch import ATTRIBUTES, LaunchAttribute, read_launch
from tests.debug.dap.client import Client
from tests.debug.dap.programs import open_run

ROOT = Path(__file__).parents[3]
PAGE = ROOT / "docs" / "editors.md"
EXTENSION = ROOT / "editors" / "vscode" / "package.json"
NEOVIM = ROOT / "editors" / "nvim" / "crs.lua"

CONFIGURATION = {
    "name": "This program in a room",
    "type": "crs",
    "request": "launch",
    "program": "${file}",
    "world": "${workspaceFolder}/worlds/room.xml",
    "cwd": "${workspaceFolder}",
    "args": [],
    "stopOnEntry": True,
}

WHERE = {
    "thread": "a robot; all stop together, as they share time",
    "step over, into, out": (
        "to the next line of that robot's program, over or into calls, or out of the function"
    ),
    "step back": "to the previous line, over calls",
    "reverse continue": "back to the previous stop, or to the start",
    "breakpoint": (
        "at the next line with code if there is none in this one; with a C expression as "
        "condition, with a hit count (`5` and `>= 5`: from the fifth on; `> 5`), or as a log "
        "point with C expressions in braces"
    ),
    "function breakpoint": (
        "at a function of the program, or at calls of the robot (`ws`, `get_sn`)"
    ),
    "data breakpoint": "when an object is changed, read, or either, also through pointers",
    "exception breakpoints": "events in the world, see below; runtime errors always stop",
    "jump to cursor": (
        "runs to the next visit of the line, or back to the previous one; nothing is skipped"
    ),
    "variables": (
        "*Locals*; *Globals*; *State*, the vendor's `State[]` with names and units; *Robot* "
        "and *World*: their true state, not what the program believes"
    ),
    "set value": "changes the program, and starts a new history from there",
    "watch, hover": "C expressions without side effects",
    "debug console": (
        "C expressions, which may change the program; anything that is not a valid "
        "expression is a [command](debugger.md): `reverse-finish`, `goto t=12.5`, `robot 1`, "
        "`move robot0 to 1 2 90`"
    ),
    "disassembly": "the program as `crs compile` shows it",
    "memory": "the program's bytes",
    "restart": "compiles the files again and restarts with the same breakpoints",
    "restart frame": "refused: step back to the call instead",
}

TEXT = """\
<!-- made by tests/debug/dap/test_editors_page.py of crs_cc/debug/dap/launch.py; edit there,
     then pytest --update-goldens -->

# The debugger in editors

`crs debug --dap stdio` serves an editor over the [Debug Adapter Protocol][dap]: breakpoints,
stepping forward and backward, variables, watches and a console in the editor's own windows, with
the robots as threads and the world beside the variables. The editor starts it; nothing else is
needed.

[dap]: https://microsoft.github.io/debug-adapter-protocol/

## VS Code

The extension is only a manifest, which tells VS Code to run `crs`. Start VS Code where that can
be found, for example with the virtual environment active. To try it:

    code --extensionDevelopmentPath="$PWD/editors/vscode" .

To install it, package it with VS Code's own tool (requires Node):

    cd editors/vscode
    npx @vscode/vsce package --skip-license --allow-missing-repository
    code --install-extension crs-debug-*.vsix

Set breakpoints in a C file and press F5, or create `.vscode/launch.json`:

```json
{launch}
```

To start the server yourself and see its messages, add `"debugServer": 4711` to the
configuration and run `crs debug --dap 4711`. It listens on the loopback interface only, and serves
one editor after the other.

## Neovim

With [nvim-dap](https://codeberg.org/mfussenegger/nvim-dap), `editors/nvim/crs.lua`:

```lua
{neovim}```

## Other editors

Configure the editor's DAP client to run `crs debug --dap stdio`, or to connect to a port, and to
`launch` with the attributes below.

## Attributes of `launch`

Editors replace `${{file}}` and `${{workspaceFolder}}` first. A value of the wrong type is refused
with a message.

{attributes}

Programs have no terminal to read from: they read `input`. Their output is shown in the
console whenever it is written, so again when a part of the run is repeated.

## Where to find what

{where}

When all programs have ended the run stops once more, so that you can go back; continuing then ends
the session. While programs run, breakpoints can be set; pause them to inspect anything.

## Exception breakpoints

A condition is a C expression, evaluated in the program of the robot of the event.

{filters}
"""


def cell(text: str) -> str:
    return text.replace("|", "\\|")


def attribute_rows() -> Iterator[str]:
    yield "| attribute | type | by default | |"
    yield "| --- | --- | --- | --- |"
    for each in ATTRIBUTES:
        kind = "strings" if each.kind == "array" else each.kind
        if each.choices:
            kind = " or ".join(f"`{choice}`" for choice in each.choices)
        default = "" if each.default is None else f"`{json.dumps(each.default)}`"
        yield f"| `{each.name}` | {kind} | {default} | {cell(each.meaning)} |"


def where_rows() -> Iterator[str]:
    yield "| in the editor | what it is |"
    yield "| --- | --- |"
    yield from (f"| {name} | {meaning} |" for name, meaning in WHERE.items())


def filter_rows() -> Iterator[str]:
    yield "| filter | stops when |"
    yield "| --- | --- |"
    for each in FILTERS:
        meaning = each["description"].removeprefix("Stop when ").rstrip(".")
        yield f"| `{each['filter']}` | {meaning} |"


def page() -> str:
    launch = {"version": "0.2.0", "configurations": [CONFIGURATION]}
    return TEXT.format(
        launch=json.dumps(launch, indent=2),
        neovim=NEOVIM.read_text(),
        attributes="\n".join(attribute_rows()),
        where="\n".join(where_rows()),
        filters="\n".join(filter_rows()),
    )


def schema_of(attribute: LaunchAttribute) -> dict[str, Any]:
    """Return the JSON schema of an attribute."""
    made: dict[str, Any] = {"type": attribute.kind, "description": attribute.meaning}
    if attribute.kind == "array":
        made |= {"type": ["array", "string"], "items": {"type": "string"}}
    if attribute.choices:
        made["enum"] = list(attribute.choices)
    if attribute.default is not None:
        made["default"] = attribute.default
    return made


def extension() -> dict[str, Any]:
    """Return the manifest of the extension, which is all that there is of it."""
    properties = {each.name: schema_of(each) for each in ATTRIBUTES}
    return {
        "name": "crs-debug",
        "displayName": "CRS robot programs",
        "description": "Steps through C programs of robots and their world, forward and backward",
        "publisher": "crs",
        "version": __version__,
        "engines": {"vscode": "^1.75.0"},
        "categories": ["Debuggers"],
        "contributes": {
            "breakpoints": [{"language": "c"}],
            "debuggers": [
                {
                    "type": "crs",
                    "label": "CRS",
                    "languages": ["c"],
                    "runtime": "crs",
                    "runtimeArgs": ["debug", "--dap", "stdio"],
                    "configurationAttributes": {"launch": {"properties": properties}},
                    "initialConfigurations": [CONFIGURATION],
                    "configurationSnippets": [
                        {
                            "label": "CRS: a program in a world",
                            "description": "Debug a robot's program",
                            "body": CONFIGURATION | {"program": '^"\\${file}"'},
                        }
                    ],
                }
            ],
        },
    }


def test_the_page_is_up_to_date(check_golden: Callable[[Path, bytes], None]) -> None:
    check_golden(PAGE, page().encode())


def test_the_extension_is_up_to_date(check_golden: Callable[[Path, bytes], None]) -> None:
    check_golden(EXTENSION, f"{json.dumps(extension(), indent=2)}\n".encode())


@pytest.mark.parametrize("name", ["json", "lua"])
def test_the_configurations_shown_can_be_launched(name: str) -> None:
    values: dict[str, Any] = CONFIGURATION
    if name == "lua":
        block = re.search(
            r"table\.insert\(dap\.configurations\.c, \{\n(.*?)\n\}\)", NEOVIM.read_text(), re.DOTALL
        )
        assert block is not None
        text = re.sub(r"^  (\w+) = ", r'"\1": ', block[1].rstrip(","), flags=re.MULTILINE)
        values = json.loads(f"{{{text.replace('{}', '[]')}}}")
    assert values == CONFIGURATION
    place = {"${file}": "samples/scout_c/wander.c", "${workspaceFolder}": "."}
    filled = json.loads(re.sub(r"\$\{\w+\}", lambda found: place[found[0]], json.dumps(values)))
    assert read_launch(Arguments(filled)).command_line == (
        "samples/scout_c/wander.c",
        "./worlds/room.xml",
    )
    with Client(open_run) as client:
        client.launch(ROOT / filled["program"], world=str(ROOT / filled["world"]), stopOnEntry=True)
        client.begin()


def test_attributes_are_validated_as_in_the_extension() -> None:
    properties = extension()["contributes"]["debuggers"][0]["configurationAttributes"]["launch"]
    for name, schema in properties["properties"].items():
        kinds = {"array": ["x"], "string": "x", "integer": 3, "boolean": True}
        kind = schema["type"][0] if isinstance(schema["type"], list) else schema["type"]
        value = schema["enum"][0] if "enum" in schema else kinds[kind]
        assert read_launch(Arguments({"program": "a.c", name: value}))


def test_the_commands_named_on_the_page_exist() -> None:
    for name in ("reverse-finish", "goto", "robot", "move"):
        assert name in NAMES
