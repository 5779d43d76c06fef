"""The bumpers: switches around the body, pressed by contacts.

    pressed when -span / 2 <= bearing of the contact - bearing of the switch < span / 2

with bearings counter-clockwise from the front, at the centre of the robot. So where switches are
adjacent without a gap, each contact presses one; in a gap it presses none, and where spans overlap
both. The robot definition specifies which bit of `State[33]` a switch sets (vendor header
`Nclient.h` 1.29 has no layout, and every known Scout program only tests for "not 0"). Source of the
geometry: Player's driver of the Nomad 200, whose 20 switches are 18 degrees apart.

A switch is pressed at a cycle's start if something touched it in the cycle before, whether or not
the wheels turn. Degradation (`bumper`): a switch is 1 when it is pressed, else 0, and reported as
pressed if the degraded value is at least 0.5.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int32Array, Int64Array
from crs_cc.core.quantity import RATIO
from crs_cc.sim.devices.bumper.element import BUMPER_BITS, Switches, read, switches_of, write
from crs_cc.sim.devices.bumper.state import BumperState, bumper_state
from crs_cc.sim.devices.installed import Installed
from crs_cc.sim.devices.vendor_state import configuration
from crs_cc.sim.kernels import exact
from crs_cc.sim.model.degradable import Degradable, at_numbers, elements_of
from crs_cc.sim.model.device import Device
from crs_cc.sim.state.bodies import Contacts

if TYPE_CHECKING:
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.model.robot import RobotModel
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState
    from crs_cc.sim.state.events import EventLog


_TURN: Final = 2 * math.pi
_PRESSED: Final = 0.5
_FEW: Final = 4096  # pairs of contacts, which are compared without sorting
_ON_EDGE_RAD: Final = 1e-9  # rounding must not let a contact slip between two switches that meet


class Bumpers:
    """The switches of all robots of a world.

    >>> from crs_cc.sim.files.world_xml import empty_world
    >>> bumpers = Bumpers(empty_world())        # a Scout: eight switches, the first in front
    >>> bumpers.pressed(np.array([0, 0, 0]), np.array([0.0, math.pi / 2, -0.3])).tolist()
    [1, 4, 1]
    """

    def __init__(self, world: WorldModel) -> None:
        models = [robot.model for robot in world.robots]
        kinds = list(dict.fromkeys(models))
        self._kind = np.array([kinds.index(model) for model in models], dtype=np.intp)
        most = max((len(switches_of(model)) for model in kinds), default=0)
        table = np.zeros((len(kinds), most, 3))  # robots with fewer switches get some of width 0
        for row, model in zip(table, kinds, strict=True):
            row[: len(switches_of(model))] = _switches(model)
        self._bearing_rad, self._span_rad = table[..., 0], table[..., 1]
        self._bit = table[..., 2].astype(np.int32)

    def pressed(self, robots: IndexArray, bearing_rad: FloatArray) -> Int32Array:
        """Return the bits of the switches that contacts press, shape (k,).

        Args:
            robots: the robot of each contact, k of them.
            bearing_rad: its bearing from that robot's heading, shape (k,).
        """
        kinds = self._kind[robots]
        span_rad = self._span_rad[kinds]
        into_rad = bearing_rad[:, None] - self._bearing_rad[kinds] + span_rad / 2 + _ON_EDGE_RAD
        bits = np.where(into_rad % _TURN < span_rad, self._bit[kinds], 0)
        return np.asarray(np.bitwise_or.reduce(bits, axis=1))

    def touch(
        self, state: EnvState, constants: RobotConstants, contacts: Contacts, end_s: float
    ) -> Contacts:
        """Press switches and count collisions at the end of a cycle.

        Args:
            state: changed in place.
            constants: the constants of all objects.
            contacts: those of the cycle.
            end_s: its end.

        Returns:
            the contacts that did not exist in the cycle before.
        """
        robot = contacts.robot
        before = bumper_state(state).pressed
        quiet = not (len(robot) or len(state.contacts_before) or np.count_nonzero(before))
        if quiet and not constants.degradations.affects(state, "bumper"):
            return contacts
        keys = robot * len(constants.scene.names) + contacts.other
        began = ~_are_in(keys, state.contacts_before)
        state.contacts_before = keys.astype(np.int64)
        np.add.at(state.collisions, robot[began], 1)
        bearing_rad = exact.arctan2(
            contacts.y_m - state.y_m[robot], contacts.x_m - state.x_m[robot]
        )
        bearing_rad -= state.base_rad[robot]
        pressed = np.zeros_like(before)
        np.bitwise_or.at(pressed, robot, self.pressed(robot, bearing_rad))
        pressed = self.degraded(state, constants, pressed, end_s)
        hit = np.flatnonzero(pressed & ~before)
        before[:] = pressed
        if len(hit):
            bumper_state(state).hit.note(hit, end_s, configuration(state, constants, hit))
        return Contacts(
            robot[began],
            contacts.other[began],
            contacts.x_m[began],
            contacts.y_m[began],
            contacts.torn,
        )

    def degraded(
        self,
        state: EnvState,
        constants: RobotConstants,
        pressed: Int32Array,
        at_s: float,
    ) -> Int32Array:
        """Return the pressed switches at a time after degradation, (robots,)."""
        if not constants.degradations.affects(state, "bumper"):
            return pressed
        robots, places = np.arange(len(pressed)), np.arange(BUMPER_BITS)
        values = ((pressed[:, None] >> places) & 1).astype(np.float64)
        instants = np.full(len(robots), at_s)
        values = constants.degradations.alter(state, "bumper", robots, values, instants)
        bits = np.where(values >= _PRESSED, 1 << places, 0).sum(axis=1)
        have = np.bitwise_or.reduce(self._bit[self._kind], axis=1)
        return np.asarray(bits & have, dtype=np.int32)


def _switches(model: RobotModel) -> FloatArray:
    rows = [(switch.bearing_rad, switch.span_rad, 1 << switch.bit) for switch in switches_of(model)]
    return np.array(rows, dtype=np.float64).reshape(-1, 3)


def get_bp(context: RequestContext) -> BoolArray:
    """Answer GET_BP with the switches, in `State`; refuse robots without bumpers.

    Switches are pressed and released at the end of a cycle.
    """
    return np.asarray(context.constants.numbers["bumper"][context.rows] >= 0)


def _reading(state: EnvState, _model: Switches, robot: int) -> BoolArray:
    """Return which switches of a robot are pressed, by their bits in `State[33]`, (24,)."""
    return np.asarray(bumper_state(state).pressed[robot] >> np.arange(BUMPER_BITS) & 1 > 0)


def _are_in(keys: IndexArray, others: Int64Array) -> BoolArray:
    """Return which keys are among others, in a tenth of the time of `np.isin` for few.

    >>> _are_in(np.array([4, 7]), np.array([3, 4])).tolist()
    [True, False]
    """
    if len(keys) * len(others) > _FEW:
        return np.isin(keys, others)
    return np.asarray((keys[:, None] == others).any(axis=1))


def install(_row: Device, world: WorldModel, _seed: int, _log: EventLog) -> Installed:
    """Return the bumpers of a world's robots."""
    return Installed(handlers={"GET_BP": get_bp}, device=Bumpers(world))


DEVICE = Device(
    name="bumper",
    title="Bumpers",
    element="bumpers",
    summary="Contact switches around the body, in one or several rings.",
    model=Switches,
    read=read,
    write=write,
    state=lambda models: BumperState.released(len(models)),
    dense=True,
    install=install,
    degradables=(
        Degradable(
            "bumper",
            "state of a switch, numbered by its bit in State[33]: 1 if pressed, otherwise 0; after"
            " degradation, a value of 0.5 or more counts as pressed",
            RATIO, elements_of("bumper", lambda model: at_numbers([one.bit for one in model.all])),
            BUMPER_BITS, "the switch reads as not pressed",
        ),
    ),
    reading=_reading,
    source=__file__,
)  # fmt: skip
