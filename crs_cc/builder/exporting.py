"""Export of a world to other programs: a picture as SVG or PNG, and SDF for Gazebo."""

from __future__ import annotations

import io
import math
from collections.abc import Iterator
from pathlib import Path
from typing import Final

import numpy as np

from crs_cc.core.suggest import unknown
from crs_cc.plot.picture import Picture, PlotDrawing, RobotPath
from crs_cc.sim.files.document import Element
from crs_cc.sim.files.xml_document import document_of
from crs_cc.sim.model.world import FIXED_KG, Box, Cylinder, Polygon, Pose, Solid, Wall, WorldModel

KINDS: Final = (".svg", ".png", ".sdf")

_TALL_M: Final = 2.5
"""The height in SDF of what has none in the world."""


def exported(world: WorldModel, kind: str) -> tuple[bytes, list[str]]:
    """Return a world in another format, and what was omitted.

    Args:
        world: the world.
        kind: `.svg`, `.png` or `.sdf`.

    Raises:
        ValueError: there is no such format.
    """
    if kind not in KINDS:
        raise ValueError(unknown("format", kind, KINDS))
    if kind == ".sdf":
        return _sdf(world)
    drawing = _drawing(world)
    if kind == ".svg":
        return drawing.render(), []
    return _png(drawing), []


def export(world: WorldModel, path: Path) -> list[str]:
    """Write a world to a file in another format; return what was omitted.

    Raises:
        ValueError: there is no such format.
        OSError: the file cannot be written.
    """
    content, left_out = exported(world, path.suffix.lower())
    path.write_bytes(content)
    return left_out


# -- pictures --------------------------------------------------------------------------------------


def _drawing(world: WorldModel) -> PlotDrawing:
    paths = [
        RobotPath(
            robot,
            np.array([[robot.start.x_m, robot.start.y_m]]),
            robot.start.heading_rad,
        )
        for robot in world.robots
    ]
    area = world.area
    return PlotDrawing(
        Picture(world.name, f"{area.length_m:g} m x {area.width_m:g} m", world, paths)
    )


def _png(drawing: PlotDrawing) -> bytes:
    from crs_cc.plot.raster import blank, draw, smaller  # Pillow is slow to load

    drawing.render()
    image = blank(drawing.page)
    draw(drawing.page, image)
    found = io.BytesIO()
    smaller(image).save(found, "PNG")
    return found.getvalue()


# -- SDF -------------------------------------------------------------------------------------------


def _sdf(world: WorldModel) -> tuple[bytes, list[str]]:
    """Return SDF 1.6 (sdformat.org); a wall is a box, without its round ends."""
    models = [_model(solid) for solid in world.solids() if not isinstance(solid, Polygon)]
    counts = {
        "polygon": len(world.polygons), "robot": len(world.robots), "light": len(world.lights),
        "sound": len(world.sounds), "ramp or plateau": len(world.surface.patches),
        "height map": int(world.surface.heightmap is not None), "goal": len(world.goals),
        "source": len(world.sources), "nest": len(world.nests),
    }  # fmt: skip
    left_out = [f"{count} of {kind}" for kind, count in counts.items() if count]
    inner = Element("world", 0, {"name": world.name}, children=[_ground(world), *models])
    return document_of(Element("sdf", 0, {"version": "1.6"}, children=[inner])), left_out


def _ground(world: WorldModel) -> Element:
    size = f"{world.area.length_m:g} {world.area.width_m:g}"
    normal, extent = Element("normal", 0, text="0 0 1"), Element("size", 0, text=size)
    x_m = world.area.x_min_m + world.area.length_m / 2
    y_m = world.area.y_min_m + world.area.width_m / 2
    plane = Element("plane", 0, children=[normal, extent])
    return _body("ground", (Pose(x_m, y_m), 0.0), plane, None, (0.8, 0.8, 0.8))


def _model(solid: Solid) -> Element:
    height_m = solid.height_m if math.isfinite(solid.height_m) else _TALL_M
    colour = tuple(part / 255 for part in solid.material.colour)
    red, green, blue = colour
    place, shape = _shape(solid, height_m)
    mass_kg = None if isinstance(solid, Wall) or solid.mass_kg == FIXED_KG else solid.mass_kg
    return _body(solid.id, (place, height_m / 2), shape, mass_kg, (red, green, blue))


def _shape(solid: Solid, height_m: float) -> tuple[Pose, Element]:
    if isinstance(solid, Cylinder):
        sizes = (_leaf("radius", solid.radius_m), _leaf("length", height_m))
        return solid.pose, Element("cylinder", 0, children=list(sizes))
    if isinstance(solid, Wall):
        along = solid.x2_m - solid.x1_m, solid.y2_m - solid.y1_m
        middle = (solid.x1_m + solid.x2_m) / 2, (solid.y1_m + solid.y2_m) / 2
        place = Pose(*middle, math.atan2(along[1], along[0]))
        return place, _box(math.hypot(*along), solid.thickness_m, height_m)
    assert isinstance(solid, Box)
    return solid.pose, _box(solid.length_m, solid.width_m, height_m)


def _box(length_m: float, width_m: float, height_m: float) -> Element:
    return Element("box", 0, children=[_leaf("size", length_m, width_m, height_m)])


def _body(
    name: str,
    where: tuple[Pose, float],
    shape: Element,
    mass_kg: float | None,
    colour: tuple[float, float, float],
) -> Element:
    """Return a model of one link at a pose and a height [m]."""
    place, z_m = where
    geometry = Element("geometry", 0, children=[shape])
    paint = Element(
        "material", 0, children=[_leaf("ambient", *colour, 1), _leaf("diffuse", *colour, 1)]
    )
    parts = [
        Element("collision", 0, {"name": "collision"}, children=[geometry]),
        Element("visual", 0, {"name": "visual"}, children=[geometry, paint]),
    ]
    if mass_kg is not None:
        parts.insert(0, Element("inertial", 0, children=[_leaf("mass", mass_kg)]))
    return Element("model", 0, {"name": name}, children=[
        Element("static", 0, text="true" if mass_kg is None else "false"),
        _leaf("pose", place.x_m, place.y_m, z_m, 0, 0, place.heading_rad),
        Element("link", 0, {"name": "link"}, children=parts),
    ])  # fmt: skip


def _leaf(tag: str, *numbers: float) -> Element:
    return Element(tag, 0, text=" ".join(_texts(numbers)))


def _texts(numbers: tuple[float, ...]) -> Iterator[str]:
    return (f"{number:.6g}" for number in numbers)
