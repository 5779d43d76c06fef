"""The C library that programs are linked with: the units of the package, and those of devices."""

from __future__ import annotations

import functools
from pathlib import Path
from typing import Final

from crs_cc.frontend.preprocess.options import Options
from crs_cc.session.device_library import (
    defines,
    device_headers,
    device_sources,
    source,
    units,
)
from crs_cc.toolchain import library as own
from crs_cc.toolchain.library import AddedUnit, CachedLibrary

SOURCES: Final = own.SOURCES
HEADERS: Final = own.HEADERS


def library_options(
    include_paths: tuple[Path, ...] = (),
    defines: tuple[str, ...] = (),
    undefines: tuple[str, ...] = (),
    standard: str = "gnu17",
    root: Path | None = None,
    *,
    named_from: Path | None = None,
) -> Options:
    """Return the options of a program that uses the library's headers; see `Options`."""
    macros = defines, undefines
    generated = device_headers()
    return Options(
        include_paths,
        (HEADERS,),
        *macros,
        standard=standard,
        root=root,
        named_from=named_from,
        generated=generated,
    )


@functools.cache
def library() -> CachedLibrary:
    """Return the library of this process."""
    added = {
        unit: AddedUnit(
            source(device),
            tuple(each.name for each in device.functions),
            defines(device),
            device_sources(),
        )
        for unit, device in units().items()
    }
    return CachedLibrary(device_headers(), added)
