"""What all tests share: a compiler cache of their own, and the flag that rewrites goldens."""

from __future__ import annotations

import gc
import os
import signal
import weakref
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from _pytest.doctest import DoctestModule
from _pytest.runner import runtestprotocol

from crs_cc.core.gc_pause import gc_paused
from crs_cc.jobs import pool
from crs_cc.runtime import executable
from crs_cc.runtime.fleet import Fleet
from crs_cc.session import session_state
from tests import commands, fast_settings, quick, times
from tests.fast_settings import USERS_SETTINGS

TESTS = Path(__file__).resolve().parent
collect_ignore = ["without_unix", "debug/gdb_sessions.py"]  # modules for Python's start, and gdb's
JUDGED = ["c/valid", "fuzz"]
"""Folders whose `.out` files hold what gcc said."""

NEW_OBJECTS = 1_000_000
"""How many objects are made before the collector looks at them: of 700, most are still in use."""

USERS_PYTHON = pool.python

CACHE = "crs_cache"
"""The name of the compiler's cache in the temporary folder of the run."""


class Examples:
    """Searches only modules with examples for them: to import and search all takes much longer."""

    @pytest.hookimpl(wrapper=True)
    def pytest_collect_file(self, file_path: Path) -> Iterator[None]:
        collectors = yield
        if file_path.suffix != ".py" or b">>>" in file_path.read_bytes():
            return collectors
        return [each for each in collectors if not isinstance(each, DoctestModule)]


class Results:
    """Reports results only: two of three reports are of setups and teardowns that passed."""

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtest_protocol(self, item: pytest.Item, nextitem: pytest.Item | None) -> bool:
        item.ihook.pytest_runtest_logstart(nodeid=item.nodeid, location=item.location)
        for report in runtestprotocol(item, log=False, nextitem=nextitem):
            if report.when == "call" or not report.passed:
                item.ihook.pytest_runtest_logreport(report=report)
        item.ihook.pytest_runtest_logfinish(nodeid=item.nodeid, location=item.location)
        return True


def is_measuring(config: pytest.Config) -> bool:
    """Return whether pytest writes down how long setups and teardowns take."""
    return config.getoption("--durations") is not None or bool(config.getoption("--junit-xml"))


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--update-goldens",
        action="store_true",
        help="rewrite expected outputs that differ, and fail once so that the difference is read",
    )
    parser.addoption(
        "--quick", action="store_true", help="run the quick tests only, see tests/quick.py"
    )
    parser.addoption(
        "--update-times", action="store_true", help="measure all tests and renew tests/times.txt"
    )
    parser.addoption(
        "--real-processes", action="store_true", help="start each command anew, without forks"
    )


def pytest_configure(config: pytest.Config) -> None:
    # A shell's job in the background ignores it, and so would all commands that tests interrupt.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    # Most programs of tests run once. What users get is shown by the commands of quick
    # runs, and by those that are not forks.
    executable.settings = fast_settings.fast_settings
    # Quick runs start too few commands for a process that imports all to be worth its time.
    commands.real |= config.getoption("--real-processes") or config.getoption("--quick")
    if not config.getoption("--real-processes"):
        pool.python = commands.fast_module
    shared = getattr(config, "workerinput", {}).get("server")
    if shared:
        commands.share(*shared)
    gc.set_threshold(NEW_OBJECTS)
    config.pluginmanager.register(Examples())
    if config.getoption("--update-times"):
        config.pluginmanager.register(times.Recorder())
    elif "PYTEST_XDIST_WORKER" in os.environ and not is_measuring(config):
        config.pluginmanager.register(Results())


@pytest.hookimpl(optionalhook=True)
def pytest_configure_node(node: Any) -> None:
    """Let workers share one server; workers that measure times have their own."""
    if not commands.real and not node.config.getoption("--update-times"):
        forks = commands.server(node.config._tmp_path_factory.getbasetemp() / CACHE)
        node.workerinput["server"] = forks.address, forks.process


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    if config.getoption("--quick"):
        taken = quick.chosen([item.nodeid for item in items], times.read(times.TABLE))
        others = [item for item in items if item.nodeid not in taken]
        items[:] = [item for item in items if item.nodeid in taken]
        config.hook.pytest_deselected(items=others)


@pytest.hookimpl(wrapper=True)
def pytest_runtest_teardown(item: pytest.Item, nextitem: pytest.Item | None) -> Iterator[None]:
    yield
    if nextitem is not None and nextitem.path == item.path:  # may be with what all of a file share
        return
    changed = commands.left_behind()
    if changed:
        pytest.fail(f"tests of this file have left behind what later ones would meet: {changed}")


def pytest_collection_finish() -> None:
    gc.freeze()  # modules and tests stay until the end: collections need not go through them


@pytest.hookimpl(trylast=True)
def pytest_unconfigure() -> None:
    gc.freeze()  # pytest has looked for what fails when it is freed, and looks again


@pytest.fixture(scope="session", autouse=True)
def compiler_cache(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Keeps what is compiled in a folder of this run, which parallel workers share.

    What users keep, settings and commands typed before, is not touched.
    """
    folder = tmp_path_factory.getbasetemp()
    if "PYTEST_XDIST_WORKER" in os.environ:
        folder = folder.parent
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("CRS_CACHE", str(folder / CACHE))
        for name in ("CONFIG", "STATE"):
            patch.setenv(f"XDG_{name}_HOME", str(folder / "home"))
        yield


@pytest.fixture
def users_settings(monkeypatch: pytest.MonkeyPatch) -> None:
    """Compile as for users, for programs that recurse so deeply that the host's stack matters."""
    monkeypatch.setattr(executable, "settings", USERS_SETTINGS)


@pytest.fixture
def users_workers(monkeypatch: pytest.MonkeyPatch) -> None:
    """Start processes that run jobs as for users, where a test looks at or kills such a process."""
    monkeypatch.setattr(pool, "python", USERS_PYTHON)


@pytest.fixture
def fleets(monkeypatch: pytest.MonkeyPatch) -> Iterator[list[weakref.ref[Fleet]]]:
    """All fleets that are made from now on, while the garbage collector is off.

    A fleet has the programs of its run, which are large: what has ended must let go of it.
    """
    made: list[weakref.ref[Fleet]] = []

    def make(*arguments: Any) -> Fleet:
        fleet = Fleet(*arguments)
        made.append(weakref.ref(fleet))
        return fleet

    monkeypatch.setattr(session_state, "Fleet", make)
    with gc_paused():
        yield made


def is_gccs(golden: Path) -> bool:
    """Return whether a file holds what gcc said, so that our own output must never get into it."""
    folder = golden.resolve().parent
    return golden.suffix == ".out" and any(folder.is_relative_to(TESTS / each) for each in JUDGED)


@pytest.fixture
def check_golden(
    check_gcc_golden: Callable[[Path, bytes], None],
) -> Callable[[Path, bytes], None]:
    """Return a function that compares our output with the file that holds the expected one."""

    def check(golden: Path, output: bytes) -> None:
        if is_gccs(golden):
            raise ValueError(f"only gcc says what {golden} holds")
        check_gcc_golden(golden, output)

    return check


@pytest.fixture
def check_gcc_golden(request: pytest.FixtureRequest) -> Callable[[Path, bytes], None]:
    """Return a function that compares gcc's output with the file that holds it."""

    def check(golden: Path, output: bytes) -> None:
        expected = golden.read_bytes() if golden.exists() else b""
        if output != expected and request.config.getoption("--update-goldens"):
            golden.write_bytes(output)
            pytest.fail(f"{golden.name} was rewritten; read the difference, then run again")
        assert output.decode(errors="replace") == expected.decode(errors="replace")

    return check
