"""Functions and files that `step` does not enter."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from crs_cc.debug.errors import DebugError
from crs_cc.debug.locations import is_file
from crs_cc.debug.step_conditions import ActiveCalls
from crs_cc.ir.names import plain_name
from crs_cc.runtime.diagnosis.inspect import StackFrame


@dataclass(slots=True)
class Skip:
    """A function or a file that is skipped.

    Attributes:
        number: its number.
        function: its name; empty for all functions of the file.
        file: the file; empty for any.
        enabled: whether it counts.
    """

    number: int
    function: str = ""
    file: str = ""
    enabled: bool = True

    def covers(self, call: StackFrame) -> bool:
        """Return whether a call is to be skipped."""
        return (not self.function or plain_name(call.function) == self.function) and (
            not self.file or is_file(call.location.file, self.file)
        )


class Skips:
    """All that is skipped."""

    def __init__(self) -> None:
        self._rows: dict[int, Skip] = {}
        self._last = 0

    def __iter__(self) -> Iterator[Skip]:
        return iter(self._rows.values())

    def add(self, function: str = "", file: str = "") -> Skip:
        """Skip a function, or all functions of a file."""
        self._last += 1
        self._rows[self._last] = made = Skip(self._last, function, file)
        return made

    def get(self, number: int) -> Skip:
        """Return one by its number; raise DebugError if it does not exist."""
        if number not in self._rows:
            raise DebugError(f"no skip number {number}")
        return self._rows[number]

    def remove(self, number: int) -> None:
        """Skip something no longer; raise DebugError if it is not skipped."""
        del self._rows[self.get(number).number]

    def cover(self, stack: Iterable[StackFrame], active: ActiveCalls) -> bool:
        """Return whether a program is inside of a call that is skipped.

        Args:
            stack: the calls of the program, the innermost first.
            active: those that it was in when the step began, which count for nothing.
        """
        wanted = [each for each in self if each.enabled]
        if not wanted:
            return False
        new = (call for call in stack if (call.fp, call.entered) not in active.frames)
        return any(each.covers(call) for call in new for each in wanted)
