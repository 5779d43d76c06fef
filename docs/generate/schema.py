"""Read an XML schema as documentation: its elements, their attributes, examples."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Final

from lxml import etree

import crs_cc.sim
from crs_cc.sim.files.xml_document import schema_document
from docs.generate import ROOT, table

SIM: Final = Path(crs_cc.sim.__file__).parent
XS: Final = "{http://www.w3.org/2001/XMLSchema}"
MAX_EXAMPLE: Final = 500  # characters
TITLES: Final = ("attribute", "type", "default", "description")

_TEMPLATES: Final = SIM.parent / "cli" / "templates"
_EXAMPLES: Final = {  # the first file that contains an element provides its example
    "world.xsd": [_TEMPLATES / "world.xml", *sorted((ROOT / "worlds").rglob("*.xml"))],
    "robot.xsd": [
        _TEMPLATES / "robot.xml",
        *sorted((SIM / "files" / "robots").glob("*.xml"), reverse=True),
    ],
}


class Schema:
    """A schema of `crs_cc/sim/files`.

    Attributes:
        root: its root element.
        named: its top-level declarations, by tag and name.
    """

    def __init__(self, name: str) -> None:
        self.root = schema_document(name).getroot()
        self.named = {(each.tag, each.get("name")): each for each in self.root}
        self._examples = [etree.parse(path) for path in _EXAMPLES[name]]
        self._done: set[tuple[str, str | None]] = set()

    def elements(self, outermost: str) -> str:
        """Return a section for each element inside `outermost`, each kind of element once."""
        sections = []
        work = [(outermost, self.named[f"{XS}element", outermost])]
        for name, element in work:
            key = name, element.get("type")
            if key in self._done:
                continue
            self._done.add(key)
            sections += list(self._section(name, element))
            children = self._parts(self._content(element), "element")
            work += [(child.get("name"), child) for child in children]
        return "\n\n".join(sections)

    def types(self) -> str:
        """Return a list of the types of attributes with their descriptions."""
        return "\n".join(
            f"- *{name}*: {documentation(each)}"
            for (tag, name), each in self.named.items()
            if tag == f"{XS}simpleType" and documentation(each)
        )

    def attributes(self, complex_type: str) -> str:
        """Return the table of the attributes of a complex type."""
        element = self.named[f"{XS}complexType", complex_type]
        return table(TITLES, [self._attribute(each) for each in self._parts(element, "attribute")])

    def comment(self) -> str:
        """Return the comment before the root element."""
        comment = next(each for each in self.root.itersiblings(preceding=True))
        return " ".join(comment.text.split())

    def _content(self, element: etree._Element) -> etree._Element:
        return self.named.get((f"{XS}complexType", element.get("type")), element)

    def _parts(self, node: etree._Element, kind: str) -> Iterator[etree._Element]:
        """Yield the attributes or elements that a type declares, directly or by reference."""
        for child in node:
            if child.tag == f"{XS}{kind}":
                yield child
                continue
            referred = (child.tag, child.get("ref")), (f"{XS}complexType", child.get("base"))
            for reference in referred:
                if reference in self.named:
                    yield from self._parts(self.named[reference], kind)
            if child.tag not in {f"{XS}element", f"{XS}attribute"}:
                yield from self._parts(child, kind)

    def _section(self, name: str, element: etree._Element) -> Iterator[str]:
        content = self._content(element)
        attributes = list(self._parts(content, "attribute"))
        children = list(self._parts(content, "element"))
        if not attributes and not children:
            return
        yield f"### `<{name}>`"
        description = documentation(element) or documentation(content)
        if description:
            yield description
        if children:
            names = [f"`<{child.get('name')}>{_repeated(child)}`" for child in children]
            devices = [n for n, each in zip(names, children, strict=True) if _is_device(each)]
            others = [name for name in dict.fromkeys(names) if name not in devices]
            if devices:
                yield f"Devices, in any order: {', '.join(devices)}."
            yield f"Contains{' one of' if _is_choice(content) else ''}: {', '.join(others)}."
        rows = [self._attribute(each) for each in attributes]
        rows += [
            self._row(each, each.get("minOccurs") != "0", "<{}>")
            for each in children
            if not self._is_complex(each)
        ]
        if rows:
            yield table(TITLES, rows)
        example = self._example(name)
        if example:
            yield f"```xml\n{example}\n```"

    def _is_complex(self, element: etree._Element) -> bool:
        content = self._content(element)
        return any(True for kind in ("attribute", "element") for _ in self._parts(content, kind))

    def _attribute(self, each: etree._Element) -> tuple[str, ...]:
        return self._row(each, each.get("use") == "required")

    def _row(self, each: etree._Element, required: bool, form: str = "{}") -> tuple[str, ...]:
        default = each.get("default")
        absent = "required" if required else f"`{default}`" if default is not None else ""
        name = form.format(each.get("name"))
        return f"`{name}`", self._type(each), absent, documentation(each)

    def _type(self, each: etree._Element) -> str:
        values = [value.get("value") for value in each.iter(f"{XS}enumeration")]
        if values:
            return " or ".join(f"`{value}`" for value in values)
        name = (each.get("type") or "").removeprefix("xs:")
        named = self.named.get((f"{XS}simpleType", name))
        if named is not None:
            listed = [value.get("value") for value in named.iter(f"{XS}enumeration")]
            return " or ".join(f"`{value}`" for value in listed) or name
        return {"string": "text", "": "list"}.get(name, name)

    def _example(self, name: str) -> str:
        """Return the first element of that name in the bundled files that is short enough."""
        texts = (
            etree.tostring(node, encoding="unicode", with_tail=False)
            for file in self._examples
            for node in file.iter(name)
        )
        return next((_dedent(text) for text in texts if len(text) < MAX_EXAMPLE), "")


def documentation(node: etree._Element) -> str:
    """Return the annotation of a declaration, fit for a table's cell."""
    text = node.findtext(f"{XS}annotation/{XS}documentation") or ""
    return " ".join(text.split()).replace("|", "\\|")


def _is_device(child: etree._Element) -> bool:
    choice = child.getparent()
    return choice is not None and choice.get("id") == "devices"


def _is_choice(content: etree._Element) -> bool:
    choice = content.find(f"{XS}choice")
    return choice is not None and "maxOccurs" not in choice.attrib


def _repeated(child: etree._Element) -> str:
    if _is_device(child):
        return ""  # the reader of robot definitions reports a second one
    node, most = child, "1"
    while node is not None and node.tag not in {f"{XS}complexType", f"{XS}schema"}:
        most = node.get("maxOccurs") or most
        node = node.getparent()
    return "" if most == "1" else " ..."


def _dedent(text: str) -> str:
    first, *rest = text.splitlines()
    indent = min((len(line) - len(line.lstrip()) for line in rest if line.strip()), default=0)
    return "\n".join([first, *(line[indent:] for line in rest)])
