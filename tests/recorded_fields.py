"""A recording of a run with pheromone fields: a robot deposits, waits, and lays a trail."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.cli.main import main
from tests.device.robot import scout_with

PROGRAM = """\
#include <Nclient.h>
#include <crs.h>
#include <unistd.h>

int main(void)
{
    connect_robot(1);
    usleep(1500000);
    crs_deposit(0, 40.0);       /* evaporates undisturbed for three seconds */
    usleep(3000000);
    crs_deposit(1, 3.0);        /* spreads */
    crs_lay_trail(0, 100.0);
    vm(100, 100, 0);
    usleep(2000000);
    return 0;
}
"""
WORLD = """<world version="1" timestep="50ms">
  <area length="12m" width="4m" origin="centre"/>
  <field name="trail" cell="10cm" evaporation="2s"/>
  <field name="smoke" cell="10cm" diffusion="20cm2/s"/>
  <robot definition="scout-with.xml" x="1m" y="1m" program="lay.c"/>
</world>
"""


@pytest.fixture(scope="session")
def fields_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the folder of a run, with its world `room.xml` and its recording `run.mcap`."""
    made = tmp_path_factory.mktemp("fields")
    scout_with(made, '<gland most="1000"/>')
    (made / "lay.c").write_text(PROGRAM)
    (made / "room.xml").write_text(WORLD)
    assert record(made, made / "run.mcap") == 0
    return made


def record(folder: Path, path: Path) -> int:
    """Record the run; return the exit status."""
    return main(["run", str(folder / "room.xml"), "--record", str(path), "--quiet"])
