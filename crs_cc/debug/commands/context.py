"""The context of commands: the debugger, and the state of the command line between commands."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Final

from crs_cc.debug.commands.answer import Answer
from crs_cc.debug.commands.arguments import OutputFormat
from crs_cc.debug.commands.display import Display
from crs_cc.debug.commands.settings import Settings
from crs_cc.debug.commands.stop_text import Selection, selection, stop_lines
from crs_cc.debug.data.memory_inspection import FULL
from crs_cc.debug.data.values import Value
from crs_cc.debug.errors import DebugError
from crs_cc.debug.stop import Stop
from crs_cc.debug.timeline.position import Position
from crs_cc.ir.types import CHAR, INT, LLONG, SHORT, PointerType

if TYPE_CHECKING:
    from crs_cc.debug.engine import Debugger


_UNITS: Final = {1: CHAR, 2: SHORT, 4: INT, 8: LLONG}
"""The types of the units that `x` examines, by size [bytes]."""


@dataclass(frozen=True, slots=True)
class Listing:
    """The lines that `list` showed last.

    Attributes:
        file: their file.
        first: the first line.
        last: the last line.
        is_found: whether it is a line that a search has found, which `list` shows in the middle.
    """

    file: str
    first: int
    last: int
    is_found: bool = False


@dataclass(frozen=True, slots=True)
class ListedInstant:
    """An instant of a list, to which `goto @3` goes.

    Attributes:
        robot: the robot that is selected there; -1 for none.
        function: the function whose frame is selected, by the linker's name; empty for the
            innermost. A call at the end of a statement has another one.
    """

    position: Position
    robot: int = -1
    function: str = ""


@dataclass(slots=True)
class CommandInput:
    """Commands of breakpoints that are being entered."""

    breakpoints: list[int]
    lines: list[str] = field(default_factory=list)


class CommandContext:
    """The state of a command line.

    Attributes:
        displays: by number, the expressions that are shown at every stop.
        scripts: by breakpoint, the commands that are executed when it is hit.
        due: the commands of the breakpoints that were hit last, not executed yet.
        input: the commands that are being entered for breakpoints; None for none.
        listing: what `list` showed last; None since the last stop.
        examined: the address at which `x` continues, and in which format; None for none.
        instants: the instants of the last list, see `past`.
        has_ended: whether the user has quit.
        depth: how many scripts are being read inside each other.
        settings: the values of the settings.
        value_count: how many values have been printed.
        shown_value: the number of the value that `show values` showed last.
    """

    def __init__(self, debugger: Debugger) -> None:
        self.debugger = debugger
        self.displays: dict[int, Display] = {}
        self.scripts: dict[int, tuple[str, ...]] = {}
        self.due: list[str] = []
        self.input: CommandInput | None = None
        self.listing: Listing | None = None
        self.examined: tuple[int, OutputFormat] | None = None
        self.instants: list[ListedInstant] = []
        self.has_ended = False
        self.depth = 0
        self.settings = Settings()
        debugger.view.settings = self.settings.values
        self.value_count = 0
        self.shown_value = 0
        self._selection: Selection | None = None

    def move(self, go: Callable[[], Stop]) -> Answer:
        """Move the run; answer with the reason and the location of the stop."""
        known = {each.number: each for each in self.debugger.stop_points.breakpoints}
        stop = go()
        self.listing = None
        self.due = [line for number in stop.breakpoints for line in self.scripts.get(number, ())]
        now = selection(self.debugger)
        self._keep_exit_status()
        if "silent" in self.due[:1]:
            del self.due[0]
        else:
            yield from stop_lines(self.debugger, stop, known, self._selection)
            yield from self.show_displays()
        self._selection = now

    def apply_settings(self) -> None:
        """Pass on the settings that are not asked for by commands."""
        elements, is_pretty = self.settings["print elements"], bool(self.settings["print pretty"])
        style = replace(FULL, most_elements=elements, is_pretty=is_pretty)
        self.debugger.view.full_style = style

    def show_selection(self) -> Answer:
        """Answer with the frame that the user has selected."""
        self.listing = None
        self._selection = selection(self.debugger)
        yield from self._selection.lines(self.debugger)

    def show_displays(self) -> Answer:
        """Show every display; leave out those that have no value here."""
        for number, display in self.displays.items():
            if not display.is_enabled:
                continue
            try:
                yield f"{number}: {display.text(self.debugger)}"
            except DebugError:
                continue

    def keep_examined(self, address: int, size: int) -> None:
        """Set `$_` to the address of the last unit examined, and `$__` to its content."""
        view = self.debugger.view
        inspector = view.evaluator(view.robot).inspector()
        kept, unit = view.convenience_values, _UNITS[size]
        kept["_"] = Value(inspector, PointerType(unit), address.to_bytes(4, "little"))
        kept["__"] = inspector.value(address, unit)

    def _keep_exit_status(self) -> None:
        """Set `$_exitcode` to the exit status of the selected program, if it has ended."""
        view = self.debugger.view
        status = view.session.exit_status(view.robot)
        view.convenience_values.pop("_exitcode", None)
        if status is not None:
            self.keep_number("_exitcode", status)

    def keep_number(self, name: str, number: int) -> None:
        """Set a convenience variable to a number."""
        view = self.debugger.view
        inspector = view.evaluator(view.robot).inspector()
        content = number.to_bytes(4, "little", signed=True)
        view.convenience_values[name] = Value(inspector, INT, content)

    def record(self, value: Value) -> int:
        """Append a value to the value history; return its number there."""
        self.value_count += 1
        saved = self.debugger.view.convenience_values
        saved[""] = saved[str(self.value_count)] = value
        return self.value_count
