"""The world as rows: time, robots, objects, messages."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from crs_cc.debug.world.rows import Row, instant, length, pose_text
from crs_cc.sim.comms.message_log import MEANINGS
from crs_cc.sim.model.world import is_pushable

if TYPE_CHECKING:
    from crs_cc.sim.engine.environment import Environment


def world_rows(environment: Environment) -> list[Row]:
    """Return the rows of a world."""
    world, state = environment.world, environment.state
    area = world.area
    corner = f"{length(area.x_min_m)[:-2]}, {length(area.y_min_m)}"
    timestep_ms = 1000 * world.timestep_s
    return [
        Row("world", world.name),
        Row("time", f"{instant(environment.time_s)}, timestep {state.cycle} of {timestep_ms:g} ms"),
        Row("area", f"{length(area.length_m)} by {length(area.width_m)} from {corner}"),
        _robots(environment),
        *_movable_objects(environment),
        *_channels(environment),
        *_degradations(environment),
    ]


def _robots(environment: Environment) -> Row:
    state, robots = environment.state, environment.world.robots
    there = state.presence.present.tolist()
    poses = zip(state.x_m.tolist(), state.y_m.tolist(), state.heading_rad.tolist(), strict=True)
    children = tuple(
        Row(robot.id, pose_text(*pose) if is_there else "not in the world")
        for robot, pose, is_there in zip(robots, poses, there, strict=True)
    )
    return Row("robots", f"{sum(there)} of {len(there)} in the world", children)


def _movable_objects(environment: Environment) -> Iterator[Row]:
    """Return the objects, and of movable ones the position and the distance from the start."""
    state, world = environment.state, environment.world_now
    solids = world.solids()
    first = len(world.robots)
    children = []
    for place, name in enumerate(environment.pushables, first):
        x_m, y_m = state.bodies.position_m[place].tolist()
        text = pose_text(x_m, y_m, float(state.bodies.angle_rad[place]))
        holders = np.flatnonzero((state.bodies.holds.object == place - first).any(axis=1)).tolist()
        held = "".join(f", held by {world.robots[robot].id}" for robot in holders)
        children.append(Row(name, text + held))
    fixed = sum(not is_pushable(solid) for solid in solids)
    yield Row("objects", f"{fixed} fixed, {len(children)} movable", tuple(children))
    put = len(state.obstacles.numbers)
    if put:
        yield Row("obstacles", f"{put} added by programs")


def _channels(environment: Environment) -> Iterator[Row]:
    """Return message counts of each channel that was used."""
    for channel in environment.world.communication.channels:
        counts = environment.communication.counts(channel.name)
        if any(counts.values()):
            children = tuple(Row(MEANINGS[fate], str(n)) for fate, n in counts.items() if n)
            yield Row(channel.name, f"{counts[min(counts)]} messages sent", children)


def _degradations(environment: Environment) -> Iterator[Row]:
    control = environment.degradations
    phases = [control.phase(each.id) for each in control.all()]
    if phases:
        yield Row("degradations", f"{phases.count('acts')} of {len(phases)} active")
