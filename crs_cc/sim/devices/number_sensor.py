"""Sensors whose reading is a few numbers: everything about them follows from a short row.

A value that is not there (NaN) makes the request fail. Values go to C as integers, rounded to the
nearest 0.1 inch or 0.1 degree.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray
from crs_cc.core.quantity import ANGLE, LENGTH, Kind
from crs_cc.core.units import m_to_tenths_inch, rad_to_tenths_deg
from crs_cc.requests import LARGEST, Field, device_request
from crs_cc.robot_api.row import OURS, Function
from crs_cc.sim.devices.sensor import Measure, Readings, Sensor, last_values
from crs_cc.sim.model.degradable import Degradable, elements_of
from crs_cc.sim.model.device import NAME, Device

if TYPE_CHECKING:
    from crs_cc.sim.devices.installed import Installed
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.events import EventLog

_RESERVED: Final = frozenset({
    "auto", "break", "case", "char", "const", "continue", "default", "do", "double", "else", "enum",
    "extern", "float", "for", "goto", "if", "inline", "int", "long", "register", "restrict",
    "return", "short", "signed", "sizeof", "static", "struct", "switch", "typedef", "union",
    "unsigned", "void", "volatile", "while", "message",
})  # fmt: skip
"""Names that values cannot have: C keywords (C17 6.4.1), and a variable of the C function."""

MAX_VALUES: Final = 8
"""Number of integers in a reply (`requests.door`)."""


@dataclass(frozen=True, slots=True)
class _Unit:
    """A unit of C.

    Attributes:
        name: its name in the docs.
        convert: converts from the SI unit.
        limit: the largest number, as a degraded sensor may measure any value.
    """

    name: str
    convert: Callable[[FloatArray], FloatArray]
    limit: float


_UNITS: Final = {
    LENGTH.name: _Unit("0.1 in", m_to_tenths_inch, LARGEST),
    ANGLE.name: _Unit("0.1 deg", rad_to_tenths_deg, 3600.0),
}
"""Units of values in C, by the name of their kind: the vendor's (`Nclient.h`)."""


@dataclass(frozen=True, slots=True)
class Value:
    """One number that a sensor measures.

    Attributes:
        name: its name in C and as an element of degradations, such as `pitch`.
        meaning: description, including the sign convention, such as `pitch, nose up`.
    """

    name: str
    meaning: str


def _listed(names: Sequence[str]) -> str:
    return " and ".join([", ".join(names[:-1]), names[-1]] if names[1:] else names)


def number_sensor(
    *,
    name: str,
    title: str,
    element: str,
    summary: str,
    does: str,
    model: type,
    values: tuple[Value, ...],
    kind: Kind,
    measure: Measure,
    nothing: str = "there is no reading, and the request fails",
    source: str = "",
    number: int = -1,
    stream: int = -1,
) -> Device:
    """Return the row of a sensor that measures a few numbers.

    Args:
        name: one word: its function is `crs_<name>`, its number `CRS_SENSOR_<NAME>`, its request
            `<NAME>`; also its name in degradations.
        title: its title in the docs, such as `Inclinometer`.
        element: its element in robot definitions.
        summary: one sentence for the schema, without its full stop; the C function is added.
        does: description of its C function, for the docs of `crs.h`: `measures ...`.
        model: the dataclass of its constants, whose fields are made by `attribute`, `rate` and
            `period`; it has `rate_hz` and `period_s`, and may have a standard deviation `noise_m`
            or `noise_rad`.
        values: its measured values.
        kind: the quantity of its values: `LENGTH` (0.1 inch in C) or `ANGLE` (0.1 degree).
        measure: the measuring function.
        nothing: effect of a degradation that leaves no value.
        source: the device's file; it is `__file__` of the package.
        number: its number in `crs.h`; by default the next free one.
        stream: the number of its noise stream; by default derived from its name.

    Raises:
        ValueError: an argument is invalid.
    """
    _check(name, values, kind, model)
    unit, names = _UNITS[kind.name], tuple(value.name for value in values)
    prototype = f"int crs_{name}({', '.join(f'int *{each}' for each in names)})"
    results = [
        Field(value.name, f"i[{place}]", unit.name, value.meaning)
        for place, value in enumerate(values)
    ]
    meanings = ", ".join(value.meaning for value in values)

    def install(row: Device, world: WorldModel, seed: int, _log: EventLog) -> Installed:
        sensors = Sensor(row, world, seed, measure, len(values))

        def answer(context: RequestContext) -> BoolArray:
            has, mine = sensors.measure_on_request(context)
            value = sensors.readings(context.state).value[mine]
            there = np.isfinite(value).all(axis=1)
            has[has] = there
            value = np.clip(np.rint(unit.convert(value[there])), -unit.limit, unit.limit)
            for column, each in zip(value.astype(np.int32).T, names, strict=True):
                context.put(each, column, has)
            return has

        return sensors.installed({name.upper(): answer})

    def inspect(state: Any, number: int) -> str:
        readings = state.device(name, Readings)
        value = readings.value[number].tolist() if readings.at_s[number] >= 0.0 else ()
        shown = zip(names, value, strict=False)
        return ", ".join(f"{each} {kind.show(number)}" for each, number in shown) or "no reading"

    return Device(
        name=name,
        title=title,
        element=element,
        summary=f"{summary}; programs read it with crs_{name}() (crs.h).",
        model=model,
        state=lambda models: Readings.never(len(models), len(values)),
        install=install,
        requests=(device_request(name.upper(), -1, prototype, does, results=tuple(results)),),
        functions=(
            Function(
                prototype, f"{does}: {meanings}", units=unit.name,
                posts=(name.upper(),), source=(OURS,),
            ),
        ),
        code=_c_function(prototype, name.upper(), names),
        degradables=(
            Degradable(
                name, _listed(names), kind, elements_of(name, lambda _model: names), len(names),
                nothing,
            ),
        ),
        inspect=inspect,
        reading=last_values(name),
        number=number,
        stream=stream,
        source=source,
    )  # fmt: skip


def _check(name: str, values: Sequence[Value], kind: Kind, model: type) -> None:
    names = [value.name for value in values]
    if not values or not all(map(NAME.fullmatch, [name, *names])):
        raise ValueError("name and the names of values must be lower-case words")
    if len(set(names)) < len(names) or not _RESERVED.isdisjoint(names):
        raise ValueError("the names of values must be distinct, and not reserved in C")
    if len(values) > MAX_VALUES:
        raise ValueError(f"more than {MAX_VALUES} values")
    if kind.name not in _UNITS:
        raise ValueError("kind must be LENGTH or ANGLE")
    if not {"rate_hz", "period_s"} <= {each.name for each in dataclasses.fields(model)}:
        raise ValueError("the model lacks rate_hz or period_s")


def _c_function(prototype: str, request: str, names: Sequence[str]) -> str:
    lines = [
        "#include <crs/device.h>",
        "",
        prototype,
        "{",
        "    struct __crs_message message;",
        "",
        f"    if (!__crs_ask_device(CRS_{request}, &message, 0, 0, 0, 0))",
        "        return 0;",
        *(f"    *{name} = message.i[{place}];" for place, name in enumerate(names)),
        "    return 1;",
        "}",
        "",
    ]
    return "\n".join(lines)
