"""Parts of `docs/sensors.md`: laws from the sensors' modules, attributes from the schema."""

from __future__ import annotations

import importlib
import inspect
import re

from crs_cc.sim.model.degradation import degradables
from crs_cc.sim.model.device import Device
from crs_cc.sim.model.registry import devices
from docs.generate import ROOT, Fillers
from docs.generate.schema import Schema


def law(module: str) -> str:
    """Return the docstring of a sensor's module without its first line, as Markdown."""
    text = inspect.getdoc(importlib.import_module(f"crs_cc.sim.devices.{module}")) or ""
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
    device = degradables()[name]
    what = device.title if " and " in device.title else f"the {device.title}"
    return f"The degradation `{name}` applies to {what}; if a value is dropped, {device.nothing}."


def registered_rows() -> str:
    """Return the rows of the overview for the sensors that read a few numbers."""
    return "\n".join(
        f"| [{device.title}](#{device.title.lower().replace(' ', '-')}) | `<{device.element}>` | "
        f"`{device.functions[0].name}` | {device.functions[0].units} | yes | `{device.name}` | "
        f"{_sample(device)} |"
        for device in _few_numbers()
    )


def registered_sections() -> str:
    """Return a section for each sensor that reads a few numbers."""
    return "\n\n".join(
        f"## {device.title}\n\n{law(device.folder.name)}\n\n{attributes(device.element)}\n\n"
        f"{degradation(device.name)}"
        for device in _few_numbers()
    )


def _few_numbers() -> list[Device]:
    """Return our sensors whose C function is made of their row."""
    ours = (each for each in devices() if each.model.__module__.startswith("crs_cc."))
    return [device for device in ours if device.code]


def _sample(device: Device) -> str:
    for path in sorted((ROOT / "samples" / "scout_c").glob("*.c")):
        if f"{device.functions[0].name}(" in path.read_text():
            return f"[{path.stem}](../samples/scout_c/{path.name})"
    return ""


FILLERS: Fillers = {
    "law": law,
    "attributes": attributes,
    "degradation": degradation,
    "registered_rows": registered_rows,
    "registered_sections": registered_sections,
}
