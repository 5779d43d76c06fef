"""Goals: the conditions of a world that are worth points, as constant data.

A goal has one condition. Most conditions are met at an instant; `NoCollision` and `Follow` hold
over a time, which ends with another goal (`until`), with the goal's time limit, or with the run.

>>> home = Goal("home", Reach(Place(4.0, 3.0, 0.3)), points=5.0, within_s=60.0)
>>> clean = Goal("clean", NoCollision(until="home"))
>>> home.title, clean.is_lasting
('home', True)
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final, TypeAlias

MAX_GOALS: Final = 100
MAX_PLACES: Final = 1000
"""Places of one `Visit`."""

MAX_CELLS: Final = 40_000
"""Cells of one `Cover`."""

MAX_POINTS: Final = 1e6
MAX_NAME: Final = 80


@dataclass(frozen=True, slots=True)
class Place:
    """A round place: all points at most `radius_m` from its centre."""

    x_m: float
    y_m: float
    radius_m: float


@dataclass(frozen=True, slots=True)
class Reach:
    """A robot's centre is in a place, and stays there without a break."""

    place: Place
    stay_s: float = 0.0


@dataclass(frozen=True, slots=True)
class Approach:
    """A robot's centre is near the surface of an object, and stays there without a break."""

    object: str
    distance_m: float
    stay_s: float = 0.0


@dataclass(frozen=True, slots=True)
class Visit:
    """Each of several places has been reached, in any order."""

    places: tuple[Place, ...]


@dataclass(frozen=True, slots=True)
class NoCollision:
    """No robot begins to touch anything but the objects that are excepted."""

    excepted: tuple[str, ...] = ()
    until: str = ""


@dataclass(frozen=True, slots=True)
class Cool:
    """Objects, of which there must be at least one, have at most some heat."""

    objects: tuple[str, ...]
    heat: float = 0.0


@dataclass(frozen=True, slots=True)
class Cover:
    """Robots have been on a share of the cells of the floor.

    A cell counts as soon as its centre has been under a robot; those whose centre is inside of a
    fixed object or outside of the area do not count at all.
    """

    share: float
    cell_m: float


@dataclass(frozen=True, slots=True)
class Bring:
    """The centres of movable objects are in a place at the same time, and stay there."""

    objects: tuple[str, ...]
    place: Place
    stay_s: float = 0.0


@dataclass(frozen=True, slots=True)
class Follow:
    """The distance to the centre of a robot or a movable object is right for a share of the time.

    It is that of a robot's centre, and right from `least_m` to `most_m`, both included.
    """

    target: str
    least_m: float
    most_m: float
    share: float
    until: str = ""


Condition: TypeAlias = Reach | Approach | Visit | NoCollision | Cool | Cover | Bring | Follow


@dataclass(frozen=True, slots=True)
class Goal:
    """One goal of a world.

    Attributes:
        id: its name, unique in the world.
        condition: what has to be so.
        name: a title for people; empty for the id.
        points: what it is worth.
        robots: the robots that have to meet it; empty if any robot can. Several robots must each
            reach, approach or follow; they visit and cover together; only their collisions count.
            It must be empty for `Cool` and `Bring`.
        within_s: the time limit, from the start of the run [s]; infinite for none.
        after: the id of the goal that must be met first; empty for none.
    """

    id: str
    condition: Condition
    name: str = ""
    points: float = 1.0
    robots: tuple[str, ...] = ()
    within_s: float = math.inf
    after: str = ""

    @property
    def title(self) -> str:
        """The name, or the id of a goal without a name."""
        return self.name or self.id

    @property
    def until(self) -> str:
        """The id of the goal that ends the time over which it holds; empty for none."""
        return self.condition.until if isinstance(self.condition, NoCollision | Follow) else ""

    @property
    def is_lasting(self) -> bool:
        """Whether it must hold over a time, and is met only at the end of it."""
        return isinstance(self.condition, NoCollision | Follow)


def cells_of(cell_m: float, length_m: float, width_m: float) -> tuple[int, int]:
    """Return the number of columns and rows of cells that cover an area.

    >>> cells_of(0.25, 6.0, 5.1)
    (24, 21)
    """
    return math.ceil(length_m / cell_m - 1e-9), math.ceil(width_m / cell_m - 1e-9)
