"""The plot of a run: the world from above, each robot's path and its contacts.

x points right and y up, as in the world file. A path runs from a hollow circle (start) to
the robot's shape with its heading (end).
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass, field
from typing import Final

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.core.quantity import round_length
from crs_cc.plot.beacons import draw_beacons, draw_fingers, draw_places
from crs_cc.plot.goal_layer import draw_goals
from crs_cc.plot.sensor_overlay import draw_sights
from crs_cc.plot.svg import Page, Point, View
from crs_cc.plot.terrain_layer import PAPER, draw_terrain, terrain_corners_m
from crs_cc.plot.tracks import simplified
from crs_cc.plot.x11_colours import HEX
from crs_cc.sim.engine.drawings import Drawing
from crs_cc.sim.engine.robot_colours import colour
from crs_cc.sim.engine.sensor_overlay import Beam
from crs_cc.sim.geometry.scene import corners_m
from crs_cc.sim.model.colours import hexadecimal
from crs_cc.sim.model.foraging import Nest, Source
from crs_cc.sim.model.world import (
    PLAIN,
    Cylinder,
    Robot,
    Solid,
    Wall,
    WorldModel,
    WorldObject,
    is_pushable,
)

_LONG_SIDE_PX: Final = 760.0
_SHORT_SIDE_PX: Final = 240.0
_LEFT_PX: Final = 48.0
_HEAD_PX: Final = 64.0
_FOOT_PX: Final = 44.0
_LEGEND_PX: Final = 190.0
_ROW_PX: Final = 20.0
_TOLERANCE_PX: Final = 0.3
_DIFFERS_PX: Final = 3.0
_LARGEST_MARK_PX: Final = 5.0
_FONT: Final = "Helvetica, Arial, sans-serif"
_INK: Final = "#2b303a"
_FAINT_INK: Final = "#7b8494"
_CONTACT: Final = "#d1242f"
_WALL: Final = "#4a5160"
_OUTLINE_PX: Final = 0.8
_FIXED: Final = "#8d95a3"
_MOVABLE: Final = "#d9b88a"


@dataclass(frozen=True, slots=True)
class RobotPath:
    """The path of one robot.

    Attributes:
        robot: the robot, with its pose at the start.
        path: positions of its centre [m], shape (samples, 2), from start to end; empty for one that
            never joined.
        heading_rad: its heading at the end.
        left: whether it has left the world.
        odometry: the path by its odometry [m], in the world frame, shape (samples, 2).
        odometry_error_m: the greatest distance between that and the true path.
        marks: positions on the path [m], with the time at which it was there, as text.
    """

    robot: Robot
    path: FloatArray
    heading_rad: float
    left: bool = False
    odometry: FloatArray = field(default_factory=lambda: np.zeros((0, 2)))
    odometry_error_m: float = 0.0
    marks: Sequence[tuple[float, float, str]] = ()


@dataclass(frozen=True, slots=True)
class Picture:
    """The contents of a plot.

    Attributes:
        title: the heading.
        subtitle: the line below it.
        paths: the robots.
        contacts: robot number and position [m] of each contact.
        pushed: objects that were moved, at their final poses.
        drawings: what the programs drew.
        sights: the last readings of sensors.
    """

    title: str
    subtitle: str
    world: WorldModel
    paths: Sequence[RobotPath]
    contacts: Sequence[tuple[int, float, float]] = ()
    pushed: Sequence[WorldObject] = ()
    drawings: Sequence[Drawing] = ()
    sights: Sequence[Beam] = ()

    def render(self) -> bytes:
        """Return the picture as SVG."""
        return PlotDrawing(self).render()


class PlotDrawing:
    """Draws a picture, all of it or in layers."""

    def __init__(self, picture: Picture, long_side_px: float = _LONG_SIDE_PX) -> None:
        self.picture = picture
        low, high = _bounds(picture)
        extent = high - low
        scale = long_side_px / float(extent.max())
        width, height = (max(_SHORT_SIDE_PX, float(side) * scale) for side in extent)
        self.size = (width, height)
        centre = (low + high) / 2
        self.low = centre - np.array(self.size) / scale / 2
        self.high = centre + np.array(self.size) / scale / 2
        self.view = View(float(self.low[0]), float(self.high[1]), scale, _LEFT_PX, _HEAD_PX)
        self.width = _LEFT_PX + self.size[0] + _LEGEND_PX
        self.height = _HEAD_PX + self.size[1] + _FOOT_PX
        self.page = Page(self.width, self.height, picture.title)

    def render(self) -> bytes:
        """Return all of it as SVG."""
        self.page.rectangle((0, 0), (self.width, self.height), fill="#ffffff")
        with self._style():
            self._scenery(is_still=False)
            self.marks(self.picture.drawings)
            self._starts()
            self._paths()
            self._odometry_paths()
            self._times()
            self._ends()
            self._contacts()
            self._scale_bar()
            self._legend(is_still=False)
        return self.page.render()

    def scenery(self) -> Page:
        """Return the static parts: the ground, fixed objects, the legend."""
        with self._style():
            self._scenery(is_still=True)
            self._starts()
            self._scale_bar()
            self._legend(is_still=True)
        return self.page

    @contextmanager
    def layer(self) -> Iterator[Page]:
        """Start a page of the same size for a part of the picture; it is drawn on until the end."""
        self.page = Page(self.width, self.height, "")
        with self._style():
            yield self.page

    def path(self, number: int, points_m: FloatArray, width_px: float = 1.5) -> None:
        """Draw a piece of a robot's path."""
        points = [self.view.point(*place) for place in points_m.tolist()]
        self.page.polyline(points, stroke=colour(number), stroke_width=width_px)

    def robot(self, number: int, place_m: tuple[float, float], heading_rad: float) -> None:
        """Draw a robot."""
        radius_px = self._radius_px(self.picture.paths[number])
        self._robot(self.view.point(*place_m), radius_px, heading_rad, colour(number))

    def movable(self) -> list[WorldObject]:
        """Return the objects that can be moved, at their start."""
        solids = self.picture.world.solids()
        return [each for each in solids if not isinstance(each, Wall) and is_pushable(each)]

    def standing(self, obj: WorldObject) -> None:
        """Draw an object that can be moved."""
        self._standing(obj)

    def contact(self, x_m: float, y_m: float) -> None:
        """Mark a contact."""
        self._cross(self.view.point(x_m, y_m))

    def clock(self, text: str) -> None:
        """Write the time above the picture."""
        place = (_LEFT_PX + self.size[0], _HEAD_PX - 8)
        self.page.text(place, text, text_anchor="end", font_size=14.0)

    def _style(self) -> AbstractContextManager[None]:
        return self.page.group(font_family=_FONT, font_size=12.0, fill=_INK)

    def _scenery(self, *, is_still: bool) -> None:
        self._heading()
        self._grid()
        draw_terrain(self.page, self.view, self.picture.world.surface)
        draw_places(self.page, self.view, self.picture.world)
        draw_sights(self.page, self.view, self.picture.sights)
        self._solids(is_still=is_still)
        draw_beacons(self.page, self.view, self.picture.world)
        if self.picture.world.goals:
            draw_goals(self.page, self.view, self.picture.world)

    def _heading(self) -> None:
        title = self.picture.title
        self.page.text((_LEFT_PX, 28), title, font_size=18.0, font_weight="bold")
        self.page.text((_LEFT_PX, 48), self.picture.subtitle, fill=_FAINT_INK)

    # The ground

    def _grid(self) -> None:
        left, top = _LEFT_PX, _HEAD_PX
        width, height = self.size
        self.page.rectangle((left, top), (width, height), fill=PAPER, stroke="#d5d8de")
        step = round_length(float((self.high - self.low).max()) / 10)
        with self.page.group(stroke="#e7e8eb", fill="none"):
            for x_m in _multiples(self.low[0], self.high[0], step):
                x_px, _ = self.view.point(x_m, 0.0)
                self.page.line((x_px, top), (x_px, top + height))
            for y_m in _multiples(self.low[1], self.high[1], step):
                _, y_px = self.view.point(0.0, y_m)
                self.page.line((left, y_px), (left + width, y_px))
        with self.page.group(font_size=10.0, fill=_FAINT_INK, text_anchor="middle"):
            for x_m in _multiples(self.low[0], self.high[0], step):
                self.page.text((self.view.point(x_m, 0.0)[0], top + height + 14), f"{x_m:g}")
            for y_m in _multiples(self.low[1], self.high[1], step):
                y_px = self.view.point(0.0, y_m)[1] + 3.5
                self.page.text((left - 6, y_px), f"{y_m:g}", text_anchor="end")
            self.page.text((left + width / 2, top + height + 30), "x [m]")
            self.page.text((left - 6, top - 8), "y [m]", text_anchor="end")

    def _scale_bar(self) -> None:
        length_m = round_length(float(self.high[0] - self.low[0]) / 6)
        end = (_LEFT_PX + self.size[0], _HEAD_PX + self.size[1] + 30)
        start = (end[0] - self.view.length(length_m), end[1])
        with self.page.group(stroke=_INK, stroke_width=1.5):
            self.page.line(start, end)
            for x_px, y_px in (start, end):
                self.page.line((x_px, y_px - 4), (x_px, y_px + 4))
        place = (start[0] - 8, end[1] + 4)
        self.page.text(place, f"{length_m:g} m", font_size=11.0, text_anchor="end")

    def _solids(self, *, is_still: bool) -> None:
        """Draw walls and objects, with what can be moved or without."""
        pushed = {obj.id for obj in self.picture.pushed}
        solids = self.picture.world.solids()
        if is_still:
            solids = tuple(each for each in solids if each not in self.movable())
        walls = [solid for solid in solids if isinstance(solid, Wall)]
        for wall in walls:  # outlines first, so that there are none where two walls meet
            if wall.material != PLAIN:
                self._wall(wall, _INK, 2 * _OUTLINE_PX)
        for wall in walls:
            self._wall(wall, _paint(wall, _WALL), 0.0)
        for solid in solids:
            if isinstance(solid, Wall):
                continue
            if solid.id in pushed:
                with self.page.group(fill="none", stroke=_FAINT_INK, stroke_dasharray="3 3"):
                    self._obj(solid)
            else:
                self._standing(solid)
        for obj in () if is_still else self.picture.pushed:
            self._standing(obj)

    def _standing(self, obj: WorldObject) -> None:
        paint = _paint(obj, _MOVABLE if is_pushable(obj) else _FIXED)
        with self.page.group(fill=paint, stroke=_INK, stroke_width=_OUTLINE_PX):
            self._obj(obj)

    def _obj(self, obj: WorldObject) -> None:
        if isinstance(obj, Cylinder):
            centre = self.view.point(obj.pose.x_m, obj.pose.y_m)
            self.page.circle(centre, self.view.length(obj.radius_m))
        else:
            corners = [self.view.point(*corner) for corner in corners_m(obj).tolist()]
            self.page.polygon(corners, stroke_linejoin="round")

    def _wall(self, wall: Wall, paint: str, wider_px: float) -> None:
        ends = self.view.point(wall.x1_m, wall.y1_m), self.view.point(wall.x2_m, wall.y2_m)
        width_px = max(1.5, self.view.length(wall.thickness_m))
        self.page.line(
            *ends, stroke=paint, stroke_width=width_px + wider_px, stroke_linecap="round"
        )

    def marks(self, drawings: Sequence[Drawing]) -> None:
        """Draw the marks of the programs."""
        if not drawings:
            return
        style: dict[str, str | float] = {"fill": "none", "stroke_width": 1.2}
        with self.page.clipped((_LEFT_PX, _HEAD_PX), self.size), self.page.group(**style):
            for drawing in drawings:
                for stroke in _strokes_m(self.picture, drawing):
                    points = [self.view.point(*place) for place in stroke.tolist()]
                    self.page.polyline(points, stroke=HEX[drawing.colour])

    # The robots

    def _paths(self) -> None:
        paths = self.picture.paths
        style = {"stroke_width": 2.0 if len(paths) <= 20 else 1.0, "stroke_opacity": 0.85}
        with self.page.group(fill="none", stroke_linejoin="round", stroke_linecap="round", **style):
            for number, track in self._present():
                path = simplified(track.path, _TOLERANCE_PX / self.view.scale)
                points = [self.view.point(*place) for place in path.tolist()]
                self.page.polyline(points, stroke=colour(number))

    def _odometry_paths(self) -> None:
        """Draw the paths by odometry where they visibly differ from the true ones."""
        style: dict[str, str | float] = {"stroke_width": 1.2, "stroke_dasharray": "4 3"}
        with self.page.group(fill="none", stroke_opacity=0.9, **style):
            for number, track in self.visibly_drifted():
                path = simplified(track.odometry, _TOLERANCE_PX / self.view.scale)
                points = [self.view.point(*place) for place in path.tolist()]
                self.page.polyline(points, stroke=colour(number))

    def visibly_drifted(self) -> list[tuple[int, RobotPath]]:
        """Return the robots whose odometry visibly differs from their path, with their numbers."""
        least_m = _DIFFERS_PX / self.view.scale
        return [
            (number, track)
            for number, track in self._present()
            if len(track.odometry) and track.odometry_error_m > least_m
        ]

    def _times(self) -> None:
        """Mark where the robots were at round times."""
        with self.page.group(font_size=9.0, fill=_FAINT_INK):
            for _, track in self._present():
                for x_m, y_m, text in track.marks:
                    x_px, y_px = self.view.point(x_m, y_m)
                    self.page.circle((x_px, y_px), 2.0, fill=_INK)
                    self.page.text((x_px + 4, y_px - 4), text)

    def _starts(self) -> None:
        for number, track in self._present():
            place = self.view.point(*track.path[0].tolist())
            heading_rad = track.robot.start.heading_rad
            self._hollow(place, self._radius_px(track), heading_rad, colour(number))

    def _ends(self) -> None:
        for number, track in self._present():
            place = self.view.point(*track.path[-1].tolist())
            draw = self._hollow if track.left else self._robot
            draw(place, self._radius_px(track), track.heading_rad, colour(number))
            gripper = track.robot.model.device("gripper")
            if gripper is not None and not track.left:
                x_m, y_m = track.path[-1].tolist()
                at = (x_m, y_m, track.heading_rad)
                draw_fingers(self.page, self.view, gripper, at, colour(number))

    def _present(self) -> list[tuple[int, RobotPath]]:
        """Return the robots that have been in the world, with their numbers."""
        return [(n, track) for n, track in enumerate(self.picture.paths) if len(track.path)]

    def _radius_px(self, track: RobotPath) -> float:
        return max(3.0, self.view.length(track.robot.model.radius_m))

    def _hollow(self, centre: Point, radius_px: float, heading_rad: float, paint: str) -> None:
        style: dict[str, str | float] = {"stroke": paint, "stroke_width": 1.6}
        self.page.circle(centre, radius_px, fill="#ffffff", fill_opacity=0.6, **style)
        self.page.line(centre, _ahead(centre, radius_px, heading_rad), **style)

    def _robot(self, centre: Point, radius_px: float, heading_rad: float, paint: str) -> None:
        self.page.circle(centre, radius_px, fill=paint, stroke="#ffffff", stroke_width=1.0)
        angles = (heading_rad, heading_rad + 2.5, heading_rad - 2.5)
        arrow = [_ahead(centre, 0.72 * radius_px, angle) for angle in angles]
        self.page.polygon(arrow, fill="#ffffff")

    def _contacts(self) -> None:
        with self.page.group(stroke_linecap="round"):
            for _, x_m, y_m in self.picture.contacts:
                self._cross(self.view.point(x_m, y_m))

    def _cross(self, centre: Point) -> None:
        x_px, y_px = centre
        for paint, width_px in (("#ffffff", 4.0), (_CONTACT, 2.0)):
            for slope in (1, -1):
                start = (x_px - _LARGEST_MARK_PX, y_px - slope * _LARGEST_MARK_PX)
                end = (x_px + _LARGEST_MARK_PX, y_px + slope * _LARGEST_MARK_PX)
                self.page.line(start, end, stroke=paint, stroke_width=width_px)

    # The legend

    def _legend(self, *, is_still: bool) -> None:
        left = _LEFT_PX + self.size[0] + 24
        rows = int((self.size[1] - 4 * _ROW_PX) // _ROW_PX)
        paths = self.picture.paths
        shown = len(paths) if len(paths) <= rows else rows - 1
        y_px = _HEAD_PX + 10
        for number, track in enumerate(paths[:shown]):
            self._robot((left, y_px), 7.0, 0.0, colour(number))
            self.page.text((left + 16, y_px + 4), shortened(track.robot.id))
            y_px += _ROW_PX
        if shown < len(paths):
            text = f"... and {len(paths) - shown} more"
            self.page.text((left + 16, y_px + 4), text, fill=_FAINT_INK)
            y_px += _ROW_PX
        self._symbols(left, y_px + 10, is_still=is_still)

    def _symbols(self, left: float, y_px: float, *, is_still: bool) -> None:
        self._hollow((left, y_px), 7.0, 0.0, _FAINT_INK)
        self.page.text((left + 16, y_px + 4), "start", fill=_FAINT_INK)
        y_px += _ROW_PX
        if not is_still:
            self._robot((left, y_px), 7.0, 0.0, _FAINT_INK)
            self.page.text((left + 16, y_px + 4), "end", fill=_FAINT_INK)
            y_px += _ROW_PX
        if self.picture.contacts:
            self._cross((left, y_px))
            self.page.text((left + 16, y_px + 4), "contact", fill=_FAINT_INK)
            y_px += _ROW_PX
        if self.visibly_drifted():
            dashes: dict[str, str | float] = {"stroke": _FAINT_INK, "stroke_dasharray": "4 3"}
            self.page.line((left - 7, y_px), (left + 7, y_px), **dashes)
            self.page.text((left + 16, y_px + 4), "by odometry", fill=_FAINT_INK)


def _paint(solid: Solid, plain: str) -> str:
    """Return the colour of a solid's material, or `plain` if it has none."""
    if solid.material.colour == PLAIN.colour:
        return plain
    return hexadecimal(solid.material.colour)


def shortened(name: str, length: int = 20) -> str:
    """Return a name shortened to fit the legend."""
    return name if len(name) <= length else name[: length - 3] + "..."


def _ahead(centre: Point, distance_px: float, heading_rad: float) -> Point:
    x_px, y_px = centre
    return (
        x_px + distance_px * math.cos(heading_rad),
        y_px - distance_px * math.sin(heading_rad),
    )


def _multiples(low: float, high: float, step: float) -> Iterator[float]:
    for count in range(math.ceil(low / step), math.floor(high / step) + 1):
        yield count * step


def _bounds(picture: Picture) -> tuple[FloatArray, FloatArray]:
    """Return the lower left and upper right corner [m] of the plot, with a margin.

    An open world is cropped to what happened in it; a closed one is shown whole.
    """
    clouds = []
    for track in (track for track in picture.paths if len(track.path)):
        clouds += [
            track.path - track.robot.model.radius_m,
            track.path + track.robot.model.radius_m,
        ]
    clouds += [_drawn(picture, drawing) for drawing in picture.drawings]
    clouds += terrain_corners_m(picture.world.surface)
    clouds += [_outline(solid) for solid in (*picture.world.solids(), *picture.pushed)]
    clouds += [np.array([[light.x_m, light.y_m]]) for light in picture.world.lights]
    clouds += [np.array([[sound.x_m, sound.y_m]]) for sound in picture.world.sounds]
    clouds += [*map(_extent, picture.world.sources), *map(_extent, picture.world.nests)]
    if not clouds:
        area = picture.world.area
        clouds = [np.array([[area.x_min_m, area.y_min_m], [area.x_max_m, area.y_max_m]])]
    low = np.min([cloud.min(axis=0) for cloud in clouds], axis=0)
    high = np.max([cloud.max(axis=0) for cloud in clouds], axis=0)
    rim = 0.03 * float((high - low).max()) + 0.05
    return low - rim, high + rim


def _extent(place: Source | Nest) -> FloatArray:
    """Return two opposite corners [m] of the square around a place."""
    reach = np.array([[-place.radius_m], [place.radius_m]])
    return np.asarray(np.array([[place.x_m, place.y_m]]) + reach)


def _strokes_m(picture: Picture, drawing: Drawing) -> list[FloatArray]:
    return drawing.strokes_m(picture.paths[drawing.robot].robot.model.radius_m)


def _drawn(picture: Picture, drawing: Drawing) -> FloatArray:
    """Return the points of a drawing, clamped to the world's area."""
    area = picture.world.area
    low, high = (area.x_min_m, area.y_min_m), (area.x_max_m, area.y_max_m)
    return np.clip(np.concatenate(_strokes_m(picture, drawing)), low, high)


def _outline(solid: Solid) -> FloatArray:
    if isinstance(solid, Wall):
        ends = np.array([[solid.x1_m, solid.y1_m], [solid.x2_m, solid.y2_m]])
        return np.vstack([ends - solid.thickness_m / 2, ends + solid.thickness_m / 2])
    if isinstance(solid, Cylinder):
        centre = np.array([[solid.pose.x_m, solid.pose.y_m]])
        return np.vstack([centre - solid.radius_m, centre + solid.radius_m])
    return corners_m(solid)
