"""Random statements: assignments, branches, loops that end, jumps.

A statement has at most one side effect between sequence points, and does not read what it changes.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from tests.fuzz.generator.expressions import Expressions, Typed
from tests.fuzz.generator.source import Source
from tests.fuzz.generator.types import ARITHMETIC, INT, INTEGERS, Type

TURNS = 400
"""How often a statement may be executed in all nested loops together."""


@dataclass
class Statements:
    """Generates statements over some variables.

    Attributes:
        source: receives the text.
        expressions: generates operands.
        writable: lvalues to assign to, all of them also readable.
        turns: how often the current statement is executed.
        loops: enclosing loops and switches for `break`, and loops for `continue`.
    """

    source: Source
    expressions: Expressions
    writable: list[Typed] = field(default_factory=list)
    turns: int = 1
    loops: list[str] = field(default_factory=list)

    def declare(self, ctype: Type, depth: int = 2, storage: str = "") -> str:
        """Declare a variable of a type, and add it to the operands."""
        name = self.source.name("v")
        value = self.expressions.of(ctype, depth)
        if storage.startswith("static"):
            value = str(self.source.chance.randint(0, 99))
        self.source.add(f"{storage}{ctype.name} {name} = {value};")
        self.expressions.readable.append((name, ctype))
        self.writable.append((name, ctype))
        return name

    def declare_array(self, ctype: Type) -> str:
        """Declare an array of eight elements."""
        name = self.source.name("a")
        count = self.source.chance.randint(1, 8)
        values = ", ".join(self.expressions.of(ctype, 1) for _ in range(count))
        self.source.add(f"{ctype.name} {name}[8] = {{ {values} }};")
        self.expressions.arrays.append((name, ctype))
        return name

    def show(self, text: str, ctype: Type) -> None:
        """Print a value."""
        if ctype.is_float:
            self.source.add(f"show({text});")
        else:
            self.source.add(f'printf("{ctype.conversion}\\n", {text});')

    def show_all(self) -> None:
        """Print everything that the statements could change."""
        for text, ctype in self.writable:
            self.show(text, ctype)
        for name, ctype in self.expressions.arrays:
            index = self.source.name("i")
            with self.source.block(f"for (int {index} = 0; {index} < 8; {index}++)"):
                self.show(f"{name}[{index}]", ctype)

    def some(self, count: int, depth: int) -> None:
        """Write some statements."""
        for _ in range(count):
            self.any(depth)

    def any(self, depth: int) -> None:
        """Write a statement."""
        simple = [self.assign] * 5 + [self.compound] * 3 + [self.step, self.step_in_expression]
        simple += [self.store] * 2
        if depth > 0:
            simple += [self.branch] * 3 + [self.loop] * 3 + [self.switch] * 2
            simple += [self.block, self.jump_ahead, self.jump_back]
        if self.loops:
            simple += [self.leave]
        statement = self.source.chance.choice(simple)
        if statement in (self.loop, self.jump_back) and self.turns * 4 > TURNS:
            statement = self.assign
        if statement in (
            self.assign,
            self.compound,
            self.step,
            self.step_in_expression,
            self.store,
        ):
            statement(2)
        else:
            statement(depth - 1)

    def body(self, depth: int) -> None:
        """Write the inside of a block, sometimes with local variables."""
        known = len(self.expressions.readable), len(self.writable), len(self.expressions.arrays)
        if self.source.chance.random() < 0.4:
            self.declare(self.source.chance.choice(ARITHMETIC), 1)
        self.some(self.source.chance.randint(1, 3), depth)
        del self.expressions.readable[known[0] :]
        del self.writable[known[1] :]
        del self.expressions.arrays[known[2] :]

    def assign(self, depth: int) -> None:
        target, ctype = self.source.chance.choice(self.writable)
        self.source.add(f"{target} = {self.expressions.of(ctype, depth)};")

    def store(self, depth: int) -> None:
        """Write to an element with a variable index."""
        if not self.expressions.arrays:
            return self.assign(depth)
        name, ctype = self.source.chance.choice(self.expressions.arrays)
        index, _ = self.expressions.integer(1)
        self.source.add(f"{name}[{index} & 7] = {self.expressions.of(ctype, depth)};")
        return None

    def compound(self, depth: int) -> None:
        """Write a compound assignment whose result is always in range."""
        target, ctype = self.source.chance.choice(self.writable)
        chance, make = self.source.chance, self.expressions
        if ctype.is_float:
            self.source.add(f"{target} {chance.choice('+-*/')}= {make.any(depth)[0]};")
            return
        operator = chance.choice(["+", "-", "*", "&", "|", "^", "/", "%", "<<", ">>", "float"])
        value = make.integer(depth)[0]
        if operator in "/%":
            value = f"({value} & 63) + 1"
        elif operator in ("<<", ">>"):
            value = f"{value} & 7"
        elif operator == "float":
            self.source.add(f"{target} %= 10;")
            operator, value = "+", f"size({make.floating(depth)[0]}, 100)"
            if ctype.rank == 0:
                value = make.integer(depth)[0]
        self.source.add(f"{target} {operator}= {value};")

    def step(self, _depth: int) -> None:
        target, _ = self.source.chance.choice(self.writable)
        form = self.source.chance.choice(["{}++", "{}--", "++{}", "--{}"])
        self.source.add(form.format(target) + ";")

    def step_in_expression(self, depth: int) -> None:
        """Write an assignment that steps another variable, which is not read elsewhere in it."""
        target, ctype = self.source.chance.choice(self.writable)
        others = [each for each in self.writable if each[0] != target and not each[1].is_float]
        plain = [each for each in others if each[0].startswith("v")]
        if not plain:
            return self.assign(depth)
        stepped = self.source.chance.choice(plain)
        readable = self.expressions.readable
        self.expressions.readable = [each for each in readable if each[0] != stepped[0]]
        form = self.source.chance.choice(["{}++", "{}--", "++{}", "--{}", "({} ^= 5)"])
        value, own = self.expressions.any(depth)
        self.expressions.readable = readable
        whole = f"({value} {self.source.chance.choice('+-')} {form.format(stepped[0])})"
        self.source.add(f"{target} = {self.expressions.fitted(whole, own, ctype)};")
        return None

    def branch(self, depth: int) -> None:
        with self.source.block(f"if ({self.expressions.condition(2)})"):
            self.body(depth)
        if self.source.chance.random() < 0.5:
            with self.source.block("else"):
                self.body(depth)

    def block(self, depth: int) -> None:
        with self.source.block(""):
            self.body(depth)

    def loop(self, depth: int) -> None:
        """Write a loop with a counter that nothing else changes."""
        counter, turns = self.source.name("n"), self.source.chance.randint(1, 5)
        kind = self.source.chance.choice(["for", "for", "down", "while", "do"])
        heads = {
            "for": f"for (int {counter} = 0; {counter} < {turns}; {counter}++)",
            "down": f"for (unsigned char {counter} = {turns}; {counter}-- > 0;)",
            "while": f"while ({counter}-- > 0 && {self.expressions.condition(1)})",
            "do": "do",
        }
        tail = f"}} while (++{counter} < {turns});" if kind == "do" else "}"
        if kind in ("while", "do"):
            self.source.add(f"int {counter} = {turns if kind == 'while' else 0};")
        self.turns *= turns
        self.loops.append("loop")
        self.expressions.readable.append((counter, INT))
        with self.source.block(heads[kind], tail):
            self.body(depth)
        if kind in ("for", "down"):
            self.expressions.readable.remove((counter, INT))
        self.loops.pop()
        self.turns //= turns

    def switch(self, depth: int) -> None:
        """Write a switch with fall-through, a default anywhere, sometimes on `long long`."""
        chance = self.source.chance
        value, ctype = self.expressions.integer(2)
        values = sorted(chance.sample(range(-3, 12), chance.randint(1, 5)))
        if chance.random() < 0.2:
            values = [each * 0x100000001 for each in values]
            value = f"(long long)({value})"
        elif chance.random() < 0.7:
            value = f"{value} % 8"
        if not ctype.signed:
            values = [each for each in values if each >= 0]
        labels = [f"case {each}:" for each in values]
        labels.insert(chance.randint(0, len(labels)), "default:")
        self.loops.append("switch")
        with self.source.block(f"switch ({value})"):
            for label in labels:
                self.source.add(label)
                with self.source.block(""):
                    self.body(depth)
                if chance.random() < 0.6:
                    self.source.add("break;")
        self.loops.pop()

    def leave(self, _depth: int) -> None:
        word = self.source.chance.choice(["break", "continue" if "loop" in self.loops else "break"])
        self.source.add(f"if ({self.expressions.condition(1)}) {word};")

    def jump_ahead(self, depth: int) -> None:
        label = self.source.name("ahead")
        self.source.add(f"if ({self.expressions.condition(2)}) goto {label};")
        with self.source.block(""):
            self.body(depth)
        self.source.add(f"{label}:;")

    def jump_back(self, depth: int) -> None:
        label, counter, turns = self.source.name("back"), self.source.name("n"), 3
        self.source.add(f"int {counter} = 0;", f"{label}:;")
        self.turns *= turns
        with self.source.block(""):
            self.body(depth)
        self.turns //= turns
        condition = self.expressions.condition(1)
        self.source.add(f"if (++{counter} < {turns} && {condition}) goto {label};")


def scalar_variables(statements: Statements, count: int) -> None:
    """Declare some variables of random types, and an array."""
    chance = statements.source.chance
    for _ in range(count):
        statements.declare(chance.choice(ARITHMETIC), 1)
    statements.declare_array(chance.choice(INTEGERS))
