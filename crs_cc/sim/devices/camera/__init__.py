"""The camera: a row of colours and ranges.

    column n  = the first object along direction n, within the range
    direction n = direction of the camera + ((columns - 1) / 2 - n) * field of view / columns

Columns are numbered from left to right, as in a picture. A column has the colour of the object's
surface (`Material.colour` of the world file) and its distance from the camera, for which a real one
would need a second lens; a column without an object in range has the camera's background colour.
Light and shadow have no effect. A camera turns with the mount of its robot. It takes a picture when
the program requests one, at most at its rate, or on its timer (`timers`); requests in between
return the previous picture.

Blobs are runs of adjacent columns of one colour, as found by a colour tracker: two objects of the
same colour that touch in the picture are one blob, at the distance of the nearer one.

Noise: a normal deviate is added to each range; its standard deviation is the definition's noise at
1 m and grows with the square of the distance, as for two lenses. Then degradation (`camera`)
applies to the ranges: a column whose range is dropped has the background colour. The model was
chosen by us: the CRS report (6.2) suggests such a device without specifying it.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core import random_streams
from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int32Array
from crs_cc.core.time_grid import is_due
from crs_cc.core.units import m_to_tenths_inch, rad_to_tenths_deg
from crs_cc.sim.devices.camera.blobs import blobs
from crs_cc.sim.devices.mount import mount_poses
from crs_cc.sim.devices.timers import read_on_request
from crs_cc.sim.geometry.rays import NO_THING, Fan
from crs_cc.sim.geometry.surfaces import packed
from crs_cc.sim.model.sensors import MAX_COLUMNS
from crs_cc.sim.state.timers import CAMERA

if TYPE_CHECKING:
    from crs_cc.sim.devices.ray_caster import RayCaster
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.model.sensors import Camera
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState


_PIXEL: Final = 2
_BLOB: Final = 4


class Cameras:
    """The cameras of all robots that have one.

    Attributes:
        fans: the beams of each kind of camera.
        interval_s: minimum time between two pictures of each.
    """

    def __init__(self, world: WorldModel, seed: int) -> None:
        self._models = [camera for robot in world.robots if (camera := robot.model.camera)]
        self._kinds = list(dict.fromkeys(self._models))
        self._kind = np.array([self._kinds.index(each) for each in self._models], dtype=np.intp)
        self.fans = [_fan(camera) for camera in self._kinds]
        self.interval_s = np.array([1.0 / camera.rate_hz for camera in self._models])
        self._noise_per_m = np.array([camera.noise_m for camera in self._models])
        noisy = len(world.robots) if self._noise_per_m.any() else 0
        self._noise = random_streams.Noise(seed, random_streams.CAMERA, MAX_COLUMNS, noisy)

    def read(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        rows: IndexArray,
        at_s: FloatArray,
    ) -> None:
        """Take pictures with the cameras that may take one again.

        Args:
            state: changed in place.
            constants: the robots' constants.
            rays: casts rays.
            rows: robots that have a camera, k of them, whose axes were turned to `at_s`.
            at_s: when, for each, shape (k,).
        """
        camera, mine = state.camera, constants.camera[rows]
        due = is_due(camera.at_s[mine], at_s, self.interval_s[mine])
        rows, mine, at_s = rows[due], mine[due], at_s[due]
        kinds = self._kind[mine]
        for kind in np.unique(kinds).tolist():
            some = kinds == kind
            self._look(state, constants, rays, rows[some], kind=kind, at_s=at_s[some])
        camera.at_s[mine] = at_s
        camera.count[mine] += 1

    def _look(
        self,
        state: EnvState,
        constants: RobotConstants,
        rays: RayCaster,
        rows: IndexArray,
        *,
        kind: int,
        at_s: FloatArray,
    ) -> None:
        """Take pictures with the cameras of one kind."""
        camera, mine = state.camera, constants.camera[rows]
        model, fan = self._kinds[kind], self.fans[kind]
        poses = mount_poses(state, constants, rows)
        range_m, thing = rays.seen(state, fan, poses, own=rows)
        if model.noise_m:
            deviates = self._noise.rows(rows, camera.count[mine])[:, : model.columns]
            spread_m = model.noise_m * np.where(thing == NO_THING, 0.0, range_m) ** 2
            range_m = np.maximum(range_m + deviates * spread_m, 0.0)
        range_m = constants.degradations.alter(state, "camera", rows, range_m, at_s)
        seen = np.isfinite(range_m)
        colour = rays.surfaces.colour[thing]
        background = packed(model.background)
        camera.colour[mine, : model.columns] = np.where(seen, colour, background)
        tenths = np.rint(m_to_tenths_inch(np.where(seen, range_m, 0.0)))
        camera.range[mine, : model.columns] = np.where(seen, tenths, -1)

    def take_picture(self, context: RequestContext) -> BoolArray:
        """Answer CAMERA with the number of pixels or blobs; refuse robots without a camera."""
        camera, mine = context.state.camera, context.constants.camera[context.rows]
        has = np.asarray(mine >= 0)
        read_on_request(context, self.read, CAMERA, has)
        for place in np.flatnonzero(has).tolist():
            number = mine[place]
            model = self._models[number]
            colour = camera.colour[number, : model.columns]
            range_ = camera.range[number, : model.columns]
            if context["blobs"][place]:
                camera.told.keep(number, _BLOB, _blob_rows(model, colour, range_))
            else:
                camera.told.keep(number, _PIXEL, np.column_stack([colour, range_]))
            context.put("count", camera.told.count[number], place)
        return has


def _blob_rows(model: Camera, colour: Int32Array, range_: Int32Array) -> Int32Array:
    """Return angle and width [0.1 deg], colour and range [0.1 in] of blobs, (blobs, 4)."""
    found = blobs(colour, range_)
    step = float(rad_to_tenths_deg(model.field_of_view_rad / model.columns))
    first, after = found[:, 0], found[:, 1]
    angle = np.rint((model.columns - first - after) / 2 * step)
    width = np.rint((after - first) * step)
    return np.column_stack([angle, width, found[:, 2], found[:, 3]]).astype(np.int32)


def _fan(camera: Camera) -> Fan:
    step_rad = camera.field_of_view_rad / camera.columns
    left_rad = camera.direction_rad + (camera.columns - 1) / 2 * step_rad
    beams = (
        (camera.x_m, camera.y_m, (left_rad - column * step_rad) % math.tau, 0.0, camera.range_m)
        for column in range(camera.columns)
    )
    return Fan.of(beams, camera.z_m)
