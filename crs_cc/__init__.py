"""Run real C control programs of the Nomadic Scout in a simulated, shared world.

The public names, which docs/python.md describes: `load_world` and `load_robot` return worlds and
kinds of robots, `compile_c` a program, `Session` runs programs in a world, `Robot`, `Wall`, `Box`
and so on make worlds in Python, `WorldBuilder` edits world files, `Degradation` describes a device
fault, and the error classes tell C, world and run-time errors apart.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from crs_cc.api.env import Env
    from crs_cc.api.gym_env import GymEnv, vector_env
    from crs_cc.api.parallel_env import ParallelEnv
    from crs_cc.api.programs import compile_c
    from crs_cc.api.robots import RobotView
    from crs_cc.api.session import Session, Snapshot
    from crs_cc.api.worlds import (
        load_robot,
        load_world,
        robot_xml,
        world_xml,
        write_robot,
        write_world,
    )
    from crs_cc.builder.world_builder import WorldBuilder
    from crs_cc.core.errors import CompileError, CrsError, InternalError, ProgramError, WorldError
    from crs_cc.debug.world.events import WorldEvent
    from crs_cc.runtime.executable import Executable
    from crs_cc.session.result import RobotResult, RunResult
    from crs_cc.sim.comms.control import Message
    from crs_cc.sim.engine.goals import GoalResult
    from crs_cc.sim.model.beacons import Light, Sound
    from crs_cc.sim.model.degradation import Degradation
    from crs_cc.sim.model.goals import (
        Approach,
        Bring,
        Cool,
        Cover,
        Follow,
        Goal,
        NoCollision,
        Place,
        Reach,
        Visit,
    )
    from crs_cc.sim.model.registry import add_device
    from crs_cc.sim.model.robot import RobotModel
    from crs_cc.sim.model.world import (
        Area,
        Box,
        Cylinder,
        Material,
        Polygon,
        Pose,
        Robot,
        Wall,
        WorldModel,
    )
    from crs_cc.sweeps.table import SweepTable, sweep

__version__ = "0.1.0"

_HOMES: Final = {
    name: home
    for home, names in {
        "crs_cc.api.env": "Env",
        "crs_cc.api.gym_env": "GymEnv vector_env",
        "crs_cc.api.parallel_env": "ParallelEnv",
        "crs_cc.api.programs": "compile_c",
        "crs_cc.api.robots": "RobotView",
        "crs_cc.api.session": "Session Snapshot",
        "crs_cc.api.worlds": "load_robot load_world robot_xml world_xml write_robot write_world",
        "crs_cc.builder.world_builder": "WorldBuilder",
        "crs_cc.core.errors": "CompileError CrsError InternalError ProgramError WorldError",
        "crs_cc.debug.world.events": "WorldEvent",
        "crs_cc.runtime.executable": "Executable",
        "crs_cc.session.result": "RobotResult RunResult",
        "crs_cc.sim.comms.control": "Message",
        "crs_cc.sim.model.beacons": "Light Sound",
        "crs_cc.sim.engine.goals": "GoalResult",
        "crs_cc.sim.model.degradation": "Degradation",
        "crs_cc.sim.model.goals": (
            "Approach Bring Cool Cover Follow Goal NoCollision Place Reach Visit"
        ),
        "crs_cc.sim.model.registry": "add_device",
        "crs_cc.sim.model.robot": "RobotModel",
        "crs_cc.sweeps.table": "SweepTable sweep",
        "crs_cc.sim.model.world": "Area Box Cylinder Material Polygon Pose Robot Wall WorldModel",
    }.items()
    for name in names.split()
}
"""The module of each public name."""

__all__ = [
    "Approach",
    "Area",
    "Box",
    "Bring",
    "CompileError",
    "Cool",
    "Cover",
    "CrsError",
    "Cylinder",
    "Degradation",
    "Env",
    "Executable",
    "Follow",
    "Goal",
    "GoalResult",
    "GymEnv",
    "InternalError",
    "Light",
    "Material",
    "Message",
    "NoCollision",
    "ParallelEnv",
    "Place",
    "Polygon",
    "Pose",
    "ProgramError",
    "Reach",
    "Robot",
    "RobotModel",
    "RobotResult",
    "RobotView",
    "RunResult",
    "Session",
    "Snapshot",
    "Sound",
    "SweepTable",
    "Visit",
    "Wall",
    "WorldBuilder",
    "WorldError",
    "WorldEvent",
    "WorldModel",
    "add_device",
    "compile_c",
    "load_robot",
    "load_world",
    "robot_xml",
    "sweep",
    "vector_env",
    "world_xml",
    "write_robot",
    "write_world",
]


if not TYPE_CHECKING:  # else type checkers would accept any name

    def __getattr__(name: str) -> object:
        """Import a public name on first access: `import crs_cc` loads nothing heavy."""
        if name not in _HOMES:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        return getattr(importlib.import_module(_HOMES[name]), name)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
