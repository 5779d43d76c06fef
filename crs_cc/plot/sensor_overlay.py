"""The last readings of sensors, in the plot of a run."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from crs_cc.plot.svg import Page, View
from crs_cc.sim.engine.sensor_overlay import Beam

_SOUND: Final = "#56b4e9"


def draw_sights(page: Page, view: View, beams: Sequence[Beam]) -> None:
    """Draw the last readings of sensors."""
    for beam in beams:
        points = [view.point(*point) for point in beam.outline.tolist()]
        if beam.colour:
            page.polyline(points, stroke=beam.colour, stroke_width=1.0, stroke_opacity=0.5)
        else:
            page.polygon(points, fill=_SOUND, fill_opacity=0.2, stroke=_SOUND, stroke_width=0.8)
