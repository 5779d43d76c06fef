"""The plot of a run does not depend on whether timesteps are reported singly or as passages."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from crs_cc.cli.run_plot import RunPlot
from crs_cc.cli.summary import Run
from crs_cc.plot.tracks import Tracks
from crs_cc.session.session import Session
from crs_cc.sim.engine.passage import Passage
from crs_cc.sim.engine.step import Step
from crs_cc.sim.files.world_xml import parse_world
from crs_cc.sim.model.world import WorldModel
from tests.session.programs import build

WORLD = """<world version="1"><area length="6m" width="5m"/>
<box x="3m" y="4m" length="1m" width="1m"/>
<robot id="a" x="1m" y="1m" heading="40deg"/><robot id="b" x="3m" y="2m"/>
<robot id="late" x="5m" y="1m" join="3s"/></world>"""

PROGRAM = """
#include <Nclient.h>
#include <unistd.h>
int main(void)
{
    int i;
    connect_robot(1);
    for (;;) {
        for (i = 0; i < 30; i++) { vm(90, 20 + i, 0); get_sn(); }
        st();
        sleep(2);
    }
}
"""


class Plotted:
    """An observer that plots; of passages, too, if it is `Calm`."""

    def __init__(self) -> None:
        self.plot, self.robots = RunPlot(), 3

    def step(self, step: Step) -> None:
        self.plot.add_contacts(step, self.robots)


class Calm(Plotted):
    session: Session
    passed_over = 0

    def passed(self, passage: Passage) -> None:
        self.passed_over += len(passage.frames)
        self.plot.add_passage(self.session, passage)


def picture(observer: Plotted, world: WorldModel, program: Path, most: int) -> bytes:
    session = Session(
        world, [build(program, PROGRAM)] * 3, 1, threads=1, observer=observer,
    )  # fmt: skip
    if isinstance(observer, Calm):
        observer.session = session
    observer.plot.sample(session)
    while session.timesteps < 300:
        session.advance(min(most, 300 - session.timesteps), calmly=most > 1)
        observer.plot.sample(session)
    run = Run(session.result(), "w.xml", 1, 0.0, interrupted=False, calls=())
    return observer.plot.picture(session, run, ["p.c"] * 3, sensors=False)


def test_a_plot_of_passages_is_that_of_single_timesteps(tmp_path: Path) -> None:
    world, calm = parse_world(WORLD.encode(), "w"), Calm()
    assert picture(Plotted(), world, tmp_path, 1) == picture(calm, world, tmp_path, 300)
    assert calm.passed_over > 50


@pytest.mark.parametrize("most", [4, 1000])
def test_timesteps_in_which_nothing_moves_count(most: int) -> None:
    one_by_one, at_once = Tracks(most), Tracks(most)
    for x_m, count in ((0.0, 1), (0.5, 7), (0.7, 1), (0.9, 12)):
        places = np.array([x_m]), np.array([0.0])
        for _ in range(count):
            one_by_one.add(*places)
        at_once.add(*places)
        at_once.repeat_last(count - 1)
    assert one_by_one.path(0).tolist() == at_once.path(0).tolist()
    assert one_by_one.places_at(0, 3) == at_once.places_at(0, 3)
