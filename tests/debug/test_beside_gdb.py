"""gdb and crs debug stop at the same places, and show the same values, in the same sessions.

The sessions leave out what is meant to differ: gdb stops at the closing brace of a function, and
in the middle of a statement after a read; its errors have other words.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
from pathlib import Path
from typing import Final

import pytest

from crs_cc.debug.commands.gdb_names import gdb_name
from crs_cc.debug.commands.shell import Shell
from crs_cc.debug.commands.table import COMMANDS
from tests import gcc
from tests.debug.debuggers import debugger_at

HERE: Final = Path(__file__).parent
PROGRAM: Final = HERE / "programs" / "beside_gdb.c"
SESSIONS: Final = [
    line
    for line in (HERE / "gdb_sessions.txt").read_text().splitlines()
    if not line.startswith("#")
]

SHOWS: Final = re.compile(r"(print|call|whatis|show values|info (locals|args))\b")
_LINES: Final = re.compile(r"^[=>* ]*(\d+)(?=\s|$)", re.MULTILINE)
LISTED: Final = {
    **dict.fromkeys(("list", "search", "forward-search", "reverse-search"), _LINES),
    "info line": re.compile(r"\A(?:Line |.*:)(\d+)\b"),
}
"""The numbers of the lines that a command shows."""

MOVES: Final = re.compile(r"(run|continue|next|step|finish|until|advance|up|down|frame)\b")
NEWEST: Final = re.compile(r"(ignore|delete|disable|enable(?: once| delete| count \d)?) \$")

SPELLING: Final = (
    (r"(?m)^\$\d+ = ", ""),
    (r"^type = ", ""),
    (r" \[", "["),  # in types
    (r"(\\000)+\"", '"'),  # gdb shows all bytes of an array of characters
    (r"0x[0-9a-f]+ <(\w+)>", r"&\1"),
    (r"\b0x0\b", "null"),
)
"""What gdb writes otherwise."""

Seen = tuple[str, str]
"""A command, and what of its effect is compared: a value, or where the program stands."""


def commands(session: str) -> list[str]:
    """Return the commands of a session."""
    return [each.strip() for each in session.split(";")]


def seen(command: str, place: object, answer: str) -> Seen:
    """Return what is compared of a command."""
    if SHOWS.match(command):
        for theirs, ours in SPELLING:
            answer = re.sub(theirs, ours, answer.strip())
        return command, answer
    for name, pattern in LISTED.items():
        if command.startswith(name):
            return command, " ".join(pattern.findall(answer))
    return command, str(place) if MOVES.match(command) else ""


def installed_gdb() -> str:
    """Return gdb; skip the test where there is none, but not in CI, which installs it."""
    found = shutil.which("gdb")
    if found is None:
        if os.environ.get("CI"):
            pytest.fail("gdb not found: .ci/run installs it")
        pytest.skip("gdb not found: there is nothing to compare with")
    return found


@pytest.fixture(scope="module")
def gdb(tmp_path_factory: pytest.TempPathFactory) -> dict[str, list[Seen]]:
    """What gdb shows in all sessions; it runs once."""
    found = installed_gdb()
    if gcc.why_not():
        pytest.skip(f"gcc -m32: {gcc.why_not()}")
    folder = tmp_path_factory.mktemp("gdb")
    program, asked, answers = folder / "program", folder / "in.json", folder / "out.json"
    subprocess.run(["gcc", "-m32", "-g", "-O0", PROGRAM, "-o", program], check=True)
    wanted = [[NEWEST.sub(r"\1 $bpnum", each) for each in commands(one)] for one in SESSIONS]
    asked.write_text(json.dumps(wanted))
    names = f"python SESSIONS, SEEN = {str(asked)!r}, {str(answers)!r}"
    script = ["-ex", names, "-x", HERE / "gdb_sessions.py", program]
    subprocess.run([found, "-nx", "-batch", *script], check=True, capture_output=True, timeout=120)
    rows = zip(SESSIONS, json.loads(answers.read_text()), strict=True)
    return {
        session: [
            seen(command, *answer)
            for command, answer in zip(commands(session), answered, strict=True)
        ]
        for session, answered in rows
    }


def ours(session: str) -> list[Seen]:
    """Return what our debugger shows."""
    debugger = debugger_at([PROGRAM])
    shell, rows = Shell(debugger), []
    for command in commands(session):
        answer = "\n".join(line.text for line in shell.execute(command))
        frame = debugger.view.current_frame()
        rows.append(seen(command, frame and [frame.function, frame.location.line], answer))
    return rows


def test_commands_marked_as_gdb_commands_exist_in_gdb() -> None:
    found = installed_gdb()
    names = [name for each in COMMANDS if (name := gdb_name(each.name))]
    assert len(names) > 50
    script = [part for name in names for part in ("-ex", f"help {name}")]
    ran = subprocess.run([found, "-nx", "-batch", *script], check=True, capture_output=True)
    assert ran.stderr == b""


@pytest.mark.parametrize("session", SESSIONS)
def test_a_session_shows_what_gdb_shows(session: str, gdb: dict[str, list[Seen]]) -> None:
    assert ours(session) == gdb[session]
