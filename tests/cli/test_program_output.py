"""The control programs' output, and the progress line beside it."""

from __future__ import annotations

import io

import pytest

from crs_cc.cli.program_output import ProgramOutput, ProgressLine, read_line


class Terminal(io.BytesIO):
    def isatty(self) -> bool:
        return True


def test_one_robots_bytes_are_passed_through() -> None:
    out, err = io.BytesIO(), io.BytesIO()
    output = ProgramOutput(["robot0"], out, err, ProgressLine(None))
    output.write(0, 1, b"\x00\xff no newline")
    output.write(0, 2, b"oops\n")
    output.close()
    assert out.getvalue() == b"\x00\xff no newline"
    assert err.getvalue() == b"oops\n"


def test_lines_of_several_robots_are_never_mixed() -> None:
    out, err = io.BytesIO(), io.BytesIO()
    output = ProgramOutput(["a", "b"], out, err, ProgressLine(None))
    for piece in (b"x", b"y\nz", b"\n\n"):
        output.write(0, 1, piece)
        output.write(1, 1, piece)
        output.write(1, 2, piece)
    output.close()
    lines = b"[a] xy\n[b] xy\n[a] z\n[a] \n[b] z\n[b] \n"
    assert out.getvalue() == lines
    assert err.getvalue() == b"[b] xy\n[b] z\n[b] \n"


def test_an_endless_line_is_written_in_pieces() -> None:
    out = io.BytesIO()
    output = ProgramOutput(["a", "b"], out, io.BytesIO(), ProgressLine(None))
    for _ in range(100):
        output.write(0, 1, b"*" * 248)
    assert out.getvalue().count(b"[a] ****") == 6  # of 4096 bytes each, the rest is kept


def test_the_order_of_stdout_and_stderr_is_kept_in_the_same_file() -> None:
    both = io.BytesIO()
    out, err = io.BufferedWriter(_Raw(both)), io.BufferedWriter(_Raw(both))
    output = ProgramOutput(["a"], out, err, ProgressLine(None))
    for fd, piece in ((1, b"1"), (2, b"2"), (1, b"3"), (2, b"4")):
        output.write(0, fd, piece)
    output.close()
    assert both.getvalue() == b"1234"


class _Raw(io.RawIOBase):
    def __init__(self, target: io.BytesIO) -> None:
        self.target = target

    def writable(self) -> bool:
        return True

    def write(self, data: object) -> int:
        return self.target.write(data)  # type: ignore[arg-type]


def test_the_progress_line_does_not_overwrite_output() -> None:
    screen, out = io.StringIO(), Terminal()
    progress = ProgressLine(screen)
    output = ProgramOutput(["a"], out, io.BytesIO(), progress)
    assert progress.is_due()
    progress.draw("1 s")
    output.write(0, 1, b"name? ")
    assert screen.getvalue().endswith("1 s\r\x1b[2K")
    progress._next_s = 0.0
    assert not progress.is_due()  # would wipe out "name? "
    output.write(0, 1, b"\n")
    assert progress.is_due()


def test_without_a_terminal_there_is_no_progress_line() -> None:
    progress = ProgressLine(None)
    assert not progress.is_due()
    progress.draw("1 s")
    progress.clear()


def test_input_is_read_by_lines_whatever_its_timing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(b"one\ntwo long\nend")))
    assert [read_line(5) for _ in range(5)] == [b"one\n", b"two l", b"ong\n", b"end", b""]


def test_closed_input_is_at_end_of_file(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sys.stdin", None)
    assert read_line(5) == b""


def test_a_progress_line_is_cut_off_at_the_terminals_end() -> None:
    """What wraps cannot be erased, so each redrawing left a line."""
    screen = io.StringIO()  # says no width: 80 columns
    ProgressLine(screen).draw("x" * 200)
    assert screen.getvalue().count("x") == 79
