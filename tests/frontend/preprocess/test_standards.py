"""`-std=`: predefined macros and trigraphs."""

from __future__ import annotations

import pytest

from crs_cc.frontend.preprocess.options import STANDARDS, Options
from tests.frontend.preprocess.preprocessing import result

VERSION = "__STDC_VERSION__ __STRICT_ANSI__ linux __linux__"


@pytest.mark.parametrize(
    ("standard", "tokens"),
    [
        ("c89", ["__STDC_VERSION__", "1", "linux", "1"]),
        ("gnu89", ["__STDC_VERSION__", "__STRICT_ANSI__", "1", "1"]),
        ("c99", ["199901L", "1", "linux", "1"]),
        ("gnu11", ["201112L", "__STRICT_ANSI__", "1", "1"]),
        ("gnu17", ["201710L", "__STRICT_ANSI__", "1", "1"]),
    ],
)
def test_predefined_macros_of_each_standard(standard: str, tokens: list[str]) -> None:
    assert result(VERSION, Options(standard=standard)) == tokens


@pytest.mark.parametrize("standard", STANDARDS)
def test_trigraphs_only_in_strict_iso_c(standard: str) -> None:
    options = Options(standard=standard)
    if options.is_strict:
        source = "??=define A 1 ??/\n + 2\nint x??(A??);"
        assert result(source, options) == ["int", "x", "[", "1", "+", "2", "]", ";"]
    else:
        assert result('"??("', options) == ['"??("']
