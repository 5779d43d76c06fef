"""A sensor of one's own: how far a robot is from a line on the floor, for C and for Python.

The row below is all that a sensor needs: its element in robot definitions, its request, its
function `crs_line` in C and its degradation follow from it. A sensor that is to be installed is the
same row in a package, as samples/plugins/uwb shows.

    python own_sensor.py
"""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

import crs_cc
from crs_cc.core.quantity import LENGTH
from crs_cc.sim.devices.number_sensor import Value, number_sensor
from crs_cc.sim.devices.sensor import Measurement
from crs_cc.sim.model.attribute import attribute, period, rate

LINE_Y_M = 2.0
PROGRAM = """
#include <Nclient.h>
#include <crs.h>

int main(void)
{
    int offset;                          /* 0.1 inch, positive to the left of the line */

    connect_robot(1);
    for (;;)
        if (crs_line(&offset)) {
            int heading = State[STATE_CONF_STEER] > 1800 ? State[STATE_CONF_STEER] - 3600
                                                         : State[STATE_CONF_STEER];
            int turn = -offset / 4 - heading / 12;

            vm(100 + turn, 100 - turn, 0);
            get_rc();
        }
}
"""


@dataclass(frozen=True, slots=True)
class LineSensor:
    """A sensor for a line on the floor, at y = 2 m."""

    rate_hz: float = rate("20Hz")
    noise_m: float = attribute("noise", LENGTH, "0m", "Standard deviation.")
    period_s: float = period()


def measure(now: Measurement) -> npt.NDArray[np.float64]:
    """Return how far robots are to the left of the line [m], (k, 1)."""
    return now.state.y_m[now.rows, None] - LINE_Y_M


crs_cc.add_device(
    number_sensor(
        name="line",
        title="Line sensor",
        element="line-sensor",
        summary="Measures the distance to a line on the floor",
        does="measures the distance to a line on the floor",
        model=LineSensor,
        values=(Value("offset", "distance, positive to the left of the line"),),
        kind=LENGTH,
        measure=measure,
    )
)


def main() -> None:
    scout = crs_cc.load_robot("scout").with_device("line", LineSensor(noise_m=0.005))
    world = crs_cc.WorldModel(
        "line",
        crs_cc.Area(0.0, 0.0, 10.0, 4.0),
        robots=(crs_cc.Robot("robot0", scout, crs_cc.Pose(0.6, 1.5)),),
    )
    session = crs_cc.Session(world, PROGRAM, duration_s=30.0)
    robot = session.robots["robot0"]
    while session.step(100):
        print(f"{session.time_s:4.1f} s: {robot.measure('line')[0]:+.3f} m from the line")


if __name__ == "__main__":
    main()
