"""What a caller can choose for the preprocessor, named after the options of `cc`.

>>> Options(defines=("DEBUG", "SPEED=200", "TWICE(x)=((x)*2)")).defines[1]
'SPEED=200'
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True, slots=True)
class Options:
    """Where headers are and what is defined before the first line.

    Attributes:
        include_paths: folders of the user's headers, in the order of search (`-I`).
        system_paths: folders of the headers that come with crs_cc, searched last.
        defines: macros to define, as `NAME`, `NAME=value` or `NAME(a)=value` (`-D`).
        undefines: names to undefine after that (`-U`).
        trusted: whether the file is the allocator, see `ir.program.Function`.
    """

    include_paths: tuple[Path, ...] = ()
    system_paths: tuple[Path, ...] = ()
    defines: tuple[str, ...] = ()
    undefines: tuple[str, ...] = ()
    trusted: bool = False
