"""The description of a run: all that is needed besides its files to repeat it."""

from __future__ import annotations

import json
import platform
import shlex
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, fields
from importlib.metadata import version
from typing import Any, Final, Self

from crs_cc import __version__
from crs_cc.recording.source_tree import is_safe
from crs_cc.recording.topics import FORMAT_VERSION
from crs_cc.toolchain import cache
from crs_cc.toolchain.fingerprint import WORLDS

PACKAGES: Final = ("numpy", "pymunk", "pycparser", "wasmtime")
"""The packages that take part in a run."""

_MAX_WORDS: Final = 100_000
_MAX_SEED: Final = 2**128


@dataclass(frozen=True, slots=True)
class RunDescription:
    """The command line of a run, with names of attachments for paths.

    Attributes:
        sources: the C files of the program.
        world: the world file; empty for the built-in world.
        arguments: of the program.
        programs: the programs of robots that have others, see `program_row`.
        include_paths: folders for `#include`.
        defines: macros.
        undefines: predefined macros to remove.
        standard: the C standard.
        dialect: the API; empty to detect it.
        checked: whether memory accesses are checked.
        trap_overflow: whether a program stops at signed overflow.
        seed: the random seed.
        client: the vendor's client library.
        link: `serial` or `ideal`.
        robot: the default robot model: a built-in name or a file.
        setup: the setup of all robots.
        files: the names of files that programs can read; their contents are attachments.
        max_time_s: when the run was to end [s]; 0 for never.
        timestep_s: the world's timestep [s].
        frame_s: simulated time between two frames [s].
        for_debugger: whether the hashes of all state are those of programs that were compiled for
            the debugger, whose memory is another.
    """

    sources: tuple[str, ...] = ()
    world: str = ""
    arguments: tuple[str, ...] = ()
    programs: tuple[str, ...] = ()
    include_paths: tuple[str, ...] = ()
    defines: tuple[str, ...] = ()
    undefines: tuple[str, ...] = ()
    standard: str = "gnu17"
    dialect: str = ""
    checked: bool = True
    trap_overflow: bool = False
    seed: int = 0
    client: str = "nclient"
    link: str = "serial"
    robot: str = "scout"
    setup: str = ""
    files: tuple[str, ...] = ()
    max_time_s: float = 0.0
    timestep_s: float = 0.05
    frame_s: float = 0.05
    for_debugger: bool = False

    def metadata(self) -> dict[str, str]:
        """Return it as named strings, with the versions that take part."""
        return {
            "format": str(FORMAT_VERSION),
            "crs": __version__,
            **versions(),
            "run": json.dumps(self._given(), ensure_ascii=True),
        }

    @classmethod
    def of(cls, metadata: Mapping[str, str]) -> Self:
        """Return the description in a recording.

        Raises:
            ValueError: it is of another version, or not valid.
        """
        found = metadata.get("format", "")
        if found != str(FORMAT_VERSION):
            shown, made_by = (
                found[:20] or "none",
                metadata.get("crs", "")[:20] or "of unknown version",
            )
            raise ValueError(
                f"its format is {shown} (this version reads {FORMAT_VERSION});"
                f" it is read by the crs that recorded it, {made_by}"
            )
        try:
            values = json.loads(metadata.get("run", ""))
        except (ValueError, RecursionError):
            raise ValueError("the description of the run is not valid JSON") from None
        known = values if isinstance(values, dict) else {"sources": None}
        made = cls(**{each.name: _value(known, each.name, each.default) for each in fields(cls)})
        made._check()
        return made

    def _given(self) -> dict[str, Any]:
        """Return the values that differ from their defaults, which are part of the format."""
        values = asdict(self)
        return {
            each.name: values[each.name]
            for each in fields(self)
            if values[each.name] != each.default
        }

    def robots_programs(self) -> dict[str, tuple[tuple[str, ...], tuple[str, ...]]]:
        """Return C files and arguments of robots that have programs of their own, by name.

        Raises:
            ValueError: they are not valid.
        """
        return dict(map(_program_of, self.programs))

    def _check(self) -> None:
        paths = [*self.sources, *self.include_paths, *([self.world] if self.world else [])]
        paths += [path for sources, _ in self.robots_programs().values() for path in sources]
        unsafe = [path for path in paths if path != "." and not is_safe(path)]
        if unsafe:
            raise ValueError(f"{unsafe[0][:80]!r} is not a name of a file below a folder")
        if not (1e-6 <= self.timestep_s <= 1e3 and 1e-6 <= self.frame_s <= 1e6):
            raise ValueError("timestep_s or frame_s is out of range")
        if not (0 <= self.seed < _MAX_SEED and 0.0 <= self.max_time_s < 1e12):
            raise ValueError("seed or max_time_s is out of range")


def program_row(robot: str, sources: Sequence[str], arguments: Sequence[str]) -> str:
    """Return the program of a robot as it is written in a shell: robot, C files, arguments.

    >>> program_row("robot0", ["my prog.c"], ["fast", "3"])
    "robot0 'my prog.c' -- fast 3"
    >>> _program_of("robot0 'my prog.c' -- fast 3")
    ('robot0', (('my prog.c',), ('fast', '3')))
    """
    return shlex.join([robot, *sources, "--", *arguments])


def _program_of(row: str) -> tuple[str, tuple[tuple[str, ...], tuple[str, ...]]]:
    robot, *words = shlex.split(row)
    end = words.index("--")
    return robot, (tuple(words[:end]), tuple(words[end + 1 :]))


def versions() -> dict[str, str]:
    """Return versions that may affect a run: Python, the processor type, our sources, packages."""
    return {
        "python": platform.python_version(),
        "machine": platform.machine(),
        "sources": cache.version(WORLDS)[:12],
        **{name: version(name) for name in PACKAGES},
    }


def _value(values: Mapping[str, Any], name: str, default: Any) -> Any:
    """Return a field's value if it has the type of its default."""
    value = values.get(name, default)
    if isinstance(default, tuple):
        is_list = isinstance(value, list | tuple) and len(value) <= _MAX_WORDS
        if is_list and all(isinstance(each, str) for each in value):
            return tuple(value)
    elif isinstance(default, float):
        if isinstance(value, int | float) and not isinstance(value, bool):
            return float(value)
    elif type(value) is type(default):
        return value
    raise ValueError(f"the description of the run has an invalid {name}")
