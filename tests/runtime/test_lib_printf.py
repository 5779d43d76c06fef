"""The printf family: against stored output of glibc, and against Python's exact conversions."""

from __future__ import annotations

import random
import struct
from pathlib import Path

from tests.runtime.library_runner import run

CASES = Path(__file__).with_name("lib_printf.txt")
NUMBERS = {"inf": "INFINITY", "-inf": "-INFINITY", "nan": "NAN"}

PRINTS_DOUBLES = r"""
#include <stdio.h>
int main(void)
{
    double x;
    int precision;
    while (fread(&x, sizeof x, 1, stdin) == 1 && fread(&precision, sizeof precision, 1, stdin)) {
        printf("%.*e\n", precision, x);
        printf("%+.*f\n", precision, x);
        printf("%#.*g\n", precision, x);
        printf("%.17g\n", x);
    }
    return 0;
}
"""


def test_output_is_that_of_glibc() -> None:
    rows = [line.split("\t") for line in CASES.read_text().splitlines()[1:]]
    calls = []
    for form, arguments, _ in rows:
        values = [NUMBERS.get(each, each) for each in arguments.split(", ") if each]
        if '"' in arguments:
            values = [arguments]
        calls.append(f'    printf({", ".join([chr(34) + form + chr(34), *values])}); puts("");')
    parts = [calls[start : start + 50] for start in range(0, len(calls), 50)]
    source = "#include <math.h>\n#include <stdio.h>\n"
    for number, part in enumerate(parts):
        source += f"static void part{number}(void)\n{{\n" + "\n".join(part) + "\n}\n"
    source += "int main(void)\n{\n" + "".join(f"    part{n}();\n" for n in range(len(parts)))
    printed = run(source + "    return 0;\n}\n").out.decode().splitlines()
    wrong = [
        (form, arguments, text, expected)
        for (form, arguments, expected), text in zip(rows, printed, strict=True)
        if text != expected
    ]
    assert not wrong


def some_doubles(count: int) -> list[float]:
    """Return doubles of all kinds: any bits, short decimals, halves, powers of ten, subnormals."""
    choose = random.Random(1)
    values: list[float] = []
    while len(values) < count:
        bits = struct.unpack("<d", choose.randbytes(8))[0]
        kinds = (
            bits,
            choose.randrange(-(10**6), 10**6) / 1000,
            choose.randrange(1000) + 0.5,
            10.0 ** choose.randrange(-300, 300),
            choose.randrange(2**40) * 5e-324,
            choose.randrange(10**9) / 2.0 ** choose.randrange(60),
        )
        values += [value for value in kinds if value - value == 0]
    return values[:count]


def test_doubles_are_rounded_correctly_at_every_precision() -> None:
    choose = random.Random(2)
    pairs = [(value, choose.choice((0, 1, 3, 6, 10, 17, 30))) for value in some_doubles(1500)]
    data = b"".join(struct.pack("<di", *pair) for pair in pairs)
    printed = run(PRINTS_DOUBLES, stdin=data).out.decode().splitlines()
    for (value, precision), rows in zip(pairs, zip(*[iter(printed)] * 4, strict=True), strict=True):
        assert rows[0] == f"{value:.{precision}e}"
        assert rows[1] == f"{value:+.{precision}f}"
        assert rows[2] == f"{value:#.{precision}g}"
        assert float(rows[3]) == value


def test_results_of_the_family() -> None:
    source = r"""
    #include <errno.h>
    #include <stdarg.h>
    #include <stdio.h>
    #include <string.h>
    static int list(char *text, size_t size, const char *format, ...)
    {
        va_list arguments;
        int result;
        va_start(arguments, format);
        result = vsnprintf(text, size, format, arguments);
        va_end(arguments);
        return result;
    }
    int main(void)
    {
        char text[8] = "zzzzzzz";
        int n = 99, result;
        result = snprintf(text, sizeof text, "%s", "longer than that");
        printf("%d [%s]\n", result, text);
        printf("%d\n", snprintf(NULL, 0, "%f", 1e300));
        printf("%d [%s]\n", list(text, 3, "%d", 12345), text);
        printf("%d [%s]\n", sprintf(text, "%c%c", 'a', 0), text);
        errno = 0;
        result = sprintf(text, "a%nb", &n);
        printf("%d %d %d\n", result, errno, n);
        errno = 0;
        result = printf("%2147483648d", 1);
        printf("%d %d\n", result, errno == EOVERFLOW);
        printf("%ls|%5lc|%.2ls\n", L"wide", L'w', L"wide");
        errno = 0;
        result = printf("%lc", 0x20ac);
        printf("%d %d\n", result, errno == EILSEQ);
        printf("%hhd %hd %Lf %y %d\n", 300, 70000, (long double)1.5, 3);
        return 0;
    }
    """
    assert run(source).out.decode().splitlines() == [
        "16 [longer ]",
        "308",
        "5 [12]",
        "2 [a]",
        "2 0 1",
        "-1 1",
        "wide|    w|wi",
        "€3 0",
        "44 4464 1.500000 %y 3",
    ]
