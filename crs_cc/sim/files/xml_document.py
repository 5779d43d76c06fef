"""Parsing of untrusted XML, and validation against one of our schemas.

Entities are not resolved, nothing is fetched, a document type declaration is rejected, depth and
size are limited (by libxml2 and by `MAX_BYTES`). The schema checks the form and fills in defaults;
the readers of the elements check the rest. Only this file in `sim` uses lxml.
"""

from __future__ import annotations

import re
import stat
from functools import cache
from itertools import islice
from pathlib import Path
from typing import Final

from lxml import etree

from crs_cc.core.errors import WorldError
from crs_cc.core.input_files import note
from crs_cc.core.source import Diagnostic, Diagnostics, Location
from crs_cc.sim.files import device_schema
from crs_cc.sim.files.document import MAX_MESSAGES, Element, Reader
from crs_cc.sim.files.schema_messages import explain
from crs_cc.sim.files.schema_names import UnknownName, unknown_names

MAX_BYTES: Final = 16 * 1024 * 1024
"""Maximum size of a file."""

IDEAL: Final = "ideal"
"""A setup of every robot definition: the plain definition."""

ROBOT_SCHEMA: Final = "robot.xsd"

_HERE: Final = Path(__file__).parent
_NAME: Final = re.compile(rb"<([A-Za-z-]+)")
_POSITION: Final = re.compile(r"(, line \d+, column \d+)?( \([^()]*, line \d+\))?$")
_SKIPPED: Final = ((b"<?", b"?>"), (b"<!--", b"-->"))
_SAID_BETTER: Final = {
    "SCHEMAV_CVC_PATTERN_VALID",  # numbers: reported later, with the known units
    "SCHEMAV_CVC_IDC",  # ids: reported later, with the location of the first use
}
_SAID_OF_UNKNOWN: Final = {"SCHEMAV_ELEMENT_CONTENT", "SCHEMAV_CVC_COMPLEX_TYPE_3_2_1"}


def read_file(path: Path) -> bytes:
    """Return the contents of a regular file of limited size.

    Raises:
        WorldError: the file cannot be read.
    """
    place = Location(str(path))
    try:
        status = path.stat()
        if not stat.S_ISREG(status.st_mode):
            raise WorldError.at(place, "not a regular file")
        if status.st_size > MAX_BYTES:
            raise WorldError.at(place, f"larger than {MAX_BYTES} bytes")
        with path.open("rb") as file:
            content = file.read(MAX_BYTES)
    except OSError as error:
        reason = error.strerror or type(error).__name__
        raise WorldError.at(place, f"cannot be read: {reason}") from None
    except ValueError:  # a null character in the name
        raise WorldError.at(place, "cannot be read: not a valid file name") from None
    note(path, content)
    return content


def outermost(text: bytes) -> str:
    """Return the name of the root element without parsing the whole document.

    >>> outermost(b"<?xml version='1.0'?><!-- <no> --><yes/>")
    'yes'
    """
    place = len(text) - len(text.removeprefix(b"\xef\xbb\xbf").lstrip())
    while closing := next((end for start, end in _SKIPPED if text.startswith(start, place)), b""):
        place = text.find(closing, place) + len(closing)
        if place < len(closing):
            return ""
        while text[place : place + 1].isspace():
            place += 1
    match = _NAME.match(text, place)
    return match[1].decode("ascii") if match else ""


def elements(
    text: bytes,
    schema: str,
    file: str,
    diagnostics: Diagnostics,
    *,
    outermost: str,
    setup: str = "",
) -> Element:
    """Parse a document, validate it against a schema, and apply a setup.

    Args:
        text: the document.
        schema: the file of the schema.
        file: the document's name in messages.
        diagnostics: receives the messages.
        outermost: the name of the root element.
        setup: a setup of a robot definition, which replaces some of its attributes.

    Returns:
        the root element.

    Raises:
        WorldError: the document is invalid; all errors are reported at once.
    """
    if len(text) > MAX_BYTES:
        raise WorldError.at(Location(file), f"larger than {MAX_BYTES} bytes")
    parser = etree.XMLParser(
        resolve_entities=False,
        no_network=True,
        load_dtd=False,
        dtd_validation=False,
        huge_tree=False,
        remove_comments=True,
        remove_pis=True,
    )
    try:
        root = etree.fromstring(text, parser)
    except etree.XMLSyntaxError as error:
        if b"<!DOCTYPE" in text:
            _refuse_document_type(file)
        line, column = error.position
        place = Location(file, line or 0, max(column, 0))
        reason = _without_position(str(error.msg), place.line)
        raise WorldError([_syntax_message(place, reason, diagnostics)]) from None
    if root.getroottree().docinfo.doctype:
        _refuse_document_type(file)
    if root.tag != outermost:
        place = Location(file, root.sourceline or 0)
        raise WorldError.at(place, f"the root element must be <{outermost}>, not <{root.tag}>")
    _validate(root, schema, file, diagnostics)
    if setup:
        _apply(setup, root, Reader(file, diagnostics))
        raise_errors(diagnostics)
        _validate(root, schema, file, diagnostics)
    return _plain(root)


def _apply(setup: str, root: etree._Element, reader: Reader) -> None:
    """Replace attributes of a definition with those of a setup."""
    setups = {str(node.get("name")): node for node in root.iterfind("setup")}
    if setup not in setups:
        if setup != IDEAL:
            known = ", ".join([IDEAL, *setups])
            place = Element(root.tag, root.sourceline or 0)
            reader.error(place, f"unknown setup {setup!r}", f"known setups: {known}")
        return
    for change in setups[setup]:
        device = root.find(change.tag)
        if device is None or change.tag == "setup":
            place = Element(change.tag, change.sourceline or 0)
            reader.error(place, f"setup {setup!r} changes <{change.tag}>, which is missing")
        else:
            device.attrib.update(change.attrib)


def _refuse_document_type(file: str) -> None:
    raise WorldError.at(
        Location(file), "a document type declaration is not allowed", "remove <!DOCTYPE ...>"
    )


def _validate(root: etree._Element, name: str, file: str, diagnostics: Diagnostics) -> None:
    """Validate a document against a schema, and add the schema's defaults."""
    schema = _schema(name)
    if schema.validate(root):
        return
    found = list(islice(unknown_names(root, schema_document(name).getroot()), MAX_MESSAGES))
    lines = {each.line for each in found}
    for entry in schema.error_log:
        said = _SAID_BETTER | (_SAID_OF_UNKNOWN if entry.line in lines else set())
        if entry.type_name not in said:
            found.append(UnknownName(entry.line, *explain(entry.message)))
    reader = Reader(file, diagnostics)
    for each in sorted(found, key=lambda each: each.line):
        reader.error(Element("", each.line), each.text, each.hint)
    raise_errors(diagnostics)


@cache
def schema_document(name: str) -> etree._ElementTree:
    """Return a schema; that of robot definitions includes the elements of all devices."""
    document = etree.parse(_HERE / name)
    if name == ROBOT_SCHEMA:
        device_schema.add_to_schema(document.getroot())
    return document


@cache
def _schema(name: str) -> etree.XMLSchema:
    return etree.XMLSchema(schema_document(name), attribute_defaults=True)


def _plain(node: etree._Element) -> Element:
    """Convert an lxml element; the schema limits the depth."""
    return Element(
        node.tag,
        node.sourceline or 0,
        dict(node.attrib),
        (node.text or "").strip(),
        [_plain(child) for child in node],
    )


def document_of(root: Element) -> bytes:
    """Return an XML document.

    >>> print(document_of(Element("world", 0, {"name": "a & b"})).decode(), end="")
    <?xml version='1.0' encoding='UTF-8'?>
    <world name="a &amp; b"/>
    """
    node = _node(root)
    etree.indent(node)
    text: bytes = etree.tostring(node, encoding="UTF-8", xml_declaration=True)
    return text + b"\n"


def _node(element: Element) -> etree._Element:
    """Return an element of lxml.

    Raises:
        ValueError: a value has a character that XML does not allow.
    """
    node = etree.Element(element.tag, element.attributes)
    node.text = element.text or None
    node.extend([_node(child) for child in element.children])
    return node


def lines_of(text: bytes) -> list[str]:
    """Return the lines of a file, for messages."""
    return text.decode("utf-8", errors="replace").splitlines()


def _without_position(message: str, line: int) -> str:
    r"""Return libxml2's message on one line, without the location at its end.

    >>> _without_position("mismatch: wall line 3 and world, line 3, column 5", 3)
    'mismatch: wall and world'
    >>> _without_position("mismatch: wall line 2 and world, line 3, column 5", 3)
    'mismatch: wall line 2 and world'
    >>> _without_position("not UTF-8 !\nBytes: 0xFF 0x20 (room.xml, line 3)", 3)
    'not UTF-8 ! Bytes: 0xFF 0x20'
    """
    text = _POSITION.sub("", " ".join(message.split()))
    return re.sub(rf" line {line}\b", "", text)


def _syntax_message(location: Location, text: str, diagnostics: Diagnostics) -> Diagnostic:
    shown = Diagnostics(lines=diagnostics.lines)
    shown.error(location, f"not well-formed XML: {text}")
    return shown.messages[0]


def raise_errors(diagnostics: Diagnostics) -> None:
    """Raise all errors that were found."""
    if diagnostics.errors:
        raise WorldError(diagnostics.errors)
