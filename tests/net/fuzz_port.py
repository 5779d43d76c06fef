"""Throws nonsense at the port of an environment, as a port scanner or a fuzzer does.

    python -m tests.net.fuzz_port [--seconds N] [--seed N]

Mutated greetings of hosts, messages, requests of HTTP and of WebSockets, half of them cut, come
beside a run with its hosts. Then the run must still go on, nothing without a token may have been
answered but by a refusal or a file of the page, the environment must not have had an error of its
own, and it must hold no more memory and no more connections than after the first minute.
"""

from __future__ import annotations

import argparse
import contextlib
import random
import re
import socket
import struct
import subprocess
import sys
import tempfile
import time
import zlib
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final

from crs_cc.net.channel import MAGIC, Kind
from crs_cc.net.handshake import Hello, Program, devices_digest

WORLD: Final = """<world version="1"><area length="6m" width="4m"/>
<robot id="left" x="1m" y="2m"/><robot id="right" x="5m" y="2m"/></world>"""

PROGRAM: Final = """#include "Nclient.h"
int main(void) { connect_robot(1); for (;;) { gs(); vm(100, 80, 0); } }
"""
TOKENS: Final = "robot 0123456789abcdef\nview fedcba9876543210\ncontrol 0f1e2d3c4b5a6978\n"
WARM_S: Final = 60.0
MORE_KB: Final = 20_000
"""The permitted excess of memory at the end, compared with an undisturbed run. Chosen by us."""
RUN_KBPS: Final = 9.6
"""How fast the memory of such a run grows, by what pages can go back to; measured over 100 s."""

PATHS: Final = (
    *("/", "/channel", "/app.js", "/../../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "//etc"),
    *("/channel?token=x", "/tokens", "/serve.log", "/world.xml", "/\0", "/" + "a" * 5000),
)
ANSWERS: Final = re.compile(rb"HTTP/1\.1 (200|400|401|403|404|405|413|414|426|431|503)")


@dataclass
class Fuzzer:
    """Connections to a port, each with something else.

    Attributes:
        port: the port.
        random_: determines what is said.
        waits_s: how long an answer is waited for [s]: one of these.
        answers: how often there was which answer.
    """

    port: int
    random_: random.Random
    waits_s: tuple[float, ...] = (0.01, 0.1)
    answers: Counter[str] = field(default_factory=Counter)

    def throw(self) -> None:
        """Connect, say something, and look at the answer."""
        say = self.random_.choice((self.noise, self.greeting, self.messages, self.http, self.page))
        said = self.mutated(say())
        try:
            with socket.create_connection(("127.0.0.1", self.port), 5.0) as connection:
                connection.settimeout(self.random_.choice(self.waits_s))
                connection.sendall(said)
                if self.random_.random() < 0.3:
                    connection.shutdown(socket.SHUT_WR)
                self.look(said, connection.recv(2**16))
        except TimeoutError:
            self.answers["none yet"] += 1
        except OSError:
            self.answers["closed"] += 1

    def look(self, said: bytes, answer: bytes) -> None:
        """Note an answer; raise AssertionError if it must not be given."""
        kind = struct.unpack_from("<I", answer)[0] if len(answer) >= 20 else None
        found = ANSWERS.match(answer)
        if found:
            assert b"root:" not in answer, said
            assert b"0123456789abcdef" not in answer, said
            assert b" 101 " not in answer[:20], said
            self.answers[found[1].decode()] += 1
        elif kind in (Kind.REFUSED, Kind.KEEP_ALIVE):
            self.answers[Kind(kind).name] += 1
        else:
            assert not answer, (said, answer)  # nor an error of ours: 500
            self.answers["closed"] += 1

    def mutated(self, said: bytes) -> bytes:
        """Return something with some bytes changed, duplicated, cut out or added."""
        made = bytearray(said)
        for _ in range(self.random_.choice((0, 0, 1, 2, 8))):
            at = self.random_.randrange(len(made) + 1)
            what = self.random_.randrange(4)
            if what == 0 and at < len(made):
                made[at] = self.random_.randrange(256)
            elif what == 1:
                del made[at : at + self.random_.randrange(20)]
            elif what == 2:
                made[at:at] = self.random_.randbytes(self.random_.randrange(20))
            else:
                made[at:at] = made[at : at + self.random_.randrange(200)]
        return bytes(
            made[: self.random_.randrange(len(made) + 1)] if self.random_.random() < 0.3 else made
        )

    def noise(self) -> bytes:
        """Return random bytes, or the greeting of another protocol."""
        known = b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03", b"SSH-2.0-x\r\n", b"\0" * 64
        return self.random_.choice((*known, self.random_.randbytes(200)))

    def greeting(self) -> bytes:
        """Return the first message of a host, without a valid token."""
        token = self.random_.choice(("", "x" * 16, "fedcba9876543210", "\ud800", "é" * 9))
        hello = Hello(token, "h" * 8, ("left",), "d" * 64, devices=devices_digest())
        return MAGIC + message(Kind.HELLO, hello.content())

    def messages(self) -> bytes:
        """Return messages of any kinds and sizes."""
        program = Program("a.c", "a", sources=("/a.c",), files={"/a.c": ""}).content()
        parts = []
        for number in range(self.random_.randrange(4)):
            content = self.random_.choice((b"", program, self.random_.randbytes(300), b"[" * 9000))
            kind = self.random_.randrange(20)
            size = self.random_.choice((None, None, 2**31, 0))
            parts.append(message(kind, content, number, size))
        return MAGIC + b"".join(parts)

    def http(self) -> bytes:
        """Return a request."""
        method = self.random_.choice(("GET", "GET", "POST", "HEAD", "OPTIONS", "X" * 300))
        rows = "".join(f"x{number}: y\r\n" for number in range(self.random_.choice((0, 3, 400))))
        path = self.random_.choice(PATHS)
        return f"{method} {path} HTTP/1.1\r\nHost: x\r\n{rows}\r\n".encode()

    def page(self) -> bytes:
        """Return the request of a page to look at the run, without a valid token."""
        offered = self.random_.choice(("crs.1", "crs.1, token.", f"crs.1, token.{'x' * 22}"))
        frame = b"\x81\x85\x01\x02\x03\x04" + self.random_.randbytes(5)
        head = (
            "GET /channel HTTP/1.1\r\nHost: x\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
            "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n"
            f"Sec-WebSocket-Protocol: {offered}\r\n\r\n"
        )
        return head.encode() + frame


def message(kind: int, content: bytes, number: int = 0, size: int | None = None) -> bytes:
    """Return a message as `crs_cc.net.channel` has it, perhaps with another size."""
    said = len(content) if size is None else size
    head = struct.pack("<IIII", kind, said, number, zlib.crc32(content))
    return head + struct.pack("<I", zlib.crc32(head)) + content


def held(process: int) -> tuple[int, int]:
    """Return the memory of a process [KB] and how many files it has open."""
    text = Path(f"/proc/{process}/status").read_text()
    size = re.search(r"VmRSS:\s+(\d+) kB", text)
    assert size
    return int(size[1]), len(list(Path(f"/proc/{process}/fd").iterdir()))


def wait_for(log: Path, pattern: str) -> re.Match[str]:
    """Return where something has been said."""
    end_s = time.monotonic() + 120.0
    while not (found := re.search(pattern, log.read_text())):
        assert time.monotonic() < end_s, log.read_text()
        time.sleep(0.1)
    return found


def fuzz(folder: Path, seconds: float, seed: int, show: Callable[[str], None]) -> None:
    """Fuzz a run; raise AssertionError where it is disturbed."""
    (folder / "world.xml").write_text(WORLD)
    (folder / "drive.c").write_text(PROGRAM)
    (folder / "tokens").write_text(TOKENS)
    log, crs = folder / "serve.log", [sys.executable, "-m", "crs_cc"]
    options = "--listen", "127.0.0.1:0", "--tokens", "tokens", "--speed", "1"
    with contextlib.ExitStack() as stack, log.open("w") as errors:
        words = [*crs, "serve", "world.xml", *options]
        environment = subprocess.Popen(words, cwd=folder, stderr=errors)
        stack.callback(environment.wait)
        stack.callback(environment.kill)
        port = int(wait_for(log, r" at 127\.0\.0\.1:(\d+)\n")[1])
        words = [*crs, "join", "--all", f"127.0.0.1:{port}", "drive.c", "--retry", "600"]
        host = subprocess.Popen([*words, "--token", TOKENS.split()[1]], cwd=folder)
        stack.callback(host.wait)
        stack.callback(host.kill)
        fuzzer = Fuzzer(port, random.Random(seed))
        wait_for(log, "view only")
        begin_s, count = time.monotonic(), 0
        before: tuple[int, int] | None = None
        while (passed_s := time.monotonic() - begin_s) < seconds:
            fuzzer.throw()
            count += 1
            if before is None and passed_s > min(WARM_S, seconds / 4):
                before = held(environment.pid)
        time.sleep(6.0)  # those who are met are given up
        after = held(environment.pid)
        assert before is not None
        said = log.read_text()
        losses = said.count("is lost")  # there may be some on a busy machine
        show(f"{count} connections, {losses} lost hosts; {fuzzer.answers}")
        show(f"KB and files held: {before}, then {after}")
        assert environment.poll() is None, said
        assert host.poll() is None, said
        for wrong in ("Traceback", "internal error"):
            assert wrong not in said, said
        assert after[0] - before[0] < MORE_KB + RUN_KBPS * seconds
        assert after[1] <= before[1] + 2


def main() -> None:
    """Fuzz for some time."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seconds", type=float, default=600.0)
    parser.add_argument("--seed", type=int, default=1)
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        fuzz(Path(folder), asked.seconds, asked.seed, print)


if __name__ == "__main__":
    main()
