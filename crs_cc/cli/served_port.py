"""The port of `crs serve`, for hosts and pages: access control and encryption."""

from __future__ import annotations

import contextlib
import errno
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import click

from crs_cc.cli.messages import say
from crs_cc.cli.net_address import publish_token, shown_address
from crs_cc.cli.view_address import announced
from crs_cc.core.loopback import LOOPBACK
from crs_cc.net import tls
from crs_cc.net.access import Access, parsed
from crs_cc.net.listener import Listener, bound_socket, forwarder_to
from crs_cc.workbench.clients import Role as PageRole
from crs_cc.workbench.server import Front

if TYPE_CHECKING:
    from crs_cc.cli.serve_options import ServeOptions
    from crs_cc.net.host_registry import HostRegistry

_OWN_NAMES = ("127.0.0.1", "::1", "localhost")
ANY_NAME = ("0.0.0.0", "::")  # noqa: S104 - to listen at, not to connect to


@dataclass(frozen=True, slots=True)
class ServedPort:
    """An open port.

    Attributes:
        number: of the port.
        access: the tokens of each role.
        front: where pages connect; None for nowhere.
        fingerprint: of the certificate; empty without TLS.
    """

    number: int
    access: Access
    front: Front | None
    fingerprint: str


@contextlib.contextmanager
def served_port(options: ServeOptions, registry: HostRegistry) -> Iterator[ServedPort]:
    """Open the port of an environment inside a `with` block.

    Args:
        options: how.
        registry: the assignment of robots to hosts.

    Raises:
        click.UsageError: the options do not go together.
        OSError: the port is in use.
    """
    access, secure = _access(options.tokens), _tls(options)
    with (
        _listening(options, access, registry, secure) as listener,
        _front(options, access, listener, is_secure=secure is not None) as front,
    ):
        fingerprint = "" if secure is None else secure.fingerprint
        yield ServedPort(listener.port, access, front, fingerprint)


def greet(options: ServeOptions, port: ServedPort) -> None:
    """Print the address at which the world is served."""
    host = options.listen[0]
    say(f"crs: serving {options.inputs.world} at {shown_address((host, port.number))}")
    if port.fingerprint:
        say(f"crs: fingerprint of the certificate: {port.fingerprint}")
    elif not is_own_name(host):
        say("crs: warning: INSECURE: anyone on the network can read tokens and programs")


def is_own_name(host: str) -> bool:
    """Return whether only programs of this machine reach an address."""
    return host in _OWN_NAMES


def _access(file: Path | None) -> Access:
    if file is None:
        return Access.made()
    try:
        return parsed(file.read_text("utf-8"))
    except ValueError as error:
        raise click.UsageError(f"--tokens: {file}:{error}.") from None


@contextlib.contextmanager
def _listening(
    options: ServeOptions, access: Access, registry: HostRegistry, secure: tls.Server | None
) -> Iterator[Listener]:
    host, port = options.listen
    if not (is_own_name(host) or secure or options.insecure):
        text = f"--listen {host} is open to other machines, which could read tokens and programs"
        raise click.UsageError(f"{text}: --tls, or --insecure if the network is yours alone.")
    try:
        server_socket = bound_socket(host, port)
    except OSError as error:
        reason = error.strerror or str(error)
        if error.errno == errno.EADDRINUSE:
            reason += " (name another port by --listen HOST:PORT)"
        raise OSError(error.errno, reason, shown_address((host, port))) from None
    with publish_token(server_socket.getsockname()[1], access.token("robot")):
        encrypt = secure.secure if secure else lambda plain: plain
        listener = Listener(server_socket, access, registry, encrypt, only_tcp=options.only_tcp)
        try:
            yield listener
        finally:
            listener.close()


def _tls(options: ServeOptions) -> tls.Server | None:
    """Return the TLS server, if encryption is requested."""
    if options.tls_cert is None and options.tls_key is None:
        return tls.self_made() if options.tls else None
    if options.tls_cert is None or options.tls_key is None:
        raise click.UsageError("--tls-cert and --tls-key must be given together.")
    try:
        return tls.Server(options.tls_cert, options.tls_key)
    except ValueError:
        raise click.UsageError(f"--tls-cert: {options.tls_cert} has no certificate.") from None


@contextlib.contextmanager
def _front(
    options: ServeOptions, access: Access, listener: Listener, *, is_secure: bool
) -> Iterator[Front | None]:
    """Yield where pages connect, if they may; `crs view` finds it on this machine."""
    if options.view is None:
        yield None
        return
    tokens: dict[PageRole, tuple[str, ...]] = {
        "control": access.tokens["control"],
        "view": access.tokens["view"],
    }

    def open_to_pages(port: int) -> None:
        listener.page_handler = forwarder_to(port)

    host = options.listen[0]
    address = shown_address((LOOPBACK if host in ANY_NAME else host, listener.port))
    place = f"{'https' if is_secure else 'http'}://{address}"
    with announced(listener.port, f"{place}/#token={access.token('control')}"):
        yield Front(place, listener.port, tokens, open_to_pages)
