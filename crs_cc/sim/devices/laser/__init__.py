"""The laser: a plane of light observed by a camera on the turret.

    point n = distance along direction n from the sensor, for n from 0 to points - 1
    direction n = (n - (points - 1) / 2) * field of view / points       (0 for a single point)

Directions are counter-clockwise, from right to left, centred on the front of the turret; a
direction without an object in range has no point. Points are x and y in units of 0.1 inch, forward
and left of the centre of the turret (vendor header `Nclient.h` 1.29; the frame of the turret, which
carries the sensor, was chosen by us). `conf_ls` can request fewer points than the 482 of the
vendor's array. The modes are the vendor's: bit 0 switches the laser on, and bit 1 selects points
instead of segments; the vendor's client (`Nclient.c` 2.7) otherwise accepts 19 and 51 for points,
and 1 and 33 for segments. The other modes return pixels, which the vendor's simulator did not
support, and are rejected. The brightness and the width of the line (`threshold`, `width`) are
ignored.

Segments are computed from the points by split and merge (`segments`), with the parameters of
`conf_sg`. `get_ls` returns points and `get_sg` segments in every mode; state replies contain what
the mode selects, unless the mask excludes the laser. A laser that is off returns nothing. The
returned readings are kept, so that the client can request them page by page (LASER_PAGE).

The laser measures when a reply contains its readings, at most thirty times a second (vendor
header), or on its timer (`timers`). Noise: a normal deviate is added to each distance; its standard
deviation is the definition's noise at 1 m and grows with the square of the distance, as for
triangulation; averaging p pixels divides it by sqrt(p). Degradation (`laser`) applies to the
distances; a dropped distance yields no point.
"""

from __future__ import annotations

from crs_cc.core.quantity import LENGTH
from crs_cc.requests import device_request
from crs_cc.requests.request import fields
from crs_cc.robot_api.row import OURS, Function
from crs_cc.sim.devices import range_scan
from crs_cc.sim.devices.laser.lasers import Lasers
from crs_cc.sim.devices.laser.model import NUM_LASER, Laser, laser_state, read, state_at_start
from crs_cc.sim.model.degradable import Degradable, elements_of, numbered
from crs_cc.sim.model.device import Device

DEVICE = Device(
    name="laser",
    title="Laser",
    element="laser",
    summary="A laser range finder on the turret (or the body).",
    model=Laser,
    read=read,
    state=state_at_start,
    install=lambda row, world, seed, _log: Lasers(row, world, seed).installed,
    requests=(
        device_request(
            "LASER", 204, "int crs_laser(int *ranges, int most)",
            "scans with the laser and keeps the ranges for READINGS",
            results=fields(("count", "i[0]", "1", "number of ranges available from READINGS")),
        ),
    ),
    functions=(
        Function(
            "int crs_laser(int *ranges, int most)",
            "takes a scan, and copies the range in each direction, from right to left, -1 for "
            "nothing in range; returns the number of ranges copied, at most `most`, and 0 while "
            "the laser is off",
            units="0.1 in", posts=("LASER", "READINGS"), source=(OURS,),
        ),
    ),
    degradables=(
        Degradable(
            "laser", "distance of a point, numbered from right to left", LENGTH,
            elements_of("laser", lambda laser: numbered(laser.points)), NUM_LASER,
            "there is no point",
        ),
    ),
    inspect=lambda state, number: range_scan.nearest_text(
        laser_state(state).readings, number, NUM_LASER
    ),
    reading=lambda state, model, number: laser_state(state).readings.last(number, model.points),
    number=3,
    stream=3,
    source=__file__,
)  # fmt: skip
