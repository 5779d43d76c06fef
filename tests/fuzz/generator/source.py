"""The text of a program while it is generated: lines, indentation, unique names."""

from __future__ import annotations

import contextlib
import random
from collections.abc import Iterator


class Source:
    """The text so far.

    Attributes:
        chance: the random number generator.
        lines: one statement, declaration or brace each, for the reducer to leave out.
    """

    def __init__(self, seed: int) -> None:
        self.chance = random.Random(seed)
        self.lines: list[str] = []
        self._depth = 0
        self._named = 0

    def name(self, prefix: str) -> str:
        """Return a unique name."""
        self._named += 1
        return f"{prefix}{self._named}"

    def add(self, *lines: str) -> None:
        self.lines.extend("    " * self._depth + line for line in lines)

    @contextlib.contextmanager
    def block(self, head: str, tail: str = "}") -> Iterator[None]:
        """Put the lines that are added meanwhile between braces."""
        self.add(f"{head} {{" if head else "{")
        self._depth += 1
        yield
        self._depth -= 1
        self.add(tail)

    def text(self) -> str:
        return "\n".join(self.lines) + "\n"
