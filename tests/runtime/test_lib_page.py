"""Generate `docs/library.md`: the headers with their declarations, and the accuracy of `math.h`.

`--update-goldens` rewrites the page.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from pathlib import Path

from crs_cc.session.library import HEADERS, SOURCES
from tests.runtime.test_lib_math import MEASURED

PAGE = Path(__file__).parents[2] / "docs" / "library.md"

INTRODUCTION = """\
<!-- made by tests/runtime/test_lib_page.py; edit there, then pytest --update-goldens -->

# The C library

A control program finds all of C17's library except threads, atomics and complex numbers, and of
POSIX, BSD and GNU what such programs use. It is written in C (`crs_cc/runtime/lib`), compiled by
crs itself, kept in the cache, and linked by need. Where C leaves a choice it does what glibc does
on i386; `long double` is `double`. Every function behind a header below can be called; `--` stands
where a header has macros or types only.

**Files.** A program sees the files that `--file FILE` or `--file NAME=FILE` names, and those that
it writes. What it wrote is kept below the folder of `--files DIR`, of several robots in
`DIR/ROBOT`. `..` ends at the disk's root, `/tmp/log` and `tmp/log` are the same file, folders are
made by putting files in them and cannot be listed. A disk takes 16 MiB
([decision 7](adr/0007-files.md)). What a program has printed into a buffer and not flushed is lost
when it is stopped, by an error or by `--max-time`, as with a signal on Unix: a loop without end
calls `fflush` now and then, or `setvbuf(log, NULL, _IOLBF, 0)` once.

**Time** is simulated time, in UTC; a run starts on 1 January 2000 at 00:00:00. `clock` counts the
program's processor time. `sleep`, `usleep`, `nanosleep`, `select` and `poll` let it pass.

**Signals.** Nobody sends a program signals but itself. `SIGALRM` of `alarm` and `setitimer` comes
when the library waits, reads the clock, or has talked to the robot, never in the middle of a
computation: a loop that does nothing but wait for a handler's variable waits for ever. A signal
without handler ends the program with an error.

**Input.** The standard streams are no terminals. `select` and `poll` with a timeout report that
nothing was typed; reading waits for crs's own standard input.

**Characters.** The only locale is "C". `char` strings are bytes, multibyte characters UTF-8,
`wchar_t` is a Unicode character. Beyond ASCII, wide characters are letters without case.

**Formats.** `printf` and `scanf` round correctly. `%n` of `printf` fails with `EINVAL`. Numbered
arguments (`%2$d`), `%m`, and `%ms` of `scanf` are there.

**Rounding** is to nearest, always; no floating-point exception raises a flag by itself. The sign of
a NaN that arithmetic makes is the processor's: `0.0 / 0.0` prints `-nan` on x86, as with gcc.
"""

UNAVAILABLE = """\
## What a sandbox cannot give

These link, say so once on the standard error stream, and give their error value with `errno`:
{names}. No descriptor is a socket or a terminal, so that calls that need one fail with `ENOTSOCK`
or `ENOTTY`.

Headers that are not there are named with a reason: `<threads.h>`, `<pthread.h>`, `<stdatomic.h>`,
`<complex.h>`, `<curses.h>`, `<X11/Xlib.h>` and others.
"""

EXACTNESS = """\
## How exact the mathematical functions are

The largest error found against mpmath, in units of the last place, over 3,000 arguments of each
function's whole range and the hardest known ones (`tests/runtime/test_lib_math.py`). The functions
for `float` round these results once more: 0.5000001 at most. All others are exact (`sqrt`, `fma`,
`fmod`, `remainder`, `rint`, `frexp`, `nextafter`, ...).

| function | promised | found |
| --- | --- | --- |
"""


def comment_of(text: str) -> str:
    """Return the first sentence of a header's opening comment."""
    comment = re.match(r"/\*\s*(.*?)\*/", text, re.DOTALL)
    assert comment is not None
    return " ".join(comment[1].split()).split(". ")[0].removesuffix(".")


def declared(text: str) -> Iterator[str]:
    """Return the functions that a header declares for programs."""
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)
    text = re.sub(r"^#.*(\\\n.*)*", "", text, flags=re.MULTILINE)
    for name in re.findall(r"(\w+)\((?!\*)[^;{}]*\);", text):
        if not name.startswith("__"):
            yield name


def headers() -> Iterator[str]:
    """Return a section for each header."""
    for path in sorted(HEADERS.rglob("*.h")):
        name = path.relative_to(HEADERS).as_posix()
        if name.startswith("crs"):
            continue
        text = path.read_text()
        functions = ", ".join(f"`{each}`" for each in declared(text)) or "--"
        yield f"**`<{name}>`** {comment_of(text)}.\n{functions}\n"


def unavailable() -> list[str]:
    """Return the functions that always fail, by the macro that defines them."""
    found = ["system", "gethostbyname", "gethostbyaddr"]
    for path in SOURCES.rglob("*.c"):
        found += re.findall(r"^UNAVAILABLE\(.*?, (\w+),", path.read_text(), re.MULTILINE)
    return sorted(found)


def page() -> str:
    """Return the text of the page."""
    names = ", ".join(f"`{name}`" for name in unavailable())
    rows = [line.split("\t") for line in MEASURED.read_text().splitlines()[1:]]
    table = "".join(f"| `{name}` | {promised} | {found} |\n" for name, promised, found in rows)
    parts = [INTRODUCTION, UNAVAILABLE.format(names=names), "## Headers\n", *headers()]
    return "\n".join([*parts, EXACTNESS + table])


def test_the_page_of_the_library_is_up_to_date(
    check_golden: Callable[[Path, bytes], None],
) -> None:
    check_golden(PAGE, page().encode())


def test_the_errors_on_the_page_are_within_the_documented_bounds() -> None:
    for line in MEASURED.read_text().splitlines()[1:]:
        name, promised, found = line.split("\t")
        assert float(found) <= float(promised), name
