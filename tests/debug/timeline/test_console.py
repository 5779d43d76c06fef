"""Output and input go back with the run, and come again as they were."""

from __future__ import annotations

import pytest

from crs_cc.core.errors import InternalError
from crs_cc.debug.timeline.console import ReplayConsole
from crs_cc.session.host import discard, no_input


class Keyboard:
    """Somebody who types lines, and never the same one twice."""

    def __init__(self, *lines: bytes) -> None:
        self.lines = list(lines)

    def __call__(self, _robot: int, wanted: int) -> bytes:
        return self.lines.pop(0)[:wanted] if self.lines else b""


def test_replayed_output_is_recorded_once() -> None:
    console = ReplayConsole(discard, no_input)
    console.write(0, 1, b"a")
    place = console.snapshot()
    console.write(1, 2, b"bc")
    console.write(0, 1, b"")
    console.restore(place)
    assert console.text() == b"a"
    console.write(1, 2, b"bc")
    assert console.text() == b"abc"
    console.write(0, 1, b"")
    console.write(0, 1, b"d")
    assert console.text() == b"abcd"
    assert list(console.pieces()) == [(0, 1, b"a"), (1, 2, b"bc"), (0, 1, b""), (0, 1, b"d")]


def test_text_is_selected_by_robot_and_position() -> None:
    console = ReplayConsole(discard, no_input)
    for number in range(6):
        console.write(number % 3, 1, b"%d" % number)
    assert console.text(1) == b"14"
    assert console.text(since=4) == b"45"
    assert console.text(2, since=3) == b"5"
    assert console.text(7) == b""


def test_different_output_on_replay_is_an_internal_error() -> None:
    console = ReplayConsole(discard, no_input)
    start = console.snapshot()
    console.write(0, 1, b"x = 1\n")
    console.restore(start)
    with pytest.raises(InternalError, match=r"did not repeat itself: robot 0 wrote b'x = 2"):
        console.write(0, 1, b"x = 2\n")
    with pytest.raises(InternalError):
        console.write(0, 2, b"x = 1\n")


def test_output_is_shown_while_live_also_on_replay() -> None:
    shown: list[bytes] = []
    console = ReplayConsole(lambda _robot, _stream, content: shown.append(content), no_input)
    start = console.snapshot()
    console.write(0, 1, b"quiet")
    console.restore(start)
    console.is_live = True
    console.write(0, 1, b"quiet")
    console.write(0, 1, b"loud")
    assert shown == [b"quiet", b"loud"]


def test_output_after_a_change_is_replaced() -> None:
    console = ReplayConsole(discard, no_input)
    console.write(0, 1, b"one ")
    place = console.snapshot()
    console.write(0, 1, b"two")
    console.restore(place)
    console.truncate()
    console.write(0, 1, b"three")
    assert console.text() == b"one three"


def test_input_is_replayed_and_never_requested_twice() -> None:
    console = ReplayConsole(discard, Keyboard(b"first", b"second", b"third"))
    start = console.snapshot()
    assert [console.read(0, 100), console.read(2, 100)] == [b"first", b"second"]
    console.restore(start)
    assert [console.read(2, 100), console.read(0, 100)] == [b"second", b"first"]
    assert console.snapshot().read == (1, 0, 1)
    assert [console.read(0, 100), console.read(0, 100)] == [b"third", b""]


def test_input_survives_a_change() -> None:
    console = ReplayConsole(discard, Keyboard(b"first\n", b"second\n"))
    start = console.snapshot()
    assert [console.read(0, 100), console.read(0, 100)] == [b"first\n", b"second\n"]
    console.restore(start)
    console.truncate()
    assert [console.read(0, 4), console.read(0, 100)] == [b"firs", b"t\n"]
    assert [console.read(0, 100), console.read(0, 100)] == [b"second\n", b""]
