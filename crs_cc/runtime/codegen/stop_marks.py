"""Stop marks of debug builds: a byte for each statement in the user's files, 1 to stop.

It is in a memory of its own, after the watched ranges (`runtime.watch_ranges`), and followed by as
many bytes that are all set, which are used for stepping.
"""

from __future__ import annotations

from crs_cc.requests import slot_offset
from crs_cc.runtime.codegen.indices import BEGUN_GLOBAL, MAILBOX, MARKS_GLOBAL, SLOT_GLOBAL
from crs_cc.runtime.codegen.watchpoints import is_pending, stops
from crs_cc.runtime.wasm import PAGE, UNLIKELY, Instr, Module
from crs_cc.runtime.watch_ranges import WATCHED


def add_marks(module: Module, statements: int) -> None:
    """Add the memory `marks` to a module with a number of statements, and export their count."""
    first = WATCHED.itemsize + statements
    module.exports.append(("marks", "memory", len(module.memories) + 1))
    module.exports.append(("begun", "global", BEGUN_GLOBAL))
    module.memories.append(-(-(first + statements) // PAGE))
    module.data.append((len(module.memories), first, b"\1" * statements))


def stop_if_marked(marks: int, number: int, suspend: list[Instr], *, watching: bool) -> list[Instr]:
    """Stop before a marked statement, when enough others have begun.

    Args:
        marks: index of the memory of the marks.
        number: the number of the statement.
        suspend: code that leaves the function.
        watching: stop also after an access to a watched range.
    """
    return [
        ("global.get", MARKS_GLOBAL), ("i32.load8_u", marks, WATCHED.itemsize + number), UNLIKELY,
        ("global.get", BEGUN_GLOBAL),
        ("global.get", SLOT_GLOBAL), ("i64.load", MAILBOX, slot_offset("stop_from")),
        ("i64.ge_s",), *(is_pending(marks) if watching else []), ("if",),
        ("global.get", SLOT_GLOBAL), ("i32.const", number + 1),
        ("i32.store", MAILBOX, slot_offset("stopped")),
        *(stops(marks) if watching else []), *suspend, ("end",), ("end",),
    ]  # fmt: skip


def begin() -> list[Instr]:
    """Return the code that counts a statement."""
    return [
        ("global.get", BEGUN_GLOBAL), ("i64.const", 1), ("i64.add",),
        ("global.set", BEGUN_GLOBAL),
    ]  # fmt: skip
