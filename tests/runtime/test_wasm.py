"""Instructions are encoded as they are, also after ones that Python takes for equal."""

from __future__ import annotations

import struct

import pytest

from crs_cc.runtime.wasm import encode


@pytest.mark.parametrize(("kind", "form"), [("f32", "<f"), ("f64", "<d")])
def test_zeros_of_either_sign_are_told_apart(kind: str, form: str) -> None:
    for value in (0.0, -0.0, 0.0):
        assert encode((f"{kind}.const", value))[1:] == struct.pack(form, value)


def test_constants_of_both_widths_are_told_apart() -> None:
    assert encode(("i32.const", 2**32 - 1)) == b"\x41\x7f"
    assert encode(("i64.const", 2**32 - 1)) == b"\x42\xff\xff\xff\xff\x0f"
