"""A world that runs, as those see it who ask and change it between two of its steps."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState


class Running(Protocol):
    """What they need of it. They keep no part of it: a restored world has another state."""

    state: EnvState

    @property
    def world(self) -> WorldModel:
        """Return the world with all its robots."""

    @property
    def time_s(self) -> float:
        """Return the start of the current cycle [s]."""
