"""Ids of objects in a world file: default ids and their uniqueness."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from typing import Final

from crs_cc.sim.files.document import Element, Reader

TAGS_WITH_ID: Final = frozenset(
    {"wall", "box", "cylinder", "polygon", "object", "map", "robot", "degradation"}
    | {"light", "sound", "goal", "scatter", "source", "nest"}
)
"""The elements that have an id."""

_OURS: Final = ("edge-", "obstacle-")  # reserved; `obstacle-` is for objects that programs add
_ID: Final = re.compile(r"[A-Za-z_][A-Za-z0-9_.\-]{0,63}")


def validation_error(name: str) -> str:
    """Return why an id is invalid; empty if it is valid.

    >>> validation_error("edge-north")
    'the prefix edge- is reserved'
    """
    if name.startswith(_OURS):
        return f"the prefix {name.partition('-')[0]}- is reserved"
    if not _ID.fullmatch(name):
        return "must be 1 to 64 letters, digits, _ . -, and start with a letter or _"
    return ""


def name_objects(elements: Sequence[Element], reader: Reader) -> None:
    """Set default ids, and report ids that are invalid or used twice."""
    used: dict[str, Element] = {}
    counts: dict[str, int] = {}
    for element in elements:
        if element.tag not in TAGS_WITH_ID:
            continue
        number = counts.get(element.tag, 0)
        counts[element.tag] = number + 1
        name = element.attributes.setdefault("id", f"{element.tag}{number}")
        if name in used:
            reader.error(
                element,
                f"duplicate id {name!r} (first used in {used[name].place})",
            )
        elif wrong := validation_error(name):
            reader.error(element, f"invalid id {name!r}: {wrong}")
        used.setdefault(name, element)


def check_parts(parts: Iterable[tuple[Element, str]], used: Iterable[str], reader: Reader) -> None:
    """Report ids of parts of objects that are too long or already used.

    Args:
        parts: the object and the id of each part.
        used: all other ids.
        reader: receives the errors.
    """
    known = set(used)
    for element, name in parts:
        if name in known:
            reader.error(element, f"duplicate id {name!r}")
        elif not _ID.fullmatch(name):
            reader.error(element, f"the id {name!r} of a part is longer than 64 characters")
        known.add(name)
