"""The extents of a world's elements, taken from the loaded world."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import Final

import numpy as np

from crs_cc.builder.addresses import address, ids
from crs_cc.builder.arrangement import Extent, Extents
from crs_cc.builder.composition import definitions
from crs_cc.builder.document import Document
from crs_cc.builder.motion import frame
from crs_cc.sim.geometry.placement import distance_from_m
from crs_cc.sim.geometry.scene import corners_m
from crs_cc.sim.model.ground import Patch
from crs_cc.sim.model.world import Box, Cylinder, Pose, Solid, Wall, WorldModel

_PLACES: Final = 40
"""Places along each side where a robot is tried."""


def extents(document: Document, world: WorldModel) -> Extents:
    """Return the extents of elements, by their names; invalid elements are omitted.

    Args:
        document: the document.
        world: what it describes.
    """
    known = ids(document.root)
    corners: dict[str, list[tuple[float, float]]] = {}
    solids: dict[str, list[Solid]] = {}
    for solid in world.solids()[len(world.edge_walls()) :]:
        name = element_of(solid.id, known)
        solids.setdefault(name, []).append(solid)
        corners.setdefault(name, []).extend(_corners(solid))
    corners.update(_parts(document, solids))
    for robot in world.robots:
        corners[robot.id] = list(_disc(robot.start.x_m, robot.start.y_m, robot.model.radius_m))
    for name, patch in patches(document, world):
        pose = Pose(patch.x_m, patch.y_m, patch.heading_rad)
        corners[name] = list(_rectangle(pose, patch.length_m, patch.width_m))
    return {
        name: Extent(
            min(x for x, _ in found),
            min(y for _, y in found),
            max(x for x, _ in found),
            max(y for _, y in found),
        )
        for name, found in corners.items()
    }


def _parts(
    document: Document, solids: Mapping[str, Sequence[Solid]]
) -> Iterator[tuple[str, list[tuple[float, float]]]]:
    """Yield corners of the parts of definitions, in their frames, as far as they are used."""
    known, done = definitions(document.root), set[str]()
    for name, node in ids(document.root).items():
        ref = node.attributes.get("ref", "")
        if node.tag != "object" or ref not in known or ref in done or name not in solids:
            continue
        done.add(ref)
        back = frame(node).inverse()
        for own, part in ids(known[ref]).items():
            whole = f"{name}.{own}"
            found = [back.point(*corner) for solid in solids[name]
                     if solid.id == whole or solid.id.startswith(f"{whole}.")
                     for corner in _corners(solid)]  # fmt: skip
            if found:
                yield address(part), found


def patches(document: Document, world: WorldModel) -> Iterator[tuple[str, Patch]]:
    """Yield the names of ramps and plateaus with their models."""
    grounds = [each for each in document.root.children if each.tag == "surface"]
    nodes = [each for ground in grounds for each in ground.children if each.tag != "heightmap"]
    for node, patch in zip(nodes, world.surface.patches, strict=False):
        yield address(node), patch


def free_place(world: WorldModel, room_m: float) -> tuple[float, float] | None:
    """Return a place far from everything, the first on a grid; None if there is none.

    Args:
        world: the world.
        room_m: the least distance from everything.
    """
    area = world.area
    step_m = max(room_m / 2, area.length_m / _PLACES, area.width_m / _PLACES)
    xs = np.arange(area.x_min_m + room_m, area.x_max_m - room_m + step_m / 2, step_m)
    ys = np.arange(area.y_min_m + room_m, area.y_max_m - room_m + step_m / 2, step_m)
    grid_x, grid_y = (each.ravel() for each in np.meshgrid(xs, ys))
    is_free = np.ones(len(grid_x), dtype=np.bool_)
    for solid in world.solids():
        is_free &= distance_from_m(solid, grid_x, grid_y) >= room_m
    found = np.flatnonzero(is_free)
    return (float(grid_x[found[0]]), float(grid_y[found[0]])) if len(found) else None


def element_of(name: str, known: Collection[str]) -> str:
    """Return the name of the element that a solid is or is a part of."""
    whole = name
    while whole not in known and "." in whole:
        whole = whole.rpartition(".")[0]
    return whole


def bounds_m(solid: Solid) -> tuple[float, float, float, float]:
    """Return the bounding box of a solid: left, bottom, right, top."""
    corners = list(_corners(solid))
    xs, ys = [x for x, _ in corners], [y for _, y in corners]
    return min(xs), min(ys), max(xs), max(ys)


def _corners(solid: Solid) -> Iterator[tuple[float, float]]:
    """Yield points that span the extent of a solid."""
    if isinstance(solid, Wall):
        yield from _disc(solid.x1_m, solid.y1_m, solid.thickness_m / 2)
        yield from _disc(solid.x2_m, solid.y2_m, solid.thickness_m / 2)
    elif isinstance(solid, Cylinder):
        yield from _disc(solid.pose.x_m, solid.pose.y_m, solid.radius_m)
    elif isinstance(solid, Box):
        yield from _rectangle(solid.pose, solid.length_m, solid.width_m)
    else:
        yield from ((float(x), float(y)) for x, y in corners_m(solid).tolist())


def _disc(x_m: float, y_m: float, radius_m: float) -> Iterator[tuple[float, float]]:
    yield x_m - radius_m, y_m - radius_m
    yield x_m + radius_m, y_m + radius_m


def _rectangle(pose: Pose, length_m: float, width_m: float) -> Iterator[tuple[float, float]]:
    for x_m, y_m in ((1, 1), (-1, 1), (-1, -1), (1, -1)):
        place = Pose(x_m * length_m / 2, y_m * width_m / 2).within(pose)
        yield place.x_m, place.y_m
