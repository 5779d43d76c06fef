"""`crs debug --repl` on a terminal of its own, as a user types."""

from __future__ import annotations

import os
import pty
import select
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.processes import wait_until_it_waits

ENDLESS = """#include <stdio.h>
int rounds;
int main(void)
{
    char word[9];
    fputs("a word? ", stderr);
    if (scanf("%8s", word) == 1)
        printf("<%s>\\n", word);
    for (;;)
        if (rounds++ == 1000)
            fputs("on its way\\n", stderr);
}
"""
TIMEOUT_S = 60.0


class Session:
    """A process on a terminal."""

    def __init__(self, program: Path) -> None:
        self._own, theirs = pty.openpty()
        command = [sys.executable, "-m", "crs_cc", "debug", "--repl", str(program)]
        environment = {**os.environ, "TERM": "dumb"}
        self._process = subprocess.Popen(
            command, stdin=theirs, stdout=theirs, stderr=theirs, env=environment,
            start_new_session=True, preexec_fn=self._control,  # noqa: PLW1509 - threads are over here
        )  # fmt: skip
        os.close(theirs)
        self._text = ""

    @staticmethod
    def _control() -> None:
        import fcntl
        import termios

        fcntl.ioctl(0, termios.TIOCSCTTY, 0)

    def type(self, text: str) -> None:
        """Types, as by hand."""
        os.write(self._own, text.encode())

    def wait_for(self, wanted: str) -> str:
        """Return what is shown up to some words, and forgets it."""
        end = time.monotonic() + TIMEOUT_S
        while wanted not in self._text:
            if not select.select([self._own], [], [], max(0.0, end - time.monotonic()))[0]:
                pytest.fail(f"{wanted!r} is not shown, but {self._text!r}")
            self._text += os.read(self._own, 65536).decode()
        before, _, self._text = self._text.partition(wanted)
        return before + wanted

    def wait_until_it_waits(self) -> None:
        """Return when the process waits for what is typed."""
        wait_until_it_waits(self._process.pid)

    def end(self) -> int:
        """Return the exit status."""
        return self._process.wait(TIMEOUT_S)

    def kill(self) -> None:
        """End it whatever it does."""
        self._process.kill()
        self._process.wait()
        os.close(self._own)


@pytest.fixture
def session(tmp_path: Path) -> Iterator[Session]:
    program = tmp_path / "endless.c"
    program.write_text(ENDLESS)
    session = Session(program)
    yield session
    session.kill()


def test_terminal_session_with_completion_input_and_interrupt(session: Session) -> None:
    session.wait_for("(crs) ")
    session.type("next 2\r")
    session.wait_for("a word? ")
    session.type("hello\r")
    session.wait_for("=>    8")
    session.type("\r")  # again
    assert "<hello>" in session.wait_for("=>   10")
    session.wait_for("(crs) ")
    session.type("print roun\t\r")
    session.wait_for("$1 = ")
    session.wait_for("(crs) ")
    session.wait_until_it_waits()  # before that, Ctrl-C is not the prompt's
    session.type("contin\x03")
    session.wait_for('Type "quit" or Ctrl-D to end the debugger.')
    session.wait_for("(crs) ")
    session.type("continue\r")
    session.wait_for("continue\r\n")
    session.wait_for("on its way")
    session.type("\x03")
    session.wait_for("Interrupted.")
    session.wait_for("(crs) ")
    session.type("print rounds > 0\r")
    session.wait_for("$2 = 1")
    session.wait_for("(crs) ")
    session.type("\x04")
    assert session.end() == 0


def test_ctrl_c_ends_the_input_of_a_waiting_program(session: Session) -> None:
    session.wait_for("(crs) ")
    session.type("next 2\r")
    session.wait_for("a word? ")
    session.wait_until_it_waits()
    session.type("\x03")
    session.wait_for("Interrupted.")
    session.wait_for("(crs) ")
    session.type("next\r")
    session.wait_for("=>   10")
    session.wait_for("(crs) ")
    session.type("quit\r")
    assert session.end() == 0
