"""Objects between two points, compared with testing every pair."""

import numpy as np
import pytest

from crs_cc.sim.geometry.line_of_sight import Sight
from crs_cc.sim.geometry.scene import Scene, corners_m
from crs_cc.sim.model.world import Box, Cylinder, Polygon, Wall
from tests.sim.driver import world_of
from tests.sim.messages.radio import talking

ROBOT = '<robot x="1m" y="9m"/>'
NOBODY = np.zeros((1, 2)), np.zeros(1)


def between(elements: str, *lines: tuple[complex, complex]) -> list[int]:
    scene = Scene(world_of(f"{ROBOT}{elements}"))
    start, end = (np.array(places) for places in zip(*lines, strict=True))
    return Sight(scene).between(scene.start[:, :2], scene.start[:, 2], start, end).tolist()


@pytest.mark.parametrize(
    ("line", "count"),
    [
        ((1 + 2j, 4 + 2j), 1),  # through both its sides
        ((1 + 2j, 1.9 + 2j), 0),  # up to it
        ((1 + 3.04j, 4 + 3.04j), 1),  # through its round end
        ((1 + 3.06j, 4 + 3.06j), 0),  # past that
        ((1 + 1j, 1 + 3j), 0),  # along it
        ((2 + 0.5j, 2 + 3.5j), 1),  # lengthwise through it
    ],
)
def test_wall_has_its_thickness_and_round_ends(line, count):
    """A wall from (2, 1) to (2, 3), 10 cm thick."""
    assert between('<wall x1="2m" y1="1m" x2="2m" y2="3m"/>', line) == [count]


def test_object_counts_once_for_any_number_of_intersections():
    """A comb of three teeth: the line goes in and out of it three times.

         #  #  #
    -----#--#--#----
         #######
    """
    points = "2,1 5,1 5,3 4.5,3 4.5,1.5 3.8,1.5 3.8,3 3.2,3 3.2,1.5 2.5,1.5 2.5,3 2,3"
    assert between(f'<polygon points="{points}"/>', (1 + 2j, 6 + 2j), (1 + 4j, 6 + 4j)) == [1, 0]


def test_long_line_counts_each_object_once():
    """Eight walls, and a line of 8 m, which is cut into four."""
    walls = "".join(f'<wall x1="{x}m" y1="1m" x2="{x}m" y2="3m"/>' for x in range(1, 9))
    assert between(walls, (0.5 + 2j, 8.5 + 2j)) == [8]


def test_vectorised_lines_match_single_lines():
    """Random lines among random fixed and movable objects, compared with sampled points."""
    rng = np.random.default_rng(2)
    elements = []
    for n in range(40):
        (row, column), turn = divmod(n, 8), rng.uniform(0, 180)
        x, y = 1.1 * column + rng.uniform(0.5, 0.9), 1.1 * row + rng.uniform(0.5, 0.9)
        mass = ' mass="1kg"' if n % 4 == 0 else ""
        kind = n % 3
        if kind == 0:
            elements.append(f'<wall x1="{x}" y1="{y}" x2="{x + 0.5}" y2="{y + 0.3}"/>')
        elif kind == 1:
            elements.append(f'<cylinder x="{x}" y="{y}" radius="0.2"{mass}/>')
        else:
            size = f'length="0.5" width="0.3" heading="{turn}"'
            elements.append(f'<box x="{x}" y="{y}" {size}{mass}/>')
    world = world_of(ROBOT + "".join(elements), 'length="10m" width="10m" edge="0"')
    scene = Scene(world)
    start, end = rng.uniform(0.5, 8.0, (2, 300, 2)).view(np.complex128)[..., 0]
    found = Sight(scene).between(scene.start[:, :2], scene.start[:, 2], start, end)
    share = np.linspace(0, 1, 4000)[:, None]
    points = start + share * (end - start)
    sampled = sum(_inside(solid, points).any(axis=0).astype(int) for solid in world.solids())
    wrong = np.flatnonzero(found != sampled)
    assert found.max() > 5
    assert len(wrong) <= 4, list(zip(found[wrong], sampled[wrong], strict=True))  # grazes


def _inside(solid, points):
    """Return which points are in an object."""
    if isinstance(solid, Cylinder):
        return np.abs(points - complex(solid.pose.x_m, solid.pose.y_m)) < solid.radius_m
    if isinstance(solid, Wall):
        a, b = complex(solid.x1_m, solid.y1_m), complex(solid.x2_m, solid.y2_m)
        share = ((points - a) * np.conjugate(b - a)).real / abs(b - a) ** 2
        foot = a + np.clip(share, 0, 1) * (b - a)
        return np.abs(points - foot) < solid.thickness_m / 2
    assert isinstance(solid, Box | Polygon)
    corners = corners_m(solid)
    places = corners[:, 0] + 1j * corners[:, 1]
    sides = [
        (np.conjugate(b - a) * (points - a)).imag > 0
        for a, b in zip(places, np.roll(places, -1), strict=True)
    ]
    return np.all(sides, axis=0)


def test_absent_robot_does_not_affect_line_of_sight():
    """A robot leaves; two others still see each other, past a box that can be pushed."""
    elements = """<robot id="gone" x="5m" y="5m"/><robot id="a" x="0" y="0"/>
        <robot id="b" x="2m" y="0"/><robot id="c" x="0" y="2m"/>
        <box x="1m" y="0" length="20cm" width="20cm" mass="1kg"/>"""
    talk = talking(elements, 'walls="0"')
    talk.environment.remove_robot(0)
    talk.run()
    talk.send(1, kind=5)
    talk.run()
    assert (talk.kinds(2), talk.kinds(3)) == ([], [5])
