"""Settings with which programs compile soon: most programs of tests run once.

As a script, it runs a module with them: `python tests/fast_settings.py MODULE`.
"""

from __future__ import annotations

import runpy
import sys

import wasmtime
from wasmtime import _bindings

from crs_cc.runtime import executable

USERS_SETTINGS = executable.settings


def baseline_settings() -> wasmtime.Config:
    """Return settings that compile in an eighth of the time, to slower code."""
    config = USERS_SETTINGS()
    # The Python API does not name this compiler. The enumeration counts from 1, C from 0.
    winch = _bindings.wasmtime_strategy_enum.WASMTIME_STRATEGY_WINCH
    _bindings.wasmtime_config_strategy_set(config.ptr(), winch.value - 1)
    config.wasm_threads = True  # shared memories are off without it
    return config


def unoptimized_settings() -> wasmtime.Config:
    """Return settings that compile in half the time, to slower code with larger frames."""
    config = USERS_SETTINGS()
    config.cranelift_opt_level = "none"
    single_pass = _bindings.wasmtime_regalloc_algorithm_enum.WASMTIME_REGALLOC_SINGLE_PASS
    # The members of the enumeration count from 1, C's from 0.
    _bindings.wasmtime_config_cranelift_regalloc_algorithm_set(config.ptr(), single_pass.value - 1)
    return config


def fast_settings() -> wasmtime.Config:
    """Return the settings that compile fastest on this processor: Winch knows only some."""
    try:
        wasmtime.Engine(baseline_settings())  # which takes the settings
    except wasmtime.WasmtimeError:
        return unoptimized_settings()
    return baseline_settings()


if __name__ == "__main__":
    executable.settings = fast_settings
    runpy.run_module(sys.argv[1], run_name="__main__", alter_sys=True)
