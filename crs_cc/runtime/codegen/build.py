"""The options of a build."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Build:
    """The build options, see `module.compile_program`.

    `watch` is the index of the function to which accesses are reported, 0 for none.
    """

    checked: bool
    debug: bool
    watch: int
    trap_overflow: bool
