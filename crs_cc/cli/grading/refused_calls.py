"""Calls that only the vendor's simulator answers: they are rejected in submissions.

`place_robot` moves the robot anywhere, `new_world` removes obstacles, and `get_rpx` returns the
true poses. A program may not even contain such a call; one that makes the request in another way is
detected while it runs.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import TYPE_CHECKING, Final

from crs_cc.cli.grading.source_tokens import SourceTokens
from crs_cc.core.source import Location
from crs_cc.ir.names import in_library
from crs_cc.requests import CODES
from crs_cc.robot_api import GROUPS
from crs_cc.robot_api.simulator import WORLD

if TYPE_CHECKING:
    from crs_cc.runtime.executable import Executable

REFUSED: Final = tuple(function.name for function in WORLD.functions)
"""The names of the functions."""


def refused_call(
    files: Sequence[SourceTokens], executable: Executable, allowed: Collection[str]
) -> tuple[str, Location] | None:
    """Return the first refused function that a program uses, and where; None if it uses none."""
    names = set(REFUSED).difference(allowed)
    for file in files:
        for number, token in enumerate(file.tokens):
            if token.text in names and _is_the_librarys(token.text, executable):
                return token.text, file.location(number)
    return None


def refused_codes(allowed: Collection[str]) -> dict[int, str]:
    """Return the requests that only refused functions post, each with its function."""
    others = {
        code
        for group in GROUPS
        for function in group.functions
        if function.name not in REFUSED or function.name in allowed
        for code in function.posts
    }
    return {
        CODES[code]: function.name
        for function in reversed(WORLD.functions)
        for code in function.posts
        if code not in others
    }


def _is_the_librarys(name: str, executable: Executable) -> bool:
    """Return whether a name refers to the library's function, not to one of the program."""
    function = executable.program.functions.get(name)
    return function is not None and in_library(function.location)
