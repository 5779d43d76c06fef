"""The world as rows."""

from crs_cc.debug.world.rows import lines
from crs_cc.debug.world.world_rows import world_rows
from tests.sim.driver import Driver, world_of


def test_world_rows_have_time_robots_objects_and_messages() -> None:
    driver = Driver.of(
        world_of(
            '<robot id="a" x="2m" y="2m"/><robot id="b" x="4m" y="2m"/>'
            '<robot id="c" x="8m" y="8m" join="5s"/>'
            '<box id="crate" x="6m" y="6m" length="1m" width="1m" mass="5kg" heading="90deg"/>'
            '<wall id="screen" x1="3m" y1="0" x2="3m" y2="1m"/>'
        )
    )
    driver.ask("SEND", 1, -1, 3, 0, data=b"x")
    driver.ask("ADD_OBSTACLE", 3, data=_corners((10, 10), (20, 10), (20, 20)))
    for _ in range(3):
        driver.environment.step()
    assert list(lines(world_rows(driver.environment))) == [
        "world      test",
        "time       0.150 s, timestep 3 of 50 ms",
        "area       10.000 m by 10.000 m from 0.000, 0.000 m",
        "robots     2 of 3 in the world",
        "  a  2.000, 2.000 m, 0.0 deg",
        "  b  4.000, 2.000 m, 0.0 deg",
        "  c  not in the world",
        "objects    6 fixed, 1 movable",
        "  crate  6.000, 6.000 m, 90.0 deg",
        "obstacles  1 added by programs",
        "radio      1 messages sent",
        "  sent       1",
        "  delivered  1",
    ]


def _corners(*places: tuple[int, int]) -> bytes:
    return b"".join(number.to_bytes(4, "little") for place in places for number in place)
