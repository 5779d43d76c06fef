"""The fields of the vendor's `State[]`, with names and units.

Names and units are those of the vendor's table; if the CRS report has others, a
program in its dialect uses these (`robot_api.report`).

>>> fields = state_fields("nomad")
>>> fields[17].name, fields[17].text(48), fields[17].text(255), fields[38].name
('STATE_SONAR_0', '48 in = 1.219 m', 'no echo', 'STATE_VEL_RIGHT')
>>> state_fields("report")[17].text(480), state_fields("nomad", synchro=True)[39].text(-450)
('480 0.1in = 1.219 m', '-450 0.1deg/s = -45.0 deg/s')
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Final, Literal

from crs_cc.core.units import inch_to_m, tenths_deg_to_rad, tenths_inch_to_m
from crs_cc.debug.world.rows import angle, length
from crs_cc.robot_api import STATE

Dialect = Literal["nomad", "report"]

_UNIT: Final = re.compile(r"\[(.+?)\]")
_NAME: Final = re.compile(r"(\w+?)(\d*) \.\. \1(\d+)")
_DIFFERENTIAL: Final = {"STATE_VEL_RIGHT", "STATE_VEL_LEFT"}
_SYNCHRO: Final = {"STATE_VEL_TRANS", "STATE_VEL_STEER"}
_NO_ECHO: Final = 255
_NOTHING_NEAR: Final = 15
_NO_REPLY: Final = 111


@dataclass(frozen=True, slots=True)
class StateField:
    """A field of `State[]`.

    Attributes:
        name: the constant of the index.
        unit: its unit, empty for none.
        nothing: the sentinel for no measurement; None if there is none.
        word: the meaning of the sentinel.
        bits: whether it is a bit mask.
        meaning: its description.
    """

    index: int
    name: str
    unit: str = ""
    nothing: int | None = None
    word: str = ""
    bits: bool = False
    meaning: str = ""

    def text(self, value: int) -> str:
        """Return a formatted value: with its unit, and in metres or degrees."""
        if self.nothing is not None and value == self.nothing:
            return self.word
        if self.bits:
            set_ = [str(bit) for bit in range(32) if value >> bit & 1]
            return f"bit{'s' * (len(set_) > 1)} {', '.join(set_)}" if set_ else "none"
        base, _, per = self.unit.partition("/")
        per = f"/{per}" if per else ""
        unit = self.unit.replace(" ", "")
        if base == "in":
            return f"{value} {unit} = {length(inch_to_m(float(value)))}{per}"
        if base == "0.1 in":
            return f"{value} {unit} = {length(tenths_inch_to_m(float(value)))}{per}"
        if base == "0.1 deg":
            return f"{value} {unit} = {angle(tenths_deg_to_rad(float(value)))}{per}"
        return str(value)


@lru_cache(maxsize=4)
def state_fields(dialect: Dialect, *, synchro: bool = False) -> tuple[StateField, ...]:
    """Return the fields of `State[]` by index.

    Args:
        dialect: the vendor's, or that of the CRS report.
        synchro: whether the robot has a synchro drive, for which some names differ.
    """
    hidden = _DIFFERENTIAL if synchro else _SYNCHRO
    fields = {each.index: _special(each) for each in _fields() if each.name not in hidden}
    if dialect == "report":
        for index, each in fields.items():
            if "SONAR" in each.name:
                fields[index] = replace(each, unit="0.1 in", nothing=-1)
            if each.name == "STATE_BUMPER":
                fields[index] = replace(each, bits=False, nothing=0, word="touches nothing")
        heat = max(fields) + 1
        fields[heat] = StateField(heat, "STATE_HEAT", meaning="the heat in range, a whole number")
    return tuple(fields[index] for index in sorted(fields))


def _fields() -> Iterator[StateField]:
    """Return the rows of the vendor's table; some indices have two names."""
    for row in STATE:
        unit = _UNIT.search(row.meaning)
        first, series = int(row.value), _NAME.fullmatch(row.name)
        names = [row.name]
        if series is not None:
            names = [f"{series[1]}{n}" for n in range(int(series[2]), int(series[3]) + 1)]
        for place, name in enumerate(names):
            yield StateField(first + place, name, unit[1] if unit else "", meaning=row.meaning)


def _special(each: StateField) -> StateField:
    """Return a field with its sentinel, and whether it is a bit mask."""
    if "SONAR" in each.name:
        return replace(each, nothing=_NO_ECHO, word="no echo")
    if "_IR_" in each.name:
        return replace(each, nothing=_NOTHING_NEAR, word="nothing near")
    if each.name == "STATE_ERROR":
        return replace(each, nothing=_NO_REPLY, word="no reply")
    return replace(each, bits=each.name in {"STATE_BUMPER", "STATE_MOTOR_STATUS"})
