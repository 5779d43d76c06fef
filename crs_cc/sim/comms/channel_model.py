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

from typing import Final, NamedTuple, Self

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int32Array, Records, all_of
from crs_cc.core.keyed_random import KeyedUniform
from crs_cc.sim.comms.channels import Channels
from crs_cc.sim.comms.inbox import Transit
from crs_cc.sim.comms.loss import burst_states
from crs_cc.sim.comms.message_log import Fate, note
from crs_cc.sim.comms.outages import is_shut
from crs_cc.sim.geometry.cell_list import expand
from crs_cc.sim.geometry.line_of_sight import Sight
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.kernels import exact
from crs_cc.sim.kernels.hearing import Heard, Hearing
from crs_cc.sim.kernels.sight_field import MANY
from crs_cc.sim.state.env_state import EnvState
from crs_cc.sim.state.messages import EVERYBODY, NO_GROUP, RECEPTION
from crs_cc.sim.state.random_streams import MESSAGES

_AT_ONCE: Final = 256  # messages per batch, which bounds memory
_TRIED: Final = 3  # objects whose effect is computed before they are counted
_STEP, _LOSS, _JITTER, _BYTE = range(4)  # purposes of random numbers


class _Batch(NamedTuple):
    """Messages that are transmitted at once; arrays have a row for each, (k,).

    Attributes:
        packets: the messages, of dtype `PACKET`.
        sender: their senders.
        is_to_several: whether each is for all, or for a group.
        range_m: the range of its channel.
        walls: by how much an object reduces that.
        said: the rows of messages for `Hearing`, (k, 6).
        places_m: where all robots are, (robots, 2).
    """

    packets: Records
    sender: IndexArray
    is_to_several: BoolArray
    range_m: FloatArray
    walls: FloatArray
    said: FloatArray
    places_m: FloatArray

    @classmethod
    def of(cls, packets: Records, channels: Channels, places_m: FloatArray) -> Self:
        """Return the messages of a batch."""
        sender, channel = packets["sender"].astype(np.intp), packets["channel"].astype(np.intp)
        group: Int32Array = packets["group"]
        bits = np.uint32(1) << np.maximum(group, 0).astype(np.uint32)
        range_m, said = channels.range_m[channel], np.empty((len(packets), 6))
        said[:, :2], said[:, 2], said[:, 3] = places_m[sender], range_m, sender
        said[:, 4], said[:, 5] = packets["to"], np.where(group == NO_GROUP, 0, bits)
        several = packets["to"] == EVERYBODY
        return cls(packets, sender, several, range_m, channels.walls[channel], said, places_m)


class ChannelModel:
    """The channel model of a world."""

    def __init__(self, channels: Channels, seed: int) -> None:
        self._channels = channels
        self._chances = KeyedUniform(seed, MESSAGES)
        self._scene: Scene | None = None
        self._hearing: Hearing | None = None

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
        if self._hearing is None:
            self._hearing = Hearing()
        places_m = np.column_stack([state.x_m, state.y_m])
        self._hearing.place(places_m, state.presence.present)
        transit = Transit(state.messages)
        for first in range(0, len(packets), _AT_ONCE):
            batch = packets[first : first + _AT_ONCE]
            sent = _Batch.of(batch, self._channels, places_m)
            reached = self._reached(state, sent, self._hearing, transit.full())
            transit.add(*self._sent_on(batch, *reached, end_s))
        transit.commit()

    def _reached(
        self, state: EnvState, sent: _Batch, hearing: Hearing, full: BoolArray
    ) -> tuple[IndexArray, IndexArray]:
        """Return pairs of message and receiver in range; robots that are `full` do not receive.

        Record the fate of the others.
        """
        messages, packets = state.messages, sent.packets
        heard = hearing.pairs(sent.said, full, messages.groups)
        packet, receiver, distance_m, is_missed = heard
        fate = np.full(len(packet), int(Fate.DELIVERED), dtype=np.int8)
        if len(messages.shuts):
            fate[is_shut(messages, packets, packet, receiver)] = Fate.SHUT
        if not all_of(state.presence.present):
            fate[~state.presence.present[receiver]] = Fate.ABSENT
        if not all_of(sent.is_to_several):
            is_far = distance_m > sent.range_m[packet]
            fate[is_far & (fate == Fate.DELIVERED)] = Fate.RANGE
        if (sent.walls < 1.0).any():
            self._block(state, sent, heard, fate)
        self._lose(state, packets, packet, receiver, fate)
        lost = np.flatnonzero(fate != Fate.DELIVERED)
        begins_s: FloatArray = packets["begins_s"]
        which = packet[lost]
        note(messages, fate[lost], packets, begins_s[which], receiver[lost], which=which)
        unreached = np.bincount(packet, minlength=len(packets)) == 0
        note(messages, Fate.INBOX, packets[is_missed], begins_s[is_missed])
        unreached &= ~is_missed
        note(messages, Fate.RANGE, packets[unreached], begins_s[unreached])
        if not len(lost):
            return packet, receiver
        reached = np.flatnonzero(fate == Fate.DELIVERED)
        return packet[reached], receiver[reached]

    def _block(
        self, state: EnvState, sent: _Batch, heard: Heard, fate: npt.NDArray[np.int8]
    ) -> None:
        """Set the fate of pairs that objects are between, where these matter."""
        packet, receiver, distance_m, _ = heard
        seen = np.flatnonzero((fate == Fate.DELIVERED) & (sent.walls < 1.0).take(packet))
        if not len(seen):
            return
        if len(seen) < len(packet):
            packet, receiver, distance_m = packet[seen], receiver[seen], distance_m[seen]
        enough = np.full(len(seen), MANY)
        # The range decreases with each object.
        for number in range(_TRIED, 0, -1):
            reach_m = sent.range_m * exact.power(sent.walls, float(number))
            np.putmask(enough, distance_m > reach_m.take(packet), number)
        bodies, place = state.bodies, sent.places_m.view(np.complex128)[:, 0]
        start, end = place.take(sent.sender.take(packet)), place.take(receiver)
        objects = self._sight.between(bodies.position_m, bodies.angle_rad, start, end, enough)
        blocked = objects >= enough
        rest = np.flatnonzero((enough == MANY) & (objects > _TRIED))
        if len(rest):
            walls, range_m = sent.walls[packet[rest]], sent.range_m[packet[rest]]
            reach_m = range_m * exact.power(walls, objects[rest].astype(np.float64))
            blocked[rest] = distance_m[rest] > reach_m
        fate[seen[blocked]] = Fate.BLOCKED

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
        lossy = ((channels.loss > 0.0) | (channels.burst_begin > 0.0))[channel]
        if not lossy.any():
            return
        reached = np.flatnonzero((fate == Fate.DELIVERED) & lossy[packet])
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
        channel: Int32Array = packets["channel"]
        begins_s: FloatArray = packets["begins_s"]
        sent_s = begins_s + channels.duration_s(packets)
        arrives_s = (sent_s + channels.delay_s[channel]).take(packet)
        jitter_s = channels.jitter_s[channel]
        if jitter_s.any():
            names = packets["sender"][packet], packets["number"][packet], receiver
            arrives_s += jitter_s.take(packet) * self._chances.draw(_JITTER, *names)
        coming = np.zeros(len(packet), RECEPTION)
        coming["receiver"], coming["packet"] = receiver, packet
        coming["arrives_s"] = np.maximum(arrives_s, end_s)
        return self._corrupted(packets, coming), coming

    def _corrupted(self, packets: Records, coming: Records) -> Records:
        """Return the messages, followed by the corrupted copies that arrive instead."""
        channel: Int32Array = packets["channel"]
        corruption = self._channels.corruption[channel]
        if not corruption.any():
            return packets
        packet: Int32Array = coming["packet"]
        share = corruption[packet]
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
