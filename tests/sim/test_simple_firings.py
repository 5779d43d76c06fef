"""What the kernel of firings does is what sonars do without it."""

from __future__ import annotations

from unittest.mock import patch

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from crs_cc.sim.devices.sonar.errors import SonarErrors
from crs_cc.sim.devices.sonar.model import SonarBoard
from crs_cc.sim.devices.sonar.simple_firings import SimpleFirings
from crs_cc.sim.kernels.program import Kernels
from crs_cc.sim.state import robot_rows
from tests.sim.driver import world_of
from tests.sim.test_simple_requests import outcome

WORLDS = {
    "noise, walls, and a push": """
        <robot setup="noisy" x="1m" y="1m"/><robot setup="noisy" x="1.6m" y="1m" heading="90deg"/>
        <robot x="9.7m" y="5m"/><cylinder x="4m" y="4m" radius="20cm"/>
        <box x="2.5m" y="1m" length="40cm" width="40cm" mass="1kg"/>""",
    "turrets, and other rings": """
        <robot definition="nomad200" setup="noisy" x="1m" y="1m"/><robot x="8m" y="8m"/>
        <robot definition="pioneer2dx" x="5m" y="5m"/><wall x1="3m" y1="3m" x2="4m" y2="6m"/>""",
    "failing wheels": """
        <robot x="1m" y="1m"/><robot x="5m" y="5m"/>
        <degradation robot="robot0" device="drive" noise="2in/s"/>""",
    "failing sonars": """
        <robot x="1m" y="1m"/><robot x="5m" y="5m"/>
        <degradation robot="robot0" device="sonar" noise="2in"/>""",
    "soft walls": """
        <robot x="1m" y="1m"/><box x="3m" y="1m" length="1m" width="1m" sonar="0.5"/>""",
}


@pytest.mark.parametrize("name", WORLDS)
@pytest.mark.parametrize("seed", range(2))
def test_echoes_and_states_are_those_without_the_kernel(name: str, seed: int) -> None:
    simply: list[bool] = []
    advance = SimpleFirings.advance

    def counted(*arguments: object) -> bool:
        simply.append(advance(*arguments))  # type: ignore[arg-type]
        return simply[-1]

    with patch.object(SimpleFirings, "advance", lambda *_: False):
        told = outcome(world_of(WORLDS[name]), seed)
    checked = Kernels(holds_world=True, checked=True)
    with (
        patch.object(robot_rows, "Kernels", lambda **_: checked),
        patch.object(SimpleFirings, "advance", counted),
    ):
        assert outcome(world_of(WORLDS[name]), seed) == told
    if seed == 0:  # the kernels of users do the same
        assert outcome(world_of(WORLDS[name]), seed) == told
    assert any(simply) == (name.split(maxsplit=1)[0] in {"noise,", "turrets,"})


def numpy_reported_m(board: SonarBoard, distance_m: float, error: float, *, lost: bool) -> float:
    """Return the range that a sonar reports, by the rules of `sonar.errors` in their order."""
    reported_m = distance_m
    if distance_m < board.blind_m:
        times = np.ceil(board.blind_m / distance_m) if distance_m else 1.0
        reported_m = times * distance_m if distance_m else board.blind_m
    reported_m = max(reported_m, board.minimum_m)
    if np.isinf(reported_m) or lost:
        return float("inf")
    spread_m = np.sqrt(board.noise_m**2 + (board.noise_share * reported_m) ** 2)
    reported_m = max(reported_m + error * spread_m, 0.0)
    if board.resolution_m:
        reported_m = np.rint(reported_m / board.resolution_m) * board.resolution_m
    return float(reported_m)


SMALL = st.sampled_from([0.0, 0.01, 0.0254, 0.3])


@given(
    st.builds(
        SonarBoard,
        blind_m=SMALL,
        minimum_m=SMALL,
        noise_m=SMALL,
        noise_share=SMALL,
        dropouts=st.sampled_from([0.0, 0.5, 1.0]),
        resolution_m=SMALL,
    ),
    st.lists(st.floats(0, 9) | st.sampled_from([0.0, np.inf]), min_size=1, max_size=5),
    st.lists(st.floats(-4, 4), min_size=3, max_size=3),
)
def test_reported_ranges_follow_the_rules(
    board: SonarBoard, distance_m: list[float], deviates: list[float]
) -> None:
    errors = SonarErrors([board], np.zeros(len(distance_m), np.intp), seed=1, stream=0)
    rows = np.arange(len(distance_m))
    drawn = np.tile(deviates, (len(rows), 1))
    found = errors.reported_m(rows, np.zeros_like(rows), np.array(distance_m), drawn)
    limit = {0.0: -np.inf, 0.5: 0.0, 1.0: np.inf}[board.dropouts]
    wanted = [
        numpy_reported_m(board, each, deviates[0], lost=deviates[1] < limit) for each in distance_m
    ]
    assert found == pytest.approx(wanted, rel=1e-15)
