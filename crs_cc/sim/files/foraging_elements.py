"""The elements `<source>` and `<nest>` of a world file, read and written."""

from __future__ import annotations

from typing import Final

from crs_cc.core.quantity import LENGTH, TIME
from crs_cc.sim.files.document import Element, Reader
from crs_cc.sim.model.foraging import MAX_ITEMS, MAX_PLACES, NEVER_S, Nest, Source

_USUAL: Final = Source("", 0.0, 0.0)


def sources_of(root: Element, reader: Reader) -> tuple[Source, ...]:
    """Return the sources of a world file; errors go to the reader."""
    return tuple(
        Source(*_place(element, reader), _items(element, reader), _refill_s(element, reader))
        for element in _some(root, "source", reader)
    )


def nests_of(root: Element, reader: Reader) -> tuple[Nest, ...]:
    """Return the nests of a world file; errors go to the reader."""
    return tuple(Nest(*_place(element, reader)) for element in _some(root, "nest", reader))


def _some(root: Element, tag: str, reader: Reader) -> list[Element]:
    found = list(root.all(tag))
    if len(found) > MAX_PLACES:
        reader.error(found[MAX_PLACES], f"more than {MAX_PLACES} places of this kind (<{tag}>)")
    return found[:MAX_PLACES]


def _place(element: Element, reader: Reader) -> tuple[str, float, float, float]:
    """Return the id, centre and radius of a place."""
    return (
        element.attributes["id"],
        reader.quantity(element, "x", LENGTH),
        reader.quantity(element, "y", LENGTH),
        reader.positive(element, "radius", LENGTH, _USUAL.radius_m),
    )


def _items(element: Element, reader: Reader) -> int | None:
    if "items" not in element.attributes:
        return None
    return reader.whole(element, "items", 1, MAX_ITEMS)


def _refill_s(element: Element, reader: Reader) -> float:
    if "refill" in element.attributes and "items" not in element.attributes:
        reader.refuse(element, "refill: this source never runs out, as it has no items='...'")
    return reader.positive(element, "refill", TIME, NEVER_S)


def place_element(place: Source | Nest) -> Element:
    """Return the element of a source or a nest."""
    attributes = {
        "id": place.id,
        "x": LENGTH.exact(place.x_m),
        "y": LENGTH.exact(place.y_m),
        "radius": LENGTH.exact(place.radius_m),
    }
    if isinstance(place, Nest):
        return Element("nest", 0, attributes)
    if place.items is not None:
        attributes["items"] = str(place.items)
    if place.refill_s != NEVER_S:
        attributes["refill"] = TIME.exact(place.refill_s)
    return Element("source", 0, attributes)
