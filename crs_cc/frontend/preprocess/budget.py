"""How much work macros may cause: a few lines can expand to more than any memory holds.

>>> from crs_cc.frontend.preprocess.tokens import tokenise
>>> budget = Budget(left=1000)
>>> budget.spend(tokenise("a + b", 0), place=0)
>>> budget.left
996
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from crs_cc.frontend.preprocess.source_text import Place
from crs_cc.frontend.preprocess.tokens import Token

LEAST: Final = 200_000
"""How many tokens the expansions of a run may move, however little source there is."""
PER_CHARACTER: Final = 10
"""How many more for each character of source: what is long may be so in its macros, too."""


class ExhaustedError(Exception):
    """The budget is used up.

    Attributes:
        place: the macro's call that needed more.
    """

    def __init__(self, place: Place) -> None:
        self.place = place
        super().__init__(place)


@dataclass(slots=True)
class Budget:
    """What is left of the work that macros may cause.

    Attributes:
        left: tokens; 4 characters of a long token count as one.
    """

    left: int = LEAST

    def grow(self, characters: int) -> None:
        """Add what so much source may cause."""
        self.left += PER_CHARACTER * characters

    def spend(self, tokens: Sequence[Token], place: Place) -> None:
        """Pays for moving tokens, and a token's price for the move itself.

        Raises:
            ExhaustedError: there is not enough left.
        """
        self.left -= 1 + sum([1 + (len(token.text) >> 2) for token in tokens])
        if self.left < 0:
            raise ExhaustedError(place)
