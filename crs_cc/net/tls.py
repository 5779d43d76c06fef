"""Encrypted connections: certificates, and sockets that two threads may use.

A self-signed certificate proves nothing by itself, but its fingerprint does if it was transferred
separately: `crs serve` prints it, and `crs join --fingerprint` checks it.
"""

from __future__ import annotations

import hashlib
import hmac
import selectors
import socket
import ssl
import subprocess
import tempfile
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Final, TypeAlias, TypeVar

_DAYS: Final = 365
_MAKING_S: Final = 30.0
_COMMAND: Final = (
    *("openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1"),
    *("-nodes", "-days", str(_DAYS), "-subj", "/CN=crs"),
)


Subject = TypeVar("Subject")
Result = TypeVar("Result")


class TlsSocket:
    """A socket for one thread that sends while another one receives.

    Only one thread at a time may use an OpenSSL connection, so no thread waits while it does.
    """

    def __init__(self, inner: ssl.SSLSocket) -> None:
        """Store a connection after its handshake."""
        self._inner = inner
        self._turn = threading.Lock()
        self._timeout_s = inner.gettimeout()
        inner.setblocking(False)

    def fileno(self) -> int:
        """Return the descriptor, to wait for it."""
        return self._inner.fileno()

    def settimeout(self, timeout_s: float | None) -> None:
        """Set how long to wait [s]; None for ever."""
        self._timeout_s = timeout_s

    def setsockopt(self, level: int, option: int, value: int) -> None:
        """Set an option of the socket below."""
        self._inner.setsockopt(level, option, value)

    def recv(self, size: int, flags: int = 0) -> bytes:
        """Receive data; with flags, from the socket below."""
        if flags:
            return socket.socket.recv(self._inner, size, flags)
        return self._done(self._inner.recv, size)

    def recv_into(self, buffer: memoryview) -> int:
        """Receive data into a buffer; return its size."""
        return self._done(self._inner.recv_into, buffer)

    def send(self, data: bytes | memoryview) -> int:
        """Send some of the data; return its size."""
        return self._done(self._inner.send, data)

    def _done(self, action: Callable[[Subject], Result], subject: Subject) -> Result:
        """Perform an action, waiting whenever it would block; return its result."""
        while True:
            try:
                with self._turn:
                    return action(subject)
            except ssl.SSLWantReadError:
                self._wait(selectors.EVENT_READ)
            except ssl.SSLWantWriteError:
                self._wait(selectors.EVENT_WRITE)

    def sendall(self, data: bytes) -> None:
        """Send data."""
        rest = memoryview(data)
        while rest:
            rest = rest[self.send(rest) :]

    def shutdown(self, how: int) -> None:
        """Shut the socket below down."""
        socket.socket.shutdown(self._inner, how)

    def close(self) -> None:
        """Close it."""
        self._inner.close()

    def _wait(self, event: int) -> None:
        with selectors.DefaultSelector() as selector:
            selector.register(self._inner, event)
            if not selector.select(self._timeout_s):
                raise TimeoutError("timed out")


Connection: TypeAlias = socket.socket | TlsSocket
"""A connection, encrypted or not."""


class Server:
    """The environment's side.

    Attributes:
        fingerprint: the SHA-256 of its certificate, as hexadecimal digits.
    """

    def __init__(self, certificate: Path, key: Path) -> None:
        """Load a certificate and its key, as PEM.

        Raises:
            OSError: they cannot be read, or do not belong together.
        """
        self._context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
        self._context.minimum_version = ssl.TLSVersion.TLSv1_3
        self._context.load_cert_chain(certificate, key)
        text = certificate.read_text("ascii", "replace")
        begin = text.index("-----BEGIN CERTIFICATE")
        end = text.index("-----END CERTIFICATE-----") + len("-----END CERTIFICATE-----")
        self.fingerprint = _fingerprint(ssl.PEM_cert_to_DER_cert(text[begin:end] + "\n"))

    def secure(self, connection: socket.socket) -> Connection:
        """Encrypt an accepted connection; raise OSError if the handshake fails."""
        return TlsSocket(self._context.wrap_socket(connection, server_side=True))


def self_made() -> Server:
    """Return a server with a new certificate, which the command `openssl` makes.

    Raises:
        OSError: there is no such command, or it fails.
    """
    with tempfile.TemporaryDirectory(prefix="crs-tls-") as folder:
        key, certificate = Path(folder, "key.pem"), Path(folder, "certificate.pem")
        command = [*_COMMAND, "-keyout", str(key), "-out", str(certificate)]
        try:
            subprocess.run(command, check=True, capture_output=True, timeout=_MAKING_S)  # noqa: S603
        except (OSError, subprocess.SubprocessError) as error:
            text = "openssl cannot make a certificate; give one by --tls-cert and --tls-key"
            raise OSError(f"{text}: {error}") from None
        return Server(certificate, key)


class Client:
    """A host's side."""

    def __init__(self, name: str, fingerprint: str = "") -> None:
        """Set which certificate is accepted.

        Args:
            name: the host name for which it must be valid, if the system trusts it.
            fingerprint: its SHA-256, which is checked instead.
        """
        self._name, self._expected = name, fingerprint.replace(":", "").lower()
        self._context = ssl.create_default_context()
        self._context.minimum_version = ssl.TLSVersion.TLSv1_3
        if fingerprint:
            self._context.check_hostname = False
            self._context.verify_mode = ssl.CERT_NONE

    def secure(self, connection: socket.socket) -> Connection:
        """Encrypt a connection.

        Raises:
            UntrustedError: the certificate is not accepted.
            OSError: the handshake fails.
        """
        try:
            inner = self._context.wrap_socket(connection, server_hostname=self._name)
        except ssl.SSLCertVerificationError as error:
            text = f"its certificate is not trusted ({error.verify_message})"
            raise UntrustedError(
                f"{text}: give --fingerprint, which crs serve has printed"
            ) from None
        except ssl.SSLError as error:
            text = f"it does not encrypt as TLS does ({error.reason or error})"
            raise OSError(f"{text}: is it served without --tls?") from None
        found = _fingerprint(inner.getpeercert(binary_form=True) or b"")
        if self._expected and not hmac.compare_digest(found.encode(), self._expected.encode()):
            inner.close()
            raise UntrustedError(f"its certificate has the fingerprint {found}, not the given one")
        return TlsSocket(inner)


def fingerprint_at(address: tuple[str, int], timeout_s: float) -> str:
    """Return the fingerprint of the certificate of a server, which is not checked.

    Args:
        address: its host and port.
        timeout_s: timeout [s].

    Returns:
        The SHA-256 as hexadecimal digits; an empty string if connections are not encrypted.

    Raises:
        OSError: there is no server.
    """
    context = ssl.create_default_context()
    context.check_hostname = False
    context.verify_mode = ssl.CERT_NONE
    with socket.create_connection(address, timeout_s) as connection:
        try:
            with context.wrap_socket(connection, server_hostname=address[0]) as inner:
                return _fingerprint(inner.getpeercert(binary_form=True) or b"")
        except OSError:
            return ""


class UntrustedError(Exception):
    """The environment's certificate is not accepted."""


def _fingerprint(certificate: bytes) -> str:
    return hashlib.sha256(certificate).hexdigest()
