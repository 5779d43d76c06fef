"""The results of a run: as an exit status and as JSON; `cli.summary_table` prints them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any

from crs_cc import __version__
from crs_cc.cli.captured_output import CapturedOutput
from crs_cc.cli.exit_status import INTERRUPTED
from crs_cc.cli.messages import as_data
from crs_cc.cli.report import call_data, call_site_data, report_data
from crs_cc.core.errors import ProgramError
from crs_cc.core.source import Diagnostic

if TYPE_CHECKING:
    from crs_cc.runtime.diagnosis.active_call import ActiveCall
    from crs_cc.runtime.diagnosis.lost_blocks import LostBlocks
    from crs_cc.session.result import Pose, RobotResult, RunResult
    from crs_cc.sim.engine.goals import GoalResult


@dataclass(frozen=True, slots=True)
class Run:
    """A finished run.

    Attributes:
        result: the session's result.
        world: the world file; empty for the built-in world.
        seed: its random seed.
        wall_s: elapsed real time [s].
        interrupted: whether it was ended by Ctrl-C.
        calls: by robot, the active call of its program if that has not ended.
        printed: what the programs have printed, if it is wanted.
        lost: by robot, the heap blocks that nothing points to at its program's end.
    """

    result: RunResult
    world: str
    seed: int
    wall_s: float
    interrupted: bool
    calls: tuple[ActiveCall | None, ...]
    printed: CapturedOutput | None = None
    lost: tuple[tuple[LostBlocks, ...], ...] = ()

    def lost_blocks_of(self, robot: int) -> tuple[LostBlocks, ...]:
        """Return the heap blocks that a robot's program has lost."""
        return self.lost[robot] if self.lost else ()

    @property
    def real_time_factor(self) -> float:
        """Simulated time by real time."""
        return self.result.simulated_s / max(self.wall_s, 1e-9)


def exit_status(run: Run) -> int:
    """Return the exit status of `crs run`."""
    statuses = [_robot_status(robot) for robot in run.result.robots]
    if run.interrupted:
        return INTERRUPTED
    return statuses[0] if len(statuses) == 1 else int(any(statuses))


def _robot_status(robot: RobotResult) -> int:
    if robot.outcome == "failed":
        return ProgramError.exit_status
    return (robot.exit_status or 0) & 0xFF  # what a parent process sees (POSIX `waitpid`)


def as_json(run: Run, warned: Sequence[Diagnostic]) -> str:
    """Return the results and warnings as JSON; all but `timing` is a function of the seed."""
    result = run.result
    data = {
        "crs": __version__,
        "world": run.world or None,
        "seed": run.seed,
        "timesteps": result.timesteps,
        "simulated_s": round(result.simulated_s, 9),
        "state_hash": result.state_hash,
        "interrupted": run.interrupted,
        "exit_status": exit_status(run),
        "diagnostics": [as_data(each) for each in warned],
        "robots": [
            {
                **_robot_data(robot, call),
                "lost_blocks": [_lost_data(each) for each in run.lost_blocks_of(number)],
                **(run.printed.fields(number) if run.printed else {}),
            }
            for number, (robot, call) in enumerate(zip(result.robots, run.calls, strict=True))
        ],
        **_goals_data(result.goals),
        **_foraging_data(result),
        "timing": {"wall_s": run.wall_s, "real_time_factor": run.real_time_factor},
    }
    import json

    return json.dumps(data, indent=2)


def _goals_data(goals: Sequence[GoalResult]) -> dict[str, Any]:
    """Return the goals and their points, nothing for a world without goals."""
    if not goals:
        return {}
    points = {"earned": sum(goal.earned for goal in goals), "of": sum(g.points for g in goals)}
    return {"goals": [asdict(goal) for goal in goals], "points": points}


def _foraging_data(result: RunResult) -> dict[str, Any]:
    """Return the sources and nests, nothing for a world without any."""
    if not (result.sources or result.nests):
        return {}
    return {
        "sources": [asdict(source) for source in result.sources],
        "nests": [asdict(nest) for nest in result.nests],
    }


def _robot_data(robot: RobotResult, call: ActiveCall | None) -> dict[str, Any]:
    return {
        "id": robot.id,
        "program": robot.program,
        "outcome": robot.outcome,
        "exit_status": robot.exit_status,
        "error": report_data(robot.error) if robot.error else None,
        "time_s": float(robot.time_s),
        "odometry": _pose_data(robot.odometry),
        "pose": _pose_data(robot.pose),
        "distance_m": float(robot.distance_m),
        "collisions": int(robot.collisions),
        "commands": int(robot.commands),
        "fuel": int(robot.fuel),
        "robot_call_s": robot.robot_call_s,
        "joined_s": robot.joined_s,
        "left_s": robot.left_s,
        "stands_in": call_data(call) if call else None,
    }


def _lost_data(lost: LostBlocks) -> dict[str, Any]:
    return {
        "blocks": len(lost.sizes),
        "bytes": sum(lost.sizes),
        "allocated": [call_site_data(each) for each in lost.allocated],
    }


def _pose_data(pose: Pose) -> dict[str, float]:
    x_m, y_m, heading_rad = map(float, pose)
    return {"x_m": x_m, "y_m": y_m, "heading_rad": heading_rad}
