"""`crs_deposit`, `crs_lay_trail`, `crs_smell` and `crs_smell_gradient` from C."""

import numpy as np
import pytest

import crs_cc
from crs_cc.sim.files.world_xml import parse_world
from tests.device.robot import scout_with
from tests.nclient.drive import drive

AREA = 'length="6m" width="6m" origin="centre"'
THERE = '<robot x="0" y="0"/><robot x="1.25m" y="0.25m"/><field name="trail" cell="10cm"/>'
WAIT = "usleep(200000);"
PUT = "crs_deposit(0, 8.0); return 0;"


def smell(folder, body: str, antennae: str = "", elements: str = THERE, put: str = PUT):
    """Return the run of a robot at (0, 0) that smells; the other one, ahead of it, deposits."""
    robot = scout_with(folder, f"<gland/><antennae {antennae}/>")
    return drive(WAIT + body, put, robot=robot, elements=elements, area=AREA)


@pytest.mark.function("crs_find_field", "crs_deposit", "crs_smell", "crs_smell_gradient")
def test_antennae_smell_what_lies_under_their_ends(tmp_path):
    """The ends are 1.3 m ahead, 11 degrees to each side: the left one is at (1.276, 0.248)."""
    body = """
        double ahead = 5, left = 5;
        printf("%d %d %d\\n", crs_find_field("trail"), crs_find_field("x"), crs_find_field(""));
        printf("%g %g ", crs_smell(0, 0), crs_smell(0, 1));
        printf("%g %g\\n", crs_smell(0, 2), crs_smell(1, 0));
        printf("%d ", crs_smell_gradient(0, &ahead, &left));
        printf("%.3f %.3f\\n", ahead, left);
        printf("%d %d\\n", crs_smell_gradient(1, &ahead, &left), crs_deposit(1, 1));
    """
    done = smell(tmp_path, body, 'reach="1.3m" apart="22deg"')
    assert done.numbers[:7] == [0, -1, -1, 0, 8, -1, -1]
    assert done.numbers[7:] == [1, 0, round(8 / (2 * 1.3 * np.sin(np.radians(11))), 3), 0, 0]


def test_three_antennae_tell_ahead_from_behind(tmp_path):
    """Only the one ahead smells: the plane through 8, 0 and 0 rises by 8 over 1.5 reaches."""
    elements = THERE.replace('y="0.25m"', 'y="0"').replace("10cm", "20cm")
    body = """
        double ahead, left;
        printf("%g %g %g\\n", crs_smell(0, 0), crs_smell(0, 1), crs_smell(0, 2));
        crs_smell_gradient(0, &ahead, &left);
        printf("%.4f %.4f\\n", ahead, left);
    """
    done = smell(tmp_path, body, 'number="3" reach="1.25m" apart="120deg"', elements)
    assert done.numbers == [0, 8, 0, round(8 / (1.5 * 1.25), 4), 0]


@pytest.mark.function("crs_lay_trail")
def test_trail_is_followed_by_its_smell(tmp_path):
    body = """
        double most = 0;
        connect_robot(1);
        printf("%d ", crs_lay_trail(0, 10.0));
        pr(200, 200, 0); ws(1, 1, 0, 20);
        printf("%d ", crs_lay_trail(0, 0.0));
        pr(-200, -200, 0); ws(1, 1, 0, 20);
        most = crs_smell(0, 0);
        printf("%d\\n", most > 0.8 && most < 1.2);
    """
    done = smell(tmp_path, body, 'number="1"', put="return 0;")
    assert done.numbers == [1, 1, 1]


def test_amounts_below_the_threshold_are_not_smelled(tmp_path):
    body = 'printf("%g\\n", crs_smell(0, 1));'
    place = 'reach="1.3m" apart="22deg"'
    assert smell(tmp_path, body, f'{place} threshold="8"').numbers == [8]
    assert smell(tmp_path, body, f'{place} threshold="8.01"').numbers == [0]


def test_noise_is_relative_and_degradations_follow(tmp_path):
    """2,000 readings: the standard error is 1.6% of the deviation."""
    body = 'int i; for (i = 0; i < 2000; i++) printf("%.9f\\n", crs_smell(0, 1));'
    place = 'reach="1.3m" apart="22deg" rate="1kHz"'
    readings = np.array(smell(tmp_path, body, f'{place} noise="0.1"').numbers)
    assert readings.std() == pytest.approx(0.8, rel=0.06)
    faults = '<degradation robot="robot0" device="antennae" element="0.1" gain="0.5" bias="1"/>'
    once = 'printf("%g %g\\n", crs_smell(0, 1), crs_smell(0, 0));'
    assert smell(tmp_path, once, place, THERE + faults).numbers == [5, 0]
    weak = '<degradation robot="robot1" device="gland" gain="0.25"/>'
    assert smell(tmp_path, once, place, THERE + weak).numbers == [2, 0]


def test_robot_without_gland_and_antennae_is_refused():
    program = "double a, b; return crs_deposit(0, 1) + crs_lay_trail(0, 1)"
    more = "+ crs_smell_gradient(0, &a, &b) + (crs_smell(0, 0) != -1.0);"
    elements = '<robot x="0" y="0"/><field name="trail"/>'
    assert drive(program + more, elements=elements, area=AREA).status == 0


def test_runs_are_the_same_in_any_number_of_threads(tmp_path):
    """Eight robots deposit in the same cells, and steer by what they smell."""
    program = tmp_path / "swarm.c"
    program.write_text("""
        #include "Nclient.h"
        #include "crs.h"
        int main(void)
        {
            int step;
            connect_robot(1);
            crs_lay_trail(0, 50.0);
            for (step = 0; step < 20; step++) {
                crs_deposit(0, 0.1 * (1 + crs_my_number()));
                vm(60 + (int)crs_smell(0, 0), 60 + (int)crs_smell(0, 1), 0);
            }
            return 0;
        }
    """)
    robot = scout_with(tmp_path, "<gland/><antennae/>")
    robots = "".join(f'<robot x="{-2 + n % 4}m" y="{n // 4}m"/>' for n in range(8))
    field = '<field name="trail" cell="2m" evaporation="1s"/>'
    text = f'<world version="1"><area {AREA}/>{field}{robots}</world>'
    world = parse_world(text.encode(), "test", "", robot)
    runs = [crs_cc.Session(world, program, threads=threads) for threads in (1, 2)]
    for run in runs:
        run.run(until_s=1.0)
    assert runs[0].field("trail").max() > 5
    assert runs[0].state_hash() == runs[1].state_hash()
