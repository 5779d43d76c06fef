"""What a function uses by name, in order, and where each comes first."""

from __future__ import annotations

from crs_cc.core.source import Location
from crs_cc.ir.instruction import Address, Block, Call, Constant, Load, Register, Return, Store
from crs_cc.ir.program import Function
from crs_cc.ir.uses import uses


def place(line: int) -> Location:
    return Location("a.c", line)


def test_uses_are_in_order_each_with_its_first_place() -> None:
    n = Register(0, "i32")
    last = Block("last", [Address(place(5), n, "table", 8)], Return(place(6), n))
    first = Block(
        "first",
        [
            Load(place(1), n, "count", 0, "i32"),
            Store(place(2), "count", 4, Constant("i32", 1), "i32"),
            Address(place(3), n, "count", 0),
        ],
    )
    first.terminator = Call(place(4), "count", [], None, last)
    function = Function("f", place(1), registers=[n], blocks=[first, last])
    assert list(uses(function).items()) == [
        (("count", "access"), place(1)),
        (("count", "address"), place(3)),
        (("count", "call"), place(4)),
        (("table", "address"), place(5)),
    ]
