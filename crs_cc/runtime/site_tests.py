"""Conditions that programs test at sites marked `TEST`, to decide whether to stop there.

They are in a module of their own, an instance of which is put into the table of a sandbox: builds
know nothing of the conditions that a user thinks of. See `codegen.stop_marks`.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Final

import wasmtime

from crs_cc.requests import SUSPENDED

STOP: Final = SUSPENDED
TEST: Final = 4
"""The marks of a site; they are the program's status until the test has been made."""

UNPASSED: Final = 128
"""Added to the mark of a site until the program passes it, with any mark or none."""


@dataclass(frozen=True, slots=True)
class SiteTests:
    """The tests of some sites of a build.

    Attributes:
        sites: the numbers of the sites.
        module: their functions, exported by the numbers of the sites.
    """

    sites: tuple[int, ...]
    module: wasmtime.Module


@dataclass(slots=True)
class ConditionTable:
    """The table of the conditions that a sandbox tests.

    Attributes:
        table: the table.
        memories: what the tests import.
    """

    table: wasmtime.Table
    memories: list[wasmtime.Memory]
    _filled: SiteTests | None = field(default=None, repr=False)

    def lacks(self, tests: SiteTests) -> bool:
        """Return whether it does not have these tests now."""
        return self._filled is not tests

    def fill(self, store: wasmtime.Store, tests: SiteTests) -> None:
        """Fill it with an instance of some tests."""
        own = wasmtime.Instance(store, tests.module, self.memories).exports(store)
        missing = max(tests.sites) + 1 - self.table.size(store)
        if missing > 0:
            self.table.grow(store, missing, None)
        for site in tests.sites:
            self.table.set(store, site, own[str(site)])
        self._filled = tests
