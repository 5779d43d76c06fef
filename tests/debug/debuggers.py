"""Small programs under the debugger's engine."""

from __future__ import annotations

import functools
import hashlib
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from crs_cc.core.source import Diagnostics
from crs_cc.debug.engine import Debugger
from crs_cc.debug.program import DebugProgram
from crs_cc.debug.stop import Stop
from crs_cc.session.build import build_executable
from crs_cc.session.library import library_options
from crs_cc.sim.files.world_xml import empty_world, load_world

ROOT = Path(__file__).parents[2]


@functools.cache
def debug_program(*paths: Path) -> DebugProgram:
    """Return the debug build of some C files."""
    options = library_options()
    return DebugProgram(build_executable(paths, Diagnostics(), debug=True), paths, options)


@functools.cache
def _folder() -> tempfile.TemporaryDirectory[str]:
    return tempfile.TemporaryDirectory(prefix="programs-of-tests-")


def source_file(source: str, name: str) -> Path:
    """Return a file with a source, the same for all tests: it is built once, and never changed."""
    path = Path(_folder().name, hashlib.sha256(source.encode()).hexdigest()[:16], name)
    if not path.exists():
        path.parent.mkdir(exist_ok=True)
        path.write_text(source)
    return path


def debugger_of(*sources: str, world: str = "", **options: Any) -> Debugger:
    """Put programs, given as text, into the robots of a world: the last into all that are left.

    Args:
        sources: the programs; their files are `a.c`, `b.c`, ...
        world: the world's name in `worlds/`; by default it is empty.
        options: further ones of the `Debugger`.
    """
    named = zip(sources, "abcdefgh", strict=False)
    return debugger_at(
        [source_file(source, f"{letter}.c") for source, letter in named], world, **options
    )


def debugger_at(paths: Sequence[Path], world: str = "", **options: Any) -> Debugger:
    """Put programs into the robots of a world: the last into all that are left."""
    model = load_world(ROOT / "worlds" / world) if world else empty_world()
    programs = [debug_program(path) for path in paths]
    robots = len(model.robots)
    programs = [*programs, *programs[-1:] * (robots - len(programs))][:robots]
    return Debugger(model, programs, **options)


def advance(debugger: Debugger, place: str, condition: str = "") -> Stop:
    """Continue the selected program to a place."""
    options = {"robot": debugger.view.robot, "condition": condition, "temporary": True}
    return debugger.advance(debugger.stop_points.add_breakpoint(place, internal=True, **options))


def line(debugger: Debugger) -> int:
    """Return the line where it is; 0 where there is none."""
    location = debugger.view.location()
    return 0 if location is None else location.line
