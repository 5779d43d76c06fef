"""The world and the other robots' programs of a run, as used by expressions."""

from __future__ import annotations

import struct
from collections.abc import Hashable, Sequence
from typing import Final, Protocol

from crs_cc.core.suggest import unknown
from crs_cc.debug.data.evaluate import Evaluator
from crs_cc.debug.data.notation import ExternalName, RobotName, WorldDistance, WorldName
from crs_cc.debug.data.values import Value, ValueReader
from crs_cc.debug.errors import DebugError
from crs_cc.debug.world.world_values import (
    WORLD_VALUES,
    WorldValue,
    distance_m,
    object_number,
    values_of,
)
from crs_cc.ir.types import DOUBLE, CType, Member, Record, RecordType
from crs_cc.runtime.diagnosis.inspect import StackFrame
from crs_cc.session.session import Session

_FORMATS: Final = {4: "<i", 8: "<d"}


class StoppedRun(Protocol):
    """A stopped run with all its programs."""

    @property
    def session(self) -> Session:
        """The session; read only."""

    @property
    def names(self) -> tuple[str, ...]:
        """The robots' names, by number."""

    def active_frame(self, robot: int, frame: int | None = None) -> StackFrame | None:
        """Return a frame of a program by number; None if it has none."""

    def first_own_frame(self, robot: int) -> int:
        """Return the number of the innermost frame of the user's own code."""

    def evaluator(self, robot: int) -> Evaluator:
        """Return the evaluator of a robot's program."""

    def evaluate_pure(self, text: str, *, robot: int, frame: int) -> Value:
        """Evaluate a C expression without side effects; raise DebugError if it is invalid."""


class RunValues:
    """The world and the other robots, for the expressions of one robot's program."""

    def __init__(self, run: StoppedRun, robot: int) -> None:
        self._run = run
        self._robot = robot

    def is_robot(self, name: str) -> bool:
        """Return whether there is a robot of that name."""
        return name in self._run.names

    def is_object(self, name: str) -> bool:
        """Return whether the world has a robot or an object of that name."""
        return name in self._run.session.environment.names

    def state(self, name: ExternalName) -> Hashable:
        """Return the state on which the type of a value depends."""
        if not isinstance(name, RobotName):
            return self._run.session.environment.names
        robot = self._run.names.index(name.robot) if self.is_robot(name.robot) else -1
        number = self._run.first_own_frame(robot) if robot >= 0 else 0
        frame = self._run.active_frame(robot, number) if robot >= 0 else None
        return robot, None if frame is None else (frame.function, frame.location)

    def value(self, name: ExternalName) -> Value:
        """Return a value.

        Raises:
            DebugError: it does not exist or cannot be read.
        """
        match name:
            case RobotName():
                return self._of_robot(name)
            case WorldDistance():
                environment = self._run.session.environment
                return self._number(DOUBLE, distance_m(environment, name.one, name.other))
        return self._of_world(name)

    def _of_robot(self, name: RobotName) -> Value:
        if not self.is_robot(name.robot):
            raise DebugError(unknown("robot", name.robot, self._run.names))
        robot = self._run.names.index(name.robot)
        try:
            frame = self._run.first_own_frame(robot)
            return self._run.evaluate_pure(name.text, robot=robot, frame=frame)
        except DebugError as wrong:
            raise DebugError(f"{name.robot}: {wrong}") from None

    def _of_world(self, name: WorldName) -> Value:
        environment = self._run.session.environment
        match name.path:
            case (obj, value_name):
                number = object_number(environment, obj)
                rows = values_of(environment, number)
                return self._scalar(_row(rows, value_name, f"value of {obj}"), number)
            case (value_name,) if self.is_object(value_name):
                number = object_number(environment, value_name)
                return self._all(values_of(environment, number), number)
            case (value_name,):
                return self._scalar(_row(WORLD_VALUES, value_name, "robot, object or value"), 0)
        return self._all(WORLD_VALUES, 0)

    def _scalar(self, row: WorldValue, number: int) -> Value:
        """Return one value of the world."""
        return self._number(row.type, row.read(self._run.session.environment, number))

    def _all(self, rows: Sequence[WorldValue], number: int) -> Value:
        """Return all values of an object as a struct."""
        record = Record("struct")
        record.complete(Member(row.name, row.type) for row in rows)
        content = bytearray(record.size)
        for row, member in zip(rows, record.members or (), strict=True):
            part = self._scalar(row, number).content
            content[member.offset : member.offset + len(part)] = part
        return Value(self._reader(), RecordType(record), bytes(content))

    def _number(self, ctype: CType, number: float) -> Value:
        is_whole = ctype.size == 4
        content = struct.pack(_FORMATS[ctype.size], int(number) if is_whole else float(number))
        return Value(self._reader(), ctype, content)

    def _reader(self) -> ValueReader:
        return self._run.evaluator(self._robot).inspector()


def _row(rows: Sequence[WorldValue], name: str, what: str) -> WorldValue:
    """Return the row of a name; raise DebugError if there is none."""
    for row in rows:
        if row.name == name:
            return row
    raise DebugError(unknown(what, name, [row.name for row in rows]))


def mentions_world(text: str, names: Sequence[str]) -> bool:
    """Return whether an expression may use the world; names of objects may also be C's.

    >>> mentions_world("$world.time > 3", []), mentions_world("distance(bin, r1)", ["r1"])
    (True, True)
    >>> mentions_world("speed > 3", ["r1"])
    False
    """
    return "$world" in text or any(name in text for name in names)
