"""Writes `docs/world-format.md` from the annotations of the schemas, with examples from our files.

`--update-goldens` rewrites the page.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from lxml import etree

import crs_cc.sim

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "world-format.md"
SIM = Path(crs_cc.sim.__file__).parent
XS = "{http://www.w3.org/2001/XMLSchema}"
TEMPLATES = SIM.parent / "cli" / "templates"
ROBOTS = SIM / "files" / "robots"
EXAMPLES = {  # the first file that has an element shows it
    "world.xsd": [TEMPLATES / "world.xml", *sorted((ROOT / "worlds").rglob("*.xml"))],
    "robot.xsd": [
        TEMPLATES / "robot.xml",
        *sorted((ROBOTS).glob("*.xml"), reverse=True),
    ],
}
LONGEST = 500

INTRODUCTION = """\
<!-- made by tests/sim/test_world_format_page.py of crs_cc/sim/files/world.xsd and robot.xsd;
     edit there, then pytest --update-goldens -->

# World and robot files

A world file says what stands where before the first timestep, and which robots run which programs.
A robot definition says what a kind of robot is made of. Both are XML; `crs_cc/sim/files/world.xsd`
and `robot.xsd` are their schemas, which let editors complete and check them.

```sh
crs new world room           # a commented start: room.xml; also robot, program
crs check room.xml           # what is in it, and all that is wrong with it, each with its line
```

![Three robots in a world with walls, and things that are hot](images/complex-3r.svg)

This is [complex-3r.xml](../worlds/complex-3r.xml) after a run. [worlds/](../worlds) has more, each
with one idea.

**Frames.** x goes to the right and y up, angles are counter-clockwise from x. Of a robot or an
object x points ahead and y to the left.

**Names.** Everything has an `id`, unique in the world; if none is given, its kind and a number:
`robot0`, `wall0`. Parts of an object are called `t1.leg0`, boxes of a map `plan.0`.

**Files** that a world names (programs, pictures, definitions, files to include) lie in its own
folder or below. Document types and entities are refused.

**Mistakes** are all told at once, with file and line, and crs ends with 122: what the schema does
not allow, numbers without sense, ids used twice, robots in walls, things to be pushed that overlap
something, sensors outside of a robot's body, programs, pictures and definitions that are missing.
"""


class Schema:
    """A schema, as a reader of its files needs it."""

    def __init__(self, name: str) -> None:
        self.root = etree.parse(SIM / "files" / name).getroot()
        self.examples = [etree.parse(path) for path in EXAMPLES[name]]
        self.done: set[tuple[str, str | None]] = set()
        self.named = {(each.tag, each.get("name")): each for each in self.root}

    def page(self, outermost: str) -> Iterator[str]:
        """Gives the section of each element, the outermost first, each kind of element once."""
        work = [(outermost, self.named[f"{XS}element", outermost])]
        for name, element in work:
            content = self.content(element)
            key = name, element.get("type")
            if key in self.done:
                continue
            self.done.add(key)
            children = list(self.parts(content, "element"))
            yield from self.section(name, element, content, children)
            work += [(child.get("name"), child) for child in children]

    def content(self, element: etree._Element) -> etree._Element:
        return self.named.get((f"{XS}complexType", element.get("type")), element)

    def parts(self, node: etree._Element, kind: str) -> Iterator[etree._Element]:
        """Gives the declarations of attributes or elements in a type, those by reference too."""
        for child in node:
            if child.tag == f"{XS}{kind}":
                yield child
                continue
            referred = (child.tag, child.get("ref")), (f"{XS}complexType", child.get("base"))
            for reference in referred:
                if reference in self.named:
                    yield from self.parts(self.named[reference], kind)
            if child.tag not in {f"{XS}element", f"{XS}attribute"}:
                yield from self.parts(child, kind)

    def section(
        self,
        name: str,
        element: etree._Element,
        content: etree._Element,
        children: list[etree._Element],
    ) -> Iterator[str]:
        attributes = list(self.parts(content, "attribute"))
        if not attributes and not children:
            return
        yield f"### `<{name}>`\n"
        said = documentation(element) or documentation(content)
        if said:
            yield f"{said}\n"
        if children:
            names = dict.fromkeys(f"`<{child.get('name')}>`{often(child)}" for child in children)
            yield f"In it: {', '.join(names)}.\n"
        plain = [child for child in children if not self.is_complex(child)]
        rows = [self.row(each, each.get("use") == "required") for each in attributes]
        rows += [self.row(each, each.get("minOccurs") != "0", "<{}>") for each in plain]
        if rows:
            yield "| attribute | what it is | if not given | |\n| --- | --- | --- | --- |"
            yield "\n".join(rows) + "\n"
        example = self.example(name)
        if example:
            yield f"```xml\n{example}\n```\n"

    def is_complex(self, element: etree._Element) -> bool:
        content = self.content(element)
        return any(True for kind in ("attribute", "element") for _ in self.parts(content, kind))

    def row(self, each: etree._Element, required: bool, form: str = "{}") -> str:
        default = each.get("default")
        absent = "must be given" if required else f"`{default}`" if default is not None else ""
        name = form.format(each.get("name"))
        return f"| `{name}` | {self.kind(each)} | {absent} | {documentation(each)} |"

    def kind(self, each: etree._Element) -> str:
        values = [value.get("value") for value in each.iter(f"{XS}enumeration")]
        if values:
            return " or ".join(f"`{value}`" for value in values)
        name = (each.get("type") or "").removeprefix("xs:")
        named = self.named.get((f"{XS}simpleType", name))
        if named is not None:
            listed = [value.get("value") for value in named.iter(f"{XS}enumeration")]
            return " or ".join(f"`{value}`" for value in listed) or name
        return {"string": "text", "": "list"}.get(name, name)

    def kinds(self) -> Iterator[str]:
        """Gives what the kinds of values are."""
        for (tag, name), each in self.named.items():
            if tag == f"{XS}simpleType" and documentation(each):
                yield f"- *{name}*: {documentation(each)}"

    def example(self, name: str) -> str:
        """Gives the first element of that name in the files that come with crs, if it is short."""
        texts = (
            etree.tostring(node, encoding="unicode", with_tail=False)
            for file in self.examples
            for node in file.iter(name)
        )
        return next((dedented(text) for text in texts if len(text) < LONGEST), "")


def documentation(node: etree._Element) -> str:
    text = node.findtext(f"{XS}annotation/{XS}documentation") or ""
    return " ".join(text.split()).replace("|", "\\|")


def often(child: etree._Element) -> str:
    node, most = child, "1"
    while node is not None and node.tag not in {f"{XS}complexType", f"{XS}schema"}:
        most = node.get("maxOccurs") or most
        node = node.getparent()
    return "" if most == "1" else " ..."


def dedented(text: str) -> str:
    first, *rest = text.splitlines()
    indent = min((len(line) - len(line.lstrip()) for line in rest if line.strip()), default=0)
    return "\n".join([first, *(line[indent:] for line in rest)])


def page() -> str:
    world, robot = Schema("world.xsd"), Schema("robot.xsd")
    parts = [INTRODUCTION, "## Values\n", *world.kinds(), ""]
    parts += ["## World files\n", *world.page("world")]
    parts += ["## Files that worlds include\n", *world.page("definitions")]
    comment = next(each for each in robot.root.itersiblings(preceding=True))
    said = " ".join(comment.text.split())
    parts += ["## Robot definitions\n", f"{said}\n", *robot.page("robot-definition")]
    return "\n".join(parts).rstrip() + "\n"


def test_the_page_is_what_the_schemas_say(check_golden: Callable[[Path, bytes], None]) -> None:
    check_golden(PAGE, page().encode())


@pytest.mark.parametrize("name", ["world.xsd", "robot.xsd"])
def test_everything_in_the_schemas_is_explained(name: str) -> None:
    schema = Schema(name)
    silent = [
        each.get("name")
        for each in schema.root.iter(f"{XS}complexType")
        if each.get("name") and not documentation(each)
    ]
    assert not silent
