"""Speakers of robots, which microphones of other robots detect (`crs_sound`).

A level is the reading of microphones at a distance of 1 m. Larger values than the maximum of the
definition are clipped. Speakers are silent at the start, and when the robot leaves. Degradation
(`speaker`) applies to the commanded level; if it is dropped the speaker falls silent.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, Int64Array
from crs_cc.core.quantity import LOUDNESS
from crs_cc.requests import device_request
from crs_cc.requests.request import fields
from crs_cc.robot_api.row import OURS, Function
from crs_cc.sim.devices.emitters import commanded, of_all
from crs_cc.sim.devices.installed import Installed
from crs_cc.sim.model.attribute import attribute
from crs_cc.sim.model.beacons import TONES
from crs_cc.sim.model.degradable import Degradable, elements_of
from crs_cc.sim.model.device import Device
from crs_cc.sim.model.robot import devices_of

if TYPE_CHECKING:
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState
    from crs_cc.sim.state.events import EventLog


@dataclass(frozen=True, slots=True)
class Speaker:
    """A speaker."""

    loudest: float = attribute(
        "loudest", LOUDNESS, "1000", "Maximum level: the reading of a microphone at 1 m.",
        positive=True,
    )  # fmt: skip


@dataclass(slots=True)
class SpeakerState:
    """Speakers; arrays have a row for each robot with one, n of them.

    Attributes:
        level: its level, 0 for off, (n,).
        tone: its tone, (n,).
    """

    level: FloatArray
    tone: Int64Array


def sounds(state: EnvState, constants: RobotConstants) -> tuple[FloatArray, Int64Array]:
    """Return level, 0 for none, and tone of all robots' speakers, both (robots,)."""
    speakers = state.device("speaker", SpeakerState)
    level = of_all(state, constants, "speaker", speakers.level)
    tone = of_all(state, constants, "speaker", speakers.tone)
    return level, tone.astype(np.int64)


def install(row: Device, world: WorldModel, _seed: int, _log: EventLog) -> Installed:
    """Return the handler of SOUND."""
    found = devices_of([robot.model for robot in world.robots], row.name)
    loudest = np.array([speaker.loudest for speaker in found if speaker is not None])

    def sound(context: RequestContext) -> BoolArray:
        """Set level and tone of speakers; refuse robots without one, and unknown tones."""
        tone, numbers = context["tone"], context.constants.numbers[row.name][context.rows]
        good = np.asarray((numbers >= 0) & (tone >= 0) & (tone < TONES))
        mine, speakers = numbers[good], context.state.device(row.name, SpeakerState)
        wanted = commanded(
            context, row.name, context.rows[good], context["level"][good], most=loudest[mine]
        )
        speakers.level[mine], speakers.tone[mine] = wanted, tone[good]
        return good

    return Installed(handlers={"SOUND": sound})


def inspect(state: EnvState, number: int) -> str:
    """Return level and tone of a speaker."""
    speakers = state.device("speaker", SpeakerState)
    return f"level {speakers.level[number]:g}, tone {speakers.tone[number]}"


DEVICE = Device(
    name="speaker",
    title="Speaker",
    element="speaker",
    summary="A speaker that microphones of other robots detect; programs control it with"
    " crs_sound() (crs.h).",
    model=Speaker,
    state=lambda models: SpeakerState(np.zeros(len(models)), np.zeros(len(models), np.int64)),
    install=install,
    requests=(
        device_request(
            "SOUND", 226, "int crs_sound(int level, int tone)", "sets the tone of the speaker",
            fields(
                ("level", "i[0]", "1", "level, as read at 1 m"),
                ("tone", "i[1]", "1", "tone, 0 to 7"),
            ),
        ),
    ),
    functions=(
        Function(
            "int crs_sound(int level, int tone)",
            "sets the level and the tone, 0 to 7, of the robot's speaker, as read by microphones"
            " at 1 m; 0 for silence",
            posts=("SOUND",), source=(OURS,),
        ),
    ),
    degradables=(
        Degradable(
            "speaker", "commanded level", LOUDNESS, elements_of("speaker", lambda _model: ("0",)),
            1, "the speaker falls silent", acts=True,
        ),
    ),
    inspect=inspect,
    source=__file__,
)  # fmt: skip
