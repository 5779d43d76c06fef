"""`docs/sensors.md` names every function that reads a sensor."""

from __future__ import annotations

from crs_cc.robot_api.device import DEVICE_GROUPS
from docs.generate import template


def test_every_function_that_reads_a_sensor_is_on_the_page() -> None:
    sensors = next(group for group in DEVICE_GROUPS if group.title == "Sensors")
    text = template("sensors")
    for function in sensors.functions:
        assert f"`{function.name}`" in text or f"`{function.name}(" in text, function.name
