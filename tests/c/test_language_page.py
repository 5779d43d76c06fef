"""Writes `docs/language.md`: each feature of C, accepted or refused, with the case that shows it.

The features are those of `language.py`; what a case shows is the comment in its first line.
`--update-goldens` rewrites the page.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

from tests.c.execution import HERE
from tests.c.language import FEATURES

PAGE = HERE.parents[1] / "docs" / "language.md"

INTRODUCTION = """\
<!-- made by tests/c/test_language_page.py; edit there, then pytest --update-goldens -->

# The language

crs compiles C17, and what programs of the 1990s and of today use of gnu89 and GNU C, to a sandboxed
program that behaves as `gcc -m32 -malign-double` makes it: `int`, `long` and pointers have 32 bits,
`char` is signed, bytes come lowest first, a `double` is aligned to 8.

What C leaves open is settled, the same on every machine:

- Operands are evaluated in the order of gcc without optimisation: mostly from left to right, but
  arguments from the last to the first, and the right side of a compound assignment before the left.
- Signed arithmetic wraps around; `--trap-overflow` stops it instead. Shifts by a count that is out
  of range, divisions by zero and the other mistakes in `errors.md` stop the program.
- Floating numbers are IEEE 754, `float` in 32 bits and `double` in 64, without excess precision;
  they round to nearest. `long double` is a `double`: it has 8 bytes, where gcc has 12.
- A cast of a number that is out of an integer's range gives what the x86 gives.
- Pointers may be cast to any type and back; types do not forbid two pointers to the same place
  (`-fno-strict-aliasing`).
- An enumeration without negative constants is unsigned, as gcc has it.
- `-std=` chooses `__STDC_VERSION__`, `__STRICT_ANSI__`, the names `linux`, `unix` and `i386`, and
  with them trigraphs; the language is the same in all. `__GNUC__` is not defined, so that programs
  take the way without assembler.

Each feature below names a case in `tests/c` that shows it. Every valid case prints what gcc made it
print; it runs whole and in small steps, moved from one sandbox to another, with and without checks,
and does the same each time. `make fuzz` compares random programs with gcc.
"""

STATUS = {"valid": "yes", "warned": "with a warning", "refused": "refused"}


def shown_by(case: str) -> str:
    """Gives what a case says about itself in its first comment."""
    text = (HERE / f"{case}.c").read_text(encoding="utf-8", errors="replace")
    match = re.match(r"/\*\s*(.*?)\s*\*/", text, re.DOTALL)
    said = " ".join(match[1].split()) if match else ""
    return said.replace("|", "\\|").removesuffix(".")


def page() -> str:
    """Gives the text of the page."""
    lines = [INTRODUCTION]
    for section, features in FEATURES.items():
        lines += [f"## {section}", "", "| feature | accepted | shown by |", "| --- | --- | --- |"]
        for feature, case in features.items():
            said = shown_by(case)
            link = f"[{case}](../tests/c/{case}.c)"
            status = STATUS[case.split("/")[0]]
            lines.append(f"| {feature} | {status} | {link}{': ' if said else ''}{said} |")
        lines.append("")
    return "\n".join(lines)


def test_the_page_of_the_language_is_up_to_date(
    check_golden: Callable[[Path, bytes], None],
) -> None:
    check_golden(PAGE, page().encode())


def test_every_feature_names_a_case_that_exists() -> None:
    for features in FEATURES.values():
        for case in features.values():
            assert (HERE / f"{case}.c").exists(), case


def test_every_folder_of_valid_cases_is_on_the_page() -> None:
    named = {case.split("/")[1] for features in FEATURES.values() for case in features.values()}
    folders = {path.name for path in (HERE / "valid").iterdir() if path.is_dir()}
    whole_programs = {"programs"}
    elsewhere = {"bits", "enums", "library", "memory", "pointers", "sizeof", "stdlib", "strings"}
    assert folders - named <= whole_programs | elsewhere
