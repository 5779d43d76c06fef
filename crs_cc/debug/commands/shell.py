"""A command line over a debugger: takes lines, answers with lines, and keeps what lies between.

It knows no screen. A screen hands over what the user types, and shows the answer as it comes: what
programs print while a command runs goes its own way, so that both appear in their order.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Final

from crs_cc.debug.commands.arguments import Format
from crs_cc.debug.commands.command import Answer, Command, Line, SourceLine
from crs_cc.debug.commands.display import Display
from crs_cc.debug.commands.listing import Listing
from crs_cc.debug.commands.stops import Standing, standing, stop_lines
from crs_cc.debug.commands.table import find
from crs_cc.debug.errors import DebugError

if TYPE_CHECKING:
    from crs_cc.debug.data.values import Value
    from crs_cc.debug.engine import Debugger
    from crs_cc.debug.stop import Stop

PROMPT: Final = "(crs) "
_MORE: Final = ">"


@dataclass(slots=True)
class _Collected:
    """Commands of breakpoints that are being typed in."""

    breakpoints: list[int]
    lines: list[str] = field(default_factory=list)


class Shell:
    """A command line.

    Attributes:
        debugger: what it is about.
        displays: by number, what is shown at every stop.
        scripts: by breakpoint, the commands that are done when it is hit.
        listing: what `list` showed last; None since the last stop.
        examined: the address where `x` goes on, and in which form; None for nowhere.
        has_ended: the user wants no more.
        failures: how many commands could not be done.
        depth: how many scripts are being read inside each other.
    """

    def __init__(self, debugger: Debugger) -> None:
        self.debugger = debugger
        self.displays: dict[int, Display] = {}
        self.scripts: dict[int, tuple[str, ...]] = {}
        self.listing: Listing | None = None
        self.examined: tuple[int, Format] | None = None
        self.has_ended = False
        self.failures = 0
        self.depth = 0
        self._values = 0
        self._again = ""
        self._due: list[str] = []
        self._collected: _Collected | None = None
        self._stood: Standing | None = None

    @property
    def prompt(self) -> str:
        """Gives what asks for the next line."""
        return _MORE if self.is_collecting else PROMPT

    @property
    def is_collecting(self) -> bool:
        """Tells whether the next line is one of a breakpoint's commands, whatever it says."""
        return self._collected is not None

    def execute(self, text: str) -> Iterator[Line | SourceLine]:
        """Does what a line says; an empty one does the last command again, if that makes sense."""
        if self._collected is not None:
            self._collect(text.strip())
            return
        text = text.strip() or self._again
        if text.startswith("#") or not text:
            return
        yield from self._perform(text, by_user=True)
        while self._due and not self.has_ended:
            yield from self._perform(self._due.pop(0))

    def greet(self) -> Iterator[Line | SourceLine]:
        """Goes to where the run begins, and says where that is."""
        yield from _as_lines(self.move(self.debugger.start))

    def move(self, go: Callable[[], Stop]) -> Answer:
        """Lets the run go somewhere else, and says why it stopped there."""
        known = {each.number: each for each in self.debugger.stop_points.breakpoints}
        stop = go()
        self.listing = None
        self._due = [line for number in stop.breakpoints for line in self.scripts.get(number, ())]
        now = standing(self.debugger)
        if "silent" in self._due[:1]:
            del self._due[0]
        else:
            yield from stop_lines(self.debugger, stop, known, self._stood)
            yield from self.show_displays()
        self._stood = now

    def look(self) -> Answer:
        """Says where the frame is that the user looks at, after he has chosen another one."""
        self.listing = None
        self._stood = standing(self.debugger)
        yield from self._stood.lines(self.debugger)

    def show_displays(self) -> Answer:
        """Shows every display, those that mean nothing here without a word."""
        for number, display in self.displays.items():
            try:
                yield f"{number}: {display.text(self.debugger)}"
            except DebugError:
                continue

    def keep(self, value: Value) -> int:
        """Lets a value be the last one, and gives the number by which it can be used, too."""
        self._values += 1
        self.debugger.view.kept[""] = self.debugger.view.kept[str(self._values)] = value
        return self._values

    def collect(self, breakpoints: list[int]) -> None:
        """Lets the next lines, up to `end`, be the commands of breakpoints."""
        self._collected = _Collected(breakpoints)

    def _collect(self, line: str) -> None:
        assert self._collected is not None
        if line != "end":
            self._collected.lines.append(line)
            return
        for number in self._collected.breakpoints:
            self.scripts[number] = tuple(each for each in self._collected.lines if each)
        self._collected = None

    def _perform(self, text: str, *, by_user: bool = False) -> Iterator[Line | SourceLine]:
        try:
            command, arguments = find(text)
            if by_user:
                self._again = _again(command, text)
            yield from _as_lines(command.run(self, arguments))
        except DebugError as error:
            yield self._refuse(str(error))
        except OSError:  # the system's: whoever read the output may have gone away
            raise
        except Exception as error:  # ours; what the user has done so far must not be lost
            wrong = " ".join(f"{type(error).__name__}: {error}".split())
            yield self._refuse(f"internal error: {wrong}; please report it")

    def _refuse(self, text: str) -> Line:
        """Takes note that a command could not be done."""
        self.failures += 1
        self._due.clear()
        return Line(text, "error")


def _again(command: Command, text: str) -> str:
    """Gives what an empty line after a command does."""
    return {"": "", "same": text, "on": command.name}[command.repeats]


def _as_lines(answer: Answer) -> Iterator[Line | SourceLine]:
    for each in answer:
        if isinstance(each, str):
            yield from map(Line, each.split("\n"))
        else:
            yield each
