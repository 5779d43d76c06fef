"""A user's module under `mypy --strict` sees the types of the public names."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import crs_cc
from tests import check_types

ROOT = Path(crs_cc.__file__).parents[1]
CACHE = ROOT / ".mypy_cache" / "of_users"
"""What mypy knows of our modules as installed ones; checking all of them takes ten seconds."""

MODULE = '''"""A user's module."""
import numpy as np
import crs_cc

session = crs_cc.Session("room.xml", {"robot0": crs_cc.compile_c("a.c")}, seed=1)
while session.step():
    path = session.poses[0].tolist()
session.on("collision", lambda event: print(event.time_s, event.text))
world = crs_cc.WorldModel("w", crs_cc.Area(0.0, 0.0, 5.0, 4.0))
env = crs_cc.Env(world, observe=["sonar"])
nearest: np.float64 = env.reset(seed=1)["robot0"]["sonar"].min()
env.step({"robot0": [0.1, 0.2]})
reveal_type(session.robots["robot0"].sonar)
reveal_type(session.run().robots[0].exit_status)
reveal_type(crs_cc.GymEnv(world).reset(seed=1)[0]["sonar"])
crs_cc.Session(5)
session.move("robot0", "here", 1.0)
session.shake()
from crs_cc.api import load_world, Sesion
'''
EXPECTED = [
    'note: Revealed type is "numpy.ndarray[tuple[Any, ...], numpy.dtype[Any]]"',
    'note: Revealed type is "int | None"',
    'note: Revealed type is "numpy.ndarray[tuple[Any, ...], numpy.dtype[numpy.float64]]"',
    'error: Argument 1 to "Session" has incompatible type "int"',
    'error: Argument 2 to "move" of "Edits" has incompatible type "str"; expected "float"',
    'error: "Session" has no attribute "shake"',
    'error: Module "crs_cc.api" has no attribute "Sesion"',
]


def test_a_users_module_is_checked(tmp_path: Path) -> None:
    (tmp_path / "user.py").write_text(MODULE)
    done = subprocess.run(
        [sys.executable, check_types.__file__, "--strict", "--cache-dir", str(CACHE), "user.py"],
        cwd=tmp_path, capture_output=True, text=True, check=False,
        # As if it were installed: mypy does not follow the import hook of editable ones.
        env={**os.environ, "PYTHONPATH": str(ROOT)},
    )  # fmt: skip
    *found, _ = done.stdout.splitlines()
    assert len(found) == len(EXPECTED), done.stdout
    for line, expected in zip(found, EXPECTED, strict=True):
        assert expected in line
