"""`crs.h`, its table, the library, the tests and the page agree with each other."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from pathlib import Path

from crs_cc.requests import REQUESTS
from crs_cc.robot_api.device import DEVICE_GROUPS
from crs_cc.session.library import HEADERS, SOURCES, library
from tests.robot_api.test_page import cell

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "crs-h.md"
FUNCTIONS = [function for group in DEVICE_GROUPS for function in group.functions]
HEADER = re.sub(r"/\*.*?\*/", "", (HEADERS / "crs.h").read_text(), flags=re.DOTALL)

INTRODUCTION = """\
<!-- made by tests/robot_api/test_devices.py of crs_cc/robot_api/device.py; edit there,
     then pytest --update-goldens -->

# crs.h

Robots have devices here that the vendor's robots did not have. A control program includes `crs.h`,
beside `Nclient.h` or in the report's dialect, and calls the functions below. Lengths are in 0.1
inch, angles in 0.1 degree, counter-clockwise.

A function gives TRUE (1), or FALSE (0) when the robot has no such device, unless the table says
otherwise. No connection is needed. A call takes the time of a message on the network, 1 ms.
"""


def test_header_and_table_declare_the_same_functions() -> None:
    declared = re.findall(r"^[\w ]+ \**\w+\([^;{}]*\)(?=;)", HEADER, re.MULTILINE)
    assert [" ".join(each.split()) for each in declared] == [each.prototype for each in FUNCTIONS]


def test_the_library_defines_them_and_posts_what_the_table_says() -> None:
    for function in FUNCTIONS:
        assert library().find(function.name) is not None, function.name
    text = "".join(path.read_text() for path in (SOURCES / "device").glob("*.c"))
    names = {request.name for request in REQUESTS.values() if request.server == "device"}
    posted = set(re.findall(r"\bCRS_(\w+)", text)) & names
    assert posted == {name for function in FUNCTIONS for name in function.posts} == names


def test_every_function_has_a_test() -> None:
    tests = sorted((ROOT / "tests" / "device").glob("test_*.py"))
    marks = [re.findall(r"mark\.function\(([^)]*)\)", path.read_text()) for path in tests]
    tested = {name for mark in marks for each in mark for name in re.findall(r'"(\w+)"', each)}
    assert tested == {function.name for function in FUNCTIONS}


def tables() -> Iterator[str]:
    """Gives a table for each group of functions."""
    for group in DEVICE_GROUPS:
        yield f"\n## {group.title}\n"
        yield "| function | units | does |"
        yield "| --- | --- | --- |"
        for each in group.functions:
            does = f"{each.does}; waits {each.waits}" if each.waits else each.does
            columns = (f"`{each.prototype}`", each.units, f"{does}. {each.chosen}".rstrip(". "))
            yield f"| {' | '.join(map(cell, columns))} |"


def test_the_page_is_as_the_table(check_golden: Callable[[Path, bytes], None]) -> None:
    check_golden(PAGE, (INTRODUCTION + "\n".join(tables()) + "\n").encode())
