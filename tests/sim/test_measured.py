"""Devices of other packages whose `measure` fails: the error names the device and its file."""

from __future__ import annotations

import inspect
from dataclasses import replace

import numpy as np
import pytest

from crs_cc.core.errors import DeviceError
from crs_cc.sim.devices.measured import measured
from crs_cc.sim.model.registry import device

ROBOTS = 2
SHAPE = ROBOTS, 1
SOURCE = __file__


FOREIGN = replace(device("altitude"), name="depth", source=SOURCE)
"""A device of another package, whose file is this one."""


def error_of(measure) -> str:
    with pytest.raises(DeviceError) as raised:
        measured(FOREIGN, measure, object(), SHAPE)
    return str(raised.value)


def divide(_now):
    return 1 / 0


def test_an_exception_is_named_with_the_device_and_its_line():
    line = inspect.getsourcelines(divide)[1] + 1
    text = "error: device 'depth': measure raised ZeroDivisionError: division by zero"
    assert error_of(divide) == f"{SOURCE}:{line}: {text}"


def test_an_exception_below_the_package_is_placed_where_the_package_called():
    def read(_now):
        return np.zeros(3).reshape(2, 2)

    line = inspect.getsourcelines(read)[1] + 1
    assert error_of(read).startswith(f"{SOURCE}:{line}: error: device 'depth': measure raised Val")


def test_an_exception_of_several_lines_is_one_line():
    def fail(_now):
        raise RuntimeError("no\n  depth\n")

    assert error_of(fail).endswith("measure raised RuntimeError: no depth")


def test_a_device_without_a_source_is_named_by_its_module():
    with pytest.raises(DeviceError) as raised:
        measured(replace(FOREIGN, source=""), divide, object(), SHAPE)
    assert str(raised.value).startswith(f"{__name__}: error: device 'depth': measure raised Zero")


@pytest.mark.parametrize(
    ("value", "found"),
    [
        (np.zeros(ROBOTS), "shape (2,) and type float64"),
        (np.zeros((ROBOTS, 2)), "shape (2, 2) and type float64"),
        (np.zeros((1, 1)), "shape (1, 1) and type float64"),
        (None, "shape () and type object"),
        ([["NaN"], ["nan"]], "shape (2, 1) and type <U3"),
        ([[None], [1.0]], "shape (2, 1) and type object"),
        (np.full((ROBOTS, 1), 1j), "shape (2, 1) and type complex128"),
        (np.full((ROBOTS, 1), np.datetime64("NaT", "s")), "shape (2, 1) and type datetime64[s]"),
    ],
)
def test_a_result_that_is_no_array_of_numbers_is_rejected(value, found):
    text = f"error: device 'depth': measure returned an array of {found} "
    assert error_of(lambda _now: value) == f"{SOURCE}: {text}(expected: shape (2, 1), float64)"


@pytest.mark.parametrize("value", [[[1], [2]], np.float32([[1], [2]]), np.array([[1.0], [2.0]])])
def test_numbers_of_any_width_are_measurements(value):
    found = measured(FOREIGN, lambda _now: value, object(), SHAPE)
    assert found.dtype == np.float64
    assert found.tolist() == [[1.0], [2.0]]


def test_an_exception_in_a_device_of_crs_is_a_bug_of_crs():
    with pytest.raises(ZeroDivisionError):
        measured(device("altitude"), divide, object(), SHAPE)
