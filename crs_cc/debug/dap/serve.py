"""The entry point: sessions on standard streams, or on a port of the loopback interface."""

from __future__ import annotations

import contextlib
import io
import os
import socket
import sys
import threading
from collections.abc import Callable
from functools import partial
from queue import SimpleQueue
from typing import Any, BinaryIO, Final

from crs_cc.debug.dap.arguments import MAX_INTEGER, Arguments, RefusalError
from crs_cc.debug.dap.connection import NOBODY, ClientGoneError, Connection
from crs_cc.debug.dap.framing import BadMessageError, BrokenStreamError, Message, read_message
from crs_cc.debug.dap.inbox import ClientRequest, Inbox
from crs_cc.debug.dap.request_table import HANDLERS
from crs_cc.debug.dap.server import Server, explain
from crs_cc.debug.dap.session import EditorSession, OpenRun

_STACK_BYTES: Final = 64 * 2**20
"""Of the thread in which programs run; they may use 6 MiB of it, see `runtime.executable`. It is
taken as it is used."""

_READ_BYTES: Final = 65536


def serve_stdio(open_run: OpenRun) -> None:
    """Serve the editor that has started this process, until it ends the session.

    Args:
        open_run: makes a debugger from a command line of `crs debug`.
    """
    sys.stdout.flush()
    source = _StandardInput()
    with (
        contextlib.suppress(ConnectionError),  # unwritten output has no reader
        os.fdopen(os.dup(1), "wb") as sink,
    ):
        os.dup2(2, 1)  # other output must not mix with messages
        serve(io.BufferedReader(source), sink, open_run, source.end)


class _StandardInput(io.RawIOBase):
    """Standard input that another thread can end.

    A thread of its own reads it; it may never return from that, and ends with the process.
    """

    def __init__(self) -> None:
        self._read: SimpleQueue[bytes] = SimpleQueue()
        self._rest = b""
        threading.Thread(target=self._work, name="standard input", daemon=True).start()

    def _work(self) -> None:
        content = b"more"
        while content:
            content = _read_some()
            self._read.put(content)

    def readable(self) -> bool:
        """Return True: it can be read."""
        return True

    def readinto(self, room: Any, /) -> int:
        """Wait for bytes; return how many were read, 0 at the end."""
        content = self._rest or self._read.get()
        view = memoryview(room)
        count = min(len(view), len(content))
        view[:count], self._rest = content[:count], content[count:]
        return count

    def end(self) -> None:
        """End the stream, for a blocked reader, too."""
        self._read.put(b"")


def _read_some() -> bytes:
    try:
        return os.read(0, _READ_BYTES)
    except OSError:  # it is closed
        return b""


def serve_port(port: int, open_run: OpenRun, announce: Callable[[str], None]) -> None:
    """Serve editors, one after the other, on a port of the loopback interface until interrupted.

    Args:
        port: its number; 0 for any that is free.
        open_run: makes a debugger from a command line of `crs debug`.
        announce: receives the address to connect to.

    Raises:
        OSError: the port is in use.
    """
    folder = os.getcwd()  # noqa: PTH109
    with socket.create_server(("127.0.0.1", port)) as listener:
        announce(f"waiting for an editor on 127.0.0.1:{listener.getsockname()[1]}")
        while True:
            client, _ = listener.accept()
            with (
                contextlib.suppress(ConnectionError),
                client,
                client.makefile("rb") as source,
                client.makefile("wb") as sink,
            ):
                serve(source, sink, open_run, partial(_hang_up, client))
            os.chdir(folder)


def _hang_up(client: socket.socket) -> None:
    with contextlib.suppress(OSError):  # the client was first
        client.shutdown(socket.SHUT_RDWR)


def serve(
    source: BinaryIO,
    sink: BinaryIO,
    open_run: OpenRun,
    hang_up: Callable[[], None] = lambda: None,
) -> None:
    """Serve one session.

    Args:
        source: the stream from the client.
        sink: the stream to the client.
        open_run: makes a debugger from a command line of `crs debug`.
        hang_up: ends a blocking read from the client.
    """
    connection, inbox = Connection(sink), Inbox()
    session = EditorSession(connection, inbox, open_run)

    def work() -> None:
        try:
            Server(session, inbox, HANDLERS).serve()
        except ClientGoneError:
            pass  # then nobody is left to tell
        except Exception as error:
            sys.stderr.write(f"crs: {explain(error)}\n")
        finally:
            session.over = True
            hang_up()

    size = threading.stack_size(_STACK_BYTES)
    worker = threading.Thread(target=work, name="engine")
    worker.start()
    threading.stack_size(size)
    try:
        with contextlib.suppress(ClientGoneError):
            _read(source, connection, inbox, session)
    finally:
        inbox.close()
        worker.join()


def _read(source: BinaryIO, connection: Connection, inbox: Inbox, session: EditorSession) -> None:
    """Put the client's requests into the inbox, up to the end of the stream.

    Raises:
        ClientGoneError: the client has closed the connection.
    """
    while not session.over:
        try:
            message = read_message(source)
            if message is None:
                return
            request = _request(message)
        except BadMessageError as error:
            connection.refuse(NOBODY, str(error))
            continue
        except (BrokenStreamError, ConnectionError) as error:
            connection.refuse(NOBODY, str(error))
            return
        if request is not None:
            _sort(request, connection, inbox)
            if request.command == "disconnect":
                return


def _request(message: Message) -> ClientRequest | None:
    """Return the request in a message; None for a response.

    Raises:
        BadMessageError: it is neither.
    """
    seq, command = message.get("seq"), message.get("command")
    if message.get("type") == "response":
        return None
    if message.get("type") != "request" or not isinstance(command, str):
        raise BadMessageError("a message is not a request")
    if not isinstance(seq, int) or isinstance(seq, bool) or abs(seq) > MAX_INTEGER:
        raise BadMessageError("a request has no 'seq'")
    arguments = message.get("arguments")
    return ClientRequest(seq, command, {} if arguments is None else arguments)


def _sort(request: ClientRequest, connection: Connection, inbox: Inbox) -> None:
    """Queue a request; answer a cancellation at once."""
    try:
        if request.command != "cancel":
            inbox.put(request)
            return
        withdrawn = inbox.withdraw(Arguments.of(request.arguments).integer("requestId", 0))
    except RefusalError as error:
        connection.refuse(request, str(error), error.word)
        return
    if withdrawn is not None:
        connection.refuse(withdrawn, "withdrawn", "cancelled")
    connection.respond(request)
