"""What all tests share: a compiler cache of their own, and the flag that rewrites goldens."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from tests.quick import mark_others_slow

TESTS = Path(__file__).resolve().parent
JUDGED = ["c/valid", "fuzz"]
"""Folders whose `.out` files hold what gcc said."""


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--update-goldens",
        action="store_true",
        help="rewrite expected outputs that differ, and fail once so that the difference is read",
    )


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    mark_others_slow(items)


@pytest.fixture(scope="session", autouse=True)
def compiler_cache(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Keeps what is compiled in a folder of this run, which parallel workers share."""
    folder = tmp_path_factory.getbasetemp()
    if "PYTEST_XDIST_WORKER" in os.environ:
        folder = folder.parent
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("CRS_CACHE", str(folder / "crs_cache"))
        yield


def is_gccs(golden: Path) -> bool:
    """Tells whether a file holds what gcc said, so that our own output must never get into it."""
    folder = golden.resolve().parent
    return golden.suffix == ".out" and any(folder.is_relative_to(TESTS / each) for each in JUDGED)


@pytest.fixture
def check_golden(
    check_gcc_golden: Callable[[Path, bytes], None],
) -> Callable[[Path, bytes], None]:
    """Gives a function that compares our output with the file that holds the expected one."""

    def check(golden: Path, output: bytes) -> None:
        if is_gccs(golden):
            raise ValueError(f"only gcc says what {golden} holds")
        check_gcc_golden(golden, output)

    return check


@pytest.fixture
def check_gcc_golden(request: pytest.FixtureRequest) -> Callable[[Path, bytes], None]:
    """Gives a function that compares gcc's output with the file that holds it."""

    def check(golden: Path, output: bytes) -> None:
        expected = golden.read_bytes() if golden.exists() else b""
        if output != expected and request.config.getoption("--update-goldens"):
            golden.write_bytes(output)
            pytest.fail(f"{golden.name} was rewritten; read the difference, then run again")
        assert output.decode(errors="replace") == expected.decode(errors="replace")

    return check
