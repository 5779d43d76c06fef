"""The environment: the world as it changes, cycle after cycle, for all robots at once.

A cycle [k dt, (k + 1) dt) goes like this. First the session hands over what the programs ask for
(`serve`), each request at its own instant: the wheels of that robot are turned on to the instant,
then the command changes their motion or the sensors are read. Then `step` ends the cycle: all
wheels are turned on to its end, which makes each robot's slice of the cycle; the physics moves the
bodies along these slices; contacts press bumpers; time goes on.

>>> from crs_cc.requests import CODES, MESSAGE
>>> from crs_cc.sim.files.world_xml import empty_world
>>> environment = Environment(empty_world(), seed=1)
>>> robots, messages = np.array([0]), np.zeros(1, MESSAGE)
>>> environment.serve(CODES["CONNECT"], robots, messages, np.array([0.0]))
array([0.])
>>> messages["i"][0, :2] = 100, 100                       # a move of 10 inches
>>> environment.serve(CODES["PR"], robots, messages, np.array([0.02]))
array([0.02])
>>> for _ in range(40):
...     step = environment.step()
>>> round(float(environment.state.x_m[0]), 6), environment.time_s
(0.254, 2.0)
"""

from __future__ import annotations

from typing import Final

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int32Array, Records
from crs_cc.requests import CODES, MESSAGE, REQUESTS, Request
from crs_cc.sim.comms.message_log import take
from crs_cc.sim.devices import drive
from crs_cc.sim.devices.drive import traction
from crs_cc.sim.devices.request_context import RequestContext
from crs_cc.sim.devices.waits import settle, when
from crs_cc.sim.engine.falls import tell_falls
from crs_cc.sim.engine.step import Served, Step, slices_of
from crs_cc.sim.engine.world_data import Setting

_ALL: Final = slice(None)


class Environment(Setting):
    """A world while it runs."""

    def link_s(
        self, codes: npt.ArrayLike, robots: npt.ArrayLike = 0, sizes: npt.ArrayLike = 0
    ) -> FloatArray:
        """Gives the time that requests take on the line between host and robot [s].

        Args:
            codes: the requests' codes.
            robots: whose they are.
            sizes: bytes of their data.

        Returns:
            the times, in the shape that the three give when they are broadcast.
        """
        return self._line.time_s(self.state.link, codes, robots, sizes)

    def serve(
        self, code: int, robots: IndexArray, messages: Records, clock_s: FloatArray
    ) -> FloatArray:
        """Answers one kind of request of all robots that posted it.

        What is asked may be nonsense: it is refused (result 0) or brought within limits.

        Args:
            code: the request's code.
            robots: who asks, rising, k of them.
            messages: what each asks, of dtype `MESSAGE`; changed in place into the replies.
            clock_s: when each request reaches the robot, within the current cycle.

        Returns:
            when each program goes on, shape (k,): at once, or at the end of a wait that ends in
            this cycle, or infinite for a wait that goes on (`step` tells when it ends).
        """
        state, rows = self.state, np.asarray(robots, dtype=np.intp)
        if code not in self._handlers or not len(rows):
            messages["result"] = 0
            return np.array(clock_s, dtype=np.float64)
        request = REQUESTS[code]
        now_s = np.fmin(np.fmax(clock_s, state.drive.clock_s[rows]), self.end_s)
        self._advance_to(rows, now_s)
        arguments = messages["i"].copy()
        state.commands[rows] += 1
        drive.renew_deadline(state, rows)
        good = self._handle(request, rows, messages, now_s)
        if request.moves:
            self._let_go_if_empty(rows, now_s)
        goes_on_s = now_s.copy()
        if request.changes_world:
            goes_on_s[:] = self.end_s
            self._refurnish(moved=code == CODES["PLACE_ROBOT"] and bool(good.any()))
            self._advance_to(rows, goes_on_s)
        if request.waits:
            waiting = messages[good]
            goes_on_s[good] = self._wait(request, rows[good], waiting)
            messages[good] = waiting
        answered = np.isfinite(goes_on_s)
        if answered.all():
            self._reply(request, rows, messages, goes_on_s, good, arguments=arguments)
        else:
            replies = messages[answered]
            at_s, good, arguments = goes_on_s[answered], good[answered], arguments[answered]
            self._reply(request, rows[answered], replies, at_s, good, arguments=arguments)
            messages[answered] = replies
        return goes_on_s.copy()

    def step(self) -> Step:
        """Ends the cycle, and gives what happened in it and which waits end in the next."""
        state = self.state
        robots, present = len(state.drive.clock_s), np.flatnonzero(state.presence.present)
        self._advance_to(present, np.full(len(present), self.end_s))
        self._rolling.add(state, self._constants)
        # The slices of the cycle are complete: what they pull at moves, or is held up.
        before_m = state.bodies.position_m[:robots].copy()
        handling, pull = self._devices.handling, traction.pull(state, self._constants)
        contacts = self._physics.step(
            state.bodies, handling.pull(state, self._constants, pull, self.end_s)
        )
        # Wheels that were held up have not turned; only then is known what the robots did.
        went_m = state.bodies.position_m[:robots] - before_m
        traction.feel(state, self._constants, went_m)
        slices = slices_of(state, self._axes, self.timestep_s)
        tell_falls(self._constants, self._log, self.end_s, before_m, went_m)
        state.distance_m += traction.ways_m(self._constants, before_m, went_m)
        drive.face(state, self._constants)
        # Hands close on what is there now; what is held makes other bodies.
        if handling.end_cycle(state, self._constants, contacts, self.end_s):
            self._physics.start_from(state.bodies)
        # Motors that lack force are limp from the next cycle on.
        worked = self._devices.sensor_board.batteries.drain(state, self.timestep_s)
        self._let_go_if_empty(worked, self.end_s)
        # Contacts number things as they still are: whoever comes or goes below changes that.
        before = state.bumpers.pressed
        began = self._bumpers.touch(state, self._constants, contacts, self.end_s)
        pressed = state.bumpers.pressed
        touches = (began, pressed & ~before, before & ~pressed, self._names)
        # Degradations that begin are told before the devices that work at the end.
        cycle, time_s, served = state.cycle, self.time_s, tuple(self._served)
        if state.degradation.next_s < self.end_s:
            self.degradations.tell(self.end_s)
        self._devices.end_cycle(state, self._constants, self.time_s, self.end_s)
        traffic = take(state.messages)
        self._begin_cycle()
        # In the next cycle already: waits that end in it, and who comes or goes at its start.
        ended, at_s, messages = self._end_waits()
        if self._is_anybody_due():
            self._come_and_go()
        heard = (slices, served, self._log.take(self.time_s), traffic)
        return Step(cycle, time_s, ended, at_s, messages, *touches, *heard)

    def _advance_to(self, rows: IndexArray, to_s: FloatArray) -> None:
        """Let timers fire and turn the wheels of robots, up to instants of this cycle."""
        # Sensors measure on the way that wheels turn, so before they are turned on.
        self._devices.advance(self.state, self._constants, self._rays, rows, to_s)
        everybody = len(rows) == len(self.state.drive.clock_s)
        drive.advance(self.state, self._constants, _ALL if everybody else rows, to_s)

    def _context(
        self, request: Request, rows: IndexArray, messages: Records, at_s: FloatArray
    ) -> RequestContext:
        return RequestContext(
            request, self.state, self._constants, self._rays, rows, messages, at_s
        )

    def _handle(
        self, request: Request, rows: IndexArray, messages: Records, at_s: FloatArray
    ) -> BoolArray:
        """Do what connected robots ask; return which requests were good."""
        messages["result"] = 1
        if request.needs_connection:
            good = self.state.connected[rows]
        else:
            good = self.state.presence.present[rows]
        handler = self._handlers[request.code]
        if good.all():
            verdict = handler(self._context(request, rows, messages, at_s))
        else:
            connected = messages[good]
            verdict = handler(self._context(request, rows[good], connected, at_s[good]))
            messages[good] = connected
        if verdict is not None:
            good[good] = verdict
        return good

    def _let_go_if_empty(self, rows: IndexArray, at_s: FloatArray | float) -> None:
        """Take the motors' force from robots whose batteries are empty."""
        if not len(rows):
            return
        batteries = self._devices.sensor_board.batteries
        empty = rows[batteries.empty(self.state, rows, at_s)]
        if len(empty):
            drive.go_limp(self.state, self._constants, empty)

    def _reply(
        self,
        request: Request,
        rows: IndexArray,
        messages: Records,
        at_s: FloatArray,
        good: BoolArray,
        *,
        arguments: Int32Array,
    ) -> None:
        """Complete replies, and note for traces what was answered."""
        messages["result"][~good] = 0
        states = None
        if request.replies_state:
            context = self._context(request, rows, messages, at_s)
            states = self._devices.sensor_board.reply(context, good)
        results = messages["result"].copy()
        told = messages.copy() if request.traced else None
        self._served.append(Served(request.code, rows, at_s, arguments, results, states, told))

    def _begin_cycle(self) -> None:
        state = self.state
        state.cycle += 1
        state.drive.moved_m = np.zeros_like(state.drive.moved_m)  # the physics keeps the old array
        state.drive.slice[:] = 0.0
        state.drive.facing_rad[:] = state.heading_rad
        self._served = []

    def _end_waits(self) -> tuple[IndexArray, FloatArray, Records]:
        """Answers the waits that end in the cycle that begins."""
        waits = self.state.waits
        waiting = np.flatnonzero(waits.code)
        if not len(waiting):
            return waiting, np.zeros(0), np.zeros(0, MESSAGE)
        codes, asked = waits.code[waiting], waits.asked[waiting]
        ends_s = self._settle_waits(waiting)
        ended = np.isfinite(ends_s)
        rows, at_s, messages, codes = waiting[ended], ends_s[ended], asked[ended], codes[ended]
        for code in np.unique(codes).tolist():
            request, mine = REQUESTS[code], codes == code
            replies, arguments = messages[mine], messages["i"][mine].copy()
            self._finish(request, rows[mine], replies, at_s[mine])
            good = np.ones(len(replies), dtype=np.bool_)
            self._reply(request, rows[mine], replies, at_s[mine], good, arguments=arguments)
            messages[mine] = replies
        return rows, at_s, messages

    def _wait(self, request: Request, rows: IndexArray, messages: Records) -> FloatArray:
        """Begin to wait; return when those go on that do so in this cycle, else infinity.

        Answers these, in place.
        """
        self.state.waits.begin(request.code, rows, messages)
        goes_on_s = self._settle_waits(rows)
        ended = np.isfinite(goes_on_s)
        replies = messages[ended]
        self._finish(request, rows[ended], replies, goes_on_s[ended])
        messages[ended] = replies
        return goes_on_s

    def _finish(
        self, request: Request, rows: IndexArray, messages: Records, at_s: FloatArray
    ) -> None:
        """Do what is done when waits have ended, whose messages become the replies."""
        self._devices.advance(self.state, self._constants, self._rays, rows, at_s)
        context = self._context(request, rows, messages, at_s)
        verdict = self._waits[request.code].finish(context)
        if verdict is not None:
            messages["result"][~verdict] = 0

    def _settle_waits(self, rows: IndexArray) -> FloatArray:
        """End the waits that end in this cycle; devices work on the way to their ends."""
        if not len(rows):
            return np.zeros(0)
        state, constants = self.state, self._constants
        ends_s = when(self._waits, state, rows)
        soon = ends_s < self.end_s
        until_s = np.minimum(ends_s, state.drive.deadline_s[rows])
        self._devices.advance(state, constants, self._rays, rows[soon], until_s[soon])
        return settle(self._waits, state, constants, rows, self.end_s)
