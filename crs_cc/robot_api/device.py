"""The functions of `crs.h`: what robots have here beyond the vendor's.

`docs/crs-h.md` is made of it, and a test holds it, the header and the library together.

>>> [function.name for group in DEVICE_GROUPS for function in group.functions][0]
'crs_gps'
"""

from __future__ import annotations

from typing import Final

from crs_cc.robot_api.row import OURS, Function, Group

SENSORS: Final = Group("Sensors", (
    Function(
        "int crs_gps(int *x, int *y)", "tells where the robot is in the world", units="0.1 in",
        posts=("GPS",), source=(OURS,),
    ),
    Function(
        "int crs_camera(struct crs_pixel *row, int most)",
        "lets the camera look, and tells colour and range of its columns, from the left to the "
        "right; gives how many it told, at most `most`",
        units="0xRRGGBB, 0.1 in", posts=("CAMERA", "READINGS"), source=(OURS,),
    ),
    Function(
        "int crs_blobs(struct crs_blob *blobs, int most)",
        "lets the camera look, and tells angle, width, colour and range of the spots of one "
        "colour, from the left to the right; gives how many it told, at most `most`",
        units="0.1 deg, 0.1 deg, 0xRRGGBB, 0.1 in", posts=("CAMERA", "READINGS"), source=(OURS,),
    ),
))  # fmt: skip

DEVICE_GROUPS: Final = (SENSORS,)
"""All functions, by what they are about."""
