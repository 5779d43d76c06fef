"""Repeating a recorded run: its options, its files on a disk, its input."""

from __future__ import annotations

import tempfile
from collections import deque
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from crs_cc.cli.compiler_options import CompilerOptions
from crs_cc.cli.inputs import Inputs
from crs_cc.cli.program_options import ProgramOptions, RobotProgram
from crs_cc.frontend.preprocess.options import DIALECTS, STANDARDS
from crs_cc.recording import topics
from crs_cc.recording.content import content_of
from crs_cc.recording.source_tree import is_safe, write_tree
from crs_cc.session.host import CLIENTS, LINKS

if TYPE_CHECKING:
    from crs_cc.recording.recording import Recording

O = TypeVar("O", bound=ProgramOptions)  # noqa: E741


@contextmanager
def extracted_run(recording: Recording, kind: type[O], **others: Any) -> Iterator[O]:
    """Write the files of a recorded run to a temporary folder; yield the options to run it again.

    Args:
        recording: the recording.
        kind: the class of the options.
        others: further fields of it.

    Raises:
        RecordingError: what is recorded is not valid.
    """
    run = recording.description
    with recording.errors():
        for value, known in (
            (run.client, CLIENTS),
            (run.link, LINKS),
            (run.standard, STANDARDS),
            (run.dialect, ("", *DIALECTS)),
        ):
            if value not in known:
                raise ValueError(f"unknown {value[:20]!r} (known: {', '.join(known)})")
    with tempfile.TemporaryDirectory(prefix="crs-replay-") as name:
        root = Path(name)
        (root / "source").mkdir()
        (root / "input").mkdir()
        recording.write_sources(root / "source")
        inputs = recording.inputs()
        with recording.errors():
            numbered = {f"{number}": content for number, content in enumerate(inputs.values())}
            write_tree(numbered, root / "input")
        files = {each: root / "input" / f"{number}" for number, each in enumerate(inputs)}
        tree = root / "source"
        is_file = run.robot.endswith(".xml") and is_safe(run.robot)
        compiler = CompilerOptions(
            tuple(tree / path for path in run.include_paths),
            run.defines,
            run.undefines,
            run.standard,
            run.dialect or None,  # type: ignore[arg-type]
            named_from=tree,
        )
        yield kind(
            inputs=Inputs(
                tuple(tree / path for path in run.sources), tree / run.world if run.world else None
            ),
            arguments=run.arguments,
            programs={
                robot: RobotProgram(tuple(tree / path for path in sources), arguments)
                for robot, (sources, arguments) in run.robots_programs().items()
            },
            compiler=compiler,
            checked=run.checked,
            trap_overflow=run.trap_overflow,
            seed=run.seed,
            inputs_on_disk=files,
            client=run.client,  # type: ignore[arg-type]
            link=run.link,  # type: ignore[arg-type]
            robot=str(tree / run.robot) if is_file else run.robot,
            setup=run.setup,
            quiet=True,
            **others,
        )


class RecordedInput:
    """The recorded standard input of a run, replayed."""

    def __init__(self, recording: Recording) -> None:
        """Read it; raise RecordingError if it is damaged."""
        self._pieces: dict[int, deque[bytes]] = {}
        self._waiting: dict[tuple[int, float], tuple[int, float]] = {}
        for _, data in recording.data(topics.INPUT.topic):
            with recording.errors():
                robot = int(data["robot"])
                if data.get("kind") == "stdin":
                    self._pieces.setdefault(robot, deque()).append(content_of(data))
                elif data.get("kind") == "waiting":
                    answer = int(data["ready"]), float(data["wait_s"])
                    self._waiting[robot, float(data["clock_s"])] = answer

    def waiting(self, robot: int, clock_s: float, _read: int = 0) -> tuple[int, float]:
        """Return the recorded state of a program's input at a time; its end if there is none."""
        return self._waiting.get((robot, clock_s), (0, 0.0))

    def read(self, robot: int, wanted: int) -> bytes:
        """Return a piece of a program's input; nothing at its end."""
        pieces = self._pieces.get(robot)
        if not pieces:
            return b""
        content = pieces.popleft()
        if len(content) > wanted:
            pieces.appendleft(content[wanted:])
        return content[:wanted]
