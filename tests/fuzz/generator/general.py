"""Topics: arithmetic, control flow, static objects."""

from __future__ import annotations

from tests.fuzz.generator.expressions import Expressions, Function
from tests.fuzz.generator.source import Source
from tests.fuzz.generator.statements import Statements, scalar_variables
from tests.fuzz.generator.types import ARITHMETIC, FLOAT, INT, INTEGERS, Type


def pure_function(source: Source, known: list[Function]) -> Function:
    """Write a function of its parameters, without side effects."""
    chance = source.chance
    result = chance.choice(ARITHMETIC)
    parameters = tuple(chance.choice(ARITHMETIC) for _ in range(chance.randint(1, 4)))
    name = source.name("f")
    names = [source.name("p") for _ in parameters]
    expressions = Expressions(chance, list(zip(names, parameters, strict=True)), [], known[-1:])
    statements = Statements(source, expressions, list(expressions.readable), turns=8)
    declared = [f"{ctype.name} {each}" for each, ctype in expressions.readable]
    as_passed = all(ctype.rank >= INT.rank and ctype is not FLOAT for ctype in parameters)
    old_style = as_passed and chance.random() < 0.5
    head = f"static {result.name} {name}({', '.join(names if old_style else declared)})"
    if old_style:
        source.add(head, *(f"    {each};" for each in declared))
        head = ""
    with source.block(head):
        statements.declare_array(chance.choice(INTEGERS))
        statements.some(3, 1)
        source.add(f"return {expressions.of(result, 2)};")
    source.add("")
    return Function(name, result, parameters, old_style)


def control(source: Source, functions: list[Function], name: str) -> None:
    """Nested statements of all kinds over local variables."""
    with source.block(f"static void {name}(void)"):
        statements = Statements(source, Expressions(source.chance, functions=functions))
        scalar_variables(statements, 5)
        statements.some(source.chance.randint(4, 8), 3)
        statements.show_all()


def promotions(source: Source, functions: list[Function], name: str) -> None:
    """Expressions that mix all types, shown with the types that they have."""
    with source.block(f"static void {name}(void)"):
        expressions = Expressions(source.chance, functions=functions)
        statements = Statements(source, expressions)
        scalar_variables(statements, 8)
        for _ in range(8):
            statements.show(*expressions.any(4))
        for ctype in ARITHMETIC:
            statements.declare(ctype, 2)
        statements.show_all()


def _file_scope(source: Source, ctype: Type) -> tuple[str, Type]:
    name = source.name("v")
    value = source.chance.choice(["", f" = {source.chance.randint(0, 99)}"])
    word = source.chance.choice(["static ", "", "static volatile "])
    source.add(f"{word}{ctype.name} {name}{value};")
    return name, ctype


def statics(source: Source, functions: list[Function], name: str) -> None:
    """File-scope variables and static locals, changed by several calls."""
    chance = source.chance
    objects = [_file_scope(source, chance.choice(ARITHMETIC)) for _ in range(4)]
    inner = source.name("step_")
    with source.block(f"static void {inner}(int turn)"):
        expressions = Expressions(chance, [*objects, ("turn", INT)], [], functions)
        statements = Statements(source, expressions, list(objects), turns=4)
        for _ in range(2):
            statements.declare(chance.choice(ARITHMETIC), storage="static ")
        statements.some(4, 2)
        statements.show_all()
    with source.block(f"static void {name}(void)"):
        source.add(f"for (int turn = 0; turn < 3; turn++) {inner}(turn);")
