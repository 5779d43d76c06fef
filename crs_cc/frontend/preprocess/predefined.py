"""The macros that are defined before the first line: those of gcc on i386 Linux, and `__CRS__`.

`long double` has 64 bits, like `double`. `__GNUC__` is not defined, so that headers and programs
choose portable code. Date and time are fixed: the same source must always compile to the same
program (C17 6.10.8.1 allows it where none is available).

>>> {macro.name: macro.body for macro in predefined_macros()}["__LONG_MAX__"][0].text
'0x7fffffffL'
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import Final

from crs_cc.core.source import Diagnostics
from crs_cc.frontend.preprocess.macros import Macro, read_definition
from crs_cc.frontend.preprocess.options import STANDARDS
from crs_cc.frontend.preprocess.report import Report
from crs_cc.frontend.preprocess.source_text import SourceMap
from crs_cc.frontend.preprocess.tokens import tokenise

ORIGIN: Final = "<built-in>"
"""The name of the file that they are in; its only character is at position 0."""

_ONES: Final = (
    "__CRS__ __STDC__ __STDC_HOSTED__ __STDC_NO_THREADS__ "
    "__STDC_IEC_559__ __STDC_UTF_16__ __STDC_UTF_32__ __i386__ __i386 __linux__ __linux "
    "__gnu_linux__ __unix__ __unix __ILP32__ _ILP32 __ELF__ "
    "__NO_INLINE__ __GNUC_STDC_INLINE__ __DBL_HAS_DENORM__ __DBL_HAS_INFINITY__ "
    "__DBL_HAS_QUIET_NAN__ __FLT_HAS_DENORM__ __FLT_HAS_INFINITY__ __FLT_HAS_QUIET_NAN__ "
    "__LDBL_HAS_DENORM__ __LDBL_HAS_INFINITY__ __LDBL_HAS_QUIET_NAN__"
)
_VALUES: Final = """
__STDC_ISO_10646__ 201706L
__DATE__ "Jan  1 1970"
__TIME__ "00:00:00"
__TIMESTAMP__ "Thu Jan  1 00:00:00 1970"
__VERSION__ "crs"
__ORDER_LITTLE_ENDIAN__ 1234
__ORDER_BIG_ENDIAN__ 4321
__ORDER_PDP_ENDIAN__ 3412
__BYTE_ORDER__ __ORDER_LITTLE_ENDIAN__
__FLOAT_WORD_ORDER__ __ORDER_LITTLE_ENDIAN__
__CHAR_BIT__ 8
__BIGGEST_ALIGNMENT__ 16
__ATOMIC_RELAXED 0
__ATOMIC_CONSUME 1
__ATOMIC_ACQUIRE 2
__ATOMIC_RELEASE 3
__ATOMIC_ACQ_REL 4
__ATOMIC_SEQ_CST 5
__STDC_EMBED_NOT_FOUND__ 0
__STDC_EMBED_FOUND__ 1
__STDC_EMBED_EMPTY__ 2
__USER_LABEL_PREFIX__
__REGISTER_PREFIX__
__FINITE_MATH_ONLY__ 0
__SCHAR_MAX__ 0x7f
__SHRT_MAX__ 0x7fff
__WCHAR_MIN__ (-__WCHAR_MAX__ - 1)
__WINT_MIN__ 0U
__SIG_ATOMIC_MIN__ (-__SIG_ATOMIC_MAX__ - 1)
__INT8_C(c) c
__INT16_C(c) c
__INT32_C(c) c
__INT64_C(c) c ## LL
__INTMAX_C(c) c ## LL
__UINT8_C(c) c
__UINT16_C(c) c
__UINT32_C(c) c ## U
__UINT64_C(c) c ## ULL
__UINTMAX_C(c) c ## ULL
__FLT_RADIX__ 2
__FLT_EVAL_METHOD__ 0
__DECIMAL_DIG__ 17
__FLT_MANT_DIG__ 24
__FLT_DIG__ 6
__FLT_DECIMAL_DIG__ 9
__FLT_MIN_EXP__ (-125)
__FLT_MIN_10_EXP__ (-37)
__FLT_MAX_EXP__ 128
__FLT_MAX_10_EXP__ 38
__FLT_MAX__ 3.40282346638528859811704183484516925e+38F
__FLT_MIN__ 1.17549435082228750796873653722224568e-38F
__FLT_EPSILON__ 1.19209289550781250000000000000000000e-7F
__FLT_DENORM_MIN__ 1.40129846432481707092372958328991613e-45F
"""
_SIZES_BYTE: Final = {
    "SHORT": 2, "INT": 4, "LONG": 4, "LONG_LONG": 8, "POINTER": 4, "FLOAT": 4, "DOUBLE": 8,
    "LONG_DOUBLE": 8, "SIZE_T": 4, "PTRDIFF_T": 4, "WCHAR_T": 4, "WINT_T": 4,
}  # fmt: skip
_TYPES: Final = {
    # name: its type, its largest value; None if it is defined elsewhere in this file
    "INT": ("", "0x7fffffff"),
    "LONG": ("", "0x7fffffffL"),
    "LONG_LONG": ("", "0x7fffffffffffffffLL"),
    "SIZE": ("unsigned int", "0xffffffffU"),
    "PTRDIFF": ("int", "0x7fffffff"),
    "WCHAR": ("long int", "0x7fffffffL"),
    "WINT": ("unsigned int", "0xffffffffU"),
    "SIG_ATOMIC": ("int", "0x7fffffff"),
    "CHAR16": ("short unsigned int", ""),
    "CHAR32": ("unsigned int", ""),
    "INTMAX": ("long long int", "0x7fffffffffffffffLL"),
    "UINTMAX": ("long long unsigned int", "0xffffffffffffffffULL"),
    "INTPTR": ("int", "0x7fffffff"),
    "UINTPTR": ("unsigned int", "0xffffffffU"),
    "INT8": ("signed char", "0x7f"),
    "INT16": ("short int", "0x7fff"),
    "INT32": ("int", "0x7fffffff"),
    "INT64": ("long long int", "0x7fffffffffffffffLL"),
    "UINT8": ("unsigned char", "0xff"),
    "UINT16": ("short unsigned int", "0xffff"),
    "UINT32": ("unsigned int", "0xffffffffU"),
    "UINT64": ("long long unsigned int", "0xffffffffffffffffULL"),
}
_DOUBLE: Final = {
    "MANT_DIG": "53", "DIG": "15", "DECIMAL_DIG": "17", "MIN_EXP": "(-1021)",
    "MIN_10_EXP": "(-307)", "MAX_EXP": "1024", "MAX_10_EXP": "308",
    "MAX": "1.79769313486231570814527423731704357e+308",
    "MIN": "2.22507385850720138309023271733240406e-308",
    "EPSILON": "2.22044604925031308084726333618164062e-16",
    "DENORM_MIN": "4.94065645841246544176568792868221372e-324",
}  # fmt: skip


_WIDTHS: Final = {
    "SCHAR": 8, "SHRT": 16, "INT": 32, "LONG": 32, "LONG_LONG": 64, "SIZE": 32, "PTRDIFF": 32,
    "WCHAR": 32, "WINT": 32, "INTMAX": 64, "INTPTR": 32, "SIG_ATOMIC": 32,
}  # fmt: skip
_FAST_BITS: Final = {8: 8, 16: 32, 32: 32, 64: 64}
"""The widths of the `int_fast` types of gcc on i386 [bits]."""

_NOT_RESERVED: Final = ("linux", "unix", "i386")
"""Names that are the program's own in strict C."""


@cache
def predefined_macros(standard: str = "gnu17") -> tuple[Macro, ...]:
    """Return the macros with constant values; all are defined at position 0.

    Args:
        standard: a key of `STANDARDS`.
    """
    report = Report(Diagnostics(), SourceMap())
    macros = []
    for line in (*_definitions(), *_of_standard(standard)):
        tokens = [token.moved(0, token.spaced) for token in tokenise(line, 0)]
        macro = read_definition(tokens, report)
        assert macro is not None
        macros.append(macro)
    return tuple(macros)


def _of_standard(standard: str) -> Iterator[str]:
    if STANDARDS[standard]:
        yield f"__STDC_VERSION__ {STANDARDS[standard]}"
    if standard.startswith("gnu"):
        yield from (f"{name} 1" for name in _NOT_RESERVED)
    else:
        yield "__STRICT_ANSI__ 1"


def _definitions() -> Iterator[str]:
    yield from (f"{name} 1" for name in _ONES.split())
    yield from _VALUES.strip().splitlines()
    yield from (f"__SIZEOF_{name}__ {size}" for name, size in _SIZES_BYTE.items())
    yield from (f"__{name}_WIDTH__ {width}" for name, width in _WIDTHS.items())
    for name, (spelling, largest) in [*_TYPES.items(), *_sized_types()]:
        if spelling:
            yield f"__{name}_TYPE__ {spelling}"
        if largest:
            yield f"__{name}_MAX__ {largest}"
    for prefix, suffix in (("DBL", ""), ("LDBL", "L")):
        for name, value in _DOUBLE.items():
            yield f"__{prefix}_{name}__ {value}{suffix if 'e' in value else ''}"


def _sized_types() -> Iterator[tuple[str, tuple[str, str]]]:
    """Return the rows of `_TYPES` for `int_least8_t`, `int_fast8_t` and the like."""
    for prefix in ("INT", "UINT"):
        for bits, fast_bits in _FAST_BITS.items():
            yield f"{prefix}_LEAST{bits}", _TYPES[f"{prefix}{bits}"]
            yield f"{prefix}_FAST{bits}", _TYPES[f"{prefix}{fast_bits}"]
