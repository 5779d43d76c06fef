"""Changes to a running world from Python: the debugger's `world` edits, and more."""

from __future__ import annotations

import math
import numbers
from collections.abc import Sequence
from dataclasses import fields
from typing import TYPE_CHECKING, Any, Final

from crs_cc.api.numbers import check_number
from crs_cc.api.program_choice import Program, check_arguments, executable_of, own_program
from crs_cc.core.suggest import unknown
from crs_cc.debug.errors import DebugError
from crs_cc.debug.world.run_edits import edit_run
from crs_cc.runtime.executable import Executable
from crs_cc.sim.engine.inject import inject
from crs_cc.sim.model.degradation import Degradation, degradables, element_of
from crs_cc.sim.model.fields import MIN_EVAPORATION_S
from crs_cc.sim.model.world import Pose, Robot

if TYPE_CHECKING:
    from crs_cc.session.session import Session as InnerSession
    from crs_cc.sim.comms.control import CommunicationControl
    from crs_cc.sim.devices.degradation.control import DegradationControl

_FAULTS: Final = frozenset(each.name for each in fields(Degradation)) - {
    "robot",
    "device",
    "element",
}


class Edits:
    """The changes that a session offers, between two timesteps.

    Each is checked before anything changes, and raises ValueError if it is invalid, or TypeError.

    Attributes:
        inner: the session.
    """

    inner: InnerSession

    # -- robots and objects --------------------------------------------------------------------

    def add(self, robot: Robot, program: Program = None, arguments: Sequence[str] = ()) -> int:
        """Add a robot to the world; return its number.

        Args:
            robot: the robot; it joins now, or at its join time if that is later.
            program: what it runs; by default what its `program` names, else Python steers it.
            arguments: `argv` without its first element; by default those of the robot.
        """
        check_arguments(arguments)
        if not isinstance(program, Executable):
            program = executable_of(program or own_program(robot), robot)
        argv = [program.command, *(arguments or robot.arguments)]
        return self.inner.add_robot(robot, program, argv)

    def remove(self, name: str) -> None:
        """Remove a robot, whose program ends, or an object."""
        if name in self._robot_names:
            self.inner.remove_robot(name)
        else:
            self.inner.environment.remove_obstacle(name)

    def move(self, name: str, x_m: float, y_m: float, heading_rad: float | None = None) -> None:
        """Move a robot or a movable object to a free place, as if by hand.

        A robot's odometry does not notice, its motors keep running, and what it holds stays behind.

        Args:
            name: the robot or object.
            x_m: where to.
            y_m: where to.
            heading_rad: its new heading; by default it keeps its own.
        """
        environment = self.inner.environment
        known = (*self._robot_names, *environment.pushables)
        if name not in known:
            raise ValueError(unknown("robot or movable object", name, known))
        if heading_rad is None:
            state, body = environment.state, environment.names.index(name)
            is_robot = body < len(self._robot_names)
            heading_rad = float((state.heading_rad if is_robot else state.bodies.angle_rad)[body])
        place = tuple(_finite(value, "a coordinate") for value in (x_m, y_m, heading_rad))
        environment.teleport(name, Pose(*place))

    def edit(self, text: str) -> str:
        """Make a change given as a command of the debugger: `move robot0 to 1 2 90`.

        Returns:
            what has changed, in words.
        """
        try:
            return edit_run(self.inner, text)
        except DebugError as error:
            raise ValueError(str(error)) from None

    # -- faults, energy, heat ------------------------------------------------------------------

    @property
    def degradations(self) -> DegradationControl:
        """All degradations, to be listed, added, changed and removed."""
        return self.inner.environment.degradations

    def degrade(
        self, robot: str, device: str, element: int | str | None = None, **faults: Any
    ) -> str:
        """Degrade a device of a robot; return the degradation's name.

        Args:
            robot: the robot's name.
            device: the device, such as `sonar`.
            element: one of its elements by number or name, such as `left`; by default all.
            faults: the fields of `Degradation`: `bias`, `gain`, `noise`, `step`, `stuck`,
                `delay_s`, `dropouts`, `dead`, `onset_s`, `duration_s`, `recovery_s`.
        """
        model = self.inner.environment.world.robots[self._number(robot)].model
        if wrong := sorted(faults.keys() - _FAULTS):
            raise ValueError(unknown("fault", wrong[0], sorted(_FAULTS)))
        if isinstance(element, str):
            row = degradables().get(device)
            number = None if row is None else element_of(row, model, element)
            if row is not None and number is None:
                raise ValueError(unknown("element", element, row.elements(model)))
            element = number
        return self.degradations.add(Degradation(robot, device, element, **faults))

    def heal(self, robot: str, device: str = "") -> None:
        """Remove the degradations of a robot or of one of its devices, or one by its name."""
        self.edit(f"heal {robot} {device}")

    def set_charge(self, robot: str, share: float) -> None:
        """Set the state of charge of a robot's motor battery, 0 to 1."""
        check_number("share", share)
        if not 0.0 <= share <= 1.0:
            raise ValueError(f"invalid state of charge {share!r} (expected 0 to 1)")
        self.inner.environment.charge(self._number(robot), float(share))

    def set_heat(self, name: str, heat: float) -> None:
        """Set the heat of a robot or an object, 0 or more."""
        environment = self.inner.environment
        if name not in environment.names:
            raise ValueError(unknown("object", name, environment.names))
        check_number("heat", heat)
        if not 0.0 <= heat < math.inf:
            raise ValueError(f"invalid heat {heat!r} (expected 0 or more)")
        environment.set_heat(name, float(heat))

    def set_evaporation(self, field: str, evaporation_s: float) -> None:
        """Set the evaporation time of a pheromone field from now on, infinite for never."""
        check_number("evaporation_s", evaporation_s)
        if not evaporation_s >= MIN_EVAPORATION_S:
            least = f"{MIN_EVAPORATION_S:g} or more"
            raise ValueError(f"invalid evaporation time {evaporation_s!r} (expected {least})")
        self.inner.environment.set_evaporation(field, float(evaporation_s))

    # -- messages ------------------------------------------------------------------------------

    @property
    def communication(self) -> CommunicationControl:
        """The links between robots: `shut`, `open` and `counts`."""
        return self.inner.environment.communication

    def message(
        self,
        sender: str,
        content: bytes | str,
        receiver: str | None = None,
        *,
        channel: str = "radio",
        kind: int = 0,
    ) -> None:
        """Send a message now, as if the program of a robot had sent it.

        Args:
            sender: the sending robot.
            content: at most 248 bytes.
            receiver: the receiving robot; by default all others.
            channel: the channel.
            kind: the message's type, a number that the programs agree on.
        """
        data = content.encode() if isinstance(content, str) else content
        inject(self.inner.environment, sender, data, receiver, channel=channel, kind=kind)

    @property
    def _robot_names(self) -> list[str]:
        return [robot.id for robot in self.inner.environment.world.robots]

    def _number(self, robot: str) -> int:
        names = self._robot_names
        if robot not in names:
            raise ValueError(unknown("robot", robot, names))
        return names.index(robot)


def _finite(value: float, what: str) -> float:
    if not isinstance(value, numbers.Real):
        raise TypeError(f"{what} must be a number, not {value!r}")
    if not math.isfinite(value):
        raise ValueError(f"{what} must be finite, not {value!r}")
    return float(value)
