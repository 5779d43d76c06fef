"""Robots of a session: their poses and readings, in SI units, and their control from Python."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from crs_cc.api.program_choice import NONE
from crs_cc.api.programs import shown
from crs_cc.core.arrays import FloatArray
from crs_cc.core.suggest import unknown
from crs_cc.sim.model.registry import devices

if TYPE_CHECKING:
    from crs_cc.api.output import Streams
    from crs_cc.session.result import RobotResult
    from crs_cc.session.session import Session
    from crs_cc.sim.comms.control import Message
    from crs_cc.sim.engine.environment import Environment
    from crs_cc.sim.model.robot import RobotModel

Reading = npt.NDArray[Any]


class RobotView:
    """A robot of a session; whatever it returns is of now.

    Its sensors are attributes by their names, such as `sonar`; docs/python.md lists them. Each
    array is a new one, which may be kept.

    Attributes:
        name: its name in the world.
        number: its row in arrays over all robots.
    """

    def __init__(self, session: Session, streams: Streams, name: str, number: int) -> None:
        self._session = session
        self._streams = streams
        self.name = name
        self.number = number

    @property
    def _environment(self) -> Environment:
        return self._session.environment

    @property
    def model(self) -> RobotModel:
        """Its constants."""
        return self._environment.world.robots[self.number].model

    @property
    def is_present(self) -> bool:
        """Whether it is in the world: it has joined and has not left."""
        return bool(self._environment.present[self.number])

    @property
    def _is_steered(self) -> bool:
        return self._session.fleet.executable(self.number).name == NONE

    # -- where it is ---------------------------------------------------------------------------

    @property
    def position_m(self) -> FloatArray:
        """Its x and y [m], (2,)."""
        place: FloatArray = self._environment.last_state.bodies.position_m[self.number].copy()
        return place

    @property
    def heading_rad(self) -> float:
        """Its heading [rad], 0 to 2 pi."""
        return float(self._environment.last_state.heading_rad[self.number])

    @property
    def pose(self) -> FloatArray:
        """Its x [m], y [m] and heading [rad], (3,)."""
        return np.append(self.position_m, self.heading_rad)

    @property
    def odometry(self) -> FloatArray:
        """Its pose by odometry, relative to its start: x [m], y [m], heading [rad], (3,)."""
        own, row = self._environment.last_state.odometry, self.number
        return np.array([own.x_m[row], own.y_m[row], own.heading_rad[row]])

    @property
    def axis_names(self) -> tuple[str, ...]:
        """The names of its axes: `right` and `left`, or `translation`, `steering`, `turret`."""
        return self.model.drive.axis_names

    @property
    def axis_speeds(self) -> FloatArray:
        """The speeds of its axes as commanded [m/s or rad/s], (axes,)."""
        speed = self._environment.state.drive.axes.speed
        return speed[self.number, : len(self.axis_names)].copy()

    # -- what it senses ------------------------------------------------------------------------

    @property
    def sensors(self) -> tuple[str, ...]:
        """The names of its sensors."""
        return tuple(
            row.name
            for row in devices()
            if row.reading is not None and self.model.device(row.name) is not None
        )

    def __getattr__(self, name: str) -> Reading:
        """Return the last reading of a sensor [SI unit]; nothing is measured for it."""
        if name.startswith("_") or hasattr(type(self), name):  # an error inside of a property
            value: Reading = object.__getattribute__(self, name)
            return value
        reading = self._environment.reading(name, self.number)
        if reading is None:
            raise AttributeError(f"{self.name}: {unknown('sensor', name, self.sensors)}")
        return reading.copy()

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self.sensors]

    def measure(self, name: str) -> Reading:
        """Measure with a sensor now, as a request of the program would, and return the reading.

        At most at the sensor's rate: else the reading is the last one. Sonars and bumpers measure
        by themselves.

        Raises:
            ValueError: the robot has no such sensor.
        """
        if name not in self.sensors:
            raise ValueError(f"{self.name}: {unknown('sensor', name, self.sensors)}")
        self._environment.measure(name, np.array([self.number]))
        reading = self._environment.reading(name, self.number)
        assert reading is not None
        return reading.copy()

    @property
    def charge(self) -> float:
        """The state of charge of its motor battery, 0 to 1."""
        return self._environment.charges(self.number)[1]

    # -- what it does --------------------------------------------------------------------------

    def drive(self, *speeds: float) -> None:
        """Set the speeds of its axes from now on: of a Scout, `drive(right, left)` [m/s].

        They are reached with the accelerations of the robot's definition, and clipped to its
        limits; there is no link and no resolution.

        Args:
            speeds: one for each of `axis_names` [m/s, or rad/s for steering and turret].

        Raises:
            ValueError: there is another number of axes, one is not finite, a program runs on it, or
                it is not in the world.
        """
        speed = self.checked_speeds(speeds)
        if not self.is_present:
            raise ValueError(f"{self.name} is not in the world")
        if not self._is_steered:
            raise ValueError(f"{self.name} runs a program, which sets its speeds itself")
        self._environment.drive(np.array([self.number]), speed[None, :])

    def checked_speeds(self, speeds: npt.ArrayLike) -> FloatArray:
        """Return the speeds of its axes as an array of three, 0 for missing axes.

        Raises:
            ValueError: there is another number of axes, or one is not finite.
        """
        names = self.axis_names
        try:
            given = np.asarray(speeds, dtype=np.float64)
        except (TypeError, ValueError):
            given = np.full(0, np.nan)
        if given.shape != (len(names),) or not np.isfinite(given).all():
            wanted = f"{len(names)} finite numbers, the speeds of {' and '.join(names)}"
            raise ValueError(f"{self.name}: invalid speeds {speeds!r} (expected {wanted})")
        return np.append(given, np.zeros(3 - len(names)))

    def receive(self) -> Message | None:
        """Take the first message out of its inbox; None if that is empty.

        `Session.message` sends one in its name.

        Raises:
            ValueError: a program runs on it, which receives its messages itself.
        """
        if not self._is_steered:
            raise ValueError(f"{self.name} runs a program, which receives its messages itself")
        return self._environment.communication.receive(self.name)

    # -- its program ---------------------------------------------------------------------------

    @property
    def result(self) -> RobotResult:
        """Its result so far."""
        return shown_result(self._session.state.robot_result(self.number))

    @property
    def stdout(self) -> str:
        """What its program has written to its standard output, at most 1 MiB."""
        return self._streams.text(self.number, 1)

    @property
    def stderr(self) -> str:
        """What its program has written to its standard error, at most 1 MiB."""
        return self._streams.text(self.number, 2)

    @property
    def files(self) -> dict[str, bytes]:
        """The files that its program created or changed, by name."""
        found = self._session.files(self.number)
        return {name.decode("utf-8", "surrogateescape"): data for name, data in found.items()}

    def __repr__(self) -> str:
        if not self.is_present:
            return f"<robot {self.name}, not in the world>"
        x_m, y_m, heading_rad = self.pose.tolist()
        angle_deg = np.degrees(heading_rad)
        return f"<robot {self.name} at {x_m:.3f}, {y_m:.3f} m, {angle_deg:.1f} deg>"


def shown_result(result: RobotResult) -> RobotResult:
    """Return a result whose error, if any, is in a file of the user."""
    return result if result.error is None else replace(result, error=shown(result.error))


class Robots(Mapping[str, RobotView]):
    """The robots of a session by name, in the world's order."""

    def __init__(self, session: Session, streams: Streams) -> None:
        self._session = session
        self._streams = streams

    @property
    def _names(self) -> list[str]:
        return [robot.id for robot in self._session.environment.world.robots]

    def __getitem__(self, name: str) -> RobotView:
        names = self._names
        if not isinstance(name, str):
            raise KeyError(f"robots are found by their names, not by {name!r} ({', '.join(names)})")
        if name not in names:
            raise KeyError(unknown("robot", name, names))
        return RobotView(self._session, self._streams, name, names.index(name))

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._session.environment.world.robots)

    def __repr__(self) -> str:
        return f"<robots {', '.join(self._names)}>"
