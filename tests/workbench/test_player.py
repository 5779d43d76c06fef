"""Pieces of a run are short at any speed, and a pause stops it."""

from __future__ import annotations

import math
import time

import pytest

from crs_cc.workbench.player import PIECE_S, Player

TIMESTEP_S = 0.05
COST_S = 0.004  # of a timestep


class Run:
    """A run whose timesteps take a while."""

    def __init__(self, player: Player) -> None:
        self.player, self.time_s, self.pieces = player, 0.0, list[int]()

    def go(self, real_s: float) -> None:
        end_s = time.monotonic() + real_s
        while time.monotonic() < end_s:
            count = self.player.timesteps(lambda: self.time_s)
            if not count:
                return
            time.sleep(count * COST_S)
            self.time_s += count * TIMESTEP_S
            self.pieces.append(count)


@pytest.mark.parametrize("speed", [2.0, math.inf])
def test_a_piece_is_never_long_so_that_the_run_can_be_paused(speed: float) -> None:
    run = Run(Player(TIMESTEP_S, speed=speed))
    run.player.play()
    run.go(0.3)
    assert run.pieces[0] == 1
    assert max(run.pieces) <= PIECE_S / COST_S
    if math.isfinite(speed):
        assert run.time_s <= speed * 0.3 + 3 * TIMESTEP_S
    else:
        assert len(run.pieces) < run.time_s / TIMESTEP_S  # it takes several at once


def test_it_waits_while_paused_and_ends_on_request() -> None:
    player = Player(TIMESTEP_S)
    player.submit(player.end)
    assert player.timesteps(lambda: 0.0) == 0
