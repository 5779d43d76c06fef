"""Whatever is typed, the answer is lines, and the debugger lives on."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from crs_cc.debug.commands.completion import complete
from crs_cc.debug.commands.shell import Shell
from crs_cc.debug.commands.table import NAMES
from tests.debug.debuggers import debugger_at

PROGRAM = Path(__file__).parents[1] / "programs" / "shapes.c"
LINES = 200
TEXT = """1 2 0 -1 1-3 3-1 $ $1 $x=3 main factorial shapes.c:45 45 999 calls &calls * ( ) (((( if
robot 0 robot0 nobody / // /x /3xb /s /xx /999999999xg x=3 calls=3 \0 \x1b[2J é \udc80 ' " \\ { } ,
a[1..2] word@3 tick stmt t= 12.3 1e999 nan inf 99999999999 error exit collision sonar.3 dead to ..
robot0::calls &robot0::calls $world.robot0.x distance(robot0,robot0) @1 output event 0..1 /csv ..
"%d" %s factorial(2) main(1,0) sizeof(int) (char*)0 *(int*)calls 1/0 # silent continue end
"""
WORDS = TEXT.split()


@pytest.mark.parametrize("seed", range(3))
def test_random_commands_do_no_harm(
    seed: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    chance = random.Random(seed)
    shell = Shell(debugger_at([PROGRAM]))
    list(shell.greet())
    for _ in range(LINES):
        arguments = chance.choices(WORDS, k=chance.randrange(4))
        line = f"{chance.choice(sorted(NAMES))} {' '.join(arguments)}"
        complete(shell.context, line)
        for answer in shell.execute(line):
            assert "\n" not in answer.text
            assert "internal error" not in answer.text
        shell.context.has_ended = False
    list(shell.execute("end"))
    assert [each.text for each in shell.execute("echo alive")] == ["alive"]


def test_a_long_line_is_handled_quickly() -> None:
    shell = Shell(debugger_at([PROGRAM]))
    blanks = f'log "%d",1{" " * 100_000}x'
    numbers = [f"{each} {'9' * 100_000}" for each in ("break", "when", "history", "events")]
    for line in ("x" * 100_000, "print " + "(" * 100_000, *numbers, blanks, "\0" * 1000):
        complete(shell.context, line)
        assert all(len(answer.text) < 300_000 for answer in shell.execute(line))
