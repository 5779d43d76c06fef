"""The vendor's API in one table: what `Nclient.h` declares, and what of it is known from where.

`docs/robot-api.md` is made of it, and a test holds it, the header and the library together.

>>> [function.name for group in GROUPS for function in group.functions if not function.declared]
['pa', 'conf_ser']
>>> len([function for group in GROUPS for function in group.functions if function.declared])
103
"""

from __future__ import annotations

from typing import Final

from crs_cc.robot_api.names import CONSTANTS, MACROS, SMASK, STATE, TYPES, VARIABLES
from crs_cc.robot_api.robot import CONFIGURATION, CONNECTION, MOTION, READING
from crs_cc.robot_api.row import SOURCES, Function, Group, Name
from crs_cc.robot_api.simulator import GRAPHICS, PACKETS, POSDATA, WORLD

__all__ = [
    "CONSTANTS",
    "GROUPS",
    "MACROS",
    "SMASK",
    "SOURCES",
    "STATE",
    "TYPES",
    "VARIABLES",
    "Function",
    "Group",
    "Name",
]

GROUPS: Final = (CONNECTION, MOTION, CONFIGURATION, READING, WORLD, GRAPHICS, POSDATA, PACKETS)
"""All functions, by what they are about."""
