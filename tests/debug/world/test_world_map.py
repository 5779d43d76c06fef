"""Maps of worlds in characters: looked at by eye once, held since then."""

import math

import numpy as np
import pytest

from crs_cc.debug.world.world_map import MapWindow, WorldMap
from crs_cc.sim.engine.robot_colours import colour
from tests.sim.driver import Driver, open_world, world_of

ROOM = world_of(
    '<robot x="1m" y="2m" heading="45deg"/>'
    '<box id="desk" x="4m" y="2.5m" length="2m" width="1m"/>'
    '<cylinder id="bin" x="2.5m" y="0.7m" radius="0.3m" mass="2kg"/>'
    '<wall id="screen" x1="2.5m" y1="2m" x2="2.5m" y2="4m" thickness="10cm"/>',
    'length="6m" width="4m"',
)


def shown(chart: WorldMap) -> list[str]:
    return ["".join(text for text, _ in row).rstrip() for row in chart.pieces]


def style_of(chart: WorldMap, column: int, row: int) -> str:
    for text, style in chart.pieces[row]:
        if column < len(text):
            return style
        column -= len(text)
    raise AssertionError


def test_a_room_with_a_path_and_a_contact() -> None:
    environment = Driver.of(ROOM).environment
    path = np.array([[0.3, 0.3], [0.3, 2.0], [1.0, 2.0]])
    view = MapWindow.whole(environment, 30, 12)
    chart = WorldMap(environment, view, paths=[path], contacts=[(0, 5.9, 0.1)])
    assert shown(chart) == GOLDEN
    assert style_of(chart, *view.cell(0.3, 1.0)) == colour(0)
    assert style_of(chart, *view.cell(1.0, 2.0)) == f"bold {colour(0)}"
    assert style_of(chart, *view.cell(2.5, 3.0)) == ""
    assert style_of(chart, *view.cell(4.0, 2.0)) == "#8d95a3"
    assert style_of(chart, *view.cell(2.5, 0.41)) == "#d9b88a"
    assert "✗" in "".join(shown(chart))


def test_map_around_a_robot_with_outline_and_echoes() -> None:
    driver = Driver.of(world_of('<robot x="1m" y="1m"/>', 'length="2m" width="2m"'))
    for _ in range(20):
        driver.environment.step()
    view = MapWindow.around(driver.environment, 0, 36, 18, across_m=2.2)
    assert shown(WorldMap(driver.environment, view, robot=0)) == GOLDEN_CLOSE
    assert shown(WorldMap(driver.environment, view)) != GOLDEN_CLOSE


@pytest.mark.parametrize(("columns", "rows"), [(1, 1), (10, 4), (30, 12), (100, 40), (7, 90)])
def test_a_map_of_any_size_can_be_drawn(columns, rows) -> None:
    environment = Driver.of(ROOM).environment
    pieces = WorldMap(environment, MapWindow.whole(environment, columns, rows), robot=0).pieces
    assert len(pieces) == rows
    assert {sum(len(text) for text, _ in row) for row in pieces} == {columns}


def test_the_scale_is_isotropic_and_cells_have_positions() -> None:
    environment = Driver.of(ROOM).environment
    view = MapWindow.whole(environment, 60, 20)
    east, north = view.dots(np.array([[3.0, 2.0], [3.0, 3.0]])) - view.dots(np.array([[2.0, 2.0]]))
    assert math.hypot(*east) == pytest.approx(view.scale)
    assert north[1] - east[1] == pytest.approx(-view.scale)
    for cell in ((0, 0), (59, 19), (30, 7)):
        assert view.cell(*view.place(*cell)) == cell


def test_an_open_world_shows_its_objects_and_numbers_its_robots() -> None:
    environment = Driver.of(
        open_world('<robot x="-1m" y="0"/><robot x="1m" y="0" heading="180deg"/>')
    ).environment
    assert shown(WorldMap(environment, MapWindow.whole(environment, 24, 4))) == GOLDEN_OPEN


def test_absent_robots_are_not_drawn() -> None:
    world = world_of('<robot x="2m" y="2m"/><robot x="7m" y="7m" join="5s"/>')
    environment = Driver.of(world).environment
    text = "".join(shown(WorldMap(environment, MapWindow.whole(environment, 40, 20))))
    assert text.count("→") == 1


def test_lights_and_sounds_have_symbols() -> None:
    world = world_of(
        '<robot x="2m" y="2m"/><light x="5m" y="5m" brightness="100"/>'
        '<sound x="8m" y="5m" level="60" tone="1"/>'
    )
    environment = Driver.of(world).environment
    text = "".join(shown(WorldMap(environment, MapWindow.whole(environment, 40, 20))))
    assert "☼" in text
    assert "♪" in text


def test_rich_text_has_the_same_characters_and_styles() -> None:
    environment = Driver.of(ROOM).environment
    chart = WorldMap(environment, MapWindow.whole(environment, 30, 12))
    assert [line.rstrip() for line in chart.text.plain.split("\n")] == shown(chart)
    assert f"bold {colour(0)}" in {str(span.style) for span in chart.text.spans}


GOLDEN = [
    "",
    "⡏⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⢹⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⠉⢹",
    "⡇           ⢸                ⢸",
    "⡇           ⢸  ⡤⠤⠤⠤⠤⠤⠤⠤⠤⢤    ⢸",
    "⡇           ⢸  ⡇        ⢸    ⢸",
    "⡇ ⣀⣀⣠↗⡄     ⢸  ⣇⣀⣀⣀⣀⣀⣀⣀⣀⣸    ⢸",
    "⡇ ⡇ ⠘⠒⠃                      ⢸",
    "⡇ ⡇                          ⢸",
    "⡇ ⡇        ⡠⠒⢢               ⢸",
    "⡇ ⡇        ⠣⣀⡸⠁              ⢸",
    "⣇⣀⣁⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀⣀✗⣸",
    " ╶───╴ 1 m",
]
GOLDEN_CLOSE = [
    "⣾⡿⠿⠿⠿⢿⠿⠿⠿⠿⠿⠿⢿⣿⠿⢿⣿⣿⣿⣿⡿⠿⣿⡿⠿⠿⠿⠿⠿⠿⡿⠿⠿⠿⢿⣷",
    "⣿⡇ ⣠⠞⠁   ⠤⠒⠩⠁     ⠄    ⠈⠍⠒⠤   ⠈⠳⣄ ⢸⣿",
    "⣿⣇⠞⠁⠁⠄      ⠐     ⡂    ⠂      ⠠⠈⠈⠳⣸⣿",
    "⣿⡇    ⠐      ⢁    ⠄   ⡈      ⠂    ⢸⣿",
    "⣿⡇ ⡄    ⠁⢀    ⠄   ⠂  ⠠    ⡀⠈    ⢠ ⢸⣿",
    "⣿⡇⡜⡀       ⠄  ⠐   ⡁  ⠂  ⠠       ⢀⢣⢸⣿",
    "⣿⣷⠁ ⠐ ⠄⢀    ⠐  ⠈⠄ ⠄⠠⠁  ⠂    ⡀⠠ ⠂ ⠈⣾⣿",
    "⣿⣇       ⠁⠐ ⡀ ⠁⣠⠔⠒⠒⠢⣄⠈ ⢀ ⠂⠈       ⣸⣿",
    "⣿⣿           ⠁⢰⠁    ⠈⡆⠈           ⣿⣿",
    "⣿⣿ ⠁⠈⠈ ⠁⠈ ⠁⠈ ⡁⠸⡀  ⠉⠉⢉⠇⢈ ⠁⠈ ⠁⠈ ⠁⠁⠈ ⣿⣿",
    "⣿⡏       ⡀⠠ ⠁ ⡀⠙⠢⠤⠤⠔⠋⢀ ⠈ ⠄⢀       ⢹⣿",
    "⣿⡿⡀ ⠠ ⠂⠈    ⠠  ⢀⠂ ⠂⠐⡀  ⠄    ⠁⠐ ⠄ ⢀⢿⣿",
    "⣿⡇⢣⠁       ⠂  ⠠   ⡁  ⠄  ⠐       ⠈⡜⢸⣿",
    "⣿⡇ ⠃    ⡀⠈    ⠂   ⠄  ⠐    ⠁⢀    ⠘ ⢸⣿",
    "⣿⡇    ⠠      ⡈   ⠐    ⢁      ⠄    ⢸⣿",
    "⣿⡏⢦⡀⡀⠂      ⠠    ⠨     ⠄      ⠐⢀⢀⡴⢹⣿",
    "⣿⡇ ⠙⢦⡀   ⠒⠤⣐⡀    ⠐     ⢀⣂⠤⠒   ⢀⡴⠋ ⢸⣿",
    "⢿⣷⣶⣶⣶⣾⣶⣶⣶⣶⣶⣶⣾⣿⣶⣾⣿⣿⣿⣿⣷⣶⣿⣷⣶⣶⣶⣶⣶⣶⣷⣶⣶⣶⣾⡿",
]
GOLDEN_OPEN = [
    "",
    "   ⡖⠚⢲⡀           ⡖⠚⢲⡀",
    "  ⠈⠧→⠼⠁0         ⠈⠧←⠼⠁1",
    " ╶──╴ 0.5 m",
]
