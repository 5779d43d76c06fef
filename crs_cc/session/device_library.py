"""The C side of the devices in the registry: their functions, and their part of `crs.h`.

A device's C file is in its folder and named after it; without one the source is that of its row. It
includes `crs/device.h`, and `CRS_<NAME>` is the code of the request `NAME`.
"""

from __future__ import annotations

import textwrap
from functools import cache
from pathlib import Path
from typing import Final

from crs_cc.robot_api.row import Function, Group
from crs_cc.sim.model.device import Device
from crs_cc.sim.model.registry import devices

HEADER: Final = "crs/registered.h"
"""What `crs.h` includes for the devices of the registry."""

_WIDTH: Final = 98
_MAX_SOURCE: Final = 1 << 20


@cache
def device_headers() -> tuple[tuple[str, str], ...]:
    """Return the header that declares the functions of all devices, and those of their own.

    Each is a name and its text.
    """
    lines = ["/* The devices of the registry; made of their rows. */", "#ifndef _CRS_REGISTERED_H"]
    lines.append("#define _CRS_REGISTERED_H")
    for device in devices():
        lines += ["", f"/* {device.title}. */", *device.declarations.splitlines()]
        if device.number is not None:
            lines.append(f"#define CRS_SENSOR_{device.name.upper()} {device.number}")
        for function in device.functions:
            lines += [_comment(function), f"{function.prototype};"]
    lines += ["", "#endif", ""]
    own = [(path.name, _text(path)) for device in devices() for path in _own_headers(device)]
    return ((HEADER, "\n".join(lines)), *own)


def _comment(function: Function) -> str:
    does = function.does[0].upper() + function.does[1:]
    text = f"{does} ({function.units})." if function.units else f"{does}."
    lines = textwrap.wrap(text.replace("*/", ""), _WIDTH - 6)
    return f"/* {f'{chr(10)}   '.join(lines)} */"


def _own_headers(device: Device) -> list[Path]:
    """Return the headers in a device's folder, which programs include by their names."""
    return sorted(device.folder.glob("*.h")) if device.source else []


def _text(path: Path) -> str:
    with path.open("rb") as file:
        return file.read(_MAX_SOURCE).decode("utf-8", errors="replace")


@cache
def device_groups() -> tuple[Group, ...]:
    """Return the functions of each device, as rows of the table of `crs.h`."""
    return tuple(Group(each.title, each.functions) for each in devices() if each.functions)


def unit_of(device: Device) -> str:
    """Return the name of the device's unit of the C library."""
    return f"device/{device.name}.c"


@cache
def units() -> dict[str, Device]:
    """Return the devices by the names of their units."""
    return {unit_of(device): device for device in devices() if device.functions}


def defines(device: Device) -> tuple[str, ...]:
    """Return the macros that a device's C file is compiled with."""
    return tuple(f"CRS_{request.name}={request.code}" for request in device.requests)


def source(device: Device) -> str:
    """Return the C source of a device's functions: the file in its folder, or that of its row."""
    path = device.folder / f"{device.name}.c"
    return _text(path) if device.source and path.is_file() else device.code


@cache
def device_sources() -> str:
    """Return everything that the compiled functions of devices depend on."""
    return "\0".join(
        [text for _, text in device_headers()]
        + [f"{defines(device)}\0{source(device)}" for device in units().values()]
    )
