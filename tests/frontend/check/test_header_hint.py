"""Hints at the header that declares an undeclared name."""

from __future__ import annotations

import pytest

from crs_cc.frontend.check.header_hint import header_hint
from crs_cc.session.library import HEADERS


@pytest.mark.parametrize(
    ("name", "header"),
    [
        ("printf", "stdio.h"),
        ("signal", "signal.h"),
        ("nullptr_t", "stddef.h"),
        ("div_t", "stdlib.h"),
        ("RAND_MAX", "stdlib.h"),
        ("State", "Nclient.h"),
        ("conf_sn", "Nclient.h"),
    ],
)
def test_declared_names_have_a_hint(name: str, header: str) -> None:
    assert header_hint(name, [HEADERS]) == f"include <{header}>"


@pytest.mark.parametrize("name", ["order", "data", "size", "seed", "tv_sec"])
def test_parameters_and_members_have_none(name: str) -> None:
    """An undeclared `data` was said to need <Nclient.h>."""
    assert header_hint(name, [HEADERS]) == ""
