"""The request queue as text: one line for each robot and timestep.

A line says which command the hardware simulator was running, which slice of it went into the
timestep, and which requests were answered, each with the instant at which the program went on:

    0.200 robot0  VM 5/-  right 0.0053 m  left 0.0053 m  GET_RC() @0.221 pose=4,0,0
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from crs_cc.sim.step import Answer, RobotSlice, Step, describe_slice


class Trace:
    """Writes what each robot did in each timestep.

    Args:
        write: takes one line, without the end of line.
        names: the robots' names, in the world's order.
    """

    def __init__(self, write: Callable[[str], None], names: Sequence[str]) -> None:
        self._write = write
        self._names = tuple(names)
        self._width = max(map(len, self._names), default=0)

    def step(self, step: Step) -> None:
        """Hears from the session that a timestep has ended."""
        for robot, name in enumerate(self._names):
            slice_ = describe_slice(step, robot)
            self._write(f"{step.time_s:.3f} {name:{self._width}}  {line(slice_)}")


def line(slice_: RobotSlice) -> str:
    """Gives one robot's timestep as text.

    >>> line(RobotSlice("PR", 3, 21, 0.0127, 0.0127, (0.0381, 0.0381), (0.254, 0.254), True, ()))
    'PR 3/21  right 0.0127 m  left 0.0127 m  done 0.0381,0.0381 of 0.2540,0.2540 m  waits'
    """
    parts = [f"{slice_.command or '-'}{_count(slice_)}"]
    parts.append(f"right {slice_.right_m:.4f} m  left {slice_.left_m:.4f} m")
    if slice_.total_m is not None and slice_.command:
        done = ",".join(f"{way_m:.4f}" for way_m in slice_.travelled_m)
        total = ",".join(f"{way_m:.4f}" for way_m in slice_.total_m)
        parts.append(f"done {done} of {total} m")
    if slice_.waiting:
        parts.append("waits")
    parts += [_answer(answer) for answer in slice_.answers]
    return "  ".join(parts)


def _count(slice_: RobotSlice) -> str:
    if not slice_.command:
        return ""
    return f" {slice_.number}/{'-' if slice_.count is None else slice_.count}"


def _answer(answer: Answer) -> str:
    arguments = ",".join(map(str, answer.arguments))
    text = f"{answer.name}({arguments}) @{answer.clock_s:.3f}"
    if not answer.result:
        text += " refused"
    for name, values in answer.values.items():
        text += f" {name}={','.join(map(str, values))}"
    return text
