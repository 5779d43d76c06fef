"""The commands that `docs/distributed.md` shows work, each in a process of its own."""

from __future__ import annotations

import re
import shlex
import subprocess
from pathlib import Path

from tests.cli.machines import free_port
from tests.commands import crs

PAGE = Path(__file__).parents[2] / "docs" / "distributed.md"


def test_the_commands_of_the_page_work_and_the_run_is_that_of_one_process(tmp_path: Path) -> None:
    found = re.search(r"```sh\n(.*?)```", PAGE.read_text(), re.DOTALL)
    assert found
    script = found[1].replace("8000", str(free_port()))
    program = f'crs() {{ {shlex.join(crs())} "$@"; }}\nset -e\n{script}'
    done = subprocess.run(
        ["bash", "-c", program], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert "the same run" in done.stdout + done.stderr
    assert "20.00 s simulated" in done.stderr
    words = ["run", "wander.c", "complex-3r.xml", "--max-time", "20", "--record", "local.mcap"]
    subprocess.run(crs(*words), cwd=tmp_path, check=True)
    assert (
        tmp_path.joinpath("run.mcap").read_bytes() == tmp_path.joinpath("local.mcap").read_bytes()
    )
