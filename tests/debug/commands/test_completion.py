from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.debug.commands.completion import Completion, complete
from crs_cc.debug.commands.shell import Shell
from crs_cc.debug.repl.keyboard import completer
from tests.debug.debuggers import debugger_at, debugger_of

PROGRAM = Path(__file__).parents[1] / "programs" / "shapes.c"


@pytest.fixture
def shell() -> Shell:
    debugger = debugger_at([PROGRAM])
    debugger.start()
    debugger.next(2)
    return Shell(debugger)


def test_members_tags_macros_and_convenience_functions_are_completed(shell: Shell) -> None:
    def words(text: str) -> tuple[str, ...]:
        return complete(shell.context, text).words

    assert words("print 1 + shapes[0].si") == ("shapes[0].size",)
    assert words("print (&shapes[0])->si") == ()  # an expression in parentheses is none of these
    assert words("print largest->na") == ("largest->name",)
    assert words("print nothing.na") == ()
    assert words("ptype struct sh") == ("struct shape",)
    assert "$_streq(" in words("print $_str")
    assert words("info macro BUFS") == ("BUFSIZ",)
    assert words("print BUFS") == ("BUFSIZ",)


def test_every_argument_kind_is_completed(shell: Shell) -> None:
    assert complete(shell.context, "reverse-f") == Completion(0, ("reverse-finish",))
    assert complete(shell.context, "info lo") == Completion(5, ("locals",))
    assert complete(shell.context, "  inf").words == ("info",)
    assert complete(shell.context, "break fac") == Completion(6, ("factorial",))
    assert complete(shell.context, "b sha") == Completion(2, ("shapes.c:",))
    assert complete(shell.context, "b shapes.c:fa") == Completion(2, ("shapes.c:factorial",))
    assert complete(shell.context, "print 2 * lar") == Completion(10, ("largest",))
    assert "total" in complete(shell.context, "p ").words
    assert complete(shell.context, "p nothing").words == ()
    assert complete(shell.context, "robot ").words == ("robot0",)
    assert "collision" in complete(shell.context, "catch ").words
    assert complete(shell.context, "help rev").words[0] == "reverse-continue"
    assert complete(shell.context, "switch ").words == ("main",)
    assert complete(shell.context, "foo bar").words == ()
    assert complete(shell.context, "step ").words == ()
    assert complete(shell.context, "").words[0] == "advance"
    assert complete(shell.context, "set print p") == Completion(10, ("pretty",))
    assert "listsize" in complete(shell.context, "set li").words
    assert complete(shell.context, "show ").words == ("backtrace", "history", "listsize", "print")
    assert complete(shell.context, "set var lar").words == ("largest",)


def test_numbers_and_files_are_completed(
    shell: Shell, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    shell.debugger.stop_points.add_breakpoint("main")
    shell.debugger.checkpoint()
    list(shell.execute("display calls"))
    for line in ("delete ", "restart ", "undisplay "):
        assert complete(shell.context, line).words == ("1",)
    monkeypatch.chdir(tmp_path)
    (tmp_path / "one.dbg").touch()
    (tmp_path / "scripts").mkdir()
    assert complete(shell.context, "source ").words == ("one.dbg", "scripts/")


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("enable on", ("once",)),
        ("enable breakpoints co", ("count",)),
        ("show val", ("values",)),
        ("goto st", ("start", "stmt")),
        ("frame ap", ("apply",)),
        ("skip fi", ("file",)),
        ("break main ro", ("robot",)),
        ("run -k", ("-keep",)),
        ("enable ", ()),
        ("step o", ()),
    ],
)
def test_words_of_arguments_are_completed_once_begun(
    shell: Shell, line: str, words: tuple[str, ...]
) -> None:
    assert complete(shell.context, line).words == words


def test_the_robots_state_is_completed() -> None:
    source = '#include "Nclient.h"\nint main(void)\n{\n    gs();\n    return State[17];\n}\n'
    made = Shell(debugger_of(source))
    assert complete(made.context, "print Sta").words == ("State",)


def test_readline_gets_the_rest_of_its_word(shell: Shell) -> None:
    line = "print shapes.c:3 + lar"
    give = completer(shell, lambda: line)
    assert [give("lar", 0), give("lar", 1)] == ["largest ", None]
    line = "break shapes.c:fa"
    assert give("shapes.c:fa", 0) == "shapes.c:factorial "
    assert give("fa", 0) == "factorial "
