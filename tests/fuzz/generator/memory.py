"""Topics: pointers and arrays, memory from the heap, sorting, arrays of variable length."""

from __future__ import annotations

from tests.fuzz.generator.expressions import Expressions, Function
from tests.fuzz.generator.source import Source
from tests.fuzz.generator.statements import Statements
from tests.fuzz.generator.types import ARITHMETIC, INT, INTEGERS


def pointers(source: Source, functions: list[Function], name: str) -> None:
    """Pointers that walk through arrays, pointers to pointers, rows of tables."""
    chance = source.chance
    ctype = chance.choice(INTEGERS[1:])
    with source.block(f"static void {name}(void)"):
        expressions = Expressions(chance, functions=functions)
        statements = Statements(source, expressions)
        array = statements.declare_array(ctype)
        source.add(f"{ctype.name} table[4][8] = {{ {{ 1, 2, 3 }}, {{ 4, 5 }}, {{ 0 }} }};")
        source.add(f"{ctype.name} *p = {array}, *q = {array} + 7, **pp = &p;")
        source.add(f"{ctype.name} (*row)[8] = table;", "char *bytes;", "(void)bytes;")
        expressions.readable += [("*p", ctype), ("*q", ctype), ("**pp", ctype)]
        expressions.readable += [("(*row)[3]", ctype), ("p[0]", ctype), ("(p < q)", INT)]
        statements.writable = [(f"({each})", ctype) for each in ("*p", "**pp", "*q", "(*row)[5]")]
        moves = [
            f"p = {array} + ({{}} & 7);",
            f"q = &{array}[{{}} & 7];",
            "pp = {} & 1 ? &p : &q;",
            "row = &table[{} & 3];",
            f"if (p < {array} + 7) *p++ = 5;",
            f"if (q > {array}) *--q = 6;",
            f"p = {array}; q = p + 7;",
            f"bytes = (char *){array}; bytes[{{}} & 7] ^= 1;",
            "memcpy(table[({} & 1) + 2], table[({} & 1)], sizeof table[0]);",
            f"memmove({array} + 1, {array}, 7 * sizeof *{array});",
            "while (q != p) {{ *q ^= 9; if (q < p) q++; else q--; }}",
            f'p = {array} + 3; printf("%d\\n", (int)(p[-2] + 2[p]));',
            'printf("%d %d\\n", (int)(&table[3][1] - &table[3][5]), (int)sizeof *row);',
            'printf("%d %d\\n", (int)(q - p), p == q);',
        ]
        for _ in range(9):
            move = chance.choice(moves)
            operands = [expressions.integer(1)[0] for _ in range(move.count("{}"))]
            source.add(move.format(*operands))
            statements.any(1)
        statements.writable = [(f"table[{i}][{j}]", ctype) for i in range(4) for j in (1, 5)]
        statements.show_all()


def sorting(source: Source, functions: list[Function], name: str) -> None:
    """`qsort` and `bsearch` over numbers and structs."""
    chance = source.chance
    ctype = chance.choice(ARITHMETIC[1:])
    by_value, by_key, row = source.name("by"), source.name("by"), source.name("Row")
    source.add(f"struct {row} {{ char key[6]; {ctype.name} value; }};")
    with source.block(f"static int {by_value}(const void *a, const void *b)"):
        source.add(f"{ctype.name} x = *(const {ctype.name} *)a, y = *(const {ctype.name} *)b;")
        source.add("return (x > y) - (x < y);")
    with source.block(f"static int {by_key}(const void *a, const void *b)"):
        source.add(f"const struct {row} *x = a, *y = b;", "return -strcmp(x->key, y->key);")
    with source.block(f"static void {name}(void)"):
        expressions = Expressions(chance, functions=functions)
        statements = Statements(source, expressions)
        array = statements.declare_array(ctype)
        source.add(f"struct {row} rows[9];")
        for index in range(8):
            source.add(f"{array}[{index}] = {expressions.of(ctype, 1)};")
            source.add(f"if ({array}[{index}] != {array}[{index}]) {array}[{index}] = 3;")
        with source.block("for (int i = 0; i < 9; i++)"):
            source.add('sprintf(rows[i].key, "%d", i * 37 % 11);')
            source.add(f"rows[i].value = {array}[i % 8];")
        source.add(f"qsort({array}, 8, sizeof *{array}, {by_value});")
        source.add(f"qsort(rows, 9, sizeof *rows, {by_key});")
        statements.show_all()
        with source.block("for (int i = 0; i < 9; i++)"):
            source.add('printf("%s ", rows[i].key);')
        source.add(f"{ctype.name} key = {array}[{chance.randint(0, 7)}];")
        source.add(f"{ctype.name} *found = bsearch(&key, {array}, 8, sizeof key, {by_value});")
        source.add('printf("%d\\n", found && *found == key);')


def lists(source: Source, functions: list[Function], name: str) -> None:
    """Linked nodes and growing arrays from the heap."""
    chance = source.chance
    node, ctype = source.name("Node"), chance.choice(ARITHMETIC[1:])
    source.add(f"struct {node} {{ {ctype.name} value; struct {node} *next; }};")
    with source.block(f"static void {name}(void)"):
        expressions = Expressions(chance, [("i", INT)], [], functions)
        statements = Statements(source, expressions)
        source.add(f"struct {node} *head = NULL, **tail = &head, *each, *next;")
        source.add(f"{ctype.name} *grown = NULL;", "int count = 0;")
        with source.block(f"for (int i = 0; i < {chance.randint(1, 12)}; i++)"):
            source.add("each = malloc(sizeof *each);", f"each->value = {expressions.of(ctype, 2)};")
            with source.block(f"if ({expressions.condition(2)})"):
                source.add("each->next = head;", "head = each;")
                source.add("if (tail == &head) tail = &each->next;")
            with source.block("else"):
                source.add("each->next = NULL;", "*tail = each;", "tail = &each->next;")
            source.add("grown = realloc(grown, ++count * sizeof *grown);")
            source.add("grown[count - 1] = each->value;")
        with source.block("for (each = head; each; each = next)"):
            statements.show("each->value", ctype)
            source.add("next = each->next;", "free(each);")
        with source.block("for (int i = 0; i < count; i++)"):
            statements.show("grown[i]", ctype)
        source.add("free(grown);")


def variable_arrays(source: Source, functions: list[Function], name: str) -> None:
    """Arrays of variable length, also as parameters."""
    chance = source.chance
    ctype, total = chance.choice(ARITHMETIC[6:]), source.name("total")
    with source.block(f"static {ctype.name} {total}(int n, int m, {ctype.name} table[n][m])"):
        source.add(f"{ctype.name} sum = 0;")
        with source.block("for (int i = 0; i < n; i++)"):
            source.add("for (int j = 0; j < m; j++) sum += table[i][j] * (i + 1);")
        source.add('printf("%u\\n", (unsigned)sizeof table[0]);', "return sum;")
    with source.block(f"static void {name}(void)"):
        expressions = Expressions(chance, [("i", INT), ("j", INT)], [], functions)
        statements = Statements(source, expressions)
        with source.block("for (int n = 1; n < 4; n++)"):
            source.add(f"int m = n + {chance.randint(0, 3)};", f"{ctype.name} table[n][m];")
            with source.block("for (int i = 0; i < n; i++)"):
                source.add(f"for (int j = 0; j < m; j++) table[i][j] = {expressions.of(ctype, 2)};")
            source.add('printf("%u\\n", (unsigned)sizeof table);')
            source.add(f"{ctype.name} (*row)[m] = table + n - 1;")
            statements.show("(*row)[m - 1]", ctype)
            statements.show(f"{total}(n, m, table)", ctype)
