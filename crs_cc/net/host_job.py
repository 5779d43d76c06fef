"""A process on a machine of a cluster that runs robots' programs, see `jobs.worker`.

It does what `crs join` does, with a program that the environment has compiled. Standard input and
output are those of the environment. It ends when the connection is lost, and is then restarted.
"""

from __future__ import annotations

import pickle
import socket
import zlib
from base64 import b64decode, b64encode
from collections.abc import Callable
from dataclasses import asdict, dataclass
from typing import Any, Final, Self

from crs_cc.jobs.worker import serve
from crs_cc.net.channel import ConnectionLostError, KeepAlive
from crs_cc.net.environment_connection import EnvironmentConnection, connect
from crs_cc.net.handshake import Hello, Program, RefusedError, as_text, devices_digest, digest_of
from crs_cc.net.program_host import ProgramHost, Streams
from crs_cc.net.tls import Client, Connection
from crs_cc.runtime.executable import Executable
from crs_cc.session.build import build_driver
from crs_cc.session.host import discard, no_input

_SILENT: Final = Streams(discard, no_input, lambda _robot, _clock_s: (0, 0.0))
_FAST: Final = 1  # zlib's level


@dataclass(frozen=True, slots=True)
class HostJob:
    """The programs that a host runs, and the environment that it runs them for.

    Attributes:
        host: the environment's host or address.
        port: its port.
        token: shows that the host may run programs.
        fingerprint: of the environment's certificate; empty without TLS.
        name: the name of this host, which it keeps when it is started again.
        robots: the robots whose programs it runs.
        executable: the program, see `packed`.
    """

    host: str
    port: int
    token: str
    fingerprint: str
    name: str
    robots: tuple[str, ...]
    executable: str

    def data(self) -> dict[str, Any]:
        """Return it as plain data."""
        return asdict(self)

    @classmethod
    def of(cls, data: dict[str, Any]) -> Self:
        """Return it from plain data that comes from the environment."""
        return cls(**{**data, "robots": tuple(data["robots"])})


def packed(executable: Executable) -> str:
    """Return a program as text: a pickle, which is trusted where it is unpacked."""
    return b64encode(zlib.compress(pickle.dumps(executable), _FAST)).decode()


def _unpacked(text: str) -> Executable:
    found: Executable = pickle.loads(zlib.decompress(b64decode(text)))  # noqa: S301 - see `packed`
    return found


def announced(executable: Executable) -> Program:
    """Return a host's message for a program that the environment itself has compiled."""
    code = digest_of(executable.machine_code)
    return Program(
        executable.name,
        executable.command,
        sources=("/machine-code",),
        files={"/machine-code": as_text(code.encode())},
    )


def _work(data: dict[str, Any], prepared: Callable[[], None]) -> dict[str, Any]:
    """Run programs until the run ends; return the reason if they end earlier."""
    job = HostJob.of(data)
    executable = _unpacked(job.executable)
    prepared()
    with KeepAlive() as keep_alive:
        try:
            found = _connect(job, executable, keep_alive)
        except RefusedError as error:
            return {"refused": str(error)}
        except ConnectionLostError as error:
            return {"unreached": str(error)}
        try:
            executables = [executable] * len(found.robots)
            ProgramHost(executables, build_driver(), _SILENT, threads=1).serve(found.channel)
        except ConnectionLostError as error:
            return {"lost": str(error)}
        finally:
            found.channel.close()
    return {}


def _connect(job: HostJob, executable: Executable, keep_alive: KeepAlive) -> EnvironmentConnection:
    program = announced(executable)
    devices = devices_digest()
    hello = Hello(job.token, job.name, job.robots, program.digest, devices=devices)
    address = job.host, job.port
    return connect(address, hello, program.content(), keep_alive, _secure(job))


def _secure(job: HostJob) -> Callable[[socket.socket], Connection]:
    if not job.fingerprint:
        return lambda connection: connection
    return Client(job.host, job.fingerprint).secure


if __name__ == "__main__":
    serve(_work)
