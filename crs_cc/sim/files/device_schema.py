"""The schema of the elements of `registry.devices()` in robot definitions."""

from __future__ import annotations

from lxml import etree

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
from crs_cc.sim.model.device import Device
from crs_cc.sim.model.registry import devices

_XS = "{http://www.w3.org/2001/XMLSchema}"


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
    return list(etree.parse(own).getroot()) if device.source and own.is_file() else [_type(device)]


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
        attribute.set("type", "positive-fraction" if row.values.positive else "fraction")
    else:
        attribute.set("type", "quantity")


def _document(element: etree._Element, text: str) -> None:
    annotation = etree.SubElement(element, f"{_XS}annotation")
    etree.SubElement(annotation, f"{_XS}documentation").text = text
