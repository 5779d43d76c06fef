"""Tables of `docs/editors.md`, and the manifest of the VS Code extension.

Both come from the attributes of the `launch` request.
"""

from __future__ import annotations

import json
from typing import Any, Final

from crs_cc import __version__
from crs_cc.core.loopback import MESSAGE_S, STALL_S
from crs_cc.debug.dap.breakpoint_requests import FILTERS
from crs_cc.debug.dap.launch import ATTRIBUTES, LaunchAttribute
from crs_cc.debug.dap.port import MAX_CLIENTS
from docs.generate import ROOT, Fillers, cell, table

EXTENSION: Final = ROOT / "editors" / "vscode" / "package.json"
NEOVIM: Final = ROOT / "editors" / "nvim" / "crs.lua"

_BACK: Final = {"enablement": "inDebugMode && debugType == 'crs'", "category": "CRS"}
COMMANDS: Final = (
    {
        "command": "crs.showWorkbench",
        "title": "Show the run in the workbench",
        "category": "CRS",
    },
    {
        "command": "crs.stepBackInto",
        "title": "Step back, into calls",
        "icon": "$(arrow-circle-left)",
        **_BACK,
    },
    {
        "command": "crs.stepBackOut",
        "title": "Step back to the call of this function",
        "icon": "$(arrow-circle-up)",
        **_BACK,
    },
)
"""The commands of the extension; VS Code itself steps back over calls."""

CONFIGURATION: Final = {
    "name": "This program in a room",
    "type": "crs",
    "request": "launch",
    "program": "${file}",
    "world": "${workspaceFolder}/worlds/room.xml",
    "cwd": "${workspaceFolder}",
    "args": [],
    "stopOnEntry": True,
}


def launch() -> str:
    """Return an example of VS Code's `launch.json`."""
    return json.dumps({"version": "0.2.0", "configurations": [CONFIGURATION]}, indent=2)


def neovim() -> str:
    """Return the configuration of nvim-dap."""
    return NEOVIM.read_text().rstrip("\n")


def attributes() -> str:
    """Return the table of the attributes of `launch`."""
    titles = ("attribute", "type", "default", "description")
    return table(titles, [_row(each) for each in ATTRIBUTES])


def _row(each: LaunchAttribute) -> tuple[str, ...]:
    kind: str = "strings" if each.kind == "array" else each.kind
    if each.choices:
        kind = " or ".join(f"`{choice}`" for choice in each.choices)
    default = "" if each.default is None else f"`{json.dumps(each.default)}`"
    return f"`{each.name}`", kind, default, cell(each.meaning)


def filters() -> str:
    """Return the table of the exception breakpoints."""
    rows = [
        (f"`{each['filter']}`", each["description"].removeprefix("Stop when ").rstrip("."))
        for each in FILTERS
    ]
    return table(("filter", "stops when"), rows)


def extension_text() -> str:
    """Return the manifest of the VS Code extension as JSON."""
    return f"{json.dumps(extension(), indent=2)}\n"


def extension() -> dict[str, Any]:
    """Return the manifest of the VS Code extension."""
    properties = {each.name: _schema(each) for each in ATTRIBUTES}
    return {
        "name": "crs-debug",
        "displayName": "CRS robot programs",
        "description": "Debug C robot programs and their simulated world, forward and backward",
        "publisher": "crs",
        "version": __version__,
        "engines": {"vscode": "^1.75.0"},
        "categories": ["Debuggers"],
        "license": "MIT",
        "icon": "icon.png",
        "main": "./extension.js",
        "activationEvents": ["onDebugResolve:crs"],
        "files": ["extension.js", "icon.png", "LICENSE", "README.md"],
        "contributes": {
            "commands": list(COMMANDS),
            "menus": {
                "debug/toolBar": [
                    {
                        "command": each["command"],
                        "when": "debugType == 'crs'",
                        "group": f"crs@{place}",
                    }
                    for place, each in enumerate(COMMANDS)
                    if "enablement" in each
                ]
            },
            "configuration": {
                "title": "CRS",
                "properties": {
                    "crs.command": {
                        "type": "string",
                        "default": "crs",
                        "scope": "machine",
                        "description": "The command crs, or its path.",
                    }
                },
            },
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
                            "description": "Debug a robot program",
                            "body": CONFIGURATION | {"program": '^"\\${file}"'},
                        }
                    ],
                }
            ],
        },
    }


def _schema(attribute: LaunchAttribute) -> dict[str, Any]:
    """Return the JSON schema of an attribute."""
    made: dict[str, Any] = {"type": attribute.kind, "description": attribute.meaning}
    if attribute.kind == "array":
        made |= {"type": ["array", "string"], "items": {"type": "string"}}
    if attribute.choices:
        made["enum"] = list(attribute.choices)
    if attribute.default is not None:
        made["default"] = attribute.default
    return made


FILLERS: Fillers = {
    "stall": lambda: f"{STALL_S:g}",
    "message": lambda: f"{MESSAGE_S:g}",
    "clients": lambda: str(MAX_CLIENTS),
    "launch": launch,
    "neovim": neovim,
    "attributes": attributes,
    "filters": filters,
}
