"""The options of `crs serve` and `crs join`, as data."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from crs_cc.cli.program_options import ProgramOptions
from crs_cc.cli.run_options import RunOptions


@dataclass(frozen=True, slots=True)
class ServeOptions(RunOptions):
    """Options of `crs serve`; its programs are those of the hosts.

    Attributes:
        listen: the host and port to listen at.
        tokens: the file of tokens; None for new ones.
        tls: whether to encrypt with a certificate made at start.
        tls_cert, tls_key: the files of a certificate and its key to encrypt with instead.
        insecure: whether to listen to other machines without TLS.
        only_tcp: whether hosts of this machine stay on the port, too.
        start: when to begin: when `all` robots have their programs, or `now`, with the first.
        on_loss: what to do when a host is lost: `wait` for another one, `stop` its programs, or
            `restart` them here.
        resume: the recording at whose end the run continues; None for a new run.
        hosts: the address of the Dask cluster whose workers run the programs; empty for hosts that
            users start.
        per_host: how many robots a host on the cluster has; None for a host on each thread.
    """

    listen: tuple[str, int] = ("127.0.0.1", 8000)
    tokens: Path | None = None
    tls: bool = False
    tls_cert: Path | None = None
    tls_key: Path | None = None
    insecure: bool = False
    only_tcp: bool = False
    start: Literal["all", "now"] = "all"
    on_loss: Literal["wait", "stop", "restart"] = "wait"
    resume: Path | None = None
    hosts: str = ""
    per_host: int | None = None


@dataclass(frozen=True, slots=True)
class JoinOptions(ProgramOptions):
    """Options of `crs join`.

    Attributes:
        address: the host and port of the environment.
        robots: the robots; empty for all that have no program.
        token: shows that we may join; None for the user's own.
        tls: whether to encrypt, and expect a certificate that the system trusts.
        fingerprint: that of the certificate to expect instead; empty for none.
        definition: the robot definition that the robots must have; empty for any.
        threads: how many threads may run programs; None for as many as there are processors.
        retry_s: how long to try to reach the environment [s].
    """

    address: tuple[str, int] = ("127.0.0.1", 8000)
    robots: tuple[str, ...] = ()
    token: str | None = None
    tls: bool = False
    fingerprint: str = ""
    definition: str = ""
    threads: int | None = None
    retry_s: float = 10.0
