"""What is watched is found out wherever it is touched, and no program does anything else for it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from crs_cc.core.source import Diagnostics
from crs_cc.debug.errors import DebugError
from crs_cc.debug.watch import MAX, AccessKind, MemoryAccess, WatchedObject, WatchSet
from crs_cc.ir.names import plain_name
from crs_cc.requests import SUSPENDED
from crs_cc.runtime.diagnosis.inspect import StackFrame
from crs_cc.runtime.executable import Executable
from crs_cc.runtime.fleet import Fleet
from crs_cc.runtime.snapshot import Snapshot
from crs_cc.session.build import build_executable, build_watching
from crs_cc.session.host import Host, HostRequest
from tests.c.execution import build, cases
from tests.c.execution import name as case_name

PROGRAM = """\
#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
struct pair { char a, b; int c; } pairs[3];
static int total, other, twice;
static char text[20];
static jmp_buf back;
static int order[4] = {4, 2, 3, 1};
static int deep(int n)
{
    int mine = n;
    if (n > 0)
        mine += deep(n - 1);
    mine *= 2;
    return mine;
}
static int less(const void *a, const void *b)
{
    int x = *(const int *)a, y = *(const int *)b;
    twice = abs(x - y);
    return x - y;
}
static void leave(int how)
{
    int kept = how;
    kept++;
    if (kept > 2)
        longjmp(back, kept);
}
static int set(void)
{
    total = 5;
    return 6;
}
int main(void)
{
    int i;
    for (i = 0; i < 3; i++)
        total += i;
    total = 9, total = 3;
    total = 3;
    total = set();
    other = total;
    sprintf(text, "%d robots", total);
    memset(pairs, 1, sizeof pairs);
    pairs[1].b = 7;
    pairs[2] = pairs[1];
    qsort(order, 4, sizeof order[0], less);
    twice = deep(3);
    if (setjmp(back) == 0)
        leave(2);
    leave(1);
    other = 77;
}
"""


@dataclass(frozen=True)
class Found:
    """Where a program has stopped for an access: before which line, and how many had begun."""

    line: str
    begun: int
    access: MemoryAccess

    @property
    def by(self) -> tuple[str, str, str]:
        """Return what made the access: the function, the line, and the library's function."""
        place = self.access.location
        return (
            plain_name(self.access.function),
            _line(place.line if place else 0),
            self.access.library,
        )

    @property
    def change(self) -> tuple[int, int]:
        """Return the number that was there, and the one that is."""
        return _number(self.access.old[0]), _number(self.access.new[0])


def _line(number: int) -> str:
    """Return a line of the program."""
    return ["", *PROGRAM.splitlines()][number].strip()


def _number(content: bytes) -> int:
    return int.from_bytes(content, "little", signed=True)


class Watching:
    """A program that runs alone, from stop to stop."""

    def __init__(self, executable: Executable, fuel: int = 10**9) -> None:
        self.executable = executable
        self.fleet = Fleet([executable])
        self.host = Host([["watched"]], lambda *_: None, lambda *_: b"")
        self.watches = WatchSet(self.fleet, 0)
        self.fuel = fuel
        self.ended = False

    def run(self) -> bool:
        """Run to the next stop; return False at the end."""
        slot = self.fleet.slots[0]
        while not self.ended:
            slot["run"], slot["fuel"] = 1, self.fuel
            self.fleet.run_round()
            if slot["status"] == SUSPENDED and slot["stopped"]:
                return True
            if slot["code"]:
                self.host.serve(int(slot["code"]), HostRequest(0, slot["message"]))
            self.ended = self.host.exit_status[0] is not None or slot["status"] != SUSPENDED
        return False

    def to(self, statement: int) -> None:
        """Go to before a statement, by how many have begun, whatever is watched."""
        slot = self.fleet.slots[0]
        slot["stop_before_all"], slot["stop_from"] = 1, statement
        while int(slot["statements"]) < statement:
            assert self.run()
            self.watches.drain()
        slot["stop_before_all"] = slot["stop_from"] = 0

    def to_line(self, line: str) -> None:
        """Go to before a line, the next time."""
        sites = self.executable.detail().compiled.statements
        marks = [number for number, each in enumerate(sites) if _line(each.location.line) == line]
        self.fleet.marks[0][marks] = 1
        assert self.run()
        self.fleet.marks[0][marks] = 0

    @property
    def begun(self) -> int:
        return int(self.fleet.slots["statements"][0])

    @property
    def line(self) -> str:
        """Return the line that it has stopped before."""
        number = int(self.fleet.slots["stopped"][0]) - 1
        return _line(self.executable.detail().compiled.statements[number].location.line)

    def watch(self, kind: AccessKind, *names: str) -> None:
        self.watches.arm(
            [self.object(each, kind, n) for n, each in enumerate(names, start=1)], build_watching
        )

    def object(self, text: str, kind: AccessKind, number: int = 1) -> WatchedObject:
        """Return an object: `name`, `name+offset:size`, or `function/variable`."""
        name, _, part = text.partition("+")
        at, _, size = part.partition(":")
        function, slash, variable = name.partition("/")
        if slash:
            return self.local(function, variable, kind, number)
        compiled = self.executable.detail().compiled
        for each, data in self.executable.program.data.items():
            if plain_name(each) == name:
                first = compiled.addresses[each] + int(at or 0)
                return WatchedObject(number, kind, first, int(size or data.size))
        raise AssertionError(name)

    def local(
        self, function: str, variable: str, kind: AccessKind, number: int = 1
    ) -> WatchedObject:
        """Return a variable of the innermost activation of a function."""
        frame = self.frame(function)
        layout = self.executable.detail().compiled.info(frame.function).frame
        for place, at in layout.offsets.items():
            if place.variable is not None and place.variable.name == variable:
                return WatchedObject(number, kind, frame.fp - layout.size + at, 4, frame)
        raise AssertionError(variable)

    def frame(self, function: str) -> StackFrame:
        stack = self.fleet.stopped(0).stack
        return next(each for each in stack if plain_name(each.function) == function)

    def found(self) -> Iterator[Found]:
        """Run to the end; return each stop for an access."""
        while self.run():
            for access in self.watches.drain():
                yield Found(self.line, self.begun, access)
        for access in self.watches.drain():
            yield Found("", self.begun, access)


@pytest.fixture(scope="module")
def program(tmp_path_factory: pytest.TempPathFactory) -> Executable:
    path: Path = tmp_path_factory.mktemp("watch") / "watch.c"
    path.write_text(PROGRAM)
    return build_executable([path], Diagnostics(), debug=True)


def all_found(program: Executable, kind: AccessKind, name: str) -> list[Found]:
    run = Watching(program)
    run.watch(kind, name)
    return list(run.found())


def test_a_write_is_reported_with_old_value_and_location(program: Executable) -> None:
    found = all_found(program, "write", "total")
    assert [(*each.by[:2], each.line, each.change) for each in found] == [
        ("main", "total += i;", "for (i = 0; i < 3; i++)", (0, 0)),
        ("main", "total += i;", "for (i = 0; i < 3; i++)", (0, 1)),
        ("main", "total += i;", "for (i = 0; i < 3; i++)", (1, 3)),
        ("main", "total = 9, total = 3;", "total = 3;", (3, 3)),
        ("main", "total = 3;", "total = set();", (3, 3)),
        ("set", "total = 5;", "return 6;", (3, 5)),
        ("main", "total = set();", "other = total;", (5, 6)),  # though `return 6;` began last
    ]
    assert {each.access.what for each in found} == {"write"}


def test_change_watchpoints_ignore_equal_writes(program: Executable) -> None:
    found = all_found(program, "change", "total")
    assert [each.change for each in found] == [(0, 1), (1, 3), (3, 5), (5, 6)]


def test_reads_are_distinguished_from_writes(program: Executable) -> None:
    reads = all_found(program, "read", "total")
    sprintf = 'sprintf(text, "%d robots", total);'
    assert [each.by[1] for each in reads] == [*["total += i;"] * 3, "other = total;", sprintf]
    both = all_found(program, "access", "total")
    assert [each.access.what for each in both] == [*["write"] * 7, "read", "read"]


def test_library_writes_are_reported_at_the_call(program: Executable) -> None:
    *_, sprintf = all_found(program, "write", "text")
    assert sprintf.by == ("main", 'sprintf(text, "%d robots", total);', "sprintf")
    assert sprintf.line == "memset(pairs, 1, sizeof pairs);"
    assert sprintf.access.new[0].startswith(b"6 robots\0")
    first, *others = all_found(program, "change", "pairs+8:8")
    assert first.by[:2] == ("main", "memset(pairs, 1, sizeof pairs);")
    assert first.access.new[0] == b"\1" * 8
    assert [each.by for each in others] == [("main", "pairs[1].b = 7;", "")]


def test_library_writes_around_callbacks_are_reported(program: Executable) -> None:
    found = all_found(program, "change", "order")
    call = "qsort(order, 4, sizeof order[0], less);"
    assert {each.by for each in found} == {("main", call, "qsort")}  # not `abs`, called by `less`
    assert found[-1].access.new[0] == np.array([1, 2, 3, 4], "<i4").tobytes()


def test_the_last_write_is_reported_at_the_end(program: Executable) -> None:
    last = all_found(program, "write", "other")[-1]
    assert (last.by[1], last.line, last.change) == ("other = 77;", "", (6, 77))


def test_overlapping_and_adjacent_objects_are_distinguished(program: Executable) -> None:
    run = Watching(program)
    parts = "pairs+9:1", "pairs+8:1", "pairs+10:1", "pairs+8:8", "pairs+16:1"
    run.watch("write", *parts)
    by_line: dict[str, list[int]] = {}
    for each in run.found():
        by_line.setdefault(each.by[1], []).append(each.access.watched.number)
    assert by_line == {
        "memset(pairs, 1, sizeof pairs);": [1, 2, 3, 4, 5],
        "pairs[1].b = 7;": [1, 4],
        "pairs[2] = pairs[1];": [5],
    }


def test_a_variable_in_a_register_is_watched(program: Executable) -> None:
    run = Watching(program)
    run.to_line("for (i = 0; i < 3; i++)")
    run.watch("change", "main/i")
    *changes, end = run.found()
    assert [each.change[1] for each in changes] == [1, 2, 3]
    assert (end.access.what, end.line) == ("return", "")


def test_activations_are_distinguished(program: Executable) -> None:
    run = Watching(program)
    for _ in range(3):  # n is 3, 2, 1
        run.to_line("if (n > 0)")
    assert len([each for each in run.fleet.stopped(0).stack if "deep" in each.function]) == 3
    run.watch("write", "deep/mine")
    found = list(run.found())
    assert [(each.by[1], each.access.what) for each in found] == [
        ("mine += deep(n - 1);", "write"),
        ("mine *= 2;", "write"),
        ("return mine;", "return"),
    ]
    assert [each.change for each in found][:2] == [(1, 1), (1, 2)]
    assert found[-1].line == "mine *= 2;"  # of its caller


def test_a_watch_ends_when_a_jump_leaves_its_function(program: Executable) -> None:
    run = Watching(program)
    run.to_line("kept++;")
    run.watch("change", "leave/kept")
    first, last = run.found()
    assert (first.by[1], first.change) == ("kept++;", (2, 3))
    assert (last.access.what, last.line) == ("return", "leave(1);")


def snapshots(run: Watching) -> dict[int, Snapshot]:
    """Return a program's state before every statement."""
    saved = {}
    slot = run.fleet.slots[0]
    slot["stop_before_all"] = 1
    while run.run():
        saved[run.begun] = run.fleet.snapshot(0)
    return saved


def again_from(run: Watching, saved: Snapshot) -> list[Found]:
    run.fleet.restore(0, saved)
    run.fleet.slots["stop_before_all"] = 0
    run.host.exit_status[0] = None
    run.ended = False
    run.watches.reset()
    return list(run.found())


def test_a_watch_follows_its_activation_when_the_run_moves(program: Executable) -> None:
    run = Watching(program)
    saved = snapshots(run)
    run.fleet.restore(0, saved[0])
    run.ended, run.host.exit_status[0] = False, None
    run.fleet.slots["stop_before_all"] = 0
    run.to_line("if (n > 0)")
    run.to_line("if (n > 0)")
    run.watch("change", "deep/mine")
    whole = list(run.found())
    assert [each.access.what for each in whole] == ["write", "write", "return"]
    entered = whole[0].access.watched.frame
    assert entered is not None
    for begun, each in saved.items():
        wanted = [row for row in whole if row.begun > begun]
        found = again_from(run, each)
        same = [(row.begun, row.line, row.access.what, row.by) for row in found]
        if begun <= entered.entered:
            assert same[0][2:] == ("write", ("deep", "int mine = n;", ""))
            del same[0], found[0]
        assert same == [(row.begun, row.line, row.access.what, row.by) for row in wanted], begun
        assert [row.change for row in found] == [row.change for row in wanted], begun


def test_stepping_and_watching_do_not_disturb_each_other(program: Executable) -> None:
    plain, watched = Watching(program), Watching(program)
    watched.watch("access", "total", "order", "text", "pairs")
    for statement in range(10, 60, 7):
        for each in (plain, watched):
            each.to(statement)
        assert plain.line == watched.line
        fleets = plain.fleet, watched.fleet
        reached = np.flatnonzero(fleets[0].shadow(0))  # below the stack lies what stops left there
        assert np.array_equal(reached, np.flatnonzero(fleets[1].shadow(0)))
        one, other = (each.memory(0)[reached] for each in fleets)
        assert np.array_equal(one, other)


def test_hits_survive_fuel_exhaustion(program: Executable) -> None:
    whole, pieces = Watching(program), Watching(program, fuel=40)
    for each in (whole, pieces):
        each.watch("change", "order", "text")
    one, other = (
        [(each.begun, each.by, each.access.new) for each in run.found()] for run in (whole, pieces)
    )
    assert one == other


def test_too_many_watched_objects_are_refused(program: Executable) -> None:
    run = Watching(program)
    objects = [run.object("total", "write", number) for number in range(MAX + 1)]
    with pytest.raises(DebugError, match=f"at most {MAX} objects"):
        run.watches.arm(objects, build_watching)
    run.watches.arm(objects[:MAX], build_watching)
    assert len(list(run.found())) == 7 * MAX


def test_the_maximum_of_local_variables_can_be_watched(program: Executable) -> None:
    run = Watching(program)
    run.to_line("if (n > 0)")
    run.watches.arm(
        [run.local("deep", "mine", "write", number) for number in range(MAX)], build_watching
    )
    assert len(list(run.found())) == 3 * MAX


def test_without_watched_objects_the_debug_build_runs(program: Executable) -> None:
    run = Watching(program)
    run.watch("write", "total")
    assert run.fleet.executable(0) is not program
    run.watches.arm([], build_watching)
    assert run.fleet.executable(0) is program
    assert not list(run.found())


def changes_by_comparing(
    program: Executable, objects: Sequence[WatchedObject]
) -> list[tuple[object, ...]]:
    """Return what changed in some objects, found by looking before every statement."""
    run = Watching(program)
    memory, found = run.fleet.memory(0), []

    def look() -> list[bytes]:
        return [memory[each.address :][: each.size].tobytes() for each in objects]

    before = look()
    run.fleet.slots["stop_before_all"] = 1
    while run.run() and run.begun < MAX_STATEMENTS:
        now = look()
        for each, old, new in zip(objects, before, now, strict=True):
            if old != new:
                found.append((run.begun, each.number, old, new))
        before = now
    return found


def changes_by_watching(
    program: Executable, objects: Sequence[WatchedObject]
) -> list[tuple[object, ...]]:
    run = Watching(program)
    run.watches.arm(objects, build_watching)
    found: list[tuple[object, ...]] = []
    while run.run() and run.begun < MAX_STATEMENTS:
        found += [
            (run.begun, each.watched.number, each.old[0], each.new[0])
            for each in run.watches.drain()
            if each.old[0] != each.new[0]
        ]
    return found


MAX_STATEMENTS = 3000


def compare(program: Executable) -> int:
    """Compare the changes of all global objects of a program; return how many there were."""
    detail = program.detail()
    objects = [
        WatchedObject(number, "change", detail.compiled.addresses[name], data.size)
        for number, (name, data) in enumerate(detail.program.data.items())
        if data.size and "<library>" not in data.location.file
    ]
    count = 0
    for first in range(0, len(objects), MAX):
        some = objects[first : first + MAX]
        wanted = changes_by_comparing(program, some)
        assert changes_by_watching(program, some) == wanted
        count += len(wanted)
    return count


def test_hits_are_the_changes_of_memory(program: Executable) -> None:
    assert compare(program) >= 15


@pytest.mark.parametrize("path", cases("valid")[::7], ids=case_name)
def test_hits_are_the_changes_of_memory_in_every_kind_of_program(path: Path) -> None:
    compare(build(path, debug=True))


def test_unchecked_builds_find_the_same_accesses(
    program: Executable, tmp_path_factory: pytest.TempPathFactory
) -> None:
    path: Path = tmp_path_factory.mktemp("unchecked") / "watch.c"
    path.write_text(PROGRAM)
    unchecked = build_executable([path], Diagnostics(), debug=True, checked=False)
    for name in ("total", "order", "text"):
        one, other = all_found(program, "change", name), all_found(unchecked, "change", name)
        assert [(each.begun, each.change) for each in one] == [
            (each.begun, each.change) for each in other
        ]
    assert all_found(unchecked, "change", "total")[0].by == ("main", "total += i;", "")
    assert all_found(unchecked, "change", "text")[0].access.location is None
