"""Each valid program with something missing or out of place is compiled or refused, no more.

One damage of each suffices: it is the same in every run, and `make fuzz-frontend` tries new ones.
"""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from tests.c.execution import cases, name
from tests.frontend.fuzzing import damaged, survive


@pytest.mark.parametrize("path", cases("valid"), ids=name)
def test_a_damaged_program_is_compiled_or_refused(path: Path) -> None:
    chance = random.Random(name(path))
    source = damaged(path.read_text(encoding="latin-1"), chance)
    assert survive(source) == "", source
