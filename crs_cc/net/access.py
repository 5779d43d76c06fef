r"""Access control: tokens by role, from a file or generated at startup.

A line of the file has a role and a token; empty lines and lines that begin with `#` are ignored.

>>> found = parsed("# course\nrobot 0123456789abcdef\nview fedcba9876543210\n")
>>> found.allows("robot", "0123456789abcdef"), found.allows("robot", "fedcba9876543210")
(True, False)
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final, Literal, Self, get_args

from crs_cc.core.loopback import MIN_TOKEN, is_token, new_token
from crs_cc.core.suggest import unknown
from crs_cc.net.handshake import RefusedError

Role = Literal["robot", "view", "control"]

ROLES: Final[tuple[Role, ...]] = get_args(Role)

MAX_TOKENS: Final = 1000


@dataclass(frozen=True, slots=True)
class Access:
    """The tokens of each role.

    Attributes:
        tokens: the tokens by role, at least one for each.
    """

    tokens: Mapping[Role, tuple[str, ...]]

    @classmethod
    def made(cls) -> Self:
        """Create new tokens, one for each role."""
        return cls({role: (new_token(),) for role in ROLES})

    def allows(self, role: Role, given: object) -> bool:
        """Return whether a token belongs to a role, comparing with all in constant time."""
        return sum(is_token(given, token) for token in self.tokens[role]) > 0

    def require(self, role: Role, given: object) -> None:
        """Check that a token belongs to a role.

        Raises:
            RefusedError: it does not.
        """
        if not self.allows(role, given):
            text = f"no valid token for the role '{role}': give that of crs serve by --token"
            raise RefusedError(text)

    def token(self, role: Role) -> str:
        """Return the first token of a role."""
        return self.tokens[role][0]


def parsed(text: str) -> Access:
    """Return the tokens of a file, and new ones for roles that are not in it.

    Raises:
        ValueError: the file is invalid; the message begins with the line number.
    """
    found: dict[Role, list[str]] = {role: [] for role in ROLES}
    for number, line in enumerate(text.splitlines(), 1):
        words = line.split()
        if not words or words[0].startswith("#"):
            continue
        role = next((each for each in ROLES if each == words[0]), None)
        if role is None:
            raise ValueError(f"{number}: {unknown('role', words[0][:40], list(ROLES))}")
        if len(words) != 2:
            raise ValueError(f"{number}: expected a role and a token")
        if len(words[1]) < MIN_TOKEN or not words[1].isascii():
            raise ValueError(f"{number}: a token has at least {MIN_TOKEN} characters of ASCII")
        found[role].append(words[1])
        if sum(map(len, found.values())) > MAX_TOKENS:
            raise ValueError(f"{number}: more than {MAX_TOKENS} tokens")
    return Access({role: tuple(rows) or (new_token(),) for role, rows in found.items()})
