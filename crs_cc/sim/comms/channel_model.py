"""The channel model: which receivers a message reaches, and when.

A message to all, or to a group, goes to those in range of its channel; one to a robot goes to that
one. With n objects between the two (`line_of_sight`), it reaches

    d <= range * walls ** n

and is then lost at random (`loss`). The rest arrives after the transmission, the
channel's delay and a uniformly distributed share of its jitter:

    arrival = b + (size + 12) / bandwidth + delay + u * jitter,   u in [0, 1)

where b is the time at which its transmission began (`outbox`), but not before the end of the cycle
that contains b. Positions are those at that end, too. On a channel with corruption c, each byte is
replaced by another one with probability c.

All random numbers are keyed by message and receiver (`keyed_random`).

A robot with the largest possible number of pending messages (`inbox`) does not receive broadcasts:
otherwise a few robots that send without end would make every message examine all pairs of robots.
"""

from __future__ import annotations

from typing import Final

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import BoolArray, ComplexArray, FloatArray, IndexArray, Int32Array, Records
from crs_cc.core.keyed_random import KeyedUniform
from crs_cc.sim.comms.channels import Channels
from crs_cc.sim.comms.inbox import Transit
from crs_cc.sim.comms.loss import burst_states
from crs_cc.sim.comms.message_log import Fate, note
from crs_cc.sim.comms.outages import is_shut
from crs_cc.sim.geometry.cell_list import CellList, expand
from crs_cc.sim.geometry.line_of_sight import Sight
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.kernels import exact
from crs_cc.sim.state.env_state import EnvState
from crs_cc.sim.state.messages import EVERYBODY, NO_GROUP, RECEPTION
from crs_cc.sim.state.random_streams import MESSAGES

_AT_ONCE: Final = 256  # messages per batch, which bounds memory
_STEP, _LOSS, _JITTER, _BYTE = range(4)  # purposes of random numbers


class ChannelModel:
    """The channel model of a world."""

    def __init__(self, channels: Channels, seed: int) -> None:
        self._channels = channels
        self._chances = KeyedUniform(seed, MESSAGES)
        self._scene: Scene | None = None

    def transmit(self, state: EnvState, scene: Scene, packets: Records, end_s: float) -> None:
        """Transmit messages to their receivers, at the end of the cycle in which they were sent.

        Args:
            state: changed in place.
            scene: the objects of the world.
            packets: the messages, in the order in which they were sent, of dtype `PACKET`.
            end_s: the end of the cycle.
        """
        if scene is not self._scene:
            self._scene, self._sight = scene, Sight(scene)
        place = state.x_m + 1j * state.y_m
        transit = Transit(state.messages)
        for first in range(0, len(packets), _AT_ONCE):
            batch = packets[first : first + _AT_ONCE]
            packet, receiver = self._reached(state, place, batch, transit.full())
            transit.add(*self._sent_on(batch, packet, receiver, end_s))
        transit.set_out()

    def _reached(
        self, state: EnvState, place: ComplexArray, packets: Records, full: BoolArray
    ) -> tuple[IndexArray, IndexArray]:
        """Return pairs of message and receiver in range; robots that are `full` do not receive.

        Record the fate of the others.
        """
        channels, messages = self._channels, state.messages
        packet, receiver = self._pairs(state, place, packets, ~full)
        fate = np.full(len(packet), int(Fate.DELIVERED), dtype=np.int8)
        fate[is_shut(messages, packets, packet, receiver)] = Fate.SHUT
        fate[~state.presence.present[receiver]] = Fate.ABSENT
        channel = packets["channel"][packet]
        start, end = place[packets["sender"][packet]], place[receiver]
        distance_m, range_m = exact.magnitude(end - start), channels.range_m[channel]
        open_ = fate == Fate.DELIVERED
        fate[open_ & (distance_m > range_m)] = Fate.RANGE
        seen = np.flatnonzero((fate == Fate.DELIVERED) & (channels.walls[channel] < 1.0))
        if len(seen):
            bodies = state.bodies
            objects = self._sight.between(
                bodies.position_m, bodies.angle_rad, start[seen], end[seen]
            )
            reach_m = range_m[seen] * exact.power(
                channels.walls[channel[seen]], objects.astype(np.float64)
            )
            fate[seen[distance_m[seen] > reach_m]] = Fate.BLOCKED
        self._lose(state, packets, packet, receiver, fate)
        lost = fate != Fate.DELIVERED
        note(messages, fate[lost], packets[packet[lost]], packets["begins_s"][packet[lost]],
             receiver[lost])  # fmt: skip
        unreached = np.bincount(packet, minlength=len(packets)) == 0
        if full.any():
            missed = self._reach(state, place, packets, full)
            note(messages, Fate.INBOX, packets[missed], packets["begins_s"][missed])
            unreached &= ~missed
        note(messages, Fate.RANGE, packets[unreached], packets["begins_s"][unreached])
        return packet[~lost], receiver[~lost]

    def _pairs(
        self,
        state: EnvState,
        place: ComplexArray,
        packets: Records,
        hears: BoolArray,
    ) -> tuple[IndexArray, IndexArray]:
        """Return pairs of message and receiver, sorted by message and then by receiver.

        Broadcasts and messages to groups go to the robots with `hears`, (robots,).
        """
        robots = np.flatnonzero(hears & state.presence.present)
        to: Int32Array = packets["to"]
        on: Int32Array = packets["channel"]
        senders: Int32Array = packets["sender"]
        one = np.flatnonzero(to != EVERYBODY)
        found = [(one, to[one].astype(np.intp))]
        for channel in np.unique(on[to == EVERYBODY]).tolist():
            many = np.flatnonzero((to == EVERYBODY) & (on == channel))
            from_ = place[senders[many]]
            reach_m = float(self._channels.range_m[channel])
            cells = CellList(place[robots].real, place[robots].imag, reach_m)
            sender, hearer = cells.near(from_.real, from_.imag)
            packet, receiver = many[sender], robots[hearer]
            near = exact.magnitude(place[receiver] - from_[sender]) <= reach_m
            near &= _is_meant(state, packets[packet], receiver)
            found.append((packet[near], receiver[near]))
        packet, receiver = (np.concatenate(part) for part in zip(*found, strict=True))
        order = np.lexsort([receiver, packet])
        return packet[order], receiver[order]

    def _reach(
        self,
        state: EnvState,
        place: ComplexArray,
        packets: Records,
        which: BoolArray,
    ) -> BoolArray:
        """Return which broadcasts and group messages have any of the robots `which` in range."""
        robots = np.flatnonzero(which & state.presence.present)
        channel: Int32Array = packets["channel"]
        senders: Int32Array = packets["sender"]
        range_m = self._channels.range_m[channel]
        away = place[robots] - place[senders][:, None]
        near = exact.magnitude(away) <= range_m[:, None]
        near &= _is_meant(state, packets[:, None], robots)
        return np.asarray((packets["to"] == EVERYBODY) & near.any(axis=1))

    def _lose(
        self,
        state: EnvState,
        packets: Records,
        packet: IndexArray,
        receiver: IndexArray,
        fate: npt.NDArray[np.int8],
    ) -> None:
        channels, bad = self._channels, state.messages.bursts
        channel: Int32Array = packets["channel"]
        lossy = (channels.loss > 0.0) | (channels.burst_begin > 0.0)
        reached = np.flatnonzero((fate == Fate.DELIVERED) & lossy[channel[packet]])
        if not len(reached):
            return
        chain = receiver[reached] * len(channels) + channel[packet[reached]]
        reached = reached[np.argsort(chain, kind="stable")]
        packet, receiver = packet[reached], receiver[reached]
        channel = channel[packet]
        names = packets["sender"][packet], packets["number"][packet], receiver
        states = bad.reshape(-1)
        in_burst = burst_states(
            states,
            receiver * len(channels) + channel,
            self._chances.draw(_STEP, *names),
            channels.burst_begin[channel],
            channels.burst_end[channel],
        )
        state.messages.bursts = states.reshape(bad.shape)
        loss = np.where(in_burst, channels.burst_loss[channel], channels.loss[channel])
        fate[reached[self._chances.draw(_LOSS, *names) < loss]] = Fate.LOSS

    def _sent_on(
        self, packets: Records, packet: IndexArray, receiver: IndexArray, end_s: float
    ) -> tuple[Records, Records]:
        """Return messages, also corrupted copies, and the arrivals of those that were not lost."""
        channels = self._channels
        channel: Int32Array = packets["channel"][packet]
        begins_s: FloatArray = packets["begins_s"]
        sent_s = begins_s + channels.duration_s(packets)
        arrives_s = sent_s[packet] + channels.delay_s[channel]
        names = packets["sender"][packet], packets["number"][packet], receiver
        if channels.jitter_s.any():
            arrives_s += channels.jitter_s[channel] * self._chances.draw(_JITTER, *names)
        coming = np.zeros(len(packet), RECEPTION)
        coming["receiver"], coming["packet"] = receiver, packet
        coming["arrives_s"] = np.maximum(arrives_s, end_s)
        return self._corrupted(packets, coming), coming

    def _corrupted(self, packets: Records, coming: Records) -> Records:
        """Return the messages, followed by the corrupted copies that arrive instead."""
        packet: Int32Array = coming["packet"]
        channel: Int32Array = packets["channel"]
        share = self._channels.corruption[channel[packet]]
        noisy = np.flatnonzero(share)
        if not len(noisy):
            return packets
        packet, share = packet[noisy], share[noisy]
        pair, byte = expand(np.zeros(len(noisy), dtype=np.intp), packets["size"][packet])
        names = packets["sender"][packet], packets["number"][packet], coming["receiver"][noisy]
        chance = self._chances.draw(_BYTE, *(name[pair] for name in names), byte)
        hit = chance < share[pair]
        pair, byte, chance = pair[hit], byte[hit], chance[hit]
        changed, place = np.unique(pair, return_inverse=True)
        copies = packets[packet[changed]]
        # Given chance < share, chance / share is uniform in [0, 1) again: it selects the byte.
        turn = 1 + (chance / share[pair] * 255).astype(np.uint8)
        copies["data"][place, byte] ^= turn
        coming["packet"][noisy[changed]] = len(packets) + np.arange(len(changed))
        coming["corrupted"][noisy[changed]] = True
        return np.concatenate([packets, copies])


def _is_meant(state: EnvState, packets: Records, receiver: IndexArray) -> BoolArray:
    """Return whether broadcasts address robots: sent by another one, and to a group of theirs."""
    group: Int32Array = packets["group"]
    bit = np.uint32(1) << np.maximum(group, 0).astype(np.uint32)
    meant = (group == NO_GROUP) | (state.messages.groups[receiver] & bit != 0)
    return np.asarray(meant & (receiver != packets["sender"]))
