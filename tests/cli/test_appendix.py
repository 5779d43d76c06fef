"""The command lines of the report's Appendix A, with `crs` for `java`, as processes of their own.

The report has ports of their own for viewers (3000) and robots (8000); here one port has both.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import textwrap
from collections.abc import Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import Final

import pytest

from crs_cc.cli.main import main
from tests import commands
from tests.cli.machines import Machine, free_port, machines

TIMEOUT_S: Final = 120.0
PROCYON: Final = "procyon.cis.ksu.edu"
PLACE: Final = "edu.ksu.cis.cooprobot.simulator"

ENVIRONMENT: Final = (
    f"java {PLACE}.environment.Environment ../TestLoadFiles/environment/complex-3r.xml",
    "crs serve complex-3r.xml --listen 0.0.0.0:8000",
)
LOCAL_VIEWER: Final = (
    f"java {PLACE}.viewer.Viewer2D localhost 3000",
    "crs view localhost:8000",
)
FAR_VIEWER: Final = (
    f"java {PLACE}.viewer.Viewer2D {PROCYON} 3000",
    f"crs view {PROCYON}:8000",
)


def robots(place: str) -> list[tuple[str, str]]:
    """Return the command lines of the robots."""
    return [
        (
            f"java {PLACE}.robot.RobotControlPanel robot{number} {place} 8000",
            f"crs join robot{number} {place}:8000 wander.c",
        )
        for number in range(3)
    ]


STAND_ALONE: Final = [ENVIRONMENT, LOCAL_VIEWER, *robots("localhost")]
DISTRIBUTED: Final = [ENVIRONMENT, LOCAL_VIEWER, FAR_VIEWER, *robots(PROCYON)]

TOKENS: Final = {"robot": "0123456789abcdef", "view": "fedcba9876543210"}
RUN: Final = ("--insecure", "--tokens", "tokens", "--max-time", "20", "--speed", "8")

BROWSER: Final = """
import json, sys, time
from urllib.parse import urlsplit
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import connect

address = urlsplit(sys.argv[1])
offered = ["crs.1", address.fragment.replace("=", ".")]
end_s = time.monotonic() + 60
while True:
    try:
        page = connect(f"ws://{address.netloc}/channel", subprotocols=offered)
        break
    except InvalidStatus as refused:  # as a page does that has come too early
        assert refused.response.status_code == 503 and time.monotonic() < end_s
        time.sleep(0.1)
frames = 0
try:
    for message in page:
        if isinstance(message, bytes):
            frames += 1
        elif (found := json.loads(message))["type"] == "hello":
            hello = found
except ConnectionClosed:
    pass
robots = [each["id"] for each in hello["world"]["robots"]]
print(json.dumps({"role": hello["role"], "robots": robots, "frames": frames}))
"""
"""A substitute for a browser, which views the run to its end."""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp("appendix")
    (made / "browser.py").write_text(textwrap.dedent(BROWSER))
    commands.put_into(made)
    (made / "tokens").write_text("".join(f"{role} {token}\n" for role, token in TOKENS.items()))
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(made)
        assert main(["samples", "copy", "wander.c", "complex-3r.xml", "."]) == 0
        words = ["run", "wander.c", "complex-3r.xml", "--max-time", "20", "--record", "local.mcap"]
        assert main([*words, "-q"]) == 0
    return made


def started(
    folder: Path, line: str, machine: Machine, port: int, *more: str
) -> subprocess.Popen[str]:
    """Start a command line of the report on a machine."""
    shown = line.replace(PROCYON, machine.server).replace(":8000", f":{port}")
    words = ["./crs", *shown.split()[1:], *more]
    browser = f"{sys.executable} browser.py %s"
    token = TOKENS["view" if " view " in line else "robot"]
    own = {"CRS_TOKEN": token, "BROWSER": browser, "DISPLAY": ":0"}
    return subprocess.Popen(
        [*machine.prefix, *words],
        cwd=folder,
        env=os.environ | own,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def outcomes(
    folder: Path, lines: Sequence[tuple[str, str]], places: Sequence[Machine], record: str
) -> list[tuple[str, int, str, str]]:
    """Run each command line on its machine, and return what has become of it."""
    port = free_port()
    with ExitStack() as stack:
        processes = []
        for (_, line), machine in zip(lines, places, strict=True):
            more = (*RUN, "--record", record) if line is ENVIRONMENT[1] else ()
            process = started(folder, line, machine, port, *more)
            stack.callback(process.communicate)
            processes.append(process)
        for process in processes:  # all before one is waited for, whose browser looks at another
            stack.callback(process.kill)
        said = [process.communicate(timeout=TIMEOUT_S) for process in processes]
    rows = zip(lines, processes, said, strict=True)
    return [(line, process.returncode, *texts) for (_, line), process, texts in rows]


@pytest.mark.parametrize("mode", ["stand-alone", "distributed"])
def test_the_command_lines_of_the_appendix(folder: Path, tmp_path: Path, mode: str) -> None:
    lines = STAND_ALONE if mode == "stand-alone" else DISTRIBUTED
    with machines(tmp_path, PROCYON, 4 if mode == "distributed" else 0) as found:
        far = iter(found[1:])
        places = [next(far) if PROCYON in line else found[0] for _, line in lines]
        done = outcomes(folder, lines, places, f"{mode}.mcap")
    for line, status, out, errors in done:
        assert status == 0, (line, out, errors)
        if " view " in line:
            assert out, (line, errors)
            seen = json.loads(out)
            assert (seen["role"], seen["robots"]) == ("view", ["robot0", "robot1", "robot2"])
            assert seen["frames"] > 5
    recordings = [(folder / f"{name}.mcap").read_bytes() for name in (mode, "local")]
    assert recordings[0] == recordings[1]
