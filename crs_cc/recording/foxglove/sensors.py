"""Laser scans and pictures of chosen robots, by Foxglove's schemas, as they are measured.

A direction without a point has the range 0, as JSON has no infinity. A camera here sees one row of
pixels, which is repeated so that it can be seen.
"""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from crs_cc.recording.foxglove.messages import as_json, channel_of, pose_of, stamp
from crs_cc.recording.mcap_records import NS
from crs_cc.sim.devices.camera import camera_state, picture
from crs_cc.sim.devices.laser.model import NUM_LASER, laser_state

if TYPE_CHECKING:
    from crs_cc.recording.mcap_records import Channel
    from crs_cc.sim.model.world import Robot
    from crs_cc.sim.state.env_state import EnvState

_ROWS: Final = 24
"""How often a camera's row is repeated."""

Message = tuple["Channel", int, bytes]


class FoxgloveSensors:
    """Makes the messages of the lasers and cameras of some robots.

    Attributes:
        channels: those of the messages.
    """

    def __init__(self, robots: Sequence[Robot], names: Sequence[str]) -> None:
        self.channels: list[Channel] = []
        self._sources: list[Callable[[EnvState], Message | None]] = []
        counts = {"laser": 0, "camera": 0}
        for row, robot in enumerate(robots):
            for kind, number in counts.items():
                model = robot.model.device(kind)
                if model is None:
                    continue
                counts[kind] = number + 1
                if robot.id in names:
                    make = _Laser if kind == "laser" else _Camera
                    source = make(robot, row, number, model)
                    self.channels.append(source.channel)
                    self._sources.append(source.message)

    def messages(self, state: EnvState) -> Iterator[Message]:
        """Yield channel, time [ns] and content for what has been measured since the last call."""
        for source in self._sources:
            found = source(state)
            if found is not None:
                yield found


class _Laser:
    def __init__(self, robot: Robot, row: int, number: int, model: Any) -> None:
        self.channel = channel_of(f"/{robot.id}/scan", "LaserScan")
        self._row, self._number, self._model = row, number, model
        self._has_turret = "turret" in robot.model.drive.axis_names
        self._at_s = -1.0

    def message(self, state: EnvState) -> Message | None:
        """Return the message for the last scan, unless it is known."""
        readings = laser_state(state).readings
        at_s = float(readings.at_s[self._number])
        if at_s == self._at_s or at_s < 0.0:
            return None
        self._at_s = at_s
        values, model = readings.value[self._number], self._model
        points = int(values[NUM_LASER])
        ranges_m = np.nan_to_num(values[:points], nan=0.0, posinf=0.0, neginf=0.0)
        half_rad = (points - 1) / 2 * model.field_of_view_rad / max(points, 1)
        row, place_m = self._row, state.bodies.position_m[self._row]
        heading = state.drive.turret_rad if self._has_turret else state.heading_rad
        angle_rad = float(heading[row])
        x_m, y_m = place_m + model.forward_m * np.array([np.cos(angle_rad), np.sin(angle_rad)])
        data = {
            "timestamp": stamp(round(at_s * NS)),
            "frame_id": "world",
            "pose": pose_of(float(x_m), float(y_m), model.z_m, angle_rad),
            "start_angle": -half_rad,
            "end_angle": half_rad,
            "ranges": ranges_m.round(4).tolist(),
            "intensities": [],
        }
        return self.channel, round(at_s * NS), as_json(data)


class _Camera:
    def __init__(self, robot: Robot, _row: int, number: int, model: Any) -> None:
        self.channel = channel_of(f"/{robot.id}/camera", "RawImage")
        self._name, self._number, self._model = robot.id, number, model
        self._at_s = -1.0

    def message(self, state: EnvState) -> Message | None:
        """Return the message for the last picture, unless it is known."""
        at_s = float(camera_state(state).readings.at_s[self._number])
        if at_s == self._at_s or at_s < 0.0:
            return None
        self._at_s = at_s
        colours = picture(state, self._model, self._number)[:, 0]
        pixels = np.column_stack([colours >> 16, colours >> 8, colours]).astype(np.uint8)
        data = {
            "timestamp": stamp(round(at_s * NS)),
            "frame_id": f"{self._name} camera",
            "width": len(pixels),
            "height": _ROWS,
            "encoding": "rgb8",
            "step": 3 * len(pixels),
            "data": b64encode(pixels.tobytes() * _ROWS).decode("ascii"),
        }
        return self.channel, round(at_s * NS), as_json(data)
