"""The elements of robot definitions for the devices of the registry, see also `device_schema`."""

from __future__ import annotations

import dataclasses
from typing import Any

from crs_cc.core.quantity import Kind
from crs_cc.sim.files.document import Element, Reader
from crs_cc.sim.files.sensor_elements import period_s
from crs_cc.sim.model.attribute import (
    Attribute,
    Choice,
    Colour,
    Count,
    Fraction,
    Numbers,
    Voltages,
)
from crs_cc.sim.model.colours import rgb
from crs_cc.sim.model.device import Device
from crs_cc.sim.model.registry import devices
from crs_cc.sim.model.robot import RobotModel


def models(root: Element, reader: Reader) -> tuple[tuple[str, Any], ...]:
    """Return the devices of a robot definition, each with its model; errors go to the reader."""
    found = []
    for device in devices():
        model = _model(device, root, reader) if device.read is None else device.read(root, reader)
        if model is not None:
            found.append((device.name, model))
    return tuple(found)


def _model(device: Device, root: Element, reader: Reader) -> Any | None:
    element = root.find_child(device.element)
    return None if element is None else read_attributes(device.model, element, reader)


def read_attributes(model: type, element: Element, reader: Reader) -> Any:
    """Return the model that the attributes of a device's element describe."""
    values = {}
    for field in dataclasses.fields(model):
        row = field.metadata.get("attribute")
        if row is None:
            continue
        if field.name == "period_s":
            values[field.name] = period_s(element, reader)
        else:
            values[field.name] = _value(row, element, reader)
    return model(**values)


def device_elements(robot: RobotModel) -> list[Element]:
    """Return the elements of a robot definition that describe the devices of a robot.

    Raises:
        ValueError: a device cannot be described.
    """
    found = []
    for device in devices():
        model = robot.device(device.name)
        if device.write is not None:
            found += device.write(robot)
        elif model is not None:
            found.append(attributes_element(device.element, model))
    return found


def attributes_element(tag: str, model: Any) -> Element:
    """Return an element with the attributes that describe the model of a device.

    Raises:
        ValueError: an attribute cannot have this value.
    """
    values = {}
    for field in dataclasses.fields(model):
        row = field.metadata.get("attribute")
        if row is None:
            continue
        try:
            values[row.name] = row.values.exact(getattr(model, field.name))
        except (TypeError, ValueError) as wrong:
            raise ValueError(f"<{tag}>, {row.name}: {wrong}") from None
    return Element(tag, 0, values)


def _value(row: Attribute, element: Element, reader: Reader) -> Any:
    values = row.values
    if isinstance(values, Choice | Fraction | Numbers | Voltages):  # the schema checks these
        return values.parse(element.attributes[row.name])
    if isinstance(values, Count):
        least = 0 if row.default is None else int(row.default)
        return reader.whole(element, row.name, values.least, values.most, absent=least)
    if isinstance(values, Colour):
        return _colour(element, row.name, reader)
    return _quantity(row, values, element, reader)


def _quantity(row: Attribute, kind: Kind, element: Element, reader: Reader) -> float:
    absent = kind.parse(row.default) if row.default else 1.0
    read = reader.not_negative
    if row.positive or row.signed:
        read = reader.positive if row.positive else reader.quantity
    value = read(element, row.name, kind, absent)
    if row.most and value > kind.parse(row.most):
        reader.refuse(element, f"{row.name}: must be {row.most} or less")
    return value


def _colour(element: Element, name: str, reader: Reader) -> tuple[int, int, int]:
    try:
        return rgb(element.attributes[name])
    except ValueError as wrong:
        reader.refuse(element, f"{name}: {wrong}")
        return 0, 0, 0
