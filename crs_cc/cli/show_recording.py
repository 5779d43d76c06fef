"""What `crs replay` does with a recording."""

from __future__ import annotations

import json
import math
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Final

import click

from crs_cc.cli.inputs import is_animation
from crs_cc.cli.instants import recorded_instant
from crs_cc.cli.messages import printable, show
from crs_cc.cli.written_file import written_file
from crs_cc.core.errors import RecordingError, ReplayMismatch
from crs_cc.core.source import Diagnostic, Location
from crs_cc.debug.errors import DebugError
from crs_cc.recording import topics
from crs_cc.recording.content import content_of
from crs_cc.recording.frames import count_in
from crs_cc.recording.mcap_records import NS
from crs_cc.recording.recording import Recording

if TYPE_CHECKING:
    from crs_cc.cli.columnar import Form
    from crs_cc.cli.compare_recordings import Comparison
    from crs_cc.recording.recording import Roster

Export = Callable[[Recording, Path], None]

_SHOWN: Final = 20  # robots, lines or events
_BEFORE_S: Final = 1.0  # events shown before an instant
_SONARS: Final = slice(17, 33)  # of State, see the vendor's manual


def show_recording(
    path: Path,
    *,
    at_s: float | None,
    verify: bool,
    other: Path | None,
    mended: Path | None,
    **targets: Path | None,
) -> int:
    """Execute the options for a recording; without any, summarise it.

    Args:
        path: the recording.
        at_s: the time to show the state at [s].
        verify: whether to run it again.
        other: a recording to compare it with.
        mended: the file for what can be read.
        targets: files and folders to export to, by the names in `_EXPORTS`.

    Raises:
        CrsError: the recording is damaged, or its run takes another course now.
        OSError: a file cannot be read or written.
    """
    recording = _opened(path)
    try:
        if mended is not None:
            _recover(recording, mended)
            return 0
        if not recording.is_complete:
            text = f"the recording ends at {recording.end_ns / NS:.2f} s, before the end of the run"
            hint = "crs replay --recover FILE.mcap makes it readable for other programs"
            if recording.mcap.is_complete:  # as it was recovered
                hint = ""
            show([Diagnostic("warning", Location(str(path)), text, hint=hint)])
        if at_s is not None:
            _print(state_at(recording, recorded_instant(recording, at_s)))
        wanted = [(name, target) for name, target in targets.items() if target is not None]
        page = targets.get("page")
        for name, target in wanted:
            if target is not page or other is None:
                _EXPORTS[name](recording, target)
        if verify:
            _verify(recording)
        if other is not None:
            return _compare(recording, other, page)
        if not (verify or wanted) and at_s is None:
            _print(summary(recording))
    finally:
        recording.close()
    return 0


def _opened(path: Path) -> Recording:
    try:
        return Recording(path)
    except OSError as error:
        text = f"cannot be read: {error.strerror or error}"
        raise RecordingError.at(Location(str(path)), text) from None


def _print(lines: Iterator[str]) -> None:
    for line in lines:
        click.echo(printable(line))


def _write_plot(recording: Recording, path: Path) -> None:
    if is_animation(path):
        from crs_cc.cli.animation import write_animation

        with written_file(path):
            write_animation(recording, path)
        return
    from crs_cc.cli.recording_plot import recorded_picture

    picture = recorded_picture(recording).render()
    with written_file(path):
        path.write_bytes(picture)


def _write_tables(recording: Recording, folder: Path) -> None:
    from crs_cc.cli.tables import write_tables

    write_tables(recording, folder)


def _write_columnar(form: Form) -> Export:
    def write(recording: Recording, folder: Path) -> None:
        from crs_cc.cli.columnar import write_columnar

        write_columnar(recording, folder, form)

    return write


def _write_page(recording: Recording, path: Path) -> None:
    from crs_cc.cli.recording_plot import world_of
    from crs_cc.workbench.page import html_page

    page = html_page(recording, world_of(recording))
    with written_file(path):
        path.write_text(page, "utf-8", errors="replace")


def _write_compared(recording: Recording, other: Recording, found: Comparison, path: Path) -> None:
    """Write the page of a run that shows another one, too."""
    from crs_cc.cli.compare_recordings import exact_rows
    from crs_cc.cli.recording_plot import world_of
    from crs_cc.workbench.page import html_page
    from crs_cc.workbench.page_comparison import OtherRecording

    compared = OtherRecording(other, exact_rows(found))
    try:
        page = html_page(recording, world_of(recording), other=compared)
    except DebugError as error:
        raise RecordingError.at(Location(str(other.path)), str(error)) from None
    with written_file(path):
        path.write_text(page, "utf-8", errors="replace")


_EXPORTS: Final[dict[str, Export]] = {
    "plot": _write_plot,
    "tables": _write_tables,
    "parquet": _write_columnar("parquet"),
    "arrow": _write_columnar("arrow"),
    "page": _write_page,
}


def _verify(recording: Recording) -> None:
    from crs_cc.cli.verify import verify

    found = verify(recording)
    click.echo(
        f"{recording.path}: the same run: {found.hashes} hashes agree, {found.states} of them of"
        f" the complete state, up to {found.simulated_s:.2f} s"
    )


def _compare(recording: Recording, path: Path, page: Path | None) -> int:
    """Compare two recordings, also on a page if one is wanted; return the exit status."""
    from crs_cc.cli.compare_recordings import compare

    other = _opened(path)
    try:
        found = compare(recording, other, onward=page is not None)
        if page is not None:
            _write_compared(recording, other, found, page)
    finally:
        other.close()
    _print(comparison(found, (recording.path, path)))
    return ReplayMismatch.exit_status if found.found else 0


def comparison(found: Comparison, paths: tuple[Path, Path]) -> Iterator[str]:
    """Yield the lines of the comparison of two runs."""
    if not found.found:
        yield f"{paths[0]}, {paths[1]}: no difference up to {found.time_s:.2f} s"
        for path, end_s in zip(paths, found.ends_s, strict=True):
            if end_s > min(found.ends_s):
                yield f"  {path} continues to {end_s:.2f} s"
        return
    yield f"the first difference is at {found.time_s:.3f} s (timestep {found.timestep}):"
    yield f"  {paths[0]} | {paths[1]}"
    for each in found.found[:_SHOWN]:
        yield f"  {each.robot} {each.name}: {each.here or 'nothing'} | {each.there or 'nothing'}"
    if len(found.found) > _SHOWN:
        yield f"  ... and {len(found.found) - _SHOWN} more"
    yield f"to investigate, run: crs debug {paths[0]} --at {found.before_s:g}s"


def _recover(recording: Recording, target: Path) -> None:
    from crs_cc.recording.recovery import recover

    if target.exists() and target.samefile(recording.path):
        raise click.UsageError("--recover must name a file other than the damaged one.")
    with written_file(target):
        found = recover(recording, target)
    click.echo(
        f"{target}: {found.messages} messages in {found.chunks} chunks up to {found.end_s:.2f} s;"
        f" lost: {found.damaged} chunks, {found.lost_bytes} bytes at the end"
    )


def summary(recording: Recording) -> Iterator[str]:
    """Yield the lines of a summary."""
    run, versions = recording.description, recording.versions
    end_s, roster = recording.end_ns / NS, recording.rosters[-1]
    yield f"{recording.path}: {end_s:.2f} s simulated, {_count(len(roster.robots), 'robot')}"
    sources = " ".join(run.sources) or "named by the world"
    yield f"  program   {sources}{' -- ' if run.arguments else ''}{' '.join(run.arguments)}"
    yield f"  world     {run.world or 'empty'}, timestep {run.timestep_s:g} s, seed {run.seed}"
    yield f"  versions  {', '.join(f'{name} {value}' for name, value in versions.items())}"
    yield from _ends(recording, roster)
    yield from _goals(recording)
    frames = pieces = size = 0
    hashes = sum(1 for _ in recording.hashes())
    for message in recording.messages(topics.FRAME.topic):
        with recording.errors():
            frames += count_in(message.data)
    inputs = sum(1 for _ in recording.data(topics.INPUT.topic))
    counts = Counter(str(data.get("kind"))[:40] for _, data in recording.data(topics.EVENT.topic))
    for _, data in recording.data(topics.OUTPUT.topic):
        with recording.errors():
            size += len(content_of(data))
        pieces += 1
    yield f"  recorded  {_count(frames, 'frame')}, {hashes} hashes, {_count(inputs, 'input')}"
    events = ", ".join(f"{count} {kind}" for kind, count in sorted(counts.items()))
    yield f"  events    {events or 'none'}"
    yield f"  output    {_count(pieces, 'piece')}, {_count(size, 'byte')}"


def _ends(recording: Recording, roster: Roster) -> Iterator[str]:
    """Yield the outcomes of the programs."""
    if recording.result is None:
        return
    with recording.errors():
        ends = json.loads(recording.result.get("robots", "[]"))
        rows = [(str(outcome)[:20], status) for outcome, status in ends]
    for name, (outcome, status) in list(zip(roster.robots, rows, strict=False))[:_SHOWN]:
        yield f"  {name[:40]:9} {outcome}{'' if status is None else f' with {status}'}"
    if len(rows) > _SHOWN:
        yield f"  ... and {len(rows) - _SHOWN} more robots"


def _goals(recording: Recording) -> Iterator[str]:
    """Yield the status of the world's goals."""
    if recording.result is None:
        return
    with recording.errors():
        goals = json.loads(recording.result.get("goals", "[]"))
        rows = [
            (str(each["title"])[:80], str(each["status"])[:20], float(each["at_s"] or 0.0))
            for each in goals[:_SHOWN]
        ]
    for title, status, at_s in rows:
        yield printable(f"  goal      {title}: {status}{f' at {at_s:.2f} s' if at_s else ''}")


def state_at(recording: Recording, at_s: float) -> Iterator[str]:
    """Yield the lines that describe an instant."""
    at_ns = min(round(at_s * NS), recording.end_ns)
    frame = recording.frame_at(at_ns)
    if frame is None:
        yield f"{recording.path}: nothing is recorded at {at_s:g} s"
        return
    roster = recording.roster_at(frame.time_ns)
    believed = recording.frame_at(at_ns, topics.ODOMETRY.topic)
    yield f"{recording.path} at {at_ns / NS:.3f} s"
    names = (*roster.robots, *roster.objects)
    for row, name in enumerate(names[: frame.values.shape[1]][:_SHOWN]):
        x_m, y_m, heading_rad = (float(value) for value in frame.values[:3, row])
        if math.isnan(x_m):
            yield f"  {name[:40]:12} not in the world"
            continue
        line = f"  {name[:40]:12} x {x_m:.3f} m  y {y_m:.3f} m  heading {_degrees(heading_rad)}"
        if believed is not None and row < believed.values.shape[1]:
            x_m, y_m, heading_rad = (float(value) for value in believed.values[:, row])
            line += f"  odometry {x_m:.3f} m {y_m:.3f} m {_degrees(heading_rad)}"
        yield line
    if len(names) > _SHOWN:
        yield f"  ... and {len(names) - _SHOWN} more"
    yield from _last_readings(recording, at_ns, roster)
    since_ns = max(0, at_ns - round(_BEFORE_S * NS))
    lines = [
        f"  {time_ns / NS:9.3f} s  {_name(roster, data)}  {data.get('kind')}: {data.get('text')}"
        for time_ns, data in recording.data(topics.EVENT.topic, since_ns, at_ns)
    ]
    yield from lines[-_SHOWN:]
    yield from _last_output(recording, at_ns, roster)


def _last_readings(recording: Recording, at_ns: int, roster: Roster) -> Iterator[str]:
    last: dict[int, tuple[float, list[int]]] = {}
    for found in recording.readings(at_ns, at_ns):
        due = found.clock_s <= at_ns / NS
        rows = zip(found.robots[due], found.clock_s[due], found.states[due], strict=True)
        for robot, clock_s, state in rows:
            last[int(robot)] = float(clock_s), state[_SONARS].tolist()
    for robot, (clock_s, sonars) in sorted(last.items())[:_SHOWN]:
        name = roster.robots[robot][:40] if robot < len(roster.robots) else f"robot {robot}"
        yield f"  {name:12} read at {clock_s:.3f} s: sonar {' '.join(map(str, sonars))} in"


def _last_output(recording: Recording, at_ns: int, roster: Roster) -> Iterator[str]:
    """Yield the last lines that were printed in the ten seconds before."""
    since_ns = max(0, at_ns - 10 * NS)
    lines: list[str] = []
    for time_ns, data in recording.data(topics.OUTPUT.topic, since_ns, at_ns):
        with recording.errors():
            text = content_of(data).decode("utf-8", "replace")
        who = _name(roster, data)
        lines += [f"  {time_ns / NS:9.3f} s  {who}  {line}" for line in text.splitlines()[-5:]]
        del lines[:-5]
    yield from lines


def _name(roster: Roster, data: dict[str, object]) -> str:
    robot = data.get("robot")
    is_known = isinstance(robot, int) and 0 <= robot < len(roster.robots)
    return roster.robots[robot][:40] if is_known and isinstance(robot, int) else "-"


def _degrees(angle_rad: float) -> str:
    return f"{math.degrees(angle_rad) % 360:.1f} deg"


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}{'' if number == 1 else 's'}"
