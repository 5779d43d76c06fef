"""Fuzzing of the front end: `make fuzz-frontend`.

The sources are random bytes, programs with tokens deleted, doubled, swapped and cut off, and deeply
nested constructs. For each there must soon be a program or an error with a location.
"""

from __future__ import annotations

import random
import re
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Final

from crs_cc.core.errors import CompileError
from crs_cc.core.source import Diagnostics
from crs_cc.frontend.unit import compile_text
from crs_cc.ir.verify import verify
from crs_cc.session.library import library_options

CORPUS: Final = Path(__file__).parent.parent / "c"
FINDINGS: Final = Path("build/fuzz-frontend")
TOKEN: Final = re.compile(r"[A-Za-z_]\w*|\d[\w.]*|\"(?:\\.|[^\"\n])*\"|[^\s\w]|\n")
_WORDS: Final = re.findall(
    r"\S+",
    """( ) [ ] { } ; , : ? = == + ++ - -- * / % & && | ! ~ ^ < << > ... . -> # ## ' " \\ 0 1 9e9 0x
    'a' "s" int char double void struct union enum typedef static extern sizeof if else for while
    do switch case default goto return break continue _Generic _Static_assert _Alignas typeof
    __attribute__((packed)) __builtin_va_arg""",
)
PIECES: Final = [*_WORDS, "\n", "\n#define ", "\n#if ", "\n#else\n", "\n#endif\n", "\n#include "]
NESTED: Final = {
    "parentheses": ("int x = ", "(", "1", ")", ";"),
    "casts": ("int x = ", "(int)", "1", "", ";"),
    "signs": ("int x = ", "- ", "1", "", ";"),
    "negations": ("int x = ", "!", "1", "", ";"),
    "choices": ("int y; int f(void) { return ", "y ? y : ", "1", "", "; }"),
    "inner choices": ("int y; int f(void) { return ", "y ? ", "1", " : 2", "; }"),
    "sums": ("int y; int f(void) { return ", "y + ", "1", "", "; }"),
    "assignments": ("int y; int f(void) { return ", "y = ", "1", "", "; }"),
    "commas": ("int y; int f(void) { return ", "y, ", "1", "", "; }"),
    "logic": ("int y; int f(void) { return ", "y && (y || ", "1", ")", "; }"),
    "calls": ("int g(int); int f(void) { return ", "g(", "1", ")", "; }"),
    "subscripts": ("int *a; int f(void) { return ", "a[", "1", "]", "; }"),
    "dereferences": ("int ", "*", "p", "", ";"),
    "uses of pointers": ("int *p; int f(void) { return ", "*&", "*p", "", "; }"),
    "sizes": ("int x = ", "sizeof ", "1", "", ";"),
    "braces": ("void f(void) ", "{", "", "}", ""),
    "initialisers": ("int x = ", "{", "1", "}", ";"),
    "ifs": ("int y; void f(void) { ", "if (y) ", ";", "", " }"),
    "else ifs": ("int y; void f(void) { ", "if (y) y = 1; else ", ";", "", " }"),
    "loops": ("int y; void f(void) { ", "while (y) ", ";", "", " }"),
    "fors": ("int y; void f(void) { ", "for (;y;) ", ";", "", " }"),
    "dos": ("int y; void f(void) { ", "do ", ";", " while (y);", " }"),
    "switches": ("int y; void f(void) { ", "switch (y) case 1: ", ";", "", " }"),
    "labels": ("void f(void) { ", "a{n}: ", ";", "", " }"),
    "structs": ("", "struct s{n} { int a; ", "int b;", "} m;", ""),
    "unions": ("", "union { int a; ", "int b;", "};", ""),
    "members": ("struct s { struct s *p; } *v; struct s *f(void) { return v", "->p", "", "", "; }"),
    "arrays": ("int a", "[1]", "", "", ";"),
    "declarators": ("int ", "(", "x", ")", ";"),
    "functions": ("int ", "(*", "f", ")(void)", ";"),
    "parameters": ("int f(", "int (*)(", "int", ")", ");"),
    "blocks as values": ("int f(void) { return ", "({ ", "1; ", "}); ", "}"),
    "literals": ("struct s { int a; }; int f(void) { return ", "(int){", "1", "}", "; }"),
    "selections": ("int x = ", "_Generic(1, default: ", "1", ")", ";"),
    "types of": ("int y; ", "typeof(", "y", ")", " z;"),
    "conditionals": ("", "#if 1\n", "int x;\n", "#endif\n", ""),
    "skipped": ("", "#if 0\n", "\n", "#endif\n", ""),
    "conditions": ("#if ", "(", "1", ")", "\nint x;\n#endif"),
    "macro calls": ("#define F(x) x\nint x = ", "F(", "1", ")", ";"),
    "macros": ("#define A0 1\n", "#define A{m} A{n}\n", "int x = A1;", "", ""),
    "growing macros": ("#define A0 1\n", "#define A{m} A{n} + A{n}\n", "int x = A9;", "", ""),
    "strings": ("char *s = ", '"a" ', '""', "", ";"),
    "comments": ("", "/* ", "int x;", "*/", ""),
    "attributes": ("int x ", "__attribute__((unused)) ", "", "", ";"),
    "open attributes": ("int x __attribute__", "(", "", ")", ";"),
    "typedefs": ("typedef int t0; ", "typedef t{n} *t{m}; ", "int x;", "", ""),
    "cases": ("int y; void f(void) { switch (y) { ", "case {n}: ", ";", "", "} }"),
    "enumerators": ("enum { ", "a{n}, ", "b", "", " };"),
    "alignments": ("", "_Alignas(", "8", ") ", "int x;"),
    "extensions": ("int x = ", "__extension__ ", "1", "", ";"),
    "strays": ("", "}", "", "", ""),
    "open parentheses": ("int x = ", "(", "", "", ""),
    "open braces": ("void f(void) ", "{", "", "", ""),
    "ellipses": ("void f(int", ", ...", "", "", ");"),
}  # fmt: skip
"""Constructs that can be nested: the start, the opening, the core, the closing, the end."""


def nested(name: str, depth: int) -> str:
    """Return a text in which a construct is nested; `{n}` in it is a level, `{m}` the next one."""
    begin, opening, core, closing, end = NESTED[name]
    levels = (
        opening.replace("{n}", str(level)).replace("{m}", str(level + 1)) for level in range(depth)
    )
    return begin + "".join(levels) + core + closing * depth + end + "\n"


def damaged(text: str, chance: random.Random) -> str:
    """Return a program with tokens deleted, doubled, swapped, replaced, or the end cut off."""
    places = [match.span() for match in TOKEN.finditer(text)]
    if not places:
        return text
    for _ in range(chance.randint(1, 6)):
        first, last = chance.choice(places)
        other, end = chance.choice(places)
        kind = chance.randrange(6)
        if kind == 0:
            text = text[:first] + text[last:]
        elif kind == 1:
            text = text[:last] + " " + text[first:last] + text[last:]
        elif kind == 2:
            text = text[:first] + text[other:end] + text[last:]
        elif kind == 3:
            text = text[:first] + chance.choice(PIECES) + text[last:]
        elif kind == 4:
            text = text[:first] + text[min(first, other) : max(last, end)] + text[last:]
        elif chance.random() < 0.2:
            text = text[:first]
    return text


def noise(chance: random.Random) -> str:
    """Return random bytes, characters or tokens."""
    size = chance.randrange(400)
    kind = chance.randrange(3)
    if kind == 0:
        return chance.randbytes(size).decode("utf-8", "surrogateescape")
    if kind == 1:
        return "".join(chr(chance.randrange(32, 127)) for _ in range(size))
    return " ".join(chance.choice(PIECES) for _ in range(size))


def survive(source: str, longest_s: float = 20.0) -> str:
    """Compile a text; return a description of what went wrong, "" if nothing did."""
    diagnostics = Diagnostics()
    began = time.monotonic()
    try:
        verify(compile_text(source, "a.c", library_options(), diagnostics))
    except CompileError:
        if not diagnostics.errors:
            return "refused without a message"
        if not all(message.location.file for message in diagnostics.errors):
            return "an error without a place"
    except Exception as problem:
        return f"{type(problem).__name__}: {problem}"[:300]
    took_s = time.monotonic() - began
    return f"took {took_s:.1f} s" if took_s > longest_s else ""


def sources(seed: int) -> Iterator[str]:
    """Yield sources endlessly."""
    chance = random.Random(seed)
    corpus = [path.read_text("latin-1") for path in sorted(CORPUS.rglob("*.c"))]
    corpus = [text for text in corpus if len(text) < 6000]
    while True:
        kind = chance.randrange(8)
        if kind == 0:
            yield noise(chance)
        elif kind == 1:
            name = chance.choice(list(NESTED))
            yield damaged(nested(name, chance.choice([3, 30, 300])), chance)
        else:
            yield damaged(chance.choice(corpus), chance)


def main() -> None:
    """Try a number of sources, the first argument, with a seed, the second argument.

    Those that fail are kept in `build/fuzz-frontend`.
    """
    number = int(sys.argv[1]) if len(sys.argv) > 1 else 2000
    seed = int(sys.argv[2]) if len(sys.argv) > 2 else 1
    wrong = 0
    for index, source in zip(range(number), sources(seed), strict=False):
        problem = survive(source, 5.0)
        if problem:
            wrong += 1
            FINDINGS.mkdir(parents=True, exist_ok=True)
            path = FINDINGS / f"{seed}_{index}.c"
            path.write_text(source, encoding="utf-8", errors="surrogateescape")
            print(f"{path}: {problem}", flush=True)
    print(f"{number} sources, {wrong} went wrong")
    sys.exit(wrong > 0)


if __name__ == "__main__":
    main()
