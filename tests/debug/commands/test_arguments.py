from __future__ import annotations

import pytest

from crs_cc.debug.commands.arguments import (
    BreakpointArguments,
    OutputFormat,
    parse_breakpoint_arguments,
    parse_count,
    parse_format,
    parse_numbers,
    parse_robot,
    split_arguments,
)
from crs_cc.debug.commands.log_text import log_text
from crs_cc.debug.errors import DebugError


def test_breakpoint_arguments_have_a_robot_and_a_condition() -> None:
    assert parse_breakpoint_arguments("12") == BreakpointArguments("12")
    assert parse_breakpoint_arguments("if x") == BreakpointArguments("", condition="x")
    assert parse_breakpoint_arguments("turn thread 2") == BreakpointArguments("turn", "2")
    assert parse_breakpoint_arguments("lift") == BreakpointArguments("lift")
    assert parse_breakpoint_arguments("turn if iffy == 3") == BreakpointArguments(
        "turn", condition="iffy == 3"
    )
    with pytest.raises(DebugError, match="'if' needs"):
        parse_breakpoint_arguments("turn if ")


def test_formats_are_parsed_like_gdbs() -> None:
    assert parse_format("x") == (OutputFormat(), "x")
    assert parse_format("/x n") == (OutputFormat("x"), "n")
    assert parse_format("/8xb&order") == (OutputFormat("x", 8, 1), "&order")


@pytest.mark.parametrize("text", ["/xd 3", "/q 3", "/bw 3", "/0x 3", "/-1x 3"])
def test_invalid_formats_are_refused(text: str) -> None:
    with pytest.raises(DebugError):
        parse_format(text)


@pytest.mark.parametrize("text", ["0", "-1", "x", "1 2", "1e3", "99999999999999999999", "٣"])
def test_counts_start_at_1(text: str) -> None:
    with pytest.raises(DebugError, match="count"):
        parse_count(text)


def test_numbers_and_ranges() -> None:
    assert parse_numbers("") == []
    assert parse_numbers("3, 1-2") == [3, 1, 2]
    for wrong in ("x", "1-", "3-1", "1-999999999", "-1"):
        with pytest.raises(DebugError):
            parse_numbers(wrong)


def test_robots_have_names_and_numbers_and_names_take_precedence() -> None:
    assert parse_robot("1", ["1", "0"]) == 0
    assert parse_robot("1", ["left", "right"]) == 1
    for wrong in ("2", "lef", "", "-1"):
        with pytest.raises(DebugError, match="left, right"):
            parse_robot(wrong, ["left", "right"])


def test_arguments_are_split_at_top_level_commas() -> None:
    assert split_arguments("12") == ["12"]
    assert split_arguments("12,\"a,b\",f(x, y)[1,2],','") == ["12", '"a,b"', "f(x, y)[1,2]", "','"]


def test_printf_formats_become_log_messages() -> None:
    made = log_text(r'"%5.1f %%, \"%s\" %*d\n"', ["speed", "name", "width", "a + f(b, c)"])
    assert made == '{%5.1f speed} %, "{%s name}" {%*d width, a + f(b, c)}'
    for literal, expressions in (("12", []), ('"%d"', []), ('"%*d"', ["x"]), ('"none"', ["x"])):
        with pytest.raises(DebugError):
            log_text(literal, expressions)
