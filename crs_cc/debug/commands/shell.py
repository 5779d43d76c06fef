"""A command line over a debugger: executes lines and answers with lines.

It is independent of any screen. A screen passes on what the user types, and shows the answer as it
comes: what programs print while a command runs goes its own way, so that both appear in order.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Final

from crs_cc.debug.commands.answer import Answer, Line, NestedCommand, SourceLine
from crs_cc.debug.commands.arguments import reject_arguments
from crs_cc.debug.commands.command import Command
from crs_cc.debug.commands.context import CommandContext, CommandInput
from crs_cc.debug.commands.gdb_names import unsupported_reason
from crs_cc.debug.commands.table import UndefinedCommandError, find
from crs_cc.debug.errors import DebugError

if TYPE_CHECKING:
    from crs_cc.debug.engine import Debugger

PROMPT: Final = "(crs) "
_CONTINUATION_PROMPT: Final = ">"


class Shell:
    """A command line.

    Attributes:
        context: the state that commands share.
        failures: how many commands have failed.
    """

    def __init__(self, debugger: Debugger, check: Callable[[Command], None] | None = None) -> None:
        """Store the debugger.

        Args:
            debugger: the debugger.
            check: raises DebugError for commands that must not be executed, those that others
                execute and those of breakpoints included.
        """
        self.context = CommandContext(debugger)
        self._check = check
        self.failures = 0
        self._repeated = ""

    @property
    def debugger(self) -> Debugger:
        """The debugger."""
        return self.context.debugger

    @property
    def has_ended(self) -> bool:
        """Whether the user has quit."""
        return self.context.has_ended

    @property
    def prompt(self) -> str:
        """The prompt for the next line."""
        return _CONTINUATION_PROMPT if self.is_collecting else PROMPT

    @property
    def is_collecting(self) -> bool:
        """Whether the next line is one of a breakpoint's commands, regardless of its text."""
        return self.context.input is not None

    def execute(self, text: str) -> Iterator[Line | SourceLine]:
        """Execute a line; an empty one repeats the last command, if it can be repeated."""
        if self.context.input is not None:
            self._collect(self.context.input, text.strip())
            return
        text = text.strip() or self._repeated
        if text.startswith("#") or not text:
            return
        yield from self._run(text, by_user=True)
        while self.context.due and not self.has_ended:
            yield from self._run(self.context.due.pop(0))

    def greet(self) -> Iterator[Line | SourceLine]:
        """Move to the start of the run and answer with its location."""
        yield from self._lines(self.context.move(self.debugger.start))

    def _collect(self, entered: CommandInput, line: str) -> None:
        if line != "end":
            entered.lines.append(line)
            return
        for number in entered.breakpoints:
            self.context.scripts[number] = tuple(each for each in entered.lines if each)
        self.context.input = None

    def _run(self, text: str, *, by_user: bool = False) -> Iterator[Line | SourceLine]:
        try:
            command, arguments = _find(text)
            if self._check is not None:
                self._check(command)
            if by_user:
                self._repeated = _repeated(command, text)
            if not command.syntax:
                reject_arguments(arguments)
            yield from self._lines(command.run(self.context, arguments))
        except DebugError as error:
            yield from self._fail(str(error))
        except OSError:  # the system's: the reader may have closed the output
            raise
        except Exception as error:  # ours; what the user has done so far must not be lost
            wrong = " ".join(f"{type(error).__name__}: {error}".split())
            yield from self._fail(f"internal error: {wrong}; please report it")

    def _lines(self, answer: Answer) -> Iterator[Line | SourceLine]:
        """Return the lines of an answer; execute the commands in it."""
        for each in answer:
            if isinstance(each, str):
                yield from map(Line, each.split("\n"))
            elif isinstance(each, NestedCommand):
                yield from self.execute(each.text)
            else:
                yield each

    def _fail(self, text: str) -> Iterator[Line]:
        """Count a failed command, drop those that were due after it, and answer with its errors."""
        self.failures += 1
        self.context.due.clear()
        for each in dict.fromkeys(text.split("\n")):
            yield Line(each, "error")


def _find(text: str) -> tuple[Command, str]:
    """Return the command of a line, and its arguments; raise DebugError if there is none."""
    try:
        return find(text)
    except UndefinedCommandError:
        reason = unsupported_reason(text)
        if not reason:
            raise
        raise DebugError(reason) from None


def _repeated(command: Command, text: str) -> str:
    """Return the command that an empty line after a command repeats."""
    return {"": "", "same": text, "on": command.name}[command.repeats]
