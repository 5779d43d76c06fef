"""A command that a fork runs does what a process of its own does, and what could not is refused."""

from __future__ import annotations

import _socket
import contextlib
import os
import resource
import signal
import socket
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

from tests import commands, fork_client
from tests.cli.machines import has_namespaces, machines

pytestmark = pytest.mark.skipif(commands.real, reason="all commands are processes of their own")

PROGRAM = """#include <stdio.h>
int main(int argc, char **argv)
{
    char line[80];
    while (fgets(line, sizeof line, stdin)) printf("%s: %s", argv[1], line);
    return 7;
}
"""

SHOWS = """
import io, locale, os, signal, sys
streams = [sys.stdin, sys.stdout, sys.stderr]
for name in ("name", "mode", "encoding", "errors", "newlines", "line_buffering", "write_through"):
    print(name, [getattr(each, name) for each in streams])
print([type(each.buffer) for each in streams], [each.buffer.name for each in streams])
print(sys.argv, sys.path, os.getcwd(), sorted(os.environ.items()), sys.stdin.read())
mask = os.umask(0)
print(mask, sorted(os.listdir("/proc/self/fd"))[:3], sys.flags[:16], locale.getlocale())
print([signal.getsignal(each) for each in signal.valid_signals() if each < 32])
print(sorted(vars(sys.modules["__main__"]).keys() - {"__annotations__"}), __name__)
print("to the error stream", file=sys.stderr)
"""

KINDS = [["-c", SHOWS, "a", "\udcff"], ["shows.py", "b"], ["-m", "shows"], ["-P", "-c", SHOWS]]


def both(words: list[str], **options: object) -> list[tuple[int, bytes, bytes]]:
    """Return what a process of its own and a fork do: exit status, output, errors."""
    found = []
    for command in ([sys.executable, *words], commands.python(*words)):
        done = subprocess.run(command, capture_output=True, check=False, **options)  # type: ignore[call-overload]
        found.append((done.returncode, done.stdout, done.stderr))
    return found


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("OPENBLAS_NUM_THREADS", "1")  # which `crs` sets, and so the server
    monkeypatch.chdir(tmp_path)
    (tmp_path / "shows.py").write_text(SHOWS)
    (tmp_path / "asks.c").write_text(PROGRAM)
    return tmp_path


@pytest.mark.parametrize("words", KINDS, ids=lambda words: "".join(words)[:4])
def test_python_finds_what_it_finds_in_a_process_of_its_own(words: list[str], folder: Path) -> None:
    real, forked = both(words, input="stdin: ä\n".encode(), env={**os.environ, "OWN": "ü"})
    assert forked == real
    assert real[0] == 0, real[2]


@pytest.mark.parametrize(
    ("words", "status"),
    [
        (["--version"], 0),
        (["run", "asks.c", "--", "x"], 7),
        (["check", "--json", "asks.c"], 0),
        (["run", "nothing.c"], 121),
        (["rum"], 2),
    ],
    ids=lambda words: str(words[0]) if isinstance(words, list) else "",
)
def test_crs_does_the_same(words: list[str], status: int, folder: Path) -> None:
    real, forked = both(["-m", "crs_cc", *words], input=b"one\ntwo\n")
    assert forked == real
    assert real[0] == status


@pytest.mark.parametrize(
    ("code", "status"),
    [
        ("import sys; sys.exit(300)", 300 & 255),
        ("import sys; sys.exit('a reason')", 1),
        ("import os, signal; os.kill(os.getpid(), signal.SIGTERM)", -signal.SIGTERM),
        ("import os, signal; os.kill(os.getpid(), signal.SIGKILL)", -signal.SIGKILL),
        ("print('left')\nimport atexit; atexit.register(print, 'last')", 0),
        ("left = open(1, 'w', closefd=False); left.write('in its buffer')", 0),
    ],
)
def test_a_command_ends_as_a_process_does(code: str, status: int) -> None:
    real, forked = both(["-c", code])
    assert forked == real
    assert real[0] == status


def sleeping(*command: str) -> subprocess.Popen[str]:
    """Start a command that reports that it runs, and then sleeps."""
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert process.stdout is not None
    assert process.stdout.readline() == "runs\n"
    return process


SLEEPS = "import time; print('runs', flush=True); time.sleep(300)"


def test_signals_reach_the_command() -> None:
    for each, status in ((signal.SIGTERM, -signal.SIGTERM), (signal.SIGINT, -signal.SIGINT)):
        process = sleeping(*commands.python("-c", SLEEPS))
        process.send_signal(each)
        _, errors = process.communicate(timeout=60)
        assert process.returncode == status
        assert ("KeyboardInterrupt" in errors) == (each == signal.SIGINT)


def test_a_command_ends_with_its_client() -> None:
    process = sleeping(*commands.python("-c", SLEEPS))
    process.kill()
    process.communicate(timeout=60)  # to the end of the output, which the fork holds open


def test_a_command_that_ends_at_once_is_not_run_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    class Slow(_socket.socket):
        """Returns from `sendmsg` only when the server has closed the connection."""

        def sendmsg(self, *message: Any) -> int:
            sent = super().sendmsg(*message)
            connection, _ = listener.accept()
            with connection:
                connection.setblocking(False)
                with contextlib.suppress(BlockingIOError):
                    while connection.recv(1 << 20):
                        pass
                connection.sendall((5).to_bytes(4, "little"))
            return sent

    with socket.socket(socket.AF_UNIX) as listener:
        listener.bind(str(tmp_path / "socket"))
        listener.listen()
        monkeypatch.setattr(_socket, "socket", Slow)
        server = fork_client.ask(str(tmp_path / "socket"), ["-c", "pass"])
    assert fork_client.number(server) == 5
    server.close()


def test_all_ends_with_whoever_has_started_it() -> None:
    code = f"""
import subprocess, sys
from tests import commands
subprocess.Popen(commands.python("-c", {SLEEPS!r})).wait()
"""
    process = sleeping(sys.executable, "-c", f"import sys; sys.path.insert(0, {ROOT!r}){code}")
    process.kill()
    process.communicate(timeout=60)


ROOT = str(Path(__file__).parents[1])


def limited() -> None:
    _, most = resource.getrlimit(resource.RLIMIT_CPU)
    resource.setrlimit(resource.RLIMIT_CPU, (1000, most))


@pytest.mark.parametrize(
    "options",
    [
        {"env": {"PYTHONHASHSEED": "3"}},
        {"env": {"LC_ALL": "C"}},
        {"env": {"OPENBLAS_NUM_THREADS": "2"}},
        {"preexec_fn": limited},
    ],
    ids=["hashes", "locale", "threads", "limits"],
)
def test_what_a_fork_would_do_otherwise_is_a_process_of_its_own(options: dict[str, object]) -> None:
    options["env"] = {**os.environ, **options.get("env", {})}  # type: ignore[dict-item]
    code = "import os; print(os.getppid(), os.environ.get('PYTHONHASHSEED'))"
    (_, real, _), (_, started, _) = both(["-c", code], **options)
    assert started == real
    assert int(real.split()[0]) == os.getpid()


@pytest.mark.skipif(not has_namespaces(), reason="needs network namespaces")
def test_a_command_on_another_machine_sees_its_network_and_mounts(tmp_path: Path) -> None:
    code = (
        "import os, socket; print(socket.gethostbyname('far'), os.getcwd(), socket.if_nameindex())"
    )
    with machines(tmp_path, "far", 1) as (_, other):
        for command in ([sys.executable], commands.python()):
            words = [*other.prefix, *command, "-c", f"{code}; print(os.getppid())"]
            done = subprocess.run(words, check=True, capture_output=True, text=True, cwd=tmp_path)
            seen, parent = done.stdout.splitlines()
            assert seen == f"10.77.1.1 {tmp_path} [(1, 'lo'), (2, 'wire1')]"
    assert int(parent) == commands.server().process


def test_a_closed_stream_is_closed(tmp_path: Path) -> None:
    script = f"{sys.executable} -c 'import sys; sys.exit(sys.stdout is None)' >&-"
    forked = script.replace(" -c", " " + " ".join(commands.python()[1:]) + " -c")
    for each in (script, forked):
        assert subprocess.run(["sh", "-c", each], check=False).returncode == 1


def test_the_server_has_one_thread(folder: Path) -> None:
    subprocess.run(commands.crs("--version"), check=True, capture_output=True)
    process = commands.server().process
    assert len(list(Path(f"/proc/{process}/task").iterdir())) == 1


def test_what_a_test_changes_for_good_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    commands.server()
    assert commands.left_behind() == ""
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    try:
        resource.setrlimit(resource.RLIMIT_NOFILE, (soft - 1, hard))
        assert commands.left_behind().startswith("limits: ")
    finally:
        resource.setrlimit(resource.RLIMIT_NOFILE, (soft, hard))
    assert commands.left_behind().startswith("limits: ")  # they have changed again
    assert commands.left_behind() == ""
    monkeypatch.setenv("OMP_NUM_THREADS", "3")
    assert commands.left_behind().startswith("environment: ")
    monkeypatch.undo()
    assert commands.left_behind().startswith("environment: ")


def test_a_server_that_has_ended_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    process = subprocess.Popen([sys.executable, "-c", "input()"], stdin=subprocess.PIPE)
    server = commands.Server("", process.pid)
    monkeypatch.setattr(commands, "_servers", [server])
    assert commands.left_behind() == ""
    process.kill()
    until_s = time.monotonic() + 20.0
    while not server.has_ended():
        assert time.monotonic() < until_s
        time.sleep(0.01)
    assert "has ended" in commands.left_behind()
    assert commands.left_behind() == ""
    process.communicate()


def test_the_time_of_commands_is_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    works = "import time\nwhile time.process_time() < 0.1: pass"
    waits = f"import subprocess, sys; subprocess.run([sys.executable, '-c', {works!r}])"
    server = sleeping(sys.executable, "-c", f"{waits}; {SLEEPS}")
    monkeypatch.setattr(commands, "_servers", [commands.Server("", server.pid)])
    assert 0.08 < commands.processor_s() < 0.5
    server.kill()
    server.communicate(timeout=60)


def test_an_option_has_all_be_processes_of_their_own(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(commands, "real", True)
    real = [sys.executable, "-m", "crs_cc", "run"]
    assert commands.crs("run") == commands.real_crs("run") == real
