"""What quick runs take, and how the table of times is renewed."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests import commands, quick, times

pytest_plugins = ["pytester"]


def test_what_the_table_does_not_list_is_cheap() -> None:
    assert quick.chosen(["a.py::new", "a.py::slow"], {"a.py::slow": 9.0}, 1.0) == {"a.py::new"}


def test_each_file_has_its_turn() -> None:
    tests = [f"{file}.py::{test}" for file in "ab" for test in ("u", "v", "w")]
    two_more = 4.5 * quick.UNLISTED_S
    assert quick.chosen(tests, {}, two_more) == {"a.py::u", "a.py::v", "b.py::u", "b.py::v"}


def test_every_file_is_represented_by_its_cheapest_test_that_ends_soon() -> None:
    table = {"a.py::x": 3.0, "a.py::y": 0.2, "b.py::z": 30.0, "b.py::z[1]": 0.2, "c.py::z": 10.0}
    tests = ["a.py::x", "a.py::y", "b.py::z[0]", "b.py::z[1]", "c.py::z"]
    assert quick.chosen(tests, table, 0.0) == {"a.py::y", "b.py::z[1]"}


def test_one_of_each_function_and_folder_comes_before_a_second_one() -> None:
    tests = [f"a.py::f[valid/{each}]" for each in ("x/1", "x/2", "y/1", "y/2")]
    tests += ["a.py::g[1]", "a.py::g[2]", "a.py::free"]
    table = {"a.py::f": 0.25, "a.py::g": 0.5}
    first = {"a.py::free", "a.py::f[valid/x/1]", "a.py::f[valid/y/1]", "a.py::g[1]"}
    used_s = 1.01 + quick.UNLISTED_S
    assert quick.chosen(tests, table, used_s) == first
    assert quick.chosen(tests, table, used_s + 0.25) == first | {"a.py::f[valid/x/2]"}


def test_classes_are_kept_while_they_fit() -> None:
    assert times.class_of(0.25) == 0.3
    assert times.class_of(0.12, 0.3) == 0.3
    assert times.class_of(0.8, 0.3) == 0.3
    assert times.class_of(0.1, 0.3) == 0.1
    assert times.class_of(0.9, 0.3) == 1.0


def test_a_renewed_table_has_what_ran_and_keeps_the_other_files() -> None:
    old = {"a.py::gone": 3.0, "b.py::other": 1.0}
    measured = {"a.py::cheap": 0.04, "a.py::f[0]": 1.0, "a.py::f[1]": 1.1, "a.py::f[2]": 9.0}
    assert times.renewed(old, measured) == {"b.py::other": 1.0, "a.py::f": 1.0, "a.py::f[2]": 10.0}


def test_the_table_is_read_as_it_was_written(tmp_path: Path) -> None:
    rows = {"a.py::test_x[a b-1]": 0.03, "b.py::test_y": 10.0}
    times.write(rows, tmp_path / "times.txt")
    assert times.read(tmp_path / "times.txt") == rows


def test_a_run_measures_the_processor_time_of_each_test(
    pytester: pytest.Pytester, monkeypatch: pytest.MonkeyPatch
) -> None:
    table = pytester.path / "times.txt"
    monkeypatch.delenv("PYTEST_XDIST_WORKER", raising=False)
    monkeypatch.setattr(commands, "_servers", [])  # other workers' forks would count, too
    old = {"test_a.py::test_skipped": 3.0, "test_a.py::test_gone": 3.0, "test_z.py::t": 1.0}
    times.write(old, table)
    pytester.makepyfile(
        test_a="""
        import subprocess, sys, time, pytest
        BUSY = "import time\\nwhile time.process_time() < 0.7: pass"
        def test_waits(): time.sleep(0.6)
        def test_works(): subprocess.run([sys.executable, "-c", BUSY])
        def test_skipped(): pytest.skip("today")
        """,
        test_b="""
        import time, pytest
        def work():
            end_s = time.process_time() + 0.3
            while time.process_time() < end_s: pass
        @pytest.fixture(scope="module")
        def made():
            work()
        @pytest.fixture(scope="module")
        def ended():
            yield
            work()
        def test_makes(made): pass
        def test_uses(made): pass
        def test_begins(ended): pass
        def test_ends(ended): pass
        """,
    )
    pytester.inline_run("-p", "no:cacheprovider", plugins=[times.Recorder(table)])
    rows = times.read(table)
    shared = {f"test_b.py::test_{each}" for each in ("makes", "uses", "begins", "ends")}
    assert rows.keys() == {"test_a.py::test_works", "test_a.py::test_skipped", *shared}
    assert rows["test_a.py::test_skipped"] == 3.0
