"""The vendor's API in one table: the declarations of `Nclient.h`, with their sources.

`docs/robot-api.md` is generated from it; a test compares it with the header and the library.

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
"""All functions, by group."""
