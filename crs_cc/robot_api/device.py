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

HANDLING: Final = Group("Taking hold of things", (
    Function(
        "int crs_gripper(int what)",
        "lets the gripper open (CRS_OPEN) or close (CRS_CLOSE), and returns at once",
        posts=("GRIPPER",), source=(OURS,),
    ),
    Function(
        "int crs_get_gripper(int *opening, int *beam, int *weight)",
        "tells how far the fingers are apart, which is the width of what they hold; whether "
        "anything breaks the beam between them; and the weight of what they hold, 0 for nothing. "
        "A pointer may be NULL", units="0.1 in, g",
        posts=("GET_GRIPPER",), source=(OURS,),
    ),
))  # fmt: skip

DEVICE_GROUPS: Final = (SENSORS, HANDLING)
"""All functions, by what they are about."""
