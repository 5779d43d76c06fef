"""The server of the page: files over HTTP and the channel as a WebSocket, on loopback only.

It runs in its own thread, so that slow pages do not delay the run. Its methods may be
called by any thread.

Who may connect: the address must name this machine (`Host`), a page must be one of ours (`Origin`),
and the channel needs one of two tokens: with that for viewing, commands that change the run are
rejected. Other users of this machine are rejected if the system reports the owner of a connection.
The files contain no secrets: they are the same on every machine.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import logging
import threading
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from http import HTTPStatus
from typing import TYPE_CHECKING, Any, Final, Protocol

from websockets.asyncio.server import ServerConnection, serve
from websockets.datastructures import Headers
from websockets.exceptions import ConnectionClosed
from websockets.frames import Frame, Opcode
from websockets.http11 import Request, Response
from websockets.protocol import OPEN

from crs_cc.core.arrays import FloatArray
from crs_cc.core.host_system import is_of_another_user
from crs_cc.core.loopback import LOOPBACK, is_own_host, is_own_origin, is_token, new_token
from crs_cc.recording.frames import difference, quantized
from crs_cc.workbench.clients import Client, LiveFrame, Role
from crs_cc.workbench.messages import MAX_BYTES, PROTOCOL, frame_message
from crs_cc.workbench.static_files import POLICY, file_at

if TYPE_CHECKING:
    from websockets.typing import Subprotocol

CHANNEL: Final = "/channel"
MAX_CLIENTS: Final = 100
_ONCE: Final = ("Host", "Origin", "Sec-WebSocket-Protocol")
"""The headers that are read; a request with a duplicate is rejected as ambiguous."""

_TOO_FAST, _TOO_SLOW, _GOING = 1008, 1013, 1001  # RFC 6455 7.4.1, and IANA's registry
_STOP_S: Final = 5.0


class Receiver(Protocol):
    """What the pages talk to; its methods are called in the server's thread."""

    def greet(self, client: Client) -> None:
        """Send a page that has connected all that it must know."""

    def receive(self, client: Client, command: dict[str, Any]) -> None:
        """Execute or forward a page's request."""


@dataclass(frozen=True, slots=True)
class Front:
    """A front end of a server: connections come through it, possibly from other machines.

    Attributes:
        address: its address, as `http://procyon:8000`.
        port: its port.
        tokens: the tokens of each role, at least one each.
        open: is given the port on this machine at which the server takes connections.
    """

    address: str
    port: int
    tokens: Mapping[Role, Sequence[str]]
    open: Callable[[int], None]


class Server:
    """Serves pages until it is closed.

    Attributes:
        port: the port that it listens on.
        tokens: the token of each role.
        sent: how many messages have been sent to all pages.
    """

    def __init__(
        self, receiver: Receiver, port: int = 0, page: str = "/", front: Front | None = None
    ) -> None:
        """Listen on a port, 0 for any that is free.

        Args:
            receiver: what the pages talk to.
            port: the port.
            page: the path of the page.
            front: the server in front of it; by default pages connect directly.

        Raises:
            OSError: the port is in use.
        """
        self.port = port
        self._front = front
        self._accepted: Mapping[Role, Sequence[str]] = {
            "control": (new_token(),),
            "view": (new_token(),),
        }
        if front is not None:
            self._accepted = front.tokens
        self.tokens: dict[Role, str] = {role: each[0] for role, each in self._accepted.items()}
        self.sent = 0
        self._receiver = receiver
        self._page = page
        self._clients: dict[Client, ServerConnection] = {}
        self._loop = asyncio.new_event_loop()
        self._closing = asyncio.Event()
        self._ready = threading.Event()
        self._error: OSError | None = None
        self._last: LiveFrame | None = None
        self._thread = threading.Thread(target=self._run, name="workbench", daemon=True)
        self._thread.start()
        self._ready.wait()
        if self._error is not None:
            raise self._error
        if front is not None:
            front.open(self.port)
            self.port = front.port

    def address(self, role: Role = "control") -> str:
        """Return the address of the page, with the token of a role."""
        base = f"http://{LOOPBACK}:{self.port}" if self._front is None else self._front.address
        return f"{base}{self._page}#token={self.tokens[role]}"

    @property
    def page_count(self) -> int:
        """The number of pages that are connected."""
        return len(self._clients)

    # -- sending ---------------------------------------------------------------------------------

    def send(self, client: Client, message: str | bytes) -> None:
        """Send a message to a page."""
        self.call_soon(lambda: client.put(message))

    def broadcast(self, message: str) -> None:
        """Send a message to all pages, except those whose first message contains it already."""
        self.sent += 1
        number = self.sent

        def put() -> None:
            content = encode_frame(message)
            for client in self._clients:
                if number > client.since and not self._write(client, content):
                    client.put(message)

        self.call_soon(put)

    def broadcast_latest(self, kind: str, message: str) -> None:
        """Send a message to all pages, in place of one of its kind that still waits."""

        def put() -> None:
            content = encode_frame(message)
            for client in self._clients:
                if not self._write(client, content):
                    client.put_latest(kind, message)

        self.call_soon(put)

    def broadcast_frame(self, time_s: float, values: FloatArray) -> None:
        """Send a frame to all pages, in place of one that still waits."""
        if not self._clients:
            return
        before, change, whole = self._last, None, quantized(values)
        if before is not None and before.whole.shape == whole.shape:
            change = frame_message(time_s, difference(before.whole, whole))
        number = 0 if before is None else before.number + 1
        frame = self._last = LiveFrame(number, time_s, values, whole, change)

        def put() -> None:
            content = b"" if frame.change is None else encode_frame(frame.change)
            for client in self._clients:
                if content and client.frame_number == number - 1 and self._write(client, content):
                    client.frame_number = number
                else:
                    client.put_latest("frame", frame)

        self.call_soon(put)

    def _write(self, client: Client, content: bytes) -> bool:
        """Write to a page for which nothing waits; return whether that was so.

        A task and a framing of its own for each page would take three times as long.
        """
        connection = self._clients[client]
        if (
            not client.is_idle
            or connection.protocol.state is not OPEN
            or connection.transport.get_write_buffer_size()
        ):
            return False
        connection.transport.write(content)
        return True

    def close(self) -> None:
        """Close the connections of all pages, and stop."""
        self.call_soon(self._closing.set)
        self._thread.join(_STOP_S)

    def call_soon(self, action: Callable[[], None]) -> None:
        """Call a function in the server's thread, unless that has ended."""
        with contextlib.suppress(RuntimeError):  # the loop has ended
            self._loop.call_soon_threadsafe(action)

    # -- the thread ------------------------------------------------------------------------------

    def _run(self) -> None:
        try:
            # Which also ends what the server has begun for pages that come just then.
            with asyncio.Runner(loop_factory=lambda: self._loop) as runner:
                runner.run(self._serve())
        except OSError as error:
            self._error = error
        finally:
            self._ready.set()

    async def _serve(self) -> None:
        quiet = logging.getLogger("crs_cc.workbench.silent")
        quiet.addHandler(logging.NullHandler())
        quiet.propagate = False
        async with serve(
            self._handle_page,
            LOOPBACK,
            self.port,
            process_request=self._process_request,
            select_subprotocol=_select_subprotocol,
            compression=None,  # frames hold little that could be left out
            max_size=MAX_BYTES,
            max_queue=16,
            server_header=None,
            close_timeout=1.0,
            logger=quiet,
        ) as server:
            self.port = next(iter(server.sockets)).getsockname()[1]
            self._ready.set()
            await self._closing.wait()
            server.close(code=_GOING, reason="the run has ended")
            await server.wait_closed()

    def _process_request(self, connection: ServerConnection, request: Request) -> Response | None:
        """Return the answer to a request; None to open the channel."""
        if any(len(request.headers.get_all(name)) > 1 for name in _ONCE):
            return _response(HTTPStatus.BAD_REQUEST, b"a header is given twice\n")
        host = request.headers.get("Host", "")
        if self._front is None and not is_own_host(host, self.port):
            return _response(HTTPStatus.FORBIDDEN, b"not the name of this machine\n")
        path = request.path.partition("?")[0]
        if path != CHANNEL:
            file = file_at(path)
            if file is None:
                return _response(HTTPStatus.NOT_FOUND, b"no such file\n")
            return _response(HTTPStatus.OK, file.content, file.type)
        origin = request.headers.get("Origin")
        if origin is not None and not self._is_same_origin(origin, host):
            return _response(HTTPStatus.FORBIDDEN, b"not a page of this server\n")
        peer = connection.transport.get_extra_info("socket")
        if self._front is None and is_of_another_user(peer):
            return _response(HTTPStatus.FORBIDDEN, b"this run belongs to another user\n")
        if self._role(request) is None:
            text = b"no valid token: open the address that crs has printed\n"
            return _response(HTTPStatus.UNAUTHORIZED, text)
        if len(self._clients) >= MAX_CLIENTS:
            return _response(HTTPStatus.SERVICE_UNAVAILABLE, b"too many pages are connected\n")
        return None

    def _is_same_origin(self, origin: str, host: str) -> bool:
        """Return whether a page comes from this server: behind a front, from the requested host."""
        if self._front is None:
            return is_own_origin(origin, self.port)
        return origin.partition("://")[2] == host

    def _role(self, request: Request | None) -> Role | None:
        offered = "" if request is None else request.headers.get("Sec-WebSocket-Protocol", "")
        for word in offered.split(","):
            given = word.strip().removeprefix("token.")
            for role, tokens in self._accepted.items():
                if any(is_token(given, token) for token in tokens):
                    return role
        return None

    async def _handle_page(self, connection: ServerConnection) -> None:
        role = self._role(connection.request)
        assert role is not None  # or else it was refused
        client = Client(role)
        self._clients[client] = connection
        sender = asyncio.create_task(_send(client, connection))
        try:
            self._receiver.greet(client)
            if self._last is not None:
                client.put_latest("frame", self._last)
            async for text in connection:
                command = _parse_command(text)
                if command is None or not client.may_send():
                    await connection.close(_TOO_FAST, "too many commands, or none")
                    break
                self._receiver.receive(client, command)
        except ConnectionClosed:
            pass
        finally:
            del self._clients[client]
            sender.cancel()


async def _send(client: Client, connection: ServerConnection) -> None:
    """Send what waits for a page, as fast as it can take it."""
    with contextlib.suppress(ConnectionClosed):
        while not client.is_lost:
            message = client.next_message()
            if message is None:
                await client.wake.wait()
            else:
                client.is_sending = True
                await connection.send(message)
                client.is_sending = False
        await connection.close(_TOO_SLOW, "this page is too slow")


def encode_frame(message: str | bytes) -> bytes:
    r"""Return a message in a frame of a server, which is the same for all pages (RFC 6455 5.1).

    >>> encode_frame("pose")
    b'\x81\x04pose'
    """
    if isinstance(message, str):
        return Frame(Opcode.TEXT, message.encode()).serialize(mask=False)
    return Frame(Opcode.BINARY, message).serialize(mask=False)


def _parse_command(text: str | bytes) -> dict[str, Any] | None:
    """Return the command in a message; None if there is none."""
    try:
        command = json.loads(text)
    except (ValueError, RecursionError):
        return None
    if not isinstance(command, dict) or not isinstance(command.get("id"), int):
        return None
    return command if isinstance(command.get("command"), str) else None


def _select_subprotocol(_connection: ServerConnection, offered: Any) -> Subprotocol | None:
    return next((each for each in offered if each == PROTOCOL), None)


def _response(status: HTTPStatus, content: bytes, kind: str = "text/plain") -> Response:
    headers = Headers(
        {
            "Content-Type": f"{kind}; charset=utf-8",
            "Content-Length": str(len(content)),
            "Content-Security-Policy": POLICY,
            "X-Content-Type-Options": "nosniff",
            "Referrer-Policy": "no-referrer",
            "Cross-Origin-Resource-Policy": "same-origin",
            "Cache-Control": "no-store",
            "Connection": "close",
        }
    )
    return Response(status.value, status.phrase, headers, content)
