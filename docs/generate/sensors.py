"""Parts of `docs/sensors.md`: laws from the sensors' modules, attributes from the schema."""

from __future__ import annotations

import importlib
import inspect
import re

from crs_cc.sim.model.degradation import DEVICES
from docs.generate import Fillers
from docs.generate.schema import Schema


def law(module: str) -> str:
    """Return the docstring of a sensor's module without its first line, as Markdown."""
    text = inspect.getdoc(importlib.import_module(f"crs_cc.sim.sensors.{module}")) or ""
    parts = [part for part in text.split("\n\n")[1:] if part.strip()]
    return "\n\n".join(
        part.strip("\n") if re.search(r"^(- | )", part, re.MULTILINE) else " ".join(part.split())
        for part in parts
    )


def attributes(element: str) -> str:
    """Return the table of the attributes of a sensor's element in a robot definition."""
    return f"Attributes of `<{element}>` in a robot definition:\n\n" + Schema(
        "robot.xsd"
    ).attributes(element)


def degradation(name: str) -> str:
    """Return what degradations of a sensor act on."""
    device = DEVICES[name]
    return f"Degradation `{name}`: {device.title}; if a value is dropped: {device.nothing}."


FILLERS: Fillers = {"law": law, "attributes": attributes, "degradation": degradation}
