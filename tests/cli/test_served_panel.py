"""The control panel of a run of `crs serve`: the changes of pages, and their permissions."""

from __future__ import annotations

import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from websockets.sync.client import connect

from crs_cc.cli.main import main
from crs_cc.recording.hashes import Hash
from crs_cc.recording.recording import Recording
from tests.cli.test_serve import WORLD, Served, join, outputs, served
from tests.commands import crs
from tests.session.programs import ROAM
from tests.workbench.test_screen import Page

EARLY = (
    *("degrade left sonar.0 dead", "move right to 3 1 90", "sleep right 9", "charge left 50"),
    *("shut from left", "message right to left: hello", "heat left 5", "drive right 0.1 20"),
)
LATER = ("heal left", "open from left", "wake right", "hold right")
LAST = "remove right"


@contextmanager
def page_of(environment: Served, role: str = "control") -> Iterator[Page]:
    word = "open" if role == "control" else "view only:"
    token = environment.wait_for(rf"{word} http://[\d.:]+/#token=(\S+)")[1]
    address = f"ws://{environment.address}/channel"
    protocols = ["crs.1", f"token.{token}"]
    with connect(address, subprotocols=protocols, max_size=None) as line:  # type: ignore[arg-type]
        yield Page(line)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    tmp_path.joinpath("world.xml").write_text(WORLD)
    tmp_path.joinpath("roam.c").write_text(ROAM)
    return tmp_path


def hashes(path: Path) -> list[Hash]:
    """Return what has been written of them."""
    return list(Recording(path).hashes())


def change(page: Page, *texts: str) -> None:
    for text in texts:
        assert "value" in page.ask("edit", text=text), page.told["answer"]


def test_a_run_that_pages_changed_is_that_of_a_local_run_with_the_same_changes(
    folder: Path,
) -> None:
    """Even if a host was lost meanwhile, and then the environment."""
    options = ["--max-time", "4", "--speed", "1", "--record", "killed.mcap"]
    with served(folder, *options, is_real=True) as environment:
        at = environment.address
        words = at, "roam.c", "--retry", "60"
        lost, kept = (join(folder, name, *words) for name in ("left", "right"))
        with page_of(environment) as page:
            page.ask("pause")
            change(page, *EARLY)
            lost.kill()
            lost.communicate()
            page.ask("play")
            page.take_until(lambda: page.told["state"]["waits"] == "left")
            hosts = [join(folder, "left", *words), kept]
            page.take_until(lambda: page.told["state"]["t"] > 0.3)
            change(page, *LATER)
            script = page.ask("export", form="inputs")["value"]["text"]
            assert "hold-right" in page.ask("export", form="xml")["value"]["text"]
        last_s = float(script.splitlines()[-1].partition("s: ")[0])
        while not any(each.timesteps * 0.05 > last_s for each in hashes(folder / "killed.mcap")):
            time.sleep(0.02)
        environment.process.kill()
        environment.process.wait()
    again = "--resume", "killed.mcap", "--listen", at
    with served(folder, *options[:-1], "resumed.mcap", *again) as environment:
        with page_of(environment) as page:
            environment.wait_for(r"continues at [123]\.00 s")
            page.ask("pause")
            change(page, LAST)
            assert page.ask("export", form="inputs")["value"]["text"].startswith(script)
            script = page.told["answer"]["value"]["text"]
            page.ask("speed", speed=0.0)
            page.ask("play")
        assert environment.finish()[0] == 0
        outputs(hosts)
    folder.joinpath("changes.txt").write_text(script)
    assert main(["replay", str(folder / "resumed.mcap"), "--verify"]) == 0
    local = "run", "roam.c", "world.xml", "--max-time", "4", "--inputs", "changes.txt"
    subprocess.run(crs(*local, "--record", "local.mcap", "--quiet"), cwd=folder, check=True)
    same = (
        folder.joinpath("local.mcap").read_bytes() == folder.joinpath("resumed.mcap").read_bytes()
    )
    assert same
