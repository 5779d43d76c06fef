"""The protocol's own JSON schema, which every message of ours has to fit.

It is the official `debugAdapterProtocol.json` (Microsoft, MIT licence); the package `debugpy`
brings a copy of it along, from which it is read here.
"""

from __future__ import annotations

import functools
import importlib.util
import json
from pathlib import Path
from typing import Any

from jsonschema import Draft4Validator

_INSIDE = "_vendored/pydevd/_pydevd_bundle/_debug_adapter/debugProtocol.json"


@functools.cache
def schema() -> dict[str, Any]:
    """Return the schema, with a definition for each kind of message."""
    found = importlib.util.find_spec("debugpy")
    assert found is not None
    assert found.origin is not None
    return json.loads((Path(found.origin).parent / _INSIDE).read_text())


@functools.cache
def _validator(name: str) -> Draft4Validator:
    whole = schema()
    assert name in whole["definitions"], f"the protocol has no {name}"
    return Draft4Validator({"$ref": f"#/definitions/{name}", "definitions": whole["definitions"]})


def _title(name: str) -> str:
    return name[0].upper() + name[1:]


def definition_of(message: dict[str, Any]) -> str:
    """Return the name of the definition that a message has to fit."""
    if message["type"] == "event":
        return f"{_title(message['event'])}Event"
    if message["type"] == "request":
        return f"{_title(message['command'])}Request"
    if not message["success"]:
        return "ErrorResponse"
    return f"{_title(message['command'])}Response"


def demand_valid(message: dict[str, Any]) -> None:
    """Make sure that a message is one of the protocol's.

    Objects may have members that the schema does not know; in what we say there are none.
    """
    name = definition_of(message)
    errors = [
        f"{error.json_path}: {error.message}" for error in _validator(name).iter_errors(message)
    ]
    errors += [f"unknown: {path}" for path in _unknown(message.get("body"), name, schema())]
    assert not errors, f"{name} {json.dumps(message)}: {errors}"


def _unknown(value: Any, name: str, whole: dict[str, Any]) -> list[str]:
    """Return the members of a body that its definition does not name."""
    parts = whole["definitions"][name].get("allOf", [whole["definitions"][name]])
    bodies = [part["properties"]["body"] for part in parts if "body" in part.get("properties", {})]
    return _strangers(value, bodies[-1], whole, "body") if bodies else []


def _strangers(value: Any, shape: dict[str, Any], whole: dict[str, Any], path: str) -> list[str]:
    if "$ref" in shape:
        return _strangers(
            value, whole["definitions"][shape["$ref"].rpartition("/")[2]], whole, path
        )
    if isinstance(value, list):
        items = shape.get("items", {})
        return [each for one in value for each in _strangers(one, items, whole, f"{path}[]")]
    if not isinstance(value, dict) or "properties" not in shape:
        return []
    found = []
    for name, one in value.items():
        if name not in shape["properties"]:
            found.append(f"{path}.{name}")
        else:
            found += _strangers(one, shape["properties"][name], whole, f"{path}.{name}")
    return found
