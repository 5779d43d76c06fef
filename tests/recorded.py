"""A recording of a short run, made once: a robot drives against a wall, reads and prints."""

from __future__ import annotations

import io
import sys
from pathlib import Path
from unittest import mock

import pytest

from crs_cc.cli.main import main
from crs_cc.recording import recording_file

PROGRAM = r"""
#include <Nclient.h>
#include <stdio.h>
#include <unistd.h>
#include "speed.h"

int main(void)
{
    char line[80];
    int i;

    if (fgets(line, sizeof line, stdin))
        printf("told %s", line);
    connect_robot(1);
    conf_tm(0);
    vm(SPEED, SPEED, 0);
    for (i = 0; i < 12; i++) {
        get_sn();
        printf("%d %d\n", i, (int)State[STATE_SONAR_0]);
        usleep(500000);
    }
    printf("\377end\n");
    return 3;
}
"""
WORLD = """<world version="1" timestep="50ms">
  <area length="4m" width="3m"/>
  <box id="crate" x="3m" y="1m" length="0.4m" width="0.4m" mass="5kg"/>
  <robot x="1m" y="1m"/>
</world>
"""


@pytest.fixture(scope="session")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the recording."""
    folder = tmp_path_factory.mktemp("recorded")
    (folder / "speed.h").write_text("#define SPEED 200\n")
    (folder / "drive.c").write_text(PROGRAM)
    (folder / "room.xml").write_text(WORLD)
    path = folder / "run.mcap"
    files = [str(folder / name) for name in ("drive.c", "room.xml")]
    printed = io.TextIOWrapper(io.BytesIO(), errors="surrogateescape")  # not all of it is text
    with (
        mock.patch.object(sys, "stdin", io.TextIOWrapper(io.BytesIO(b"go\nmore\n"))),
        mock.patch.object(sys, "stdout", printed),
        mock.patch.object(recording_file, "BLOCK_S", 2.0),
    ):
        assert main(["run", *files, "--record", str(path), "--quiet", "--max-time", "8"]) == 3
    for name in ("speed.h", "drive.c", "room.xml"):
        (folder / name).unlink()  # the recording is all that is left
    return path
