"""The interface of a running world for queries and changes between two of its steps."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState


class RunningWorld(Protocol):
    """A running world. Keep no reference to parts of it: a restored world has another state."""

    @property
    def state(self) -> EnvState:
        """Return its state, which may be changed."""

    @property
    def world(self) -> WorldModel:
        """Return the world with all its robots."""

    @property
    def time_s(self) -> float:
        """Return the start of the current cycle [s]."""
