"""A client of the protocol: it says what a test wants, and checks whatever it is told."""

from __future__ import annotations

import contextlib
import socket
import threading
from functools import partial
from pathlib import Path
from typing import Any, Self

from crs_cc.debug.dap.framing import encode, read_message
from crs_cc.debug.dap.serve import serve
from crs_cc.debug.dap.session import OpenRun
from tests.debug.dap.schema import demand_valid

WAIT_S = 20.0
Message = dict[str, Any]


class Client:
    """An editor, with a server of ours in another thread.

    Attributes:
        events: those that nobody has asked for yet, in their order.
        messages: whatever was told, in its order.
    """

    def __init__(self, open_run: OpenRun) -> None:
        self.events: list[Message] = []
        self.messages: list[Message] = []
        self._mine, theirs = socket.socketpair()
        self._mine.settimeout(WAIT_S)
        self._from = self._mine.makefile("rb")
        self._seq = 0
        self._answers: dict[int, Message] = {}

        def work() -> None:
            with (
                contextlib.suppress(ConnectionError),
                theirs,
                theirs.makefile("rb") as source,
                theirs.makefile("wb") as sink,
            ):
                serve(
                    partial(read_message, source),
                    sink,
                    open_run,
                    lambda: theirs.shutdown(socket.SHUT_RDWR),
                )

        self._server = threading.Thread(target=work)
        self._server.start()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        with contextlib.suppress(OSError):
            self._mine.shutdown(socket.SHUT_RDWR)
        self._server.join(WAIT_S)
        assert not self._server.is_alive(), "the server has not ended"
        self._from.close()
        self._mine.close()

    # -- saying ------------------------------------------------------------------------------

    def post(self, command: str, **arguments: Any) -> int:
        """Make a request, and return its number."""
        self._seq += 1
        message = {"seq": self._seq, "type": "request", "command": command, "arguments": arguments}
        self.send(encode(message))
        return self._seq

    def send(self, content: bytes) -> None:
        """Return something, whatever it is."""
        self._mine.sendall(content)

    def hang_up(self) -> None:
        """Return no more."""
        self._mine.shutdown(socket.SHUT_WR)

    # -- hearing -----------------------------------------------------------------------------

    def hear(self) -> Message | None:
        """Return the next message, None at the end; all have to fit the schema."""
        message = read_message(self._from)
        if message is not None:
            demand_valid(message)
            self.messages.append(message)
        return message

    def answer(self, seq: int) -> Message:
        """Return the response to a request."""
        while seq not in self._answers:
            message = self.hear()
            assert message is not None, "the server has ended"
            if message["type"] == "event":
                self.events.append(message)
            else:
                self._answers[message["request_seq"]] = message
        return self._answers.pop(seq)

    def ask(self, command: str, **arguments: Any) -> Message:
        """Make a request that is to be fulfilled, and return the body of the response."""
        answer = self.answer(self.post(command, **arguments))
        assert answer["success"], answer["message"]
        body: Message = answer.get("body", {})
        return body

    def refused(self, command: str, **arguments: Any) -> str:
        """Make a request that is not to be fulfilled, and return the reason."""
        answer = self.answer(self.post(command, **arguments))
        assert not answer["success"], answer
        text: str = answer["body"]["error"]["variables"]["why"]
        assert "internal error" not in text
        return text

    def event(self, name: str) -> Message:
        """Return the body of the next event of a kind."""
        while True:
            for number, each in enumerate(self.events):
                if each["event"] == name:
                    return self.events.pop(number).get("body", {})
            message = self.hear()
            assert message is not None, f"the server has ended without {name}"
            if message["type"] == "event":
                self.events.append(message)
            else:
                self._answers[message["request_seq"]] = message

    # -- usual sequences ---------------------------------------------------------------------

    def launch(self, *program: Path, **attributes: Any) -> Message:
        """Go through the opening up to `initialized`; return the capabilities."""
        able = self.ask("initialize", adapterID="crs", **SELF)
        self.ask("launch", program=[str(each) for each in program], **attributes)
        self.event("initialized")
        return able

    def begin(self) -> Message:
        """Let the run begin, and return the first stop."""
        self.ask("configurationDone")
        return self.event("stopped")

    def move(self, command: str, thread: int = 1, **arguments: Any) -> Message:
        """Let the run go on, or back, and return the stop."""
        self.ask(command, threadId=thread, **arguments)
        return self.event("stopped")

    def break_at(self, path: Path, *breakpoints: int | Message) -> list[Message]:
        """Set breakpoints at lines, or as the protocol describes them."""
        wanted = [{"line": each} if isinstance(each, int) else each for each in breakpoints]
        body = self.ask("setBreakpoints", source={"path": str(path)}, breakpoints=wanted)
        found: list[Message] = body["breakpoints"]
        return found

    def frames(self, thread: int = 1) -> list[Message]:
        """Return a robot's active functions."""
        found: list[Message] = self.ask("stackTrace", threadId=thread)["stackFrames"]
        return found

    def line(self, thread: int = 1) -> int:
        """Return the line in which a robot's program stands."""
        number: int = self.frames(thread)[0]["line"]
        return number

    def scope(self, name: str, thread: int = 1) -> list[Message]:
        """Return what stands in a scope of the innermost active function."""
        frame = self.frames(thread)[0]["id"]
        scopes = self.ask("scopes", frameId=frame)["scopes"]
        number = next(each["variablesReference"] for each in scopes if each["name"] == name)
        return self.parts(number)

    def parts(self, number: int, **arguments: Any) -> list[Message]:
        """Return the parts of something."""
        found: list[Message]
        found = self.ask("variables", variablesReference=number, **arguments)["variables"]
        return found

    def printed(self, category: str = "stdout") -> str:
        """Return what was written since this was asked for last."""
        rows = [each for each in self.events if each["event"] == "output"]
        mine = [each for each in rows if each["body"]["category"] == category]
        self.events = [each for each in self.events if each not in mine]
        return "".join(each["body"]["output"] for each in mine)


SELF = {
    "supportsVariableType": True,
    "supportsVariablePaging": True,
    "supportsMemoryReferences": True,
    "supportsInvalidatedEvent": True,
    "supportsMemoryEvent": True,
}
"""What the client says of itself."""
