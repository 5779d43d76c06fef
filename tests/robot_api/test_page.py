"""`docs/robot-api.md` states the rules of the C library exactly."""

from __future__ import annotations

import pytest

from crs_cc.robot_api.report import COMMANDS, REPORT_STATE
from docs.generate.robot_api import dialect_functions, dialect_state, parameter


def test_dialect_tables_show_every_command() -> None:
    lines = dialect_functions().splitlines()
    for command in COMMANDS:
        assert any(line.startswith(f"| `{command.prototype}` |") for line in lines)
    assert {line.count("|") for line in lines} == {6}
    assert {line.count("|") for line in dialect_state().splitlines()} == {4}
    assert len(dialect_state().splitlines()) == len(REPORT_STATE) + 2


def test_unknown_parameter_is_an_error() -> None:
    with pytest.raises(KeyError):
        parameter("scout", "drive", "colour")
