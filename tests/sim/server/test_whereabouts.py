"""Where robots are told to be."""

import numpy as np
import pytest

from tests.sim.driver import INCH, Driver, open_world


def poses(driver: Driver, first: int) -> tuple[int, list[list[int]]]:
    message, _ = driver.post("GET_RPX", first)
    return int(message["result"]), message["data"][: message["size"]].view("<i4").reshape(
        -1, 3
    ).tolist()


def test_many_robots_are_told_page_by_page():
    robots = "".join(f'<robot x="{20 * n}in" y="-3in" heading="{n}deg"/>' for n in range(45))
    driver = Driver.of(open_world(robots))
    told = []
    for first in (0, 20, 40):
        count, page = poses(driver, first)
        assert count == 45
        told += page
    assert told == [[200 * n, -30, 10 * n] for n in range(45)]
    for nobody in (45, 46, 2**31 - 1):
        assert poses(driver, nobody) == (45, [])
    assert poses(driver, -5)[1] == told[:20]


def test_robots_are_told_where_they_are_and_not_where_they_believe_to_be():
    driver = Driver.of(open_world('<robot x="30in" y="40in" heading="350deg"/>'))
    driver.ask("DP", 7, 7)
    assert poses(driver, 0) == (1, [[300, 400, 3500]])
    driver.ask("VM", 100, 100)
    driver.run_s(2)
    x, y, _ = poses(driver, 0)[1][0]
    assert (x, y) == (
        pytest.approx(driver.state.x_m[0] / INCH * 10, abs=0.5),
        pytest.approx(driver.state.y_m[0] / INCH * 10, abs=0.5),
    )
    assert np.hypot(x - 300, y - 400) > 100
