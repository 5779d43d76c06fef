"""`crs completion`: the scripts are those of the shells, and what they complete."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

from crs_cc.cli.main import main
from tests.commands import put_into

BASH = shutil.which("bash")


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_the_script_is_for_the_command_crs(shell: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["completion", shell]) == 0
    script = capsys.readouterr().out
    assert f"_CRS_COMPLETE={shell}_complete" in script
    assert "%(" not in script


@pytest.mark.skipif(BASH is None, reason="needs bash")
def test_bash_completes_commands_and_samples(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    main(["completion", "bash"])
    put_into(tmp_path)

    def completed(*words: str) -> list[str]:
        line = f"COMP_WORDS=({' '.join(words)} ''); COMP_CWORD={len(words)}; _crs_completion crs"
        script = f"{functions}\n{line}\nprintf '%s\\n' \"${{COMPREPLY[@]}}\""
        environment = {**os.environ, "PATH": f"{tmp_path}:{os.environ['PATH']}"}
        done = subprocess.run(
            [str(BASH), "-c", script], env=environment, check=True, capture_output=True, text=True
        )
        return done.stdout.split()

    functions = capsys.readouterr().out
    assert {"run", "debug", "samples", "docs"} <= set(completed("crs"))
    assert {"wander.c", "room.xml"} <= set(completed("crs", "samples", "copy"))
    assert "sensors" in completed("crs", "docs")
