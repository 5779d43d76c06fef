"""What a parameter varies, by its name.

>>> check_target("define.SPEED")
>>> check_target("world.crate.x")
>>> check_target("speed")  # doctest: +ELLIPSIS
Traceback (most recent call last):
ValueError: unknown parameter 'speed' (known: define.NAME, argument.N, ...
"""

from __future__ import annotations

import re
from typing import Final

TARGETS: Final = {
    "define.NAME": "the value of a macro of the program, as `-D NAME=value`",
    "argument.N": "argument N of the program, from 1",
    "world.ELEMENT.ATTRIBUTE": "an attribute of an element of the world file, such as "
    "`world.crate.x`; elements are named as in the [world builder](world-builder.md); `world` "
    "is the root",
    "robot.ELEMENT.ATTRIBUTE": "an attribute of an element of the robot definition, such as "
    "`robot.drive.wheel-base`",
    "fault": "degradations: the attributes of `<degradation>`, such as "
    '`"robot=robot0 device=sonar element=3 dead=yes"`; separate several '
    'degradations with `;`, and use `""` for none',
    "robots": "the number n of robots that take part: the first n in the world",
    "setup": "the setup of all robots, such as `noisy`",
    "robot": "the type of robots for which the world specifies none",
    "link": "`serial` or `ideal`",
    "client": "`nclient` or `ndirect`",
}
"""The forms of the names of parameters, and what they vary."""

_FORMS: Final = {
    "define": re.compile(r"[A-Za-z_]\w*", re.ASCII),
    "argument": re.compile(r"[1-9][0-9]{0,3}"),
    "world": re.compile(r"(.+)\.([\w-]+)"),
    "robot": re.compile(r"(.+)\.([\w-]+)"),
}


def check_target(name: str) -> None:
    """Check the form of a parameter's name.

    Raises:
        ValueError: there is no such parameter.
    """
    kind, _, rest = name.partition(".")
    is_word = name in TARGETS and not rest
    if not is_word and not (kind in _FORMS and _FORMS[kind].fullmatch(rest)):
        raise ValueError(f"unknown parameter '{name}' (known: {', '.join(TARGETS)})")


def place_of(name: str) -> tuple[str, str]:
    """Return the element and the attribute of a parameter of a world or a robot.

    >>> place_of("world.surface/ramp[1].height")
    ('surface/ramp[1]', 'height')
    """
    element, _, attribute = name.partition(".")[2].rpartition(".")
    return element, attribute
