"""C files of the simulation as a program that computes for it, from the cache if possible."""

from __future__ import annotations

from pathlib import Path

from crs_cc.core.errors import InternalError
from crs_cc.core.source import Diagnostics
from crs_cc.runtime.executable import Executable, code_format, load_executable
from crs_cc.toolchain import cache


def build_kernels(folder: Path, *, checked: bool = False) -> Executable:
    """Compile and link the C files of a folder, one of which defines `__crs_start`.

    Args:
        folder: the folder, whose headers they can include.
        checked: check every access through a pointer, for tests.

    Raises:
        InternalError: they are not a valid program.
    """
    files = sorted(folder.glob("*.[ch]"))
    texts = [part for file in files for part in (file.name, file.read_text("utf-8"))]
    name = cache.key("kernels", texts, str(checked), code_format())
    machine_code = cache.load(name, bytes)
    if machine_code:
        known = load_executable(
            str(folder), folder.name, machine_code, lambda: _compile(folder, checked=True).detail()
        )
        if known:
            return known
    made = _compile(folder, checked=checked)
    cache.store(name, made.machine_code)
    return made


def _compile(folder: Path, *, checked: bool) -> Executable:
    # Not needed if the code is in the cache.
    from crs_cc.core.gc_pause import gc_paused
    from crs_cc.frontend.preprocess.options import Options
    from crs_cc.ir.names import LIBRARY
    from crs_cc.runtime.executable import make_executable
    from crs_cc.runtime.link import link
    from crs_cc.toolchain.library import HEADERS, CachedLibrary, compile_bundled

    options = Options(system_paths=(HEADERS, folder))
    with gc_paused():
        units = [
            compile_bundled(file.read_text("utf-8"), f"{LIBRARY}{folder.name}/{file.name}", options)
            for file in sorted(folder.glob("*.c"))
        ]
        diagnostics = Diagnostics()
        program = link(units, CachedLibrary(), diagnostics)
        if diagnostics.errors:
            raise InternalError(diagnostics.messages)
        return make_executable(program, str(folder), command=folder.name, checked=checked)
