"""Topics: variadic functions, functions as values, recursion, jumps out of functions."""

from __future__ import annotations

from tests.fuzz.generator.expressions import Expressions, Function
from tests.fuzz.generator.source import Source
from tests.fuzz.generator.statements import Statements, scalar_variables
from tests.fuzz.generator.texts import word
from tests.fuzz.generator.types import DOUBLE, INT, LLONG, ULLONG


def _argument(expressions: Expressions, letter: str, pair: str, wide: str) -> str:
    chance = expressions.chance
    if letter in "iuq":
        ctype = {"i": "int", "u": "unsigned", "q": "long long"}[letter]
        return f"({ctype})({expressions.integer(2)[0]})"
    if letter in "pw":
        first, second = chance.randint(-9, 9), chance.randint(0, 9)
        return f"(struct {pair if letter == 'p' else wide}){{ {first}, {second} }}"
    return word(chance, 6) if letter == "s" else expressions.floating(2)[0]


def varargs(source: Source, functions: list[Function], name: str) -> None:
    """Variadic functions: numbers, strings, structs, and lists passed on."""
    chance = source.chance
    pair, wide, outer, inner = (source.name(each) for each in ("Pair", "Wide", "vary", "each"))
    take = {
        "i": ("int", 'printf("%d\\n", {})'),
        "u": ("unsigned", 'printf("%u\\n", {})'),
        "q": ("long long", 'printf("%lld\\n", {})'),
        "d": ("double", "show({})"),
        "s": ("const char *", 'printf("%s\\n", {})'),
        "p": (f"struct {pair}", 'printf("%d %d\\n", {0}.x, {0}.y)'),
        "w": (f"struct {wide}", 'printf("%a %d\\n", {0}.d, {0}.c)'),
    }
    source.add("#include <stdarg.h>", f"struct {pair} {{ short x, y; }};")
    source.add(f"struct {wide} {{ double d; char c; }};")
    with (
        source.block(f"static void {inner}(const char *letters, va_list list)"),
        source.block("for (; *letters; letters++)"),
        source.block("switch (*letters)"),
    ):
        for letter, (ctype, show) in take.items():
            value = source.name("x")
            with source.block(f"case '{letter}':"):
                source.add(f"{ctype} {value} = va_arg(list, {ctype});")
                source.add(show.format(value) + ";", "break;")
    with source.block(f"static void {outer}(const char *letters, ...)"):
        source.add("va_list list, again;", "va_start(list, letters);", "va_copy(again, list);")
        source.add(f"{inner}(letters, list);", "va_end(list);")
        source.add(f"{inner}(letters, again);", "va_end(again);")
    with source.block(f"static void {name}(void)"):
        expressions = Expressions(chance, functions=functions)
        scalar_variables(Statements(source, expressions), 3)
        for _ in range(3):
            letters = chance.choices("iuqdspw", k=chance.randint(0, 6))
            values = [_argument(expressions, letter, pair, wide) for letter in letters]
            source.add(f"{outer}({', '.join([chr(34) + ''.join(letters) + chr(34), *values])});")


def function_pointers(source: Source, functions: list[Function], name: str) -> None:
    """Tables of functions, functions that take and return functions."""
    chance = source.chance
    kinds = chance.choice([("int", INT), ("double", DOUBLE), ("long long", LLONG)])
    type_name, ctype = kinds
    rows = []
    for _ in range(3):
        rows.append(source.name("g"))
        expressions = Expressions(chance, [("a", ctype), ("b", INT)], [], functions)
        with source.block(f"static {type_name} {rows[-1]}({type_name} a, int b)"):
            source.add(f"return {expressions.of(ctype, 2)};")
    signature = source.name("Call")
    pick, apply = source.name("pick"), source.name("apply")
    source.add(f"typedef {type_name} (*{signature})({type_name}, int);")
    source.add(
        f"static {signature} const {signature}_table[3] = {{ {rows[0]}, &{rows[1]}, {rows[2]} }};"
    )
    with source.block(f"static {type_name} (*{pick}(unsigned i))({type_name}, int)"):
        source.add(f"return i % 4 == 3 ? *{rows[0]} : {signature}_table[i % 4];")
    with source.block(f"static {type_name} {apply}({signature} call, {type_name} a, int b)"):
        source.add("return call ? (*call)(a, b) : (**&call == 0);")
    with source.block(f"static void {name}(void)"):
        expressions = Expressions(chance, functions=functions)
        statements = Statements(source, expressions)
        scalar_variables(statements, 2)
        source.add(f"struct {{ int n; {signature} call; }} object = {{ 1, {rows[1]} }};")
        for turn in range(4):
            a, b = expressions.of(ctype, 1), expressions.of(INT, 1)
            statements.show(f"{apply}({pick}({chance.randint(0, 9)}), {a}, {b})", ctype)
            source.add(f"object.call = {pick}({turn});")
            statements.show(f"object.call({a}, {b})", ctype)
            source.add(f'printf("%d\\n", object.call == {chance.choice(rows)});')


def recursion(source: Source, functions: list[Function], name: str) -> None:
    """Functions that call themselves and each other, to a limited depth."""
    chance = source.chance
    one, two = source.name("r"), source.name("r")
    source.add(f"static long long {two}(int depth, unsigned long long x);")
    operands = [("depth", INT), ("x", ULLONG)]
    for own, other in ((one, two), (two, one)):
        expressions = Expressions(chance, operands, [], functions[:1])
        with source.block(f"static long long {own}(int depth, unsigned long long x)"):
            source.add("long long left = 0;")
            source.add(f"if (depth <= 0) return {expressions.integer(2)[0]};")
            source.add(f"if ({expressions.condition(2)})")
            source.add(
                f"    left = {chance.choice((own, other))}(depth - 1, {expressions.integer(2)[0]});"
            )
            source.add(f"return left * 3 + {other}(depth - 2, x ^ (unsigned long long)left);")
    with source.block(f"static void {name}(void)"):
        for depth in (0, 1, 5, 9):
            source.add(f'printf("%lld\\n", {one}({depth}, {chance.randint(0, 2**40)}));')


def long_jumps(source: Source, functions: list[Function], name: str) -> None:
    """Jumps out of nested calls, back to `setjmp`."""
    chance = source.chance
    place, dive = source.name("place"), source.name("dive")
    source.add("#include <setjmp.h>", f"static jmp_buf {place};")
    with source.block(f"static int {dive}(int depth, int value)"):
        source.add(f"if (depth == 0) longjmp({place}, value);")
        source.add(f"return {dive}(depth - 1, value * 3 % 101) + 1;")
    with source.block(f"static void {name}(void)"):
        expressions = Expressions(chance, functions=functions)
        statements = Statements(source, expressions, turns=20)
        source.add("volatile int turns = 0, last = 0;")
        expressions.readable += [("turns", INT), ("last", INT)]
        source.add(f"switch (setjmp({place}))", "{")
        source.add("case 0: last += 1; break;", f"case {chance.randint(1, 9)}: last += 2; break;")
        source.add(f"default: last += {chance.randint(3, 99)};", "}")
        source.add("turns++;")
        statements.show(*expressions.integer(2))
        source.add(f"if (turns < 6) {dive}(turns, last + {chance.randint(0, 50)});")
        source.add('printf("%d %d\\n", turns, last);')
