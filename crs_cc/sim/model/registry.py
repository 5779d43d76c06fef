"""Registry of all devices: those in `crs_cc/sim/devices`, and those of installed packages.

Rows are found by name, so nothing here imports a device, and adding one changes no other file.
"""

from __future__ import annotations

import importlib
import itertools
import zlib
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Final

from crs_cc.core.errors import DeviceError
from crs_cc.core.source import Location
from crs_cc.requests import CODES, REGISTERED, register
from crs_cc.sim.model.device import Device
from crs_cc.sim.model.entry_points import may_have_entries

GROUP: Final = "crs_cc.devices"
"""The entry point group of devices in other packages; each entry is a `Device`."""

_DEVICES: Final = Path(__file__).parents[1] / "devices"
_FIRST_NUMBER: Final = 9  # the lower ones are fixed in the rows
_FOREIGN: Final = 100  # first code of other packages' devices; those below are reserved
_STREAMS: Final = 1000  # streams below are reserved, see `state.random_streams`


_added: Final[list[Device]] = []


def add_device(row: Device) -> None:
    """Add a device without a package, for this process; to be called before all else.

    Raises:
        ValueError: the devices are in use already.
    """
    if devices.cache_info().currsize:
        text = "add_device must be called before anything else of crs_cc is used"
        raise ValueError(f"device {row.name!r} cannot be added: {text}")
    _added.append(row)


@cache
def devices() -> tuple[Device, ...]:
    """Return all devices with their numbers, codes and streams: built-in ones first, then by name.

    Those of `add_device` are the last.

    Raises:
        DeviceError: a device's row is invalid, or its name is in use.
    """
    found: dict[str, Device] = {}
    ours, others = list(_ours()), list(_of_other_packages())
    others += [(row.source or row.name, row) for row in _added]
    for where, device in (*ours, *others):
        if not isinstance(device, Device):
            raise DeviceError.at(Location(where), "not a crs_cc.sim.model.device.Device")
        if reason := _complaint(device, found):
            raise DeviceError.at(Location(where), f"device {device.name!r}: {reason}")
        found[device.name] = device
    rows = tuple(_numbered(list(found.values()), len(ours)))
    for row in rows:
        for request in row.requests:
            register(request)
    return rows


@cache
def device(name: str) -> Device:
    """Return the device with a name; raise KeyError if there is no such device."""
    return {each.name: each for each in devices()}[name]


@cache
def sensor_count() -> int:
    """Return the number of sensors that can have a timer; their numbers are less than this."""
    return 1 + max(each.number for each in devices() if each.number is not None)


def _complaint(device: Device, found: dict[str, Device]) -> str:
    if device.name in found:
        return "duplicate device name"
    names = {request.name for each in found.values() for request in each.requests}
    if any(request.name in CODES or request.name in names for request in device.requests):
        return "duplicate request name"
    numbers = {each.number for each in found.values()}
    if device.number is not None and device.number >= 0 and device.number in numbers:
        return "duplicate sensor number"
    if device.element and device.element in {each.element for each in found.values()}:
        return "duplicate device element"
    return device.validation_error()


def _ours() -> Iterator[tuple[str, object]]:
    for folder in sorted(_DEVICES.iterdir()):
        if (folder / "__init__.py").is_file():
            row = getattr(importlib.import_module(f"crs_cc.sim.devices.{folder.name}"), "DEVICE", 0)
            if row:
                yield str(folder / "__init__.py"), row


def _of_other_packages() -> Iterator[tuple[str, object]]:
    if not may_have_entries(GROUP):
        return
    import importlib.metadata  # slow to import

    points = importlib.metadata.entry_points(group=GROUP)
    for point in sorted(points, key=lambda each: (each.name, each.value)):
        try:
            row = point.load()
        except Exception as error:  # whatever the package's code may raise
            reason = f"{type(error).__name__}: {error}"
            text = f"device {point.name!r} cannot be loaded: {reason}"
            raise DeviceError.at(Location(point.value), text) from error
        yield point.value, row


def _numbered(rows: list[Device], ours: int) -> Iterator[Device]:
    """Yield rows with their missing numbers filled in, in order."""
    numbers = {row.number for row in rows}
    free = (number for number in itertools.count(_FIRST_NUMBER) if number not in numbers)
    our_codes, other_codes = iter(REGISTERED[:_FOREIGN]), iter(REGISTERED[_FOREIGN:])
    for place, row in enumerate(rows):
        codes = our_codes if place < ours else other_codes
        yield replace(
            row,
            number=next(free) if row.number is not None and row.number < 0 else row.number,
            stream=_STREAMS + zlib.crc32(row.name.encode()) if row.stream < 0 else row.stream,
            requests=tuple(
                each if each.code >= 0 else replace(each, code=next(codes)) for each in row.requests
            ),
        )
