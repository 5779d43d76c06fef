"""The arithmetic types of generated programs, and their conversions (C17 6.3.1)."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Type:
    """An arithmetic type.

    Attributes:
        name: its name in C.
        rank: its rank in the usual arithmetic conversions.
        bits: its width.
        signed: whether it is signed.
        conversion: its conversion for `printf`.
    """

    name: str
    rank: int
    bits: int
    signed: bool
    conversion: str

    @property
    def is_float(self) -> bool:
        return self.rank >= FLOAT.rank

    @property
    def highest(self) -> int:
        """The largest value of an integer type."""
        return 1 if self.rank == 0 else 2 ** (self.bits - self.signed) - 1


BOOL = Type("_Bool", 0, 8, False, "%d")
CHAR = Type("char", 1, 8, True, "%d")
SCHAR = Type("signed char", 1, 8, True, "%d")
UCHAR = Type("unsigned char", 1, 8, False, "%u")
SHORT = Type("short", 2, 16, True, "%d")
USHORT = Type("unsigned short", 2, 16, False, "%u")
INT = Type("int", 3, 32, True, "%d")
UINT = Type("unsigned", 3, 32, False, "%u")
LONG = Type("long", 4, 32, True, "%ld")
ULONG = Type("unsigned long", 4, 32, False, "%lu")
LLONG = Type("long long", 5, 64, True, "%lld")
ULLONG = Type("unsigned long long", 5, 64, False, "%llu")
FLOAT = Type("float", 6, 32, True, "%a")
DOUBLE = Type("double", 7, 64, True, "%a")

INTEGERS = [
    BOOL, CHAR, SCHAR, UCHAR, SHORT, USHORT, INT, UINT, LONG, ULONG, LLONG, ULLONG,
]  # fmt: skip
ARITHMETIC = [*INTEGERS, FLOAT, DOUBLE]


def promoted(ctype: Type) -> Type:
    """Return the type of an integer operand after its promotion (C17 6.3.1.1)."""
    return INT if ctype.rank < INT.rank else ctype


def common(left: Type, right: Type) -> Type:
    """Return the common type of two operands (C17 6.3.1.8)."""
    if left.is_float or right.is_float:
        return left if left.rank > right.rank else right
    low, high = sorted((promoted(left), promoted(right)), key=lambda ctype: ctype.rank)
    if low.rank == high.rank:
        return high if low.signed else low
    if low.signed or not high.signed or high.bits > low.bits:
        return high
    return {LONG: ULONG, LLONG: ULLONG}[high]
