"""The names that the library declares, defines and uses."""

from __future__ import annotations

import re

import pytest

from crs_cc.core.source import Diagnostics
from crs_cc.frontend.check.scope import ENTRIES
from crs_cc.frontend.unit import compile_text
from crs_cc.ir.names import LIBRARY
from crs_cc.runtime.link import references
from crs_cc.session.library import HEADERS, SOURCES, library, library_options

DIALECT = "crs/report.h"
"""What takes the place of `Nclient.h` in the report's dialect."""

PUBLIC = sorted(path.relative_to(HEADERS).as_posix() for path in HEADERS.rglob("*.h"))

INTRINSICS = (
    "__crs_request", "__crs_stop", "__crs_mark", "__crs_mark_unset", "__crs_callers", "__crs_state",
)  # fmt: skip

C89 = """
abort abs acos asctime asin atan atan2 atexit atof atoi atol bsearch calloc ceil clearerr clock
cos cosh ctime difftime div errno exit exp fabs fclose feof ferror fflush fgetc fgetpos fgets
floor fmod fopen fprintf fputc fputs fread free freopen frexp fscanf fseek fsetpos ftell fwrite
getc getchar getenv gets gmtime isalnum isalpha iscntrl isdigit isgraph islower isprint ispunct
isspace isupper isxdigit labs ldexp ldiv localeconv localtime log log10 longjmp malloc mblen
mbstowcs mbtowc memchr memcmp memcpy memmove memset mktime modf perror pow printf putc putchar
puts qsort raise rand realloc remove rename rewind scanf setbuf setlocale setvbuf signal sin
sinh sprintf sqrt srand sscanf stderr stdin stdout strcat strchr strcmp strcoll strcpy strcspn
strerror strftime strlen strncat strncmp strncpy strpbrk strrchr strspn strstr strtod strtok
strtol strtoul strxfrm system tan tanh time tmpfile tmpnam tolower toupper ungetc vfprintf
vprintf vsprintf wcstombs wctomb
"""
"""What no program may define (C17 7.1.3) and every library had, functions and objects."""

OBJECTS = """
State Smask Laser SERVER_MACHINE_NAME SERV_TCP_PORT signgam environ error_message_count
optarg optind opterr optopt
"""
"""Objects through which a program and the library speak."""

FAMILIES = (
    "math/complex", "math/float.c", "math/float_exact.c", "math/long_double.c", "stdio/print",
    "stdio/scan", "system/select.c", "wide/numbers.c",
)  # fmt: skip
"""The functions are based on those of the same family, such as `expm1f` on `expm1`."""


@pytest.mark.parametrize("name", PUBLIC)
def test_each_header_compiles_alone_and_twice_without_warnings(name: str) -> None:
    diagnostics = Diagnostics()
    text = f"#include <{name}>\n#include <{name}>\nint unit;\n"
    compile_text(text, "unit.c", library_options(), diagnostics)
    assert not diagnostics.messages


def test_all_headers_compile_together() -> None:
    diagnostics = Diagnostics()
    names = [name for name in PUBLIC if name != DIALECT]
    text = "".join(f"#include <{name}>\n" for name in [*names, *reversed(names)])
    compile_text(text + "int unit;\n", "unit.c", library_options(), diagnostics)
    assert not diagnostics.messages


def without_directives(text: str) -> str:
    """Return a header whose macros that declare several functions at a time are expanded."""
    text = text.replace("\\\n", "")
    for name, parameter, body in re.findall(
        r"^#define (__\w+)\((\w+)\) +(.*;)$", text, re.MULTILINE
    ):
        for used, argument in re.findall(rf"^({name}\((\w+)\))$", text, re.MULTILINE):
            declarations = re.sub(rf"\b{parameter}\b|{parameter}(?=##)", argument, body)
            text = text.replace(f"\n{used}\n", f"\n{declarations.replace('##', '')}\n")
    return re.sub(r"^#.*", "", text, flags=re.MULTILINE)


def test_everything_declared_is_defined() -> None:
    for name in PUBLIC:
        text = re.sub(r"/\*.*?\*/", "", (HEADERS / name).read_text(), flags=re.DOTALL)
        text = re.sub(r'\w+((?:\(|\[)[^;{}]*)\s__asm__\("(\w+)"\);', r"\2\1;", text)
        text = without_directives(text)
        functions = re.findall(r"(\w+)\((?!\*)[^;{}]*\);", text)
        variables = re.findall(r"^extern [\w ]+?[ *]+(\w+)(?:\[\w+\])?;", text, re.MULTILINE)
        for declared in [*functions, *variables]:
            if declared not in INTRINSICS:
                assert library().find(declared) is not None, f"{declared} of {name}"


def test_a_program_may_define_what_c89_leaves_free() -> None:
    """A program's own `round` or `index` must not become part of the library's inner workings."""
    allowed = re.compile(rf"__.*|.*:.*|{'|'.join([*C89.split(), *OBJECTS.split(), *ENTRIES])}")
    units = dict(row.split(":", 1) for row in (SOURCES / "index.txt").read_text().splitlines())
    for unit, public in units.items():
        for name in [] if unit.startswith(FAMILIES) else public.split():
            used = [each for each in uses(name) if not allowed.fullmatch(each)]
            assert not used, f"{name} of {unit}"


def uses(name: str) -> set[str]:
    """Return what a definition of the library uses, and what its unit's own names do for it."""
    found, work = set[str](), [name]
    for each in work:
        definition = library().find(each)
        assert definition is not None, each
        used = set(references(definition)) - found
        found |= used
        work += sorted(other for other in used if other.startswith(LIBRARY))
    return found


def test_library_sources_respect_the_size_limits() -> None:
    for path in [*SOURCES.rglob("*.c"), *SOURCES.rglob("*.h")]:
        lines = path.read_text().splitlines()
        assert len(lines) <= 500, path
        assert all(len(line) <= 100 for line in lines), path
        assert lines[0].startswith("/* "), f"{path} does not open with its idea"
