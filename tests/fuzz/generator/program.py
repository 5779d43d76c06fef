"""A whole random program from a seed.

>>> text = generate(1)
>>> text == generate(1), text == generate(2)
(True, False)
"""

from __future__ import annotations

from collections.abc import Callable

from tests.fuzz.generator import calls, general, gnu, memory, records, texts
from tests.fuzz.generator.expressions import PRELUDE, Function
from tests.fuzz.generator.source import Source

Topic = Callable[[Source, list[Function], str], None]
"""Writes a function with a name that prints its results, and the declarations it needs."""

TOPICS: dict[str, Topic] = {
    "control": general.control,
    "promotions": general.promotions,
    "statics": general.statics,
    "bit_fields": records.bit_fields,
    "structs": records.structs,
    "unions": records.unions,
    "initialisers": records.initialisers,
    "printing": texts.printing,
    "strings": texts.strings,
    "numbers": texts.numbers,
    "varargs": calls.varargs,
    "function_pointers": calls.function_pointers,
    "recursion": calls.recursion,
    "long_jumps": calls.long_jumps,
    "pointers": memory.pointers,
    "sorting": memory.sorting,
    "lists": memory.lists,
    "variable_arrays": memory.variable_arrays,
    "nested_statements": gnu.nested_statements,
    "atomics": gnu.atomics,
    "complex_numbers": gnu.complex_numbers,
    "complex_integers": gnu.complex_integers,
    "inline_functions": gnu.inline_functions,
    "bit_fields_by_value": gnu.bit_fields_by_value,
    "constant_tables": gnu.constant_tables,
    "nested_functions": gnu.nested_functions,
}


def generate(seed: int) -> str:
    """Return a program without undefined behaviour that prints its results."""
    source = Source(seed)
    source.add(*PRELUDE.splitlines(), "")
    functions: list[Function] = []
    for _ in range(source.chance.randint(2, 4)):
        functions.append(general.pure_function(source, functions))
    chosen = source.chance.choices(sorted(TOPICS), k=source.chance.randint(4, 7))
    names = []
    for topic in ["control", *chosen]:
        name = source.name(f"{topic}_")
        names.append(name)
        TOPICS[topic](source, functions, name)
        source.add("")
    with source.block("int main(void)"):
        source.add(*(f"{name}();" for name in names), "return 0;")
    return source.text()
