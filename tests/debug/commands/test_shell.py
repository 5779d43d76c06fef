"""What lies between the lines that are typed: here, what must not end the debugger."""

from __future__ import annotations

from typing import Never

import pytest

from crs_cc.debug.commands.shell import Shell
from crs_cc.debug.engine import Debugger
from tests.debug.debuggers import debugger_of

QUIET = """\
int main(void)
{
    return 0;
}
"""


@pytest.fixture
def shell() -> Shell:
    return Shell(debugger_of(QUIET))


def failing(monkeypatch: pytest.MonkeyPatch, error: BaseException) -> None:
    """Let `step` meet an error."""

    def fail(*_: object, **__: object) -> Never:
        raise error

    monkeypatch.setattr(Debugger, "step", fail)


def test_an_internal_error_is_one_line_and_the_debugger_continues(
    shell: Shell, monkeypatch: pytest.MonkeyPatch
) -> None:
    failing(monkeypatch, ValueError("no\n\tnumber"))
    answer = [(line.text, line.kind) for line in shell.execute("step")]
    said = "internal error: ValueError: no number; please report it"
    assert answer == [(said, "error")]
    assert shell.failures == 1
    assert [line.text for line in shell.execute("echo alive")] == ["alive"]


@pytest.mark.parametrize("error", [KeyboardInterrupt(), SystemExit(3), BrokenPipeError()])
def test_system_errors_propagate(
    shell: Shell, monkeypatch: pytest.MonkeyPatch, error: BaseException
) -> None:
    failing(monkeypatch, error)
    with pytest.raises(type(error)):
        list(shell.execute("step"))
