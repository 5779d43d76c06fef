"""A position in a run, by progress rather than by the clock.

A run consists of timesteps, these of rounds, and in a round one program after the other runs. A
program's statements are counted, with the returns from its calls, so that `robot` and `statements`
identify a position; the others say when that is.

>>> Position(3, 0, robot=1, statements=40) < Position(3, 1) < Position(4, 0)
True
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, order=True, slots=True)
class Position:
    """A position in a run; earlier ones are smaller.

    Attributes:
        timestep: how many timesteps have ended.
        round: how many rounds of this timestep have ended.
        robot: the program that has stopped in the middle of a round; -1 for none, before the round.
        statements: how many statements of that program have started, and how many of its calls
            have returned: it is before the next of them.
    """

    timestep: int
    round: int
    robot: int = -1
    statements: int = 0


BEGINNING = Position(0, 0)
"""Before the first statement of all programs."""
