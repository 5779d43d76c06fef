"""Requests: from robots to handlers and back as replies, at once or at the end of a wait."""

from __future__ import annotations

from typing import Final

import numpy as np

from crs_cc.core.arrays import (
    BoolArray,
    FloatArray,
    IndexArray,
    Int32Array,
    Records,
    all_of,
    any_of,
    copied,
)
from crs_cc.requests import CODES, MESSAGE, REQUESTS, Request
from crs_cc.sim.devices import drive
from crs_cc.sim.devices.request_context import RequestContext
from crs_cc.sim.devices.waits import when
from crs_cc.sim.engine.simple_requests import answer_simple_requests
from crs_cc.sim.engine.step import Served
from crs_cc.sim.engine.world_data import WorldData

_MESSAGES: Final = {CODES["SEND"], CODES["RECEIVE"], CODES["MESSAGE_COUNT"]}
"""Requests that need nothing of robots but that their clocks have reached the time."""
_NO_WAITS: Final = np.zeros(0, np.intp), np.zeros(0), np.zeros(0, MESSAGE)


class Dispatcher:
    """The dispatcher of the requests of all robots of a world.

    Attributes:
        served: the requests that were answered in this cycle, in order.
    """

    def __init__(self, data: WorldData) -> None:
        self.served: list[Served] = []
        self._data = data

    def serve(
        self, code: int, robots: IndexArray, messages: Records, clock_s: FloatArray
    ) -> FloatArray:
        """Answer requests of one kind, see `Environment.serve`."""
        data, rows = self._data, np.asarray(robots, dtype=np.intp)
        state = data.state
        if code not in data.handlers or not len(rows):
            messages["result"] = 0
            return np.array(clock_s, dtype=np.float64)
        arguments = messages["i"].copy()
        simply = answer_simple_requests(data, code, rows, messages, clock_s)
        if simply is not None:
            goes_on_s, states = simply
            self._note(code, (rows, goes_on_s), messages, arguments=arguments, states=states)
            return goes_on_s.copy()
        request, drives = REQUESTS[code], state.drive
        reached_s = drives.clock_s[rows]
        now_s = np.fmin(np.fmax(clock_s, reached_s), data.end_s)
        if code in _MESSAGES and all_of(now_s == reached_s):
            drive.renew_deadline(state, rows)
        else:
            data.advance_to(rows, now_s, renews=True)
        state.commands[rows] += 1
        context = self._context(request, rows, messages, now_s)
        good = self._handle(context)
        if request.moves:
            data.go_limp_if_empty(rows, now_s)
        goes_on_s = now_s.copy()
        if request.changes_world:
            goes_on_s[:] = data.end_s
            data.rebuild_scene_data(moved=code == CODES["PLACE_ROBOT"] and bool(good.any()))
            data.advance_to(rows, goes_on_s)
            context = self._context(request, rows, messages, goes_on_s)
        if not request.waits or self._ends_at_once(context, good):
            self._reply(context, good, arguments=arguments)
            return goes_on_s
        waiting = messages[good]
        goes_on_s[good] = self._wait(request, rows[good], waiting)
        messages[good] = waiting
        answered = np.isfinite(goes_on_s)
        if not any_of(answered):
            return goes_on_s
        replies = messages[answered]
        context = self._context(request, rows[answered], replies, goes_on_s[answered])
        self._reply(context, good[answered], arguments=arguments[answered])
        messages[answered] = replies
        return goes_on_s

    def end_waits(self) -> tuple[IndexArray, FloatArray, Records]:
        """Answer the waits that end in the cycle that begins."""
        waits = self._data.state.waits
        if not np.count_nonzero(waits.code):
            return _NO_WAITS
        waiting = np.flatnonzero(waits.code)
        codes, asked = waits.code[waiting], waits.asked[waiting]
        ends_s = self._end_waits_of(waiting)
        ended = np.isfinite(ends_s)
        rows, at_s, messages, codes = waiting[ended], ends_s[ended], asked[ended], codes[ended]
        for code in sorted(set(codes.tolist())):
            request, mine = REQUESTS[code], codes == code
            replies, arguments = messages[mine], messages["i"][mine].copy()
            self._finish(request, rows[mine], replies, at_s[mine])
            good = np.ones(len(replies), dtype=np.bool_)
            context = self._context(request, rows[mine], replies, at_s[mine])
            self._reply(context, good, arguments=arguments)
            messages[mine] = replies
        return rows, at_s, messages

    def _ends_at_once(self, context: RequestContext, good: BoolArray) -> bool:
        """End the waits of requests if none has to wait; return whether that was so."""
        data, state, rows = self._data, self._data.state, context.rows
        if not all_of(good):
            return False
        ends_s = data.waits[context.request.code].ends_s(state, rows)
        late_s = np.minimum(data.end_s, state.drive.deadline_s[rows])
        if not all_of((ends_s <= context.at_s) & (ends_s < late_s)):
            return False
        state.waits.axes[rows] = False
        self._finish(context.request, rows, context.messages, ends_s)
        return True

    def _wait(self, request: Request, rows: IndexArray, messages: Records) -> FloatArray:
        """Start to wait; return the ends of the waits that end in this cycle, else infinity.

        Answer those that end, in place.
        """
        self._data.state.waits.begin(request.code, rows, messages)
        goes_on_s = self._end_waits_of(rows)
        ended = np.isfinite(goes_on_s)
        replies = messages[ended]
        self._finish(request, rows[ended], replies, goes_on_s[ended])
        messages[ended] = replies
        return goes_on_s

    def _finish(
        self, request: Request, rows: IndexArray, messages: Records, at_s: FloatArray
    ) -> None:
        """Finish waits that have ended: turn their messages into the replies."""
        context = self._context(request, rows, messages, at_s)
        verdict = self._data.waits[request.code].finish(context)
        if verdict is not None:
            messages["result"][~verdict] = 0

    def _end_waits_of(self, rows: IndexArray) -> FloatArray:
        """End the waits of robots that end in this cycle, with the robots advanced to these times.

        Returns:
            the time at which each wait ended, infinite for those that continue, shape (k,).
        """
        data, state = self._data, self._data.state
        ends_s = when(data.waits, state, rows)
        # The command timeout may expire before; then the axes stop earlier than predicted.
        deadline_s = state.drive.deadline_s[rows]
        cut = (deadline_s < ends_s) & (deadline_s < data.end_s)
        if cut.any():
            data.advance_to(rows[cut], np.nextafter(deadline_s[cut], np.inf))
            ends_s = when(data.waits, state, rows)
        ended = ends_s < data.end_s
        if ended.any():
            data.advance_to(rows[ended], ends_s[ended])
            state.waits.end(rows[ended])
        return np.where(ended, ends_s, np.inf)

    def _context(
        self, request: Request, rows: IndexArray, messages: Records, at_s: FloatArray
    ) -> RequestContext:
        data = self._data
        return RequestContext(request, data.state, data.constants, data.rays, rows, messages, at_s)

    def _handle(self, context: RequestContext) -> BoolArray:
        """Execute the requests of connected robots; return which requests were good."""
        request, rows, messages = context.request, context.rows, context.messages
        messages["result"] = 1
        if request.needs_connection:
            good = self._data.state.connected[rows]
        else:
            good = self._data.state.presence.present[rows]
        handler = self._data.handlers[request.code]
        if all_of(good):
            verdict = handler(context)
            return good if verdict is None else verdict
        connected = messages[good]
        verdict = handler(self._context(request, rows[good], connected, context.at_s[good]))
        messages[good] = connected
        if verdict is not None:
            good[good] = verdict
        return good

    def _reply(self, context: RequestContext, good: BoolArray, *, arguments: Int32Array) -> None:
        """Complete replies, and record them for traces."""
        request, messages = context.request, context.messages
        if not all_of(good):
            messages["result"][~good] = 0
        states = None
        if request.replies_state:
            states = self._data.devices.sensor_board.reply(context, good)
        replied = context.rows, context.at_s
        self._note(request.code, replied, messages, arguments=arguments, states=states)

    def _note(
        self,
        code: int,
        replied: tuple[IndexArray, FloatArray],
        messages: Records,
        *,
        arguments: Int32Array,
        states: Int32Array | None,
    ) -> None:
        """Record replies for traces."""
        self.served.append(
            Served(
                code=code,
                robots=replied[0],
                clock_s=replied[1],
                arguments=arguments,
                results=messages["result"].copy(),
                states=states,
                replies=copied(messages) if REQUESTS[code].traced else None,
            )
        )
