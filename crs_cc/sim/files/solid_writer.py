"""Elements for the walls and objects of a world.

A composite object becomes a `<define>` of its own whose frame is that of the world, so that its
parts are exactly where they were. The order of all walls, boxes and so on is kept.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Final

import numpy as np

from crs_cc.core.quantity import ANGLE, HEAT, LENGTH, MASS
from crs_cc.sim.files.document import Element
from crs_cc.sim.model.colours import hexadecimal
from crs_cc.sim.model.mass_properties import floor_m2
from crs_cc.sim.model.world import (
    EVERYWHERE_M,
    FIXED_KG,
    PLAIN,
    TALL_M,
    Box,
    Material,
    Polygon,
    Pose,
    Robot,
    Solid,
    Wall,
    WorldModel,
    WorldObject,
)

_TRIES: Final = 64


def solid_elements(world: WorldModel) -> list[Element]:
    """Return the elements of all walls and objects.

    Raises:
        ValueError: the parts of a composite object are not next to each other.
    """
    kinds: tuple[Sequence[Solid], ...] = (
        world.walls, world.boxes, world.cylinders, world.polygons
    )  # fmt: skip
    groups: dict[str, list[WorldObject]] = {}
    before: dict[str, list[str]] = {}
    alone: dict[str, Solid] = {}
    for solids in kinds:
        last = ""
        for solid in solids:
            name = _whole(solid)
            if name != solid.id and not isinstance(solid, Wall):
                groups.setdefault(name, []).append(solid)
            else:
                alone[name] = solid
            before.setdefault(name, [])
            if last not in ("", name):
                before[name].append(last)
            last = name
    found: list[Element] = []
    for name in _ordered(before):
        found += _composite(name, groups[name]) if name in groups else [solid_element(alone[name])]
    return found


def _ordered(before: Mapping[str, Sequence[str]]) -> list[str]:
    """Return names so that each follows those that must be before it.

    >>> _ordered({"a": [], "b": ["a", "d"], "c": [], "d": ["c"]})
    ['a', 'c', 'd', 'b']
    """
    done: dict[str, None] = {}
    for first in before:
        work = {first: None}
        while work:
            name = next(reversed(work))
            missing = next((each for each in before[name] if each not in done), None)
            if missing is None:
                done[name] = work.pop(name)
            elif missing in work:
                raise ValueError(
                    f"{name!r} and {missing!r} are mixed (the parts of an object must follow one"
                    " another)"
                )
            else:
                work[missing] = None
    return list(done)


def _whole(solid: Solid) -> str:
    """Return the name of the object that a solid is, or is a part of."""
    return solid.id if isinstance(solid, Wall) else solid.part_of or solid.id


def _composite(name: str, parts: Sequence[WorldObject]) -> Iterator[Element]:
    """Yield the definition of a composite object, and the object."""
    children = [solid_element(part) for part in parts]
    for child in children:
        child.attributes["id"] = child.attributes["id"].removeprefix(f"{name}.")
        child.attributes.pop("mass", None)
    yield Element("define", 0, {"name": name}, children=children)
    place = {"x": "0m", "y": "0m"}
    yield Element("object", 0, {"id": name, "ref": name, **place, "mass": _whole_mass(parts)})


def _whole_mass(parts: Sequence[WorldObject]) -> str:
    """Return the mass of which the parts have the shares that the reader gives them."""
    areas_m2 = [floor_m2(part) for part in parts]
    whole_m2, mass_kg = sum(areas_m2), sum(part.mass_kg for part in parts)
    shares = list(zip(parts, areas_m2, strict=True))
    for tried in _near(mass_kg):
        if all(part.mass_kg == tried * area / whole_m2 for part, area in shares):
            return MASS.exact(tried)
    return MASS.exact(mass_kg)


def _near(value: float) -> Iterator[float]:
    """Yield the numbers around a value, round ones first."""
    yield float(f"{value:.12g}")
    below = above = value
    for _ in range(_TRIES):
        yield below
        yield above
        below, above = float(np.nextafter(below, 0.0)), float(np.nextafter(above, np.inf))


def solid_element(solid: Solid) -> Element:
    """Return the element of a single wall or object."""
    if isinstance(solid, Wall):
        return Element("wall", 0, {"id": solid.id, **_wall(solid), **_common(solid)})
    mass = {} if solid.mass_kg == FIXED_KG else {"mass": MASS.exact(solid.mass_kg)}
    common = {**mass, **_common(solid)}
    if isinstance(solid, Polygon):
        return Element("polygon", 0, {"id": solid.id, **_polygon(solid), **common})
    place = pose(solid.pose)
    if isinstance(solid, Box):
        size = {"length": LENGTH.exact(solid.length_m), "width": LENGTH.exact(solid.width_m)}
        return Element("box", 0, {"id": solid.id, **place, **size, **common})
    size = {"radius": LENGTH.exact(solid.radius_m)}
    return Element("cylinder", 0, {"id": solid.id, **place, **size, **common})


def _wall(wall: Wall) -> dict[str, str]:
    names = ("x1", "y1", "x2", "y2", "thickness")
    return {name: LENGTH.exact(getattr(wall, f"{name}_m")) for name in names}


def _polygon(polygon: Polygon) -> dict[str, str]:
    """Return the corners in the world's frame if that is exact, else in the polygon's own."""
    if polygon.pose.heading_rad == 0.0:
        place = np.array([polygon.pose.x_m, polygon.pose.y_m])
        for digits in (12, 17):
            corners = [
                (float(f"{x:.{digits}g}"), float(f"{y:.{digits}g}"))
                for x, y in (np.array(polygon.corners_m) + place).tolist()
            ]
            again = Polygon.of(polygon.id, corners)
            if (again.pose, again.corners_m) == (polygon.pose, polygon.corners_m):
                return {"points": _points(corners)}
    return {"points": _points(polygon.corners_m), **pose(polygon.pose)}


def _points(corners_m: Sequence[tuple[float, float]]) -> str:
    return " ".join(f"{LENGTH.exact(x)},{LENGTH.exact(y)}" for x, y in corners_m)


def pose(place: Pose) -> dict[str, str]:
    """Return the attributes of a pose."""
    found = {"x": LENGTH.exact(place.x_m), "y": LENGTH.exact(place.y_m)}
    if place.heading_rad != 0.0:
        found["heading"] = ANGLE.exact(place.heading_rad)
    return found


def _common(solid: Solid) -> dict[str, str]:
    height = {} if solid.height_m == TALL_M else {"height": LENGTH.exact(solid.height_m)}
    return {**hot(solid), **surface(solid.material), **height}


def hot(obj: Solid | Robot) -> dict[str, str]:
    """Return the attributes of an object's heat."""
    found = {} if obj.heat == 0.0 else {"heat": HEAT.exact(obj.heat)}
    if obj.spread_m != EVERYWHERE_M:
        found["spread"] = LENGTH.exact(obj.spread_m)
    return found


def surface(material: Material) -> dict[str, str]:
    """Return the attributes of a material."""
    found: Mapping[str, str | None] = {
        "colour": hexadecimal(material.colour) if material.colour != PLAIN.colour else None,
        "sonar": f"{float(material.sonar)!r}" if material.sonar != PLAIN.sonar else None,
        "infrared": None if material.infrared is None else f"{float(material.infrared)!r}",
    }
    return {name: text for name, text in found.items() if text is not None}
