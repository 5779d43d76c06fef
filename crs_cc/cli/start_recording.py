"""From the options of a command to a recorder of its run."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import click

from crs_cc.cli.written_file import written_file
from crs_cc.core.suggest import unknown
from crs_cc.frontend.preprocess.regular_file import read_regular_file
from crs_cc.net.vendor.relay import RELAY
from crs_cc.recording.description import RunDescription, program_row
from crs_cc.recording.recorder import Recorder, RecorderOptions
from crs_cc.recording.source_tree import INPUTS, SOURCES, SourceTree

if TYPE_CHECKING:
    from crs_cc.cli.debug_options import DebugOptions
    from crs_cc.cli.load import Loaded
    from crs_cc.cli.program_options import ProgramOptions
    from crs_cc.cli.run_options import RunOptions


def start_recording(
    loaded: Loaded,
    options: RunOptions | DebugOptions,
    seed: int,
    max_time_s: float = 0.0,
    roots: Mapping[Path, str] | None = None,
    *,
    for_debugger: bool = False,
) -> Recorder:
    """Create the file of a recording, and return its recorder.

    Args:
        loaded: the world and the programs.
        options: how to run and to record them.
        seed: the random seed.
        max_time_s: when the run was to end [s]; 0 for never.
        roots: the folders of its files, with their names in the recording, see `SourceTree.of`.
        for_debugger: see `RunDescription`.

    Raises:
        OSError: it cannot be written.
    """
    assert options.record is not None
    files = dict(loaded.files_read)
    for path in loaded.compiled:
        content = read_regular_file(path)
        if isinstance(content, bytes):
            files[path] = content
    tree = SourceTree.of(files, options.compiler.include_paths, roots)
    if RELAY in options.inputs.sources:  # ours, but another version may have another one
        roots = {RELAY.parent: "relay", **tree.roots}
        files[RELAY] = RELAY.read_bytes()
        tree = SourceTree.of(files, roots=roots)
    attachments = {f"{SOURCES}{name}": content for name, content in tree.contents.items()}
    attachments |= {f"{INPUTS}{name}": content for name, content in loaded.files.items()}
    description = _description(options, tree, loaded, seed, max_time_s)
    frame_s = max(options.record_every_s, loaded.world.timestep_s)
    description = replace(description, frame_s=frame_s, for_debugger=for_debugger)
    known = [robot.id for robot in loaded.world.robots]
    for name in options.foxglove_robots:
        if name not in known:
            raise click.UsageError(f"--foxglove-robot: {unknown('robot', name, known)}.")
    wanted = RecorderOptions(
        options.record_every_s,
        options.record_sensors,
        foxglove=options.foxglove or bool(options.foxglove_robots),
        foxglove_robots=options.foxglove_robots,
        for_debugger=for_debugger,
    )
    with written_file(options.record):
        return Recorder(options.record, wanted, description.metadata(), attachments)


def _description(
    options: ProgramOptions, tree: SourceTree, loaded: Loaded, seed: int, max_time_s: float
) -> RunDescription:
    compiler, world = options.compiler, options.inputs.world
    return RunDescription(
        sources=tuple(map(tree.name, options.inputs.sources)),
        world=tree.name(world) if world is not None else "",
        arguments=options.arguments,
        programs=tuple(
            program_row(robot, [*map(tree.name, own.sources)], own.arguments)
            for robot, own in sorted(options.programs.items())
        ),
        include_paths=tuple(map(tree.name, compiler.include_paths)),
        defines=compiler.defines,
        undefines=compiler.undefines,
        standard=compiler.standard,
        dialect=compiler.dialect or "",
        checked=options.checked,
        trap_overflow=options.trap_overflow,
        seed=seed,
        client=options.client,
        link=options.link,
        robot=tree.name(Path(options.robot)) if options.robot.endswith(".xml") else options.robot,
        setup=options.setup,
        files=tuple(loaded.files),
        max_time_s=max_time_s,
        timestep_s=loaded.world.timestep_s,
    )
