"""Elements of lights and sounds, and of the sensors for them."""

from __future__ import annotations

from crs_cc.core.quantity import ANGLE, BRIGHTNESS, LENGTH, LOUDNESS
from crs_cc.sim.files.document import Element, Reader
from crs_cc.sim.files.sensor_elements import period_s
from crs_cc.sim.model.beacons import (
    MAX_LIGHT_SENSORS,
    TONES,
    Light,
    LightSensors,
    Microphones,
    Sound,
)


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


def light_sensors(root: Element, reader: Reader) -> LightSensors | None:
    """Return the light sensors of a robot, None if it has none."""
    element = root.maybe("light-sensors")
    if element is None:
        return None
    return LightSensors(
        reader.whole(element, "number", 1, MAX_LIGHT_SENSORS, absent=1),
        reader.quantity(element, "first", ANGLE),
        reader.positive(element, "range", LENGTH),
        float(element.attributes.get("noise", "0")),
        period_s(element, reader),
    )


def microphones(root: Element, reader: Reader) -> Microphones | None:
    """Return the microphones of a robot, None if it has none."""
    element = root.maybe("microphones")
    if element is None:
        return None
    return Microphones(
        reader.positive(element, "range", LENGTH),
        float(element.attributes.get("noise", "0")),
        period_s(element, reader),
    )


def brightest(root: Element, reader: Reader) -> float:
    """Return the maximum brightness of a robot's lamp, 0 if it has none."""
    lamp = root.maybe("lamp")
    return 0.0 if lamp is None else reader.positive(lamp, "brightest", BRIGHTNESS, 0.0)


def loudest(root: Element, reader: Reader) -> float:
    """Return the maximum level of a robot's speaker, 0 if it has none."""
    speaker = root.maybe("speaker")
    return 0.0 if speaker is None else reader.positive(speaker, "loudest", LOUDNESS, 0.0)
