"""Random expressions that are defined for any values of their variables.

Divisors are made positive, shift counts are masked, numbers are limited before they are converted
from floating to integer types, subscripts are masked. Signed overflow wraps, by our rules and by
gcc's -fwrapv. Expressions have no side effects; statements add those, one at a time.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from random import Random

from tests.fuzz.generator.types import (
    ARITHMETIC,
    DOUBLE,
    INT,
    INTEGERS,
    LLONG,
    UINT,
    Type,
    common,
    promoted,
)

Typed = tuple[str, Type]

PRELUDE = """\
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Anything that is not between -most and most becomes a number that is. */
static double limit(double x, double most) { return x > -most && x < most ? x : most / 2; }
static double size(double x, double most) { return limit(fabs(x), most); }

/* Not-a-numbers have no sign that C speaks of. */
static void show(double x)
{
    if (x != x)
        printf("nan\\n");
    else
        printf("%a\\n", x);
}
"""

INTERESTING = [0, 1, 2, 3, 7, 8, 100, 127, 128, 255, 256, 32767, 32768, 65535, 65536, 2**31 - 1]
FLOATS = [
    "0.0", "1.0", "0.5", "0.1f", "1e10", "3.14159", "1e-300", "0x1p-1074", "1e308", "2.5e-5f",
    "16777217.0", "0x1.fffffep127f", "1e-45f", "4294967296.0", "9007199254740993.0", "1.5f",
]  # fmt: skip
UNARY_MATH = ["sqrt", "floor", "ceil", "trunc", "fabs", "rint", "round"]
COMPARISONS = ["<", ">", "<=", ">=", "==", "!="]


@dataclass(frozen=True)
class Function:
    """A generated function without side effects.

    Attributes:
        old_style: its arguments are not converted, since it has no prototype.
    """

    name: str
    result: Type
    parameters: tuple[Type, ...]
    old_style: bool = False


@dataclass
class Expressions:
    """Generates expressions.

    Attributes:
        chance: the random number generator.
        readable: operands: variables, members, elements.
        arrays: arrays of eight elements.
        functions: functions to call.
    """

    chance: Random
    readable: list[Typed] = field(default_factory=list)
    arrays: list[Typed] = field(default_factory=list)
    functions: list[Function] = field(default_factory=list)

    def any(self, depth: int) -> Typed:
        """Return an expression of some arithmetic type."""
        return self.floating(depth) if self.chance.random() < 0.3 else self.integer(depth)

    def of(self, ctype: Type, depth: int) -> str:
        """Return an expression that can be assigned to an object of a type."""
        text, own = self.any(depth)
        return self.fitted(text, own, ctype)

    def fitted(self, text: str, own: Type, ctype: Type) -> str:
        """Return an expression limited to a type's range, if necessary."""
        if not own.is_float or ctype.is_float or ctype.rank == 0:
            return text
        most = float(min(ctype.highest, 2**62))
        return f"{'limit' if ctype.signed else 'size'}({text}, {most})"

    def integer(self, depth: int) -> Typed:
        """Return an expression of an integer type."""
        if depth <= 0 or self.chance.random() < 0.1:
            return self._integer_leaf()
        kind = self.chance.choice(
            ["arithmetic"] * 5 + ["division", "shift", "shift", "logic", "compare", "compare"]
            + ["choice", "cast", "cast", "unary", "unary", "element", "call", "comma", "sizeof"]
        )  # fmt: skip
        made: Typed = getattr(self, f"_{kind}")(depth - 1)
        return made

    def floating(self, depth: int) -> Typed:
        """Return an expression of a floating type."""
        draw = self.chance.random()
        if depth <= 0 or draw < 0.1:
            known = [each for each in self.readable if each[1].is_float]
            if known and self.chance.random() < 0.7:
                return self.chance.choice(known)
            text = self.chance.choice(FLOATS)
            return text, ARITHMETIC[-2] if text.endswith("f") else DOUBLE
        if draw < 0.55:
            left, left_type = self.floating(depth - 1)
            right, right_type = self.any(depth - 1)
            if self.chance.random() < 0.5:
                left, left_type, right, right_type = right, right_type, left, left_type
            return f"({left} {self.chance.choice('+-*/')} {right})", common(left_type, right_type)
        if draw < 0.7:
            function = self.chance.choice(UNARY_MATH)
            return f"{function}({self.floating(depth - 1)[0]})", DOUBLE
        if draw < 0.85:
            ctype = self.chance.choice(ARITHMETIC[-2:])
            return f"({ctype.name}){self.any(depth - 1)[0]}", ctype
        if draw < 0.95:
            text, ctype = self.floating(depth - 1)
            return f"(-{text})", ctype
        (yes, yes_type), (no, no_type) = self.floating(depth - 1), self.any(depth - 1)
        return f"({self.condition(depth - 1)} ? {yes} : {no})", common(yes_type, no_type)

    def condition(self, depth: int) -> str:
        """Return an expression for `if` and the like."""
        if self.chance.random() < 0.2:
            return self.any(depth)[0]
        return self._compare(depth)[0]

    def literal(self) -> Typed:
        """Return an integer constant, with a suffix or without."""
        value = self.chance.choice(INTERESTING) + self.chance.randint(-1, 1)
        value = self.chance.choice([abs(value), self.chance.randint(0, 300)])
        form = self.chance.choice(["d", "d", "d", "#x", "#o"])
        text = f"{value:{form}}".replace("0o", "0")
        if value == 0:
            text = "0"
        suffix, ctype = self.chance.choice(
            [("", INT)] * 4
            + [("u", UINT), ("ll", LLONG), ("UL", INTEGERS[9]), ("ull", INTEGERS[11])]
        )
        return (text + suffix, ctype) if value < 2**31 else (f"{text}ll", LLONG)

    def _integer_leaf(self) -> Typed:
        known = [each for each in self.readable if not each[1].is_float]
        if known and self.chance.random() < 0.75:
            return self.chance.choice(known)
        return self.literal()

    def _pair(self, depth: int) -> tuple[str, str, Type]:
        (left, left_type), (right, right_type) = self.integer(depth), self.integer(depth)
        return left, right, common(left_type, right_type)

    def _arithmetic(self, depth: int) -> Typed:
        left, right, ctype = self._pair(depth)
        return f"({left} {self.chance.choice('+-*&|^')} {right})", ctype

    def _division(self, depth: int) -> Typed:
        left, left_type = self.integer(depth)
        right, right_type = self.integer(depth)
        text = f"({left} {self.chance.choice('/%')} (({right} & 63) + 1))"
        return text, common(left_type, common(right_type, INT))

    def _shift(self, depth: int) -> Typed:
        left, ctype = self.integer(depth)
        ctype = promoted(ctype)
        operator = self.chance.choice(["<<", ">>"])
        return f"({left} {operator} ({self.integer(depth)[0]} & {ctype.bits - 1}))", ctype

    def _logic(self, depth: int) -> Typed:
        operator = self.chance.choice(["&&", "||"])
        return f"({self.any(depth)[0]} {operator} {self.any(depth)[0]})", INT

    def _compare(self, depth: int) -> Typed:
        operator = self.chance.choice(COMPARISONS)
        return f"({self.any(depth)[0]} {operator} {self.any(depth)[0]})", INT

    def _choice(self, depth: int) -> Typed:
        left, right, ctype = self._pair(depth)
        return f"({self.condition(depth)} ? {left} : {right})", ctype

    def _cast(self, depth: int) -> Typed:
        ctype = self.chance.choice(INTEGERS)
        return f"({ctype.name})({self.of(ctype, depth)})", ctype

    def _unary(self, depth: int) -> Typed:
        text, ctype = self.integer(depth)
        operator = self.chance.choice("-~+!")
        return f"({operator} {text})", INT if operator == "!" else promoted(ctype)

    def _element(self, depth: int) -> Typed:
        arrays = [each for each in self.arrays if not each[1].is_float]
        if not arrays:
            return self._integer_leaf()
        name, ctype = self.chance.choice(arrays)
        return f"{name}[{self.integer(depth)[0]} & 7]", ctype

    def _call(self, depth: int) -> Typed:
        known = [each for each in self.functions if not each.result.is_float]
        if not known:
            return self._arithmetic(depth)
        function = self.chance.choice(known)
        values = [self.of(ctype, depth - 1) for ctype in function.parameters]
        if function.old_style:
            rows = zip(function.parameters, values, strict=True)
            values = [f"({ctype.name})({value})" for ctype, value in rows]
        return f"{function.name}({', '.join(values)})", function.result

    def _comma(self, depth: int) -> Typed:
        text, ctype = self.integer(depth)
        return f"((void)({self.any(depth - 1)[0]}), {text})", ctype

    def _sizeof(self, depth: int) -> Typed:
        return f"sizeof({self.any(depth)[0]})", UINT
