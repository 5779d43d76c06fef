"""A command that a page can send: a row of the table, see `commands`."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Final

if TYPE_CHECKING:
    from crs_cc.workbench.context import Context

MAX_TEXT: Final = 4000

Field = type[float] | type[int] | type[str] | type[bool]


@dataclass(frozen=True, slots=True)
class Command:
    """A command.

    Attributes:
        name: its name.
        summary: what it does, in a line.
        run: carries it out, given the screen and the fields; returns the answer, as JSON.
        fields: the names and types of its fields.
        controls: whether it needs the token for control.
        needs: what the run must be able to do, one of its `can`; empty for nothing.
        asks: whether it changes nothing, so that other pages need not be notified.
        longest: the most characters of a field.
        at_once: whether it is executed in the server's thread, during the run: only what
            is thread-safe.
    """

    name: str
    summary: str
    run: Callable[..., Any]
    fields: Mapping[str, Field] = field(default_factory=dict)
    controls: bool = True
    needs: str = ""
    at_once: bool = False
    asks: bool = False
    longest: int = MAX_TEXT

    def arguments(self, given: Mapping[str, Any]) -> dict[str, Any]:
        """Return the fields of a command that a page has sent.

        Raises:
            ValueError: one is missing, or of another type.
        """
        return {
            name: _checked(name, given.get(name), kind, self.longest)
            for name, kind in self.fields.items()
        }

    def __call__(self, screen: Context, given: Mapping[str, Any]) -> Any:
        """Carry it out with fields of a page."""
        return self.run(screen, **self.arguments(given))


def _checked(name: str, value: Any, kind: Field, longest: int) -> Any:
    if kind is float and isinstance(value, int) and not isinstance(value, bool):
        value = float(value) if abs(value) < 2**53 else None
    if type(value) is not kind:
        raise ValueError(f"'{name}' must be a {kind.__name__}")
    if isinstance(value, float) and not math.isfinite(value):
        raise ValueError(f"'{name}' must be finite")
    if isinstance(value, str) and len(value) > longest:
        raise ValueError(f"'{name}' is longer than {longest} characters")
    return value
