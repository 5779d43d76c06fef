"""The floor of a world in cells, for goals that require a share of it to be covered.

>>> from crs_cc.sim.model.world import Area, Box, Pose, WorldModel
>>> desk = Box("desk", Pose(0.5, 0.5), 1.0, 1.0)
>>> floor = Floor(WorldModel("w", Area(0.0, 0.0, 2.0, 1.0), boxes=(desk,)))
>>> floor.free(0.5).tolist()
[False, False, True, True, False, False, True, True]
>>> covered = np.zeros(8, np.bool_)
>>> floor.cover(0.5, covered, np.array([1.5]), np.array([0.25]), np.array([0.3]))
>>> covered.nonzero()[0].tolist()
[2, 3]
"""

from __future__ import annotations

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.geometry.shape_table import ShapeTable
from crs_cc.sim.model.goals import cells_of
from crs_cc.sim.model.world import WorldModel


class Floor:
    """The cells of a world's area, row by row from its lower left corner."""

    def __init__(self, world: WorldModel) -> None:
        """Prepare the floor of a world; fixed objects that programs add or remove do not count."""
        self._world = world
        self._free: dict[float, BoolArray] = {}

    def free(self, cell_m: float) -> BoolArray:
        """Return which cells have a centre in the area, and not inside of a fixed object."""
        if cell_m not in self._free:
            self._free[cell_m] = self._find_free(cell_m)
        return self._free[cell_m]

    def centres_m(self, cell_m: float) -> tuple[FloatArray, FloatArray]:
        """Return the x and y of the centres of all cells."""
        columns, rows = self._size(cell_m)
        x_m, y_m = np.meshgrid(*self._centres_m(cell_m, np.arange(columns), np.arange(rows)))
        return x_m.ravel(), y_m.ravel()

    def cover(
        self,
        cell_m: float,
        covered: BoolArray,
        x_m: FloatArray,
        y_m: FloatArray,
        radii_m: FloatArray,
    ) -> None:
        """Mark the cells whose centres are under robots.

        Args:
            cell_m: the size of a cell.
            covered: the marks of the cells, changed in place.
            x_m: the robots' positions.
            y_m: the robots' positions.
            radii_m: their radii.
        """
        columns, _ = self._size(cell_m)
        robots = zip(x_m.tolist(), y_m.tolist(), radii_m.tolist(), strict=True)
        for x, y, radius in robots:
            column, row = self._window(cell_m, x, y, radius)
            centre_x_m, centre_y_m = self._centres_m(cell_m, column, row)
            from_x_m, from_y_m = centre_x_m[None, :] - x, centre_y_m[:, None] - y
            near = from_x_m * from_x_m + from_y_m * from_y_m <= radius * radius
            covered[(row[:, None] * columns + column)[near]] = True

    def _find_free(self, cell_m: float) -> BoolArray:
        columns, rows = self._size(cell_m)
        x_m, y_m = self._centres_m(cell_m, np.arange(columns), np.arange(rows))
        in_area = (y_m <= self._world.area.y_max_m)[:, None] & (x_m <= self._world.area.x_max_m)
        free = np.asarray(in_area)
        scene = Scene(self._world)
        shapes = ShapeTable.of(scene)
        first = len(scene.objects) - len(scene.fixed_solids)
        poses = np.concatenate([np.zeros((first, 3)), shapes.fixed])
        for number in range(first, len(scene.objects)):
            thing_x_m, thing_y_m, _ = poses[number].tolist()
            window = self._window(cell_m, thing_x_m, thing_y_m, float(shapes.reach_m[number]))
            column, row = (each.ravel() for each in np.meshgrid(*window))
            left = free[row, column]  # walls around cross the same cells
            column, row = column[left], row[left]
            at_x_m, at_y_m = self._centres_m(cell_m, column, row)
            objects = np.full(len(column), number)
            inside = shapes.distance_m(poses, objects, at_x_m, at_y_m) <= 0.0
            free[row[inside], column[inside]] = False
        return free.ravel()

    def _size(self, cell_m: float) -> tuple[int, int]:
        return cells_of(cell_m, self._world.area.length_m, self._world.area.width_m)

    def _window(
        self, cell_m: float, x_m: float, y_m: float, reach_m: float
    ) -> tuple[IndexArray, IndexArray]:
        """Return the columns and rows that may have a centre within a distance of a point."""
        area, size = self._world.area, self._size(cell_m)
        found = []
        for at_m, low_m, most in zip((x_m, y_m), (area.x_min_m, area.y_min_m), size, strict=True):
            low = np.clip((at_m - low_m - reach_m) / cell_m - 1, 0, most)
            high = np.clip((at_m - low_m + reach_m) / cell_m + 1, 0, most)
            found.append(np.arange(int(low), int(high)))
        return found[0], found[1]

    def _centres_m(
        self, cell_m: float, column: IndexArray, row: IndexArray
    ) -> tuple[FloatArray, FloatArray]:
        """Return the x of the centres of columns of cells, and the y of those of rows."""
        area = self._world.area
        x_m = np.asarray(area.x_min_m + (column + 0.5) * cell_m, np.float64)
        y_m = np.asarray(area.y_min_m + (row + 0.5) * cell_m, np.float64)
        return x_m, y_m
