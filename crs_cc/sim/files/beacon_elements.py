"""From the elements of world and robot files to lights, sounds, and what senses them."""

from __future__ import annotations

from crs_cc.sim.beacon_model import (
    MAX_LIGHT_SENSORS,
    TONES,
    Light,
    LightSensors,
    Microphones,
    Sound,
)
from crs_cc.sim.files.document import Element, Reader
from crs_cc.sim.quantity import ANGLE, BRIGHTNESS, LENGTH, LOUDNESS


def lights(root: Element, reader: Reader) -> tuple[Light, ...]:
    """Gives the lights of a world; mistakes go to the reader."""
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
    """Gives the sounds of a world; mistakes go to the reader."""
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
    """Gives the light sensors of a robot, None where there are none."""
    for element in root.all("light-sensors"):
        return LightSensors(
            reader.whole(element, "number", 1, MAX_LIGHT_SENSORS, absent=1),
            reader.quantity(element, "first", ANGLE),
            reader.positive(element, "range", LENGTH),
            float(element.attributes.get("noise", "0")),
        )
    return None


def microphones(root: Element, reader: Reader) -> Microphones | None:
    """Gives the microphones of a robot, None where there are none."""
    for element in root.all("microphones"):
        return Microphones(
            reader.positive(element, "range", LENGTH), float(element.attributes.get("noise", "0"))
        )
    return None


def brightest(root: Element, reader: Reader) -> float:
    """Gives how bright the lamp of a robot can shine, 0 where there is none."""
    return (
        reader.positive(root.first("lamp"), "brightest", BRIGHTNESS, 0.0)
        if any(root.all("lamp"))
        else 0.0
    )


def loudest(root: Element, reader: Reader) -> float:
    """Gives how loud the speaker of a robot can sound, 0 where there is none."""
    return (
        reader.positive(root.first("speaker"), "loudest", LOUDNESS, 0.0)
        if any(root.all("speaker"))
        else 0.0
    )
