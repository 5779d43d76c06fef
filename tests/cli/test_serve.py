"""`crs serve` and `crs join`, as processes of their own."""

from __future__ import annotations

import csv
import json
import os
import re
import signal
import subprocess
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import IO

import pytest
from websockets.exceptions import InvalidStatus
from websockets.sync.client import connect

from crs_cc.cli.changed_run import recorded_changes
from crs_cc.cli.main import main
from crs_cc.net.listener import bound_socket
from crs_cc.recording.recording import Recording
from tests.commands import crs, real_crs
from tests.session.programs import ROAM

WORLD = """<world version="1"><area length="6m" width="4m"/>
<robot id="left" x="1m" y="2m"/><robot id="right" x="5m" y="2m" heading="180deg"/></world>"""

ECHO = r"""
#include <stdio.h>
#include <unistd.h>

int main(int argc, char **argv)
{
    char text[80];
    while (fgets(text, sizeof text, stdin))
        printf("%s: %s", argv[argc - 1], text);
    usleep(300000);
    return 7;
}
"""
TIMEOUT_S = 60.0


def busy() -> float:
    """Return how many times as long as alone a process takes here now, at least 1."""
    return max(1.0, os.getloadavg()[0] / (os.cpu_count() or 1))


class Served:
    """An environment in a process of its own."""

    def __init__(self, process: subprocess.Popen[str], log: Path) -> None:
        self.process = process
        self._log = log

    @property
    def text(self) -> str:
        return self._log.read_text()

    @property
    def address(self) -> str:
        found = self.wait_for(r" at (127\.0\.0\.1:\d+)\n")
        return found[1]

    def wait_for(self, pattern: str) -> re.Match[str]:
        """Return where it has said something."""
        end_s = time.monotonic() + TIMEOUT_S
        while not (found := re.search(pattern, self.text)):
            assert self.process.poll() is None, self.text
            assert time.monotonic() < end_s, self.text
            time.sleep(0.01)
        return found

    def finish(self) -> tuple[int, str]:
        """Return its exit status and what it has written to standard output."""
        out, _ = self.process.communicate(timeout=TIMEOUT_S)
        return self.process.returncode, out


@contextmanager
def served(folder: Path, *options: str, is_real: bool = False) -> Iterator[Served]:
    log = folder / "serve.log"
    with log.open("w") as errors:
        start = real_crs if is_real else crs
        words = start("serve", "world.xml", "--listen", "127.0.0.1:0", *options)
        process = subprocess.Popen(
            words, cwd=folder, stdout=subprocess.PIPE, stderr=errors, text=True
        )
    try:
        yield Served(process, log)
    finally:
        process.kill()
        process.communicate()


def join(
    folder: Path, *words: str, stdin: int | IO[str] = subprocess.DEVNULL, is_real: bool = False
) -> subprocess.Popen[str]:
    pipe = subprocess.PIPE
    started = (real_crs if is_real else crs)("join", *words)
    return subprocess.Popen(started, cwd=folder, stdin=stdin, stdout=pipe, stderr=pipe, text=True)


def outputs(hosts: Sequence[subprocess.Popen[str]]) -> list[tuple[str, str]]:
    return [host.communicate(timeout=TIMEOUT_S) for host in hosts]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp("served")
    made.joinpath("world.xml").write_text(WORLD)
    made.joinpath("roam.c").write_text(ROAM)
    made.joinpath("echo.c").write_text(ECHO)
    words = ["run", "roam.c", "world.xml", "--max-time", "3", "--record", "local.mcap"]
    done = subprocess.run(crs(*words), cwd=made, capture_output=True, text=True, check=True)
    made.joinpath("local.txt").write_text(done.stdout)
    return made


@pytest.mark.parametrize("hosts", [["right", "left"], ["--all"]], ids=["two", "one"])
def test_the_recording_of_a_run_on_hosts_is_that_of_a_local_run(
    folder: Path, hosts: list[str]
) -> None:
    options = "--max-time", "3", "--record", "far.mcap", "--json"
    with served(folder, *options) as environment:
        started = [join(folder, name, environment.address, "roam.c") for name in hosts]
        shown = outputs(started)
        status, result = environment.finish()
    assert status == 0
    assert [host.returncode for host in started] == [0] * len(hosts)
    assert folder.joinpath("far.mcap").read_bytes() == folder.joinpath("local.mcap").read_bytes()
    assert json.loads(result)["exit_status"] == 0
    if len(hosts) == 1:
        assert shown[0][0] == folder.joinpath("local.txt").read_text()


def test_a_killed_host_is_detected_soon_and_another_continues(folder: Path) -> None:
    options = "--max-time", "3", "--record", "killed.mcap", "--speed", "1"
    with served(folder, *options) as environment:
        at = environment.address
        left, right = (
            partial(join, folder, each, at, "roam.c", is_real=True) for each in ("left", "right")
        )
        others = [left(), right()]
        environment.wait_for("the run starts")
        for number, signal_ in enumerate((signal.SIGKILL, signal.SIGSTOP)):
            time.sleep(0.3)
            count = environment.text.count("is lost")
            others[-1].send_signal(signal_)
            began_s = time.monotonic()
            while environment.text.count("is lost") == count:
                assert time.monotonic() - began_s < TIMEOUT_S
                time.sleep(0.01)
            assert time.monotonic() - began_s < 2.5 * busy()
            others.append(right())
            environment.wait_for("(?s)" + ".*taken over" * (number + 1))
        status, _ = environment.finish()
        for each in others[1:3]:
            each.kill()
        outputs(others)
    assert status == 0
    assert [others[0].returncode, others[3].returncode] == [0, 0]
    assert folder.joinpath("killed.mcap").read_bytes() == folder.joinpath("local.mcap").read_bytes()


def test_robots_of_a_lost_host_stop_if_the_run_continues_without_it(
    folder: Path,
) -> None:
    options = "--max-time", "5", "--speed", "2", "--on-loss", "stop", "--csv", "tables"
    options += "--record", "stop.mcap"
    with served(folder, *options) as environment:
        at = environment.address
        hosts = [join(folder, name, at, "roam.c") for name in ("left", "right")]
        environment.wait_for("the run starts")
        time.sleep(0.5)
        hosts[1].kill()
        environment.wait_for("right: the host is lost .* its programs and robots stop")
        status = environment.finish()[0]
        outputs(hosts)
    assert status == 1, environment.text
    assert hosts[0].returncode == 0
    with (folder / "tables" / "poses.csv").open() as table:
        rows = [row[1:5] for row in list(csv.reader(table))[1:] if float(row[0]) > 4.0]
    moved = {
        name: len({tuple(each) for each in rows if each[0] == name}) for name in ("left", "right")
    }
    assert moved["right"] == 1 < moved["left"]
    done = subprocess.run(
        crs("replay", "stop.mcap", "--verify"),
        check=False,
        cwd=folder,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 125
    assert re.search(r"right lost its host at .*, which cannot be repeated", done.stderr)


def test_robots_with_late_hosts_join_then_and_the_recording_repeats_it(folder: Path) -> None:
    options = "--start", "now", "--speed", "1", "--record", "late.mcap", "--max-time"
    with served(folder, *options, "3") as environment:
        at = environment.address
        hosts = [join(folder, "left", at, "roam.c")]
        environment.wait_for("the run begins without right\n")
        hosts.append(join(folder, "right", at, "roam.c"))
        environment.wait_for("right: connected")
        assert environment.finish()[0] == 0
        outputs(hosts)
    assert main(["replay", str(folder / "late.mcap"), "--verify"]) == 0
    changes = recorded_changes(Recording(folder / "late.mcap"))
    assert [each.text for each in changes] == ["delay right", "join right"]
    lines = [f"{each.position.timestep * 0.05}s: {each.text}\n" for each in changes]
    folder.joinpath("changes.txt").write_text("".join(lines))
    local = "run", "roam.c", "world.xml", "--inputs", "changes.txt", "--quiet", "--record"
    subprocess.run(crs(*local, "here.mcap", "--max-time", "3"), cwd=folder, check=True)
    assert folder.joinpath("late.mcap").read_bytes() == folder.joinpath("here.mcap").read_bytes()


def test_robots_whose_hosts_had_not_connected_join_after_the_run_is_resumed(folder: Path) -> None:
    options = "--start", "now", "--speed", "1", "--max-time"
    with served(folder, *options, "1", "--record", "early.mcap") as environment:
        hosts = [join(folder, "left", environment.address, "roam.c")]
        assert environment.finish()[0] == 0
        outputs(hosts)
    more = "--resume", "early.mcap", "--record", "rest.mcap"
    with served(folder, *options, "3", *more) as environment:
        at = environment.address
        hosts = [join(folder, name, at, "roam.c") for name in ("right", "left")]
        assert environment.finish()[0] == 0
        outputs(hosts)
    assert main(["replay", str(folder / "rest.mcap"), "--verify"]) == 0
    delayed, joined = recorded_changes(Recording(folder / "rest.mcap"))
    assert (delayed.text, delayed.position.timestep) == ("delay right", 0)
    assert joined.text == "join right"
    assert joined.position.timestep >= 20


def test_the_environment_restarts_the_programs_of_a_lost_host_itself(folder: Path) -> None:
    options = "--max-time", "3", "--speed", "1", "--on-loss", "restart", "--record", "own.mcap"
    with served(folder, *options) as environment:
        at = environment.address
        hosts = [join(folder, name, at, "roam.c") for name in ("left", "right")]
        environment.wait_for("the run starts")
        hosts[1].kill()
        environment.wait_for("right: the host is lost .* its programs continue here")
        late = join(folder, "right", at, "roam.c")
        status, shown = environment.finish()
        outputs([*hosts, late])
    assert status == 0, environment.text
    assert late.returncode != 0
    assert folder.joinpath("own.mcap").read_bytes() == folder.joinpath("local.mcap").read_bytes()
    local, here = (
        [line for line in text.splitlines() if line.startswith("[right]")]
        for text in (folder.joinpath("local.txt").read_text(), shown)
    )
    assert here == local[-len(here) :] != []


@pytest.mark.parametrize("option", [("--tls",), ("--tokens", "echo.c"), ("--resume", "local.mcap")])
def test_options_for_hosts_are_rejected_with_the_vendors_clients_only(
    folder: Path, option: tuple[str, ...], capfd: pytest.CaptureFixture[str]
) -> None:
    words = [str(folder / word) if "." in word else word for word in option]
    assert main(["serve", str(folder / "world.xml"), "--nserver", "0", *words]) == 2
    assert f"{option[0]} applies to programs that join" in capfd.readouterr().err


def test_a_killed_environment_continues_with_the_same_hosts(folder: Path) -> None:
    options = ["--max-time", "3", "--record", "killed.mcap"]
    with served(folder, *options, "--speed", "1", is_real=True) as environment:
        at = environment.address
        hosts = [join(folder, name, at, "roam.c", "--retry", "60") for name in ("left", "right")]
        environment.wait_for("view only")
        while len(list(Recording(folder / "killed.mcap").hashes())) < 2:
            time.sleep(0.02)
        environment.process.kill()
        environment.process.wait()
    options[-1] = "resumed.mcap"
    again = "--resume", "killed.mcap", "--listen", at
    with served(folder, *options, *again) as environment:
        environment.wait_for(r"continues at [12]\.00 s")
        assert environment.finish()[0] == 0
        shown = outputs(hosts)
    assert [host.returncode for host in hosts] == [0, 0]
    assert (
        folder.joinpath("resumed.mcap").read_bytes() == folder.joinpath("local.mcap").read_bytes()
    )
    lines = [line for text, _ in shown for line in text.splitlines()]
    local = folder.joinpath("local.txt").read_text().splitlines()
    assert sorted(lines) == sorted(line.partition("] ")[2] for line in local)


def verify(recording: Path) -> None:
    """Assert that a recording's run can be run again here, to the same states."""
    words = crs("replay", str(recording), "--verify")
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "the same run" in done.stdout + done.stderr


def test_standard_input_and_exit_status_are_those_of_the_host(folder: Path) -> None:
    folder.joinpath("input.txt").write_text("one\ntwo\n")
    with served(folder, "--record", "echo.mcap", "--tls") as environment:
        at = environment.address
        encrypted = "--fingerprint", environment.wait_for(r"certificate: ([0-9a-f]{64})\n")[1]
        with folder.joinpath("input.txt").open() as lines:
            first = join(folder, "left", at, "echo.c", *encrypted, "--", "L", stdin=lines)
        second = join(folder, "right", at, "echo.c", *encrypted, "--", "R")
        assert outputs([first, second])[0][0] == "L: one\nL: two\n"
        status, _ = environment.finish()
    assert (first.returncode, second.returncode, status) == (7, 7, 1)
    verify(folder / "echo.mcap")


def test_a_recording_has_the_program_of_each_robot_and_their_input(folder: Path) -> None:
    with served(folder, "--record", "both.mcap", "--max-time", "2") as environment:
        hosts = [join(folder, "left", environment.address, "roam.c")]
        hosts.append(join(folder, "right", environment.address, "echo.c", "--", "R"))
        outputs(hosts)
        environment.finish()
    verify(folder / "both.mcap")


def test_a_host_reports_that_it_reconnects(folder: Path) -> None:
    with bound_socket("127.0.0.1", 0) as closed:  # nobody listens
        at = f"127.0.0.1:{closed.getsockname()[1]}"
        host = join(folder, "left", at, "echo.c", "--retry", "0.3")
        _, said = host.communicate(timeout=TIMEOUT_S)
    refused = f"crs: {at}: Connection refused"
    assert (host.returncode, said) == (1, f"{refused}; trying again for 0.3 s\n{refused}\n")


def test_unsuitable_hosts_are_rejected_with_the_reason(folder: Path) -> None:
    folder.joinpath("tokens").write_text("robot 0123456789abcdef\n")
    with served(folder, "--tokens", "tokens") as environment:
        at = environment.address
        again = crs("serve", "world.xml", "--listen", at)
        done = subprocess.run(again, cwd=folder, capture_output=True, text=True, check=False)
        text = "Address already in use (name another port by --listen HOST:PORT)"
        assert (done.returncode, done.stderr) == (1, f"crs: error: {text}: {at}\n")
        token = "--token", "0123456789abcdef"
        kept = join(folder, "left", at, "echo.c", *token)
        refused = [
            ("left", "echo.c", "--token", "x", "no valid token for the role 'robot': give that of"),
            ("middle", "echo.c", *token, "unknown robot 'middle' (known: left, right)"),
            ("right", "echo.c", "--robot", "nomad200", *token, "has right as scout"),
            ("left", "echo.c", *token, "left has a host already (without one: right)"),
        ]
        environment.wait_for("waiting for right\n")
        for name, source, *rest, reason in refused:
            host = join(folder, name, at, source, *rest)
            _, said = host.communicate(timeout=TIMEOUT_S)
            assert host.returncode == 2
            assert reason in said
            assert "Traceback" not in said
        host = join(folder, "left", at, "echo.c", *token, "--tls", "--retry", "0")
        _, said = host.communicate(timeout=TIMEOUT_S)
        assert host.returncode == 1
        assert "it does not encrypt as TLS does" in said
        assert "is it served without --tls?" in said
        kept.kill()
        kept.communicate()


def test_an_address_without_a_port_is_named(folder: Path) -> None:
    for words, text in (
        (
            ("left", "8000", "echo.c"),
            "'8000' is not an address HOST:PORT of an environment; write :8000 for this machine.",
        ),
        (
            ("--all", "procyon", "echo.c"),
            "'procyon' is not an address HOST:PORT of an environment; write procyon:8000",
        ),
        (("left", "a b", "echo.c"), "'a b' is not an address HOST:PORT of an environment."),
        (("left",), "no address HOST:PORT"),
    ):
        done = subprocess.run(
            crs("join", *words), cwd=folder, capture_output=True, text=True, check=False
        )
        assert done.returncode == 2
        assert text in " ".join(done.stderr.split())


def test_hosts_report_that_the_run_ended_before_their_programs(folder: Path) -> None:
    with served(folder, "--max-time", "1") as environment:
        at = environment.address
        assert f"crs join ROBOT {at} PROGRAM.c" in environment.wait_for(r"to join: .*\n")[0]
        hosts = [join(folder, "left", at, "roam.c"), join(folder, "right", at, "roam.c")]
        said = [text for _, text in outputs(hosts)]
        environment.finish()
    for name, text in zip(("left", "right"), said, strict=True):
        assert f"the run has ended, and with it the program of {name}" in text


def test_pages_look_at_the_run_on_the_same_port_with_a_token_only(folder: Path) -> None:
    with served(folder, "--max-time", "100", "--speed", "1") as environment:
        at = environment.address
        hosts = [join(folder, "--all", at, "roam.c")]
        token = environment.wait_for(r"view only: http://[\d.:]+/#token=(\S+)")[1]
        with connect(f"ws://{at}/channel", subprotocols=["crs.1", f"token.{token}"]) as page:
            hello = json.loads(page.recv(TIMEOUT_S))
            assert (hello["type"], hello["role"]) == ("hello", "view")
        for wrong in ("x" * 22, ""):
            with pytest.raises(InvalidStatus, match="401"):
                connect(f"ws://{at}/channel", subprotocols=["crs.1", f"token.{wrong}"])
        environment.process.send_signal(signal.SIGINT)
        assert environment.finish()[0] == 130
        outputs(hosts)


@pytest.mark.parametrize("is_encrypted", [False, True])
def test_the_address_of_a_page_shows_whether_the_run_is_encrypted(
    folder: Path, *, is_encrypted: bool
) -> None:
    scheme = "https" if is_encrypted else "http"
    with served(folder, *(["--tls"] if is_encrypted else [])) as environment:
        at = environment.address
        printed = ""
        if is_encrypted:
            printed = environment.wait_for(r"certificate: ([0-9a-f]{64})\n")[1]
        for word in (at, f"https://{at}"):
            words = crs("view", word, "--no-open", "--token", "x" * 22)
            done = subprocess.run(words, cwd=folder, capture_output=True, text=True, check=False)
            assert done.returncode == 0
            said = done.stderr.splitlines()
            expected = "https" if word != at else scheme
            assert said[0] == f"crs: open {expected}://{at}/#token={'x' * 22}"
            if printed:
                assert said[1:] == [f"crs: fingerprint of the certificate: {printed}"]
            else:
                is_wrong = expected != scheme
                assert said[1:] == [f"crs: warning: {at} is not encrypted"] * is_wrong


def test_other_machines_are_admitted_only_on_request(folder: Path) -> None:
    words = crs("serve", "world.xml", "--listen", "0.0.0.0:0")
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert "--insecure" in done.stderr
    assert os.environ.get("CRS_TOKEN") is None
