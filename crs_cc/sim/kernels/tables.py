"""The interface between kernels and Python: numbers, results, and the rows of their tables.

Those of robots are described in `robot.h`.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from crs_cc.requests import NUM_STATE

ADVANCED: Final = 0
SENSOR_DUE: Final = 1
TIMEOUT_DUE: Final = 2
NOT_HANDLED: Final = 3
"""What `Kernels.advance` returns, as in `kernels.h`."""

(
    SETUP, ECHOES, RAYS, PROFILES, COUNTS, ADVANCE, REPORTS, COVERS, RENEW, SPEEDS, REPLIES,
    CHARGES, FINISH, SCAN, SERVE, FIRE, ERRORS, CALM, SORT, SURVEY, ANTENNAE, TRAILS,
    ROOM, SIGHT, HEAR,
) = range(99, 124)  # fmt: skip
"""The numbers of kernels, as in `main.c`."""

ROBOTS: Final = 11000
BODIES: Final = 15000
KINDS: Final = 2048
RINGS: Final = 256
"""Rows of the tables of instances that hold the rows of a world."""
ROBOT_SIZE: Final = 104
BODY_SIZE: Final = 6
BATTERY_SIZE: Final = 4
KIND_SIZE: Final = 40
RING_SIZE: Final = 104
"""Numbers in the rows of tables, see `robot.h`."""
KIND: Final = 93
BATTERY: Final = 94
"""Places in a row of a robot: the row of its constants, and that of its battery, -1 for none."""

REPLY: Final = np.dtype(
    [("state", "<i4", NUM_STATE), ("_", "<i4"), ("charge", "<f8", 2), ("board_ms", "<f8")]
)
"""The data of a robot in the reply to a request, see `report.c`."""

_INSTRUMENT: Final = [
    ("interval_s", "<f8"), ("noise", "<f8"), ("on_request", "<f8"), ("masked", "<f8"),
    ("at_s", "<f8"), ("count", "<i8"), ("configuration", "<i4", 8),
]  # fmt: skip
RING: Final = np.dtype(
    [
        *_INSTRUMENT, ("step_m", "<f8"), ("fan", "<f8"), ("share", "<f8"),
        ("on", "<f8", 16), ("level", "<f8", 16),
    ]
)  # fmt: skip
"""An infrared ring, see `instruments.h`."""
COMPASS: Final = np.dtype(
    [
        *_INSTRUMENT, ("offset_rad", "<f8"), ("deviation_rad", "<f8"), ("on", "<f8"),
        ("reading", "<f8"),
    ]
)  # fmt: skip
"""A compass."""

PING_SIZE: Final = 13
"""Numbers in a row of pings, see `echoes.c`."""
RAY_BINS: Final = 256
"""Bins of directions in a turn, as in `kernels.h`."""
