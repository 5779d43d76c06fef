"""A kind of device in a world: the result of installing its row."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, TypeAlias

from crs_cc.core.arrays import FloatArray, IndexArray

if TYPE_CHECKING:
    from crs_cc.sim.devices.ray_caster import RayCaster
    from crs_cc.sim.devices.request_context import Handler
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.geometry.rays import Fan
    from crs_cc.sim.state.env_state import EnvState
    from crs_cc.sim.state.paged_reply import PagedReply

Read: TypeAlias = "Callable[[EnvState, RobotConstants, RayCaster, IndexArray, FloatArray], None]"
"""The function that measures with sensors of the given robots at the given times."""


@dataclass(frozen=True, slots=True)
class Timed:
    """A kind of sensor that can have a timer.

    Attributes:
        read: measures with it.
        measured_s: from the state: time of each one's last measurement; below 0 for never, (n,).
        interval_s: minimum time between two measurements of each, (n,).
    """

    read: Read
    measured_s: Callable[[EnvState], FloatArray]
    interval_s: FloatArray


@dataclass(frozen=True, slots=True, kw_only=True)
class Installed:
    """The devices of one kind of all robots of a world.

    Attributes:
        handlers: the handlers of its requests, by their names.
        timed: how it measures by a timer; None if it has none.
        fans: the beams that it casts.
        announced: from the state: the readings that the last reply announced, for READINGS; None
            if all its readings fit into a reply.
        device: the object behind these, for devices that work together.
    """

    handlers: Mapping[str, Handler] = field(default_factory=dict)
    timed: Timed | None = None
    fans: Sequence[Fan] = ()
    announced: Callable[[EnvState], PagedReply] | None = None
    device: Any = None
