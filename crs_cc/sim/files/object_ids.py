"""The names of things in a world file: given where there is none, and unique."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from typing import Final

from crs_cc.sim.files.document import Element, Reader

THINGS: Final = frozenset(
    {"wall", "box", "cylinder", "polygon", "object", "map", "robot", "degradation"}
    | {"light", "sound"}
)
"""The elements that have an id."""

_OURS: Final = ("edge-", "obstacle-")  # what programs add is named so
_ID: Final = re.compile(r"[A-Za-z_][A-Za-z0-9_.\-]{0,63}")


def complaint(name: str) -> str:
    """Gives why a thing cannot be called so; empty if it can.

    >>> complaint("edge-north")
    "names that begin with edge- are the world's"
    """
    if name.startswith(_OURS):
        return f"names that begin with {name.partition('-')[0]}- are the world's"
    if not _ID.fullmatch(name):
        return "letters, digits, _ . - only, no digit first, at most 64"
    return ""


def name_things(elements: Sequence[Element], reader: Reader) -> None:
    """Gives ids to things that have none, and notes ids that cannot be, or are used twice."""
    used: dict[str, Element] = {}
    counts: dict[str, int] = {}
    for element in elements:
        if element.tag not in THINGS:
            continue
        number = counts.get(element.tag, 0)
        counts[element.tag] = number + 1
        name = element.attributes.setdefault("id", f"{element.tag}{number}")
        if name in used:
            reader.error(
                element,
                f"a second thing with the id {name!r}; the first is in {used[name].place}",
            )
        elif wrong := complaint(name):
            reader.error(element, f"the id {name!r}: {wrong}")
        used.setdefault(name, element)


def check_parts(parts: Iterable[tuple[Element, str]], used: Iterable[str], reader: Reader) -> None:
    """Notes ids of parts of objects that are too long, or used by something else.

    Args:
        parts: the object and the id of each part.
        used: the ids of all else.
        reader: gets the mistakes.
    """
    known = set(used)
    for element, name in parts:
        if name in known:
            reader.error(element, f"a second thing with the id {name!r}")
        elif not _ID.fullmatch(name):
            reader.error(element, f"the id {name!r} of a part has more than 64 characters")
        known.add(name)
