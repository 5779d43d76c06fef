"""`crs run`: the command and its options; `cli.simulate` does the work."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any, Final

import click
from click.core import ParameterSource

from crs_cc.cli.inputs import check_plot_path, check_recording_path, is_animation, make_folder
from crs_cc.cli.network_options import network_options
from crs_cc.cli.path_options import written_file, written_folder
from crs_cc.cli.program_options import WithProgramArguments, program_options
from crs_cc.cli.record_options import record_options
from crs_cc.cli.run_options import RunOptions
from crs_cc.cli.time_options import MAX_TIME, SPEED

_EXAMPLES: Final = """
\b
Examples:
  crs run wander.c
  crs run wander.c room.xml --max-time 60 --plot path.svg
  crs run main.c turn.c office.xml -I include -D SPEED=80 -- fast 3
  crs run logger.c room.xml --file maps/room.txt --files out
  crs run wander.c room.xml --record run.mcap
  crs run wander.c room.xml --live --speed 1
  crs run server.c room.xml --forward 7000
  crs run wander.c room.xml --max-time 5 --json | jq .robots[0].pose
"""


@click.command(
    cls=WithProgramArguments,
    epilog=_EXAMPLES,
    short_help="Run C programs in a simulated world.",
    options_metavar="[OPTIONS]",
)
@MAX_TIME
@click.option(
    "--input",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    metavar="FILE",
    help="Send each line of FILE to the standard input of each robot's program at the simulated "
    "time given at the start of the line: '2.5s: forward\\n' sends 'forward' and a newline at "
    "2.5 s.",
)
@click.option(
    "--inputs",
    "changes",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    metavar="FILE",
    help="Change the run with the debugger commands in FILE, each preceded by the simulated time "
    "at which to execute it: '12.5s: degrade robot0 sonar.3 dead'. crs view writes such files.",
)
@written_file(
    "--plot",
    "Plot the world from above, with each robot's path, to FILE. Its extension selects the "
    "format: .svg for a picture, .gif or .apng for an animation.",
)
@click.option(
    "--plot-sensors",
    is_flag=True,
    help="Add the last readings of sonars and cameras to the plot.",
)
@click.option(
    "--trace",
    type=click.Choice(["requests", "messages"]),
    help="Trace to stderr either the request queue, with one line per robot and timestep "
    "(requests), or the messages between robots (messages).",
)
@click.option(
    "--json",
    "as_json",
    is_flag=True,
    help="Write the results to stdout as JSON; the programs' own stdout then goes to stderr.",
)
@click.option(
    "--threads",
    type=click.IntRange(1, 64),
    metavar="N",
    help="Use up to N threads to run programs and to simulate sensors, where this saves time; the "
    "number of threads does not affect the results. Default: the number of processors.",
)
@click.option(
    "--summary/--no-summary",
    default=None,
    help="Print a summary to stderr at the end of the run. Default: only on a terminal.",
)
@written_folder(
    "--csv", "Write poses.csv, sensors.csv, events.csv and messages.csv to DIR.", to="tables"
)
@SPEED
@network_options
@click.option(
    "--live",
    is_flag=True,
    help="Draw a map in the terminal while the programs run; see also --speed.",
)
@click.option(
    "--view",
    is_flag=False,
    flag_value=0,
    type=click.IntRange(0, 65535),
    metavar="[PORT]",
    help="Also show the run in the browser, as crs view does: serve it on PORT, or on any free "
    "port, and print the local URL. The page can pause the run and set its speed.",
)
@record_options
@click.option("-q", "--quiet", is_flag=True, help="Report errors only; no warnings, no summary.")
@program_options
def run(**options: Any) -> int:
    """Compile a C control program and run it in a simulated world.

    Several C files are compiled as one program. In a world with several robots, each robot runs the
    program specified for it in the world file or, if there is none, the one given on the command
    line. Without a world file, there is one robot in an empty world. Arguments after -- are passed
    to the program's main.

    The programs share the stdin, stdout and stderr of crs; with several robots, each line of output
    starts with the robot's name. With one robot, the exit status is that of its program; with
    several, it is 0 if all programs exited with 0, otherwise 1. A program still running at
    --max-time counts as having exited with 0.
    """
    run_options = RunOptions(**options)
    if run_options.machines or run_options.forwards:
        source = click.get_current_context().get_parameter_source("speed")
        if source is ParameterSource.DEFAULT:
            run_options = replace(run_options, speed=1.0)
    for path in run_options.inputs.sources:
        if path.suffix.lower() == ".mcap":
            raise click.UsageError(f"{path} is a recording: crs view, replay and debug show it.")
    if run_options.plot is not None:
        check_plot_path(run_options.plot)
        if run_options.plot_sensors and is_animation(run_options.plot):
            raise click.UsageError("--plot-sensors is for SVG plots.")
    if run_options.tables is not None:
        make_folder(run_options.tables)
    if run_options.record is not None:
        check_recording_path(run_options.record)
    from crs_cc.cli.simulate import simulate

    return simulate(run_options)
