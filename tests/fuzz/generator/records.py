"""Topics: structs, unions, bit-fields: their layout, their values, their initialisers."""

from __future__ import annotations

from dataclasses import dataclass

from tests.fuzz.generator.expressions import Expressions, Function, Typed
from tests.fuzz.generator.source import Source
from tests.fuzz.generator.statements import Statements
from tests.fuzz.generator.types import (
    ARITHMETIC,
    BOOL,
    CHAR,
    INT,
    INTEGERS,
    LLONG,
    UCHAR,
    UINT,
    ULLONG,
    USHORT,
    Type,
)

BIT_FIELD_TYPES = [INT, UINT, INT, UINT, UCHAR, USHORT, CHAR, BOOL, LLONG, ULLONG]


@dataclass
class Record:
    """A struct or union type, and the paths to its scalar members."""

    name: str
    members: list[Typed]


def _bit_field(source: Source) -> tuple[str, Typed | None]:
    """Return a declaration of a bit-field, and how its value takes part in expressions."""
    chance = source.chance
    ctype = chance.choice(BIT_FIELD_TYPES)
    width = 1 if ctype is BOOL else chance.randint(1, ctype.bits)
    if chance.random() < 0.1:
        return f"{ctype.name} : {chance.choice([0, width])};", None
    name = source.name("b")
    signed = "signed " if ctype is INT else ""
    taken = Type("bit-field", ctype.rank, width, ctype.signed, ctype.conversion)
    return f"{signed}{ctype.name} {name} : {width};", (name, taken)


def record(source: Source, inside: list[Record], *, bits: float, word: str = "struct") -> Record:
    """Declare a record type with members of all kinds."""
    chance = source.chance
    made = Record(f"{word} {source.name('S')}", [])
    with source.block(made.name, "};"):
        for _ in range(chance.randint(2, 6)):
            name = source.name("m")
            draw = chance.random()
            if draw < bits:
                text, member = _bit_field(source)
                source.add(text)
                made.members += [member] if member else []
            elif draw < bits + 0.15 and inside:
                inner = chance.choice(inside)
                source.add(f"{inner.name} {name};")
                made.members += [(f"{name}.{path}", ctype) for path, ctype in inner.members]
            elif draw < bits + 0.3:
                ctype = chance.choice(INTEGERS)
                source.add(f"{ctype.name} {name}[3];")
                made.members += [(f"{name}[{index}]", ctype) for index in range(3)]
            else:
                ctype = chance.choice(ARITHMETIC)
                source.add(f"{ctype.name} {name};")
                made.members.append((name, ctype))
        last = source.name("m")
        source.add(f"int {last};")
        made.members.append((last, INT))
    source.add("")
    return made


def _promoted(members: list[Typed]) -> list[Typed]:
    """Return members as operands; gcc computes in the width of a wide bit-field."""
    return [
        (f"({_wide(ctype).name}){path}", _wide(ctype))
        if ctype.name == "bit-field"
        else (path, ctype)
        for path, ctype in members
        if not ctype.is_float
    ]


def _wide(ctype: Type) -> Type:
    """Return the type that a bit-field's value is promoted or cast to."""
    if ctype.bits < INT.bits or (ctype.bits == INT.bits and ctype.signed):
        return INT
    if ctype.bits == INT.bits:
        return UINT
    return LLONG if ctype.signed else ULLONG


def dump_function(source: Source) -> str:
    """Write a function that prints the bytes of an object."""
    name = source.name("dump")
    with source.block(f"static void {name}(const void *object, unsigned size)"):
        source.add("const unsigned char *byte = object;")
        with source.block("for (unsigned i = 0; i < size; i++)"):
            source.add('printf("%02x", byte[i]);')
        source.add('printf("\\n");')
    source.add("")
    return name


def bit_fields(source: Source, functions: list[Function], name: str) -> None:
    """Bit-fields: layout, truncation, and neighbours."""
    inner = record(source, [], bits=0.8)
    outer = record(source, [inner], bits=0.6)
    dump = dump_function(source)
    with source.block(f"static void {name}(void)"):
        source.add(f"{outer.name} s;", "memset(&s, 0, sizeof s);")
        source.add(f"struct {{ char c; {outer.name} s; }} beside;", "(void)beside;")
        source.add('printf("%u %u\\n", (unsigned)sizeof s, (unsigned)sizeof beside);')
        members = [(f"s.{path}", ctype) for path, ctype in outer.members]
        expressions = Expressions(source.chance, _promoted(members), [], functions)
        statements = Statements(source, expressions, members)
        whole = [(text, ctype) for text, ctype in members if not ctype.is_float]
        for text, ctype in whole:
            source.add(f"{text} = {expressions.of(ctype, 1)};")
        statements.writable = [each for each in whole if each[1].bits >= 8]
        source.add(f"{dump}(&s, sizeof s);")
        statements.some(5, 1) if statements.writable else None
        for text, ctype in source.chance.sample(whole, min(3, len(whole))):
            form = source.chance.choice(["{}++;", "--{};", "{} ^= 3;", "{} += 7;", "{} = ~{};"])
            source.add(form.format(text, text) if ctype.rank else f"{text} = !{text};")
        source.add(f"{dump}(&s, sizeof s);", f"{outer.name} copy = s;")
        for text, ctype in whole:
            conversion = "%lld" if ctype.bits > 32 else "%d"
            cast = "long long" if ctype.bits > 32 else "int"
            source.add(f'printf("{conversion}\\n", ({cast})copy{text[1:]});')
        source.add(f'printf("%d\\n", s.{whole[0][0][2:]} - 100 < 0);')


def structs(source: Source, functions: list[Function], name: str) -> None:
    """Structs by value: arguments, results, assignments, arrays, compound literals."""
    chance = source.chance
    inner = record(source, [], bits=0.2)
    outer = record(source, [inner], bits=0.2)
    change, show = source.name("change"), source.name("show_")
    with source.block(f"static {outer.name} {change}({outer.name} s, int by, {inner.name} other)"):
        members = [(f"s.{path}", ctype) for path, ctype in outer.members]
        others = [(f"other.{path}", ctype) for path, ctype in inner.members]
        expressions = Expressions(chance, [*_promoted([*members, *others]), ("by", INT)])
        for text, ctype in chance.sample(members, min(4, len(members))):
            source.add(f"{text} = {expressions.of(ctype, 2)};")
        source.add("return s;")
    source.add("")
    with source.block(f"static void {show}({outer.name} s)"):
        for text, ctype in outer.members:
            if ctype.is_float:
                source.add(f"show(s.{text});")
            else:
                source.add(f'printf("%lld ", (long long)s.{text});')
        source.add('printf("\\n");')
    source.add("")
    with source.block(f"static void {name}(void)"):
        source.add(f"{outer.name} s[3] = {{ {{ 0 }} }}, *p = s;")
        last = outer.members[-1][0]
        source.add(f"{inner.name} other = {{ 0 }};", f"other.{inner.members[-1][0]} = 77;")
        for turn in range(3):
            source.add(
                f"s[{turn}] = {change}(s[{(turn + 2) % 3}], {chance.randint(-99, 99)}, other);"
            )
            source.add(f"p[{turn}].{last} += {change}(*p, {turn}, other).{last};")
        source.add(f"*p = p->{last} & 1 ? p[1] : p[2];")
        source.add(f"{show}(({outer.name}){{ .{last} = 5 }});")
        with source.block("for (int i = 0; i < 3; i++)"):
            source.add(f"{show}(s[i]);")


def unions(source: Source, functions: list[Function], name: str) -> None:
    """Unions: one member written, another read."""
    chance = source.chance
    with source.block(f"static void {name}(void)"):
        source.add(
            "union { float f; double d; unsigned u; long long ll;",
            "    unsigned char bytes[8]; short s[4]; } u;",
            "memset(&u, 0, sizeof u);",
        )
        expressions = Expressions(chance, [("u.u", UINT), ("u.s[1]", INTEGERS[4]), ("u.ll", LLONG)])
        expressions.functions = functions
        for _ in range(6):
            member = chance.choice(["f", "d", "u", "ll", "bytes[3]", "s[2]"])
            if member in ("f", "d"):
                source.add(f"u.{member} = limit({expressions.floating(2)[0]}, 1e9);")
            else:
                source.add(f"u.{member} = {expressions.integer(2)[0]};")
            source.add('printf("%llx %u %d\\n", u.ll, u.u, u.s[0]);')


def initialisers(source: Source, functions: list[Function], name: str) -> None:
    """Initialisers: positions, designators, missing braces, strings, nesting."""
    chance = source.chance
    inner, outer, dump = source.name("In"), source.name("Out"), dump_function(source)
    with source.block(f"struct {inner}", "};"):
        source.add("int x;", "short y[3];", "char text[6];")
    with source.block(f"struct {outer}", "};"):
        source.add(
            "int a;", f"struct {inner} in[2];", "union { int i; short s[2]; } u;", "int z[2][2];"
        )
    number = lambda: str(chance.randint(-99, 99))  # noqa: E731 - three letters, used everywhere
    word = lambda: '"' + "".join(chance.choices("abcxyz", k=chance.randint(0, 3))) + '"'  # noqa: E731

    def inside() -> str:
        return chance.choice([
            f"{{ {number()}, {{ {number()}, {number()} }}, {word()} }}",
            f"{{ .y = {{ [1] = {number()} }}, .x = {number()} }}",
            f"{{ {number()}, {number()}, {number()}, {number()}, {word()} }}",
            f"{{ .text = {word()} }}",
        ])  # fmt: skip

    def outside() -> str:
        rows = [
            f".a = {number()}", f".in = {{ {inside()}, {inside()} }}", f".in[1] = {inside()}",
            f".in[0].y[2] = {number()}", f".u = {{ .i = {number()} }}",
            f".z[1] = {{ {number()} }}", f".z = {{ {{ {number()} }}, {{ {number()}, 1 }} }}",
            f".in[1].y[0] = {number()}, {number()}, {number()}", f".z[0][1] = {number()}",
        ]  # fmt: skip
        return "{ " + ", ".join(chance.sample(rows, chance.randint(1, 5))) + " }"

    with source.block(f"static void {name}(void)"):
        for storage in ("static ", "", "static const "):
            each = source.name("o")
            source.add(f"{storage}struct {outer} {each} = {outside()};")
            source.add(f"{dump}(&{each}, sizeof {each});")
        each = source.name("o")
        index = chance.randint(0, 3)
        rows = f"[{index}] = {outside()}, {outside()}, [0] = {outside()}"
        source.add(f"static struct {outer} {each}[] = {{ {rows} }};")
        source.add(f"{dump}({each}, sizeof {each});")
