"""Pheromone fields in low resolution, as fractions of the largest amount.

A sketch does not depend on earlier ones, so any time can be shown without them. Between two
sketches, a field evaporates as the earlier one states; the later one was recorded because something
else happened.

>>> amounts = np.array([[0.0, 2.0], [0.5, 4.0]])
>>> sketch = FieldSketch.made("trail", amounts, (0.0, 0.0), 0.1, 40.0)
>>> sketch.shares.tolist(), sketch.most
([[0, 128], [32, 255]], 4.0)
>>> again = FieldSketch.of(sketch.entry())
>>> again.shares.tolist(), round(again.maximum_after(40.0), 3)
([[0, 128], [32, 255]], 1.472)
"""

from __future__ import annotations

import math
from base64 import b64decode, b64encode
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final, Self

import numpy as np
import numpy.typing as npt

from crs_cc.recording import topics
from crs_cc.sim.kernels import exact
from crs_cc.sim.model.fields import MAX_FIELDS

if TYPE_CHECKING:
    from crs_cc.core.arrays import FloatArray
    from crs_cc.recording.recording import Recording
    from crs_cc.sim.engine.environment import Environment

MAX_SIDE: Final = 96
"""Squares along the longer side of the area. Chosen by us."""

TOLERANCE: Final = 0.01
"""A field is recorded again when an amount differs from the prediction by the last sketch by this
fraction of the largest amount. Chosen by us; it is hardly visible."""

FULL: Final = 255
"""The share of a square that has the largest amount."""

_MAX_NAME: Final = 1000  # characters of a name


@dataclass(frozen=True, slots=True)
class FieldSketch:
    """The contents of a field at a time.

    Attributes:
        name: the field.
        x_m: the lower left corner of the area.
        y_m: the same.
        square_m: side of a square.
        evaporation_s: the evaporation time from then on; infinite for none.
        most: the largest amount.
        shares: the largest amount in each square as a share of that, rounded up, 255 for all of
            it, (rows, columns); the first row is the one with the smallest y.
    """

    name: str
    x_m: float
    y_m: float
    square_m: float
    evaporation_s: float
    most: float
    shares: npt.NDArray[np.uint8]

    @classmethod
    def made(
        cls,
        name: str,
        amounts: FloatArray,
        corner_m: tuple[float, float],
        square_m: float,
        evaporation_s: float,
    ) -> Self:
        """Return the sketch of amounts, (rows, columns)."""
        most = float(amounts.max())
        shares = np.ceil(amounts * (FULL / most if most > 0.0 else 0.0)).astype(np.uint8)
        return cls(name, *corner_m, square_m, evaporation_s, float(f"{most:.6g}"), shares)

    @classmethod
    def of(cls, entry: Mapping[str, Any]) -> Self:
        """Return the sketch in an entry; raise ValueError or KeyError if it is not valid."""
        name, rows, columns = entry["field"], entry["rows"], entry["columns"]
        if not isinstance(name, str) or len(name) > _MAX_NAME:
            raise ValueError("a field has no valid name")
        if not all(type(each) is int and 0 < each <= MAX_SIDE for each in (rows, columns)):
            raise ValueError("a field has an invalid number of rows or columns")
        x_m, y_m, square_m, most = (
            _number(entry[each]) for each in ("x_m", "y_m", "square_m", "most")
        )
        evaporation_s = entry["evaporation_s"]
        evaporation_s = math.inf if evaporation_s is None else _number(evaporation_s)
        if square_m <= 0.0 or most < 0.0 or evaporation_s <= 0.0:
            raise ValueError("a field has invalid numbers")
        content = entry["shares"]
        if not isinstance(content, str) or len(content) > 2 * MAX_SIDE**2:
            raise ValueError("a field has no valid shares")
        shares = np.frombuffer(b64decode(content, validate=True), np.uint8)
        if len(shares) != rows * columns:
            raise ValueError("a field has the wrong number of shares")
        shares = shares.reshape(rows, columns)
        return cls(name, x_m, y_m, square_m, evaporation_s, most, shares)

    def entry(self) -> dict[str, Any]:
        """Return it as an entry of a message."""
        rows, columns = self.shares.shape
        return {
            "field": self.name,
            "x_m": self.x_m,
            "y_m": self.y_m,
            "square_m": self.square_m,
            "rows": rows,
            "columns": columns,
            "evaporation_s": self.evaporation_s if math.isfinite(self.evaporation_s) else None,
            "most": self.most,
            "shares": b64encode(self.shares.tobytes()).decode("ascii"),
        }

    def maximum_after(self, time_s: float) -> float:
        """Return the remaining fraction of the largest amount after a time [s]."""
        return self.most * exact.exp(-(time_s / self.evaporation_s))


def field_sketch(environment: Environment, field: int) -> tuple[FieldSketch, FloatArray]:
    """Return the sketch of a field as it is now, and the amounts in its squares."""
    world = environment.world
    name = world.fields[field].name
    amounts, square_m = environment.field_sketch(name, MAX_SIDE)
    corner_m = world.area.x_min_m, world.area.y_min_m
    evaporation_s = float(environment.state.fields.evaporation_s[field])
    return FieldSketch.made(name, amounts, corner_m, square_m, evaporation_s), amounts


@dataclass(slots=True)
class _RecordedField:
    """The last recorded state of a field.

    Attributes:
        time_s: when it was recorded [s].
        evaporation_s: its evaporation time at that time.
        amounts: the amounts in its squares at that time.
    """

    time_s: float
    evaporation_s: float
    amounts: FloatArray

    def predicts(self, time_s: float, evaporation_s: float, amounts: FloatArray) -> bool:
        """Return whether amounts are as predicted for a time."""
        if evaporation_s != self.evaporation_s or ((amounts > 0.0) != (self.amounts > 0.0)).any():
            return False
        expected = self.amounts * exact.exp(-((time_s - self.time_s) / evaporation_s))
        return bool(np.abs(amounts - expected).max() <= TOLERANCE * amounts.max())


class ChangedFields:
    """The changes of fields that are still to be recorded."""

    def __init__(self) -> None:
        """Start without any recorded field."""
        self._known: dict[int, _RecordedField] = {}

    def entries(self, environment: Environment) -> Iterator[dict[str, Any]]:
        """Yield entries for the fields that differ from their prediction."""
        time_s = environment.time_s
        for field in range(len(environment.world.fields)):
            sketch, amounts = field_sketch(environment, field)
            known = self._known.get(field)
            if known is None or not known.predicts(time_s, sketch.evaporation_s, amounts):
                self._known[field] = _RecordedField(time_s, sketch.evaporation_s, amounts)
                yield sketch.entry()


def sketches_in(recording: Recording) -> Iterator[tuple[int, FieldSketch]]:
    """Yield all sketches in a recording with their times [ns], each field in the order of time.

    Raises:
        RecordingError: one is not valid.
    """
    names: dict[str, None] = {}
    for time_ns, entry in recording.data(topics.FIELD.topic):
        with recording.errors():
            sketch = FieldSketch.of(entry)
            names[sketch.name] = None
            if len(names) > MAX_FIELDS:
                raise ValueError(f"there are more than {MAX_FIELDS} fields")
        yield time_ns, sketch


def _number(value: Any) -> float:
    """Return a finite number; raise ValueError if it is invalid."""
    if type(value) not in (int, float) or not math.isfinite(value):
        raise ValueError("a field has invalid numbers")
    return float(value)
