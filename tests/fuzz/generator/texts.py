"""Topics: printing, strings, conversion of numbers to text and back."""

from __future__ import annotations

from random import Random

from tests.fuzz.generator.expressions import Expressions, Function
from tests.fuzz.generator.source import Source
from tests.fuzz.generator.statements import Statements, scalar_variables

INTEGER_ARGUMENTS = {
    "hh": "(signed char)({})", "h": "(short)({})", "": "(int)({})", "l": "(long)({})",
    "ll": "(long long)({})", "j": "(long long)({})", "z": "(unsigned)({})", "t": "(int)({})",
}  # fmt: skip


def word(chance: Random, longest: int) -> str:
    """Return a string literal."""
    letters = chance.choices("abcdexyz 019,%", k=chance.randint(0, longest))
    extra = chance.choice(["", "", "", "\\n", "\\t", "\\x41", "\\0after", "\\\\", '\\"', "\\377"])
    return '"' + "".join(letters) + extra + '"'


def _width(chance: Random, arguments: list[str], limit: int) -> str:
    draw = chance.random()
    if draw < 0.5:
        return ""
    if draw < 0.6:
        arguments.append(str(chance.randint(-limit, limit)))
        return "*"
    return str(chance.randint(1, limit))


def conversion(expressions: Expressions) -> tuple[str, list[str]]:
    """Return a conversion specification of `printf` and its arguments."""
    chance = expressions.chance
    arguments: list[str] = []
    kind = chance.choice("ddiuxXocsseEfFgGaA%")
    if kind == "%":
        return "%%", []
    flags = "".join(flag for flag in "-+ #0" if chance.random() < 0.2)
    if kind in "cs":
        flags = flags.replace("#", "").replace("0", "").replace("+", "").replace(" ", "")
    if kind in "diu":
        flags = flags.replace("#", "")
    width = _width(chance, arguments, 20)
    precision = ""
    if kind != "c" and chance.random() < 0.4:
        precision = "." + _width(chance, arguments, 12)
    if kind == "c":
        arguments.append(str(chance.randint(33, 126)))
    elif kind == "s":
        arguments.append(word(chance, 8))
    elif kind in "eEfFgGaA":
        arguments.append(f"limit({expressions.floating(2)[0]}, 1e15)")
    else:
        length = chance.choice(sorted(INTEGER_ARGUMENTS))
        arguments.append(INTEGER_ARGUMENTS[length].format(expressions.integer(2)[0]))
        kind = length + kind
    return f"%{flags}{width}{precision}{kind}", arguments


def printing(source: Source, functions: list[Function], name: str) -> None:
    """The `printf` family with all flags, widths, precisions and lengths."""
    chance = source.chance
    with source.block(f"static void {name}(void)"):
        expressions = Expressions(chance, functions=functions)
        scalar_variables(Statements(source, expressions), 3)
        source.add("char buffer[64];", "int count;")
        for _ in range(6):
            parts = [conversion(expressions) for _ in range(chance.randint(1, 4))]
            text = "|".join(part for part, _ in parts)
            values = "".join(f", {value}" for _, row in parts for value in row)
            if chance.random() < 0.4:
                size = chance.randint(1, 64)
                source.add(f'count = snprintf(buffer, {size}, "{text}"{values});')
                source.add('printf("%d [%s]\\n", count, buffer);')
            else:
                source.add(f'count = printf("[{text}]\\n"{values});')
                source.add('printf("%d\\n", count);')


def strings(source: Source, functions: list[Function], name: str) -> None:
    """The functions of string.h over a few buffers."""
    chance = source.chance
    with source.block(f"static void {name}(void)"):
        source.add(
            f'char a[64] = {word(chance, 10)}, b[64] = {word(chance, 10)}, copy[64] = "", *p;',
            f"const char *words = {word(chance, 12)};",
            "(void)copy; (void)words;",
        )
        steps = [
            "if (strlen(a) + strlen(b) < 60) strcat(a, b);",
            "strncat(b, a, {n}); b[30] = 0;",
            "memset(copy, 0, sizeof copy); strncpy(copy, a, {n}); printf(\"%s\\n\", copy);",
            "strcpy(copy, b); memmove(copy + {k}, copy, 20); copy[40] = 0;",
            "memmove(a, a + {k}, 30); a[33] = 0;",
            "p = strchr(a, '{c}'); printf(\"%d\\n\", p ? (int)(p - a) : -1);",
            "p = strrchr(b, '{c}'); printf(\"%d\\n\", p ? (int)(p - b) : -1);",
            "p = strstr(a, \"{c}\"); printf(\"%s\\n\", p ? p : \"none\");",
            "printf(\"%d\\n\", (strcmp(a, b) > 0) - (strcmp(a, b) < 0));",
            "printf(\"%d\\n\", (strncmp(a, b, {n}) > 0) - (strncmp(a, b, {n}) < 0));",
            "printf(\"%d\\n\", (memcmp(a, words, {k}) > 0) - (memcmp(a, words, {k}) < 0));",
            "printf(\"%u %u\\n\", (unsigned)strspn(a, words), (unsigned)strcspn(b, words));",
            "p = strpbrk(a, words); printf(\"%s\\n\", p ? p : \"none\");",
            "strcpy(copy, a); if ((p = strtok(copy, \"{c} ,\"))) puts(p);",
            "if (strtok(copy, \",\")) while ((p = strtok(NULL, \"{c} ,\"))) puts(p);",
            "printf(\"%u %u\\n\", (unsigned)strlen(a), (unsigned)strlen(words));",
            "for (p = a; *p; p++) if (*p >= 'a' && *p <= 'z') *p ^= 32;",
            "p = memchr(a, '{c}', sizeof a); printf(\"%d\\n\", p ? (int)(p - a) : -1);",
            "for (int i = 0; i < 20; i++) {{ char c = a[i]; a[i] = b[19 - i]; b[19 - i] = c; }}",
        ]  # fmt: skip
        for step in chance.choices(steps, k=10):
            text = step.format(
                n=chance.randint(1, 30), k=chance.randint(0, 1), c=chance.choice("abx1")
            )
            source.add(text, 'printf("%s|%s\\n", a, b);')


def numbers(source: Source, functions: list[Function], name: str) -> None:
    """Numbers written as text and read again by all functions that read numbers."""
    chance = source.chance
    expressions = Expressions(chance, functions=functions)
    with source.block(f"static void {name}(void)"):
        scalar_variables(Statements(source, expressions), 3)
        source.add("char text[400], *end;", "double d;", "float f;", "int i, n;", "long l;")
        source.add(
            "unsigned u;", "char w[40];", "(void)w; (void)f; (void)i; (void)n; (void)u; (void)l;"
        )
        for _ in range(6):
            form = chance.choice(["%.17g", "%.16e", "%a", "%.9g", "%f", "%.3f", "%g", "%.0e"])
            source.add(f'sprintf(text, "{form}", {expressions.floating(3)[0]});')
            source.add("d = strtod(text, &end);", "show(d);", 'printf("%d\\n", *end);')
        for _ in range(3):
            digits = "".join(chance.choices("0123456789", k=chance.randint(1, 25)))
            point = chance.randint(0, len(digits))
            exponent = chance.choice(["", f"e{chance.randint(-320, 310)}", "e+", "x"])
            literal = f"{digits[:point]}.{digits[point:]}{exponent}"
            source.add(f'd = strtod("{literal}", &end);', "show(d);", 'printf("[%s]\\n", end);')
            source.add(f'f = strtof("{literal}", &end);', "show(f);")
        for _ in range(4):
            literal = chance.choice(["", " ", "-", "+", "0x", "-0", "  \\t-"])
            literal += "".join(chance.choices("0123789abfz_", k=chance.randint(0, 12)))
            base = chance.choice([0, 0, 2, 8, 10, 16, 36])
            source.add(f'l = strtol("{literal}", &end, {base});', 'printf("%ld [%s]\\n", l, end);')
            source.add(f'printf("%llu\\n", strtoull("{literal}", NULL, {base}));')
        numbers = f"{chance.randint(-999, 999)} {chance.randint(0, 99)}abc {chance.random():.4f} z"
        source.add("i = n = 0; u = 0; d = 0; w[0] = 0;")
        source.add(f'i = sscanf("{numbers}", "%d %u%3s %lf", &n, &u, w, &d);')
        source.add('printf("%d %d %u %s %g\\n", i, n, u, w, d);')
