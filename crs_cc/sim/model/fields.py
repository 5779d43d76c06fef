"""Pheromone fields of a world: amounts on the floor, in square cells."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

NEVER_S: Final = math.inf
"""Evaporation time of what never evaporates."""

MAX_AMOUNT: Final = 1e6
"""Largest amount in a cell; our choice, so that sums of amounts are exact (`state.fields`)."""

MAX_FIELDS: Final = 4
MAX_CELLS: Final = 2**25
"""Largest number of fields in a world, and of cells in one; our choice, 256 MiB for each field."""

MIN_EVAPORATION_S: Final = 0.1
"""Shortest evaporation time: the longest timestep."""

STABLE: Final = 0.25
"""Largest diffusion * timestep / cell^2 for which the explicit scheme in two dimensions is stable.

W. H. Press et al., "Numerical Recipes", 3rd edition, 20.2 (for one dimension: 1/2).
"""


@dataclass(frozen=True, slots=True)
class Field:
    """A pheromone field, which covers the area of its world.

    Attributes:
        name: its name.
        cell_m: side of a cell.
        evaporation_s: time in which all but 1/e of an amount evaporates.
        diffusion_m2ps: diffusion coefficient [m^2/s].
        saturation: largest amount in a cell.
    """

    name: str
    cell_m: float = 0.05
    evaporation_s: float = NEVER_S
    diffusion_m2ps: float = 0.0
    saturation: float = MAX_AMOUNT

    def share(self, timestep_s: float) -> float:
        """Return the share of a difference between two cells that moves in a timestep."""
        return self.diffusion_m2ps * timestep_s / (self.cell_m * self.cell_m)
