"""The table of operators agrees with wasmtime's assembler and validator."""

from __future__ import annotations

import pytest
import wasmtime

from crs_cc.ir.operators import OPERATORS, Operator


def module(operator: Operator) -> bytes:
    """Assemble a function that applies the operator to its parameters."""
    gets = " ".join(f"local.get {i}" for i in range(len(operator.operands)))
    head = f"(func (param {' '.join(operator.operands)}) (result {operator.result})"
    return bytes(wasmtime.wat2wasm(f"(module {head} {gets} {operator.name}))"))


@pytest.mark.parametrize("operator", OPERATORS.values(), ids=OPERATORS.keys())
def test_types_and_opcodes_match_webassembly(operator: Operator) -> None:
    code = module(operator)
    wasmtime.Module.validate(wasmtime.Engine(), code)
    gets = b"".join(bytes([0x20, i]) for i in range(len(operator.operands)))
    assert gets + operator.opcode + b"\x0b" in code


def test_all_numeric_opcodes_are_defined() -> None:
    plain = {operator.opcode[0] for operator in OPERATORS.values() if len(operator.opcode) == 1}
    assert plain == set(range(0x45, 0xC5))  # WebAssembly 2.0, section 5.4.7
    assert sum(len(operator.opcode) == 2 for operator in OPERATORS.values()) == 8
