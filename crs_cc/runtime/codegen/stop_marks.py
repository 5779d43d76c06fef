"""Stop marks of debug builds: a byte for each site in the user's files, `STOP` to stop.

The marks are in a memory of their own, after the watched ranges (`runtime.watch_ranges`), and
followed by two constant maps, which `stop_before_all` selects: one in which all statements are set,
for stepping, and one in which the returns from calls are set, too, for going to a number of sites
passed.

At a site marked `TEST` the function saves its registers as if it stopped, and calls the site's
test, see `site_tests`. If that says that the program need not stop, the function resumes itself:
its callers know nothing of it, so a test costs no more at the bottom of a deep recursion.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from crs_cc.ir.instruction import Statement
from crs_cc.ir.names import in_library
from crs_cc.ir.program import Function
from crs_cc.requests import SUSPENDED, slot_offset
from crs_cc.runtime.codegen import stopping
from crs_cc.runtime.codegen.indices import (
    BEGUN_GLOBAL,
    FUEL,
    MAILBOX,
    MARKS_GLOBAL,
    SLOT_GLOBAL,
    SP,
    STATUS_GLOBAL,
)
from crs_cc.runtime.codegen.watchpoints import is_pending, stops
from crs_cc.runtime.site_tests import TEST, UNPASSED
from crs_cc.runtime.sites import StatementSite
from crs_cc.runtime.wasm import PAGE, UNLIKELY, Instr, Module
from crs_cc.runtime.watch_ranges import WATCHED, offset

TEST_TYPE: Final = 0
"""The index of the type of tests, `TYPE_I32_I32`: of the lower end of the frame, 0 to go on."""

TESTS: Final = 1
"""The table of tests, by the numbers of their sites; the host makes room in it."""


def has_statements(function: Function) -> bool:
    """Return whether a program can stop in a function: it is the user's, and has statements."""
    return not in_library(function.location) and any(
        isinstance(it, Statement) for block in function.blocks for it in block.instructions
    )


def add_marks(module: Module, sites: Sequence[StatementSite]) -> None:
    """Add memory `marks` and table `tests` to a module, and export how many sites were passed."""
    statements = bytes(not each.after_call for each in sites)
    first = WATCHED.itemsize + len(sites)
    module.exports.append(("marks", "memory", len(module.memories) + 1))
    module.exports.append(("begun", "global", BEGUN_GLOBAL))
    assert len(module.tables) == TESTS
    module.exports.append(("tests", "table", TESTS))
    module.tables.append(0)
    content = statements + b"\1" * len(sites)
    module.memories.append(-(-(first + len(content)) // PAGE))
    module.data.append((len(module.memories), first, content))


def stop_if_marked(marks: int, number: int, suspend: list[Instr], *, watching: bool) -> list[Instr]:
    """Return code that stops at a marked site, when enough others have been passed.

    Args:
        marks: index of the memory of the marks.
        number: the number of the site.
        suspend: code that leaves the function, its status apart.
        watching: stop also after an access to a watched range.
    """
    place: Instr = ("i32.load8_u", marks, WATCHED.itemsize + number)
    return [
        ("global.get", MARKS_GLOBAL), place, UNLIKELY,
        ("global.get", MARKS_GLOBAL), ("global.get", MARKS_GLOBAL), place,
        ("i32.const", UNPASSED - 1), ("i32.and",), ("i32.store8", *place[1:]),
        ("global.get", BEGUN_GLOBAL),
        ("global.get", SLOT_GLOBAL), ("i64.load", MAILBOX, slot_offset("stop_from")),
        ("i64.ge_s",),
        ("global.get", MARKS_GLOBAL), place, ("i32.const", 0), ("i32.ne",), ("i32.and",),
        *(is_pending(marks) if watching else []), ("if",),
        ("global.get", SLOT_GLOBAL), ("i32.const", number + 1),
        ("i32.store", MAILBOX, slot_offset("stopped")),
        ("global.get", MARKS_GLOBAL), place, ("global.set", STATUS_GLOBAL),
        *(stops(marks) if watching else []), *suspend, ("end",), ("end",),
    ]  # fmt: skip


def self_resuming(body: list[Instr]) -> list[Instr]:
    """Return the code of a function that resumes itself at a site if its test says so.

    Args:
        body: the function's code. At its end it has saved its registers and pushes its fuel, as
            one that stops; so does the code that is returned.
    """
    stopped = slot_offset("stopped")
    return [
        ("loop",), *body, ("local.set", FUEL),
        ("global.get", STATUS_GLOBAL), ("i32.const", TEST), ("i32.eq",), UNLIKELY,
        *stopping.status(SUSPENDED),
        ("local.get", SP),
        ("global.get", SLOT_GLOBAL), ("i32.load", MAILBOX, stopped),
        ("i32.const", 1), ("i32.sub",), ("call_indirect", TEST_TYPE, TESTS),
        ("i32.eqz",), ("if",),
        ("global.get", SLOT_GLOBAL), ("i32.const", 0), ("i32.store", MAILBOX, stopped),
        ("br", 2), ("end",), ("end",), ("end",), ("local.get", FUEL),
    ]  # fmt: skip


def begin(marks: int, *, recorded: bool) -> list[Instr]:
    """Return the code that counts a site; a statement of a watching build is `recorded`."""
    record: list[Instr] = [
        ("i32.const", 0), ("global.get", BEGUN_GLOBAL), ("i64.store", marks, offset("statement")),
    ]  # fmt: skip
    return [
        *(record if recorded else []),
        ("global.get", BEGUN_GLOBAL), ("i64.const", 1), ("i64.add",),
        ("global.set", BEGUN_GLOBAL),
    ]  # fmt: skip
