"""A run: how programs and environment take turns, one timestep after the other.

Time is cut into cycles `[t, t + dt)`. In each cycle

1. every program that is not waiting runs on until its own clock has passed the end of the cycle.
   Its clock moves by the processor time it uses (fuel) and by the time its commands take on the
   link. When it posts a request it stops: the host's requests are answered at once, the robot's
   when they have come through the link, in this cycle or in a later one;
2. the environment executes the cycle: the hardware simulator has cut the running commands into
   one slice for it. Waits that ended in it let their programs go on in the next cycle.

All robots that can go on are resumed in one call, and all requests with the same code are served
in one call, in the order of their codes; so a run is a function of programs, world and seed alone.

>>> from crs_cc.runtime.testing import counting_program
>>> from crs_cc.sim.files.world_xml import empty_world
>>> session = Session(empty_world(), [counting_program(rounds=42)])
>>> session.step()
False
>>> session.result().robots[0].exit_status
42
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from crs_cc.core.arrays import IndexArray, Int32Array, Int64Array
from crs_cc.requests import CODES, REGISTERED, REQUESTS, SUSPENDED
from crs_cc.session.host import (
    HOST_CODES,
    SYSTEM_CALL,
    TIME_SERVERS,
    HostRequest,
)
from crs_cc.session.session_state import ENDLESS, Crew

if TYPE_CHECKING:
    from crs_cc.session.host import TimeServer

_GOES_OUT = np.isin(np.arange(REGISTERED.stop + 1), list(REQUESTS.keys() - HOST_CODES))
"""By code, whether a request goes over the link; the last stands for all codes beyond."""


class Session(Crew):
    """A run of one program in each robot of a world; made, and kept, by `Crew`."""

    def step(self) -> bool:
        """Runs one timestep; gives False when all programs have ended, and no robot is to come."""
        while self.run_round():
            pass
        return self.end_cycle()

    def run_round(self) -> bool:
        """Lets programs go on for one round; gives False when all have used up the cycle.

        A debug build that stops before a marked statement ends the call in the middle of the round:
        `halted` tells whose it is. The next call goes on from there.
        """
        if not self.begin_round():
            return False
        self.run_programs()
        if self.halted is None:
            self.end_round()
        return True

    def begin_round(self) -> bool:
        """Finds out which programs go on, and for how long; gives False when none does.

        In the middle of a round it is known already.
        """
        if self.pending.any():
            return True
        end_s = self.environment.end_s
        self._answer_robots(end_s)
        ready = np.flatnonzero(self.alive & (self.clock_s < end_s) & (self._due_s == ENDLESS))
        if not ready.size:
            return False
        self.pending[ready] = budgets = self._budgets(ready, end_s)
        self.fleet.slots["run"][ready] = 1
        self.fleet.slots["fuel"][ready] = budgets
        return True

    def run_programs(self) -> None:
        """Lets the programs of this round run on, all of them or up to the first that is halted."""
        if self.halted is not None:
            self.fleet.slots["run"][self.halted] = 1
        self.halted = self.fleet.run_round()

    def end_round(self) -> None:
        """Takes up what the programs that ran have used, and what they ask for."""
        slots, ready = self.fleet.slots, np.flatnonzero(self.pending)
        burnt = self.pending[ready] - slots["fuel"][ready]
        self.pending[ready] = 0
        self.rounds += 1
        self.fuel[ready] += burnt
        self.clock_s[ready] += burnt / self._speed_hz[ready]
        self._end(ready[slots["status"][ready] != SUSPENDED])
        codes = slots["code"][ready]
        posted = (slots["status"][ready] == SUSPENDED) & (codes != 0)
        asked, codes = ready[posted], codes[posted]
        goes_out = _GOES_OUT.take(codes, mode="clip")
        if goes_out.any():
            self._send(asked[goes_out], codes[goes_out])
        if not goes_out.all():
            self._answer_hosts(asked[~goes_out], codes[~goes_out])

    def end_cycle(self) -> bool:
        """Lets the environment execute the cycle that all programs have used up.

        Gives False when all programs have ended, and no robot is to come.
        """
        step = self.environment.step()
        self.clock_s[step.robots] = self._called_s[step.robots] = step.at_s
        self.fleet.reply(step.robots, step.messages)
        self.timesteps += 1
        self.rounds = 0
        self._meet()
        if self._trace is not None:
            self._trace.step(step)
        return self.running > 0 or self.environment.awaits

    def now_s(self, robot: int) -> float:
        """Gives a program's clock [s], also in the middle of a round."""
        burnt = 0
        if self.pending[robot]:
            burnt = int(self.pending[robot] - self.fleet.slots["fuel"][robot])
        return float(self.clock_s[robot] + burnt / self._speed_hz[robot])

    def _budgets(self, ready: IndexArray, end_s: float) -> Int64Array:
        """Gives the fuel that takes programs to the end of the cycle."""
        fuel = np.ceil((end_s - self.clock_s[ready]) * self._speed_hz[ready])
        return np.asarray(fuel.astype(np.int64))

    def _send(self, robots: IndexArray, codes: Int32Array) -> None:
        """Puts requests on the link."""
        sizes = self.fleet.slots["message"]["size"][robots]
        link_s = self.environment.link_s(codes, robots, sizes)
        if not link_s.all():  # else a program that asks without end would keep the simulator busy
            self._call_system(robots[link_s == 0.0])
        self._due_s[robots] = self.clock_s[robots] + link_s

    def _call_system(self, robots: IndexArray) -> None:
        """Lets programs pay for a request with their hosts' processor time."""
        self.fuel[robots] += SYSTEM_CALL
        self.clock_s[robots] += SYSTEM_CALL / self._speed_hz[robots]

    def _answer_hosts(self, robots: IndexArray, codes: Int32Array) -> None:
        """Answers what programs ask of their hosts, at once."""
        self._call_system(robots)
        served = np.zeros(len(robots), dtype=np.bool_)
        for code, serve in TIME_SERVERS.items():
            same = codes == code
            if same.any():
                self._answer_time(serve, robots[same])
                served |= same
        left = zip(robots[~served].tolist(), codes[~served].tolist(), strict=True)
        for robot, code in left:
            self._answer_host(robot, code)

    def _answer_time(self, serve: TimeServer, robots: IndexArray) -> None:
        messages = self.fleet.messages(robots)
        used_s = self.fuel[robots] / self._speed_hz[robots]
        self.clock_s[robots] = serve(messages, self.clock_s[robots], used_s)
        self.fleet.reply(robots, messages)

    def _answer_host(self, robot: int, code: int) -> None:
        if code == CODES["UNCONNECTED"]:
            self.unconnected_calls[robot] = self.fleet.library_call(robot)
        message = self.fleet.slots["message"][robot : robot + 1][0]
        clock_s = float(self.clock_s[robot])
        used_s = float(self.fuel[robot] / self._speed_hz[robot])
        request = HostRequest(robot, message, clock_s, used_s)
        self.clock_s[robot] = self._host.serve(code, request)
        if self._host.exit_status[robot] is not None:
            self._end(np.array([robot]))

    def _answer_robots(self, end_s: float) -> None:
        """Serves the requests that come through the link before the end of the cycle."""
        due = np.flatnonzero(self._due_s < end_s)
        codes = self.fleet.slots["code"][due]
        for code in sorted(set(codes.tolist())):
            robots = due[codes == code]
            messages = self.fleet.messages(robots)
            self.clock_s[robots] = self.environment.serve(
                code, robots, messages, self._due_s[robots]
            )
            self.fleet.reply(robots, messages)
            self._called_s[robots] = self._due_s[robots]
            self._due_s[robots] = ENDLESS
