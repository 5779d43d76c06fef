"""When `crs debug` shows the full-screen interface, and its start and end on a terminal."""

from __future__ import annotations

import os
import select
import sys
import time
from pathlib import Path

import click
import pytest

from crs_cc.cli import full_screen
from crs_cc.cli.debug import read_options
from crs_cc.cli.main import main
from tests.debug.debuggers import ROOT

PROGRAM = str(ROOT / "samples" / "scout_c" / "square.c")


@pytest.fixture
def terminal(monkeypatch: pytest.MonkeyPatch) -> pytest.MonkeyPatch:
    monkeypatch.setattr(full_screen, "_is_terminal", lambda: True)
    monkeypatch.setenv("TERM", "xterm")
    return monkeypatch


def test_it_is_the_default_on_a_terminal(terminal: pytest.MonkeyPatch) -> None:
    assert full_screen.is_wanted(read_options([PROGRAM]))
    assert full_screen.is_wanted(read_options(["--tui", PROGRAM]))
    assert not full_screen.is_wanted(read_options(["--repl", PROGRAM]))
    assert not full_screen.is_wanted(read_options(["--batch", PROGRAM]))
    with pytest.raises(click.UsageError, match="mutually exclusive"):
        full_screen.is_wanted(read_options(["--batch", "--tui", PROGRAM]))


def test_without_a_terminal_there_is_no_message(capsys: pytest.CaptureFixture[str]) -> None:
    assert not full_screen.is_wanted(read_options([PROGRAM]))
    assert capsys.readouterr().err == ""
    with pytest.raises(click.UsageError, match="not a terminal"):
        full_screen.is_wanted(read_options(["--tui", PROGRAM]))
    assert main(["debug", "--tui", PROGRAM]) == 2
    assert "Traceback" not in capsys.readouterr().err


def test_a_line_explains_why_it_is_not_shown(
    terminal: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    terminal.setenv("TERM", "dumb")
    assert not full_screen.is_wanted(read_options([PROGRAM]))
    expected = "crs: no full-screen interface: the terminal does not support it; using the prompt\n"
    assert capsys.readouterr().err == expected
    terminal.setenv("TERM", "xterm")
    terminal.setattr(full_screen, "find_spec", lambda _name: None)
    assert not full_screen.is_wanted(read_options([PROGRAM]))
    assert "textual is not installed" in capsys.readouterr().err


@pytest.mark.skipif(sys.platform == "win32", reason="needs a pseudo-terminal")
def test_it_starts_on_a_terminal_and_restores_it(tmp_path: Path) -> None:
    import pty

    child, master = pty.fork()
    if child == 0:
        os.environ["TERM"] = "xterm-256color"
        os.chdir(ROOT)
        arguments = ["-m", "crs_cc", "debug", "--files", str(tmp_path), PROGRAM]
        os.execv(sys.executable, [sys.executable, *arguments])
    shown = b""
    sent = False
    deadline = time.monotonic() + 60.0
    while time.monotonic() < deadline:
        ready, _, _ = select.select([master], [], [], 1.0)
        try:
            shown += os.read(master, 65536) if ready else b""
        except OSError:  # the other end is closed
            break
        if not sent and b"square.c:46" in shown:
            os.write(master, b"\x11")  # Ctrl-Q
            sent = True
    os.close(master)
    _, status = os.waitpid(child, 0)
    assert sent, shown[-2000:]
    assert os.waitstatus_to_exitcode(status) == 0
    assert shown.rindex(b"\x1b[?1049l") > shown.rindex(b"square.c:46")  # back on the usual screen
