"""The expression after `#if`: C17 6.10.1."""

from __future__ import annotations

import pytest

from tests.frontend.preprocess.preprocessing import messages, result

HOLDS = r"""
1
-1
!0
1 + 2 * 3 == 7
10 - 4 - 3 == 3
100 / 10 / 5 == 2
1 << 2 << 3 == 32
-7 / 2 == -3 && -7 % 2 == -1 && 7 % -2 == 1
-1 >> 1 == -1
1 << -1 == 0 && -1 >> 70 == -1 && 1 << 64 == 0
1 < 2 == 2 > 1 && (1 | 6 ^ 3 & 2) == 5
(1 ? 2 : 3 ? 4 : 5) == 2 && (0 ? 1 : 0 ? 2 : 7) == 7 && (1 ? 0 ? 3 : 4 : 5) == 4
- -1 == 1 && +-+1 == -1 && !!5 == 1 && ~0 == -1 && -!0 == -1
2 || 1/0
!(0 && 1/0)
1 ? 1 : 1/0
(0, 1)
-1 > 0u
0xffffffffffffffff == -1
(1u - 2) > 0 && (1 ? -1 : 0u) > 0
0x7fffffffffffffff + 1 < 0
(-9223372036854775807 - 1) / -1 < 0
18446744073709551615 == 0xffffffffffffffffu
1 == 1L && 0b101 == 5 && 010 == 8 && 0XAul == 10 && 3LLU == 3
'A' == 65 && '\x41' == 'A' && '\101' == 'A' && '\n' == 10 && '\'' == 39 && '"' == 34
'\377' == -1 && 'ab' == 24930 && 'abcd' == 1633837924
L'\xff' == 255 && L'\u00e9' == 233 && '\0' == 0
int == 0 && undefined == 0 && true == 0
defined __LINE__ && defined(__CRS__) && !defined X && !defined (X)
defined __has_include && defined __has_embed
__has_c_attribute(nodiscard) == 202003L && !__has_c_attribute(none)
__has_c_attribute(gnu::packed)
0x1'ff == 511 && 1'000'000 == 1000000
ONE && F(1) && F(F(1)) && F == 0 && EMPTY ONE
DEFINED_ONE && F(DEFINED_ONE)
__LINE__ == 5
"""
PRELUDE = """\
#define ONE 1
#define F(x) x
#define EMPTY
#define DEFINED_ONE (defined ONE && defined(ONE) && !defined TWO)
"""

WRONG = [
    ("", "1:1: error: in '#if': expected an expression"),
    ("1 +", "1:1: error: in '#if': unexpected end of the expression"),
    ("1 2", "1:7: error: in '#if': expected an operator before '2'"),
    ("X = 1", "1:7: error: in '#if': expected an operator before '='"),
    ("(1", "1:5: error: in '#if': missing ')' for '('"),
    ("1)", "1:6: error: in '#if': ')' without '(' before it"),
    ("1 ? 2", "1:7: error: in '#if': missing ':' for '?'"),
    ("1 : 2", "1:7: error: in '#if': ':' without '?' before it"),
    ("(1 ? 2)", "1:11: error: in '#if': ')' without '(' before it"),
    ("* 2", "1:5: error: in '#if': unexpected '*' in the expression"),
    ('"a"', "1:5: error: in '#if': unexpected string in the expression"),
    ("1 / (2 - 2)", "1:7: error: in '#if': division by zero"),
    ("1 || 2 / 0 ? 3 % 0 : 1", "1:20: error: in '#if': division by zero"),
    ("1.5", "1:5: error: in '#if': '1.5' is not an integer"),
    ("0x", "1:5: error: in '#if': '0x' is not an integer"),
    ("18446744073709551616", "1:5: error: in '#if': 18446744073709551616 is too large"),
    ("''", "1:5: error: in '#if': empty character constant"),
    ("VERSION(2)", "1:5: error: in '#if': the macro 'VERSION' is not defined"),
    ("defined", "1:5: error: in '#if': 'defined' must be followed by a name"),
    ("defined(X", "1:5: error: in '#if': missing ')' after 'defined'"),
    (
        "__has_include",
        "1:5: error: in '#if': '__has_include' must be followed by a header in parentheses",
    ),
    ("__has_include(<a.h)", "1:5: error: in '#if': missing ')' after '__has_include'"),
    ("__has_include(a)", "1:5: error: in '#if': write \"name.h\" or <name.h>"),
    ("__has_c_attribute()", "1:5: error: in '#if': missing ')' after '__has_c_attribute'"),
]


@pytest.mark.parametrize("expression", HOLDS.strip().splitlines())
def test_true_conditions(expression: str) -> None:
    assert result(f"{PRELUDE}#if {expression}\nyes\n#else\nno\n#endif") == ["yes"]


@pytest.mark.parametrize("expression", ["0", "1 - 1", "0 && 1/0", "undefined", "0 ? 1/0 : 0", "0u"])
def test_false_conditions(expression: str) -> None:
    assert result(f"#if {expression}\nyes\n#else\nno\n#endif") == ["no"]


@pytest.mark.parametrize(("expression", "message"), WRONG)
def test_condition_errors(expression: str, message: str) -> None:
    assert messages(f"#if {expression}\n#endif\n") == [message]


def test_nesting_is_not_limited_by_the_stack() -> None:
    deep = 10_000
    source = f"#if {'(' * deep}{'!' * deep}1{')' * deep}\nyes\n#endif\n"
    assert result(source) == ["yes"]
    assert result(f"#if {'1 ? 0 : ' * deep}1\nyes\n#else\nno\n#endif") == ["no"]
