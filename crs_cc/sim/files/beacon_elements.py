"""Elements of a world's lights and sounds."""

from __future__ import annotations

from crs_cc.core.quantity import BRIGHTNESS, LENGTH, LOUDNESS
from crs_cc.sim.files.document import Element, Reader
from crs_cc.sim.model.beacons import TONES, Light, Sound


def lights(root: Element, reader: Reader) -> tuple[Light, ...]:
    """Return the lights of a world; errors go to the reader."""
    return tuple(
        Light(
            element.attributes["id"],
            reader.quantity(element, "x", LENGTH),
            reader.quantity(element, "y", LENGTH),
            reader.not_negative(element, "brightness", BRIGHTNESS),
        )
        for element in root.all("light")
    )


def sounds(root: Element, reader: Reader) -> tuple[Sound, ...]:
    """Return the sounds of a world; errors go to the reader."""
    return tuple(
        Sound(
            element.attributes["id"],
            reader.quantity(element, "x", LENGTH),
            reader.quantity(element, "y", LENGTH),
            reader.not_negative(element, "level", LOUDNESS),
            reader.whole(element, "tone", 0, TONES - 1),
        )
        for element in root.all("sound")
    )
