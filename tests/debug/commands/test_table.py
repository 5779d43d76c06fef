from __future__ import annotations

import pytest

from crs_cc.debug.commands.table import COMMANDS, GROUPS, NAMES, PREFIXES, find, matching
from crs_cc.debug.errors import DebugError


@pytest.mark.parametrize(
    ("typed", "name"),
    [
        ("b", "break"), ("br", "break"), ("r", "run"), ("c", "continue"), ("s", "step"),
        ("n", "next"), ("fin", "finish"), ("u", "until"), ("bt", "backtrace"), ("f", "frame"),
        ("l", "list"), ("d", "delete"), ("rs", "reverse-step"), ("rn", "reverse-next"),
        ("rc", "reverse-continue"), ("rewind", "reverse-continue"), ("where", "backtrace"),
        ("tb", "tbreak"), ("thread", "robot"), ("t", "robot"), ("i b", "info breakpoints"),
        ("h", "help"), ("q", "quit"), ("fg", "continue"), ("si", "stepi"),
    ],
)  # fmt: skip
def test_gdb_aliases(typed: str, name: str) -> None:
    assert find(typed)[0].name == name


def test_unambiguous_abbreviations() -> None:
    for command in COMMANDS:
        if " " not in command.name:
            assert find(f"{command.name} x") == (command, "x")
    assert find("reverse-ti 3")[0].name == "reverse-tick"
    assert find("inf bre 2") == (NAMES["info breakpoints"], "2")


@pytest.mark.parametrize("typed", ["source x", "list(x)", "list,3"])
def test_a_name_ends_where_no_letter_follows(typed: str) -> None:
    command, rest = find(typed)
    assert command.name + rest == typed.replace(" ", "")


@pytest.mark.parametrize(
    ("typed", "said"),
    [
        ("foo", 'Undefined command: "foo".  Try "help".'),
        ("12", 'Undefined command: "12".  Try "help".'),
        ("§$%", 'Undefined command: "§$%".  Try "help".'),
        ("whe", 'Ambiguous command "whe": when, where.'),
        ("info foo", 'Undefined info command: "foo".  Try "help info".'),
        ("info", '"info" needs a subcommand: try "help info".'),
    ],
)
def test_unknown_commands_are_refused_in_gdbs_words(typed: str, said: str) -> None:
    with pytest.raises(DebugError) as refused:
        find(typed)
    assert str(refused.value) == said


def test_every_command_has_one_group_and_a_summary() -> None:
    assert len({group.name for group in GROUPS}) == len(GROUPS)
    for command in COMMANDS:
        assert command.summary.endswith(".")
        assert len(command.summary) < 70
        assert not command.text or command.text.endswith(".")
        assert command.name.count(" ") <= 1
    assert not set(PREFIXES) & set(NAMES)


def test_names_are_completed_word_by_word() -> None:
    assert list(matching("reverse-st")) == ["reverse-step", "reverse-stepi"]
    assert "info" in list(matching("in"))
    assert "info breakpoints" not in list(matching("in"))
    assert "info breakpoints" in list(matching("info br"))
