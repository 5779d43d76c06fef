"""Watching builds stop before the first statement after an access to a watched range."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import pytest

from crs_cc.core.source import Diagnostics
from crs_cc.requests import SUSPENDED
from crs_cc.runtime.codegen.watchpoints import accesses
from crs_cc.runtime.executable import Executable, make_executable
from crs_cc.runtime.fleet import Fleet
from crs_cc.runtime.watch_ranges import RANGE, RANGES, READ, WRITE, grains, offset
from crs_cc.session.build import build_executable
from crs_cc.session.host import Host, HostRequest

PROGRAM = """\
#include <string.h>
struct pair { int a, b; } pairs[3];
static int total, other;
static void add(int *to, int what) { *to += what; }
int main(void)
{
    int i, twice = 0;
    for (i = 0; i < 3; i++) {
        add(&total, i);
        twice = 2 * total;
        other = twice;
    }
    memset(pairs, 1, sizeof pairs);
    pairs[1].b = 7;
    pairs[2] = pairs[1];
    total = total;
    return total + pairs[2].b;
}
"""


@dataclass
class Stepped:
    """A program that runs from stop to stop."""

    executable: Executable
    fleet: Fleet = field(init=False)
    status: int | None = None

    def __post_init__(self) -> None:
        self.fleet = Fleet([self.executable])
        self.host = Host([["watched"]], lambda *_: None, lambda *_: b"")

    def to_stop(self) -> int | None:
        """Continue, and return the line before which it stopped, None at the end."""
        slot = self.fleet.slots[0]
        while self.status is None:
            slot["run"], slot["fuel"] = 1, 10**9
            self.fleet.run_round()
            assert slot["status"] == SUSPENDED
            if slot["stopped"]:
                places = self.executable.detail().compiled.statements
                return places[int(slot["stopped"]) - 1].location.line
            self.host.serve(int(slot["code"]), HostRequest(0, slot["message"]))
            self.status = self.host.exit_status[0]
        return None

    def stops(self, address: int, size: int, kind: int, number: int = 0) -> list[int]:
        """Return the lines where it stops when bytes are watched."""
        watched = self.fleet.watched[0][0]
        watched["first"], watched["span"] = address - 7, size + 7
        watched["lowest"], watched["highest"] = address, address + size
        watched["grains"] = grains(address, size)
        watched["end"] = offset("ranges") + (number + 1) * RANGE.itemsize
        mine = watched["ranges"][number]
        mine["first"], mine["size"], mine["kinds"] = address, size, kind
        found = []
        while (line := self.to_stop()) is not None:
            assert int(mine["hits"]) == kind
            assert not watched["pending"]
            mine["hits"] = 0
            place = accesses(self.executable.program)[int(mine["place"]) - 1]
            assert place.location.line, place
            found.append(line)
        return found


@pytest.fixture(scope="module")
def plain(tmp_path_factory: pytest.TempPathFactory) -> Executable:
    path: Path = tmp_path_factory.mktemp("watched") / "watched.c"
    path.write_text(PROGRAM)
    return build_executable([path], Diagnostics(), debug=True)


@pytest.fixture(scope="module")
def watching(plain: Executable) -> Executable:
    return make_executable(plain.program, plain.name, debug=True, watching=True)


def test_a_program_can_move_from_one_build_to_the_other(
    plain: Executable, watching: Executable
) -> None:
    one, other = plain.detail().compiled, watching.detail().compiled
    assert one.addresses == other.addresses
    assert one.statements == other.statements
    for a, b in zip(one.functions, other.functions, strict=True):
        assert a.landings == b.landings, a.function.name
        assert list(a.frame.offsets.values()) == list(b.frame.offsets.values()), a.function.name


@pytest.mark.parametrize(
    ("name", "part", "kind", "lines"),
    [
        ("watched.c:total", (0, 4), WRITE, [10, 10, 10, 17]),  # through a pointer, and by its name
        ("watched.c:other", (0, 4), WRITE, [8, 8, 8]),
        ("watched.c:other", (0, 4), READ, []),
        ("pairs", (12, 4), WRITE, [14, 15]),  # pairs[1].b: by memset, by its name
        ("pairs", (16, 8), WRITE, [14, 16]),  # pairs[2], whole: by memset, by assignment
        ("pairs", (8, 8), READ, [16]),  # pairs[1], by assignment
    ],
)
def test_it_stops_after_each_access(
    watching: Executable, name: str, part: tuple[int, int], kind: int, lines: list[int]
) -> None:
    stepped, (offset, size) = Stepped(watching), part
    known = watching.detail().compiled.addresses
    address = next(at for each, at in known.items() if each.endswith(name)) + offset
    assert stepped.stops(address, size, kind, number=RANGES - 1) == lines
    assert stepped.status == 10


@pytest.mark.parametrize(
    ("name", "kind", "lines"),
    [
        ("twice", WRITE, [8, 11, 11, 11]),
        ("twice", READ, [8, 8, 8]),
        ("i", WRITE, [8, 8, 8, 8]),
    ],
)
def test_variables_in_registers_are_watched_in_their_frames(
    watching: Executable, name: str, kind: int, lines: list[int]
) -> None:
    stepped = Stepped(watching)
    slot = stepped.fleet.slots[0]
    slot["stop_before_all"] = 1
    assert stepped.to_stop() == 7
    slot["stop_before_all"] = 0
    frame = watching.detail().compiled.info("main").frame
    fp = next(each.fp for each in stepped.fleet.stopped(0).stack if each.function == "main")
    offset = next(
        at
        for at, each in ((at, place.variable) for place, at in frame.offsets.items())
        if each is not None and each.name == name
    )
    assert stepped.stops(fp - frame.size + offset, 4, kind) == lines
