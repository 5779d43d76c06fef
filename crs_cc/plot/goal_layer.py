"""The places of a world's goals in the plot of a run."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from crs_cc.plot.svg import Page, View
from crs_cc.sim.model.goals import Bring, Goal, Place, Reach, Visit
from crs_cc.sim.model.world import WorldModel

_PAINT: Final = "#2e7d32"


def draw_goals(page: Page, view: View, world: WorldModel) -> None:
    """Draw the places that goals name as dashed circles with a title."""
    with page.group(stroke=_PAINT, stroke_width=1.2, fill="none", stroke_dasharray="5 3"):
        for goal in world.goals:
            for place in places(goal):
                page.circle(view.point(place.x_m, place.y_m), view.length(place.radius_m))
    with page.group(fill=_PAINT, font_size=10.0, text_anchor="middle"):
        for goal in world.goals:
            for number, place in enumerate(places(goal), 1):
                text = f"{goal.title} {number}" if isinstance(goal.condition, Visit) else goal.title
                page.text(view.point(place.x_m, place.y_m - place.radius_m), text, dy=11.0)


def places(goal: Goal) -> Iterator[Place]:
    """Yield the places of a goal."""
    match goal.condition:
        case Reach(place) | Bring(place=place):
            yield place
        case Visit(places):
            yield from places
