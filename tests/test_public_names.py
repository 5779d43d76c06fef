"""What `import crs_cc` offers."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

import crs_cc

WORLD = '<world version="1"><area length="5m" width="5m"/><robot x="2m" y="2m"/></world>'
PROGRAM = """#include "Nclient.h"
int main(void) { connect_robot(1); pr(100, 100, 0); ws(1, 1, 0, 20); return 7; }
"""


def test_a_program_runs_in_a_world(tmp_path: Path) -> None:
    program, world = tmp_path / "ahead.c", tmp_path / "room.xml"
    program.write_text(PROGRAM)
    world.write_text(WORLD)
    session = crs_cc.Session(crs_cc.load_world(world), [crs_cc.compile_c(str(program))])
    while session.step():
        pass
    (robot,) = session.result().robots
    assert robot.exit_status == 7
    assert robot.pose == pytest.approx((2.254, 2.0, 0.0), abs=1e-6)


def test_whose_fault_it_is_says_the_errors_class(tmp_path: Path) -> None:
    path = tmp_path / "wrong.c"
    path.write_text("int main(void) { return sped; }\n")
    with pytest.raises(crs_cc.CompileError, match="sped"):
        crs_cc.compile_c(path)


def test_every_public_name_is_there_and_no_other() -> None:
    for name in crs_cc.__all__:
        assert getattr(crs_cc, name).__name__ == name
    with pytest.raises(AttributeError, match="'compile_d'"):
        crs_cc.compile_d  # noqa: B018


def test_importing_the_package_imports_nothing_heavy() -> None:
    code = (
        "import sys, crs_cc\n"
        "heavy = {'numpy', 'wasmtime', 'pymunk', 'lxml', 'pycparser', 'click'} & set(sys.modules)\n"
        "sys.exit(f'imported {heavy}' if heavy else 0)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
