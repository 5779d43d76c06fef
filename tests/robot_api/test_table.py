"""The table of the vendor's API, the header, the library and the tests agree with each other."""

from __future__ import annotations

import re
from pathlib import Path

from crs_cc.requests import CODES
from crs_cc.robot_api import CONSTANTS, GROUPS, MACROS, SMASK, SOURCES, STATE, TYPES, VARIABLES
from crs_cc.session.library import HEADERS, library
from crs_cc.session.library import SOURCES as LIBRARY

FUNCTIONS = [function for group in GROUPS for function in group.functions]
HEADER = re.sub(r"/\*.*?\*/", "", (HEADERS / "Nclient.h").read_text(), flags=re.DOTALL)
NOT_THE_VENDORS = {"scout_pr", "scout_ws", "sonarSensorCheck"}
"""Names that Scout programs defined themselves, and we declare."""

TESTS = Path(__file__).parents[1] / "nclient"
OTHERS = {"report", "runcode"}
CLIENT = [path for path in (LIBRARY / "robot").glob("*.c") if path.stem not in OTHERS]


def test_vendor_header_declares_103_functions() -> None:
    assert len([function for function in FUNCTIONS if function.declared]) == 103
    assert len({function.name for function in FUNCTIONS}) == len(FUNCTIONS)


def test_header_and_table_declare_the_same_functions() -> None:
    declared = {
        " ".join(prototype.split())
        for prototype in re.findall(r"^[\w ]+ \**\w+\([^;{}]*\)(?=;)", HEADER, re.MULTILINE)
    }
    declared -= {each for each in declared if re.split(r"[ (]", each)[1] in NOT_THE_VENDORS}
    assert declared == {function.prototype for function in FUNCTIONS if function.declared}


def names_and_values(rows: tuple) -> dict[str, int | float]:
    """Return the value of each name, including implicitly numbered ones."""
    values = {}
    for row in rows:
        first, _, last = row.name.partition(" .. ")
        if not last:
            values[first] = float(row.value) if "." in row.value else int(row.value, 0)
            continue
        stem = first.rstrip("0123456789")
        begin, end = int(first[len(stem) :]), int(last[len(stem) :])
        values |= {f"{stem}{n}": int(row.value) + n - begin for n in range(begin, end + 1)}
    return values


def test_header_and_table_have_the_same_constants() -> None:
    defined = re.findall(r"^#define (\w+) +(0x\w+|[\d.]+) *$", HEADER, re.MULTILINE)
    values = {name: float(text) if "." in text else int(text, 0) for name, text in defined}
    assert values == names_and_values((*CONSTANTS, *STATE, *SMASK))


def test_header_and_table_have_the_same_macros() -> None:
    functions = re.findall(r"^#define (\w+\([^)]*\))", HEADER, re.MULTILINE)
    tests = re.findall(r"^#define (POS_\w+_P)\b", HEADER, re.MULTILINE)
    assert {*functions, *tests} == {row.name for row in MACROS}


def test_header_and_table_have_the_same_variables_and_types() -> None:
    declared = re.findall(r"^extern (\w+) (\w+)(?:(\[[^]]*\]))?;", HEADER, re.MULTILINE)
    found = {name: f"{ctype} {size}".strip() for ctype, name, size in declared}
    assert found == {row.name: row.value for row in VARIABLES}
    kinds = dict.fromkeys(re.findall(r"^} (\w+_union);", HEADER, re.MULTILINE), "union")
    kinds |= dict.fromkeys(re.findall(r"^} (\w+Data);", HEADER, re.MULTILINE), "struct")
    kinds |= dict.fromkeys(re.findall(r"^struct (\w+) {", HEADER, re.MULTILINE), "struct")
    assert "typedef unsigned long TimeData;" in HEADER
    kinds["TimeData"] = "unsigned long"
    assert kinds == {row.name: row.value for row in TYPES}


def test_library_defines_all_functions() -> None:
    for name in [*(function.name for function in FUNCTIONS), *(row.name for row in VARIABLES)]:
        assert library().find(name) is not None, name


def test_library_posts_requests_of_table() -> None:
    text = "".join(path.read_text() for path in CLIENT)
    posted = set(re.findall(r"\bCRS_(\w+)", text)) & CODES.keys()
    told = {name for function in FUNCTIONS for name in function.posts}
    assert posted - {"CLIENT", "UNCONNECTED"} == told


def test_every_entry_names_its_source() -> None:
    for function in FUNCTIONS:
        assert set(function.source) <= SOURCES.keys(), function.name


def test_every_function_has_a_test() -> None:
    marks = "".join(
        "".join(re.findall(r"mark\.function\(([^)]*)\)", path.read_text()))
        for path in TESTS.glob("test_*.py")
    )
    tested = set(re.findall(r'"(\w+)"', marks))
    known = {function.name for function in FUNCTIONS} | NOT_THE_VENDORS
    assert tested <= known
    assert known - NOT_THE_VENDORS - tested == set()
