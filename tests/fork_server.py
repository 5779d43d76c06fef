"""Runs commands of tests in forks of one process, which has imported and compiled what they need.

To start Python and to import what `crs run` needs takes longer than most tests. A fork is a process
of its own all the same: with its own streams, folder, environment, signals and exit status.
`fork_client.py` asks for it and stands for it. What a fork could not take over, or what is read at
the start of a process only, makes the server refuse; the client then starts a process as usual.

The server ends, with all forks, as soon as its standard input does: whoever started it has ended.
It must have no other threads, which forks would be without.

Its arguments are the descriptor of a socket that listens, and the folder of a cache for what it
compiles before it serves; without one (`/dev/null`), nothing is stored.
"""

from __future__ import annotations

import array
import atexit
import contextlib
import ctypes
import gc
import importlib
import io
import marshal
import os
import runpy
import select
import signal
import socket
import sys
import tempfile
import traceback
from collections.abc import Callable, Iterable
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Final

from fork_client import FORWARDED, NAMESPACES, READ_AT_START, surroundings

if TYPE_CHECKING:
    import wasmtime

PACKAGE: Final = Path(__file__).parents[1] / "crs_cc"

CLIENT: Final = Path(__file__).with_name("fork_client.py")

STREAMS: Final = 3

PASSED: Final = 1 + len(NAMESPACES) + STREAMS
"""The descriptors of a request: the folder, the namespaces, and the streams."""

MAX_FILES: Final = 1024
"""A server has fewer open: one for each client, and one for each fork."""

SILENCE_S: Final = 30.0
"""The timeout of a silent client [s]."""

ONE_THREAD: Final = {b"OPENBLAS_NUM_THREADS": b"1"}
"""What `crs` sets itself, before it imports NumPy."""

USUAL_PROGRAM: Final = """
#include <Nclient.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int main(void)
{
    connect_robot(1);
    vm(1, 1, 0);
    gs();
    printf("%f %s", sqrt(2), strchr("a", 'a'));
    return atoi("0");
}
"""


def read_at_start(environment: dict[bytes, bytes]) -> dict[bytes, bytes]:
    """Return the variables that must be those of the server."""
    beginnings = tuple(os.fsencode(each) for each in READ_AT_START)
    read = {key: value for key, value in environment.items() if key.startswith(beginnings)}
    if read.get(b"PYTHONPATH") == os.fsencode(PACKAGE.parent):  # where the package is, anyway
        del read[b"PYTHONPATH"]
    return read


def import_all() -> None:
    """Import the whole package, except for what needs a library that is not there."""
    for path in sorted(PACKAGE.rglob("*.py")):
        names = path.relative_to(PACKAGE.parent).with_suffix("").parts
        if all(each.isidentifier() for each in names) and names[-1] != "__main__":
            try:
                importlib.import_module(".".join(names).removesuffix(".__init__"))
            except ImportError:
                continue


def compile_with(settings: Callable[[], wasmtime.Config]) -> None:
    """Let commands compile with these settings of the engine."""
    from crs_cc.runtime import executable

    executable.settings = settings


def fill_cache(listener: socket.socket) -> None:
    """Compile into the cache what every run needs, in a process of its own, which ends soon."""
    if os.fork() == 0:
        listener.close()  # clients would wait for this process
        try:
            from crs_cc.jobs import worker

            worker.prepare()
        except Exception:  # whoever needs it will meet it
            traceback.print_exc()
        finally:
            os._exit(0)


def compile_usual_program() -> None:
    """Read the headers and compile the library functions that most programs use."""
    from crs_cc.core.source import Diagnostics
    from crs_cc.session.build import build_executable

    with tempfile.NamedTemporaryFile("w", suffix=".c") as program:
        program.write(USUAL_PROGRAM)
        program.flush()
        for debug in (False, True):
            # Another program each time: a library function's code is kept from its second use on.
            for number in range(2):
                defines = [f"NUMBER={number}"]
                try:
                    build_executable(
                        [Path(program.name)], Diagnostics(), defines=defines, debug=debug
                    )
                except Exception:  # whoever needs it will meet it
                    traceback.print_exc()


def start_jobs_by(address: str) -> None:
    """Let the processes to which a command gives jobs be forks of this server, too."""
    from crs_cc.jobs import pool

    client = [sys.executable, "-I", "-S", str(CLIENT), address]
    pool.python = lambda *words: [*client, *words]


def receive(client: socket.socket) -> tuple[bytes, list[int]]:
    """Return a request and what is passed with it."""
    content, passed = b"", array.array("i")
    with contextlib.ExitStack() as failed:
        failed.callback(close, passed)  # who reads or writes their other ends would wait
        while len(content) < 4 or len(content) < 4 + int.from_bytes(content[:4], "little"):
            more, extra, _, _ = client.recvmsg(1 << 20, socket.CMSG_SPACE(PASSED * 4))
            for _, _, data in extra:
                passed.frombytes(data)
            if not more:
                raise OSError("the client has ended")
            content += more
        failed.pop_all()
    return content[4:], list(passed)


def close(numbers: Iterable[int]) -> None:
    """Close descriptors."""
    for each in numbers:
        os.close(each)


def standard_stream(number: int) -> io.TextIOWrapper:
    """Return a standard stream as Python makes it at its start."""
    known = (sys.__stdin__, sys.__stdout__, sys.__stderr__)[number]
    assert known is not None
    at_once = bool(os.environ.get("PYTHONUNBUFFERED"))
    buffering = 0 if at_once and number else -1
    bytes_ = open(number, "wb" if number else "rb", buffering, closefd=False)  # noqa: SIM115
    getattr(bytes_, "raw", bytes_).name = known.name
    stream = io.TextIOWrapper(
        bytes_, known.encoding, known.errors, "\n" if number else None,
        line_buffering=number == 2 and not at_once, write_through=at_once,
    )  # fmt: skip
    stream.mode = "w" if number else "r"  # type: ignore[misc]
    return stream


def kill_all_of(process: int) -> None:
    """End a fork and the processes that it has started, but for those that have left its group."""
    for kill in (os.kill, os.killpg):  # it may have no group of its own yet
        with contextlib.suppress(ProcessLookupError):
            kill(process, signal.SIGKILL)


def enter(own: str, namespace: int) -> None:
    """Enter the namespace of a client if it is another one; whoever made that may do so."""
    if not os.path.sameopenfile(os.open(own, os.O_RDONLY), namespace):
        library = ctypes.CDLL(None, use_errno=True)  # `os.setns` is there since Python 3.12
        if library.setns(namespace, 0):
            raise OSError(ctypes.get_errno(), f"cannot enter the namespace of {own}")


class Command:
    """What a client wants to be run: Python's arguments, and what a process has from its parent."""

    def __init__(self, content: bytes, passed: list[int]) -> None:
        words, self._environment, self._mask, self._ignored, self._around = marshal.loads(content)
        self._words = [os.fsdecode(each) for each in words]
        self._folder, *others = passed
        self._namespaces, self._streams = others[: len(NAMESPACES)], others[len(NAMESPACES) :]

    def can_run(self, environment: dict[bytes, bytes], around: dict[str, object]) -> bool:
        """Return whether a fork of this process would do what a process of its own does."""
        first = self._words[0] if self._words else "-"
        return (
            (first in {"-P", "-m", "-c"} or not first.startswith("-"))
            and self._around == around
            and read_at_start(ONE_THREAD | self._environment) == read_at_start(environment)
        )

    def close(self) -> None:
        """Close what was passed."""
        close([self._folder, *self._namespaces, *self._streams])

    def run(self) -> None:
        """Make this process the one that the client stands for, and run the command."""
        self._take_over()
        is_safe = self._words[0] == "-P"
        first, *rest = self._words[is_safe:]
        sys.path[:0] = filter(None, [os.environ.get("PYTHONPATH")])
        if not is_safe:
            beside = str(Path(first).resolve().parent)
            sys.path.insert(0, {"-m": os.getcwd(), "-c": ""}.get(first, beside))  # noqa: PTH109
        if first == "-m":
            sys.argv = rest
            runpy.run_module(rest[0], run_name="__main__", alter_sys=True)
        elif first == "-c":
            sys.argv = ["-c", *rest[1:]]
            main = sys.modules["__main__"] = ModuleType("__main__")
            atexit.register(vars(main).clear)  # as Python does, after its own handlers
            exec(compile(rest[0], "<string>", "exec"), vars(main))
        else:
            sys.argv = [first, *rest]
            runpy.run_path(first, run_name="__main__")

    def _take_over(self) -> None:
        os.setsid()
        for name, namespace in zip(NAMESPACES, self._namespaces, strict=True):
            enter(f"/proc/self/ns/{name}", namespace)
        os.fchdir(self._folder)
        for number, stream in enumerate(self._streams):
            os.dup2(stream, number)
        os.closerange(STREAMS, MAX_FILES)
        os.umask(self._mask)
        tempfile.tempdir = None  # that of the server
        os.environb.clear()
        os.environb.update(self._environment)
        for name in FORWARDED:
            usual = signal.default_int_handler if name == "SIGINT" else signal.SIG_DFL
            taken = signal.SIG_IGN if name in self._ignored else usual
            signal.signal(getattr(signal, name), taken)
        sys.stdin, sys.stdout, sys.stderr = map(standard_stream, range(STREAMS))
        sys.__stdin__, sys.__stdout__, sys.__stderr__ = sys.stdin, sys.stdout, sys.stderr


class Server:
    """Forks for each command, tells clients of their fork, and ends forks without a client."""

    def __init__(self, listener: socket.socket) -> None:
        self._listener = listener
        self._environment = dict(os.environb)
        self._around = surroundings()
        self._waiting = select.poll()
        self._waiting.register(listener, select.POLLIN)
        self._waiting.register(0, select.POLLIN)
        self._forks: dict[int, tuple[int, socket.socket]] = {}  # by the descriptor of the process
        self._clients: dict[int, int] = {}  # the process of each

    @property
    def address(self) -> str:
        """Return where its socket is."""
        return str(self._listener.getsockname())

    def next_command(self) -> Command:
        """Return a command in a fork that is there for it; the server itself never returns."""
        while True:
            for number, _ in self._waiting.poll():
                if number == 0:
                    self._end()
                elif number in self._forks:
                    self._bury(number)
                elif number in self._clients:
                    self._kill(number)
                elif number == self._listener.fileno():
                    client, _ = self._listener.accept()
                    try:
                        command = self._started(client)
                    except OSError:  # the client has been killed
                        client.close()
                        continue
                    if command is not None:
                        return command

    def _started(self, client: socket.socket) -> Command | None:
        """Fork for a client, and return its command in the fork."""
        client.settimeout(SILENCE_S)
        command = Command(*receive(client))
        if not command.can_run(self._environment, self._around):
            client.sendall(bytes(4))
            command.close()
            client.close()
            return None
        process = os.fork()
        if process == 0:
            for each in (self._listener, client, *(other for _, other in self._forks.values())):
                each.detach()  # the command closes all, and may open others of these numbers
            return command
        command.close()
        ended = os.pidfd_open(process)
        self._forks[ended] = process, client
        self._clients[client.fileno()] = process
        self._waiting.register(ended, select.POLLIN)
        self._waiting.register(client, select.POLLIN)
        self._say(client, process)
        return None

    def _say(self, client: socket.socket, number: int) -> None:
        try:
            client.sendall(number.to_bytes(4, "little", signed=True))
        except OSError:  # it has been killed, which its socket tells, too
            return

    def _kill(self, number: int) -> None:
        """End the fork of a client that is no longer there."""
        kill_all_of(self._clients[number])
        self._waiting.unregister(number)

    def _bury(self, ended: int) -> None:
        """Tell the client of a fork how that has ended."""
        process, client = self._forks.pop(ended)
        seen = os.waitid(os.P_PID, process, os.WEXITED | os.WNOWAIT)
        if seen is not None and seen.si_status == signal.SIGKILL:  # as whoever started it would do
            kill_all_of(process)
        _, status = os.waitpid(process, 0)
        self._waiting.unregister(ended)
        os.close(ended)
        del self._clients[client.fileno()]
        with contextlib.suppress(KeyError):  # it has been killed
            self._waiting.unregister(client)
        self._say(client, os.waitstatus_to_exitcode(status))
        client.close()

    def _end(self) -> None:
        for process, _ in self._forks.values():
            kill_all_of(process)
        address = Path(self.address)
        address.unlink(missing_ok=True)
        address.parent.rmdir()
        os._exit(0)


def run(command: Command) -> None:
    """Run a command in a fork, and end without freeing all modules: that would copy their pages."""
    from crs_cc.cli.process import exit_process

    try:
        command.run()
    except SystemExit as end:
        if not isinstance(end.code, int | None):
            raise
        exit_process(end.code or 0)
    exit_process(0)


def main() -> None:
    os.environb.update(ONE_THREAD)
    from fast_settings import fast_settings

    sys.path.pop(0)  # the folder of this file, which no command looks into
    listener = socket.socket(fileno=int(sys.argv[1]))
    server = Server(listener)
    import_all()
    compile_with(fast_settings)
    start_jobs_by(server.address)
    os.environ["CRS_CACHE"] = sys.argv[2]
    if sys.argv[2] != os.devnull:
        fill_cache(listener)
    compile_usual_program()
    gc.collect()
    gc.freeze()  # a collection in a fork would copy the pages of what all share
    run(server.next_command())


if __name__ == "__main__":
    main()
