"""Scripts for `crs debug`, and what is seen on the plain screen: `<script>.dbg` and `<script>.out`.

The first line of a script is the command line that it is for. `pytest --update-goldens` rewrites
what is seen.
"""

from __future__ import annotations

import re
import shlex
import shutil
from collections.abc import Callable
from functools import cache
from pathlib import Path

import pytest

from crs_cc.cli.main import main
from crs_cc.debug.commands.table import COMMANDS, find
from crs_cc.debug.errors import DebugError

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
SAMPLES = [*ROOT.glob("samples/scout_c/*.c"), *ROOT.glob("worlds/*")]
CONVOY = sorted(ROOT.glob("samples/scout_c/convoy/*"))
SCRIPTS = sorted(HERE.glob("*.dbg"))


@pytest.mark.parametrize("script", SCRIPTS, ids=lambda path: path.stem)
def test_script_output(
    script: Path,
    check_golden: Callable[[Path, bytes], None],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capfdbinary: pytest.CaptureFixture[bytes],
) -> None:
    words = shlex.split(script.read_text().splitlines()[0].removeprefix("# crs debug "))
    named = [path for path in SAMPLES if path.name in words]
    for path in (*CONVOY, *named, *HERE.glob("programs/*"), script):
        shutil.copy(path, tmp_path)
    monkeypatch.chdir(tmp_path)
    status = main(["debug", "--batch", "-q", "-x", script.name, *words])
    shown = capfdbinary.readouterr()
    assert shown.err == b""
    out = shown.out.replace(f"{ROOT}/".encode(), b"")
    check_golden(script.with_suffix(".out"), out + f"exit status {status}\n".encode())


@cache
def done() -> set[str]:
    """Return the names of the commands that scripts do."""
    names = set()
    for script in [*SCRIPTS, *HERE.glob("programs/*.dbg")]:
        for line in script.read_text().splitlines():
            if line.strip() and not line.startswith("#"):
                try:
                    names.add(find(line)[0].name)
                except DebugError:
                    continue
    return names


@pytest.mark.parametrize("command", [each.name for each in COMMANDS])
def test_every_command_is_in_a_script(command: str) -> None:
    assert command in done()


def test_every_golden_belongs_to_a_script() -> None:
    assert {path.stem for path in HERE.glob("*.out")} == {path.stem for path in SCRIPTS}


def test_no_golden_has_a_traceback() -> None:
    for path in HERE.glob("*.out"):
        assert not re.search("Traceback|internal error", path.read_text())
