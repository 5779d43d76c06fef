"""Breakpoint conditions that programs test themselves, so that false ones cause no stop.

A program that tests a condition stops where it may be true; the debugger then evaluates it as ever.
So what can be translated changes the time that a run takes, and nothing else.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Final

from crs_cc.debug.data.expression_compiler import Use
from crs_cc.debug.data.scope import Storage
from crs_cc.debug.errors import DebugError
from crs_cc.debug.view import View
from crs_cc.runtime.codegen.condition_code import PassedVariable, condition_code, site_tests
from crs_cc.runtime.compiled import Compiled
from crs_cc.runtime.executable import Executable
from crs_cc.runtime.site_tests import SiteTests
from crs_cc.runtime.sites import StatementSite
from crs_cc.runtime.wasm import Code

Conditions = Mapping[int, tuple[str, ...]]
"""By the number of a site the conditions, one of which is to be true for the program to stop."""

Key = tuple[tuple[int, tuple[str, ...]], ...]
"""The same, to look it up."""

_MAX_CACHED: Final = 64
"""So many sets of conditions are kept compiled."""


class ConditionTests:
    """Has programs test the conditions of breakpoints."""

    def __init__(self, view: View) -> None:
        self._view = view
        self._made: dict[tuple[int, Key], tuple[Executable, SiteTests | None]] = {}

    def set(self, robot: int, conditions: Conditions) -> None:
        """Make a robot's program test the conditions of its breakpoints itself, where it can."""
        if not conditions:
            return
        fleet = self._view.session.fleet
        executable = fleet.executable(robot)  # kept, too, so that no other one gets its id
        key = id(executable), tuple(sorted(conditions.items()))
        if key not in self._made:
            if len(self._made) >= _MAX_CACHED:
                self._made.clear()
            self._made[key] = executable, self._compiled(robot, conditions)
        _, tests = self._made[key]
        if tests is not None:
            fleet.set_tests(robot, tests)

    def _compiled(self, robot: int, conditions: Conditions) -> SiteTests | None:
        compiled = self._view.session.fleet.executable(robot).detail().compiled
        codes: dict[int, Code] = {}
        for number, texts in sorted(conditions.items()):
            code = self._code(robot, compiled, compiled.statements[number], texts)
            if code is not None:
                codes[number] = code
        return site_tests(codes, checked=compiled.checked) if codes else None

    def _code(
        self, robot: int, compiled: Compiled, site: StatementSite, texts: tuple[str, ...]
    ) -> Code | None:
        either = " || ".join(f"({text})" for text in texts)
        try:
            evaluator = self._view.evaluator(robot)
            prepared = evaluator.prepared(f"!!({either})", site.function, site.location)
        except DebugError:
            return None
        uses = [each for each in prepared.uses if isinstance(each, Use) and not each.inside]
        passed = list(_passed([each.storage for each in uses], compiled, site))
        if len(passed) < len(prepared.uses):
            return None
        function, addresses = prepared.compiled.function, compiled.addresses
        return condition_code(function, passed, addresses, checked=compiled.checked)


def _passed(
    variables: list[Storage], compiled: Compiled, site: StatementSite
) -> Iterator[PassedVariable]:
    """Return the locations of variables at a site, except of those without a value."""
    info = compiled.info(site.function)
    unset = [
        info.unset[landing]
        for landing, place in info.landings.items()
        if place == site.location and landing in info.unset
    ]
    for each in variables:
        flag = None
        if each.register is not None:
            if not each.is_visible(site.location) or any(each.register in some for some in unset):
                continue
            flag = each.flag
        in_register = each.register is not None
        yield PassedVariable(each.at, each.in_frame, in_register, flag, each.variable.is_indirect)
