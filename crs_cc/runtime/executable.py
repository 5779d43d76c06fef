"""Compiled programs, ready to be instantiated.

All robots of a process share one wasmtime `Engine`, whose settings determine the machine
code; an `Executable` holds that machine code.
"""

from __future__ import annotations

import functools
import mmap
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import PurePath
from typing import TYPE_CHECKING, Any, Final, TypeAlias

import wasmtime
from wasmtime import _bindings

from crs_cc.core.host_system import stack_bytes
from crs_cc.runtime.driver import driver

if TYPE_CHECKING:
    from crs_cc.ir.program import Program
    from crs_cc.runtime.compiled import Compiled

Module: TypeAlias = wasmtime.Module
"""Machine code that is ready to be instantiated."""

Driver: TypeAlias = Module
"""The module that runs a round of a fleet."""

MAX_WASM_STACK = 6 * 2**20
"""Host stack for the deepest recursion [bytes], three times the program's stack.

Every frame is charged for the locals that the host may spill to its stack, see `registers`,
so that the program's stack check fails first. With a small `ulimit -s` the host's stack is smaller
and can overflow before, see `fleet`.
"""

_GUARD: Final = 32 * 2**20 + mmap.PAGESIZE
"""Guard before and after each memory [bytes]: wasmtime's, and a page.

With wasmtime's alone, all memories would lie a power of two apart, and the pages that each program
uses most would compete for the same few entries of the translation lookaside buffer (TLB).
"""


def _host_stack() -> int:
    """Return the limit on the host's stack for programs: three quarters at most [bytes]."""
    limit = stack_bytes()
    return MAX_WASM_STACK if limit is None else min(MAX_WASM_STACK, limit * 3 // 4)


def settings() -> wasmtime.Config:
    """Return the settings of the engine, by which programs run fast."""
    config = wasmtime.Config()
    # The C API rejects a stack above that of asynchronous calls, which the Python API lacks.
    _bindings.wasmtime_config_async_stack_size_set(config.ptr(), _host_stack())
    config.max_wasm_stack = _host_stack()
    config.cranelift_opt_level = "speed"
    _bindings.wasmtime_config_wasm_branch_hinting_set(config.ptr(), True)
    config.shared_memory = True
    config.memory_guard_size = _GUARD
    # Its pool of threads does not exist in a forked child, which would wait for it forever.
    _bindings.wasmtime_config_parallel_compilation_set(config.ptr(), False)
    return config


def engine() -> wasmtime.Engine:
    """Return the engine that all fleets share."""
    return _engine(settings)


@functools.cache
def _engine(settings: Callable[[], wasmtime.Config]) -> wasmtime.Engine:
    return wasmtime.Engine(settings())


def code_format() -> bytes:
    """Return what machine code depends on beside the program, for keys of caches.

    It is the code of an empty module, which states wasmtime's version, the engine's settings and
    the processor's features.
    """
    return _code_format(engine())


@functools.cache
def _code_format(engine: wasmtime.Engine) -> bytes:
    return bytes(wasmtime.Module(engine, b"\0asm\1\0\0\0").serialize())


def compile_driver() -> Driver:
    """Return the module that runs a round of any fleet."""
    return _driver(engine())


@functools.cache
def _driver(engine: wasmtime.Engine) -> Driver:
    return wasmtime.Module(engine, driver())


def load_module(machine_code: bytes) -> Module | None:
    """Return a serialised module; None if this computer cannot run it.

    Machine code is specific to the processor that it was compiled on; the cache may have been moved
    to another, which wasmtime detects.
    """
    try:
        return wasmtime.Module.deserialize(engine(), machine_code)
    except wasmtime.WasmtimeError:
        return None


@dataclass(slots=True)
class Executable:
    """A compiled program.

    Attributes:
        name: the program as the user named it, for messages.
        command: its `argv[0]`, which is a part of its state: no path of this computer, see
            `command_name`.
        machine_code: wasmtime's serialised module.
        detail: returns what only messages and debuggers need, see `Detail`.
    """

    name: str
    command: str
    machine_code: bytes = field(repr=False)  # some 100 KiB
    detail: Callable[[], Detail] = field(repr=False)
    _loaded: tuple[wasmtime.Engine, Module] | None = field(default=None, repr=False)

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle with the detail, which cannot be loaded lazily elsewhere."""
        return _executable, (self.name, self.command, self.machine_code, self.detail())

    def module(self) -> Module:
        """Return the module for the engine in use, loaded on first use.

        Machine code that comes from another kind of processor is made again.
        """
        if self._loaded is None or self._loaded[0] is not engine():
            module = load_module(self.machine_code)
            if module is None:
                module, _ = compile_module(self.detail().compiled.module.to_binary())
            self._loaded = engine(), module
        return self._loaded[1]

    @property
    def has_marks(self) -> bool:
        """Whether it is a debug build, which can stop before statements."""
        return any(export.name == "marks" for export in self.module().exports)

    @property
    def program(self) -> Program:
        """The linked program."""
        return self.detail().program

    def wat(self) -> str:
        """Return the code in WebAssembly's text format."""
        return self.detail().compiled.module.to_text()


def _executable(name: str, command: str, machine_code: bytes, detail: Detail) -> Executable:
    return Executable(name, command, machine_code, lambda: detail)


def command_name(source: str | PurePath) -> str:
    """Return the name by which a program is called, from that of its first C file.

    >>> command_name("samples/scout_c/wander.c")
    'wander'
    """
    return PurePath(source).stem


@dataclass(slots=True)
class Detail:
    """The intermediate forms of a program.

    Attributes:
        program: linked, as IR.
        compiled: as WebAssembly.
        lines: the lines of the user's files, by name.
    """

    program: Program
    compiled: Compiled
    lines: Mapping[str, Sequence[str]]


def load_executable(
    name: str, command: str, machine_code: bytes, detail: Callable[[], Detail]
) -> Executable | None:
    """Load a cached program; return None if this computer cannot run it, see `load_module`."""
    module = load_module(machine_code)
    if module is None:
        return None
    return Executable(name, command, machine_code, detail, (engine(), module))


def compile_module(wasm: bytes) -> tuple[Module, bytes]:
    """Compile WebAssembly for the engine that all fleets share.

    Returns:
        The module, and its machine code.
    """
    module = wasmtime.Module(engine(), wasm)
    return module, bytes(module.serialize())


def make_executable(
    program: Program,
    name: str,
    *,
    command: str = "",
    lines: Mapping[str, Sequence[str]] | None = None,
    module_of: Callable[[bytes], tuple[Module, bytes]] = compile_module,
    checked: bool = True,
    debug: bool = False,
    watching: bool = False,
    trap_overflow: bool = False,
) -> Executable:
    """Compile a linked, verified program.

    Args:
        program: the program.
        name: the program as the user named it.
        command: its `argv[0]`; by default derived from the name, which is that of one file then.
        lines: the lines of the user's files, by name, for messages.
        module_of: compiles WebAssembly as `compile_module` does, or knows the code.
        checked: check every access through a pointer.
        debug: allow breakpoints on every statement.
        watching: compare every access with the watched ranges; in debug builds only.
        trap_overflow: stop at signed overflow, in checked builds.
    """
    from crs_cc.runtime.codegen.module import compile_program

    compiled = compile_program(
        program, checked=checked, debug=debug, watching=watching, trap_overflow=trap_overflow
    )
    module, machine_code = module_of(compiled.module.to_binary())
    detail = Detail(program, compiled, lines or {})
    command = command or command_name(name)
    return Executable(name, command, machine_code, lambda: detail, (engine(), module))
