"""Stands for Python in a test: has its command run by a fork of the server in `fork_server.py`.

Called with the path of the server's socket and with Python's arguments. It passes its streams, its
folder, its environment, and the network and mounts that it sees, forwards signals, and ends as the
fork ends. If it is killed, the server kills the fork. Where a fork would differ from a process of
its own (a terminal, other limits), or no server answers, it becomes that process.

It runs without site packages, and imports as little as possible: all tests wait for its start.
"""

import _socket
import marshal
import os
import resource
import signal
import sys

FORWARDED = ("SIGINT", "SIGTERM", "SIGHUP", "SIGQUIT", "SIGUSR1", "SIGUSR2", "SIGWINCH")

NAMESPACES = ("mnt", "net")
"""What a fork can enter."""

READ_AT_START = (
    *("PYTHON", "LC_", "LANG", "LANGUAGE", "LD_", "MALLOC_", "GLIBC_", "OPENBLAS_", "OMP_"),
    *("NPY_", "RUST_", "TZ", "TEXTUAL"),
)
"""How environment variables begin that Python or a library reads once."""

LIMITS = [each for each in vars(resource) if each.startswith("RLIMIT_")]


def surroundings() -> dict[str, object]:
    """Return what a process has from its parent, and what no fork of another can take over."""
    return {
        "user": (os.getuid(), os.geteuid(), os.getgroups()),
        "limits": [resource.getrlimit(getattr(resource, each)) for each in LIMITS],
        "processes": os.readlink("/proc/self/ns/pid"),  # noqa: PTH115 - pathlib takes long to import
    }


def request(words: list[str]) -> bytes:
    """Return what the server has to know, with its length before."""
    mask = os.umask(0)
    os.umask(mask)
    ignored = [each for each in FORWARDED if _handler(each) is signal.SIG_IGN]
    parts = [os.fsencode(each) for each in words]
    content = marshal.dumps((parts, dict(os.environb), mask, ignored, surroundings()))
    return len(content).to_bytes(4, "little") + content


def _handler(name: str) -> object:
    return signal.getsignal(getattr(signal, name))


def ask(address: str, words: list[str]) -> _socket.socket:
    """Hand a command over to the server."""
    server = _socket.socket(_socket.AF_UNIX, _socket.SOCK_STREAM)
    server.connect(address)
    content = request(words)
    places = [".", *(f"/proc/self/ns/{each}" for each in NAMESPACES)]
    opened = [os.open(each, os.O_RDONLY) for each in places]
    passed = b"".join(each.to_bytes(4, sys.byteorder) for each in (*opened, 0, 1, 2))
    sent = server.sendmsg([content], [(_socket.SOL_SOCKET, _socket.SCM_RIGHTS, passed)])
    if sent < len(content):  # even an empty send fails once the connection is closed
        server.sendall(content[sent:])
    for each in opened:
        os.close(each)
    return server


def number(server: _socket.socket) -> int:
    """Return the next number from the server."""
    said = b""
    while len(said) < 4:
        more = server.recv(4 - len(said))
        if not more:
            raise OSError("the server has ended")
        said += more
    return int.from_bytes(said, "little", signed=True)


def end_like(status: int) -> None:
    """End with an exit status, or by the signal whose negative it is."""
    if status < 0:
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        if -status not in (signal.SIGKILL, signal.SIGSTOP):
            signal.signal(-status, signal.SIG_DFL)
        os.kill(os.getpid(), -status)
    os._exit(status)


def _is_plain(stream: int) -> bool:
    try:
        return not (os.fstat(stream) and os.isatty(stream))
    except OSError:  # it is closed
        return False


def main() -> None:
    address, *words = sys.argv[1:]
    heard: list[int] = []
    if all(map(_is_plain, (0, 1, 2))):
        try:
            server = ask(address, words)
            for each in FORWARDED:
                if _handler(each) is not signal.SIG_IGN:
                    signal.signal(getattr(signal, each), lambda each, _: heard.append(each))
            fork = number(server)
        except OSError:
            fork = 0
        if fork:
            _wait(server, fork, heard)
    os.execv(sys.executable, [sys.executable, *words])


def _wait(server: _socket.socket, fork: int, heard: list[int]) -> None:
    for stream in (0, 1, 2):  # their other ends see when the fork closes them
        os.close(stream)

    def forward(received: int, _: object) -> None:
        try:
            os.kill(fork, received)
        except ProcessLookupError:  # it has ended, which the server is about to say
            return

    for each in FORWARDED:
        if _handler(each) is not signal.SIG_IGN:
            signal.signal(getattr(signal, each), forward)
    for each in heard:
        forward(each, None)
    end_like(number(server))


if __name__ == "__main__":
    main()
