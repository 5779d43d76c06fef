"""Drawing into the simulator's window."""

from __future__ import annotations

import pytest

from crs_cc.sim.engine.drawings import drawings_in
from tests.nclient.drive import drive

DRAWINGS = """connect_robot(1);
printf("%d ", draw_line(-10, 20, 30, 40, 1)); printf("%d ", draw_arc(1, 2, 3, 4, 5, 6, 22));
printf("%d ", draw_robot(100, 200, 900, 1800, 2)); printf("%d ", draw_line(1, 1, 2, 2, 23));
draw_robot(100, 200, 900, 1800, 2);
"""


@pytest.mark.function("draw_line", "draw_arc", "draw_robot")
def test_marks_appear_in_picture():
    done = drive(DRAWINGS)
    assert done.numbers == [1, 1, 1, 1]  # the reply is not looked at
    drawn = drawings_in(done.session.environment.state.drawings)
    assert [(one.kind, one.numbers, one.colour, one.xor) for one in drawn] == [
        (1, (-10, 20, 30, 40, 0, 0), "Black", False),
        (2, (1, 2, 3, 4, 5, 6), "Maroon", True),
        (3, (100, 200, 900, 1800, 0, 0), "Black", False),
    ]
    assert len([one for step in done.steps for one in step.drawings]) == 4


@pytest.mark.function(
    "refresh_all", "refresh_all_traces", "refresh_actual_trace", "refresh_encoder_trace",
    "refresh_all_sensors", "refresh_bumper_sensor", "refresh_infrared_sensor",
    "refresh_sonar_sensor", "refresh_laser_sensor", "refresh_client_graphics",
)  # fmt: skip
@pytest.mark.parametrize(
    ("what", "left"),
    [
        ("all", 0),
        *[(f"{name}_trace", 3) for name in ("actual", "encoder")],
        *[(f"{name}_sensor", 3) for name in ("bumper", "infrared", "sonar", "laser")],
        ("all_traces", 3),
        ("all_sensors", 3),
        ("client_graphics", 0),
    ],
)
def test_marks_are_at_requested_positions(what, left):
    done = drive(f'{DRAWINGS} printf("%d", refresh_{what}());')
    assert done.numbers == [1, 1, 1, 1, 1]
    assert len(drawings_in(done.session.environment.state.drawings)) == left


def test_drawing_takes_network_time():
    done = drive("int n = 0; connect_robot(1); while (n < 1000) draw_line(n++, 0, 0, 0, 1);")
    assert done.session.time_s == pytest.approx(1.0, abs=0.1)
