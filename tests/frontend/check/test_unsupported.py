"""Every node class of pycparser is checked, part of another, or refused."""

from __future__ import annotations

import inspect

import pytest
from pycparser import c_ast

from crs_cc.core.source import Diagnostics, Location
from crs_cc.frontend.check import unit
from crs_cc.frontend.check.checker import EXPRESSIONS, STATEMENTS, CheckError, Unit
from crs_cc.frontend.check.unsupported import PARTS, REFUSED, refused

NODES = [
    each
    for _, each in inspect.getmembers(c_ast, inspect.isclass)
    if issubclass(each, c_ast.Node) and each is not c_ast.Node
]


@pytest.mark.parametrize("node", NODES)
def test_every_node_class_has_exactly_one_fate(node: type) -> None:
    is_checked = node in EXPRESSIONS or node in STATEMENTS or node in unit.EXTERNAL
    assert [is_checked, node in PARTS, node in REFUSED].count(True) == 1


def test_unsupported_node_is_an_error() -> None:
    unit = Unit("a.c", Diagnostics(), Location("a.c", 1, 1))
    error = refused(unit, c_ast.BitIntType(None, None))
    assert isinstance(error, CheckError)
    assert error.text == "'_BitInt' is not supported"
