"""The program of a robot that is controlled from outside, `relay.c`."""

from __future__ import annotations

from pathlib import Path
from typing import Final

RELAY: Final = Path(__file__).with_suffix(".c")
