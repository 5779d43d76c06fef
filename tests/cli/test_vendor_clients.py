"""Options of programs that are linked with the vendor's libraries: what is wrong with them."""

from __future__ import annotations

import re
import signal
import subprocess
from pathlib import Path

import pytest
from click.testing import CliRunner

from crs_cc.cli.main import crs
from tests import commands
from tests.net.vendor.nclient import Nclient

PAIR = str(Path(__file__).parents[2] / "worlds" / "pair.xml")


@pytest.mark.parametrize(
    ("options", "text"),
    [
        (["--serial", "robo"], "unknown robot 'robo' (known: robot0, robot1)"),
        (["--tcp-robot", "robot1=x"], "'robot1=x' is not [ROBOT=]PORT"),
        (["--tcp-robot", "0", "--tcp-robot", "robot0=0"], "'robot0' has only one line"),
        (["--nserver", "65536"], "65536 is not in the range"),
    ],
)
def test_wrong_options_are_one_error(options: list[str], text: str) -> None:
    done = CliRunner().invoke(crs, ["serve", PAIR, "--max-time", "0.1", *options])
    assert done.exit_code == 2, done.output
    assert text in done.output
    assert done.output.startswith("Usage:"), "no page is opened before"


def test_open_ports_are_announced(tmp_path: Path) -> None:
    options = ["--nserver", "0", "--tcp-robot", "robot1=0", "--insecure", "--max-time", "0.1"]
    done = CliRunner().invoke(crs, ["serve", PAIR, *options])
    assert done.exit_code == 0, done.output
    assert "INSECURE: the vendor's protocols have no password" in done.output
    assert "Nserver is on port" in done.output
    assert "of 0.0.0.0" in done.output
    assert "robot1 is on port" in done.output


@pytest.mark.parametrize("speed", ["max", "1"])
def test_an_interrupted_run_is_verified(tmp_path: Path, speed: str) -> None:
    recording = tmp_path / "run.mcap"
    options = ["--nserver", "0", "--no-view", "--speed", speed, "--record", str(recording)]
    with subprocess.Popen(
        commands.crs("serve", PAIR, *options), stderr=subprocess.PIPE, text=True
    ) as run:
        assert run.stderr is not None
        announced = re.search(r"on port (\d+)", run.stderr.readline())
        assert announced
        client = Nclient(int(announced[1]))
        client.connect_robot()
        client.state_call(12, 50, 50, 0)
        client.state_call(15)
        run.send_signal(signal.SIGINT)
        assert run.wait(30) == 130
        assert "Traceback" not in run.stderr.read()
    done = CliRunner().invoke(crs, ["replay", str(recording), "--verify"])
    assert done.exit_code == 0, done.output
    assert "the same run" in done.output
