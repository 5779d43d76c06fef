"""Infrared rings and compasses measure the same in calm time as without it."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from crs_cc.runtime.executable import Executable
from crs_cc.session.session import Session
from crs_cc.sim import files
from crs_cc.sim.devices.compass import compasses
from crs_cc.sim.devices.infrared import rings
from crs_cc.sim.files.world_xml import load_world
from crs_cc.sim.model.world import WorldModel
from tests.session.both_ways import compare
from tests.session.programs import build

LOOKS = r"""
#include <Nclient.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
#include "crs.h"

static int order[16];

static void choose(int share)
{
    int i;

    for (i = 0; i < 16; i++)
        Smask[1 + i] = rand() % share == 0;
    Smask[43] = rand() % share == 0;
    ct();
}

static void set_up(void)
{
    int i, n = rand() % 17;

    for (i = 0; i < 16; i++)
        order[i] = i < n ? (i + n) % 16 : 255;
    conf_ir(rand() % 11, order);
    conf_cp(rand() % 4 != 0);
}

int main(int argc, char **argv)
{
    connect_robot(1);
    srand(atoi(argv[1]));
    if (rand() % 2)
        set_up();
    for (;;) {
        switch (rand() % 90) {
        case 0: set_up(); break;
        case 1: choose(2); break;
        case 2: choose(40); break;
        case 3: init_mask(); ct(); break;
        case 4: crs_period(CRS_SENSOR_INFRARED, 300 * (rand() % 2)); break;
        case 5: crs_period(CRS_SENSOR_COMPASS, 300 * (rand() % 2)); break;
        case 6: st(); break;
        default:
            usleep(1000 * (rand() % 40));
            vm(rand() % 60 - 20, rand() % 60 - 20, rand() % 60 - 30);
            get_ir();
            printf("%ld %ld %ld\n", State[STATE_IR_0], State[STATE_IR_5], State[STATE_IR_11]);
            rand() % 4 ? get_sn() : get_cp();
            printf("%ld %ld\n", State[STATE_COMPASS], State[STATE_IR_3]);
            gs();
        }
    }
}
"""
HALL = """<area length="5m" width="4m"/><box x="2.6m" y="2m" length="0.5m" width="0.3m"/>
<cylinder x="1.7m" y="3.2m" radius="15cm"/>"""
ROBOTS = """<robot id="a" x="1m" y="2m" {0}/><robot id="b" x="1.9m" y="1m" heading="70deg" {1}/>
<robot id="c" x="3.6m" y="2m" heading="180deg" {2}/>"""
RING = 'definition="{}.xml"'
NOISY, PLAIN, NOMAD = (RING.format(name) for name in ("noisy", "plain", "nomad"))
WORLDS = {
    "rings": HALL + ROBOTS.format(PLAIN, PLAIN, PLAIN),
    "noisy rings": HALL + ROBOTS.format(NOISY, NOISY, NOISY),
    "mixed": HALL + ROBOTS.format(NOISY, NOMAD, PLAIN),
    "not all have one": HALL + ROBOTS.format(NOISY, "", NOMAD),
    "rings fail": HALL + ROBOTS.format(PLAIN, NOISY, PLAIN)
    + '<degradation robot="a" device="infrared" onset="2.2s" duration="1s" noise="0.2m"/>'
    + '<degradation robot="b" device="compass" onset="4.2s" duration="1s" noise="9deg"/>',
    "dark objects": HALL
    + '<material name="dark" infrared="0.3"/>'
    + '<box x="4.5m" y="3m" length="0.5m" width="0.3m" material="dark"/>'
    + ROBOTS.format(PLAIN, NOISY, PLAIN),
}  # fmt: skip
CALM = {"rings fail": 30, "dark objects": 0}


def world_of(name: str, folder: Path) -> WorldModel:
    robots = Path(files.__file__).parent / "robots"
    scout, nomad = ((robots / f"{each}.xml").read_text() for each in ("scout", "nomad200"))
    device = '<infrared step="{}" noise="{}" history="{}" rate="{}Hz"/><compass on="yes" {}/>'
    for kind, values in {
        "plain": ("0.2m", "0m", "0", "12", 'offset="30deg"'),
        "noisy": ("8cm", "60cm", "4", "100", 'noise="2deg" deviation="9deg"'),
    }.items():
        content = re.sub("(<sonars .*?/>)", rf"\1{device.format(*values)}", scout, count=1)
        (folder / f"{kind}.xml").write_text(content)
    without_laser = re.sub("<laser [^>]*/>", "", nomad).replace('step="1in"', 'step="0.1m"')
    (folder / "nomad.xml").write_text(without_laser)
    file = folder / "world.xml"
    file.write_text(f'<world version="1" timestep="50ms">{WORLDS[name]}</world>')
    return load_world(file)


@pytest.fixture(scope="module")
def looking(tmp_path_factory: pytest.TempPathFactory) -> Executable:
    """Return the program that looks, for all worlds."""
    return build(tmp_path_factory.mktemp("looks"), LOOKS)


@pytest.mark.parametrize("world", WORLDS)
def test_rings_and_compasses_measure_the_same(
    world: str, looking: Executable, tmp_path: Path
) -> None:
    model = world_of(world, tmp_path)
    passed = compare(model, [looking] * 3, 160)
    assert passed >= CALM.get(world, 80)


def test_errors_are_drawn_as_often_as_they_are_needed(tmp_path: Path) -> None:
    program = "#include <Nclient.h>\nint main(void) { connect_robot(1); for (;;) get_ir(); }"
    model = world_of("noisy rings", tmp_path)
    assert compare(model, [build(tmp_path, program)] * 3, 90) > 80


def test_the_programs_see_something(looking: Executable, tmp_path: Path) -> None:
    session = Session(world_of("mixed", tmp_path), [looking] * 3, 5)
    while session.timesteps < 100:
        session.step()
    state = session.environment.state
    assert len(set(rings(state).level.ravel().round(1))) > 12
    assert np.count_nonzero(compasses(state).reading) >= 2
