"""A debugger's side of the screen that is made of plain data."""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence

from rich.text import Text

from crs_cc.debug.tui.backend import BackendReply, BackendRequest
from crs_cc.debug.tui.screen_data import (
    BreakpointMark,
    ListEntry,
    OutputLine,
    ScreenData,
    SourceData,
    ValueRow,
)
from crs_cc.debug.world.events import WorldEvent

LINES = (
    "/* Sum of squares. */",
    "int sum;",
    "",
    "int main(void)",
    "{",
    "\tint i;",
    "",
    "\tfor (i = 0; i < 10; i++)",
    "\t\tsum += i * i;",
    "\treturn sum;",
    "}",
)


class FakeWork:
    """Steps through a program that is not there; keeps the orders that it got."""

    def __init__(self) -> None:
        self.orders: list[BackendRequest] = []
        self.line = 8
        self.count = 0
        self.breakpoints = {9: BreakpointMark(1)}
        self.go_on = threading.Event()
        self.given: list[str | None] = []

    @property
    def lines(self) -> list[str]:
        return [each.line for each in self.orders if each.line is not None]

    def execute(self, request: BackendRequest) -> BackendReply:
        self.orders.append(request)
        line = request.line
        if line == "step":
            self.line, self.count = 17 - self.line, self.count + 1
            return BackendReply(self.snapshot(request), moved=True)
        if line == "print sum":
            return BackendReply(self.snapshot(request), Text("$1 = 285"))
        if line == "until":
            self.asked("scout")
        if line in {"continue", "until"}:
            self.go_on.wait(5.0)
            self.go_on.clear()
            return BackendReply(self.snapshot(request), Text("interrupted"), moved=True)
        if line is not None and line.startswith("break"):
            number = len(self.breakpoints) + 1
            self.breakpoints[int(line.rpartition(":")[2])] = BreakpointMark(number)
        if line == "delete 1":
            del self.breakpoints[9]
        if line == "quit":
            return BackendReply(self.snapshot(request), quits=True)
        if line == "foo":
            return BackendReply(
                self.snapshot(request), errors=('Undefined command: "foo".  Try "help".',)
            )
        return BackendReply(self.snapshot(request))

    def interrupt(self) -> None:
        self.go_on.set()

    @property
    def time_s(self) -> float:
        return 4.5

    def on_input_request(self, asked: Callable[[str], None]) -> None:
        self.asked = asked

    def send_input(self, line: str | None) -> None:
        self.given.append(line)
        self.go_on.set()

    def take_output(self) -> tuple[OutputLine, ...]:
        return (OutputLine("", "2 2"),)

    def complete(self, line: str) -> Sequence[str]:
        words = ["continue", "file:", "reverse-next", "reverse-step", "step"]
        return [each for each in words if each.startswith(line)]

    def snapshot(self, request: BackendRequest) -> ScreenData:
        where = ("0", "main", "p")
        parts = (ValueRow((*where, "x"), "x", "1.5"), ValueRow((*where, "y"), "y", "-2"))
        width, height = request.map_size
        return ScreenData(
            state="breakpoint 1, main () at sum.c:9",
            time_s=3.25,
            now_s=3.2,
            end_s=10.0,
            place="timestep 32, before stmt 121",
            source=self.source(request),
            frames=(
                ListEntry(0, "main ()", f"sum.c:{self.line}", True),
                ListEntry(1, "start ()", "start.c:3"),
            ),
            robots=(ListEntry(0, "scout", "1.00, 2.00 m, 45.0 deg", True),),
            variables=(
                ValueRow(
                    ("main",),
                    "main",
                    has_parts=True,
                    parts=(
                        ValueRow(("0", "main", "i"), "i", str(self.count)),
                        ValueRow(
                            where,
                            "p",
                            "{x = 1.5, y = -2}",
                            has_parts=True,
                            parts=parts if where in request.unfolded else (),
                        ),
                    ),
                ),
            ),
            world_map=Text("\n".join(["#" * width] * height)),
            output=(
                OutputLine("", "0 0", number=7),
                *[OutputLine("", "1 1", number=7 + each) for each in range(1, self.count + 1)],
            ),
            events=(
                WorldEvent(3.25, "stop", 0, "breakpoint 1"),
                WorldEvent(7.0, "collision", 0, "scout touched wall 3"),
            ),
        )

    def source(self, request: BackendRequest) -> SourceData:
        files = ("sum.c", "square.c")
        if request.file == "square.c" and request.line is None:
            return SourceData("square.c", ("double square(double x)",), files=files)
        return SourceData("sum.c", LINES, self.line, True, dict(self.breakpoints), files)
