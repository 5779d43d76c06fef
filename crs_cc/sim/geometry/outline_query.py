"""The interface through which rays and echoes query outlines within reach of robots.

`obstacles.Obstacles` returns all of them, `height_occlusion.Outlook.at` those at a height.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Protocol

from crs_cc.core.arrays import ComplexArray, FloatArray, IndexArray


class ObstacleQuery(Protocol):
    """Returns pairs of a robot and an outline, including all within reach."""

    def blocks(self, place: ComplexArray) -> Iterator[tuple[slice, ObstacleQuery]]:
        """Yield parts of the robots whose pairs are few enough, each with the outlines for it."""

    def segment_rows(self, place: ComplexArray) -> FloatArray:
        """Return what `segments_near` returns, with objects, as `kernels/rays.c` reads it."""

    def circle_rows(self, place: ComplexArray, own: IndexArray) -> FloatArray:
        """Return what `circles_near` returns, with objects, as `kernels/rays.c` reads it.

        Bodies of robots may be among them.
        """

    def segments_near(
        self, place: ComplexArray
    ) -> tuple[IndexArray, ComplexArray, ComplexArray, FloatArray]:
        """Return the robots, and both ends and the length [m] of the segments."""

    def segment_objects(self, place: ComplexArray) -> IndexArray:
        """Return the object, as in `Scene.names`, of each pair of `segments_near`."""

    def circles_near(
        self, place: ComplexArray, own: IndexArray
    ) -> tuple[IndexArray, ComplexArray, FloatArray]:
        """Return the robots, and centre and radius [m] of the circles, except their own bodies."""

    def circle_objects(self, place: ComplexArray, own: IndexArray) -> IndexArray:
        """Return the object, as in `Scene.names`, of each pair of `circles_near`."""

    def segments_and_objects(
        self, place: ComplexArray
    ) -> tuple[tuple[IndexArray, ComplexArray, ComplexArray, FloatArray], IndexArray]:
        """Return `segments_near` and `segment_objects`, which often need the same."""

    def circles_and_objects(
        self, place: ComplexArray, own: IndexArray
    ) -> tuple[tuple[IndexArray, ComplexArray, FloatArray], IndexArray]:
        """Return `circles_near` and `circle_objects`, which often need the same."""
