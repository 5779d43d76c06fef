r"""The syntax of Stage's world files: names with values, and blocks.

>>> blocks = parse('define wall model ( color "red" )  # a kind\nwall ( pose [1 2 0 90] )')
>>> [(block.word, block.name, block.values) for block in blocks]
[('define', 'wall', {'color': ['red']}), ('wall', '', {'pose': ['1', '2', '0', '90']})]
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import Final

MAX_TOKENS: Final = 500_000
MAX_DEPTH: Final = 32

_TOKEN: Final = re.compile(r"""(?:\s|\#[^\n]*)*(?:"([^"\n]*)"|([()\[\]])|([^\s()\[\]"#]+)|$)""")


@dataclass(slots=True)
class Block:
    """A block, or a value outside all blocks.

    Attributes:
        word: what it begins with.
        name: what it defines, after `define`.
        base: what that is based on.
        values: its values by names: `size [1 2]` has two, `color "red"` one.
        blocks: the blocks in it.
    """

    word: str
    name: str = ""
    base: str = ""
    values: dict[str, list[str]] = field(default_factory=dict)
    blocks: list[Block] = field(default_factory=list)


def parse(text: str) -> list[Block]:
    """Return the blocks of a file.

    Raises:
        ValueError: it is not of this form.
    """
    top = Block("")
    _Parser(text).fill(top)
    return top.blocks


class _Parser:
    def __init__(self, text: str) -> None:
        self._tokens: list[tuple[str, bool]] = []
        place = 0
        while place < len(text):
            found = _TOKEN.match(text, place)
            if found is None or len(self._tokens) > MAX_TOKENS:
                raise ValueError("not a Stage world" if found is None else "too large")
            place = found.end()
            if found.lastindex:
                self._tokens.append((found[found.lastindex], found.lastindex == 2))
            elif place >= len(text):
                break
        self._tokens.reverse()

    def fill(self, block: Block, depth: int = 0) -> None:
        """Read the contents of a block, to its end."""
        if depth > MAX_DEPTH:
            raise ValueError(f"blocks are nested more than {MAX_DEPTH} deep")
        while self._tokens:
            word, is_mark = self._tokens.pop()
            if is_mark:
                if word == ")" and depth:
                    return
                raise ValueError(f"unexpected {word!r}")
            name = base = ""
            if word == "define":
                name, base = self._word(), self._word()
            if self._next() == ("(", True):
                self._tokens.pop()
                inner = Block(word, name, base)
                block.blocks.append(inner)
                self.fill(inner, depth + 1)
            else:
                index, value = self._value()
                block.values[word + index] = value
        if depth:
            raise ValueError("')' is missing")

    def _next(self) -> tuple[str, bool]:
        return self._tokens[-1] if self._tokens else ("", True)

    def _word(self) -> str:
        word, is_mark = self._tokens.pop() if self._tokens else ("", True)
        if is_mark:
            raise ValueError("a name is missing")
        return word

    def _value(self) -> tuple[str, list[str]]:
        """Return the index of a value, as of `point[0] [1 2]`, and its words."""
        if self._next() != ("[", True):
            return "", [self._word()]
        self._tokens.pop()
        found = []
        while self._next() != ("]", True):
            found.append(self._word())
        self._tokens.pop()
        if self._next() == ("[", True):
            return "".join(found), self._value()[1]
        return "", found
