"""Breakpoint locations as users type them: a line, a function, a call of the robot.

A line without code means the next one with code. A line or a function stops before its
first statement; a function of the robot (`ws`, `get_sn`) when its request is posted; another one of
the library before each statement that calls it. A function that is never called has locations like
any other, where no program ever stops.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import PurePath
from typing import TYPE_CHECKING, Final

from crs_cc.core.file_names import displayed
from crs_cc.core.source import Location
from crs_cc.core.suggest import unknown
from crs_cc.debug.errors import DebugError
from crs_cc.debug.program import DebugProgram
from crs_cc.ir.instruction import Block, Call, Statement
from crs_cc.ir.names import in_library, plain_name
from crs_cc.ir.program import Function
from crs_cc.requests import CODES
from crs_cc.robot_api import GROUPS
from crs_cc.robot_api.device import DEVICE_GROUPS
from crs_cc.session.device_library import device_groups

if TYPE_CHECKING:
    from crs_cc.runtime.sites import StatementSite

_PLACE: Final = re.compile(r"(?:(?P<file>.+):)?(?:(?P<line>[0-9]{1,9})|(?P<function>[A-Za-z_]\w*))")

POSTS: Final = {
    function.name: frozenset(CODES[name] for name in function.posts)
    for group in (*GROUPS, *DEVICE_GROUPS, *device_groups())
    for function in group.functions
    if function.posts
}
"""The codes of the requests that each function of the robot posts."""


@dataclass(frozen=True, slots=True)
class BreakpointLocation:
    """Where programs stop.

    Attributes:
        statements: by robot, the numbers of the statements before which it stops.
        codes: the requests after which it stops, for a function of the robot.
        location: the location in the source; None for a function of the library.
        function: the name of the function.
        note: a remark for the user: that the location was moved.
    """

    statements: Mapping[int, frozenset[int]]
    codes: frozenset[int]
    location: Location | None
    function: str
    note: str = ""


def find_location(
    text: str, programs: Sequence[DebugProgram], robots: Sequence[int], here: str
) -> BreakpointLocation:
    """Resolve a location as the user writes it.

    Args:
        text: `12`, `wander.c:12`, `turn`, `wander.c:turn`, `ws`.
        programs: by robot, its program.
        robots: the robots whose programs it refers to.
        here: the file of a line without one.

    Raises:
        DebugError: there is no such location.
    """
    match = _PLACE.fullmatch(text.strip())
    if match is None:
        raise DebugError(f"'{text}' is not a location (expected LINE, FILE:LINE or FUNCTION)")
    file = match["file"]
    sites = {robot: _sites(programs[robot]) for robot in robots}
    unused = list(_unused(programs))
    if match["line"]:
        return _line(sites, unused, file or here, int(match["line"]))
    return _function(sites, unused, file, match["function"], programs)


_ProgramSites = Mapping[int, "StatementSite"]
_Sites = Mapping[int, _ProgramSites]
"""By robot, the statements of its program by number."""


def _sites(program: DebugProgram) -> _ProgramSites:
    return dict(program.executable.detail().compiled.breakable())


_Unused = Sequence[tuple[str, Location]]


def _unused(programs: Sequence[DebugProgram]) -> Iterator[tuple[str, Location]]:
    """Return the statements of the user's functions that are never called, with their functions."""
    for program in {id(each): each for each in programs}.values():
        left_out = program.executable.program.unused
        for function in left_out.functions.values() if left_out else ():
            for block in function.blocks:
                for instruction in block.instructions:
                    if isinstance(instruction, Statement):
                        yield plain_name(function.name), instruction.location


def _never(sites: _Sites, function: str, place: Location) -> BreakpointLocation:
    """Return a location in a function that is never called."""
    nowhere = dict.fromkeys(sites, frozenset[int]())
    note = f"'{function}' is never called"
    return BreakpointLocation(nowhere, frozenset(), place, function, note)


def _line(sites: _Sites, unused: _Unused, file: str, line: int) -> BreakpointLocation:
    own = {
        robot: [
            (site.location.line, number)
            for number, site in rows.items()
            if is_file(site.location.file, file)
        ]
        for robot, rows in sites.items()
    }
    lines = {each for rows in own.values() for each, _ in rows}
    never = {at.line: (name, at) for name, at in reversed(unused) if is_file(at.file, file)}
    if not lines and not never:
        files = sorted({site.location.file for rows in sites.values() for site in rows.values()})
        raise DebugError(unknown("file", file, files))
    later = [each for each in lines | never.keys() if each >= line]
    if line < 1 or not later:
        raise DebugError(f"{file} has no code at or after line {line}")
    found = min(later)
    if found not in lines:
        return _never(sites, *never[found])
    statements = {
        robot: _firsts(sites[robot], [number for each, number in rows if each == found])
        for robot, rows in own.items()
    }
    robot, number = next((each, min(of)) for each, of in statements.items() if of)
    site = sites[robot][number]
    note = "" if found == line else f"no code at line {line}; moved to line {found}"
    return BreakpointLocation(
        statements, frozenset(), site.location, plain_name(site.function), note
    )


def _firsts(sites: _ProgramSites, numbers: Sequence[int]) -> frozenset[int]:
    """Return the first statement of each function among some."""
    first: dict[str, int] = {}
    for number in sorted(numbers, key=lambda each: sites[each].location):
        first.setdefault(sites[number].function, number)
    return frozenset(first.values())


def _function(
    sites: _Sites, unused: _Unused, file: str | None, name: str, programs: Sequence[DebugProgram]
) -> BreakpointLocation:
    statements, location = {}, None
    for robot, rows in sites.items():
        numbers = [
            number
            for number, site in rows.items()
            if plain_name(site.function) == name
            and (file is None or is_file(site.location.file, file))
        ]
        statements[robot] = _firsts(rows, numbers)
        for number in statements[robot]:
            location = location or rows[number].location
    if location is not None:
        return BreakpointLocation(statements, frozenset(), location, name)
    for function, place in unused:
        if function == name and (file is None or is_file(place.file, file)):
            return _never(sites, name, place)
    if name in POSTS and file is None:
        return BreakpointLocation({}, POSTS[name], None, name)
    calls = {robot: calling(programs[robot], name) for robot in sites}
    if file is None and any(calls.values()):
        return BreakpointLocation(
            calls, frozenset(), None, name, f"stops before each statement that calls '{name}'"
        )
    names = sorted(
        {function for function, _ in unused}
        | {plain_name(each.function) for rows in sites.values() for each in rows.values()}
    )
    raise DebugError(unknown("function", name, names))


def is_file(file: str, wanted: str) -> bool:
    """Return whether a name refers to a file: its whole path, or the end of it."""
    parts, own = PurePath(displayed(wanted)).parts, PurePath(displayed(file)).parts
    return bool(parts) and own[-len(parts) :] == parts


def calling(program: DebugProgram, name: str) -> frozenset[int]:
    """Return the numbers of the user's statements that call a function by its name.

    A function of the C library has no statements of its own, so a breakpoint on it stops before
    each of these, whether or not the call is evaluated.
    """
    detail = program.executable.detail()
    sites = {(site.function, site.location): number for number, site in detail.compiled.breakable()}
    return frozenset(
        sites[function.name, place]
        for function in detail.program.functions.values()
        if not in_library(function.location)
        for place in _places(function, name)
        if (function.name, place) in sites
    )


def _places(function: Function, name: str) -> Iterator[Location]:
    """Return the locations of a function's statements that call another one."""
    entry = function.blocks[0]
    begun: dict[Block, Location | None] = {entry: None}
    waiting = [entry]
    while waiting:
        block = waiting.pop()
        place = begun[block]
        for instruction in block.instructions:
            if isinstance(instruction, Statement):
                place = instruction.location
        end = block.terminator
        callee = end.callee if isinstance(end, Call) else None
        if isinstance(callee, str) and plain_name(callee) == name and place is not None:
            yield place
        for follower in block.successors():
            if follower not in begun:
                begun[follower] = place
                waiting.append(follower)
