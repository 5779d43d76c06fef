"""Copies of sonars in a robot definition: each has its own number and fires after the others."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Final

from crs_cc.builder import markup
from crs_cc.builder.changes import Plan
from crs_cc.builder.document import Document
from crs_cc.builder.motion import Motion
from crs_cc.builder.mounting import is_mounted, mounted
from crs_cc.builder.spans import Node
from crs_cc.sim.devices.sonar.model import MAX_SONARS

_BODY: Final = r"<!--(?:(?!-->).)*-->"
_COMMENT: Final = re.compile(
    rf"(?<=\n)[ \t]*{_BODY}[ \t]*\n|(?<=\S)[ \t]*{_BODY}|{_BODY}[ \t]*", re.DOTALL
)
"""A comment, with its line if nothing else is on it, or with the space before or after it."""


def is_sensor(node: Node) -> bool:
    """Return whether an element is a `<sensor>` of a robot definition."""
    return node.tag == "sensor" and is_mounted(node)


def sensor_copies(document: Document, nodes: Sequence[Node], motions: Sequence[Motion]) -> Plan:
    """Copy sensors, once for each motion; the copies follow all others.

    Comments are left out: they say of the original where it is.

    Raises:
        ValueError: a coordinate is invalid, or there would be too many.
    """
    root = document.root
    present = [each for each in root.children if each.tag == "sensor"]
    count = len(present) + len(nodes) * len(motions)
    if count > MAX_SONARS:
        raise ValueError(f"{count} sonars are too many (maximum: {MAX_SONARS})")
    taken = {text for each in present for text in _numbers(each)}
    free = iter([str(number) for number in range(count) if str(number) not in taken])
    texts, numbers = [], []
    for node in nodes:
        for motion in motions:
            number = next(free)
            splices = mounted(document, node, motion)
            for leaf in node.children:
                if leaf.tag == "id":
                    splices += markup.set_text(document, leaf, number)
            texts.append(_COMMENT.sub("", markup.changed(document, node, splices)))
            numbers.append(number)
    names = [f"sensor[{index}]" for index in range(len(present), count)]
    plan = Plan(markup.insert(document, root, "sensor", texts), names)
    for sonars in root.children:
        order = sonars.attributes.get("order") if sonars.tag == "sonars" else None
        if order is not None:
            longer = {"order": " ".join([order, *numbers])}
            plan.splices += markup.set_attributes(document, sonars, longer)
    return plan


def _numbers(sensor: Node) -> list[str]:
    return [leaf.text.strip() for leaf in sensor.children if leaf.tag == "id"]
