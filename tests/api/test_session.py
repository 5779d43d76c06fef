"""A session from Python: the same run as on the command line, read and changed in SI units."""

from __future__ import annotations

import json

import pytest

import crs_cc
from crs_cc.cli.main import main

WORLD = """<world version="1" seed="4" duration="3s"><area length="6m" width="5m"/>
  <robot x="1m" y="1m"/><robot x="4m" y="1m" heading="180deg"/>
  <box id="crate" x="2m" y="4m" length="40cm" width="40cm" mass="5kg" heat="10"/>
  <wall id="screen" x1="5m" y1="3m" x2="5m" y2="4m"/></world>"""
AHEAD = """#include "Nclient.h"
#include <stdio.h>
int main(void) { connect_robot(1); vm(100, 100, 0); printf("off\\n"); return 3; }
"""


@pytest.fixture
def session() -> crs_cc.Session:
    return crs_cc.Session(WORLD, AHEAD)


def test_the_run_is_that_of_the_command_line(capfd: pytest.CaptureFixture[str]) -> None:
    program, place = "samples/scout_c/mixed.c", "worlds/mixed.xml"
    options = ["--setup", "noisy", "--seed", "5", "--max-time", "4", "--json", "-q"]
    assert main(["run", program, place, *options]) == 0
    told = json.loads(capfd.readouterr().out)
    world = crs_cc.load_world(place, setup="noisy")
    session = crs_cc.Session(world, program, seed=5, duration_s=4.0)
    session.on("collision", lambda event: None)
    while session.step():
        assert session.robots["nomad"].sonar.shape == (16,)
        assert session.poses.shape == (5, 3)
    assert session.result().state_hash == told["state_hash"]
    other = crs_cc.Session(world, program, seed=6)
    assert other.run(until_s=4.0).state_hash != told["state_hash"]


def test_duration_and_seed_are_the_worlds_unless_told() -> None:
    for given, expected in ((None, (3.0, 4)), (1.0, (1.0, 9))):
        session = crs_cc.Session(WORLD, AHEAD, duration_s=given, seed=None if given is None else 9)
        assert (session.duration_s, session.seed) == expected


def test_a_run_ends_when_all_programs_have_ended(session: crs_cc.Session) -> None:
    result = session.run()
    assert [robot.exit_status for robot in result.robots] == [3, 3]
    assert session.is_over
    assert session.robots["robot1"].stdout == "off\n"
