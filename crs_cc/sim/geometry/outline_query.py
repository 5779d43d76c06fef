"""What rays and echoes ask for: the outlines that lie within reach of robots.

`obstacles.Obstacles` gives all of them, `outlook.Level` those that matter at a height.
"""

from __future__ import annotations

from typing import Protocol

from crs_cc.core.arrays import ComplexArray, FloatArray, IndexArray


class Prospect(Protocol):
    """Gives pairs of a robot and an outline; among them all within reach."""

    def segments_near(
        self, place: ComplexArray
    ) -> tuple[IndexArray, ComplexArray, ComplexArray, FloatArray]:
        """Return the robots, and both ends and the length [m] of the segments."""

    def segment_things(self, place: ComplexArray) -> IndexArray:
        """Return the thing, as in `Scene.names`, of each pair that `segments_near` gives."""

    def circles_near(
        self, place: ComplexArray, own: IndexArray
    ) -> tuple[IndexArray, ComplexArray, FloatArray]:
        """Return the robots, and middle and radius [m] of the circles, but for their own bodies."""

    def circle_things(self, place: ComplexArray, own: IndexArray) -> IndexArray:
        """Return the thing, as in `Scene.names`, of each pair that `circles_near` gives."""
