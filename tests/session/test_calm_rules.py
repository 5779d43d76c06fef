"""Rules of calm time that few worlds need: of each, a world in which breaking it is noticed."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.session.session import Session
from crs_cc.sim import files
from crs_cc.sim.engine import calm_time
from crs_cc.sim.engine.passage import Passage
from crs_cc.sim.files.world_xml import load_world
from crs_cc.sim.kernels.calm import ANSWER
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
NAPS = """
#include <Nclient.h>
#include <unistd.h>
int main(void) { connect_robot(1); vm(9, 9, 0); for (;;) { get_rc(); usleep(7000); gs(); } }
"""
DRIVES = """
#include <Nclient.h>
int main(void) { connect_robot(1); vm(100, 100, 0); for (;;) gs(); }
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


class Sizes(Observer):
    """Notes how much is logged of passages."""

    passages = most_frames = most_answers = 0

    def passed(self, passage: Passage) -> None:
        self.passages += 1
        self.most_frames = max(self.most_frames, passage.count)
        self.most_answers = max(self.most_answers, len(passage.logged) // ANSWER.itemsize)


def world_of(folder: Path, robots: str, attributes: str = "") -> WorldModel:
    scout = (Path(files.__file__).parent / "robots" / "scout.xml").read_text()
    (folder / "noisy.xml").write_text(scout.replace(' noise="0in"', ' noise="2cm"'))
    mistaken = scout.replace(' noise="0in"', ' noise="1cm" crosstalk="1"')
    (folder / "mistaken.xml").write_text(mistaken)
    weary = scout.replace('"408Wh" power="5W"', '"0.002Wh" power="3W"')
    (folder / "weary.xml").write_text(weary)
    (folder / "quick.xml").write_text(QUICK)
    text = f'<area length="8m" width="5m"/>{robots.format(attributes, attributes)}'
    (folder / "world.xml").write_text(f'<world version="1" timestep="50ms">{text}</world>')
    return load_world(folder / "world.xml")


def test_requests_that_take_no_time_on_the_link_are_charged(tmp_path: Path) -> None:
    world = world_of(tmp_path, ALONE, 'definition="quick.xml"')
    assert compare(world, [build(tmp_path, ASKS)], 6) > 1


def test_programs_that_have_ended_are_not_waited_for(tmp_path: Path) -> None:
    assert compare(world_of(tmp_path, PAIR), [build(tmp_path, ENDS)] * 2, 40) > 5


def test_a_speed_above_the_limit_is_reported(tmp_path: Path) -> None:
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
    programs = [build(tmp_path, LISTENS)] * 2
    assert compare(world, programs, 30) > 5
    observer = Sizes()
    session, _ = start(world, programs, observer)
    while session.timesteps < 30:
        session.advance(30 - session.timesteps, calmly=True)
    assert observer.passages > 3
    assert 0 < observer.most_frames <= frames
    assert 0 < observer.most_answers <= answers


def test_a_goal_is_judged_when_a_robot_may_have_reached_it(tmp_path: Path) -> None:
    goal = '<goal><reach x="2.7m" y="2m" radius="0.3m" stay="0.2s"/></goal>'
    world = world_of(tmp_path, ALONE + goal)
    assert compare(world, [build(tmp_path, DRIVES)], 60) > 20
    session, _ = start(world, [build(tmp_path, DRIVES)], Observer())
    while session.timesteps < 60:
        session.advance(60 - session.timesteps, calmly=True)
    assert [each.status for each in session.goals] == ["met"]


def test_a_robot_whose_battery_is_empty_stops(tmp_path: Path) -> None:
    world = world_of(tmp_path, ALONE, 'definition="weary.xml"')
    assert compare(world, [build(tmp_path, DRIVES)], 50) > 5
    session, _ = start(world, [build(tmp_path, DRIVES)], Observer())
    while session.timesteps < 50:
        session.advance(50 - session.timesteps, calmly=True)
    assert session.environment.state.drive.limp[0, :2].all()


def test_each_request_gets_one_reply(tmp_path: Path) -> None:
    assert compare(world_of(tmp_path, PAIR), [build(tmp_path, NAPS)] * 2, 20) > 5


def test_requests_are_answered_by_rising_codes(tmp_path: Path) -> None:
    programs = [build(tmp_path, text, f"{len(text)}.c") for text in (LISTENS, DRIVES)]
    assert compare(world_of(tmp_path, PAIR), programs, 20) > 5
    assert compare(world_of(tmp_path, PAIR), programs[::-1], 20) > 5


def test_sonars_that_make_mistakes_fire_in_python(tmp_path: Path) -> None:
    facing = ALONE + '<robot id="b" x="4m" y="2m" heading="180deg" {}/>'
    world = world_of(tmp_path, facing, 'definition="mistaken.xml"')
    compare(world, [build(tmp_path, LISTENS)] * 2, 40)


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
