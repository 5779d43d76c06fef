"""Writes `docs/errors.md`: what stops a program, each with a case of `errors/` and its report.

`--update-goldens` rewrites the page, as it does the reports. The example of a kind is its first
case, or the one whose opening comment begins with `Example:`.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

from crs_cc.requests import ERROR_KINDS
from tests.c.execution import HERE, cases, expected_errors

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "errors.md"

INTRODUCTION = """\
<!-- made by tests/c/test_errors_page.py; edit there, then pytest --update-goldens -->

# Errors while running

Every program is checked while it runs. What C leaves undefined, and what real programs do by
mistake, stops the robot with a report and exit status 123; other robots go on. The report says
where, shows the line with the failing expression underlined, the values of the variables in it,
the object that is concerned, and the calls that led there, the innermost first.

`crs run --json` gives the same as data. `--unchecked` leaves the checks of memory out.

Each example below is a file of `tests/c/errors`.
"""

MEANING = {
    "null pointer": "The program follows a pointer that is null, or nearly so: a member or an "
    "element of what is not there.",
    "pointer outside memory": "The program follows a pointer to where it has no memory at all.",
    "wild pointer": "The program follows a pointer into its memory, but to no object.",
    "out of bounds": "An access lies before, behind, or half behind an array, a variable, or a "
    "block of the heap. An index too large within one struct, which hits another of its members, "
    "is not found, nor is writing to a string literal.",
    "use after free": "The program uses a block of the heap that it has given back.",
    "use after scope": "The program uses a variable of a block that has ended.",
    "use after return": "The program uses a variable of a function that has returned.",
    "uninitialised read": "A value that nobody has set decides a branch, an address or an "
    "output, or is passed on as an argument or a result.",
    "invalid free": "`free` or `realloc` gets a pointer that no allocation gave.",
    "double free": "A block of the heap is given back a second time.",
    "missing argument": "`va_arg`, or a format, asks for an argument that was not passed.",
    "no value returned": "A function ends without `return`, and its caller uses the value.",
    "mismatched call": "A call goes through a pointer to a function that would misread its "
    "arguments.",
    "shift out of range": "A shift by a negative count, or by the width of the type or more.",
    "signed overflow": "The result of signed arithmetic does not fit; only with "
    "`--trap-overflow`, otherwise it wraps around.",
    "division by zero": "`/` or `%` with a divisor of zero. Floating division is no error.",
    "division overflow": "The smallest integer divided by -1, which has no place in its type.",
    "bad function pointer": "A call through a pointer that is null, or no pointer to a function.",
    "stack overflow": "Calls need more than the stack has: mostly a recursion without end.",
    "damaged stack": "The program has written over the records of its own calls.",
    "no memory for local array": "A local array of variable length, or `alloca`, finds no room.",
    "array length not positive": "A local array of variable length has none.",
    "unreachable code reached": "The program comes to a `__builtin_unreachable()`.",
    "goto to no label": "`goto *p` with a pointer that no `&&label` of the function gave.",
    "longjmp without setjmp": "`longjmp` gets a buffer that no `setjmp` has filled.",
    "longjmp to a function that has returned": "The function that called `setjmp` is no longer "
    "active.",
    "abort called": "The program gives up by itself.",
    "unhandled signal": "`raise`, `kill` or an alarm sends a signal for which the program has set "
    "no handler.",
    "assertion failed": "An `assert` does not hold. It says so on stderr, too, as C wants.",
}

WITHOUT_EXAMPLE = {"none", "internal trap"}
"""No kind, and a mistake of crs itself."""


def examples() -> dict[str, Path]:
    """Gives the case that shows each kind of error."""
    found: dict[str, Path] = {}
    for path in cases("errors"):
        (wanted,) = expected_errors(path)
        if wanted.text not in found or path.read_text(encoding="utf-8").startswith("/* Example:"):
            found[wanted.text] = path
    return found


def page() -> str:
    """Gives the text of the page."""
    known = examples()
    sections = [_section(kind, known[kind]) for kind in ERROR_KINDS if kind in known]
    return "\n".join([INTRODUCTION, *sections])


def shown_report(case: Path) -> str:
    """Gives a case's report without the comment that says what is expected."""
    return re.sub(r" *// error:.*", "", case.with_suffix(".report").read_text(encoding="utf-8"))


def _section(kind: str, case: Path) -> str:
    source = re.sub(r" *// error:.*", "", case.read_text(encoding="utf-8"))
    shown = shown_report(case)
    title = kind[0].upper() + kind[1:]
    return f"## {title}\n\n{MEANING[kind]}\n\n```c\n{source}```\n\n```\n{shown}```\n"


def test_the_page_of_errors_is_up_to_date(check_golden: Callable[[Path, bytes], None]) -> None:
    check_golden(PAGE, page().encode())


def test_every_kind_of_error_is_explained() -> None:
    assert set(MEANING) | WITHOUT_EXAMPLE == set(ERROR_KINDS)


def test_the_readme_shows_a_real_report() -> None:
    case = HERE / "errors" / "students" / "one_sonar_too_many.c"
    assert shown_report(case) in (ROOT / "README.md").read_text(encoding="utf-8")
