"""The changes that a host may make to the slots and clocks of its programs.

Each word of a row has bits that must not change and a maximum value; some must not decrease. Words
are compared as integers, which orders floating-point numbers that are not negative, too.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from crs_cc.net.word_kernel import WORDS, Rules
from crs_cc.requests import ERROR_KINDS, FAILED, slot_offset, timing_offset

_ALL: Final = 2**64 - 1
_INFINITE: Final = 0x7FF << 52
"""The bits of the first number of seconds that is not finite."""

_ASKS: Final = 1 << 32
"""In the word of `alive`, the bit of `asks`."""

_UPPER_HALF: Final = 1 << 32


def _of_words(default: int, **values: int) -> np.ndarray:
    """Return a number for each word of a row."""
    found = np.full(WORDS, default, np.uint64)
    for name, value in values.items():
        is_timing = name in _TIMING
        found[(timing_offset(name) if is_timing else slot_offset(name)) // 8] = value
    return found


_TIMING: Final = ("clock_s", "due_s", "speed_hz", "fuel", "pending", "alive")
_FIXED: Final = _of_words(0, due_s=_ALL, speed_hz=_ALL, pending=_ALL, alive=_ALL ^ _ASKS)
_MAXIMA: Final = _of_words(
    _ALL,
    clock_s=_INFINITE - 1,
    fuel=2**63 - 1,
    status=(FAILED + 1) * _UPPER_HALF - 1,
    error_kind=len(ERROR_KINDS) * _UPPER_HALF - 1,
)
_MONOTONIC: Final = _of_words(0, clock_s=_ALL, fuel=_ALL)
_ASKING: Final = _of_words(0, alive=_ASKS)

RULES: Final = Rules(_FIXED, _MAXIMA, _MONOTONIC, wanted=_ASKING)
"""Rules for a host that has run rounds; what is looked for is a request of a program."""

IDLE_RULES: Final = RULES._replace(fixed=_FIXED | _ASKING)
"""Rules for a host that has run no round, so that no program can have made a request."""
