"""The commands that `docs/vendor-clients.md` shows work, and a run they record needs no client."""

from __future__ import annotations

import re
import shlex
import subprocess
import sys
from pathlib import Path

from tests.cli.test_distributed_page import free_port
from tests.commands import crs

PAGE = (Path(__file__).parents[2] / "docs" / "vendor-clients.md").read_text()


def block(kind: str) -> str:
    found = re.search(rf"```{kind}\n(.*?)```", PAGE, re.DOTALL)
    assert found
    return found[1]


def test_the_commands_of_the_page_work(tmp_path: Path) -> None:
    (tmp_path / "drive.py").write_text(block("python"))
    script = block("sh").replace("7019", str(free_port())).replace("python3", f'"{sys.executable}"')
    program = f'crs() {{ {shlex.join(crs())} "$@"; }}\nset -e\n{script}'
    done = subprocess.run(
        ["bash", "-c", program],
        cwd=tmp_path, capture_output=True, text=True, check=False, timeout=120,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    moved = re.search(r"State\[STATE_CONF_X\] is (\d+)", done.stdout)
    assert moved
    assert 30 < int(moved[1]) < 200
    assert "Nserver is on port" in done.stderr
    assert "the same run" in done.stdout + done.stderr
    assert (tmp_path / "run.mcap").exists()
