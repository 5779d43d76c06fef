"""The C side of the devices in the registry: their functions, and their part of `crs.h`.

The function of a sensor is derived from its row. A device can have a C file of its own instead,
named after it, in its folder; it includes `crs/device.h`, and `CRS_<NAME>` is its request's code.
"""

from __future__ import annotations

import textwrap
from functools import cache
from pathlib import Path
from typing import Final

from crs_cc.robot_api.row import OURS, Function, Group
from crs_cc.sim.model.device import Device
from crs_cc.sim.model.registry import devices

HEADER: Final = "crs/registered.h"
"""What `crs.h` includes for the devices of the registry."""

_WIDTH: Final = 98
_LARGEST_SOURCE: Final = 1 << 20


@cache
def device_headers() -> tuple[tuple[str, str], ...]:
    """Return the header that declares the functions of all devices, and those of their own.

    Each is a name and its text.
    """
    lines = ["/* The devices of the registry; made of their rows. */", "#ifndef _CRS_REGISTERED_H"]
    lines.append("#define _CRS_REGISTERED_H")
    for device in devices():
        values = "; ".join(value.meaning for value in device.values)
        text = f"{device.title}: {device.does} ({device.unit}): {values}."
        comment = textwrap.wrap(text.replace("*/", ""), _WIDTH - 6)
        lines += ["", f"/* {f'{chr(10)}   '.join(comment)} */", f"{device.prototype};"]
        lines.append(f"#define CRS_SENSOR_{device.name.upper()} {device.number}")
    lines += ["", "#endif", ""]
    own = [(path.name, _text(path)) for device in devices() for path in _own_headers(device)]
    return ((HEADER, "\n".join(lines)), *own)


def _own_headers(device: Device) -> list[Path]:
    """Return the headers in a device's folder, which programs include by their names."""
    return sorted(device.folder.glob("*.h")) if device.source else []


def _text(path: Path) -> str:
    with path.open("rb") as file:
        return file.read(_LARGEST_SOURCE).decode("utf-8", errors="replace")


@cache
def registered_functions() -> Group:
    """Return the functions of all devices, as rows of the table of `crs.h`."""
    rows = (
        Function(
            device.prototype,
            f"{device.does}: {', '.join(value.meaning for value in device.values)}",
            units=device.unit,
            posts=(device.name.upper(),),
            source=(OURS,),
        )
        for device in devices()
    )
    return Group("Sensors that read a few numbers", tuple(rows))


def unit_of(device: Device) -> str:
    """Return the name of the device's unit of the C library."""
    return f"device/{device.name}.c"


@cache
def units() -> dict[str, Device]:
    """Return the devices by the names of their units."""
    return {unit_of(device): device for device in devices()}


def defines(device: Device) -> tuple[str, ...]:
    """Return the macros that a device's C file is compiled with."""
    return (f"CRS_{device.name.upper()}={device.code}",)


def source(device: Device) -> str:
    """Return the C source of a device's function: its own, or derived from its row."""
    path = device.folder / f"{device.name}.c"
    if device.source and path.is_file():
        return _text(path)
    lines = [
        "#include <crs/device.h>",
        "",
        device.prototype,
        "{",
        "    struct __crs_message message;",
        "",
        f"    if (!__crs_ask_device(CRS_{device.name.upper()}, &message, 0, 0, 0, 0))",
        "        return 0;",
        *(f"    *{value.name} = message.i[{place}];" for place, value in enumerate(device.values)),
        "    return 1;",
        "}",
        "",
    ]
    return "\n".join(lines)


@cache
def device_sources() -> str:
    """Return all that decides what the devices' functions are compiled to."""
    return "\0".join(
        [text for _, text in device_headers()]
        + [f"{defines(device)}\0{source(device)}" for device in devices()]
    )
