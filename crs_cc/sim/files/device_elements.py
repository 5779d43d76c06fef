"""The elements of robot definitions for the devices of `registry.devices()`: schema and reader."""

from __future__ import annotations

import dataclasses
from typing import Any

from lxml import etree

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
    attributes_of,
)
from crs_cc.sim.model.colours import rgb
from crs_cc.sim.model.device import Device
from crs_cc.sim.model.registry import devices

_XS = "{http://www.w3.org/2001/XMLSchema}"


def models(root: Element, reader: Reader) -> tuple[tuple[str, Any], ...]:
    """Return the devices of a robot definition, each with its model; errors go to the reader."""
    found = []
    for device in devices():
        model = _model(device, root, reader) if device.read is None else device.read(root, reader)
        if model is not None:
            found.append((device.name, model))
    return tuple(found)


def _model(device: Device, root: Element, reader: Reader) -> Any | None:
    element = root.maybe(device.element)
    return None if element is None else read_attributes(device.model, element, reader)


def read_attributes(model: type, element: Element, reader: Reader) -> Any:
    """Return the model that the attributes of a device's element describe.

    Args:
        model: its dataclass, whose fields are made by `attribute`.
        element: the element.
        reader: reads the values; errors go to it.
    """
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


def add_to_schema(schema: etree._Element) -> None:
    """Add the elements of all devices to the schema of robot definitions."""
    choice = schema.find(f".//{_XS}choice[@id='devices']")
    first = schema.find(f"{_XS}complexType")
    assert choice is not None
    assert first is not None
    for device in devices():
        if not device.element:
            continue
        etree.SubElement(choice, f"{_XS}element", name=device.element, type=device.element)
        for kind in _types(device):
            schema.insert(schema.index(first), kind)


def _types(device: Device) -> list[etree._Element]:
    """Return the types of a device's element: its own, or one derived from its model."""
    own = device.folder / "element.xsd"
    return list(etree.parse(own).getroot()) if own.is_file() else [_type(device)]


def _type(device: Device) -> etree._Element:
    kind = etree.Element(f"{_XS}complexType", name=device.element)
    _document(kind, device.summary)
    for row in attributes_of(device.model):
        if row.name == "period":
            etree.SubElement(kind, f"{_XS}attributeGroup", ref="timer")
            continue
        each = etree.SubElement(kind, f"{_XS}attribute", name=row.name)
        if row.default is None:
            each.set("use", "required")
        elif row.default:
            each.set("default", row.default)
        _document(each, row.meaning)
        _restrict(each, row)
    return kind


def _restrict(attribute: etree._Element, row: Attribute) -> None:
    """Set the type of an attribute's values."""
    if isinstance(row.values, Choice):
        kind = etree.SubElement(attribute, f"{_XS}simpleType")
        words = etree.SubElement(kind, f"{_XS}restriction", base="xs:string")
        for word, _ in row.values.values:
            etree.SubElement(words, f"{_XS}enumeration", value=word)
    elif isinstance(row.values, Numbers):
        kind = etree.SubElement(attribute, f"{_XS}simpleType")
        bounded = etree.SubElement(kind, f"{_XS}restriction")
        listed = etree.SubElement(bounded, f"{_XS}simpleType")
        etree.SubElement(listed, f"{_XS}list", itemType="xs:unsignedByte")
        etree.SubElement(bounded, f"{_XS}maxLength", value=str(row.values.most))
    elif isinstance(row.values, Count | Colour):
        attribute.set("type", "xs:string")
    elif isinstance(row.values, Voltages):
        kind = etree.SubElement(attribute, f"{_XS}simpleType")
        bounded = etree.SubElement(kind, f"{_XS}restriction")
        listed = etree.SubElement(bounded, f"{_XS}simpleType")
        etree.SubElement(listed, f"{_XS}list", itemType="volts")
        etree.SubElement(bounded, f"{_XS}minLength", value="1")
        etree.SubElement(bounded, f"{_XS}maxLength", value=str(row.values.most))
    elif isinstance(row.values, Fraction):
        attribute.set("type", "share" if row.values.positive else "probability")
    else:
        attribute.set("type", "quantity")


def _document(element: etree._Element, text: str) -> None:
    annotation = etree.SubElement(element, f"{_XS}annotation")
    etree.SubElement(annotation, f"{_XS}documentation").text = text
