"""The debugger computes what the processor computes, whatever the operands."""

from __future__ import annotations

import itertools
import math
import random
import struct

import pytest
import wasmtime

from crs_cc.debug.data.operators import compute
from crs_cc.ir.operators import OPERATORS, Operator
from crs_cc.runtime.executable import engine
from crs_cc.runtime.wasm import Code, Module

EDGES = {
    "i32": [0, 1, -1, 2, 31, 32, 33, 127, 128, 255, 256, 32767, 2**31 - 1, -(2**31), 12345, -99],
    "i64": [0, 1, -1, 63, 64, 2**31, 2**32 - 1, 2**32, 2**63 - 1, -(2**63), -(2**31), 1 << 40],
    "f64": [0.0, -0.0, 1.0, -1.5, 2.5, 3.5, 0.1, 1e300, -1e-320, 2.0**31, 2.0**63, -(2.0**63), 1e10,
            4294967295.0, math.inf, -math.inf, math.nan],
}  # fmt: skip


def single(value: float) -> float:
    try:
        return struct.unpack("<f", struct.pack("<f", value))[0]
    except OverflowError:
        return math.copysign(math.inf, value)


EDGES["f32"] = [single(value) for value in EDGES["f64"]]


def processor(operator: Operator):
    """Return the operator as the processor has it."""
    body = [("local.get", number) for number in range(len(operator.operands))]
    code = Code("op", (operator.operands, (operator.result,)), [], [*body, (operator.name,)])
    module = Module(functions=[code], exports=[("op", "func", 0)])
    store = wasmtime.Store(engine())
    instance = wasmtime.Instance(store, wasmtime.Module(engine(), module.to_binary()), [])
    function = instance.exports(store)["op"]
    return lambda *operands: function(store, *operands)


def same(left: float, right: float) -> bool:
    if isinstance(left, float) and math.isnan(left):
        return math.isnan(right)
    signs = math.copysign(1, left) == math.copysign(1, right)
    return type(left) is type(right) and left == right and signs


@pytest.mark.parametrize("name", sorted(OPERATORS))
def test_operators(name: str) -> None:
    operator, chance = OPERATORS[name], random.Random(name)
    ask = processor(operator)
    cases = list(itertools.product(*(EDGES[kind] for kind in operator.operands)))
    cases += [tuple(chance.choice(EDGES[kind]) for kind in operator.operands) for _ in range(20)]
    for operands in cases:
        try:
            expected = ask(*operands)
        except wasmtime.Trap:
            expected = None
        try:
            found = compute(name, *operands)
        except ArithmeticError:
            found = None
        if "trunc_f" in name:  # traps of the processor; the IR's `trunc` saturates
            continue
        assert (found is None) == (expected is None), operands
        assert found is None or same(found, expected), (operands, found, expected)
