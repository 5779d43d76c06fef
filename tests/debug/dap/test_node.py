"""Sessions with the protocol's public test client, `@vscode/debugadapter-testsupport`.

They need Node and npm, and npm's registry the first time: what it gives is kept with the compiler's
cache. Where that is missing they are skipped, and say so.
"""

from __future__ import annotations

import hashlib
import os
import shutil
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from crs_cc.cli.exit_status import INTERRUPTED
from tests.commands import crs
from tests.debug.dap.programs import LOOP
from tests.debug.dap.test_processes import hear_interrupts

HERE = Path(__file__).parent / "node"
ROOT = Path(__file__).parents[3]
CACHE = Path(os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache")) / "crs_cc_tests"

TWO = """\
#include <unistd.h>
static int seen;
int main(void)
{
    for (;;) {
        seen++;
        sleep(1);
    }
}
"""


def _install(folder: Path) -> str:
    """Installs what the lock file says; return why it cannot be, empty if it could."""
    command = ["npm", "ci", "--ignore-scripts", "--no-audit", "--no-fund", "--loglevel=error"]
    try:
        done = subprocess.run(
            command, cwd=folder, capture_output=True, text=True, timeout=120, check=False
        )
    except subprocess.TimeoutExpired:
        return "its registry does not answer"
    return "" if not done.returncode else (done.stderr.strip() or "it failed").splitlines()[0]


@pytest.fixture(scope="session")
def modules() -> Path:
    """Return a folder with the client, installed once for each content of the lock file."""
    missing = [name for name in ("node", "npm") if shutil.which(name) is None]
    if missing:
        pytest.skip(f"{' and '.join(missing)} not found: the public DAP client cannot be run")
    lock = (HERE / "package-lock.json").read_bytes()
    folder = CACHE / f"dap-{hashlib.sha256(lock).hexdigest()[:16]}"
    if not (folder / "installed").exists():
        folder.mkdir(parents=True, exist_ok=True)
        for name in ("package.json", "package-lock.json"):
            shutil.copy(HERE / name, folder)
        reason = _install(folder)
        if reason:
            pytest.skip(f"npm cannot install the public DAP client: {reason}")
        (folder / "installed").touch()
    return folder / "node_modules"


TOKEN = "a token of these tests"


@pytest.fixture
def port() -> Iterator[int]:
    """Return the port of a server that serves one editor after the other."""
    command = crs("debug", "--dap", "0")
    environment = os.environ | {"PYTHONPATH": str(ROOT), "CRS_DAP_TOKEN": TOKEN}
    with subprocess.Popen(
        command,
        env=environment,
        stderr=subprocess.PIPE,
        text=True,
        preexec_fn=hear_interrupts,  # noqa: PLW1509 - no threads here
    ) as server:
        assert server.stderr is not None
        said = server.stderr.readline()
        yield int(said.rpartition(":")[2])
        server.send_signal(signal.SIGINT)
        assert server.wait(20) == INTERRUPTED


def test_sessions_with_the_public_client(modules: Path, port: int, tmp_path: Path) -> None:
    (tmp_path / "loop.c").write_text(LOOP)
    (tmp_path / "two.c").write_text(TWO)
    environment = os.environ | {
        "NODE_PATH": str(modules),
        "PYTHONPATH": str(ROOT),
        "PYTHON": sys.executable,
        "ADAPTER": str(HERE / "adapter.py"),
        "PORT": str(port),
        "TOKEN": TOKEN,
        "PROGRAMS": str(tmp_path),
        "WORLD": str(ROOT / "worlds" / "pair.xml"),
    }
    command = ["node", "--test", str(HERE / "sessions.test.js")]
    done = subprocess.run(
        command,
        env=environment,
        cwd=tmp_path,
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
