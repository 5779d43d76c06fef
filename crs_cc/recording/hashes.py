"""The hashes of a run, for comparison with a repetition of it.

>>> made = [Hash(20, "0f3a", 7, ""), Hash(40, "77aa", 9, "28212b1101b966de")]
>>> entry_of(made)["digest"], entry_of(made)["state"]
('0f3a77aa', {'40': '28212b1101b966de'})
>>> list(hashes_in(entry_of(made))) == made
True
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import accumulate
from typing import Any, Final, NamedTuple

DIGITS: Final = 4
"""Hexadecimal digits of a digest, and of the hash of all output: a run that differs also differs in
all later seconds, and the hash of all state at the end is longer."""

DIGEST_BITS: Final = 16**DIGITS - 1
"""The recorded bits of the CRC-32 of the motion, and of that of all output."""

STATE_DIGITS: Final = 16
"""The recorded digits of a hash of all state: enough to detect that a run differs."""


class Hash(NamedTuple):
    """The hashes of a run after a number of timesteps.

    Attributes:
        timesteps: the number.
        digest: of the motion and all clocks.
        output: the lowest bits of the CRC-32 of all output, see `DIGEST_BITS`.
        state: of all state; empty if it was not computed.
    """

    timesteps: int
    digest: str
    output: int
    state: str


def entry_of(hashes: Sequence[Hash]) -> dict[str, Any]:
    """Return hashes as an entry of a recording."""
    before = [0, *(each.timesteps for each in hashes)]
    return {
        "timesteps": [each.timesteps - last for each, last in zip(hashes, before, strict=False)],
        "digest": "".join(each.digest for each in hashes),
        "output": "".join(f"{each.output:0{DIGITS}x}" for each in hashes),
        "state": {str(each.timesteps): each.state for each in hashes if each.state},
    }


def hashes_in(entry: Mapping[str, Any]) -> Iterator[Hash]:
    """Yield the hashes in an entry.

    Raises:
        KeyError, TypeError, ValueError: it is not valid.
    """
    digests, outputs, states = (entry[name] for name in ("digest", "output", "state"))
    count = len(entry["timesteps"])
    if len(digests) != DIGITS * count or len(outputs) != DIGITS * count:
        raise ValueError("the numbers of hashes and timesteps differ")
    for number, timesteps in enumerate(accumulate(map(int, entry["timesteps"]))):
        digits = slice(DIGITS * number, DIGITS * (number + 1))
        state = str(states.get(str(timesteps), ""))
        yield Hash(timesteps, str(digests[digits]), int(outputs[digits], 16), state)


def common_until(here: Iterable[Hash], there: Iterable[Hash]) -> int:
    """Return a timestep up to which runs of the same programs are known to be the same.

    >>> common_until([Hash(20, "0f", 7, "28")], [Hash(20, "0f", 7, "28"), Hash(40, "7a", 9, "")])
    20
    """
    same = 0
    for one, other in zip(here, there, strict=False):
        if one != other:
            break
        if one.state:
            same = one.timesteps
    return same
