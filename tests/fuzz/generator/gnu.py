"""Topics: statement expressions, atomics, complex numbers, nested functions, as in GNU C.

Also inline functions, bit-fields in structs by value, and constants in static initialisers.
"""

from __future__ import annotations

from tests.fuzz.generator.expressions import Expressions, Function
from tests.fuzz.generator.source import Source
from tests.fuzz.generator.statements import Statements, scalar_variables
from tests.fuzz.generator.types import (
    ARITHMETIC,
    INT,
    INTEGERS,
    LLONG,
    UINT,
    USHORT,
    Type,
    common,
)

ATOMIC = [INT, UINT, USHORT, LLONG]
PARTS = ["__real__", "__imag__"]
COMPLEX_INTEGERS = ["short", "unsigned char", "int", "unsigned", "long long"]
QUOTIENT = "(float _Complex)({} / ({}))"


def _largest(source: Source, expressions: Expressions, depth: int) -> tuple[str, Type]:
    """Return nested statement expressions, each the larger of two values."""
    chance = source.chance
    if depth == 0:
        return expressions.integer(2)
    (left, left_type), (right, right_type) = (
        _largest(source, expressions, depth - 1),
        _largest(source, expressions, chance.randint(0, depth - 1)),
    )
    a, b = source.name("a"), source.name("b")
    body = f"__typeof__({left}) {a} = ({left}); __typeof__({right}) {b} = ({right});"
    value = f"{a} {chance.choice('<>')} {b} ? {a} : {b}"
    if chance.random() < 0.3:
        value = f"({{ if ({a} == {b}) {a} ^= 5; {value}; }})"
    return f"({{ {body} {value}; }})", common(left_type, right_type)


def nested_statements(source: Source, functions: list[Function], name: str) -> None:
    """Statement expressions inside each other, as values of expressions."""
    with source.block(f"static void {name}(void)"):
        expressions = Expressions(source.chance, functions=functions[-1:])
        statements = Statements(source, expressions)
        scalar_variables(statements, 4)
        for _ in range(4):
            text, ctype = _largest(source, expressions, 2)
            target, own = source.chance.choice(statements.writable)
            source.add(f"{target} = {expressions.fitted(text, ctype, own)};")
            statements.show(f"({text}) + 1", common(ctype, INT))
        statements.show_all()


def _atomic_operation(source: Source, name: str, ctype: Type, value: str) -> str:
    """Return an atomic operation on a variable."""
    chance = source.chance
    word = chance.choice(["add", "sub", "or", "and", "xor", "nand"])
    return chance.choice(
        [
            f"__sync_fetch_and_{word}(&{name}, {value})",
            f"__sync_{word}_and_fetch(&{name}, {value})",
            f"__atomic_fetch_{word}(&{name}, {value}, 5)",
            f"__atomic_{word}_fetch(&{name}, {value}, 0)",
            f"__atomic_exchange_n(&{name}, {value}, 5)",
            f"__sync_val_compare_and_swap(&{name}, {value}, ({ctype.name})7)",
            f"__sync_bool_compare_and_swap(&{name}, {name}, {value})",
            f"__atomic_load_n(&{name}, 5)",
        ]
    )


def atomics(source: Source, functions: list[Function], name: str) -> None:
    """Atomic operations, whose results take part in expressions."""
    chance = source.chance
    with source.block(f"static void {name}(void)"):
        expressions = Expressions(chance, functions=functions[-1:])
        statements = Statements(source, expressions)
        for _ in range(3):
            statements.declare(chance.choice(ATOMIC), 1)
        for _ in range(8):
            target, ctype = chance.choice(statements.writable)
            value = expressions.of(ctype, 1)
            source.add(f"static volatile {ctype.name} {(kept := source.name('k'))};")
            source.add(f"{kept} = {_atomic_operation(source, target, ctype, value)};")
            source.add('__asm__ volatile ("" ::: "memory");')
            statements.show(kept, ctype)
        statements.show_all()


def complex_numbers(source: Source, functions: list[Function], name: str) -> None:
    """Arithmetic of complex and real numbers; both parts are shown.

    Quotients are rounded to float: gcc's library for i386 computes them in 80 bits.
    """
    chance = source.chance
    inner = source.name("z")
    with source.block(f"static double _Complex {inner}(double _Complex x, float _Complex y)"):
        quotient = QUOTIENT.format("x", "y + 1")
        source.add(f"return {chance.choice(['x * y', 'x + y', '~x - y', quotient, '-y'])};")
    with source.block(f"static void {name}(void)"):
        expressions = Expressions(chance, functions=functions)
        names = [source.name("c") for _ in range(4)]
        for each in names:
            ctype = chance.choice(["double _Complex", "float _Complex"])
            parts = [f"limit({expressions.floating(1)[0]}, 1e6)" for _ in PARTS]
            source.add(f"{ctype} {each} = {parts[0]} + {parts[1]} * 1.0i;")
        for _ in range(8):
            left, right = chance.choice(names), chance.choice(names)
            real = f"limit({expressions.any(1)[0]}, 1e6)"
            value = chance.choice(
                [f"{left} {chance.choice('+-*')} {right}", f"{left} {chance.choice('+-*')} {real}",
                 QUOTIENT.format(left, right),
                 f"{real} {chance.choice('+-*')} {right}", f"{inner}({left}, {right})",
                 f"{left} == {right} ? {left} : ~{right}", f"({left} ? {left} : {real})"]
            )  # fmt: skip
            form = chance.choice(["{} = {};", "{} += {};", "{} -= {};"])
            source.add(form.format(chance.choice(names), value))
            for part in PARTS:
                source.add(f"show({part} {chance.choice(names)});")
        source.add(f"{chance.choice(PARTS)} {names[0]} = 2;", f"{names[0]}++;")
        for each in names:
            source.add(*(f"show({part} {each});" for part in PARTS))


def complex_integers(source: Source, functions: list[Function], name: str) -> None:
    """Arithmetic of complex integers, whose parts wrap as the types of integers do."""
    chance = source.chance
    words = [chance.choice(COMPLEX_INTEGERS) for _ in range(2)]
    inner = source.name("z")
    with source.block(f"static {words[0]} _Complex {inner}({words[0]} _Complex x, int _Complex y)"):
        source.add(f"return {chance.choice(['x * y', 'x + ~y', 'x - y', '-x', 'x == y'])};")
    with source.block(f"static void {name}(void)"):
        expressions = Expressions(chance, functions=functions)
        names = [source.name("c") for _ in range(4)]
        for each in names:
            source.add(f"{chance.choice(words)} _Complex {each};")
            source.add(*(f"{part} {each} = {expressions.integer(1)[0]};" for part in PARTS))
        for _ in range(8):
            left, right = chance.choice(names), chance.choice(names)
            number, op = expressions.integer(1)[0], chance.choice("+-*")
            value = chance.choice(
                [f"{left} {op} {right}", f"{left} {op} {number}", f"{number} {op} {right}",
                 f"{inner}({left}, {right})",
                 f"{left} / (1 + ({number} & 15))", f"{left} / (1 + ({number} & 7) + 3i)",
                 f"{left} != {right} ? -{left} : ~{right}", f"({left} ? {left} : {number})"]
            )  # fmt: skip
            form = chance.choice(["{} = {};", "{} += {};", "{} -= {};", "{} *= {};"])
            source.add(form.format(chance.choice(names), value), f"{chance.choice(names)}++;")
        for each in names:
            source.add(*(f'printf("%lld\\n", (long long){part} {each});' for part in PARTS))


def inline_functions(source: Source, functions: list[Function], name: str) -> None:
    """Inline functions of all kinds; one has another body than its inline definition."""
    chance, made = source.chance, []
    for head in ("static inline", "inline", "extern inline", "extern inline GNU"):
        ctype, parameter = chance.choice(INTEGERS), source.name("p")
        expressions = Expressions(chance, [(parameter, ctype)])
        own = source.name("i")
        declared = f"{ctype.name} {own}({ctype.name} {parameter})"
        if head == "inline":
            source.add(f"extern {declared};")
        words = head.replace("GNU", "__attribute__((gnu_inline))")
        value = expressions.of(ctype, 2)
        with source.block(f"{words} {declared}"):
            source.add(f"return {value};")
        if words != head:
            with source.block(declared):
                source.add(f"return {value};")
        made.append(Function(own, ctype, (ctype,)))
    with source.block(f"static void {name}(void)"):
        statements = Statements(source, Expressions(chance, functions=made))
        scalar_variables(statements, 3)
        statements.some(3, 1)
        for each in made:
            statements.show(f"{each.name}({chance.randint(0, 99)})", each.result)
        statements.show_all()


def bit_fields_by_value(source: Source, functions: list[Function], name: str) -> None:
    """Structs of bit-fields as arguments, results and assigned values."""
    chance = source.chance
    tag, step = source.name("B"), source.name("turn_")
    widths = [chance.randint(1, 31) for _ in range(5)]
    with source.block(f"struct {tag}", "};"):
        for number, width in enumerate(widths):
            source.add(f"{chance.choice(['unsigned', 'signed'])} int f{number} : {width};")
        source.add("short last;")
    members = [f"f{number}" for number in range(len(widths))]
    with source.block(f"static struct {tag} {step}(struct {tag} one, struct {tag} other)"):
        for _ in range(4):
            target, left, right = (chance.choice(members) for _ in range(3))
            source.add(f"one.{target} = (unsigned)one.{left} * 3 + (unsigned)other.{right};")
        source.add("one.last += other.last;", "return one;")
    with source.block(f"static void {name}(void)"):
        values = [", ".join(str(chance.randint(0, 300)) for _ in widths) for _ in range(2)]
        source.add(f"struct {tag} a = {{ {values[0]}, 7 }}, b = {{ {values[1]}, 9 }}, c;")
        source.add(f"c = {step}(a, {step}(b, a));", "b = (a.last > 3 ? c : a);")
        for each in ("a", "b", "c", f"{step}(c, b)"):
            source.add(
                *(f'printf("%d\\n", (int){each}.{member});' for member in [*members, "last"])
            )


def constant_tables(source: Source, functions: list[Function], name: str) -> None:
    """Constant variables and tables in static initialisers and conditions."""
    chance = source.chance
    scalars = []
    for _ in range(3):
        ctype, own = chance.choice([INT, UINT, LLONG]), source.name("K")
        terms = [str(chance.randint(0, 1000)), *(each for each, _ in scalars)]
        value = f"{chance.choice(terms)} {chance.choice('+-*')} {chance.choice(terms)}"
        source.add(f"static const {ctype.name} {own} = {value};")
        scalars.append((own, ctype))
    table, length = source.name("t"), chance.randint(3, 8)
    values = [
        f"[{index}] = {chance.choice(scalars)[0]} {chance.choice('+-^&')} {chance.randint(0, 99)}"
        for index in sorted(chance.sample(range(length), chance.randint(1, length)))
    ]
    source.add(f"static const int {table}[{length}] = {{ {', '.join(values)} }};")
    builtins = ["__builtin_popcount(255)", "__builtin_clz(9)", "(__builtin_bswap32(7) >> 24)"]
    source.add(f"static int {table}_count = {chance.choice(builtins)} + {scalars[0][0]};")
    with source.block(f"static void {name}(void)"):
        statements = Statements(source, Expressions(chance, list(scalars)))
        source.add(f"static long long sum = {scalars[1][0]};")
        with source.block(f"for (int i = 0; i < {length}; i++)"):
            source.add(f"sum += {table}[i];", f'printf("%d\\n", {table}[i] + {table}_count);')
        statements.show("sum", LLONG)
        for each, ctype in scalars:
            statements.show(each, ctype)


def nested_functions(source: Source, functions: list[Function], name: str) -> None:
    """Nested functions that change outer variables, called directly and through pointers."""
    chance = source.chance
    apply = source.name("apply_")
    with source.block(f"static int {apply}(int (*visit)(int), int count)"):
        source.add("int sum = 0;", "while (count-- > 0) sum += visit(count);", "return sum;")
    with source.block(f"static int {name}_in(int depth, int (*outer)(int))"):
        expressions = Expressions(chance, [("depth", INT)], functions=functions[-1:])
        statements = Statements(source, expressions, turns=20)
        for _ in range(3):
            statements.declare(chance.choice(ARITHMETIC), 1)
        inner = source.name("inner_")
        with source.block(f"int {inner}(int x)"):
            expressions.readable.append(("x", INT))
            statements.some(2, 1)
            source.add(f"return {expressions.of(INT, 1)} + (outer ? outer(x) : 0);")
            expressions.readable.remove(("x", INT))
        source.add(f"int result = {inner}(3) + {apply}({inner}, 3);")
        source.add(f"if (depth > 0) result ^= {name}_in(depth - 1, {inner});")
        statements.show_all()
        source.add("return result;")
    with source.block(f"static void {name}(void)"):
        source.add(f'printf("%d\\n", {name}_in(2, 0));')
