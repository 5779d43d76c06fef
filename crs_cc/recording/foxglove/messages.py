"""Messages by Foxglove's schemas.

>>> stamp(1_500_000_000)
{'sec': 1, 'nsec': 500000000}
"""

from __future__ import annotations

import json
import math
from base64 import b64encode
from collections.abc import Sequence
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from crs_cc.recording.mcap_records import NS, Channel
from crs_cc.recording.shapes import robot_data, shape_data

if TYPE_CHECKING:
    from crs_cc.core.arrays import FloatArray
    from crs_cc.sim.model.world import WorldModel

MAX_SCENE: Final = 200
"""Robots in a scene; more are points. A thousand as a scene take 12 ms each frame."""

_HERE: Final = Path(__file__).parent
_NAMES: Final = ("SceneUpdate", "PointCloud", "Log", "LaserScan", "RawImage")
_FRAME: Final = "world"
_ROBOT_M: Final = 0.35  # high
_LEVELS: Final = {1: 2, 2: 3}  # stdout: INFO, stderr: WARNING
_ZERO: Final = {"sec": 0, "nsec": 0}
_POINT: Final = 12


def channel_of(topic: str, name: str) -> Channel:
    """Return a channel of messages by one of the schemas."""
    schema = (_HERE / f"{name}.json").read_bytes()
    return Channel(topic, "json", f"foxglove.{name}", "jsonschema", schema, names_schema=True)


@lru_cache(maxsize=1000)
def known_channel(topic: str, schema: str) -> Channel | None:
    """Return a channel of messages by the name of its schema; None if it is not one of them.

    >>> known_channel("/log", "foxglove.Log").schema, known_channel("/log", "foxglove.../x")
    ('foxglove.Log', None)
    """
    family, _, name = schema.partition(".")
    return channel_of(topic, name) if family == "foxglove" and name in _NAMES else None


SCENE: Final = channel_of("/scene", "SceneUpdate")
POINTS: Final = channel_of("/scene", "PointCloud")
LOG: Final = channel_of("/log", "Log")


class FoxgloveView:
    """Makes the messages of one run."""

    def __init__(self, world: WorldModel) -> None:
        self._world = world
        self._shapes = {shape["id"]: shape for shape in shape_data(world)}
        self._has_shown_world = False

    def frame(
        self, time_ns: int, values: FloatArray, robots: Sequence[str], objects: Sequence[str]
    ) -> tuple[Channel, bytes]:
        """Return the message for a frame, see `frames`."""
        if len(robots) > MAX_SCENE:
            return POINTS, as_json(_cloud(time_ns, values[:, : len(robots)]))
        entities = [
            _entity(f"robot {each['id']}", time_ns, [], [_robot(each, values[:, row])])
            for row, each in enumerate(robot_data(self._world, robots))
            if not math.isnan(values[0, row])
        ]
        for number, name in enumerate(objects):
            x_m, y_m, angle_rad = values[:3, len(robots) + number].tolist()
            if name in self._shapes:
                moved = {**self._shapes[name], "x": x_m, "y": y_m, "angle": angle_rad}
                entities.append(_obj(time_ns, moved))
        if not self._has_shown_world:
            self._has_shown_world = True
            fixed = [shape for name, shape in self._shapes.items() if name not in objects]
            entities += [_obj(time_ns, shape) for shape in fixed]
        return SCENE, as_json({"deletions": [], "entities": entities})


def log_message(time_ns: int, name: str, stream: int, content: bytes) -> bytes:
    """Return the log message for a piece of output."""
    return as_json(
        {
            "timestamp": stamp(time_ns),
            "level": _LEVELS[stream],
            "message": content.decode("utf-8", "replace").rstrip("\n"),
            "name": name,
            "file": "",
            "line": 0,
        }
    )


def stamp(time_ns: int) -> dict[str, int]:
    """Return a time by Foxglove's schemas."""
    return dict(zip(("sec", "nsec"), divmod(time_ns, NS), strict=True))


def _cloud(time_ns: int, values: FloatArray) -> dict[str, Any]:
    present = values[:, ~np.isnan(values[0])]
    points = np.zeros((present.shape[1], 3), "<f4")
    points[:, :2] = present[:2].T
    fields = [
        {"name": name, "offset": 4 * place, "type": 7}  # FLOAT32
        for place, name in enumerate("xyz")
    ]
    return {
        "timestamp": stamp(time_ns),
        "frame_id": _FRAME,
        "pose": pose_of(0.0, 0.0, 0.0, 0.0),
        "point_stride": _POINT,
        "fields": fields,
        "data": b64encode(points.tobytes()).decode("ascii"),
    }


def _robot(robot: dict[str, Any], values: FloatArray) -> dict[str, Any]:
    x_m, y_m, heading_rad = values[:3].tolist()
    size = (robot["radius"], _ROBOT_M)
    return _cylinder((x_m, y_m, heading_rad), size, robot["colour"])


def _obj(time_ns: int, shape: dict[str, Any]) -> dict[str, Any]:
    """Return an entity for an object; a polygon is shown by the box around it."""
    x_m, y_m, angle_rad, height_m = (shape[key] for key in ("x", "y", "angle", "height"))
    if "radius" in shape:
        size = (shape["radius"], height_m)
        shown = _cylinder((x_m, y_m, angle_rad), size, shape["colour"])
        return _entity(shape["id"], time_ns, [], [shown])
    low, high = np.min(shape["corners"], axis=0), np.max(shape["corners"], axis=0)
    length_m, width_m = (high - low).tolist()
    cube = {
        "pose": pose_of(x_m, y_m, height_m / 2, angle_rad),
        "size": {"x": length_m, "y": width_m, "z": height_m},
        "color": _colour(shape["colour"]),
    }
    return _entity(shape["id"], time_ns, [cube], [])


def _cylinder(
    at: tuple[float, float, float], size_m: tuple[float, float], colour: str
) -> dict[str, Any]:
    (x_m, y_m, angle_rad), (radius_m, height_m) = at, size_m
    return {
        "pose": pose_of(x_m, y_m, height_m / 2, angle_rad),
        "size": {"x": 2 * radius_m, "y": 2 * radius_m, "z": height_m},
        "bottom_scale": 1.0,
        "top_scale": 1.0,
        "color": _colour(colour),
    }


def _entity(
    name: str, time_ns: int, cubes: list[dict[str, Any]], cylinders: list[dict[str, Any]]
) -> dict[str, Any]:
    empty: dict[str, list[Any]] = {
        kind: [] for kind in ("metadata", "arrows", "spheres", "lines", "triangles", "texts")
    }
    return {
        "timestamp": stamp(time_ns),
        "frame_id": _FRAME,
        "id": name,
        "lifetime": _ZERO,
        "frame_locked": False,
        **empty,
        "models": [],
        "cubes": cubes,
        "cylinders": cylinders,
    }


def pose_of(x_m: float, y_m: float, z_m: float, angle_rad: float) -> dict[str, Any]:
    """Return a pose by the schemas."""
    half = angle_rad / 2
    turn = {"x": 0.0, "y": 0.0, "z": math.sin(half), "w": math.cos(half)}
    return {"position": {"x": x_m, "y": y_m, "z": z_m}, "orientation": turn}


def _colour(text: str) -> dict[str, float]:
    parts = [int(text[place : place + 2], 16) / 255 for place in (1, 3, 5)]
    return {**dict(zip("rgb", parts, strict=True)), "a": 1.0}


def as_json(data: dict[str, Any]) -> bytes:
    """Return a message."""
    return json.dumps(data, separators=(",", ":")).encode()
