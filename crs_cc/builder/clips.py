r"""Copies of elements for other worlds, as text, with the definitions that they need.

A clip is XML with the root `<clip>`: materials, definitions, then the elements. It can be pasted
into the same world, another one, or a text editor.

>>> room = Document(b"<world>\n  <box id='a' x='1m' y='1m'/>\n</world>", "room.xml")
>>> text = clip(room, room.root.children, ())
>>> print(text)
<clip>
  <box id='a' x='1m' y='1m'/>
</clip>
>>> room.change("paste", paste(room, text, Motion.shift(0.5, 0), ()).splices)
>>> print(room.text.decode())
<world>
  <box id='a' x='1m' y='1m'/>
  <box id='a-2' x='1.5m' y='1m'/>
</world>
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path, PurePosixPath
from typing import Final

from crs_cc.builder import markup
from crs_cc.builder.addresses import address, ids, outermost, unused_name
from crs_cc.builder.arrangement import MAX_COPIES, written
from crs_cc.builder.changes import IN_SURFACE, Plan
from crs_cc.builder.document import Document, Splice
from crs_cc.builder.motion import Motion, movable, moved
from crs_cc.builder.spans import Node
from crs_cc.core.errors import WorldError
from crs_cc.sim.files.include import MAX_FILES
from crs_cc.sim.files.nearby import read_below
from crs_cc.sim.files.object_ids import TAGS_WITH_ID
from crs_cc.sim.files.xml_document import MAX_BYTES

_NAMED: Final = ("material", "define")
_CLIPPED: Final = (*_NAMED, *IN_SURFACE, *TAGS_WITH_ID)


def included_files(document: Document, folder: Path | None) -> Iterator[Document]:
    """Yield the files that a document includes, those that they include too, as far as readable."""
    if folder is None:
        return
    work, seen = [(PurePosixPath(), document)], set[PurePosixPath]()
    while work:
        where, inner = work.pop(0)
        for node in inner.root.children:
            path = where / node.attributes.get("file", "")
            if node.tag != "include" or path in seen or len(seen) >= MAX_FILES:
                continue
            seen.add(path)
            try:
                text = read_below(folder, str(path), ".xml", MAX_BYTES)
                found = Document(text, str(folder / path))
            except (ValueError, WorldError):
                continue  # the loader reports the error
            work.append((path.parent, found))
            yield found


def clip(document: Document, nodes: Sequence[Node], library: Sequence[Document]) -> str:
    """Return elements as text, with the materials and definitions that they need.

    Args:
        document: the document.
        nodes: the elements.
        library: the files that it includes.
    """
    whole = [node for node in outermost(nodes) if node.parent is not None]
    known = {
        (each.tag, each.attributes.get("name", "")): (home, each)
        for home in (*reversed(library), document)
        for each in home.root.children
        if each.tag in _NAMED
    }
    needed: set[tuple[str, str]] = set()
    work = list(whole)
    for node in work:
        for each in node.all():
            for key in _needs(each):
                if key in known and key not in needed:
                    needed.add(key)
                    work.append(known[key][1])
    given = {id(node) for node in whole}
    order = [key for kind in _NAMED for key in known if key in needed and key[0] == kind]
    texts = [
        *(markup.fragment(*known[key]) for key in order if id(known[key][1]) not in given),
        *(markup.fragment(document, node) for node in whole),
    ]
    return markup.element("clip", {}, "", *texts)


def _needs(node: Node) -> Iterator[tuple[str, str]]:
    if node.tag == "object":
        yield "define", node.attributes.get("ref", "")
    if "material" in node.attributes:
        yield "material", node.attributes["material"]


def paste(document: Document, text: str, motion: Motion, library: Sequence[Document]) -> Plan:
    """Put the elements of a clip into a world; ids that are taken get the next number.

    Materials and definitions that are there already stay as they are.

    Args:
        document: the document.
        text: the clip.
        motion: what to do with positions.
        library: the files that the document includes.

    Raises:
        WorldError: the clip is no clip.
        ValueError: something in it cannot be put there.
    """
    source = Document(text.encode(errors="replace"), "clip")
    if source.root.tag != "clip" or len(source.root.children) > MAX_COPIES:
        raise ValueError("not a copied part of a world")
    there = {
        (each.tag, each.attributes.get("name", ""))
        for home in (document, *library)
        for each in home.root.children
    }
    new_ids: dict[str, str] = {}
    taken = set(ids(document.root))
    for name in ids(source.root):
        new_ids[name] = unused_name(name, taken)
        taken.add(new_ids[name])
    plan = Plan([])
    groups: dict[str, list[str]] = {}
    for node in source.root.children:
        if node.tag not in _CLIPPED:
            raise ValueError(f"<{node.tag}> cannot be pasted")
        if node.tag in _NAMED:
            if (node.tag, node.attributes.get("name", "")) not in there:
                groups.setdefault(node.tag, []).append(markup.fragment(source, node))
            continue
        values = moved(source, node, motion) if list(movable(node)) == [node] else {}
        if node.tag in TAGS_WITH_ID:
            values["id"] = new_ids[address(node)]
            plan.names.append(new_ids[address(node)])
        groups.setdefault(node.tag, []).append(written(source, node, values))
    for tag, texts in groups.items():
        plan.splices += _inserted(document, tag, texts)
    return plan


def _inserted(document: Document, tag: str, texts: Sequence[str]) -> list[Splice]:
    root = document.root
    if tag not in IN_SURFACE:
        return markup.insert(document, root, tag, texts)
    surface = next((each for each in root.children if each.tag == "surface"), None)
    if surface is not None:
        return markup.insert(document, surface, tag, texts)
    return markup.insert(document, root, "surface", [markup.element("surface", {}, "", *texts)])
