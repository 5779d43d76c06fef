"""The camera: a row of colours and ranges.

    column n  = the first object along direction n, within the range
    direction n = direction of the camera + ((columns - 1) / 2 - n) * field of view / columns

Columns are numbered from left to right, as in a picture. A column has the colour of the object's
surface (`Material.colour` of the world file) and the surface's distance from the camera, which a
real camera would need a second lens to measure; a column without an object in range has the
camera's background colour. Light and shadow have no effect. A camera turns with the mount of its
robot. It takes a picture when the program requests one, but no more often than its rate allows, or
on its timer; requests in between return the previous picture.

Blobs are runs of adjacent columns of one colour, as found by a colour tracker: two objects of the
same colour that touch in the picture are one blob, at the distance of the nearer one.

Noise: a normal deviate is added to each range; its standard deviation is the definition's noise at
1 m and grows with the square of the distance, as for two lenses. Then degradation (`camera`)
applies to the ranges: a column whose range is dropped has the background colour. The model was
chosen by us: the CRS report (6.2) suggests such a device without specifying it.
"""

from __future__ import annotations

import dataclasses
import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int32Array
from crs_cc.core.distinct import distinct
from crs_cc.core.quantity import ANGLE, LENGTH
from crs_cc.core.units import m_to_tenths_inch, rad_to_tenths_deg
from crs_cc.requests import device_request
from crs_cc.requests.request import fields
from crs_cc.robot_api.row import OURS, Function
from crs_cc.sim.devices import range_scan
from crs_cc.sim.devices.camera.blobs import blobs
from crs_cc.sim.devices.mount import mount_poses
from crs_cc.sim.devices.sensor import Measurement, Readings, Sensor
from crs_cc.sim.files.body import is_outside
from crs_cc.sim.files.device_elements import read_attributes
from crs_cc.sim.geometry.rays import Fan
from crs_cc.sim.geometry.surfaces import packed
from crs_cc.sim.kernels import exact
from crs_cc.sim.model.attribute import COLOUR, Count, attribute, period, rate
from crs_cc.sim.model.degradable import Degradable, elements_of, numbered
from crs_cc.sim.model.device import Device
from crs_cc.sim.model.robot import devices_of
from crs_cc.sim.state.paged_reply import PagedReply

if TYPE_CHECKING:
    from collections.abc import Sequence

    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.files.document import Element, Reader
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState


MAX_COLUMNS: Final = 320
"""Maximum number of columns of a camera; our choice."""

_PIXEL: Final = 2
_BLOB: Final = 4
"""Numbers per reading."""


@dataclass(frozen=True, slots=True)
class Camera:
    """A camera on the mount that measures a row of colours and ranges.

    Attributes:
        field_of_view_rad: the angle that they cover, half of it to each side.
        range_m: maximum range.
        x_m: its position ahead of the mount's centre.
    """

    columns: int = attribute(
        "columns", Count(1, MAX_COLUMNS), "160", f"Number of pixels in the row, 1 to {MAX_COLUMNS}."
    )
    field_of_view_rad: float = range_scan.field_of_view("60deg")
    range_m: float = attribute("range", LENGTH, "10m", "Maximum distance measured.", positive=True)
    x_m: float = range_scan.forward()
    y_m: float = attribute(
        "left", LENGTH, "0m", "Position, left of the centre of the turret.", signed=True
    )
    direction_rad: float = attribute(
        "direction", ANGLE, "0deg", "Direction, counter-clockwise from the front.", signed=True
    )
    rate_hz: float = rate("30Hz")
    noise_m: float = attribute(
        "noise", LENGTH, "0m",
        "Standard deviation of a range at 1 m; it grows with the square of the range.",
    )  # fmt: skip
    background: tuple[int, int, int] = attribute(
        "background", COLOUR, "black",
        "Colour of empty columns: #rrggbb, or a name such as silver.",
    )  # fmt: skip
    z_m: float = range_scan.height()
    period_s: float = period()


def read(root: Element, reader: Reader) -> Camera | None:
    """Return the camera of a robot definition, None for a robot without one.

    The report's `<sensor>` of this type, if there is one, sets its pose, field of view and range.
    """
    element, places = root.find_child("camera"), list(root.sensors("camera"))
    for place in places[1:]:
        reader.error(place, "duplicate camera: a robot has at most one")
    for place in places:
        position = place.first("position")
        x_m, y_m = (reader.quantity(position, f"{axis}-relative", LENGTH) for axis in "xy")
        if is_outside(root, x_m, y_m, reader):
            reader.error(place, "the camera is outside of the body")
    if element is None:
        for place in places[:1]:
            hint = "add <camera/> before <computer-battery>"
            reader.error(place, "missing <camera>, which sets the camera's columns and rate", hint)
        return None
    camera: Camera = read_attributes(Camera, element, reader)
    if is_outside(root, camera.x_m, 0.0, reader):
        reader.error(element, "the camera is outside of the body")
    return _placed(camera, places[0].first("position"), reader) if places else camera


def _placed(camera: Camera, place: Element, reader: Reader) -> Camera:
    """Return a camera with the pose, field of view and range of the report's `<sensor>`."""
    range_m = reader.positive(place, "range", LENGTH)
    radius_m = reader.positive(place, "radius", LENGTH)
    return dataclasses.replace(
        camera,
        field_of_view_rad=2 * exact.arctan2(radius_m, range_m),
        range_m=range_m,
        x_m=reader.quantity(place, "x-relative", LENGTH),
        y_m=reader.quantity(place, "y-relative", LENGTH),
        direction_rad=reader.quantity(place, "dir-relative", ANGLE, unit="rad"),
        z_m=reader.not_negative(place, "z-relative", LENGTH),
    )


@dataclass(slots=True)
class CameraState:
    """The cameras; arrays have a row for each robot with a camera, n of them.

    Attributes:
        readings: the range of each column [m], from left to right, not finite if no object is in
            range; then the colour of each, 0xRRGGBB.
        reply: contents of the last reply.
    """

    readings: Readings
    reply: PagedReply


def state_at_start(models: Sequence[Camera]) -> CameraState:
    """Return cameras without an image."""
    return CameraState(
        Readings.never(len(models), 2 * MAX_COLUMNS),
        PagedReply.nothing(len(models), _PIXEL * MAX_COLUMNS),
    )


def camera_state(state: EnvState) -> CameraState:
    """Return the state of the cameras."""
    return state.device("camera", CameraState)


def pictures(
    state: EnvState, numbers: IndexArray, columns: IndexArray, background: Int32Array
) -> tuple[Int32Array, Int32Array]:
    """Return colour, 0xRRGGBB, and range [0.1 in] of columns, -1 for no range, (k, most) each.

    Args:
        state: the state.
        numbers: the cameras' numbers among all cameras, k of them.
        columns: the number of columns of each, (k,); what follows them is meaningless.
        background: the colour of its empty columns, 0xRRGGBB, (k,).
    """
    most = int(columns.max(initial=0))
    value = camera_state(state).readings.value
    range_m = value[numbers, :most]
    colour = value[numbers, MAX_COLUMNS : MAX_COLUMNS + most]
    seen = np.isfinite(range_m)
    tenths = np.rint(m_to_tenths_inch(np.where(seen, range_m, 0.0)))
    shown = np.where(seen, colour, background[:, None])
    return shown.astype(np.int32), np.where(seen, tenths, -1).astype(np.int32)


def picture(state: EnvState, camera: Camera, number: int) -> Int32Array:
    """Return colour, 0xRRGGBB, and range [0.1 in] of each column, -1 for no range, (columns, 2)."""
    background = np.array([packed(camera.background)], dtype=np.int32)
    columns = np.array([camera.columns])
    return np.concatenate(pictures(state, np.array([number]), columns, background)).T


class _Cameras:
    """The cameras of all robots that have one."""

    def __init__(self, row: Device, world: WorldModel, seed: int) -> None:
        found = devices_of([robot.model for robot in world.robots], row.name)
        models: list[Camera] = [camera for camera in found if camera is not None]
        self._columns = np.array([camera.columns for camera in models], dtype=np.intp)
        self._background = np.array(
            [packed(camera.background) for camera in models], dtype=np.int32
        )
        self._step = np.array([_step(camera) for camera in models], dtype=np.float64)
        kinds, self._kind = distinct(models)
        self._fans = [_fan(camera) for camera in kinds]
        self._sensor = Sensor(
            row, world, seed, self._measure, MAX_COLUMNS, errors=range_scan.triangulated,
            readings=lambda state: camera_state(state).readings,
        )  # fmt: skip
        self.installed = self._sensor.installed(
            {"CAMERA": self.take_picture}, self._fans,
            announced=lambda state: camera_state(state).reply,
        )  # fmt: skip

    def _measure(self, now: Measurement) -> FloatArray:
        """Return the range of each column [m], then its colour, (k, 640)."""
        numbers = now.constants.numbers["camera"][now.rows]
        poses = mount_poses(now.state, now.constants, now.rows)
        value = np.empty((len(numbers), 2 * MAX_COLUMNS))
        value[:, :MAX_COLUMNS], value[:, MAX_COLUMNS:] = np.inf, 0.0
        for kind, some in range_scan.alike(self._kind[numbers]):
            fan = self._fans[kind]
            seen_m, obj = now.rays.seen(now.state, fan, poses[some], own=now.rows[some])
            value[some, : len(fan)] = seen_m
            colour = now.rays.surfaces.colour[obj]
            value[some, MAX_COLUMNS : MAX_COLUMNS + len(fan)] = colour
        return value

    def take_picture(self, context: RequestContext) -> BoolArray:
        """Answer CAMERA with the number of pixels or blobs; refuse robots without a camera."""
        has, mine = self._sensor.measure_on_request(context)
        wants_blobs = context["blobs"] != 0
        reply = camera_state(context.state).reply
        for are_blobs, keep in ((False, self._keep_pixels), (True, self._keep_blobs)):
            some = has & (wants_blobs == are_blobs)
            numbers = mine[some[has]]
            if len(numbers):
                keep(context.state, numbers)
                context.put("count", reply.count[numbers], some)
        return has

    def _pictures(self, state: EnvState, numbers: IndexArray) -> tuple[Int32Array, Int32Array]:
        return pictures(state, numbers, self._columns[numbers], self._background[numbers])

    def _keep_pixels(self, state: EnvState, numbers: IndexArray) -> None:
        pixels = np.stack(self._pictures(state, numbers), axis=2)
        camera_state(state).reply.keep(numbers, _PIXEL, self._columns[numbers], pixels)

    def _keep_blobs(self, state: EnvState, numbers: IndexArray) -> None:
        """Keep angle and width [0.1 deg], colour and range [0.1 in] of blobs."""
        columns = self._columns[numbers]
        owner, first, after, colour, nearest = blobs(*self._pictures(state, numbers), columns)
        step = self._step[numbers][owner]
        angle = np.rint((columns[owner] - first - after) / 2 * step)
        width = np.rint((after - first) * step)
        counts = np.bincount(owner, minlength=len(numbers))
        rows = np.zeros((len(numbers), int(counts.max()), _BLOB), dtype=np.int32)
        inside = np.arange(rows.shape[1]) < counts[:, None]
        rows[inside] = np.column_stack([angle, width, colour, nearest])
        camera_state(state).reply.keep(numbers, _BLOB, counts, rows)


def _step(camera: Camera) -> float:
    """Return the angle of a column [0.1 deg]."""
    return float(rad_to_tenths_deg(camera.field_of_view_rad / camera.columns))


def _fan(camera: Camera) -> Fan:
    step_rad = camera.field_of_view_rad / camera.columns
    left_rad = camera.direction_rad + (camera.columns - 1) / 2 * step_rad
    beams = (
        (camera.x_m, camera.y_m, (left_rad - column * step_rad) % math.tau, 0.0, camera.range_m)
        for column in range(camera.columns)
    )
    return Fan.of(beams, camera.z_m)


DEVICE = Device(
    name="camera",
    title="Camera",
    element="camera",
    summary="A camera on the turret (or the body) that measures one row of colours and ranges;"
    " programs read it with crs_camera() and crs_blobs() (crs.h).",
    model=Camera,
    read=read,
    state=state_at_start,
    install=lambda row, world, seed, _log: _Cameras(row, world, seed).installed,
    requests=(
        device_request(
            "CAMERA", 201, "int crs_camera(struct crs_pixel *row, int most)",
            "takes a picture and keeps it for READINGS",
            fields(("blobs", "i[0]", "1", "0 for pixels, 1 for blobs")),
            results=fields(("count", "i[0]", "1", "number of readings available from READINGS")),
        ),
    ),
    functions=(
        Function(
            "int crs_camera(struct crs_pixel *row, int most)",
            "takes a picture, and copies the colour and the range of its columns, from left to "
            "right; returns the number of columns copied, at most `most`",
            units="0xRRGGBB, 0.1 in", posts=("CAMERA", "READINGS"), source=(OURS,),
        ),
        Function(
            "int crs_blobs(struct crs_blob *blobs, int most)",
            "takes a picture, and copies the angle, width, colour and range of the blobs of one "
            "colour, from left to right; returns the number of blobs copied, at most `most`",
            units="0.1 deg, 0.1 deg, 0xRRGGBB, 0.1 in", posts=("CAMERA", "READINGS"),
            source=(OURS,),
        ),
    ),
    declarations="""\
/* A column of a camera picture: the colour of the visible object, 0xRRGGBB, and its distance in
   0.1 inch, -1 if no object is in range. */
struct crs_pixel {
    int colour;
    int range;
};

/* Adjacent columns of one colour: the angle of their centre from the optical axis, positive to the
   left, and their angular width, both in 0.1 degree; the colour, 0xRRGGBB; the distance of the
   nearest column in 0.1 inch. */
struct crs_blob {
    int angle;
    int width;
    int colour;
    int range;
};
""",
    degradables=(
        Degradable(
            "camera", "range of a column, numbered from left to right", LENGTH,
            elements_of("camera", lambda camera: numbered(camera.columns)), MAX_COLUMNS,
            "the column has the background colour",
        ),
    ),
    reading=lambda state, model, number: camera_state(state).readings.last(number, model.columns),
    inspect=lambda state, number: range_scan.nearest_text(
        camera_state(state).readings, number, MAX_COLUMNS
    ),
    number=1,
    stream=6,
    source=__file__,
)  # fmt: skip
