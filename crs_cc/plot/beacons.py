"""Lights, sounds, sources and nests in the plot of a run, and the fingers of grippers."""

from __future__ import annotations

import math
from typing import Final

from crs_cc.plot.svg import Page, Point, View
from crs_cc.sim.devices.gripper.model import Gripper
from crs_cc.sim.model.world import WorldModel

SOURCE_PAINT: Final = "#b8860b"
NEST_PAINT: Final = "#3f51b5"
"""The colours of sources of items, and of nests."""

_LIGHT: Final = "#e6a700"
_SOUND: Final = "#7a5195"
_SIZE_PX: Final = 6.0
_RAYS: Final = 8
_WAVES: Final = (0.5, 1.2, 1.9)


def draw_beacons(page: Page, view: View, world: WorldModel) -> None:
    """Draw the light sources of a world as suns, its sound sources as waves."""
    for light in world.lights:
        middle = view.point(light.x_m, light.y_m)
        with page.group(stroke=_LIGHT, stroke_width=1.5):
            for ray in range(_RAYS):
                angle = ray * 2 * math.pi / _RAYS
                page.line(_away(middle, _SIZE_PX, angle), _away(middle, 2 * _SIZE_PX, angle))
            page.circle(middle, 0.7 * _SIZE_PX, fill=_LIGHT)
    for sound in world.sounds:
        with page.group(stroke=_SOUND, stroke_width=1.5, fill="none"):
            for wave in _WAVES:
                page.circle(view.point(sound.x_m, sound.y_m), wave * _SIZE_PX)


def draw_places(page: Page, view: View, world: WorldModel) -> None:
    """Draw the sources and nests of a world as discs with their names."""
    for paint, places in ((SOURCE_PAINT, world.sources), (NEST_PAINT, world.nests)):
        for place in places:
            with page.group(fill=paint, stroke=paint):
                middle, radius_px = view.point(place.x_m, place.y_m), view.length(place.radius_m)
                page.circle(middle, radius_px, fill_opacity=0.2)
            edge = view.point(place.x_m, place.y_m - place.radius_m)
            page.text(edge, place.id, dy=11.0, fill=paint, font_size=10.0, text_anchor="middle")


def draw_fingers(
    page: Page, view: View, gripper: Gripper, robot: tuple[float, float, float], paint: str
) -> None:
    """Draw the fingers of a gripper, fully open.

    Args:
        page: where to draw.
        view: maps metres to the page.
        gripper: the gripper.
        robot: x, y [m] and heading [rad] of its robot.
        paint: the colour.
    """
    x_m, y_m, heading_rad = robot
    cos, sin = math.cos(heading_rad), math.sin(heading_rad)
    for side_m in (gripper.opening_m / 2, -gripper.opening_m / 2):
        ends = [
            view.point(x_m + cos * ahead_m - sin * side_m, y_m + sin * ahead_m + cos * side_m)
            for ahead_m in (gripper.place_m, gripper.place_m + gripper.reach_m)
        ]
        page.line(*ends, stroke=paint, stroke_width=2.5, stroke_linecap="round")


def _away(middle: Point, distance_px: float, angle_rad: float) -> Point:
    x_px, y_px = middle
    return x_px + distance_px * math.cos(angle_rad), y_px - distance_px * math.sin(angle_rad)
