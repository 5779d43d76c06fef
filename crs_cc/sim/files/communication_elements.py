"""The element `<communication>` of a world file."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from crs_cc.core.quantity import DATA_RATE, LENGTH, TIME
from crs_cc.core.suggest import unknown
from crs_cc.sim.files.document import Element, Reader
from crs_cc.sim.model.communication import (
    ANY,
    MAX_CHANNELS,
    MAX_QUEUE,
    PLAIN_COMMUNICATION,
    PREDEFINED,
    Channel,
    Communication,
    Shut,
)

MAX_SHUTS: Final = 1000
MAX_DELAY_S: Final = 60.0


def communication(root: Element, robots: Sequence[str], reader: Reader) -> Communication:
    """Return the channels and outages of a world file; errors go to the reader."""
    channels = {channel.name: channel for channel in PREDEFINED}
    elements = [child for element in root.all("communication") for child in element.children]
    said: dict[str, Element] = {}
    for element in elements:
        if element.tag != "channel":
            continue
        name = element.attributes["name"]
        if name in said:
            first = said[name].place
            reader.error(element, f"duplicate channel {name!r} (first defined in {first})")
        said.setdefault(name, element)
        channels[name] = _channel(element, channels.get(name, Channel(name)), reader)
    if len(channels) > MAX_CHANNELS:
        reader.error(root.first("communication"), f"more than {MAX_CHANNELS} channels")
    shuts = [element for element in elements if element.tag == "shut"]
    if len(shuts) > MAX_SHUTS:
        reader.error(root.first("communication"), f"more than {MAX_SHUTS} outages (<shut>)")
        shuts = []
    found = tuple(_shut(element, list(channels), robots, reader) for element in shuts)
    return Communication(tuple(channels.values()), found, _latency_s(root, reader))


def _latency_s(root: Element, reader: Reader) -> float:
    """Return the latency of the network; the last element that has one decides."""
    latency_s = PLAIN_COMMUNICATION.network_latency_s
    for element in root.all("communication"):
        latency_s = _delay(element, "network-latency", latency_s, reader)
    return latency_s


def _channel(element: Element, before: Channel, reader: Reader) -> Channel:
    """Return a channel, changed by an element's attributes."""
    drop = element.attributes.get("drop")
    return replace(
        before,
        range_m=reader.positive(element, "range", LENGTH, before.range_m),
        walls=reader.fraction(element, "walls", before.walls),
        delay_s=_delay(element, "delay", before.delay_s, reader),
        jitter_s=_delay(element, "jitter", before.jitter_s, reader),
        bandwidth_bps=_bandwidth(element, before.bandwidth_bps, reader),
        queue=reader.whole(element, "queue", 1, MAX_QUEUE, before.queue),
        drops_oldest=before.drops_oldest if drop is None else drop == "oldest",
        loss=reader.fraction(element, "loss", before.loss),
        burst_begin=reader.fraction(element, "burst-begin", before.burst_begin),
        burst_end=reader.fraction(element, "burst-end", before.burst_end),
        burst_loss=reader.fraction(element, "burst-loss", before.burst_loss),
        corruption=reader.fraction(element, "corruption", before.corruption),
    )


def _delay(element: Element, name: str, absent: float, reader: Reader) -> float:
    value_s = reader.not_negative(element, name, TIME, absent)
    if value_s > MAX_DELAY_S:
        reader.refuse(element, f"{name}: must be {MAX_DELAY_S:g}s or less")
        return absent
    return value_s


def _bandwidth(element: Element, absent: float, reader: Reader) -> float:
    value_bps = reader.positive(element, "bandwidth", DATA_RATE, absent)
    if value_bps < 1.0:
        reader.refuse(element, "bandwidth: must be 1B/s or more")
        return absent
    return value_bps


def _shut(element: Element, channels: Sequence[str], robots: Sequence[str], reader: Reader) -> Shut:
    at_s = reader.not_negative(element, "at", TIME)
    until_s = reader.not_negative(element, "until", TIME, math.inf)
    if until_s <= at_s and not element.broken:
        reader.refuse(element, "until: must be later than at")
    return Shut(
        at_s,
        until_s,
        _number(element, "channel", channels, "channel", reader),
        _number(element, "from", robots, "robot", reader),
        _number(element, "to", robots, "robot", reader),
    )


def _number(element: Element, name: str, known: Sequence[str], kind: str, reader: Reader) -> int:
    wanted = element.attributes.get(name)
    if wanted is None:
        return ANY
    if wanted not in known:
        reader.refuse(element, f"{name}: {unknown(kind, wanted, known)}")
        return ANY
    return known.index(wanted)
