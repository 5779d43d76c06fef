"""Sessions: one thread reads the requests, another answers them; `port` serves many of them."""

from __future__ import annotations

import contextlib
import io
import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from functools import partial
from queue import SimpleQueue
from typing import Any, BinaryIO, Final

from crs_cc.debug.dap.arguments import MAX_INTEGER, Arguments, RefusalError
from crs_cc.debug.dap.connection import NOBODY, ClientDisconnectedError, Connection
from crs_cc.debug.dap.framing import BadMessageError, BrokenStreamError, Message, read_message
from crs_cc.debug.dap.inbox import ClientRequest, Inbox
from crs_cc.debug.dap.request_table import HANDLERS
from crs_cc.debug.dap.server import Server, explain
from crs_cc.debug.dap.session import EditorSession, OpenRun

_STACK_BYTES: Final = 64 * 2**20
"""Of the thread in which programs run; they may use 6 MiB of it, see `runtime.executable`. It is
taken as it is used."""

_READ_BYTES: Final = 65536

_starting: Final = threading.Lock()
"""Held while a thread is started with a stack of its own size: that is the process's setting."""


def serve_stdio(open_run: OpenRun) -> None:
    """Serve the editor that has started this process, until it ends the session.

    Args:
        open_run: makes a debugger from a command line of `crs debug`.
    """
    sys.stdout.flush()
    source = _StandardInput()
    # some editors, such as Neovim, send it when they have closed the stream: no reason to fail
    signal.signal(signal.SIGINT, lambda *_: source.end())
    with (
        contextlib.suppress(ConnectionError),  # unwritten output has no reader
        os.fdopen(os.dup(1), "wb") as sink,
    ):
        os.dup2(2, 1)  # other output must not mix with messages
        receive = partial(read_message, io.BufferedReader(source))
        serve(receive, sink, open_run, source.end)


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


def serve(
    receive: Callable[[], Message | None],
    sink: BinaryIO,
    open_run: OpenRun,
    hang_up: Callable[[], None] = lambda: None,
    *,
    admit: Callable[[ClientRequest], ClientRequest] = lambda request: request,
    folder: str | None = None,
) -> None:
    """Serve one session.

    Args:
        receive: returns the client's next message, like `read_message`.
        sink: the stream to the client.
        open_run: makes a debugger from a command line of `crs debug`.
        hang_up: ends a blocking read from the client.
        admit: returns the request that is answered; a `RefusalError` ends the session.
        folder: what relative paths start from; by default the current directory.
    """
    connection, inbox = Connection(sink), Inbox()
    session = EditorSession(connection, inbox, open_run, folder)

    def work() -> None:
        try:
            Server(session, inbox, HANDLERS).serve()
        except ClientDisconnectedError:
            pass  # the client is gone
        except Exception as error:
            sys.stderr.write(f"crs: {explain(error)}\n")
        finally:
            session.over = True
            hang_up()

    with _starting:
        size = threading.stack_size(_STACK_BYTES)
        worker = threading.Thread(target=work, name="engine")
        worker.start()
        threading.stack_size(size)
    try:
        with contextlib.suppress(ClientDisconnectedError):
            for request in _requests(receive, connection, session):
                try:
                    admitted = admit(request)
                except RefusalError as error:
                    connection.refuse(request, str(error))
                    return
                _sort(admitted, connection, inbox)
    finally:
        inbox.close()
        worker.join()


def _requests(
    receive: Callable[[], Message | None], connection: Connection, session: EditorSession
) -> Iterator[ClientRequest]:
    """Yield the client's requests, up to `disconnect` or the end of the stream.

    Raises:
        ClientDisconnectedError: the client has closed the connection.
    """
    while not session.over:
        try:
            message = receive()
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
            yield request
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
    """Queue a request; answer the cancellation of another one at once."""
    try:
        arguments = Arguments.of(request.arguments) if request.command == "cancel" else None
        if arguments is None or arguments.text("progressId", ""):
            inbox.put(request)
            return
        withdrawn = inbox.cancel(arguments.integer("requestId", 0))
    except RefusalError as error:
        connection.refuse(request, str(error), error.word)
        return
    if withdrawn is not None:
        connection.refuse(withdrawn, "withdrawn", "cancelled")
    connection.respond(request)
