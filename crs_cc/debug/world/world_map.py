"""A map of the world in characters: objects, robots, paths, and one robot's echoes.

x goes to the right and y goes up, as in the world file, at the same scale. Walls are drawn in the
default colour, objects in theirs, each robot in its own with its heading: an arrow,
or if there is room its outline. The minimum size is 10 by 4 cells.

>>> from crs_cc.sim.engine.environment import Environment
>>> from crs_cc.sim.files.world_xml import parse_world
>>> environment = Environment(parse_world(b'''<world version="1"><area length="4m" width="4m"/>
...   <robot x="1m" y="2m"/></world>''', "room"), seed=1)
>>> for row in WorldMap(environment, MapWindow.whole(environment, 11, 6)).pieces:
...     print("".join(text for text, _ in row).rstrip())
⡖⠒⠒⠒⠒⠒⠒⠒⠒⠒⢲
⡇         ⢸
⡇ ⣀→      ⢸
⡇ ⠈⠃      ⢸
⡇╶─╴ 1 m  ⢸
⠧⠤⠤⠤⠤⠤⠤⠤⠤⠤⠼
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product
from typing import TYPE_CHECKING, Final, Self

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray
from crs_cc.core.quantity import round_length
from crs_cc.debug.world.canvas import ACROSS, DOWN, Canvas, Pieces
from crs_cc.sim.engine.robot_colours import colour
from crs_cc.sim.engine.sensor_overlay import sights
from crs_cc.sim.geometry.scene import Outlines
from crs_cc.sim.model.colours import hexadecimal
from crs_cc.sim.model.world import PLAIN, Robot, Solid, Wall, is_pushable

if TYPE_CHECKING:
    from rich.text import Text

    from crs_cc.sim.engine.environment import Environment


_ARROWS: Final = "→↗↑↖←↙↓↘"
_WALL: Final = ""
_FIXED: Final = "#8d95a3"
_MOVABLE: Final = "#d9b88a"
_SOUND: Final = "#56b4e9"
_CONTACT: Final = "bold #d1242f"
_SCALE: Final = "dim"
_LAMP: Final = "bold #e6b800"
_BEAMS, _PATHS, _THINGS, _WALLS, _MARKS, _SHELLS, _ROBOTS = range(7)  # ranks
_OUTLINED: Final = 4.0  # dots: from this radius on a robot is drawn with its outline
_ROUNDED_M: Final = 0.5  # an open world's view does not move with each step


@dataclass(frozen=True, slots=True)
class MapWindow:
    """The visible part of the world, and its size in cells.

    Attributes:
        x_m: the x coordinate of the centre.
        y_m: the y coordinate of the centre.
        scale: dots per metre.
        columns: the width [cells].
        rows: the height [cells].
    """

    x_m: float
    y_m: float
    scale: float
    columns: int
    rows: int

    @classmethod
    def whole(
        cls, environment: Environment, columns: int, rows: int, paths: Sequence[FloatArray] = ()
    ) -> Self:
        """Return a window on a whole world; for an open one, on all objects in it.

        Args:
            environment: the world.
            columns: the width [cells], at least 1.
            rows: the height [cells], at least 1.
            paths: paths to include.
        """
        low, high = _bounds(environment, paths)
        sides = np.maximum(high - low, 2 * _ROUNDED_M)
        scale = min((ACROSS * columns - 1) / sides[0], (DOWN * rows - 1) / sides[1])
        x_m, y_m = ((low + high) / 2).tolist()
        return cls(x_m, y_m, float(scale), columns, rows)

    @classmethod
    def around(
        cls, environment: Environment, robot: int, columns: int, rows: int, across_m: float = 6.0
    ) -> Self:
        """Return a window of a given size around a robot."""
        state = environment.state
        scale = min(ACROSS * columns, DOWN * rows) / across_m
        return cls(float(state.x_m[robot]), float(state.y_m[robot]), scale, columns, rows)

    def dots(self, places_m: FloatArray) -> FloatArray:
        """Return the canvas coordinates of positions in the world, (n, 2) each."""
        x = (places_m[:, 0] - self.x_m) * self.scale + ACROSS * self.columns / 2
        y = (self.y_m - places_m[:, 1]) * self.scale + DOWN * self.rows / 2
        return np.column_stack([x, y])

    def cell(self, x_m: float, y_m: float) -> tuple[int, int]:
        """Return column and row of the cell of a position, maybe outside."""
        ((x, y),) = self.dots(np.array([[x_m, y_m]])).tolist()
        return math.floor(x / ACROSS), math.floor(y / DOWN)

    def place(self, column: int, row: int) -> tuple[float, float]:
        """Return the position in the world [m] of the centre of a cell."""
        x = (column + 0.5) * ACROSS - ACROSS * self.columns / 2
        y = (row + 0.5) * DOWN - DOWN * self.rows / 2
        return self.x_m + x / self.scale, self.y_m - y / self.scale


class WorldMap:
    """A map of the current state of a world.

    Attributes:
        view: the visible part.
    """

    def __init__(
        self,
        environment: Environment,
        view: MapWindow,
        *,
        robot: int = -1,
        paths: Sequence[FloatArray] = (),
        contacts: Sequence[tuple[int, float, float]] = (),
    ) -> None:
        """Draw a world.

        Args:
            environment: the world.
            view: the visible part.
            robot: the robot whose sensors' echoes are drawn, -1 for none.
            paths: the path of each robot [m], (n, 2) each, separated by rows of NaN; as many as are
                known.
            contacts: number of the robot and position [m] of contacts.
        """
        self.view = view
        self._environment = environment
        self._canvas = Canvas(view.columns, view.rows)
        if robot >= 0:
            self._beams(robot)
        for number, path in enumerate(paths):
            self._path(number, path)
        for outlines in environment.outlines():
            self._things(outlines)
        self._lamps()
        for _, x_m, y_m in contacts:
            self._canvas.put(*view.cell(x_m, y_m), "✗", _CONTACT, _MARKS)
        self._robots(np.flatnonzero(environment.state.presence.present))
        self._scale_bar()

    @property
    def pieces(self) -> Pieces:
        """The map, row by row, as texts and their styles."""
        return self._canvas.pieces()

    @property
    def text(self) -> Text:
        """The map as rich text, a line for each row."""
        from rich.text import Text

        rows = [Text.assemble(*row, no_wrap=True) for row in self.pieces]
        return Text("\n").join(rows)

    def _beams(self, robot: int) -> None:
        """Draw the axis of each beam with an echo, and the echo's source."""
        environment = self._environment
        for beam in sights(environment.state, environment.world, environment.time_s, robot):
            dots = self.view.dots(beam.outline)
            middle = dots[len(dots) // 2] if len(dots) > 2 else dots[1]
            self._canvas.lines(
                np.concatenate([dots[0], middle])[None], beam.colour or _SOUND, _BEAMS, gap=3
            )
            if len(dots) > 2:
                self._line(dots[1:], _SOUND, _BEAMS)

    def _path(self, number: int, path_m: FloatArray) -> None:
        if len(path_m):
            self._line(self.view.dots(path_m), colour(number), _PATHS)

    def _line(self, dots: FloatArray, style: str, rank: int) -> None:
        lines = np.concatenate([dots[:-1], dots[1:]], axis=1)
        self._canvas.lines(lines[np.isfinite(lines).all(axis=1)], style, rank)

    def _things(self, outlines: Outlines) -> None:
        """Draw objects with outlines, except robots; walls are filled."""
        objects, robots = self._environment.objects, len(self._environment.world.robots)
        is_wall = np.array([isinstance(obj, Wall) for obj in objects], np.bool_)
        starts, ends = (self.view.dots(outlines.segments[:, 2 * n : 2 * n + 2]) for n in (0, 1))
        lines, owners = np.concatenate([starts, ends], axis=1), outlines.segment_owners
        walls, others = np.flatnonzero(is_wall[owners]), np.flatnonzero(~is_wall[owners])
        fill, wall = _filled(lines[walls])
        self._canvas.lines(fill, self._styles(owners[walls][2 * wall]), _WALLS)
        self._canvas.lines(lines[others], self._styles(owners[others]), _THINGS)
        # The round ends of walls are neglected.
        round_ = np.flatnonzero((outlines.owners >= robots) & ~is_wall[outlines.owners])
        radii = outlines.circles[round_, 2:] * self.view.scale
        circles = np.column_stack([self.view.dots(outlines.circles[round_]), radii])
        self._canvas.circles(circles, self._styles(outlines.owners[round_]), _THINGS)

    def _styles(self, owners: IndexArray) -> list[str]:
        objects = self._environment.objects
        return [_style(objects[owner]) for owner in owners.tolist()]

    def _lamps(self) -> None:
        for sign, x_m, y_m in _sources(self._environment):
            self._canvas.put(*self.view.cell(x_m, y_m), sign, _LAMP, _MARKS)

    def _robots(self, numbers: IndexArray) -> None:
        """Draw robots with their headings, and their numbers if there are several."""
        state, robots = self._environment.state, self._environment.world.robots
        styles = [f"bold {colour(number)}" for number in numbers.tolist()]
        middles = self.view.dots(np.column_stack([state.x_m, state.y_m])[numbers])
        radii = np.array([robots[number].model.radius_m for number in numbers.tolist()])
        radii, headings_rad = radii * self.view.scale, state.heading_rad[numbers]
        self._canvas.circles(np.column_stack([middles, radii]), styles, _SHELLS)
        ahead = np.column_stack([np.cos(headings_rad), -np.sin(headings_rad)]) * radii[:, None]
        large = np.flatnonzero(radii >= _OUTLINED)
        lines = np.concatenate([middles, middles + ahead], axis=1)[large]
        self._canvas.lines(lines, [styles[each] for each in large.tolist()], _SHELLS)
        cells = np.floor(middles / (ACROSS, DOWN)).astype(np.intp).tolist()
        rows = zip(
            numbers.tolist(), cells, radii.tolist(), headings_rad.tolist(), styles, strict=True
        )
        for number, (column, row), radius, heading_rad, style in rows:
            beside = column + math.ceil(radius / ACROSS)
            if radius < _OUTLINED:
                arrow = _ARROWS[round(heading_rad / (math.pi / 4)) % len(_ARROWS)]
                self._canvas.put(column, row, arrow, style, _ROBOTS)
                beside += 1
            if len(robots) > 1:
                self._canvas.put(beside, row, str(number), style, _MARKS)

    def _scale_bar(self) -> None:
        """Draw a scale bar, as far down as there is room, left or right."""
        view = self.view
        length_m = round_length(view.columns * ACROSS / view.scale / 4)
        cells = max(1, round(length_m * view.scale / ACROSS))
        bar = f"╶{'─' * (cells - 2)}╴" if cells > 1 else "─"
        text = f"{bar} {length_m:g} m"
        places = product(range(view.rows - 1, -1, -1), (1, 0, view.columns - len(text) - 1))
        free = (place for place in places if self._canvas.is_free(place[1], place[0], len(text)))
        row, column = next(free, (-1, 0))
        self._canvas.put(column, row, text, _SCALE, _MARKS)


def _style(obj: Robot | Solid) -> str:
    """Return the style of an object: that of its material, if it has a colour."""
    if obj.material.colour != PLAIN.colour:
        return hexadecimal(obj.material.colour)
    if isinstance(obj, Wall):
        return _WALL
    return _MOVABLE if not isinstance(obj, Robot) and is_pushable(obj) else _FIXED


def _filled(sides: FloatArray) -> tuple[FloatArray, IndexArray]:
    """Return lines that fill walls, whose two sides follow each other, in dots.

    Returns:
        the lines, (n, 4), and which wall each is of, (n,).
    """
    there, back = sides[0::2], sides[1::2][:, [2, 3, 0, 1]]
    apart = np.hypot(*(back[:, :2] - there[:, :2]).T)
    counts = np.maximum(np.ceil(apart), 1.0).astype(np.intp)
    wall = np.repeat(np.arange(len(there)), counts)
    number = np.arange(len(wall)) - (np.cumsum(counts) - counts)[wall]
    share = ((number + 0.5) / counts[wall])[:, None]
    return np.asarray(there[wall] + share * (back[wall] - there[wall])), wall


def _sources(environment: Environment) -> list[tuple[str, float, float]]:
    """Return a symbol and the position [m] of each light, sound, source of items, and nest."""
    world = environment.world
    lights = [("☼", light.x_m, light.y_m) for light in world.lights]
    sounds = [("♪", sound.x_m, sound.y_m) for sound in world.sounds]
    items = [("$", place.x_m, place.y_m) for place in world.sources]
    return [*lights, *sounds, *items, *(("⌂", nest.x_m, nest.y_m) for nest in world.nests)]


def _bounds(environment: Environment, paths: Sequence[FloatArray]) -> tuple[FloatArray, FloatArray]:
    """Return the lower left and upper right corner [m] of all objects."""
    clouds = [path for path in paths if len(path)]
    for outlines in environment.outlines():
        places, radii = outlines.circles[:, :2], outlines.circles[:, 2:]
        segments = outlines.segments
        clouds += [segments[:, :2], segments[:, 2:4], places - radii, places + radii]
    clouds += [np.array([[x_m, y_m]]) for _, x_m, y_m in _sources(environment)]
    area, points = environment.world.area, np.concatenate(clouds)
    points = points[np.isfinite(points).all(axis=1)]
    if not len(points):
        points = np.array([[area.x_min_m, area.y_min_m], [area.x_max_m, area.y_max_m]])
    low, high = points.min(axis=0), points.max(axis=0)
    if area.edge_m > 0.0:
        return low, high
    return np.floor(low / _ROUNDED_M) * _ROUNDED_M, np.ceil(high / _ROUNDED_M) * _ROUNDED_M
