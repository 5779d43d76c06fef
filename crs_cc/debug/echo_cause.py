"""Echoes as causes: the beam that a range sensor fired, and the object that it met."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from crs_cc.debug.cause import Beam, Cause
from crs_cc.debug.timeline.position import Position
from crs_cc.debug.timeline.recorded_run import RecordedRun
from crs_cc.debug.world.sensor_cause import Firing, echoing_object, firing_of
from crs_cc.sim.devices.sonar.state import sonar_state


def firing_cause(run: RecordedRun, robot: int, ping: Firing, field: str) -> Cause:
    """Return the node of a firing, with the object that it met.

    The run is at the timestep of the firing after that.

    Args:
        run: the run.
        robot: the robot whose sensor it is.
        ping: the firing.
        field: what comes before its description.
    """
    environment = run.session.environment
    at = Position(int(ping.fired_s / environment.timestep_s), 0)
    run.seek(at)
    met = echoing_object(environment, robot, ping.number, ping.echo_m)
    beam = Beam(ping.number, ping.echo_m, met)
    return Cause(f"{field}{ping.text(met)}", position=at, robot=robot, beam=beam)


def nearest(run: RecordedRun, here: Position, robot: int) -> Iterator[Cause]:
    """Return the beam of the nearest sonar echo of a robot at a position."""
    run.seek(here)
    environment = run.session.environment
    echo_m = sonar_state(environment.state).echo_m[robot]
    if np.isfinite(echo_m).any():
        yield firing_cause(run, robot, firing_of(environment, robot, int(np.nanargmin(echo_m))), "")
