"""The elements of robot definitions for the devices of `registry.devices()`: schema and reader."""

from __future__ import annotations

import dataclasses
from typing import Any

from lxml import etree

from crs_cc.sim.files.document import Element, Reader
from crs_cc.sim.files.sensor_elements import period_s
from crs_cc.sim.model.device import Attribute, Device, attributes_of
from crs_cc.sim.model.registry import devices

_XS = "{http://www.w3.org/2001/XMLSchema}"
_BEFORE = "camera"  # the element that follows those of the registry in a definition


def models(root: Element, reader: Reader) -> tuple[tuple[str, Any], ...]:
    """Return the devices of a robot definition, each with its model; errors go to the reader."""
    found = []
    for device in devices():
        element = root.maybe(device.element)
        if element is not None:
            found.append((device.name, _model(device, element, reader)))
    return tuple(found)


def _model(device: Device, element: Element, reader: Reader) -> Any:
    values = {}
    for field in dataclasses.fields(device.model):
        row = field.metadata.get("attribute")
        if row is None:
            continue
        if field.name == "period_s":
            values[field.name] = period_s(element, reader)
        else:
            values[field.name] = _value(row, element, reader)
    return device.model(**values)


def _value(row: Attribute, element: Element, reader: Reader) -> float:
    absent = row.kind.parse(row.default)
    if row.positive:
        return reader.positive(element, row.name, row.kind, absent)
    if row.signed:
        return reader.quantity(element, row.name, row.kind, absent)
    return reader.not_negative(element, row.name, row.kind, absent)


def add_to_schema(schema: etree._Element) -> None:
    """Add the elements of all devices to the schema of robot definitions."""
    follower = schema.find(f".//{_XS}element[@name='{_BEFORE}'][@type='{_BEFORE}']")
    assert follower is not None
    sequence = follower.getparent()
    assert sequence is not None
    first = schema.find(f"{_XS}complexType")
    assert first is not None
    for device in devices():
        row = etree.Element(
            f"{_XS}element", name=device.element, type=device.element, minOccurs="0"
        )
        sequence.insert(sequence.index(follower), row)
        schema.insert(schema.index(first), _type(device))


def _type(device: Device) -> etree._Element:
    kind = etree.Element(f"{_XS}complexType", name=device.element)
    _document(kind, f"{device.summary}: {device.function}() of crs.h.")
    for row in attributes_of(device.model):
        if row.name == "period":
            etree.SubElement(kind, f"{_XS}attributeGroup", ref="timer")
            continue
        each = etree.SubElement(
            kind, f"{_XS}attribute", name=row.name, type="quantity", default=row.default
        )
        _document(each, row.meaning)
    return kind


def _document(element: etree._Element, text: str) -> None:
    annotation = etree.SubElement(element, f"{_XS}annotation")
    etree.SubElement(annotation, f"{_XS}documentation").text = text
