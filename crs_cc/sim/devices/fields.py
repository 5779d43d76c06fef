"""Pheromone fields: amounts on the floor that robots deposit and smell.

    amount = sum over deposits of deposit * exp(-time since the deposit / evaporation)

in each cell, at most the saturation. Time is counted in whole timesteps: deposits are added at the
end of theirs, all at once, and what is smelled is what was there at the start of the timestep, so
it depends neither on the order of robots nor on that of their requests. Then the field diffuses, by
the explicit scheme for Fick's second law: from each cell

    diffusion * timestep / cell^2 * difference

flows to each of its four neighbours in the area, which is the scheme's limit of stability at 1/4.
Walls and objects have no effect. The models were chosen by us.

Amounts are kept as integers (`state.fields`), relative to a base time: the last multiple of four
evaporation times, rounded up to whole timesteps. Evaporation is computed when an amount is read;
only when the base changes, all integers are divided by the same factor, and tiles that hold nothing
any more are dropped.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int64Array, all_of
from crs_cc.core.suggest import unknown
from crs_cc.sim.devices import field_tiles
from crs_cc.sim.devices.mount import mount_poses
from crs_cc.sim.devices.name_lookup import look_up, numbers_of
from crs_cc.sim.geometry.field_grid import NOWHERE, SIDE, FieldGrid
from crs_cc.sim.kernels import exact
from crs_cc.sim.kernels.field_cells import Robots, Trails, antenna_cells, trail_cells
from crs_cc.sim.kernels.program import kernels
from crs_cc.sim.state.fields import UNIT
from crs_cc.sim.state.rows import simplest

if TYPE_CHECKING:
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState
    from crs_cc.sim.state.fields import FieldState

_REBASE: Final = 4.0  # evaporation times
_NEVER: Final = 2**53  # cycles


class Fields:
    """The pheromone fields of a world.

    Attributes:
        names: their names.
    """

    def __init__(self, world: WorldModel) -> None:
        self.names = tuple(field.name for field in world.fields)
        self._timestep_s = world.timestep_s
        self._saturation = np.array([field.saturation for field in world.fields])
        self._shares = [field.share(world.timestep_s) for field in world.fields]
        self._grid = FieldGrid(world.area, world.fields)

    def number(self, name: str) -> int:
        """Return the number of a field.

        Raises:
            ValueError: there is no field with this name.
        """
        if name not in self.names:
            raise ValueError(unknown("field", name, self.names))
        return self.names.index(name)

    def find(self, context: RequestContext) -> BoolArray:
        """Answer FIELD: the number of a field with a name, the name of one with a number."""
        return look_up(context, numbers_of(self.names), np.full(len(context), NOWHERE))

    def deposit(
        self,
        state: EnvState,
        field: IndexArray,
        place_m: FloatArray,
        amount: FloatArray,
    ) -> None:
        """Deposit amounts, which are smelled from the next timestep on.

        Args:
            state: changed in place.
            field: the field of each deposit, (k,).
            place_m: its place, nothing happens to those outside of the area, (k, 2).
            amount: the amount, 0 or more, (k,).
        """
        one = _common_field(field)
        cells = self._grid.cells(one, place_m[:, 0], place_m[:, 1])
        there = cells >= 0
        if not all_of(there):
            cells, amount = cells[there], amount[there]
            one = one if isinstance(one, int) else one[there]
        amount = np.minimum(amount, self._saturation[one])
        deposit = np.rint(amount / self._units(state.fields, state.cycle, 1)[one])
        self._put(state, cells, deposit.astype(np.int64))

    def lay(self, state: EnvState, trails: Trails) -> None:
        """Deposit what robots lay in a timestep, evenly along their paths.

        Args:
            state: changed in place.
            trails: what they lay.
        """
        units = self._units(state.fields, state.cycle, 1)
        measures = np.column_stack([self._saturation, units])
        self._put(state, *trail_cells(self._grid.table, measures, trails))

    def smell(
        self,
        state: EnvState,
        constants: RobotConstants,
        rows: IndexArray,
        ends_m: FloatArray,
        amounts: FloatArray,
    ) -> None:
        """Smell the amounts at the ends of antennae, 0 outside of the area.

        Args:
            state: has the fields.
            constants: the robots' constants.
            rows: the robots, k of them.
            ends_m: where their antennae end, see `kernels.field_cells`.
            amounts: set to the amounts of each field at each end, (fields, antennae, k).
        """
        if not self.names:
            return
        home = state.rows.resident_kernels(constants.kinds)
        robots: Robots = rows
        if home is None:
            robots = mount_poses(state, constants, rows)
        elif isinstance(simplest(rows, len(state.connected)), slice):
            robots = len(rows)
        tiles, places = antenna_cells(home or kernels(), self._grid.table, ends_m, robots)
        found = field_tiles.read(state.fields, self._grid, tiles, places)
        np.multiply(found, self._units(state.fields, state.cycle)[:, None, None], out=amounts)

    def end_cycle(self, state: EnvState) -> None:
        """Add the deposits of the cycle, let the fields diffuse, and rebase them."""
        if not self.names:
            return
        self._add(state)
        self._pass(state.fields, state.cycle)

    def skip(self, state: EnvState, cycles: int) -> None:
        """Execute cycles before the current one, in which nothing was deposited."""
        end, begin = state.cycle, state.cycle - cycles
        if any(self._shares):
            works = np.arange(begin, end)
        else:
            every = self._cycles(state.fields)
            first = begin + (-1 - begin) % every  # the first cycle at whose end there is a new base
            works = np.unique(np.concatenate([
                np.zeros(0, np.int64), *(map(np.arange, first, np.full_like(first, end), every)),
            ]))  # fmt: skip
        for cycle in works.tolist():
            if state.fields.used == 1:
                return
            self._pass(state.fields, cycle)

    def set_evaporation(self, state: EnvState, field: int, evaporation_s: float) -> None:
        """Set the evaporation time of a field from the start of the current cycle on."""
        before = self._units(state.fields, state.cycle)
        state.fields.evaporation_s[field] = evaporation_s
        after = self._units(state.fields, state.cycle)
        field_tiles.scale(state.fields, self._grid, field, float(before[field] / after[field]))

    def picture(self, state: EnvState, field: int) -> FloatArray:
        """Return all amounts of a field at the start of the current cycle, (rows, columns).

        The first row is the one with the smallest y.
        """
        fields, grid = state.fields, self._grid
        rows, columns = int(grid.rows[field]), int(grid.columns[field])
        up, across = -(-rows // SIDE), -(-columns // SIDE)
        blocks = np.zeros((up, across, SIDE, SIDE))
        slots = field_tiles.of(fields, grid, field)
        row, column = grid.place(field, fields.tile[slots])
        amounts = fields.amount[slots] * self._units(fields, state.cycle)[field]
        blocks[row // SIDE, column // SIDE] = amounts.reshape(-1, SIDE, SIDE)
        return blocks.swapaxes(1, 2).reshape(up * SIDE, across * SIDE)[:rows, :columns]

    def sketch(self, state: EnvState, field: int, most: int) -> tuple[FloatArray, float]:
        """Return a coarse picture of a field: the largest amounts in squares of cells.

        Only what is stored is looked at, however large the area is.

        Args:
            state: has the fields.
            field: the field.
            most: maximum number of squares along a side of the area.

        Returns:
            the amounts, (rows, columns), and the side of a square [m].
        """
        fields, grid = state.fields, self._grid
        rows, columns = int(grid.rows[field]), int(grid.columns[field])
        cells = -(-max(rows, columns) // most)
        found = np.zeros((-(-rows // cells), -(-columns // cells)))
        slots = field_tiles.of(fields, grid, field)
        amounts = fields.amount[slots].reshape(-1, SIDE, SIDE)
        tile, up, across = amounts.nonzero()
        row, column = grid.place(field, fields.tile[slots])
        place = (row[tile] + up) // cells, (column[tile] + across) // cells
        np.maximum.at(found, place, amounts[tile, up, across])
        unit = float(self._units(fields, state.cycle)[field])
        return found * unit, cells * float(grid.cell_m[field])

    def _put(self, state: EnvState, cells: Int64Array, deposit: Int64Array) -> None:
        """Keep integers to add to cells at the end of the cycle."""
        fields = state.fields
        if len(fields.deposit):
            cells = np.concatenate([fields.deposit_cell, cells])
            deposit = np.concatenate([fields.deposit, deposit])
        fields.deposit_cell, fields.deposit = cells, deposit

    def _add(self, state: EnvState) -> None:
        """Add the deposits of the cycle."""
        fields = state.fields
        if not len(fields.deposit):
            return
        cells, deposit = fields.deposit_cell, fields.deposit
        fields.deposit_cell, fields.deposit = cells[:0].copy(), deposit[:0].copy()
        most = np.rint(self._saturation / self._units(fields, state.cycle, 1)).astype(np.int64)
        field_tiles.add(fields, self._grid, cells, deposit, most[self._grid.field(cells)])

    def _pass(self, fields: FieldState, cycle: int) -> None:
        """Let the fields diffuse at the end of a cycle, and rebase those whose time has come."""
        for field, share in enumerate(self._shares):
            if share > 0.0:
                field_tiles.spread(fields, self._grid, field, share)
        cycles = self._cycles(fields)
        for field in np.flatnonzero((cycle + 1) % cycles == 0).tolist():
            passed_s = cycles[field] * self._timestep_s
            factor = exact.exp(-float(passed_s / fields.evaporation_s[field]))
            field_tiles.scale(fields, self._grid, field, factor)

    def _cycles(self, fields: FieldState) -> Int64Array:
        """Return the number of cycles between two bases of each field."""
        return np.array(
            [_cycles(each, self._timestep_s) for each in fields.evaporation_s.tolist()], np.int64
        )

    def _units(self, fields: FieldState, cycle: int, later: int = 0) -> FloatArray:
        """Return the amount of an integer 1 in each field at the start of a cycle, (fields,).

        Args:
            fields: the fields, which have the base of this cycle.
            cycle: the cycle.
            later: number of cycles from then on.
        """
        times_s, timestep_s = fields.evaporation_s.tolist(), self._timestep_s
        return np.array([
            _unit(cycle % _cycles(each_s, timestep_s) + later, timestep_s, each_s)
            for each_s in times_s
        ])  # fmt: skip


def _cycles(evaporation_s: float, timestep_s: float) -> int:
    """Return the number of cycles between two bases of a field."""
    cycles = _REBASE * evaporation_s / timestep_s
    return math.ceil(cycles) if cycles < _NEVER else _NEVER


@lru_cache(maxsize=64)  # gland, antennae and fields ask for the same within a timestep
def _unit(cycles: int, timestep_s: float, evaporation_s: float) -> float:
    """Return the amount of an integer 1 some cycles after the base time."""
    return UNIT * exact.exp(-(cycles * timestep_s / evaporation_s))


def _common_field(field: IndexArray) -> IndexArray | int:
    """Return the field that all deposits are in, or the fields: one takes less time."""
    first = int(field[0]) if len(field) else 0
    return first if (field == first).all() else field
