"""The ground: its elements in world files, its height and its gradient."""

import math

import numpy as np
import pytest

from crs_cc.core.errors import WorldError
from crs_cc.sim.files.world_xml import parse_world
from crs_cc.sim.geometry.terrain import Terrain
from crs_cc.sim.model.ground import Ground, Patch


def world(surface: str):
    return parse_world(
        f'<world version="1"><area length="20m" width="20m"/>{surface}<robot x="1" y="1"/>'
        "</world>".encode(),
        "w",
    )


def at(terrain: Terrain, x_m: float, y_m: float) -> tuple[float, list[float]]:
    x, y = np.array([x_m]), np.array([y_m])
    return float(terrain.height_m(x, y)[0]), terrain.gradient(x, y)[0].tolist()


def test_world_without_surface_is_flat():
    assert world("").surface.is_flat
    assert at(Terrain(world("").surface), 3.0, 4.0) == (0.0, [0.0, 0.0])


def test_ramps_and_plateaus_are_read_with_units():
    read = world(
        '<surface><ramp x="200cm" y="1" heading="90deg" length="2m" width="50cm" to="40cm"/>'
        '<plateau x="1" y="2" length="1" width="2" height="100mm"/></surface>'
    ).surface
    assert read.patches == (
        Patch(2.0, 1.0, math.pi / 2, 2.0, 0.5, 0.0, 0.4),
        Patch(1.0, 2.0, 0.0, 1.0, 2.0, 0.1, 0.1),
    )
    assert hash(read) == hash(Ground(read.patches))


@pytest.mark.parametrize(
    ("surface", "wrong"),
    [
        ('<surface><ramp x="1" y="1" length="1" width="1"/></surface>', "missing attribute 'to'"),
        (
            '<surface><plateau x="1" y="1" length="1" width="1" height="-1m"/></surface>',
            "height: '-1m' must not be negative",
        ),
        (
            '<surface><ramp x="1" y="1" length="1mm" width="1" to="1"/></surface>',
            "length: must be 1cm or more",
        ),
        (
            '<surface><ramp x="1" y="1" length="1" width="1" to="101m"/></surface>',
            "to: must be 100m or less",
        ),
    ],
)
def test_invalid_surface_is_rejected(surface, wrong):
    with pytest.raises(WorldError, match=wrong):
        world(surface)


def test_ramp_rises_along_its_heading_and_ends_at_its_sides():
    """A ramp that rises along y, 2 m long, 1 m wide, to 0.5 m: x 3.5 to 4.5, y 1 to 3."""
    terrain = Terrain(Ground((Patch(4.0, 2.0, math.pi / 2, 2.0, 1.0, 0.0, 0.5),)))
    assert at(terrain, 4.0, 1.0)[0] == pytest.approx(0.0)
    assert at(terrain, 4.4, 2.5)[0] == pytest.approx(0.375)
    assert at(terrain, 4.4, 2.5)[1] == pytest.approx([0.0, 0.25])
    assert at(terrain, 4.0, 3.0)[0] == pytest.approx(0.5)  # the edge belongs to it
    for x_m, y_m in [(4.6, 2.5), (3.4, 2.5), (4.0, 3.1), (4.0, 0.9)]:
        assert at(terrain, x_m, y_m) == (0.0, [0.0, 0.0])


def test_highest_of_overlapping_patches_counts():
    """A ramp from 0 to 1 m, x 0 to 4, and a plateau of 0.5 m over its centre, x 1 to 3."""
    terrain = Terrain(
        Ground((Patch(2, 0, 0, 4, 1, 0.0, 1.0), Patch(2.0, 0.0, 0.0, 2.0, 1.0, 0.5, 0.5)))
    )
    assert at(terrain, 0.8, 0.0) == (pytest.approx(0.2), [pytest.approx(0.25), 0.0])
    assert at(terrain, 1.2, 0.0) == (0.5, [0.0, 0.0])
    assert at(terrain, 2.8, 0.0) == (pytest.approx(0.7), [pytest.approx(0.25), 0.0])


def test_vectorised_heights_match_single_points():
    rng = np.random.default_rng(1)
    patches = tuple(
        Patch(*rng.uniform(0, 20, 2), rng.uniform(0, 7), *rng.uniform(0.5, 4, 2), 0.1, float(top))
        for top in rng.uniform(0, 1, 60)
    )
    terrain, (x, y) = Terrain(Ground(patches)), rng.uniform(-1, 21, (2, 400))
    heights, gradients = terrain.height_m(x, y), terrain.gradient(x, y)
    alone = [Terrain(Ground((patch,))) for patch in patches]
    for number in range(0, 400, 13):
        seen = [at(each, x[number], y[number]) for each in alone]
        best = max(seen, key=lambda pair: pair[0])
        assert heights[number] == pytest.approx(best[0])
        assert gradients[number].tolist() == pytest.approx(best[1])
