"""Descriptions of objects: their names in a sentence, and notes on type and origin."""

from __future__ import annotations

from typing import Final

from crs_cc.ir.names import in_library, plain_name
from crs_cc.ir.types import spell
from crs_cc.runtime.diagnosis.objects import Object
from crs_cc.runtime.diagnosis.values import place_name
from crs_cc.runtime.sites import CallSite

SHOWN_SITES: Final = 3


def count(number: int, what: str) -> str:
    """Return a number with its noun: `1 byte`, `2 bytes`."""
    return f"{number:,} {what}" + ("" if number == 1 else "s")


def object_name(found: Object | None, article: str = "a") -> str:
    """Return the name of an object, for use in a sentence; of a heap block, with an article."""
    if found is None:
        return "an unknown object"
    if found.kind == "heap block":
        return f"{article} heap block of {count(found.size, 'byte')}"
    if found.kind == "string":
        return "a string literal"
    if found.kind == "argument":
        return f"the arguments of '{plain_name(found.function)}'"
    return f"'{found.name}'" if found.name else "an unnamed object"


def object_notes(
    found: Object | None, address: int | None = None, what: str = "the access is"
) -> tuple[str, ...]:
    """Describe an object, what is done to which part of it at an address, and its origin."""
    if found is None:
        return ()
    notes = []
    if found.variable is not None:
        ctype, name = found.variable.ctype, found.name
        offset = 0 if address is None else address - found.address
        part = place_name(name, ctype, offset) if offset else name
        this = f"; {what} to {part}" if part != name else ""
        size = count(found.size, "byte")
        notes.append(f"'{name}' is {spell(ctype)}, {size}, declared at {found.location}{this}")
    elif found.kind == "string" and found.location is not None:
        size = count(found.size, "byte")
        notes.append(f"the string literal is {size} long and appears at {found.location}")
    if found.allocated:
        notes.append(f"allocated {_sites(found.allocated)}")
    if found.freed:
        notes.append(f"freed {_sites(found.freed)}")
    return tuple(notes)


def _sites(sites: tuple[CallSite, ...]) -> str:
    """Return the calls that led to an event, without those inside the library."""
    mine = [site for site in sites if not in_library(site.location)]
    if not mine:
        return "inside the library"
    calls = [f"{site.location} in {plain_name(site.function)}" for site in mine]
    return "at " + ", called from ".join(calls[:SHOWN_SITES])
