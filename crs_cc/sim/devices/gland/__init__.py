"""The gland, which deposits pheromone on the floor: at once, or as a trail.

`crs_deposit` deposits an amount in the cell under the robot's centre. `crs_lay_trail` makes the
robot deposit an amount per metre driven, evenly along the path of each timestep; a robot at rest
deposits nothing, and one that is carried elsewhere leaves no trail between. A robot lays one trail
at a time. `devices.fields` describes the fields.

Degradation (`gland`) applies to the amount, or the amount per metre; if it is dropped or negative
nothing is deposited. The model was chosen by us.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int64Array, all_of, any_of
from crs_cc.core.quantity import AMOUNT
from crs_cc.requests import device_request
from crs_cc.requests.request import fields
from crs_cc.robot_api.row import OURS, Function
from crs_cc.sim.devices.fields import Fields
from crs_cc.sim.devices.installed import Installed
from crs_cc.sim.devices.mount import mount_poses
from crs_cc.sim.kernels.field_cells import Trails
from crs_cc.sim.model.attribute import attribute
from crs_cc.sim.model.degradable import Degradable, elements_of
from crs_cc.sim.model.device import Device
from crs_cc.sim.model.robot import devices_of
from crs_cc.sim.state.rows import ALL, simplest, take

if TYPE_CHECKING:
    from collections.abc import Sequence

    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState
    from crs_cc.sim.state.events import EventLog


@dataclass(frozen=True, slots=True)
class Gland:
    """A gland."""

    most: float = attribute(
        "most", AMOUNT, "1000", "Maximum amount per deposit, and per metre of trail.",
        positive=True,
    )  # fmt: skip


@dataclass(slots=True)
class GlandState:
    """Glands; arrays have a row for each robot with one, n of them.

    Attributes:
        field: the field of its trail, (n,).
        per_m: the amount that it deposits per metre, 0 for no trail, (n,).
        from_m: the robot's position at the end of the last timestep, NaN before, (n, 2).
        distance_m: the distance that it had moved by then, (n,).
    """

    field: Int64Array
    per_m: FloatArray
    from_m: FloatArray
    distance_m: FloatArray

    @classmethod
    def at_start(cls, models: Sequence[Gland]) -> GlandState:
        """Return glands that lay no trail."""
        count = len(models)
        return cls(
            np.zeros(count, dtype=np.int64), np.zeros(count), np.full((count, 2), np.nan),
            np.zeros(count),
        )  # fmt: skip


class Glands:
    """The glands of all robots that have one."""

    def __init__(self, row: Device, world: WorldModel) -> None:
        self._name = row.name
        self._fields = Fields(world)
        self._cell_m = np.array([field.cell_m for field in world.fields])
        found = devices_of([robot.model for robot in world.robots], row.name)
        self._most = np.array([gland.most for gland in found if gland is not None])
        self._rows = np.array([row for row, gland in enumerate(found) if gland], dtype=np.intp)
        self._robots = simplest(self._rows, len(found))

    @property
    def any_installed(self) -> bool:
        """Whether any robot has one."""
        return len(self._most) > 0

    def deposit(self, context: RequestContext) -> BoolArray:
        """Answer DEPOSIT; refuse unknown fields and invalid amounts."""
        good, numbers = self._asked(context)
        rows, at_s, state = context.rows[good], context.at_s[good], context.state
        if len(rows):
            amount = np.minimum(context["amount"][good], self._most[numbers])
            amount = self._altered(state, context.constants, rows, amount, at_s)
            place_m = mount_poses(state, context.constants, rows)[:, :2]
            field = context["field"][good].astype(np.intp)
            self._fields.deposit(state, field, place_m, amount)
        return good

    def lay_trail(self, context: RequestContext) -> BoolArray:
        """Answer LAY_TRAIL; refuse unknown fields and invalid amounts."""
        good, numbers = self._asked(context)
        glands = context.state.device(self._name, GlandState)
        glands.field[numbers] = context["field"][good]
        glands.per_m[numbers] = np.minimum(context["amount"][good], self._most[numbers])
        return good

    def end_cycle(self, state: EnvState, constants: RobotConstants, at_s: float) -> None:
        """Deposit what robots laid in a cycle, whose bodies have moved.

        Args:
            state: changed in place.
            constants: the robots' constants.
            at_s: the last time in the cycle.
        """
        glands = state.device(self._name, GlandState)
        if not len(glands.field):
            return
        rows, robots = self._rows, self._robots
        # Copies that lie together: all that follows takes less time.
        distance_m = np.ascontiguousarray(take(state.distance_m, robots))
        position_m = take(state.bodies.position_m[: len(state.distance_m)], robots)
        position_m = np.ascontiguousarray(position_m)
        from_m, moved_m = glands.from_m.copy(), distance_m - glands.distance_m
        glands.from_m[:], glands.distance_m[:] = position_m, distance_m
        lays = (glands.per_m > 0.0) & (moved_m > 0.0) & state.presence.present[rows]
        if not (any_of(lays) and len(self._cell_m)):
            return
        laying = ALL if all_of(lays) else lays
        rows, per_m = rows[laying], glands.per_m[laying]
        per_m = self._altered(state, constants, rows, per_m, np.full(len(rows), at_s))
        trails = position_m[laying], from_m[laying], moved_m[laying]
        self._fields.lay(state, Trails(*trails, per_m, glands.field[laying]))

    def _asked(self, context: RequestContext) -> tuple[BoolArray, IndexArray]:
        """Return which requests are good, (k,), and the numbers of their glands."""
        numbers, field = context.constants.numbers[self._name][context.rows], context["field"]
        good = (numbers >= 0) & (field >= 0) & (field < len(self._cell_m))
        good &= context["amount"] >= 0.0  # not NaN
        return good, numbers[good]

    def _altered(
        self,
        state: EnvState,
        constants: RobotConstants,
        rows: IndexArray,
        amount: FloatArray,
        at_s: FloatArray,
    ) -> FloatArray:
        """Return amounts after degradation, (k,)."""
        if not constants.degradations.affects(state, self._name):
            return amount
        values = constants.degradations.alter(state, self._name, rows, amount[:, None], at_s)
        return np.maximum(np.nan_to_num(values[:, 0], nan=0.0), 0.0)


def install(row: Device, world: WorldModel, _seed: int, _log: EventLog) -> Installed:
    """Return the glands of a world's robots."""
    glands = Glands(row, world)
    handlers = {"DEPOSIT": glands.deposit, "LAY_TRAIL": glands.lay_trail}
    return Installed(handlers=handlers, device=glands)


def _inspect(state: EnvState, number: int) -> str:
    glands = state.device("gland", GlandState)
    per_m, field = float(glands.per_m[number]), int(glands.field[number])
    return f"trail of {per_m:g}/m in field {field}" if per_m else "no trail"


_FIELD: Final = ("field", "i[0]", "1", "the number of the field")

DEVICE = Device(
    name="gland",
    title="Gland",
    element="gland",
    summary="A gland that deposits pheromone; programs use it with crs_deposit() and"
    " crs_lay_trail() (crs.h).",
    model=Gland,
    state=GlandState.at_start,
    install=install,
    requests=(
        device_request(
            "DEPOSIT", 230, "int crs_deposit(int field, double amount)",
            "deposits pheromone under the robot",
            fields(_FIELD, ("amount", "f[0]", "1", "the amount")),
        ),
        device_request(
            "LAY_TRAIL", 231, "int crs_lay_trail(int field, double amount)",
            "deposits pheromone while the robot drives",
            fields(_FIELD, ("amount", "f[0]", "1/m", "the amount per metre, 0 for no trail")),
        ),
    ),
    functions=(
        Function(
            "int crs_deposit(int field, double amount)",
            "deposits an amount in a pheromone field under the robot; also FALSE if there is no"
            " such field, or if the amount is negative", posts=("DEPOSIT",), source=(OURS,),
        ),
        Function(
            "int crs_lay_trail(int field, double amount)",
            "deposits an amount per metre that the robot drives from now on, in place of any other"
            " trail; 0 for no trail", units="-, 1/m", posts=("LAY_TRAIL",), source=(OURS,),
        ),
    ),
    degradables=(
        Degradable(
            "gland", "deposited amount", AMOUNT, elements_of("gland", lambda _model: ("0",)), 1,
            "nothing is deposited", acts=True,
        ),
    ),
    inspect=_inspect,
    source=__file__,
)  # fmt: skip
