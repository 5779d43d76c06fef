"""Validated access to the arguments of a request.

>>> arguments = Arguments({"threadId": 2, "breakpoints": [{"line": 7}]})
>>> arguments.integer("threadId"), arguments.text("condition", "")
(2, '')
>>> [each.integer("line") for each in arguments.objects("breakpoints")]
[7]
>>> arguments.text("threadId")
Traceback (most recent call last):
...
crs_cc.debug.dap.arguments.RefusalError: 'threadId' must be a string
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final, Self, TypeVar

_Value = TypeVar("_Value", int, bool, str)

MAX_INTEGER: Final = 2**53  # larger JSON numbers are inexact in most clients
MAX_ITEMS: Final = 10_000  # of a list; chosen by us

_NAMES: Final = {int: "an integer", bool: "true or false", str: "a string"}


class RefusalError(Exception):
    """A request cannot be fulfilled; the message is for the user.

    Attributes:
        word: the protocol's identifier for it, if it has one.
    """

    def __init__(self, text: str, word: str = "") -> None:
        super().__init__(text)
        self.word = word


class Arguments:
    """The arguments of a request, or an object among them."""

    def __init__(self, values: Mapping[str, Any]) -> None:
        self._values = values

    @classmethod
    def of(cls, values: Any) -> Self:
        """Wrap the arguments of a request; raise RefusalError if they are not an object."""
        if not isinstance(values, dict):
            raise RefusalError("'arguments' must be an object")
        return cls(values)

    def __contains__(self, name: str) -> bool:
        return self._values.get(name) is not None

    def names(self) -> list[str]:
        """Return the names of the values that are present."""
        return [name for name, value in self._values.items() if value is not None]

    def integer(self, name: str, default: int | None = None) -> int:
        """Return an integer.

        Raises:
            RefusalError: it has another type, is too large, or is missing without a default.
        """
        value = self._value(name, int, default)
        if abs(value) > MAX_INTEGER:
            raise RefusalError(f"'{name}' is too large")
        return value

    def natural(self, name: str, default: int | None = None) -> int:
        """Return a non-negative integer; like `integer`."""
        value = self.integer(name, default)
        if value < 0:
            raise RefusalError(f"'{name}' must not be negative")
        return value

    def flag(self, name: str, *, default: bool | None = None) -> bool:
        """Return a boolean; raises like `integer`."""
        return self._value(name, bool, default)

    def text(self, name: str, default: str | None = None) -> str:
        """Return a string; raises like `integer`."""
        return self._value(name, str, default)

    def texts(self, name: str) -> list[str]:
        """Return a list of strings; a single string counts as one. Raises like `integer`."""
        if isinstance(self._values.get(name), str):
            return [self.text(name)]
        values = self._list(name)
        if not all(isinstance(value, str) for value in values):
            raise RefusalError(f"'{name}' must be a list of strings")
        return values

    def objects(self, name: str) -> list[Arguments]:
        """Return a list of objects, empty by default; raises like `integer`."""
        values = self._list(name)
        if not all(isinstance(value, dict) for value in values):
            raise RefusalError(f"'{name}' must be a list of objects")
        return [Arguments(value) for value in values]

    def object(self, name: str) -> Arguments:
        """Return an object, empty by default; raises like `integer`."""
        value = self._values.get(name)
        if value is not None and not isinstance(value, dict):
            raise RefusalError(f"'{name}' must be an object")
        return Arguments(value or {})

    def _list(self, name: str) -> list[Any]:
        values = self._values.get(name)
        if values is None:
            return []
        if not isinstance(values, list):
            raise RefusalError(f"'{name}' must be a list")
        if len(values) > MAX_ITEMS:
            raise RefusalError(f"'{name}' has more than {MAX_ITEMS} items")
        return values

    def _value(self, name: str, kind: type[_Value], default: _Value | None) -> _Value:
        value = self._values.get(name)
        if value is None:
            if default is None:
                raise RefusalError(f"'{name}' is missing")
            return default
        if not isinstance(value, kind) or (kind is int and isinstance(value, bool)):
            raise RefusalError(f"'{name}' must be {_NAMES[kind]}")
        return value
