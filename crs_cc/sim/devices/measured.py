"""Calls of devices' `measure`, which may be the code of another package.

Whatever that code raises or returns is reported as an error of the device, with its file; an
exception in a device of crs itself is a bug of crs.
"""

from __future__ import annotations

import traceback
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Final, TypeVar

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.core.errors import DeviceError
from crs_cc.core.source import Location

if TYPE_CHECKING:
    from crs_cc.sim.model.device import Device

_OWN: Final = Path(__file__).parent
_Measurement = TypeVar("_Measurement")
_NUMBERS: Final = "iuf"  # kinds of arrays that hold real numbers


def measured(
    device: Device,
    measure: Callable[[_Measurement], FloatArray],
    measurement: _Measurement,
    shape: tuple[int, int],
) -> FloatArray:
    """Return the measurements of a device, (k, values).

    Raises:
        DeviceError: a device of another package raised an exception, or its result is not an array
            of numbers of this shape.
    """
    try:
        value = np.asarray(measure(measurement))
    except Exception as error:  # whatever the package's code may raise
        if _OWN in Path(device.source).parents:
            raise
        text = " ".join(f"{type(error).__name__}: {error}".split())
        place = _raised_at(device, measure.__module__, error)
        raise DeviceError.at(place, f"device {device.name!r}: measure raised {text}") from error
    if value.shape != shape or value.dtype.kind not in _NUMBERS:
        raise DeviceError.at(
            Location(device.source or measure.__module__),
            f"device {device.name!r}: measure returned an array of shape {value.shape} and type"
            f" {value.dtype} (expected: shape {shape}, float64)",
        )
    return value.astype(np.float64, copy=False)


def _raised_at(device: Device, module: str, error: Exception) -> Location:
    """Return the last place in the device's package that an exception came through."""
    frames = traceback.extract_tb(error.__traceback__)
    inside = [frame for frame in frames if device.folder in Path(frame.filename).parents]
    if not device.source or not inside:
        return Location(device.source or module)
    return Location(inside[-1].filename, inside[-1].lineno or 0)
