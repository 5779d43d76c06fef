"""The format of messages on a terminal and elsewhere."""

from __future__ import annotations

import io
import sys

import pytest

from crs_cc.cli.messages import MAX_LINE_LENGTH, MAX_MESSAGES, is_coloured, render, show
from crs_cc.core.source import Diagnostic, Location

ORDINARY = Diagnostic(
    "error", Location("wander.c", 3, 9), "unknown name 'sped'", "\tvm(sped, 0, 0);", "did you mean?"
)


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def test_without_colours_a_message_has_the_format_of_the_diagnostic() -> None:
    for message in (
        ORDINARY,
        Diagnostic("warning", Location("wander.c"), "whole file"),
        Diagnostic("note", Location("wander.c", 3), "whole line", "vm(1, 2, 3);"),
    ):
        assert render(message, coloured=False) == message.render()


def test_colours_change_nothing_but_the_colours() -> None:
    import click

    painted = render(ORDINARY, coloured=True)
    assert "\x1b[" in painted
    assert click.unstyle(painted) == ORDINARY.render()


def test_control_characters_of_a_hostile_file_do_not_reach_the_terminal() -> None:
    evil = "\x1b[2J\x07\u202etxt\x9b"
    message = Diagnostic("error", Location(f"a{evil}\n.c", 1, 2), evil, evil, evil)
    shown = render(message, coloured=False)
    assert not set(shown) & set("\x1b\x07\u202e\x9b")
    assert len(shown.split("\n")) == 4


def test_a_very_long_line_is_cut_to_the_part_around_the_caret() -> None:
    line = "x" * 5000 + "here" + "y" * 5000
    rows = render(
        Diagnostic("error", Location("a.c", 1, 5001), "long", line), coloured=False
    ).split("\n")
    assert len(rows[1]) <= MAX_LINE_LENGTH + 4
    assert rows[1][rows[2].index("^") :].startswith("here")


def test_a_flood_of_messages_is_cut_with_a_count(capsys: pytest.CaptureFixture[str]) -> None:
    show([ORDINARY] * (MAX_MESSAGES + 7))
    shown = capsys.readouterr().err
    assert shown.count("wander.c:3:9") == MAX_MESSAGES
    assert "... and 7 more messages" in shown


@pytest.mark.parametrize(
    ("environment", "coloured"),
    [({}, True), ({"NO_COLOR": "1"}, False), ({"NO_COLOR": ""}, True), ({"TERM": "dumb"}, False)],
)
def test_colours_are_used_on_terminals_that_support_them(
    monkeypatch: pytest.MonkeyPatch, environment: dict[str, str], coloured: bool
) -> None:
    monkeypatch.delenv("NO_COLOR", raising=False)
    monkeypatch.setenv("TERM", "xterm")
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    assert is_coloured(Terminal()) is coloured
    assert not is_coloured(io.StringIO())
    assert sys.stderr is not None
