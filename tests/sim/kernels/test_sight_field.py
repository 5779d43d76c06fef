"""Lines of sight among sorted shapes meet what testing pieces with numpy finds, all of them."""

from __future__ import annotations

import math

import numpy as np
import pytest

from crs_cc.sim.geometry.line_of_sight import Sight
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.kernels import program, sight_field
from crs_cc.sim.model.world import Area, Box, Cylinder, Polygon, Pose, Wall, WorldModel
from tests.sim.geometry.numpy_sight import NumpySight

MANY = 40


def scene(seed: int, side: int, count: int) -> Scene:
    """Return a scene of objects on whole centimetres, some of which overlap, and some can move."""
    rng = np.random.default_rng(seed)

    def place() -> tuple[float, float]:
        x, y = np.rint(rng.uniform(0, 100 * side, 2)) / 100
        return float(x), float(y)

    def mass() -> float:
        return math.inf if rng.random() < 0.7 else 1.0

    def box(number: int) -> Box:
        length, width = np.rint(rng.uniform(20, 90, 2)) / 100
        heading = math.radians(rng.choice([0, 30, 45, 90, 17]))
        return Box(f"box{number}", Pose(*place(), heading), length, width, mass())

    def polygon(number: int) -> Polygon:
        x, y = place()
        corners = (0, 0), (0.5, 0.1), (0.3, 0.6), (0.25, 0.3)
        return Polygon.of(f"p{number}", [(x + a, y + b) for a, b in corners], mass())

    def thickness() -> float:
        return float(rng.choice([0.01, 0.1, 0.3]))

    return Scene(
        WorldModel(
            "sight",
            Area(0, 0, side, side, 0.1),
            walls=tuple(Wall(f"w{n}", *place(), *place(), thickness()) for n in range(count)),
            boxes=tuple(map(box, range(count))),
            cylinders=tuple(
                Cylinder(f"c{n}", Pose(*place()), float(rng.choice([0.1, 0.4])), mass())
                for n in range(count)
            ),
            polygons=tuple(map(polygon, range(count))),
        )
    )


def lines(seed: int, side: int, count: int, starts: int = 0) -> tuple[np.ndarray, np.ndarray]:
    """Return both ends of lines, some beyond the area, some equal, and many on round numbers."""
    starts = starts or count
    rng = np.random.default_rng(seed)
    points_m = np.rint(rng.uniform(-1, side + 1, (2, count, 2)) * 100) / 100
    points_m[:, ::2] = np.rint(points_m[:, ::2] * 2) / 2
    points_m[0] = points_m[0][np.sort(rng.integers(0, starts, count))]
    points_m[1, ::7] = points_m[0, ::7]
    points_m[1, 1::7, 0] = points_m[0, 1::7, 0]
    start, end = points_m.view(np.complex128)[..., 0]
    return start, end


def poses(seen: Scene, seed: int) -> tuple[np.ndarray, np.ndarray]:
    """Return places and headings of movable objects that have moved a little."""
    rng = np.random.default_rng(seed)
    moved_m = np.rint(rng.uniform(-50, 50, (len(seen.start), 2))) / 100
    return seen.start[:, :2] + moved_m, seen.start[:, 2] + rng.uniform(-1, 1, len(seen.start))


SIZES = (
    (5, 1, 4, 4),
    (9, 4, 300, 300),
    (60, 25, 900, 900),
    (5, 1, 99, 2),
    (9, 4, 3000, 7),
    (60, 25, 4000, 2),
)


@pytest.mark.parametrize("seed", range(18))
def test_counts_are_those_of_numpy(seed: int) -> None:
    """Lines from few places are swept, the others are followed piece by piece."""
    side, objects, *sizes = SIZES[seed % 6]
    seen = scene(seed, side, objects)
    ours, expected = Sight(seen), NumpySight(seen)
    ends, most = lines(seed, side, *sizes), 0
    for moved in range(3):
        where = poses(seen, moved)
        counts = expected.between(*where, *ends)
        assert ours.between(*where, *ends).tolist() == counts.tolist()
        most = max(most, counts.max())
        enough = np.random.default_rng(seed).integers(1, 4, len(counts)).astype(np.int32)
        some = ours.between(*where, *ends, enough)
        assert np.minimum(some, enough).tolist() == np.minimum(counts, enough).tolist()
    assert most > 3 or objects == 1


def test_a_world_without_objects_has_free_lines() -> None:
    nothing = Scene(WorldModel("empty", Area(0, 0, 9, 9, 0)))
    assert Sight(nothing).between(*poses(nothing, 0), *lines(0, 9, 5)).tolist() == [0] * 5
    none = np.zeros(0, dtype=np.complex128)
    assert Sight(scene(1, 5, 1)).between(*poses(scene(1, 5, 1), 0), none, none).tolist() == []


@pytest.mark.parametrize("places", [3000, 400, 30])
def test_shapes_and_lines_without_room_for_all_are_divided(monkeypatch, places: int) -> None:
    """With the least room, that of a few segments, objects of several shapes are divided, too."""
    seen, ends = scene(5, 9, 6), lines(5, 9, 100)
    where = poses(seen, 1)
    expected = NumpySight(seen).between(*where, *ends)
    laid = []

    def few(kernels, place: int, tables, *rest) -> int:
        laid.append(tables)
        return 0 if sum(table.size for table in tables) > places else real(
            kernels, place, tables, *rest
        )  # fmt: skip

    real = sight_field.sort_shapes
    monkeypatch.setattr(sight_field, "sort_shapes", few)
    monkeypatch.setattr(sight_field, "_LINES", 33)
    sight = Sight(seen)
    for _ in range(2):
        assert sight.between(*where, *ends).tolist() == expected.tolist()
    assert len(laid) > {3000: 2, 400: 8, 30: 100}[places]


def test_the_checked_build_counts_the_same(monkeypatch) -> None:
    seen, ends = scene(8, 20, 6), lines(8, 20, 200)
    expected = Sight(seen).between(*poses(seen, 1), *ends)
    made = program.Kernels
    monkeypatch.setattr(sight_field, "Kernels", lambda **sizes: made(**sizes, checked=True))
    assert Sight(seen).between(*poses(seen, 1), *ends).tolist() == expected.tolist()
