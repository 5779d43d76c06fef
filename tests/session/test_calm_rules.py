"""Rules of calm time that few worlds need: of each, a world in which breaking it is noticed."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.session.session import Session
from crs_cc.sim import files
from crs_cc.sim.engine import calm_time
from crs_cc.sim.files.world_xml import load_world
from crs_cc.sim.model.world import WorldModel
from tests.session.both_ways import Observer, compare, start
from tests.session.programs import build

QUICK = """<robot-definition version="1" name="quick">
  <body radius="20cm" mass="10kg"/>
  <drive wheel-base="34cm" speed-limit="0.3m/s" acceleration-limit="2m/s2" speed="0.3m/s"
         acceleration="2m/s2"/>
  <sonars order=""/>
  <infrared step="0.4m"/>
  <link baud="115200"><command name="VM" sends="12" receives="48"/></link>
</robot-definition>
"""
ALONE = '<robot id="a" x="2m" y="2m" {}/>'
PAIR = ALONE + '<robot id="b" x="6m" y="3m" {}/>'
ASKS = """
#include <Nclient.h>
int main(void) { connect_robot(1); for (;;) { gs(); gs(); vm(30, 20, 0); } }
"""
LISTENS = """
#include <Nclient.h>
int main(void) { connect_robot(1); vm(5, 5, 0); for (;;) get_sn(); }
"""
ENDS = """
#include <Nclient.h>
#include <stdlib.h>
int main(int argc, char **argv)
{
    int i, most = 10 * (atoi(argv[1]) - 999);
    connect_robot(1);
    for (i = 0; i < most; i++) { vm(20, 30, 0); gs(); }
    return 0;
}
"""
HASTENS = """
#include <Nclient.h>
int main(void)
{
    int i;
    connect_robot(1);
    for (i = 0; ; i++) { gs(); vm(i == 30 ? 900 : 20, 25, 0); }
}
"""


def world_of(folder: Path, robots: str, attributes: str = "") -> WorldModel:
    scout = (Path(files.__file__).parent / "robots" / "scout.xml").read_text()
    (folder / "noisy.xml").write_text(scout.replace(' noise="0in"', ' noise="2cm"'))
    (folder / "quick.xml").write_text(QUICK)
    text = f'<area length="8m" width="5m"/>{robots.format(attributes, attributes)}'
    (folder / "world.xml").write_text(f'<world version="1" timestep="50ms">{text}</world>')
    return load_world(folder / "world.xml")


def test_requests_that_take_no_time_on_the_link_are_charged(tmp_path: Path) -> None:
    world = world_of(tmp_path, ALONE, 'definition="quick.xml"')
    assert compare(world, [build(tmp_path, ASKS)], 6) > 1


def test_programs_that_have_ended_are_not_waited_for(tmp_path: Path) -> None:
    assert compare(world_of(tmp_path, PAIR), [build(tmp_path, ENDS)] * 2, 40) > 5


def test_a_speed_above_the_limit_is_told(tmp_path: Path) -> None:
    assert compare(world_of(tmp_path, ALONE), [build(tmp_path, HASTENS)], 40) > 5
    session, _ = start(world_of(tmp_path, ALONE), [build(tmp_path, HASTENS)], Observer())
    session.advance(40)
    while session.timesteps < 40:
        session.advance(40 - session.timesteps, calmly=True)
    assert [hint.flag for hint in session.hints] == ["speed-limit"]


@pytest.mark.parametrize(("frames", "answers"), [(3, 40_000), (512, 5)])
def test_passages_are_no_longer_than_what_is_logged_of_them(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, frames: int, answers: int
) -> None:
    monkeypatch.setattr(calm_time, "_CYCLES", frames)
    monkeypatch.setattr(calm_time, "_ANSWERS", answers)
    world = world_of(tmp_path, PAIR, 'definition="noisy.xml"')  # deviates follow in the memory
    assert compare(world, [build(tmp_path, LISTENS)] * 2, 30) > 5


def test_a_run_ends_with_the_last_program(tmp_path: Path) -> None:
    ends = []
    for is_allowed in (True, False):
        session, _ = start(world_of(tmp_path, ALONE), [build(tmp_path, ENDS)], Observer())
        session.calm.is_allowed = is_allowed
        ends.append((_timesteps(session), session.state_hash()))
    assert ends[0] == ends[1]
    assert ends[0][0] < 200


def _timesteps(session: Session) -> int:
    """Return how many timesteps a session runs, 200 at most."""
    while session.timesteps < 200 and session.advance(200 - session.timesteps, calmly=True):
        pass
    return session.timesteps
