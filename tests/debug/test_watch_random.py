"""In random programs, what is found by watching is what is found by looking at every statement."""

from __future__ import annotations

import contextlib
import random
from pathlib import Path

import pytest

from crs_cc.core.source import Diagnostics
from crs_cc.debug.data.evaluate import Evaluator
from crs_cc.debug.data.expression_compiler import SourceNames
from crs_cc.debug.errors import DebugError
from crs_cc.debug.program import DebugProgram
from crs_cc.debug.watch import MAX, WatchedObject
from crs_cc.debug.watchpoints import same_activation, watched_expression
from crs_cc.ir.names import in_library
from crs_cc.ir.types import ArrayType, IntegerType, PointerType
from crs_cc.runtime.diagnosis.inspect import StackFrame
from crs_cc.runtime.executable import Executable
from crs_cc.session.build import build_executable, build_watching
from crs_cc.session.library import library_options
from tests.debug.test_watch import Watching, compare
from tests.fuzz.generator.program import generate

Change = tuple[int, int, bytes, bytes]
"""How many statements had begun, the number of the object, what was there, and what is."""

FAR = 600
"""So many statements are followed."""
FEW = 300
"""So many, where an expression is evaluated before each."""
FEW_SEEDS = 3


def variables(run: Watching, chance: random.Random) -> list[WatchedObject]:
    """Return some variables of one of the functions that are active."""
    own = [each for each in run.fleet.stopped(0).stack if not in_library(each.location)]
    frame = chance.choice(own)
    layout = run.executable.detail().compiled.info(frame.function).frame
    places = [
        (frame.fp - layout.size + at, place.variable.ctype.size)
        for place, at in layout.offsets.items()
        if place.variable is not None and place.variable.ctype.size
    ]
    some = chance.sample(places, min(MAX, len(places)))
    return [WatchedObject(number, "change", *place, frame) for number, place in enumerate(some)]


def is_active(run: Watching, frame: StackFrame) -> bool:
    name = frame.fp, frame.function, frame.entered
    stack = run.fleet.stopped(0).stack
    return any((each.fp, each.function, each.entered) == name for each in stack)


def by_looking(
    run: Watching, objects: list[WatchedObject], end: int
) -> tuple[list[Change], int | None]:
    """Return the changes up to a statement, and the one before which the function had returned."""
    memory, changes = run.fleet.memory(0), list[Change]()
    parts = [slice(each.address, each.address + each.size) for each in objects]
    before = [memory[part].tobytes() for part in parts]
    run.fleet.slots["stop_before_all"] = 1
    while run.run() and run.begun < end:
        if objects[0].frame and not is_active(run, objects[0].frame):
            return changes, run.begun
        now = [memory[part].tobytes() for part in parts]
        changes += [
            (run.begun, number, old, new)
            for number, (old, new) in enumerate(zip(before, now, strict=True))
            if old != new
        ]
        before = now
    return changes, None


def by_watching(
    run: Watching, objects: list[WatchedObject], end: int
) -> tuple[list[Change], int | None]:
    changes = list[Change]()
    run.watches.arm(objects, build_watching)
    while run.run() and run.begun < end:
        for each in run.watches.drain():
            if each.what == "return":
                return changes, run.begun
            if each.old[0] != each.new[0]:
                changes.append((run.begun, each.watched.number, each.old[0], each.new[0]))
    return changes, None


def compare_variables(program: Executable, chance: random.Random) -> int:
    """Compare the changes of variables from some statements on; return how many there were."""
    whole = Watching(program)
    whole.run()
    count = 0
    for _ in range(8):
        first = chance.randrange(1, max(2, whole.begun - 1))
        one, other = Watching(program), Watching(program)
        one.to(first)
        other.to(first)
        objects = variables(one, chance)
        if objects:
            wanted = by_looking(one, objects, first + FAR)
            assert by_watching(other, objects, first + FAR) == wanted, first
            count += len(wanted[0])
    return count


def expressions(evaluator: Evaluator, chance: random.Random) -> list[str]:
    """Return some expressions of the variables of the innermost function of the user's."""
    of: dict[type, list[str]] = {}
    for each in evaluator.variables():
        of.setdefault(type(each.value.type), []).append(each.name)
    numbers, arrays = of.get(IntegerType, []) or ["1"], of.get(ArrayType, [])
    found = [f"{chance.choice(numbers)} * 3 + {chance.choice(numbers)}" for _ in range(2)]
    found += [f"{chance.choice(arrays)}[{chance.choice(numbers)} & 7]" for _ in arrays[:2]]
    return found + [f"*{each}" for each in of.get(PointerType, [])[:2]]


def expression_by_looking(
    run: Watching, evaluator: Evaluator, text: str, end: int
) -> tuple[list[tuple[int, bytes]], int | None]:
    """Return the new values of an expression, and before which statement its function returned."""
    changes, scope = list[tuple[int, bytes]](), evaluator.scope_of(text)

    def look() -> bytes:
        stack = run.fleet.stopped(0).stack
        own = scope.frame
        frame = next((each for each in stack if own and same_activation(each, own)), None)
        return evaluator.observe(text, scope.names, frame).content[0]

    before = look()
    run.fleet.slots["stop_before_all"] = 1
    while run.run() and run.begun < end:
        if scope.innermost and not is_active(run, scope.innermost):
            return changes, run.begun
        now = look()
        if now != before:
            changes.append((run.begun, now))
        before = now
    return changes, None


def expression_by_watching(
    run: Watching, names: SourceNames, text: str, end: int
) -> tuple[list[tuple[int, bytes]], int | None]:
    changes = list[tuple[int, bytes]]()
    evaluators = {id(run.executable): evaluator_of(run, names)}

    def current() -> Evaluator:
        build = id(run.fleet.executable(0))
        return evaluators.setdefault(build, evaluator_of(run, names))

    run.watches.arm([watched_expression(1, text, "change", current, None).watched], build_watching)
    while run.run() and run.begun < end:
        for each in run.watches.drain():
            if each.what == "return":
                return changes, run.begun
            if each.old[0] != each.new[0]:
                changes.append((run.begun, each.new[0]))
    return changes, None


def compare_expressions(program: Executable, names: SourceNames, chance: random.Random) -> int:
    """Compare the values of expressions from some statements on; return how many there were."""
    whole = Watching(program)
    whole.run()
    count = 0
    for _ in range(2):
        first = chance.randrange(1, max(2, whole.begun - 1))
        one = Watching(program)
        one.to(first)
        for text in expressions(evaluator_of(one, names), chance):
            runs = [Watching(program) for _ in range(2)]
            for each in runs:
                each.to(first)
            with contextlib.suppress(DebugError):  # it is constant, or an object that is no more
                found = expression_by_watching(runs[0], names, text, first + FEW)
                wanted = expression_by_looking(
                    runs[1], evaluator_of(runs[1], names), text, first + FEW
                )
                assert found == wanted, (first, text)
                count += len(found[0])
    return count


def evaluator_of(run: Watching, names: SourceNames) -> Evaluator:
    return Evaluator(lambda: run.fleet.stopped(0), names)


@pytest.mark.parametrize("seed", range(6))
def test_hits_are_the_changes_of_memory(seed: int, tmp_path: Path) -> None:
    path = tmp_path / "program.c"
    path.write_text(generate(seed))
    program = build_executable([path], Diagnostics(), debug=True)
    compare(program)
    assert compare_variables(program, random.Random(seed))
    if seed < FEW_SEEDS:
        names = SourceNames(DebugProgram(program, [path], library_options()))
        assert compare_expressions(program, names, random.Random(seed))
