"""Commands for names: regular expressions choose them, addresses and names lead to each other."""

from __future__ import annotations

import pytest

from crs_cc.debug.commands.shell import Shell
from tests.debug.debuggers import debugger_of

PROGRAM = """\
struct turn { int left; };
struct returned { int right; };
int total[3], subtotal;
int twice(int n) { return 2 * n; }
int thrice(int n) { return 3 * n; }
int main(void)
{
    struct turn first = { 1 };
    struct returned second = { 2 };
    total[1] = subtotal = twice(first.left) + thrice(second.right);
    return total[1];
}
"""


@pytest.fixture
def shell() -> Shell:
    shell = Shell(debugger_of(PROGRAM))
    list(shell.execute("break twice"))
    list(shell.execute("continue"))
    return shell


def said(shell: Shell, line: str) -> list[str]:
    return [each.text for each in shell.execute(line)]


@pytest.mark.parametrize(
    ("line", "names"),
    [
        ("info functions ^t", ["twice", "thrice"]),
        ("info functions ice$", ["twice", "thrice"]),
        ("info functions t.*r", ["thrice"]),
        ("info types turn$", ["struct turn;"]),
        ("info globals ^total", ["total = {0, 0, 0}"]),
        ("info globals total|nothing", ["subtotal = 0", "total = {0, 0, 0}"]),
    ],
)
def test_names_are_chosen_by_a_regular_expression(
    shell: Shell, line: str, names: list[str]
) -> None:
    assert sorted(text.split(": ")[-1] for text in said(shell, line)) == sorted(names)


@pytest.mark.parametrize("command", ["info functions", "info types", "info globals", "rbreak"])
def test_what_is_no_regular_expression_is_an_error(shell: Shell, command: str) -> None:
    (text,) = said(shell, f"{command} (a")
    assert text.startswith("'(a' is not a regular expression: ")


def test_an_address_leads_to_a_name_and_back(shell: Shell) -> None:
    assert said(shell, "info symbol &total[2]") == ["total+8"]
    assert said(shell, "info symbol twice") == ["twice"]
    assert said(shell, "info symbol 5") == ["No variable or function is at 5."]
    (text,) = said(shell, "info address total")
    address = text.split()[3]
    assert text == f"total is at {address} total"
    assert said(shell, f"info symbol {address}") == ["total"]
    (text,) = said(shell, "info address nothing")
    assert "nothing" in text


def test_echo_replaces_escape_sequences(shell: Shell) -> None:
    assert said(shell, r"echo a\tb\\n\n") == ["a\tb\\n"]
