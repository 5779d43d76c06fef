"""`why` beside a slow oracle, which single-steps and keeps the whole memory after each statement.

Each node of a tree claims: this object had this value, written by the statement at this position
and not changed from there to where its parent used it. The oracle looks at all bytes of the object
at all positions in between, wherever it is: a local variable, a parameter, an element behind a
pointer, what a function of the library has copied, a message of another robot, `State[]`.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import pytest

from crs_cc.core.arrays import ByteArray
from crs_cc.debug.cause import Cause
from crs_cc.debug.engine import Debugger
from crs_cc.debug.errors import DebugError
from crs_cc.debug.timeline.position import Position
from crs_cc.debug.why import Why
from crs_cc.runtime.diagnosis.inspect import StackFrame
from crs_cc.runtime.layout import STACK_TOP
from tests.debug.debuggers import debugger_of

PROGRAM = """\
#include <string.h>
struct pair { int first, second; };
struct node { struct pair at; struct node *next; } nodes[3];
static int seed = 7, tab[4], total;
static int draw(int most)
{
    int drawn;
    seed = seed * 1103515245 + 12345;
    drawn = (seed >> 16) & 0xff;
    return drawn % most;
}
static int depth(int n, int add)
{
    int below = add;
    if (n > 0)
        below = depth(n - 1, add + n) + 1;
    return below;
}
static void put(struct node *into, const int *one, int other)
{
    struct pair made;
    made.first = *one;
    made.second = other - made.first;
    into->at = made;
}
static struct pair both(int a, int b)
{
    struct pair made = { a, b };
    made.first += b;
    return made;
}
static int mixed(int i, struct pair given)
{
    int local[3], *to = local + i % 3, kept, sum;
    memset(local, 0, sizeof local);
    *to = given.first;
    kept = depth(draw(3), given.second);
    memcpy(&tab[i & 3], to, sizeof *to);
    put(&nodes[i % 3], &tab[i & 3], kept);
    sum = nodes[i % 3].at.second + local[1];
    total = total + sum;
    return sum; /* line 42 */
}
int main(void)
{
    int i, last = 1;
    for (i = 0; i < 2; i++)
        last = mixed(i, both(last, draw(9)));
    return last;
}
"""
STOP = 42
ASKED = ("sum", "kept", "local[0]", "local[1]", "*to", "i", "given.first", "given.second", "total",
         "tab[i & 3]", "nodes[i % 3].at.second", "nodes[i % 3].at.first", "seed")  # fmt: skip
ROOM = 1 << 16
"""So many bytes below and above the end of the stack are kept: all that the program uses."""


@dataclass
class Oracle:
    """The memory after each statement of a program.

    Attributes:
        positions: where it stopped: before each statement.
        memories: for each position, the bytes around the end of the stack.
    """

    positions: list[Position]
    memories: list[ByteArray]

    @classmethod
    def of(cls, debugger: Debugger) -> Oracle:
        """Single-step through a program."""
        found = cls([], [])
        debugger.start()
        while not debugger.run.is_over(0):
            found.positions.append(debugger.position)
            memory = debugger.run.stopped(0).memory
            found.memories.append(memory[STACK_TOP - ROOM : STACK_TOP + ROOM].copy())
            debugger.step_statement()
        return found

    def number(self, at: Position) -> int:
        """Return the number of a position, or of the last one before: calls return between two."""
        return bisect_right(self.positions, at) - 1

    def values(self, first: int, last: int, address: int, size: int) -> set[bytes]:
        """Return the values that an object has had."""
        at = address - STACK_TOP + ROOM
        return {each[at : at + size].tobytes() for each in self.memories[first : last + 1]}


class Checker:
    """Compares trees with the oracle.

    Attributes:
        checked: how many nodes have been compared, by what they are.
    """

    def __init__(
        self, debugger: Debugger, oracle: Oracle, functions: Sequence[int] | None = None
    ) -> None:
        self.functions = FUNCTIONS if functions is None else functions
        self.debugger = debugger
        self.oracle = oracle
        self.checked = {"global": 0, "local": 0}

    def check(self, cause: Cause, until: Position, frame: StackFrame | None) -> None:
        """Check a node and those below it, whose value was used at a position in a frame."""
        at = until if cause.position is None else cause.position
        assert self.oracle.number(at) <= self.oracle.number(until), cause
        if " = " in cause.text and cause.how != "...":
            self._compare(cause, at, until, frame)
        if cause.causes:
            self.debugger.goto(at)
            below = self.frame(cause)
            for each in cause.causes:
                self.check(each, at, below)

    def _compare(
        self, cause: Cause, at: Position, until: Position, frame: StackFrame | None
    ) -> None:
        self.debugger.goto(until)
        evaluator = self.debugger.view.evaluator(0)
        place = evaluator.place(cause.expression, frame)
        value = evaluator.evaluate(cause.expression, frame).value
        evaluator.undo()
        assert cause.text == f"{cause.expression} = {value.text}"
        first, last = self.oracle.number(at) + 1, self.oracle.number(until)
        if cause.position is None or cause.times > 1:
            first = last  # an initial value, or an argument; or the first of many writes
        values = self.oracle.values(first, last, place.address, place.size)
        assert values <= {value.content}, (cause, values)
        self.checked["local" if place.address < STACK_TOP else "global"] += 1

    def frame(self, cause: Cause) -> StackFrame | None:
        """Return the frame in which a statement is executed: the run is before it."""
        if cause.location is None:
            return None
        stack = self.debugger.run.stopped(0).stack
        for each in stack:
            info = self.debugger.run.stopped(0).compiled.info(each.function).function.location
            lines = [line for line in self.functions if line <= cause.location.line]
            if info.file == cause.location.file and info.line in {lines[-1], lines[-1] + 1}:
                return replace(each, location=cause.location)
        return None


FUNCTIONS = [
    number
    for number, line in enumerate(PROGRAM.splitlines(), start=1)
    if line.endswith(")") and not line.startswith(" ")
]
"""The lines at which the functions begin."""


def test_trees_through_locals_arguments_returns_and_memory() -> None:
    debugger = debugger_of(PROGRAM)
    oracle = Oracle.of(debugger)
    debugger.goto_time(0.0)
    debugger.stop_points.add_breakpoint(str(STOP))
    checker, stops = Checker(debugger, oracle), 0
    while debugger.resume().reason == "breakpoint":
        here, frame = debugger.position, debugger.view.active_frame(0)
        for expression in ASKED:
            cause = Why(debugger.view, debugger.navigator).explain(expression)
            assert debugger.position == here
            checker.check(cause, here, frame)
            debugger.goto(here)
        stops += 1
    assert stops == 2
    assert checker.checked["local"] > 40
    assert checker.checked["global"] > 8


MESSAGES = """\
#include <crs.h>
#include <unistd.h>
#include "Nclient.h"
int near_in, told;
int main(void)
{
    int i;
    connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400);
    for (i = 0; i < 12; i++) {
        gs();
        near_in = State[17];
        if (crs_my_number() == 0) {
            int report = near_in + 1000 * i;
            crs_send(1, 7, &report, sizeof report);
        } else {
            struct crs_message message;
            if (crs_receive(&message, 2000))
                told = *(int *) message.data;
        }
        usleep(500000);
    }
    return 0;
}
"""
PARTS = """\
#include <string.h>
#include <crs.h>
#include "Nclient.h"
struct report { int number; short kind; double range; char name[6]; };
int second, told;
double far;
char letter;
struct report got;
int main(void)
{
    int i;
    connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400);
    for (i = 0; i < 3; i++) {
        if (crs_my_number() == 0) {
            struct report report;
            int pair[2];
            report.number = 40 + i;
            report.kind = 7;
            report.range = i * 2.5;
            strcpy(report.name, "left");
            crs_send(1, 7, &report, sizeof report);
            pair[0] = i;
            pair[1] = 100 + i;
            crs_broadcast(7, pair, sizeof pair);
        } else {
            struct crs_message message;
            if (crs_receive(&message, 2000)) {
                memcpy(&got, message.data, sizeof got);
                told = ((struct report *) message.data)->number;
                far = got.range;
                letter = got.name[1];
            }
            if (crs_receive(&message, 2000))
                second = *(int *) (message.data + 4);
        }
        ws(1, 1, 1, 1);
    }
    return 0;
}
"""
BEGINS = 9
"""The line at which its function begins."""

WHOLE = """\
#include <string.h>
#include <crs.h>
#include "Nclient.h"
struct at { int x, y; };
struct report { int number; short kind; double range; struct at at; };
struct report list[3], last;
double far;
static struct report read_report(struct crs_message *from)
{
    struct report got = *(struct report *) from->data;
    return got;
}
static void keep(struct report given, int at)
{
    list[at] = given;
    far = list[at].range;
}
int main(void)
{
    int i;
    connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400);
    for (i = 0; i < 3; i++) {
        if (crs_my_number() == 0) {
            struct report report;
            report.number = 40 + i;
            report.kind = 7;
            report.range = i * 2.5;
            report.at.x = 5;
            report.at.y = -i;
            crs_send(1, 7, &report, sizeof report);
        } else {
            struct crs_message message;
            if (crs_receive(&message, 2000)) {
                last = *(struct report *) message.data;
                keep(read_report(&message), i);
            }
        }
        ws(1, 1, 1, 1);
    }
    return 0;
}
"""
WHOLE_BEGINS = [8, 13, 18]

SENT_WHOLE = {
    "last.number": "report.number = 42",
    "last.range": "report.range = 5.0",
    "last.at.y": "report.at.y = -2",
    "list[2].kind": "report.kind = 7",
    "list[2].at.y": "report.at.y = -2",
    "list[1].at": "report.at = {x = 5, y = -1}",
    "list[1].number": "report.number = 41",
    "far": "report.range = 5.0",
}

SENT = {
    "second": "pair[1] = 102",
    "told": "report.number = 42",
    "far": "report.range = 5.0",
    "letter": "report.name[1] = 101 'e'",
    "got.kind": "report.kind = 7",
}
"""What was sent of each."""


@pytest.mark.parametrize(
    ("source", "begins", "sent"),
    [(PARTS, [BEGINS], SENT), (WHOLE, WHOLE_BEGINS, SENT_WHOLE)],
    ids=["parts", "structs that are assigned, passed and returned as a whole"],
)
def test_a_part_of_a_message_comes_from_the_bytes_that_were_sent(
    source: str, begins: list[int], sent: dict[str, str]
) -> None:
    debugger = debugger_of(source, world="pair.xml")
    checker = Checker(debugger, Oracle.of(debugger), begins)
    debugger.goto_end()
    here = debugger.position
    for expression, text in sent.items():
        debugger.goto(here)
        debugger.view.select_robot(1)
        cause = find(Why(debugger.view, debugger.navigator).explain(expression), "sent it")
        assert cause is not None
        assert cause.position is not None
        assert [each.text for each in cause.causes] == [text]
        debugger.goto(cause.position)
        frame = checker.frame(cause)
        for each in cause.causes:
            checker.check(each, cause.position, frame)
    assert checker.checked["local"] >= len(sent)


INCH_M = 0.0254


def find(cause: Cause, ends: str) -> Cause | None:
    """Return the first node whose text ends so."""
    if cause.text.endswith(ends):
        return cause
    return next((found for each in cause.causes if (found := find(each, ends))), None)


def beam_of(cause: Cause) -> Cause | None:
    """Return the first node with a beam."""
    if cause.beam is not None:
        return cause
    return next((found for each in cause.causes if (found := beam_of(each))), None)


@pytest.fixture(scope="module")
def pair() -> Debugger:
    """Two robots of which one reports to the other what it sees."""
    return debugger_of(MESSAGES, world="pair.xml")


def test_messages_and_state(pair: Debugger) -> None:
    """The oracle stops at each message and notes what it says: the numbers in them are unique."""
    sent: dict[int, tuple[Position, int]] = {}
    pair.stop_points.add_breakpoint("14", robot=0)
    while pair.resume().reason == "breakpoint":
        report = int(pair.evaluate("report", robot=0).number or 0)
        sent[report] = pair.position, int(pair.evaluate("near_in", robot=0).number or 0)
    pair.stop_points.remove(1)
    pair.view.select_robot(1)
    explained = 0
    for tenths in range(10, 60, 7):
        pair.goto_time(tenths / 10)
        told = int(pair.view.evaluate_pure("told", robot=1).number or 0)
        if not told:
            continue
        cause = Why(pair.view, pair.navigator).explain("told")
        message, measured = find(cause, "sent it"), beam_of(cause)
        assert message is not None
        position, near_in = sent[told]
        assert message.position == position
        assert measured is not None
        assert measured.beam is not None
        assert measured.position is not None
        assert measured.position <= position
        assert near_in == min(255, round(measured.beam.echo_m / INCH_M))
        explained += 1
    assert explained > 4


def test_an_expression_that_is_not_there_is_refused(pair: Debugger) -> None:
    with pytest.raises(DebugError):
        Why(pair.view, pair.navigator).explain("nothing_there")
    assert np.isfinite(pair.view.time_s)
