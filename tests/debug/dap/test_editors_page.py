"""What `docs/editors.md` and the extension for VS Code show can be launched."""

from __future__ import annotations

import json
import re
from typing import Any

import pytest

from crs_cc.debug.commands.table import NAMES
from crs_cc.debug.dap.arguments import Arguments
from crs_cc.debug.dap.launch import read_launch
from docs.generate import ROOT
from docs.generate.editors import CONFIGURATION, NEOVIM, extension
from tests.debug.dap.client import Client
from tests.debug.dap.programs import open_run


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
