"""A line of the call stack in reports."""

from __future__ import annotations

from dataclasses import dataclass

from crs_cc.core.source import Location


@dataclass(frozen=True, slots=True)
class ActiveCall:
    """An active call, or several that are summarised.

    Attributes:
        function: its name; of several the names, empty if there are too many.
        arguments: names and values of its arguments; `...` without a value for variable ones.
        location: its location; None in the library, and for several.
        count: the number of calls represented.
    """

    function: str
    arguments: tuple[tuple[str, str], ...] = ()
    location: Location | None = None
    count: int = 1

    def __str__(self) -> str:
        if self.count > 1:
            return f"{self.count:,} more calls" + (f" to {self.function}" if self.function else "")
        arguments = ", ".join(
            f"{name}={value}" if value else name for name, value in self.arguments
        )
        return f"{self.function}({arguments})"
