"""`docs/language.md` lists each feature of C with the case of this folder that shows it."""

from __future__ import annotations

import re

from docs.generate import template
from tests.c.execution import HERE

ROWS = re.findall(r"\{\{case (\S+?)( unsupported)?\}\}", template("language"))
CASES = [case for case, _ in ROWS]


def test_every_feature_names_a_case_that_exists() -> None:
    assert CASES
    for case in CASES:
        assert (HERE / f"{case}.c").exists(), case


def test_every_folder_of_valid_cases_is_on_the_page() -> None:
    named = {case.split("/")[1] for case in CASES}
    folders = {path.name for path in (HERE / "valid").iterdir() if path.is_dir()}
    whole_programs = {"programs"}
    elsewhere = {"bits", "enums", "library", "memory", "pointers", "sizeof", "stdlib", "strings"}
    assert folders - named <= whole_programs | elsewhere


def test_only_refused_cases_are_unsupported() -> None:
    unsupported = {case for case, mark in ROWS if mark}
    assert unsupported
    assert {case.split("/")[0] for case in unsupported} == {"refused"}
