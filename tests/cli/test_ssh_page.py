"""The commands that `docs/cluster.md` shows for two machines with SSH work.

The machines are network namespaces; the other one has a server of SSH, with keys and a home folder
of its own, which end with the test.
"""

from __future__ import annotations

import contextlib
import os
import re
import shutil
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Final

import pytest

from crs_cc.recording.recording import Recording
from tests.cli.machines import Machine, has_namespaces, machines
from tests.commands import put_into

PAGE: Final = Path(__file__).parents[2] / "docs" / "cluster.md"
SSHD: Final = shutil.which("sshd", path=f"{os.environ['PATH']}{os.pathsep}/usr/sbin")
NAME, ADDRESS, PORT = "procyon", "10.77.1.2", 2222
TIMEOUT_S: Final = 90.0

pytestmark = pytest.mark.skipif(
    SSHD is None or shutil.which("ssh") is None or not has_namespaces(),
    reason="needs a client and a server of SSH, and network namespaces",
)


def blocks() -> list[str]:
    """Return the commands of the page's section about SSH."""
    [section] = re.findall(r"## On two machines with SSH\n(.*?)\n## ", PAGE.read_text(), re.DOTALL)
    return re.findall(r"```(?:text|sh)\n(.*?)```", section, re.DOTALL)


def commands(folder: Path) -> Path:
    """Return a folder with the commands of the page; those of SSH use our keys."""
    found = folder / "bin"
    found.mkdir()
    put_into(found)
    lines = {
        "dask": f'exec "{sys.executable}" -m dask "$@"',
        "ssh": f'exec {shutil.which("ssh")} -F "{folder}/ssh_config" "$@"',
        "scp": f'exec {shutil.which("scp")} -S "{found}/ssh" "$@"',
    }
    for name, line in lines.items():
        (found / name).write_text(f"#!/bin/sh\n{line}\n")
        (found / name).chmod(0o700)
    return found


@contextmanager
def served(folder: Path, machine: Machine, path: str) -> Iterator[Path]:
    """Run a server of SSH on a machine; yield the home folder there."""
    home, empty = folder / "home", Path("/run/sshd")
    (home / ".ssh").mkdir(parents=True, mode=0o700)
    empty.mkdir(exist_ok=True, mode=0o755)  # which sshd wants
    for name in ("host", "own"):
        words = ("-q", "-t", "ed25519", "-N", "", "-f", str(folder / name))
        subprocess.run(["ssh-keygen", *words], check=True)
    shutil.copy(folder / "own.pub", home / ".ssh" / "authorized_keys")
    # What Python reads at its start must be as here for `crs` to be a fork.
    same = {name: each for name, each in os.environ.items() if name.startswith(("PYTHON", "LANG"))}
    there = {**same, "PATH": path, "PYTHONPATH": str(PAGE.parents[1])}
    (folder / "sshd_config").write_text(
        f"Port {PORT}\nHostKey {folder}/host\nPidFile none\nUsePAM no\nStrictModes no\n"
        f"PermitRootLogin prohibit-password\nSubsystem sftp internal-sftp\n"
        f"SetEnv {' '.join(f'{name}={each}' for name, each in there.items())}\n"
    )
    (folder / "ssh_config").write_text(
        f"Host {NAME}\n HostName {ADDRESS}\n Port {PORT}\n IdentityFile {folder}/own\n"
        f" UserKnownHostsFile {folder}/known_hosts\n StrictHostKeyChecking accept-new\n"
    )
    users = Path("/etc/passwd").read_text()
    (folder / "passwd").write_text(users.replace(f":{Path.home()}:", f":{home}:"))
    mount = f'mount --bind "{folder}/passwd" /etc/passwd'
    script = f'{mount} && exec {SSHD} -D -e -f "{folder}/sshd_config"'
    with (folder / "sshd.log").open("wb") as log:
        server = subprocess.Popen([*machine.prefix, "sh", "-c", script], stderr=log)
    try:
        yield home
    finally:
        server.terminate()
        server.wait()


def hashes(file: Path) -> list[object]:
    """Return the hashes of the state in a recording."""
    recording = Recording(file)
    try:
        return list(recording.hashes())
    finally:
        recording.close()


def run(folder: Path, machine: Machine, path: str, script: str) -> str:
    """Run commands on a machine; return what they print."""
    with (folder / "log").open("w+") as log:
        words = [*machine.prefix, "bash", "-ec", script]
        environment = os.environ | {"PATH": path}
        shell = subprocess.Popen(
            words, cwd=folder, env=environment, stdout=log, stderr=log, start_new_session=True
        )
        try:
            status = shell.wait(TIMEOUT_S)
        except subprocess.TimeoutExpired:
            status = None
        finally:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(shell.pid, signal.SIGKILL)
        log.seek(0)
        text = log.read()
    assert status == 0, text
    return text


def test_hosts_join_by_hand_through_a_tunnel(tmp_path: Path) -> None:
    path = f"{commands(tmp_path)}{os.pathsep}{os.environ['PATH']}"
    with machines(tmp_path, "hall", 1) as (here, there), served(tmp_path, there, path) as home:
        run(tmp_path, here, path, "crs samples copy wander.c complex-3r.xml .")
        run(tmp_path, here, path, blocks()[0] + "wait\n")
        local = "crs run wander.c complex-3r.xml --max-time 20 --record local.mcap"
        run(tmp_path, here, path, local)
        assert (home / "wander.c").exists()
    assert hashes(tmp_path / "run.mcap") == hashes(tmp_path / "local.mcap")


def test_dask_places_hosts_on_both_machines(tmp_path: Path) -> None:
    pytest.importorskip("distributed", reason="needs the extra 'cluster'")
    path = f"{commands(tmp_path)}{os.pathsep}{os.environ['PATH']}"
    with machines(tmp_path, "hall", 1) as (here, there), served(tmp_path, there, path):
        run(tmp_path, here, path, "crs samples copy wander.c complex-3r.xml .")
        run(tmp_path, here, path, f"{blocks()[1]}kill $(jobs -p)\n")
        local = "crs run wander.c complex-3r.xml --max-time 20 --record local.mcap"
        run(tmp_path, here, path, local)
    assert hashes(tmp_path / "run.mcap") == hashes(tmp_path / "local.mcap")
