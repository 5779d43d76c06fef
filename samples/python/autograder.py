"""Grades C programs by the goals of a world, and prints the points of each.

`crs grade` does that with limits, pictures and pages; here it is in a few lines of Python, to be
changed for a course of your own.

    python autograder.py WORLD PROGRAM...
"""

import sys
from pathlib import Path

import crs_cc


def grade(world: crs_cc.WorldModel, program: Path) -> tuple[float, str]:
    """Return the points of a program, and why it has no more."""
    try:
        session = crs_cc.Session(world, program, duration_s=world.duration_s or 60.0)
    except crs_cc.CompileError as error:
        return 0.0, str(error).splitlines()[0]
    result = session.run()
    points = sum(goal.points for goal in result.goals if goal.status == "met")
    reasons = [f"not met: {goal.title}" for goal in result.goals if goal.status != "met"]
    for robot in result.robots:
        if robot.error is not None:
            place, text = robot.error.location, robot.error.text
            reasons.insert(0, f"stopped at {place}: {text}")
    return points, "; ".join(reasons)


def main() -> None:
    if len(sys.argv) < 3:
        sys.exit("usage: python autograder.py WORLD PROGRAM...")
    world = crs_cc.load_world(sys.argv[1])
    full = sum(goal.points for goal in world.goals)
    for program in map(Path, sys.argv[2:]):
        points, reason = grade(world, program)
        print(f"{program.name:20s} {points:4g} of {full:g}  {reason}".rstrip())


if __name__ == "__main__":
    main()
