"""Library functions that are known without a declaration, as they are in gcc.

`__builtin_strlen` is `strlen`, and an undeclared `sqrt` returns a `double`.
"""

from __future__ import annotations

import functools
from typing import Final

from crs_cc.core.source import Diagnostics, Location
from crs_cc.frontend.check.checker import Unit
from crs_cc.frontend.check.declarator import declared_type
from crs_cc.frontend.parse.lexer import lex
from crs_cc.frontend.parse.parser import parse
from crs_cc.ir.types import DOUBLE, FloatType, FunctionType

_PROTOTYPES: Final = {
    "string.h": """
        void *memchr(const void *, int, unsigned); int memcmp(const void *, const void *, unsigned);
        void *memcpy(void *, const void *, unsigned); void *memmove(void *, const void *, unsigned);
        void *mempcpy(void *, const void *, unsigned); void *memset(void *, int, unsigned);
        char *stpcpy(char *, const char *); char *strcat(char *, const char *);
        char *strchr(const char *, int); int strcmp(const char *, const char *);
        char *strcpy(char *, const char *); unsigned strcspn(const char *, const char *);
        char *strdup(const char *); unsigned strlen(const char *); char *strerror(int);
        char *strncat(char *, const char *, unsigned); char *strndup(const char *, unsigned);
        int strncmp(const char *, const char *, unsigned);
        char *strncpy(char *, const char *, unsigned); char *strpbrk(const char *, const char *);
        char *strrchr(const char *, int); unsigned strspn(const char *, const char *);
        char *strstr(const char *, const char *); char *strtok(char *, const char *);
    """,
    "strings.h": """
        int bcmp(const void *, const void *, unsigned); void bzero(void *, unsigned);
        void bcopy(const void *, void *, unsigned); char *index(const char *, int);
        char *rindex(const char *, int); int strcasecmp(const char *, const char *);
        int strncasecmp(const char *, const char *, unsigned);
    """,
    "stdlib.h": """
        void abort(void); int abs(int); void *calloc(unsigned, unsigned); void exit(int);
        void free(void *); char *getenv(const char *); long labs(long); long long llabs(long long);
        void *malloc(unsigned); void *realloc(void *, unsigned); double atof(const char *);
        double strtod(const char *, char **); void _Exit(int); double drand48(void);
    """,
    "setjmp.h": "void longjmp(void *, int);",
    "stdio.h": """
        int printf(const char *, ...); int putchar(int); int puts(const char *);
        int scanf(const char *, ...); int snprintf(char *, unsigned, const char *, ...);
        int sprintf(char *, const char *, ...); int sscanf(const char *, const char *, ...);
        int vprintf(const char *, char *); int vsprintf(char *, const char *, char *);
        int vsnprintf(char *, unsigned, const char *, char *);
    """,
}  # fmt: skip
_ONE_INTEGER: Final = (
    "isalnum", "isalpha", "isblank", "iscntrl", "isdigit", "isgraph", "islower", "isprint",
    "ispunct", "isspace", "isupper", "isxdigit", "tolower", "toupper",
)  # fmt: skip
_ONE_DOUBLE: Final = (
    "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "exp", "log", "log10",
    "sqrt", "ceil", "floor", "fabs", "cbrt", "log1p", "expm1", "asinh", "acosh", "atanh", "rint",
    "exp2", "log2", "logb", "nearbyint", "round", "trunc", "erf", "erfc", "tgamma", "lgamma",
)  # fmt: skip
_TWO_DOUBLES: Final = (
    "atan2", "pow", "fmod", "hypot", "copysign", "fdim", "fmax", "fmin", "nextafter", "remainder",
)  # fmt: skip
_OTHER_DOUBLES: Final = (
    "{0} ldexp{1}({0}, int); {0} frexp{1}({0}, int *); {0} modf{1}({0}, {0} *);"
    "{0} scalbn{1}({0}, int); {0} fma{1}({0}, {0}, {0}); long lround{1}({0}); long lrint{1}({0});"
    "long long llround{1}({0}); long long llrint{1}({0}); int ilogb{1}({0}); "
)


@functools.cache
def library_functions() -> dict[str, tuple[FunctionType, str]]:
    """Return the type and the header of each function."""
    found: dict[str, tuple[FunctionType, str]] = {}
    texts = dict(_PROTOTYPES)
    texts["ctype.h"] = "".join(f"int {name}(int); " for name in _ONE_INTEGER)
    texts["math.h"] = "".join(
        "".join(f"{real} {name}{suffix}({real}); " for name in _ONE_DOUBLE)
        + "".join(f"{real} {name}{suffix}({real}, {real}); " for name in _TWO_DOUBLES)
        + _OTHER_DOUBLES.format(real, suffix)
        for real, suffix in (("double", ""), ("float", "f"), ("long double", "l"))
    )
    for header, text in texts.items():
        diagnostics = Diagnostics()
        unit = Unit(header, diagnostics, Location(header))
        place = functools.partial(Location, header)
        for node in parse(lex(" ".join(text.split()), place, diagnostics), diagnostics):
            ctype = declared_type(unit, node.type)
            assert isinstance(ctype, FunctionType)
            found[node.name] = ctype, header
        assert not diagnostics.messages, diagnostics.messages[0].render()
    return found


def undeclared(name: str) -> tuple[FunctionType, str] | None:
    """Return the implied type of an undeclared function, and its header; None if it is unknown.

    Only floating-point parameters have types: old programs may pass anything for others.
    """
    known = library_functions().get(name)
    if known is None:
        return None
    ctype, header = known
    if any(isinstance(each, FloatType) for each in ctype.parameters or ()):
        return known
    if header == "math.h" or ctype.result == DOUBLE:
        return known
    return FunctionType(ctype.result), header
