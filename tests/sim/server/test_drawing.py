"""What programs draw into the picture, and what they erase."""

import math

import numpy as np
import pytest

from crs_cc.sim.engine.drawings import ARC, ARROW, COLOURS, LINE, ROBOT, Drawing, drawings_in
from crs_cc.sim.engine.server import drawing
from tests.sim.driver import INCH, Driver, open_world


def draw(driver: Driver, kind: int, *numbers: int, mode: int, robot: int = 0) -> int:
    padded = [*numbers, 0, 0, 0, 0, 0, 0][:6]
    message, _ = driver.post("DRAW", kind, *padded, mode, robot=robot)
    return int(message["result"])


def shown(driver: Driver) -> list[tuple[int, int, str]]:
    """Return kind, first number and colour of all that is drawn."""
    return [(one.kind, one.numbers[0], one.colour) for one in drawings_in(driver.state.drawings)]


def test_every_mode_has_its_colour():
    assert len(COLOURS) == 20
    for kind, last in ((LINE, 2), (ARC, 2), (ROBOT, 3)):
        driver = Driver.of(open_world())
        told = [draw(driver, kind, mode, mode=mode) for mode in range(-1, last + 22)]
        assert told == [0, 0, *[1] * (last + 20), 0]
        colours = [colour for kind, _, colour in shown(driver) if kind != ARROW]
        assert colours == ["Black"] * last + list(COLOURS)


def test_what_is_drawn_twice_by_exclusive_or_is_gone_and_what_is_copied_stays():
    driver = Driver.of(open_world('<robot x="0" y="0"/><robot x="3m" y="0"/>'))
    for mode in (1, 2, 3):
        draw(driver, LINE, 7, mode=mode)
    assert shown(driver) == [(LINE, 7, "Black"), (LINE, 7, "Black"), (LINE, 7, "Blue")]
    for mode in (1, 2, 3):
        draw(driver, LINE, 7, mode=mode)
    assert shown(driver) == [(LINE, 7, "Black")]
    draw(driver, LINE, 8, mode=2)
    draw(driver, LINE, 8, mode=2, robot=1)  # another program's
    draw(driver, LINE, 8, 1, mode=2)  # another line
    assert len(shown(driver)) == 4


def test_a_robot_drawn_in_mode_2_leaves_an_arrow_when_it_is_gone():
    driver = Driver.of(open_world())
    draw(driver, ROBOT, 100, 200, 900, 900, mode=2)
    assert [kind for kind, _, _ in shown(driver)] == [ROBOT, ARROW]
    draw(driver, ROBOT, 100, 200, 900, 900, mode=2)
    assert [kind for kind, _, _ in shown(driver)] == [ARROW]


def test_shapes_that_nobody_knows_are_refused():
    driver = Driver.of(open_world())
    assert [draw(driver, kind, 1, mode=1) for kind in (-1, ARROW, 4, 2**31 - 1)] == [0] * 4
    assert shown(driver) == []


def test_two_of_the_refresh_functions_take_the_drawings_of_all_programs_away():
    driver = Driver.of(open_world('<robot x="0" y="0"/><robot x="3m" y="0"/>'))
    for what, left in [(0, 0), *[(n, 1) for n in range(1, 9)], (9, 0), (10, 1), (-1, 1)]:
        driver.post("REFRESH", 0)
        draw(driver, LINE, 7, mode=1, robot=1)
        message, _ = driver.post("REFRESH", what)
        assert len(shown(driver)) == left
        assert message["result"] == (0 <= what <= 9)


def test_of_very_many_marks_the_oldest_are_forgotten(monkeypatch):
    monkeypatch.setattr(drawing, "MAX_OWN", 3)
    monkeypatch.setattr(drawing, "MAX_ALL", 4)
    driver = Driver.of(open_world('<robot x="0" y="0"/><robot x="3m" y="0"/>'))
    for number in range(5):
        draw(driver, LINE, number, mode=1)
    assert [x for _, x, _ in shown(driver)] == [2, 3, 4]
    for number in range(10, 13):
        draw(driver, LINE, number, mode=1, robot=1)
    assert [x for _, x, _ in shown(driver)] == [4, 10, 11, 12]
    draw(driver, LINE, 4, mode=1)  # the same again takes no room
    assert [x for _, x, _ in shown(driver)] == [10, 11, 12, 4]


def test_a_step_tells_what_was_drawn_in_it():
    driver = Driver.of(open_world())
    draw(driver, LINE, 1, 2, 3, 4, mode=5)
    draw(driver, LINE, 1, 2, 3, 4, mode=99)
    draw(driver, ARC, 1, 2, 3, 4, 5, 6, mode=1)
    first, second = driver.run(2)
    assert [(one.kind, one.numbers, one.colour) for one in first.drawings] == [
        (LINE, (1, 2, 3, 4, 0, 0), "RoyalBlue"),
        (ARC, (1, 2, 3, 4, 5, 6), "Black"),
    ]
    assert second.drawings == ()


def test_the_picture_belongs_to_a_snapshot():
    driver = Driver.of(open_world())
    draw(driver, LINE, 1, mode=1)
    snapshot, before = driver.environment.snapshot(), driver.environment.hash()
    draw(driver, LINE, 2, mode=1)
    assert driver.environment.hash() != before
    driver.environment.restore(snapshot)
    assert driver.environment.hash() == before
    assert shown(driver) == [(LINE, 1, "Black")]


def test_strokes_lie_where_the_program_said():
    (arc,) = Drawing.of(0, [ARC, 100, 400, 200, 100, 0, 900, 1]).strokes_m(0.2)
    assert arc[0] == pytest.approx((30 * INCH, 35 * INCH))
    assert arc[-1] == pytest.approx((20 * INCH, 40 * INCH))
    (whole,) = Drawing.of(0, [ARC, 100, 400, 200, 100, -1800, 2**31 - 1, 1]).strokes_m(0.2)
    assert whole[0] == pytest.approx(whole[-1])
    body, front = Drawing.of(0, [ROBOT, 100, 0, 900, 900, 0, 0, 1]).strokes_m(0.2)
    assert np.hypot(*(body - (10 * INCH, 0)).T) == pytest.approx(0.2)
    assert front[1] == pytest.approx((10 * INCH, 0.2))
    assert len(Drawing.of(0, [ROBOT, 100, 0, 900, 0, 0, 0, 1]).strokes_m(0.2)) == 3
    (arrow,) = Drawing.of(0, [ARROW, 0, 0, 450, 450, 0, 0, 3]).strokes_m(0.2)
    assert math.atan2(*arrow[1][::-1]) == pytest.approx(math.pi / 4)
