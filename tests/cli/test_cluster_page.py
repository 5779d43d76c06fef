"""The commands that `docs/cluster.md` shows for a laptop work, each in a process of its own."""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path

import pytest

from tests.cli.machines import free_port
from tests.commands import put_into

PAGE = Path(__file__).parents[2] / "docs" / "cluster.md"


def test_the_run_of_the_page_on_a_cluster_is_that_of_one_process(tmp_path: Path) -> None:
    pytest.importorskip("distributed", reason="needs the extra 'cluster'")
    found = re.search(r"```sh\n(.*?)```", PAGE.read_text(), re.DOTALL)
    assert found
    script = found[1].replace("8786", str(free_port()))
    script = script.replace("--hosts", f"--listen 127.0.0.1:{free_port()} --tls --hosts")
    commands = tmp_path / "bin"
    commands.mkdir()
    for name, module in (("crs", "crs_cc"), ("dask", "dask")):
        put_into(commands, name, module)
    path = f"{commands}{os.pathsep}{os.environ['PATH']}"
    done = subprocess.run(
        ["bash", "-ec", script],
        cwd=tmp_path,
        env=os.environ | {"PATH": path},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    served, local = done.stdout.split("[robot0]", 1), (tmp_path / "local.mcap").read_bytes()
    assert len(served) == 2
    assert (tmp_path / "run.mcap").read_bytes() == local
