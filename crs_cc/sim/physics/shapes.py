"""Conversion of a world to pymunk: shapes of bodies, floor friction, the ground."""

from __future__ import annotations

from typing import Final

import numpy as np
import pymunk

from crs_cc.core.arrays import FloatArray
from crs_cc.sim.geometry.frames import compose
from crs_cc.sim.geometry.ledges import Ledges
from crs_cc.sim.geometry.scene import Scene, convex_parts_of, corners_m, own_corners_m
from crs_cc.sim.model.world import Box, Cylinder, Polygon, Solid, Wall, WorldObject
from crs_cc.sim.physics.rigid import CompositeBody
from crs_cc.sim.state.bodies import Bodies

SURFACE_FRICTION: Final = 0.5
"""Friction of each surface; for a contact the product of two counts. Our choice."""

_PATCH: Final = 1  # collision type of the ground
_LEAVES_MPS: Final = 1e-3  # a body that moves away from the ground faster is not blocked by it
_AS_IT_IS: Final = np.zeros(3)


def add(space: pymunk.Space, body: pymunk.Body, *shapes: pymunk.Shape) -> None:
    """Add a body with its shapes."""
    for shape in shapes:
        shape.friction = SURFACE_FRICTION
    space.add(body, *shapes)


def floor_friction(
    floor: pymunk.Body, body: pymunk.Body, whole: CompositeBody
) -> tuple[pymunk.Constraint, pymunk.Constraint]:
    """Return joints that model an object's friction on the floor."""
    slide = pymunk.PivotJoint(floor, body, (0.0, 0.0), (0.0, 0.0))
    turn = pymunk.GearJoint(floor, body, 0.0, 1.0)
    slide.max_force, turn.max_force = whole.friction_n, whole.friction_nm
    slide.max_bias = turn.max_bias = 0.0  # no position correction: a pushed object stays there
    return slide, turn


def shapes_of(body: pymunk.Body, whole: CompositeBody) -> list[pymunk.Shape]:
    """Return the shapes of all parts of a composite body."""
    return [shape for obj, place in whole.parts for shape in object_shapes(body, obj, place)]


def object_shapes(
    body: pymunk.Body, obj: WorldObject, pose: FloatArray = _AS_IT_IS
) -> list[pymunk.Shape]:
    """Return the shapes of a movable object, at a pose in the frame of a body."""
    if isinstance(obj, Cylinder):
        return [pymunk.Circle(body, obj.radius_m, (float(pose[0]), float(pose[1])))]
    corners = np.column_stack([own_corners_m(obj), np.zeros(len(own_corners_m(obj)))])
    placed = compose(np.broadcast_to(pose, corners.shape), corners)[:, :2]
    return _straight_shapes(body, obj, placed)


def fixed_shapes(body: pymunk.Body, solid: Solid) -> list[pymunk.Shape]:
    """Return the shapes of a fixed solid, in the world frame."""
    if isinstance(solid, Wall):
        ends = (solid.x1_m, solid.y1_m), (solid.x2_m, solid.y2_m)
        return [pymunk.Segment(body, *ends, solid.thickness_m / 2)]
    if isinstance(solid, Cylinder):
        return [pymunk.Circle(body, solid.radius_m, (solid.pose.x_m, solid.pose.y_m))]
    return _straight_shapes(body, solid, corners_m(solid))


def _straight_shapes(
    body: pymunk.Body, obj: Box | Polygon, corners: FloatArray
) -> list[pymunk.Shape]:
    """Return the shapes of a box or polygon; pymunk's polygons are convex."""
    if isinstance(obj, Box):
        return [pymunk.Poly(body, [(x, y) for x, y in corners.tolist()])]
    pieces = corners[convex_parts_of(obj)].tolist()
    return [pymunk.Poly(body, [(x, y) for x, y in piece]) for piece in pieces]


def add_ground(space: pymunk.Space, bodies: list[pymunk.Body], ledges: Ledges) -> pymunk.Body:
    """Add all blocking parts of the ground; `ledges` decides at each contact whether they block."""
    ground = pymunk.Body(body_type=pymunk.Body.STATIC)
    numbers = {shape: n for n, body in enumerate(bodies) for shape in body.shapes}
    shapes: list[pymunk.Shape] = []
    for number, corners in enumerate(ledges.corners_m().tolist()):
        made: list[pymunk.Shape] = [pymunk.Poly(ground, corners)]
        if number < ledges.patches:  # only their edges: a body on one would always be in contact
            ends = zip(corners, [*corners[1:], corners[0]], strict=True)
            made = [pymunk.Segment(ground, tuple(a), tuple(b), 0.0) for a, b in ends]
        numbers.update(dict.fromkeys(made, number))
        shapes += made
    add(space, ground, *shapes)
    for shape in shapes:
        shape.collision_type = _PATCH
    # The space must hold no reference to its owner: neither could ever be freed.
    space.on_collision(_PATCH, 0, pre_solve=_meet_patch, data=(ledges, numbers))
    return ground


def _meet_patch(
    arbiter: pymunk.Arbiter, _: pymunk.Space, data: tuple[Ledges, dict[pymunk.Shape, int]]
) -> None:
    """Disable contacts of a body with a patch that does not block it."""
    ledges, numbers = data
    patch, other = arbiter.shapes
    if other.body is not None and other.body.velocity.dot(arbiter.normal) > _LEAVES_MPS:
        arbiter.process_collision = False
        return
    points = [(point.point_a.x, point.point_a.y) for point in arbiter.contact_point_set.points]
    arbiter.process_collision = ledges.blocks(numbers[other], numbers[patch], points)


def overlap(scene: Scene, bodies: Bodies, one: int, other: int) -> bool:
    """Return whether two objects, as in `Scene.names`, overlap or touch at their current poses."""
    space = pymunk.Space()  # pymunk's comparison of two shapes fails if they do not meet
    body, theirs = _standing(scene, bodies, other)
    space.add(body, *theirs)
    _, shapes = _standing(scene, bodies, one)
    return any(space.shape_query(shape) for shape in shapes)


def _standing(scene: Scene, bodies: Bodies, obj: int) -> tuple[pymunk.Body, list[pymunk.Shape]]:
    """Return the body and the shapes of an object at its current pose, in no space."""
    moving = len(scene.start)
    body = pymunk.Body(body_type=pymunk.Body.STATIC)
    shapes: list[pymunk.Shape]
    if obj < moving:
        x_m, y_m = bodies.position_m[obj].tolist()
        body.position, body.angle = (x_m, y_m), float(bodies.angle_rad[obj])
    if obj < scene.robots:
        shapes = [pymunk.Circle(body, scene.world.robots[obj].model.radius_m)]
    elif obj < moving:
        shapes = object_shapes(body, scene.pushables[obj - scene.robots])
    else:
        shapes = fixed_shapes(body, scene.fixed_solids[obj - moving])
    return body, shapes
