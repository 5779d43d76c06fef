"""The filter of degradations: what happens to values from a sensor or to an actuator.

For each degradation, with its severity s at the time of the value:

    1. gain, bias, noise:  v = v * (1 + s * (gain - 1)) + s * bias + s * noise * normal deviate
    2. step:               v = the nearest multiple of s * step
    3. stuck:              v = (1 - s) * v + s * the value at which it is stuck
    4. delay:              v = (1 - s) * v + s * the value of `delay` before
    5. dropouts, dead:     nothing, with the probability s * dropouts, or s when it is dead

    s = 0 before the onset, 1 for the duration, then 1 - (time since) / recovery, then 0

so that all effects fade together: those with a size get smaller, those without get rarer. Several
degradations of an element apply in sequence, in the order of the world file, then in that in which
they were added; each gets the result of the one before it.

The stuck value is the last value from before the onset, or the first one if there was none, or the
specified one. A delayed value is the last one that was measured at least `delay` before, or the
first one of all; values are stored at least a 62nd of the delay apart (of all points of a laser, a
sixth). A direction is mixed along the shorter arc. Where there was nothing to measure, such as no
echo, steps 1 and 2 have no effect. A magnitude above 10^6 is 10^6.

Readings have a time each. Motions (`MOTIONS`) are speeds over an interval, for which s is the mean
severity; their deviates are drawn once in a timestep, however often it is divided; a delayed motion
is that of `delay` before, over an equally long interval; a dropped one is no motion for the
timestep.

Each degradation draws from a stream of its own: the robot's, numbered by the order of its
degradations, so that nothing changes for other robots and other degradations. All of this was
chosen by us; the kinds are those of the report's "sensor degradation".

>>> import numpy as np
>>> table = np.zeros(1, [(name, "f8") for name in ("onset_s", "duration_s", "recovery_s")])
>>> table[0] = 10.0, 5.0, 2.0
>>> [float(severity(table, np.array([at_s]))[0]) for at_s in (9.9, 10.0, 14.9, 15.5, 17.0)]
[0.0, 1.0, 1.0, 0.75, 0.0]
>>> float(mean_severity(table, np.array([9.0]), np.array([11.0]))[0])
0.5
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray
from crs_cc.core.time_grid import ROUNDING_S
from crs_cc.sim.devices.degradation.delay import delayed, delayed_speeds
from crs_cc.sim.devices.degradation.pipeline import distorted, mix, pass_of, stuck_at
from crs_cc.sim.model.degradation import degradables
from crs_cc.sim.state.degradation import MOTIONS, OVER, DegradationState, number_of
from crs_cc.sim.state.random_streams import DEGRADATION, NormalUniformStreams

if TYPE_CHECKING:
    from crs_cc.sim.state.env_state import EnvState


_FINEST: Final = 1e-9


@dataclass(frozen=True, slots=True)
class _Layer:
    """The n-th degradation of a device, for each robot that has that many.

    Attributes:
        place: the row of the table for each robot, -1 for none, (robots,).
        draws: their random numbers, one stream for each.
        stream: the number of each robot's stream, -1 for none, (robots,).
    """

    place: IndexArray
    draws: NormalUniformStreams
    stream: IndexArray


class Degradations:
    """The filter of all robots' degradations; their state is `EnvState.degradation`."""

    def __init__(self, seed: int) -> None:
        self._seed = seed
        self._of: BoolArray | None = None
        self._known: BoolArray | None = None
        self._affects_motion = False
        self._layers: dict[int, list[_Layer]] = {}

    def affects(self, state: EnvState, device: str) -> bool:
        """Return whether any robot has a degradation of a device."""
        return bool(state.degradation.present[number_of(device)])

    def affects_motion(self, state: EnvState) -> bool:
        """Return whether any robot has a degradation of `MOTIONS`."""
        present = state.degradation.present
        if present is not self._known:
            self._known = present
            self._affects_motion = any(self.affects(state, device) for device in MOTIONS)
        return self._affects_motion

    def alter(
        self,
        state: EnvState,
        device: str,
        rows: IndexArray,
        values: FloatArray,
        at_s: FloatArray,
        *,
        elements: IndexArray | None = None,
    ) -> FloatArray:
        """Return readings, or actuators' commands, after degradation.

        Call it exactly once for each measured value.

        Args:
            state: changed in place: the memory of past values.
            device: the device's name in `degradables()`.
            rows: the robots, each at most once, k of them.
            values: the values [SI unit of the device], not finite for no value, (k, width).
            at_s: the time of each robot, shape (k,).
            elements: the element of each row of `values`, which is then (k, 1); by default the
                columns are the elements, from 0 on.

        Returns:
            the values, NaN for none, shape (k, width); `values` itself without degradations.
        """
        number, kept = number_of(device), state.degradation
        if not kept.present[number]:
            return values
        values = np.array(values, dtype=np.float64)
        columns = np.broadcast_to(np.arange(values.shape[1]), values.shape)
        if elements is not None:
            columns = np.asarray(elements, dtype=np.intp)[:, None]
        for layer in self._of_device(kept, number):
            mine = np.flatnonzero(layer.place[rows] >= 0)
            if not len(mine):
                continue
            place = layer.place[rows[mine]]
            row = kept.table[place]
            numbers = row["count"].copy()
            kept.table["count"][place] += 1
            s = severity(row, at_s[mine])
            passing = pass_of(kept, row, columns[mine], s, at_s[mine])
            normal, uniform = layer.draws.rows(layer.stream[rows[mine]], numbers)
            new = distorted(passing, values[mine], _pick(normal, columns[mine]))
            before = passing.at_s < passing.of("onset_s") - ROUNDING_S
            new = stuck_at(passing, new, before, number)
            if row["depth"].any():
                new = mix(passing.s, new, delayed(passing, new), number)
            lost = np.where(passing.of("dead"), passing.s, passing.s * passing.of("dropouts"))
            new = np.where(_pick(uniform, columns[mine]) < lost, np.nan, new)
            values[mine] = np.where(passing.touched, new, values[mine])
        return values

    def move(
        self,
        state: EnvState,
        device: str,
        rows: IndexArray | slice,
        motions: FloatArray,
        *,
        from_s: FloatArray,
        to_s: FloatArray,
        limit: FloatArray | None = None,
    ) -> FloatArray:
        """Return the motions of axes between two times after degradation.

        Args:
            state: changed in place: the memory of past values.
            device: one of `MOTIONS`.
            rows: the robots, each at most once, k of them.
            motions: the motion of each axis, shape (k, 3).
            from_s: the start of each robot's interval, (k,).
            to_s: its end, (k,).
            limit: maximum speed of the axes of each robot, (robots, 3); None for no limit.

        Returns:
            the motions, shape (k, 3); `motions` itself without degradations.
        """
        if not state.degradation.present[number_of(device)]:
            return motions
        robots = np.arange(len(state.degradation.made))[rows]
        for_s = (to_s - from_s)[:, None]
        runs = np.flatnonzero(for_s[:, 0] > 0.0)
        commanded = motions[runs] / for_s[runs]
        instants = (from_s[runs], to_s[runs])
        speeds = self._speeds(state, device, robots[runs], commanded.copy(), instants, writes=True)
        if limit is not None:
            speeds = np.clip(speeds, -limit[robots[runs]], limit[robots[runs]])
        other = motions.copy()
        # Elements without a degradation stay the same to the last bit.
        other[runs] = np.where(speeds == commanded, motions[runs], speeds * for_s[runs])
        return other

    def speeds(
        self, state: EnvState, device: str, rows: IndexArray, speeds: FloatArray, at_s: FloatArray
    ) -> FloatArray:
        """Return the speeds of axes after degradation, without storing them.

        Args:
            state: has the memory of past values.
            device: one of `MOTIONS`.
            rows: the robots, each at most once, k of them.
            speeds: the speed of each axis, shape (k, 3).
            at_s: the time of each robot, (k,).
        """
        if not state.degradation.present[number_of(device)]:
            return speeds
        return self._speeds(state, device, rows, speeds.copy(), (at_s, at_s), writes=False)

    def _speeds(
        self,
        state: EnvState,
        device: str,
        rows: IndexArray,
        speeds: FloatArray,
        instants: tuple[FloatArray, FloatArray],
        *,
        writes: bool,
    ) -> FloatArray:
        number, kept = number_of(device), state.degradation
        columns = np.broadcast_to(np.arange(speeds.shape[1]), speeds.shape)
        for layer in self._of_device(kept, number):
            mine = np.flatnonzero(layer.place[rows] >= 0)
            if not len(mine):
                continue
            row = kept.table[layer.place[rows[mine]]]
            from_s, to_s = instants[0][mine], instants[1][mine]
            s = mean_severity(row, from_s, to_s)
            passing = pass_of(kept, row, columns[mine], s, to_s, writes=writes)
            cycles = np.full(len(mine), state.cycle)
            normal, uniform = layer.draws.rows(layer.stream[rows[mine]], cycles)
            new = distorted(passing, speeds[mine], normal)
            new = stuck_at(passing, new, passing.at_s <= passing.of("onset_s") + ROUNDING_S, number)
            if row["depth"].any():
                new = mix(passing.s, new, delayed_speeds(passing, new, from_s), number)
            lost = passing.of("dead") | (uniform < passing.of("dropouts"))
            new = np.where(lost, (1.0 - passing.s) * new, new)
            speeds[mine] = np.where(passing.touched, new, speeds[mine])
        return speeds

    def _of_device(self, kept: DegradationState, number: int) -> list[_Layer]:
        """Return the layers of a device; rebuild them when the table has changed."""
        if kept.present is not self._of:
            self._of = kept.present
            self._layers = {}
        if number not in self._layers:
            self._layers[number] = self._layers_of(kept, number)
        return self._layers[number]

    def _layers_of(self, kept: DegradationState, number: int) -> list[_Layer]:
        table, width = kept.table, list(degradables().values())[number].width
        layers: list[list[int]] = []
        depth: dict[int, int] = {}
        for place in np.flatnonzero(
            (table["device"] == number) & (table["phase"] != OVER)
        ).tolist():
            robot = int(table["robot"][place])
            layer = depth.get(robot, 0)
            depth[robot] = layer + 1
            if layer == len(layers):
                layers.append([])
            layers[layer].append(place)
        return [self._layer(kept, places, width) for places in layers]

    def _layer(self, kept: DegradationState, places: list[int], width: int) -> _Layer:
        robots = kept.table["robot"][places]
        place = np.full(len(kept.made), -1, dtype=np.intp)
        place[robots] = places
        stream = np.full(len(kept.made), -1, dtype=np.intp)
        stream[robots] = np.arange(len(places))
        pairs = zip(robots.tolist(), kept.table["serial"][places].tolist(), strict=True)
        keys = [(robot, DEGRADATION, serial) for robot, serial in pairs]
        row = kept.table[places]
        random = row["noise"].any() or row["dropouts"].any() or row["dead"].any()
        return _Layer(
            place, NormalUniformStreams(self._seed, keys, width, draws=bool(random)), stream
        )


def severity(row: Any, at_s: FloatArray) -> FloatArray:
    """Return the severity of degradations at times, 0 to 1, shape (m,)."""
    since_s = at_s - row["onset_s"] + ROUNDING_S
    beyond_s = since_s - row["duration_s"]
    fades = row["recovery_s"] > 0.0
    left = 1.0 - (beyond_s - ROUNDING_S) / np.where(fades, row["recovery_s"], 1.0)
    faded = np.where(fades, np.clip(left, 0.0, 1.0), 0.0)
    return np.where(since_s < 0.0, 0.0, np.where(beyond_s < 0.0, 1.0, faded))


def mean_severity(row: Any, from_s: FloatArray, to_s: FloatArray) -> FloatArray:
    """Return the mean severity between two times, or that at the second if they are equal."""
    for_s = to_s - from_s
    total_s = _so_far_s(row, to_s) - _so_far_s(row, from_s)
    mean = np.divide(total_s, for_s, out=severity(row, to_s), where=for_s > ROUNDING_S)
    # Rounding errors near 0 and 1 must not leave an effect of a degradation that is over.
    return np.asarray(np.where(mean < _FINEST, 0.0, np.where(mean > 1.0 - _FINEST, 1.0, mean)))


def _so_far_s(row: Any, at_s: FloatArray) -> FloatArray:
    """Return the integral of the severity up to times."""
    since_s = np.maximum(at_s - row["onset_s"], 0.0)
    whole_s = np.minimum(since_s, row["duration_s"])
    fading_s = np.clip(since_s - row["duration_s"], 0.0, row["recovery_s"])
    half = np.where(row["recovery_s"] > 0.0, 2 * row["recovery_s"], 1.0)
    return np.asarray(whole_s + fading_s - fading_s * fading_s / half)


def _pick(draws: FloatArray, columns: IndexArray) -> FloatArray:
    return np.asarray(np.take_along_axis(draws, columns, axis=1))
