from __future__ import annotations

from random import Random

import pytest
from textual.pilot import Pilot

from crs_cc.debug.tui.app import DebugApp
from crs_cc.debug.tui.command_line import CommandLine
from crs_cc.debug.tui.help_page import HelpPage
from crs_cc.debug.tui.keys import SHORTCUTS
from crs_cc.debug.tui.panes import Panes
from crs_cc.debug.tui.source_pane import SourcePane
from crs_cc.debug.tui.status_bars import StatusBar
from crs_cc.debug.tui.time_line import TimeLine
from crs_cc.debug.tui.variables_pane import VariablesPane
from crs_cc.debug.world.events import WorldEvent
from tests.debug.tui.fake_backend import FakeWork
from tests.debug.tui.screen import LARGE, TINY, drive, enter, settle, text_of, until


def test_function_keys_work_while_typing_and_letters_elsewhere() -> None:
    backend = FakeWork()

    async def session(pilot: Pilot[int], app: DebugApp) -> None:
        await pilot.press("p", "f11")
        await settle(pilot)
        assert app.query_one(CommandLine).value == "p"
        await pilot.press("escape", "s")
        await settle(pilot)
        assert app.query_one(CommandLine).value == "p"
        await pilot.press("S")
        await settle(pilot)

    drive(backend, session)
    assert backend.lines == ["step", "step", "reverse-step"]


def test_typed_commands_are_answered_in_the_console_pane() -> None:
    backend = FakeWork()

    async def session(pilot: Pilot[int], app: DebugApp) -> None:
        await enter(pilot, "print sum")
        await settle(pilot)
        assert app.query_one(Panes).picked == "console"
        assert "(crs) print sum\n$1 = 285\n" in text_of(app)
        await enter(pilot, "foo")
        await settle(pilot)
        assert 'Undefined command: "foo".  Try "help".' in text_of(app)

    drive(backend, session)


def test_history_and_completion_of_the_command_line() -> None:
    backend = FakeWork()

    async def session(pilot: Pilot[int], app: DebugApp) -> None:
        line = app.query_one(CommandLine)
        await enter(pilot, "print sum")
        await pilot.press("up")
        assert line.value == "print sum"
        await pilot.press("down", *"rev", "tab")
        assert line.value == "reverse-"
        await pilot.press("s", "tab")
        assert line.value == "reverse-step "

    drive(backend, session)


def test_ctrl_r_searches_the_commands_typed_before() -> None:
    backend = FakeWork()

    async def session(pilot: Pilot[int], app: DebugApp) -> None:
        line = app.query_one(CommandLine)
        line.value = "pr"
        found = []
        for _ in range(3):
            await pilot.press("ctrl+r")
            found.append(line.value)
        assert found == ["print speed", "print sum", "print sum"]  # no earlier one

    drive(backend, session, history=["print sum", "break 12", "print speed"])


def test_the_screen_is_responsive_while_the_program_runs() -> None:
    backend = FakeWork()

    async def session(pilot: Pilot[int], app: DebugApp) -> None:
        await pilot.press("f5")
        running = " running  continue: 4.50 s   Ctrl-C stops it"
        await until(pilot, lambda: text_of(app).startswith(running))
        await pilot.press("f11", "f2")  # a key that is held down does not pile up
        assert app.query_one(Panes).picked == "stack"
        app.action_pick("output")
        await until(pilot, lambda: "0 0\n2 2\n" in text_of(app))
        await pilot.press("ctrl+c")
        await settle(pilot)
        assert not app.query_one(StatusBar).running
        assert "2 2" not in text_of(app)  # what counts is the run's own account

    drive(backend, session)
    assert backend.lines == ["continue"]


def test_a_click_in_the_gutter_toggles_a_breakpoint() -> None:
    backend = FakeWork()

    async def session(pilot: Pilot[int], app: DebugApp) -> None:
        top = app.query_one(SourcePane).scroll_offset.y
        await pilot.click("#source", offset=(1, 10 - 1 - top))
        await settle(pilot)
        await pilot.click("#source", offset=(1, 9 - 1 - top))
        await settle(pilot)
        await pilot.click("#source", offset=(20, 8 - 1 - top))  # only marks the line
        assert app.query_one(SourcePane).cursor == 8
        await pilot.press("f9")
        await settle(pilot)

    drive(backend, session)
    assert backend.lines == ["break sum.c:10", "delete 1", "break sum.c:8"]
    assert sorted(backend.breakpoints) == [8, 10]


def test_the_only_completion_is_ended_unless_it_goes_on() -> None:
    backend = FakeWork()

    async def session(pilot: Pilot[int], app: DebugApp) -> None:
        line = app.query_one(CommandLine)
        for typed, completed in (
            ("con", "continue "),
            ("fi", "file:"),
            ("reverse-n", "reverse-next "),
        ):
            line.value = typed
            await pilot.press("end", "tab")
            assert line.value == completed
        await settle(pilot)
        assert not line._suggestion  # none before the next word has begun

    drive(backend, session)


def test_a_click_on_a_line_of_output_goes_to_the_statement_that_printed_it() -> None:
    backend = FakeWork()

    async def session(pilot: Pilot[int], app: DebugApp) -> None:
        await pilot.press("f11")
        await settle(pilot)
        app.action_pick("output")
        await pilot.click("#output", offset=(2, 2))
        await settle(pilot)
        await pilot.click("#output", offset=(2, 6))  # below all lines
        await settle(pilot)

    drive(backend, session, LARGE)
    assert backend.lines == ["step", "goto output 8"]


def test_values_expand_and_changes_are_highlighted() -> None:
    backend = FakeWork()

    async def session(pilot: Pilot[int], app: DebugApp) -> None:
        assert "i = 0" in text_of(app)
        await pilot.press("f11")
        await settle(pilot)
        assert "i • 1" in text_of(app)
        assert "y = -2\n" not in text_of(app)
        app.query_one(VariablesPane).focus()
        await pilot.press("down", "down", "enter")
        await settle(pilot)
        assert "├ x = 1.5" in text_of(app)
        assert "i • 1" in text_of(app)  # still, as the run has not moved
        await pilot.press("f11")
        await settle(pilot)
        assert "├ x = 1.5" in text_of(app)  # stays unfolded
        await pilot.press("enter")
        await settle(pilot)
        assert "├ x = 1.5" not in text_of(app)

    drive(backend, session)


def test_frames_and_robots_are_selected() -> None:
    backend = FakeWork()

    async def session(pilot: Pilot[int], app: DebugApp) -> None:
        await pilot.click("#stack", offset=(4, 2))
        await settle(pilot)
        await pilot.click("#robots", offset=(4, 1))
        await settle(pilot)

    drive(backend, session, LARGE)
    assert backend.lines == ["frame 1", "robot 0"]


def test_the_time_line_is_dragged_and_moved_by_keys() -> None:
    backend = FakeWork()

    async def session(pilot: Pilot[int], app: DebugApp) -> None:
        line = app.query_one(TimeLine)
        await pilot.mouse_down(line, offset=(30, 1))
        await pilot.hover(line, offset=(11, 1))
        assert "   0.000 s ┃" in text_of(app)  # where it would go
        await pilot.mouse_up(line, offset=(11, 1))
        await settle(pilot)
        line.focus()
        for key in ("left", "right", "shift+right", "end"):
            await pilot.press(key)
            await settle(pilot)

    drive(backend, session)
    goto = [
        "goto 3.333333",
        "goto 0.000000",
        "reverse-tick",
        "tick",
        "goto 7.000000",
        "goto 10.000000",
    ]
    assert backend.lines == goto


def test_events_of_the_current_timestep_are_passed_over() -> None:
    async def session(pilot: Pilot[int], app: DebugApp) -> None:
        line = app.query_one(TimeLine)
        line.focus()
        times = (3.1, 3.24, 3.3, 7.0)
        for key in ("shift+right", "shift+left"):
            line.happened = tuple(WorldEvent(at, "collision", 0, "hit") for at in times)
            line.now_s, line.timestep_s = 3.2, 0.1
            await pilot.press(key)
            await settle(pilot)

    backend = FakeWork()
    drive(backend, session)
    assert backend.lines == ["goto 3.300000", "goto 3.100000"]


def test_the_time_line_shows_the_event_under_the_pointer() -> None:
    async def session(pilot: Pilot[int], app: DebugApp) -> None:
        line = app.query_one(TimeLine)
        await pilot.hover(line, offset=(11 + round(0.7 * 57), 0))
        assert "7.000 s scout touched wall 3" in text_of(app)

    drive(FakeWork(), session)


def test_another_file_of_the_program_is_shown_until_the_run_moves() -> None:
    backend = FakeWork()

    async def session(pilot: Pilot[int], app: DebugApp) -> None:
        await pilot.press("escape", "o")
        await settle(pilot)
        assert app.query_one(SourcePane).file == "square.c"
        assert "double square(double x)" in text_of(app)
        await pilot.press("s")
        await settle(pilot)
        assert app.query_one(SourcePane).file == "sum.c"

    drive(backend, session)


def test_f1_shows_the_keys() -> None:
    async def session(pilot: Pilot[int], app: DebugApp) -> None:
        await pilot.press("f1")
        await until(pilot, lambda: "F6 Shift-F5 C" in text_of(app))
        for key in ("f11", "f2", "f4", "f9", "ctrl+c"):  # keys go on working below it
            await pilot.press(key)
            await settle(pilot)
        await pilot.press("escape")
        await until(pilot, lambda: not isinstance(app.screen, HelpPage))

    backend = FakeWork()
    drive(backend, session)
    assert backend.lines == ["step", "delete 1"]


def test_a_pane_can_be_maximised() -> None:
    async def session(pilot: Pilot[int], app: DebugApp) -> None:
        source = app.query_one(SourcePane)
        await pilot.press("escape", "z")
        await until(pilot, lambda: source.size.height == 19)
        await pilot.press("z")
        await until(pilot, lambda: source.size.height < 19)

    drive(FakeWork(), session)


def test_in_the_smallest_terminals_answers_replace_the_source() -> None:
    async def session(pilot: Pilot[int], app: DebugApp) -> None:
        assert "sum += i * i" in text_of(app)
        await enter(pilot, "print sum")
        await settle(pilot)
        assert "$1 = 285" in text_of(app)
        await pilot.press("f11")
        await settle(pilot)
        assert "sum += i * i" in text_of(app)

    drive(FakeWork(), session, TINY)


def test_ctrl_q_quits_even_while_the_program_runs() -> None:
    async def session(pilot: Pilot[int], app: DebugApp) -> None:
        await pilot.press("f5")
        await pilot.press("ctrl+q")

    assert drive(FakeWork(), session).return_value == 0


def test_ctrl_d_and_quit_exit() -> None:
    async def with_key(pilot: Pilot[int], app: DebugApp) -> None:
        await pilot.press("ctrl+d")

    async def with_command(pilot: Pilot[int], app: DebugApp) -> None:
        await enter(pilot, "quit")
        await until(pilot, lambda: app.return_value is not None)

    assert drive(FakeWork(), with_key).return_value == 0
    assert drive(FakeWork(), with_command).return_value == 0


def test_input_of_programs_is_typed_in_the_command_line() -> None:
    backend = FakeWork()

    async def session(pilot: Pilot[int], app: DebugApp) -> None:
        for answer in ("enter", "ctrl+d"):
            await enter(pilot, "until")
            await until(pilot, lambda: "scout reads: " in text_of(app))
            app.query_one(CommandLine).value = "" if answer == "ctrl+d" else " 42"
            await pilot.press(answer)
            await settle(pilot)
            assert "(crs) a command" in text_of(app)

    drive(backend, session)
    assert backend.given == [" 42", None]
    assert backend.lines == ["until", "until"]


def test_an_internal_error_closes_the_screen_and_is_raised(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def fail(self: StatusBar) -> None:
        raise ZeroDivisionError("oh")

    monkeypatch.setattr(StatusBar, "render", fail)
    app = DebugApp(FakeWork())
    with pytest.raises(ZeroDivisionError):
        app.show(headless=True)
    shown = capsys.readouterr()
    assert "Traceback" not in shown.out + shown.err


@pytest.mark.parametrize("seed", range(2))
def test_random_keys_do_no_harm(seed: int) -> None:
    random = Random(seed)
    keys = [key for each in SHORTCUTS for key in (*each.keys.split(","), each.letter)]
    keys = [key for key in keys if key not in {"", "ctrl+q", "f5", "c"}]
    keys += ["tab", "up", "down", "left", "right", "enter", "home", "end", "x", "pagedown"]

    async def session(pilot: Pilot[int], app: DebugApp) -> None:
        for _ in range(15):
            await pilot.press(random.choice(keys))
            place = random.randrange(app.size.width), random.randrange(app.size.height - 1)
            await pilot.click(offset=place)
            if random.random() < 0.1:
                await pilot.resize_terminal(*random.choice([(1, 2), TINY, (120, 20), LARGE]))
        await settle(pilot)

    drive(FakeWork(), session)
