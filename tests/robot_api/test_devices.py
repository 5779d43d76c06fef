"""`crs.h`, its table, the library and the tests agree with each other."""

from __future__ import annotations

import re
from pathlib import Path

from crs_cc.requests import REQUESTS
from crs_cc.robot_api.device import DEVICE_GROUPS
from crs_cc.session.device_library import device_groups, device_headers, source
from crs_cc.session.library import HEADERS, SOURCES, library
from crs_cc.sim.model.registry import devices

ROOT = Path(__file__).parents[2]
GROUPS = (*device_groups(), *DEVICE_GROUPS)
FUNCTIONS = [function for group in GROUPS for function in group.functions]
HEADER = re.sub(
    r"/\*.*?\*/",
    "",
    device_headers()[0][1] + (HEADERS / "crs.h").read_text(),
    flags=re.DOTALL,
)


def test_header_and_table_declare_the_same_functions() -> None:
    declared = re.findall(r"^[\w ]+ \**\w+\([^;{}]*\)(?=;)", HEADER, re.MULTILINE)
    assert [" ".join(each.split()) for each in declared] == [each.prototype for each in FUNCTIONS]


def test_library_defines_functions_and_posts_requests_of_table() -> None:
    for function in FUNCTIONS:
        assert library().find(function.name) is not None, function.name
    text = "".join(path.read_text() for path in (SOURCES / "device").glob("*.c"))
    text += "".join(map(source, devices()))
    names = {request.name for request in REQUESTS.values() if request.server == "device"}
    posted = set(re.findall(r"\bCRS_(\w+)", text)) & names
    assert posted == {name for function in FUNCTIONS for name in function.posts} == names


def test_every_function_has_a_test() -> None:
    tests = sorted((ROOT / "tests" / "device").glob("test_*.py"))
    marks = [re.findall(r"mark\.function\(([^)]*)\)", path.read_text()) for path in tests]
    tested = {name for mark in marks for each in mark for name in re.findall(r'"(\w+)"', each)}
    assert tested == {function.name for function in FUNCTIONS}
