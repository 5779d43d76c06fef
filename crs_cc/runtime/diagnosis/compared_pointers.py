"""Describe a comparison of pointers to different objects, which does not stop a program."""

from __future__ import annotations

from dataclasses import dataclass

from crs_cc.core.source import Location
from crs_cc.runtime.diagnosis.inspect import StoppedProgram
from crs_cc.runtime.diagnosis.object_text import object_name
from crs_cc.runtime.diagnosis.objects import Objects
from crs_cc.runtime.layout import STACK_TOP


@dataclass(frozen=True, slots=True)
class ComparedPointers:
    """A comparison of pointers to different objects.

    Attributes:
        location: where it is.
        text: what is wrong with it.
    """

    location: Location
    text: str


def compared_pointers(
    stopped: StoppedProgram, location: Location, pointers: tuple[int, int]
) -> ComparedPointers:
    """Return a comparison of two pointers.

    Variables of functions are not named, for they may have ended.
    """
    text = "pointers to different objects are compared"
    if min(pointers) >= STACK_TOP:
        objects = Objects(stopped)
        first, second = (object_name(objects.at(each)) for each in pointers)
        text += f": one points to {first}, the other to {'another' if first == second else second}"
    return ComparedPointers(location, text)
