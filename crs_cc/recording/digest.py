"""A short hash of a run, cheap enough to be computed each second.

The hash of all state (`Session.state_hash`) reads every robot's memory, which takes seconds for
10,000 robots. This one covers what depends on all of it: where everything is and goes, what the
robots believe, the programs' clocks, and how many instructions they have executed. It is the same
for every build of a program, so that the debugger can compare its runs, too. A CRC-32 is enough: it
tells runs apart that have gone different ways, and SHA-256 takes ten times as long for one robot.
"""

from __future__ import annotations

import zlib
from typing import TYPE_CHECKING

from crs_cc.recording.hashes import DIGEST_BITS, DIGITS

if TYPE_CHECKING:
    from crs_cc.session.session import Session


def digest(session: Session) -> str:
    """Return the hash of a run between two timesteps."""
    state, world = session.state, session.environment.last_state
    odometry, bodies = world.odometry, world.bodies
    arrays = (
        *(state.clock_s, state.fuel, state.alive, state.due_s, state.ended_s, state.called_s),
        *(bodies.position_m, bodies.angle_rad, bodies.velocity_mps, world.heading_rad),
        *(odometry.x_m, odometry.y_m, odometry.heading_rad),
        *(world.collisions, world.commands, world.distance_m),
    )
    content = b"".join([b"%d" % session.timesteps, *(array.tobytes() for array in arrays)])
    return f"{zlib.crc32(content) & DIGEST_BITS:0{DIGITS}x}"
