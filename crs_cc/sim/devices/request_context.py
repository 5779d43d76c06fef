"""Requests that robots posted, with all that is needed to answer them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Records

if TYPE_CHECKING:
    from crs_cc.sim.devices.ray_caster import RayCaster
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.state.env_state import EnvState


@dataclass(frozen=True, slots=True)
class RequestContext:
    """Requests of one kind; arrays have a row for each, k of them.

    Attributes:
        state: the state, to be changed in place; axes were turned to `at_s`.
        constants: the robots' constants.
        rays: what there is to see.
        rows: the robots, rising.
        messages: what they ask, of dtype `MESSAGE`, to be changed in place into the replies.
        at_s: when each is answered, within the current cycle.
    """

    state: EnvState
    constants: RobotConstants
    rays: RayCaster
    rows: IndexArray
    messages: Records
    at_s: FloatArray


Answer: TypeAlias = Callable[[RequestContext], BoolArray | None]
"""Writes what robots are told over their messages; gives which requests were good, None for all."""
