"""Checks of numbers that users pass.

>>> check_number("seed", 3, whole=True)
>>> check_number("until_s", float("nan"))
Traceback (most recent call last):
ValueError: until_s must be a number, not nan
>>> check_number("seed", "1", whole=True)
Traceback (most recent call last):
TypeError: seed must be an integer, not '1'
"""

from __future__ import annotations

import math
import numbers


def check_number(name: str, value: object, *, whole: bool = False) -> None:
    """Check an argument, which may be None.

    Args:
        name: the argument's name.
        value: its value.
        whole: whether only integers are allowed.

    Raises:
        TypeError: it is not a number.
        ValueError: it is NaN.
    """
    if value is None:
        return
    if not isinstance(value, numbers.Integral if whole else numbers.Real):
        raise TypeError(f"{name} must be {'an integer' if whole else 'a number'}, not {value!r}")
    if math.isnan(value):
        raise ValueError(f"{name} must be a number, not nan")
