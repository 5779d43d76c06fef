"""Which accesses of a function have a known base, and which pairs of pointers one object."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.core.source import Diagnostics
from crs_cc.ir.instruction import Load, Register, SameObject, Slot, Store
from crs_cc.session.build import build_executable

CASES = {
    "int *p = few; n = p[n];": ["few"],
    "int *p = few + 2; if (n) p = few; *(p + n) = 1;": ["few"],
    "int *p = n ? few : many; n = p[n];": [],
    "int *p = few; p = q; n = p[n];": [],
    "int here[4] = {0}, *p = here; n = p[n];": ["here"],
    "int *p = malloc(40); n = p[n]; free(p);": ["p"],
    "int *p = malloc(40), *k = p; p = malloc(8); n = k[n] + p[n]; free(p);": ["k", "p"],
    "int *p = few; p += (int)q - (int)few; n = p[n];": [],  # corrected
    "int *p; for (p = few; *p; p++) n += *p;": [],  # in small steps
    "int *p; for (p = few; *p; p += 8) n += *p;": ["few"],
    "int *p = few + 3; n = p[-1] + p[0];": [],  # known to be inside
    "n = few < q;": ["pair"],
    "int *p = few, *end = few + n; while (p < end) p++;": [],
    "int *p = q, *end = q + n; while (p < end) p++;": [],
    "int *p = few; n = p < q;": ["pair"],
}


@pytest.mark.parametrize("body", CASES)
def test_bases_are_known_where_they_must_be_and_nowhere_else(tmp_path: Path, body: str) -> None:
    path = tmp_path / "bases.c"
    path.write_text(
        "#include <stdlib.h>\nstatic int few[4], many[400];\n"
        f"static int f(int *q, int n) {{ {body} return n; }}\n"
        "int main(void) { return f(many, 0); }\n"
    )
    program = build_executable([path], Diagnostics()).detail().program
    (function,) = (each for name, each in program.functions.items() if name.endswith(":f"))
    found = []
    for block in function.blocks:
        for it in block.instructions:
            if isinstance(it, SameObject):
                found.append("pair")
            elif isinstance(it, Load | Store) and it.within is not None:
                found.append(_name(it.within))
    assert found == CASES[body]


def _name(base: Register | Slot | str) -> str:
    if isinstance(base, str):
        return base.rpartition(":")[2]
    return base.variable.name if base.variable is not None else ""
