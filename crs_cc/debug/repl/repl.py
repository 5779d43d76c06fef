"""The prompt: commands from scripts and from the user, and their answers."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from crs_cc.debug.commands.answer import Line
from crs_cc.debug.commands.scripts import read_script
from crs_cc.debug.commands.shell import Shell
from crs_cc.debug.commands.user_session import UserSession
from crs_cc.debug.engine import Debugger
from crs_cc.debug.errors import DebugError
from crs_cc.debug.repl.keyboard import Keyboard, line_history, offer_completion
from crs_cc.debug.repl.terminal import Terminal


@dataclass(frozen=True, slots=True)
class Scripts:
    """Commands to execute before the prompt.

    Attributes:
        files: scripts.
        commands: further commands.
    """

    files: Sequence[Path] = ()
    commands: Sequence[str] = ()

    def lines(self) -> Iterator[str]:
        """Return their lines; an empty one does not repeat the one before it.

        Raises:
            DebugError: a file cannot be read.
        """
        for path in self.files:
            yield from (line or "#" for line in read_script(path))
        yield from self.commands


class Repl:
    """A debugger with a prompt.

    Attributes:
        shell: its command line.
    """

    def __init__(self, debugger: Debugger, terminal: Terminal, keyboard: Keyboard) -> None:
        self.shell = Shell(debugger)
        self._terminal = terminal
        self._keyboard = keyboard
        self._interrupted = False
        debugger.stop_points.print_log = lambda text: terminal.line(Line(text, "log"))

    def run(self, scripts: Scripts, *, batch: bool = False) -> int:
        """Execute scripts, then the user's commands; return how many have failed."""
        with self._keyboard.listening(self._interrupt):
            is_at_terminal = self._keyboard.is_typed and not batch
            user = UserSession(self.shell.context) if is_at_terminal else None
            for text in user.load_settings() if user else ():
                self._terminal.line(Line(text, "error"))
            for line in self.shell.greet():
                self._terminal.line(line)
            self._script(scripts)
            if user is not None:
                offer_completion(self.shell)
                user.keep_settings()
                with line_history(user):
                    self._converse()
            elif not batch:
                self._converse()
        self._terminal.finish_lines()
        return self.shell.failures

    def _script(self, scripts: Scripts) -> None:
        try:
            for text in scripts.lines():
                if self.shell.has_ended or self._interrupted:
                    break
                if text != "#":
                    self._terminal.echo(self.shell.prompt, text)
                self._execute(text)
        except DebugError as error:
            self._refuse(str(error))
        if self._interrupted:
            self._refuse("script interrupted")

    def _refuse(self, text: str) -> None:
        self.shell.failures += 1
        self._terminal.line(Line(text, "error"))

    def _converse(self) -> None:
        while not self.shell.has_ended:
            text = self._keyboard.command(self.shell.prompt)
            if text is None:
                return
            self._execute(text)

    def _interrupt(self) -> None:
        """Interrupt the programs and the current script."""
        self._interrupted = True
        self.shell.debugger.interrupt()

    def _execute(self, text: str) -> None:
        self.shell.debugger.forget_interrupt()  # one that arrived too late for the previous command
        for line in self.shell.execute(text):
            self._terminal.line(line)
