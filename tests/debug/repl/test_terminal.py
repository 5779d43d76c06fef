from __future__ import annotations

import io
import re

from crs_cc.debug.commands.answer import Line, SourceLine
from crs_cc.debug.repl.terminal import Terminal


def terminal(*, is_coloured: bool = False, names: tuple[str, ...] = ("robot0",)) -> Terminal:
    return Terminal(io.BytesIO(), names, is_coloured=is_coloured)


def shown(of: Terminal) -> str:
    stream = of._stream
    assert isinstance(stream, io.BytesIO)
    return stream.getvalue().decode()


def test_output_of_one_robot_is_unchanged_and_answers_start_a_line() -> None:
    screen = terminal()
    screen.program(0, 1, b"no end of li\xff")
    screen.line(Line("Interrupted.", "stop"))
    screen.program(0, 2, b"")
    screen.program(0, 1, b"a line\n")
    screen.line(SourceLine(12, "\tx = 3;", is_current=True, has_breakpoint=True))
    content = screen._stream.getvalue()  # type: ignore[attr-defined]
    assert content == b"no end of li\xff\nInterrupted.\na line\n=>*  12          x = 3;\n"


def test_stdout_and_stderr_do_not_mix_in_a_line() -> None:
    screen = terminal(names=("a", "b"))
    screen.program(0, 1, b"out")
    screen.program(0, 2, b"err\n")
    screen.program(0, 1, b"put\n")
    screen.program(1, 1, b"x" * 5000)
    screen.finish_lines()
    lines = shown(screen).splitlines()
    assert lines[:2] == ["[a] err", "[a] output"]
    assert [len(line) for line in lines[2:]] == [4 + 4096, 4 + 904]


def test_colours_do_not_change_the_text() -> None:
    plain, coloured = terminal(), terminal(is_coloured=True)
    rows = (
        Line("Undefined", "error"),
        Line("main () at a.c:3", "place"),
        SourceLine(3, '    puts("a[0] \\n");  /* [b]not markup[/b] */', is_current=True),
        SourceLine(4, ""),
    )
    for row in rows:
        plain.line(row)
        coloured.line(row)
    assert "\x1b" not in shown(plain)
    assert "\x1b[" in shown(coloured)
    assert re.sub(r"\x1b\[[\d;]*m", "", shown(coloured)) == shown(plain)


def test_control_characters_are_not_passed_on() -> None:
    for is_coloured in (False, True):
        screen = terminal(is_coloured=is_coloured)
        screen.line(Line("\x1b]0;title\x07\u202e"))
        screen.line(SourceLine(1, "/* \x1b[2J \x9b */"))
        text = re.sub(r"\x1b\[[\d;]*m", "", shown(screen))
        assert not set(text) & set("\x1b\x07\x9b\u202e")


def test_script_lines_are_echoed() -> None:
    screen = terminal()
    screen.program(0, 1, b"12")
    screen.echo("(crs) ", "next\x1b")
    assert shown(screen) == "12\n(crs) next?\n"


def test_a_line_that_is_longer_than_the_screen_continues_below_its_own_text() -> None:
    stream = io.BytesIO()
    long = "@12  " + "gap = first + second " * 5
    narrow = Terminal(stream, ["robot0"], columns=lambda: 40)
    narrow.line(Line(long, indent=9))
    lines = stream.getvalue().decode().splitlines()
    assert len(lines) > 2
    assert all(len(each) <= 40 for each in lines)
    assert all(each.startswith(" " * 9 + "g") or each[9] != " " for each in lines[1:])
    assert " ".join(" ".join(lines).split()) == " ".join(long.split())
    for same in (Line(long), Line("short", indent=9)):
        stream = io.BytesIO()
        Terminal(stream, ["robot0"], columns=lambda: 40).line(same)
        assert stream.getvalue().decode() == f"{same.text}\n"
