"""The simulation computes with `exact`, not with functions whose bits depend on the processor."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

import crs_cc

SIM = Path(crs_cc.__file__).parent / "sim"

NUMPY = frozenset(
    [
        "angle",
        "arccos",
        "arccosh",
        "arcsin",
        "arcsinh",
        "arctan",
        "arctan2",
        "arctanh",
        "cbrt",
        "convolve",
        "correlate",
        "cos",
        "cosh",
        "dot",
        "einsum",
        "exp",
        "exp2",
        "expm1",
        "fft",
        "float_power",
        "geomspace",
        "hypot",
        "inner",
        "interp",
        "kron",
        "linalg",
        "log",
        "log10",
        "log1p",
        "log2",
        "logaddexp",
        "logspace",
        "matmul",
        "outer",
        "pow",
        "power",
        "sin",
        "sinc",
        "sinh",
        "tan",
        "tanh",
        "tensordot",
        "vdot",
    ]
)
MATH = frozenset(
    [
        "acos",
        "acosh",
        "asin",
        "asinh",
        "atan",
        "atan2",
        "atanh",
        "cbrt",
        "cos",
        "cosh",
        "dist",
        "erf",
        "erfc",
        "exp",
        "exp2",
        "expm1",
        "gamma",
        "hypot",
        "lgamma",
        "log",
        "log10",
        "log1p",
        "log2",
        "pow",
        "sin",
        "sinh",
        "tan",
        "tanh",
    ]
)


def faults(tree: ast.AST) -> Iterator[str]:
    """Yield the line and the name of what depends on the processor."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
            known = {"np": NUMPY, "math": MATH}.get(node.value.id, frozenset())
            if node.attr in known:
                yield f"{node.lineno}: {node.value.id}.{node.attr}"
        elif isinstance(node, ast.BinOp | ast.AugAssign) and isinstance(node.op, ast.MatMult):
            yield f"{node.lineno}: @"
        elif isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow):
            # of numbers it is the C library's `pow`, of arrays a function of numpy
            sides = node.left, node.right
            if not all(isinstance(each, ast.Constant) for each in sides):
                yield f"{node.lineno}: **"


@pytest.mark.parametrize(
    "path", sorted(SIM.rglob("*.py")), ids=lambda path: path.relative_to(SIM).as_posix()
)
def test_no_function_depends_on_the_processor(path: Path) -> None:
    assert list(faults(ast.parse(path.read_text()))) == []


def test_the_rule_finds_them() -> None:
    text = "a = np.exp(1j)\nb = a @ a\nc = math.sin(2) + np.sqrt(2) + exact.sin(2)\n"
    text += "d = 2.0**53 + a**2\n"
    assert sorted(faults(ast.parse(text))) == ["1: np.exp", "2: @", "3: math.sin", "4: **"]
