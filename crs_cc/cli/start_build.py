"""Start the world builder in the browser, and runs of its world in processes of their own."""

from __future__ import annotations

import contextlib
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Final

from crs_cc.builder.world_builder import WorldBuilder
from crs_cc.cli.inputs import check_readable
from crs_cc.cli.messages import say
from crs_cc.cli.start_view import open_browser
from crs_cc.workbench.build_screen import BuildScreen

_NEW: Final = ("8m", "6m")
_ADDRESS: Final = "crs: open "
_MAX_LINES: Final = 200
_ENDS_S: Final = 5.0


class Trial:
    """The run of a world as it is in the builder: `crs view` in a process of its own.

    The world is written beside its file, so that what it includes is found, and removed at the end.
    """

    def __init__(self, program: Path | None) -> None:
        self._program = program
        self._process: subprocess.Popen[str] | None = None
        self._file: Path | None = None

    def start(self, builder: WorldBuilder) -> str:
        """Start a run; return the address of its page.

        Raises:
            ValueError: it does not start; the message is the reason.
        """
        self.end()
        idle = [robot.id for robot in builder.world().robots if not robot.program]
        if self._program is None and idle:
            raise ValueError(
                f"robot {idle[0]!r} has no program: select it, and name a C file under 'program'"
            )
        path = builder.path or Path("new.xml")
        file = self._file = path.with_name(f".{path.stem}.trial.xml")
        file.write_bytes(builder.document.text)
        command = [sys.executable, "-m", "crs_cc", "view", str(file), "--no-open", "--play"]
        if self._program is not None:
            command.append(str(self._program))
        self._process = subprocess.Popen(  # noqa: S603 - ourselves
            command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
            text=True, errors="replace",
        )  # fmt: skip
        assert self._process.stderr is not None
        said = []
        for line in self._process.stderr:
            if line.startswith(_ADDRESS):
                return line.removeprefix(_ADDRESS).strip()
            said.append(line.strip())
            if len(said) >= _MAX_LINES:
                break
        self.end()
        why = "; ".join(filter(None, said[:3])) or "the run does not start"
        raise ValueError(why.replace(file.name, path.name))

    def end(self) -> None:
        """End the run, if there is one."""
        if self._process is not None:
            self._process.terminate()
            with contextlib.suppress(subprocess.TimeoutExpired):
                self._process.wait(_ENDS_S)
            self._process.kill()
            assert self._process.stderr is not None
            self._process.stderr.close()
            self._process = None
        if self._file is not None:
            self._file.unlink(missing_ok=True)
            self._file = None


@contextlib.contextmanager
def building(world: Path | None, program: Path | None, port: int) -> Iterator[BuildScreen]:
    """Serve a world that is edited, and end its run at the end.

    Raises:
        WorldError: the world cannot be read.
        OSError: the port is in use.
    """
    if world is None or not world.exists():
        builder = WorldBuilder.new(*_NEW, path=world)
    else:
        check_readable(world)
        builder = WorldBuilder(world)
    trial = Trial(program)
    screen = BuildScreen(builder, trial.start, port)
    try:
        yield screen
    finally:
        screen.close()
        trial.end()


def serve_builder(world: Path | None, program: Path | None, port: int, *, opens: bool) -> int:
    """Serve the world builder until Ctrl-C; return the exit status."""
    with building(world, program, port) as screen:
        address = screen.server.address()
        say(f"crs: open {address}  (Ctrl-C ends)")
        if opens:
            open_browser(address)
        with contextlib.suppress(KeyboardInterrupt):
            screen.wait()
        if screen.builder.is_changed:
            say("crs: the last changes were not saved")
    return 0
