"""Sections of `docs/world-format.md`, from the annotations of the schemas."""

from __future__ import annotations

from functools import cache

from docs.generate import Fillers
from docs.generate.schema import Schema


def fillers() -> Fillers:
    """Return the fillers; each call documents every element anew."""
    schema = cache(Schema)
    return {
        "types": lambda name: schema(name).types(),
        "elements": lambda name, outermost: schema(name).elements(outermost),
        "comment": lambda name: schema(name).comment(),
    }


FILLERS: Fillers = fillers()
