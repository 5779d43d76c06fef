"""Mathematical functions whose results are exact, special values, and the other types' families."""

from __future__ import annotations

import math
import random
import re
import struct
from fractions import Fraction

from crs_cc.session.library import HEADERS
from tests.runtime.library_runner import run

EXACT = r"""
#include <math.h>
#include <stdio.h>
int main(void)
{
    double in[3], out[17];
    while (fread(in, sizeof in, 1, stdin) == 1) {
        double x = in[0], y = in[1], z = in[2];
        int exponent, quotient;
        out[0] = fma(x, y, z);
        out[1] = fmod(x, y);
        out[2] = remainder(x, y);
        out[3] = remquo(x, y, &quotient);
        out[4] = floor(x);
        out[5] = ceil(x);
        out[6] = trunc(x);
        out[7] = rint(x);
        out[8] = round(x);
        out[9] = frexp(x, &exponent);
        out[10] = exponent;
        out[11] = ldexp(x, (int)(long long)fmod(z, 2000));
        out[12] = nextafter(x, y);
        out[13] = modf(x, &out[14]);
        out[15] = llrint(fmod(x, 0x1p60));
        out[16] = llround(fmod(x, 0x1p60));
        fwrite(out, sizeof out, 1, stdout);
    }
    return 0;
}
"""


def as_double(value: Fraction, sign: float) -> float:
    if value == 0:
        return math.copysign(0.0, sign)
    try:
        return float(value)
    except OverflowError:
        return math.inf if value > 0 else -math.inf


def half_away(x: float) -> float:
    whole = math.trunc(x) if abs(x) >= 2**52 else int(Fraction(abs(x)) + Fraction(1, 2))
    return math.copysign(float(abs(whole)), x)


def expected(x: float, y: float, z: float) -> list[float]:
    fraction, exponent = math.frexp(x)
    small, shift = math.fmod(x, 2.0**60), int(math.fmod(z, 2000))
    product = Fraction(x) * Fraction(y)
    rest, whole = math.modf(x)
    return [
        as_double(product + Fraction(z), -1.0 if product == 0 == z and z < 0 else 1.0),
        math.fmod(x, y),
        math.remainder(x, y),
        math.remainder(x, y),
        math.copysign(float(math.floor(x)), x),
        math.copysign(float(math.ceil(x)), x),
        math.copysign(float(math.trunc(x)), x),
        math.copysign(float(round(x)), x),
        half_away(x),
        fraction,
        float(exponent),
        as_double(Fraction(x) * Fraction(2) ** shift, x),
        math.nextafter(x, y),
        rest,
        whole,
        float(round(small)),
        half_away(small) + 0.0,
    ]


def some_number(choose: random.Random) -> float:
    kind = choose.randrange(5)
    if kind == 0:
        return struct.unpack("<d", choose.randbytes(8))[0]
    if kind == 1:
        return choose.randrange(-4000, 4000) / 2
    if kind == 2:
        return choose.uniform(1, 2) * 2.0 ** choose.randrange(-60, 60)
    if kind == 3:
        return choose.randrange(-(2**50), 2**50) * 5e-324
    return choose.choice((1.0, -1.0, 0.5, 2.0**53 - 1, 5e-324, 0.49999999999999994, 1.7e308))


def test_exact_functions() -> None:
    choose = random.Random(7)
    points = []
    while len(points) < 1500:
        x, y, z = (some_number(choose) for _ in range(3))
        if choose.random() < 0.3:
            z = -x * y * choose.choice((1, 1 + 2**-52, 1 - 2**-53))
        if all(map(math.isfinite, (x, y, z))) and x != 0 and y != 0:
            points.append((x, y, z))
    data = b"".join(struct.pack("<3d", *point) for point in points)
    found = struct.iter_unpack("<17d", run(EXACT, stdin=data).out)
    for point, row in zip(points, found, strict=True):
        assert list(row) == expected(*point), point


SPECIAL = """
sqrt(-1.0)=nan EDOM, log(0.0)=-inf ERANGE, log(-1.0)=nan EDOM, log1p(-1.0)=-inf ERANGE,
exp(710.0)=inf ERANGE, exp(-746.0)=0 ERANGE, exp(-INFINITY)=0, exp2(1024.0)=inf ERANGE,
expm1(-INFINITY)=-1, sin(INFINITY)=nan EDOM, sin(-0.0)=-0, cos(0.0)=1, tan(-0.0)=-0,
asin(1.5)=nan EDOM, acos(1.0)=0, atan(-0.0)=-0, atan2(0.0, -0.0)=3.14159, atan2(-0.0, 0.0)=-0,
atan2(-0.0, -1.0)=-3.14159, atan2(INFINITY, -INFINITY)=2.35619, atan2(1.0, INFINITY)=0,
atan2(1.0, -INFINITY)=3.14159, pow(0.0, 0.0)=1, pow(NAN, 0.0)=1, pow(1.0, NAN)=1,
pow(-2.0, 3.0)=-8, pow(-2.0, 0.5)=nan EDOM, pow(0.0, -1.0)=inf ERANGE, pow(-0.0, -3.0)=-inf ERANGE,
pow(-0.0, 3.0)=-0, pow(-1.0, INFINITY)=1, pow(0.5, INFINITY)=0, pow(0.5, -INFINITY)=inf,
pow(-INFINITY, 3.0)=-inf, pow(-INFINITY, -3.0)=-0, pow(10.0, 309.0)=inf ERANGE,
pow(10.0, -324.0)=0 ERANGE, pow(10.0, 22.0)=1e+22, pow(2.0, -1074.0)=4.94066e-324,
hypot(INFINITY, NAN)=inf, hypot(1e308, 1e308)=1.41421e+308, hypot(1.7e308, 1.7e308)=inf ERANGE,
hypot(3e-320, 4e-320)=4.99994e-320, cosh(-INFINITY)=inf, sinh(720.0)=inf ERANGE, tanh(-INFINITY)=-1,
acosh(0.5)=nan EDOM, atanh(1.0)=inf ERANGE, atanh(2.0)=nan EDOM, cbrt(-27.0)=-3, cbrt(-0.0)=-0,
tgamma(0.0)=inf ERANGE, tgamma(-0.0)=-inf ERANGE, tgamma(-2.0)=nan EDOM, tgamma(5.0)=24,
tgamma(172.0)=inf ERANGE, lgamma(1.0)=0, lgamma(2.0)=0, lgamma(-3.0)=inf ERANGE, erf(INFINITY)=1,
erfc(-INFINITY)=2, erfc(30.0)=0 ERANGE, fmod(1.0, 0.0)=nan EDOM, fmod(INFINITY, 1.0)=nan EDOM,
fmod(-6.0, 3.0)=-0, fmod(5.0, INFINITY)=5, fmax(NAN, 1.0)=1, fmin(1.0, NAN)=1, fdim(1.0, 3.0)=0,
logb(8.0)=3, nextafter(1.7976931348623157e308, INFINITY)=inf ERANGE, ldexp(1.0, 5000)=inf ERANGE,
log2(1024.0)=10, log10(1e15)=15, exp10(3.0)=1000, round(-0.4)=-0, rint(2.5)=2, nearbyint(3.5)=4
"""


def test_special_values_and_errno() -> None:
    cases = re.findall(r"(\w+\([^()]*\))=(\S+?)(?: (EDOM|ERANGE))?,?\s", SPECIAL)
    assert len(cases) == 78
    calls = "".join(f'show("{call}", (errno = 0, {call}));\n' for call, _, _ in cases)
    source = (
        "#include <errno.h>\n#include <math.h>\n#include <stdio.h>\n"
        "static void show(const char *call, double value) {\n"
        '    printf("%s=%g%s\\n", call, isnan(value) ? NAN : value,\n'
        '           errno == EDOM ? " EDOM" : errno == ERANGE ? " ERANGE" : "");\n}\n'
        f"int main(void) {{ {calls} return 0; }}\n"
    )
    wanted = [f"{call}={value}{' ' if error else ''}{error}" for call, value, error in cases]
    assert run(source).out.decode().splitlines() == wanted


def families(suffix: str, kind: str) -> list[str]:
    """Return the functions of one argument that `math.h` declares for a type, without suffix."""
    text = (HEADERS / "math.h").read_text()
    found = re.findall(rf"^{kind} (\w+){suffix}\({kind} x\);", text, re.MULTILINE)
    return [name for name in found if name != "significand"]


def test_float_and_long_double_agree_with_double() -> None:
    floats, longs = families("f", "float"), families("l", "long double")
    assert len(floats) == len(longs) == 33
    checks = "".join(
        f'if (!same({name}f(x), (float){name}(x))) puts("{name}f");\n'
        f'if (!same({name}l(x), {name}(x))) puts("{name}l");\n'
        for name in floats
    )
    source = f"""
    #include <math.h>
    #include <stdio.h>
    static int same(double a, double b) {{ return a == b || (a != a && b != b); }}
    int main(void)
    {{
        static const float values[] = {{0.5f, 1.25f, -0.75f, 3.5f, 100.0f, -1e-30f, 1e30f, 0.0f}};
        int i;
        for (i = 0; i < 8; i++) {{
            float x = values[i];
            {checks}
        }}
        printf("%.9g %.9g", powf(2.5f, 3.25f), atan2f(-1.0f, -2.0f));
        printf(" %.9g %g\\n", fmaf(1.1f, 1.3f, -1.43f), (double)nextafterf(1.0f, 2.0f) - 1);
        printf("%d %d %d\\n", fpclassify(1e-40f) == FP_SUBNORMAL, fpclassify(1e-40) == FP_NORMAL,
               isnormal(1e-310));
        printf("%d %d %d %d\\n", isnan(NAN), isinf(-INFINITY), isfinite(1e308), signbit(-0.0) != 0);
        return 0;
    }}
    """
    assert run(source).out.decode().splitlines() == [
        "19.647398 -2.67794514 3.09944141e-08 1.19209e-07",
        "1 1 0",
        "1 -1 1 1",
    ]
