"""A limit for macro expansion: a few lines can expand to more than fits into memory.

>>> from crs_cc.frontend.preprocess.tokens import tokenise
>>> budget = Budget(left=1000)
>>> budget.spend(tokenise("a + b", 0), position=0)
>>> budget.left
996
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from crs_cc.frontend.preprocess.source_text import Position
from crs_cc.frontend.preprocess.tokens import Token

MIN_TOKENS: Final = 200_000
"""How many tokens expansions may move, however short the source is."""
TOKENS_PER_CHARACTER: Final = 10
"""How many more they may move for each character of source."""


class ExhaustedError(Exception):
    """The budget is used up.

    Attributes:
        position: the macro call that exceeded it.
    """

    def __init__(self, position: Position) -> None:
        self.position = position
        super().__init__(position)


@dataclass(slots=True)
class Budget:
    """The number of tokens that expansions may still move.

    Attributes:
        left: the number; 4 characters of a long token count as one.
    """

    left: int = MIN_TOKENS

    def grow(self, characters: int) -> None:
        """Raise the limit for further source text."""
        self.left += TOKENS_PER_CHARACTER * characters

    def spend(self, tokens: Sequence[Token], position: Position) -> None:
        """Count tokens that are moved, and one more for the move itself.

        Raises:
            ExhaustedError: the limit is exceeded.
        """
        self.left -= 1 + sum([1 + (len(token.text) >> 2) for token in tokens])
        if self.left < 0:
            raise ExhaustedError(position)
