"""Standard input: commands, and lines that programs read."""

from __future__ import annotations

import signal
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType
from typing import Final

from crs_cc.debug.commands.answer import Line
from crs_cc.debug.commands.completion import complete, ended
from crs_cc.debug.commands.shell import Shell
from crs_cc.debug.commands.user_session import UserSession
from crs_cc.debug.repl.terminal import Terminal

_DELIMITERS: Final = " \t\n!@#$%^&*()=+[{]}|;'\",<>?"


def _ignore() -> None:
    """Ignore Ctrl-C while nothing runs."""


class Keyboard:
    """Standard input.

    Attributes:
        is_typed: whether it is a terminal.
    """

    def __init__(self, terminal: Terminal) -> None:
        """Store the terminal, so that prompts and output do not mix."""
        self.is_typed = sys.stdin is not None and not sys.stdin.closed and sys.stdin.isatty()
        self._interrupt: Callable[[], None] = _ignore
        self._terminal = terminal
        self._is_asking = False

    def command(self, prompt: str) -> str | None:
        """Prompt for a command; return None at the end of input. Ctrl-C discards the line."""
        self._terminal.finish_lines()
        while True:
            try:
                with self._asking():
                    return self._typed(prompt) if self.is_typed else self._piped(prompt)
            except KeyboardInterrupt:
                self._terminal.broken()
                self._terminal.line(Line('Type "quit" or Ctrl-D to end the debugger.'))

    def read(self, _robot: int, wanted: int) -> bytes:
        """Read input for a program: at most `wanted` bytes, at most one line.

        Ctrl-C ends the input, and the program stops after that.
        """
        self._terminal.finish_lines()
        if sys.stdin is None or sys.stdin.closed:
            return b""
        try:
            with self._asking():
                return sys.stdin.buffer.readline(wanted)
        except KeyboardInterrupt:
            self._terminal.broken()
            self._interrupt()
            return b""

    @contextmanager
    def listening(self, interrupt: Callable[[], None]) -> Iterator[None]:
        """Make Ctrl-C end a prompt, or interrupt the programs.

        Args:
            interrupt: called on Ctrl-C while the programs run.
        """
        self._interrupt = interrupt
        try:
            with self._handling_signals():
                yield
        finally:
            self._interrupt = _ignore

    @contextmanager
    def _handling_signals(self) -> Iterator[None]:
        if threading.current_thread() is not threading.main_thread():
            yield
            return
        before = signal.signal(signal.SIGINT, self._handle_signal)
        try:
            yield
        finally:
            signal.signal(signal.SIGINT, before)

    def _handle_signal(self, _signal: int, _frame: FrameType | None) -> None:
        if self._is_asking:
            raise KeyboardInterrupt
        self._interrupt()

    @contextmanager
    def _asking(self) -> Iterator[None]:
        self._is_asking = True
        try:
            yield
        finally:
            self._is_asking = False

    def _typed(self, prompt: str) -> str | None:
        try:
            return input(prompt)
        except EOFError:
            self._terminal.broken()
            return None

    def _piped(self, prompt: str) -> str | None:
        line = sys.stdin.buffer.readline() if sys.stdin is not None else b""
        if not line:
            return None
        text = line.decode(errors="replace").rstrip("\r\n")
        self._terminal.echo(prompt, text)
        return text


def offer_completion(shell: Shell) -> None:
    """Enable completion by the tab key, if Python has `readline`."""
    try:
        import readline
    except ImportError:
        return
    readline.set_completer(completer(shell, readline.get_line_buffer))
    readline.set_completer_delims(_DELIMITERS)
    readline.parse_and_bind("tab: complete")


@contextmanager
def line_history(session: UserSession) -> Iterator[None]:
    """Offer the commands of earlier sessions, if Python has `readline`, and keep those of this."""
    try:
        import readline
    except ImportError:
        yield
        return
    readline.clear_history()
    for each in session.commands:
        readline.add_history(each)
    known = readline.get_current_history_length()
    try:
        yield
    finally:
        new = range(known + 1, readline.get_current_history_length() + 1)
        session.keep_commands([readline.get_history_item(number) for number in new])


def completer(shell: Shell, line: Callable[[], str]) -> Callable[[str, int], str | None]:
    """Return readline's completer function."""
    found: list[str] = []

    def give(word: str, number: int) -> str | None:
        if number == 0:
            text = line()
            completion = complete(shell.context, text)
            skipped = len(text) - len(word) - completion.start  # readline splits words elsewhere
            found[:] = [each[max(0, skipped) :] for each in completion.words]
            if len(found) == 1:
                found[0] = ended(found[0])
        return found[number] if number < len(found) else None

    return give
