"""Programs and worlds for the tests of sessions."""

from __future__ import annotations

from pathlib import Path

from crs_cc.core.source import Diagnostics
from crs_cc.runtime.executable import Executable
from crs_cc.session.build import build_executable
from crs_cc.session.session import Session
from crs_cc.sim.files.world_xml import parse_world
from crs_cc.sim.model.world import WorldModel

HALL = parse_world(
    b"""<world version="1">
    <area length="8m" width="4m"/>
    <box id="crate" x="4m" y="2m" length="0.5m" width="0.5m" mass="5kg"/>
    <robot id="left" x="1m" y="2m"/>
    <robot id="right" x="7m" y="2m" heading="180deg"/>
    </world>""",
    "hall.xml",
)

ROAM = r"""
#include <stdio.h>
#include "Nclient.h"

int main(void)
{
    int turns = 0;
    if (!connect_robot(1))
        return 1;
    ac(300, 300, 0);
    for (;;) {
        get_sn();
        if (State[STATE_SONAR_0] < 15) {
            vm(60, -60, 0);
            turns++;
        } else {
            vm(150, 150, 0);
        }
        printf("%ld %ld %ld %d\n", State[STATE_SONAR_0], State[STATE_CONF_X],
               State[STATE_CONF_Y], turns);
    }
}
"""

LOOP = "int main(void) { for (;;) ; }\n"


def build(folder: Path, source: str, name: str = "program.c", *, debug: bool = False) -> Executable:
    path = folder / name
    path.write_text(source)
    return build_executable([path], Diagnostics(), debug=debug)


def run(world: WorldModel, programs: list[Executable], steps: int, seed: int = 0) -> Recorded:
    """Run some timesteps; keeps what the robots wrote."""
    recorded = Recorded(world, programs, seed)
    for _ in range(steps):
        if not recorded.session.step():
            break
    return recorded


class Recorded:
    """A session with everything that its robots wrote."""

    def __init__(self, world: WorldModel, programs: list[Executable], seed: int) -> None:
        self.written = written = [bytearray() for _ in programs]
        self.session = Session(
            world,
            programs,
            seed,
            output=lambda robot, _stream, content: written[robot].extend(content),
        )
