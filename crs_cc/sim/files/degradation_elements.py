"""The `<degradation>` elements of a world file.

Values are in the unit of the device's element; `stuck="hold"` holds the last one.

>>> from crs_cc.sim.files.world_xml import parse_world
>>> world = parse_world(b'''<world version="1"><area length="6m" width="5m"/>
...   <robot x="1m" y="1m"/>
...   <degradation robot="robot0" device="sonar" element="3" bias="20cm" onset="10s"/>
...   <degradation robot="robot0" device="drive" element="left" gain="0.8"/>
... </world>''', "room")
>>> [(each.id, each.element, each.bias, each.gain) for each in world.degradations]
[('degradation0', 3, 0.2, 1.0), ('degradation1', 1, 0.0, 0.8)]
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

from crs_cc.core.quantity import RATIO, TIME
from crs_cc.core.suggest import unknown
from crs_cc.sim.files.document import Element, Reader
from crs_cc.sim.model.degradable import Degradable
from crs_cc.sim.model.degradation import (
    HOLD,
    MAX_MEMORY,
    Degradation,
    degradables,
    element_of,
    memory_size,
    out_of_range,
    shown,
    validation_error,
)
from crs_cc.sim.model.robot import RobotModel
from crs_cc.sim.model.world import Robot

_UNKNOWN: Final = -1


def degradations(
    elements: Iterable[Element], robots: Iterable[tuple[Element, Robot]], reader: Reader
) -> tuple[Degradation, ...]:
    """Return the degradations of a world file; errors go to the reader."""
    known = {robot.id: (place, robot.model) for place, robot in robots}
    found, room = [], MAX_MEMORY
    for element in elements:
        name = element.attributes["robot"]
        if name not in known:
            reader.refuse(element, f"robot: {unknown('robot', name, tuple(known))}")
            continue
        place, model = known[name]
        if place.broken:  # and so, perhaps, without its devices
            continue
        one = degradation(element, model, reader)
        if one is None:
            continue
        room -= memory_size(one)
        if room < 0:
            reader.error(element, "too many degradations: their delays need too much memory")
            break
        found.append(one)
    return tuple(found)


def degradation(element: Element, model: RobotModel, reader: Reader) -> Degradation | None:
    """Return the degradation of a robot that an element describes; None after an error."""
    device = degradables().get(element.attributes["device"])
    if device is None:
        name = element.attributes["device"]
        reader.refuse(element, f"device: {unknown('device', name, tuple(degradables()))}")
        return None
    number = _element(element, device, model, reader)
    if number == _UNKNOWN:
        return None
    names = device.elements(model) or ("",)
    kind = device.kind_of(names[number or 0])
    stuck = element.attributes.get("stuck")
    holds = stuck is not None and stuck.strip() == HOLD
    fixed = None if stuck is None or holds else reader.quantity(element, "stuck", kind)
    found = Degradation(
        element.attributes["robot"],
        device.name,
        number,
        bias=reader.quantity(element, "bias", kind),
        gain=reader.quantity(element, "gain", RATIO, 1.0),
        noise=reader.quantity(element, "noise", kind),
        step=reader.quantity(element, "step", kind),
        stuck=HOLD if holds else fixed,
        delay_s=reader.quantity(element, "delay", TIME),
        dropouts=reader.quantity(element, "dropouts", RATIO),
        dead=element.attributes.get("dead") == "yes",
        onset_s=reader.quantity(element, "onset", TIME),
        duration_s=_duration_s(element, reader),
        recovery_s=reader.quantity(element, "recovery", TIME),
        id=element.attributes.get("id", ""),
    )
    for wrong in out_of_range(found):
        reader.refuse(element, wrong)
    if not element.broken and (wrong := validation_error(found, model)):
        reader.refuse(element, wrong)
    return None if element.broken else found


def _element(element: Element, device: Degradable, model: RobotModel, reader: Reader) -> int | None:
    """Return the number of the element, None for all, `_UNKNOWN` for an unknown one."""
    text = element.attributes.get("element")
    names = device.elements(model)
    if text is None or not names:  # a missing device is reported later
        return None
    number = element_of(device, model, text)
    if number is None:
        reader.refuse(
            element, f"element: unknown {text[:40]!r} of {device.name} (known: {shown(names)})"
        )
        return _UNKNOWN
    return number


def _duration_s(element: Element, reader: Reader) -> float | None:
    return reader.quantity(element, "duration", TIME) if "duration" in element.attributes else None
