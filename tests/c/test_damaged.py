"""Each valid program with something missing or out of place is compiled or refused, no more."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from tests.c.execution import cases, name
from tests.frontend.fuzzing import damaged, survive

DAMAGES = 3
"""Damaged versions of each program."""


@pytest.mark.parametrize("path", cases("valid"), ids=name)
def test_a_damaged_program_is_compiled_or_refused(path: Path) -> None:
    chance = random.Random(name(path))
    text = path.read_text(encoding="latin-1")
    for _ in range(DAMAGES):
        source = damaged(text, chance)
        assert survive(source) == "", source
