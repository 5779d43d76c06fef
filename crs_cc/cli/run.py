"""`crs run`: the options of a run. What it does stands in `cli.simulate`."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final, Literal

import click

from crs_cc.cli.compiler_options import CompilerOptions, compiler_options
from crs_cc.cli.inputs import Inputs, demand_picture, make_folder, name_files, sort_files

if TYPE_CHECKING:
    from crs_cc.session.host import Client

_ARGUMENTS = "crs.arguments"


@dataclass(frozen=True, slots=True)
class RunOptions:
    """What to run, how, and what to show of it.

    Attributes:
        inputs: the C files and the world.
        arguments: what `main` finds behind `argv[0]`.
        compiler: how to compile.
        checked: with checks of every memory access.
        trap_overflow: stop a program at signed overflow.
        seed: start of all random numbers; None for the world's, else 0.
        max_time_s: stop at the first timestep that ends at or after it [s]; None for the world's,
            else no end.
        plot: the picture to draw.
        plot_sensors: whether it shows what sensors told last, too.
        inputs_on_disk: files that the programs can read, by the names that they have for them.
        outputs: the folder that takes the files that the programs write; None to drop them.
        client: which of the vendor's client libraries the programs find.
        link: `ideal` for commands that take no time on the line between host and robot.
        robot: the kind of the robots of which the world says none: a name, or a definition file.
        setup: the setup of all robots, such as `noisy`; empty for what the world says.
        trace: what to show of each timestep: `requests`, the request queue, or `messages`.
        as_json: give the results as JSON on stdout.
        quiet: say nothing but errors.
        summary: show the summary; None to decide by whether stderr is a terminal.
    """

    inputs: Inputs
    arguments: tuple[str, ...] = ()
    compiler: CompilerOptions = field(default_factory=CompilerOptions)
    checked: bool = True
    trap_overflow: bool = False
    seed: int | None = None
    max_time_s: float | None = None
    plot: Path | None = None
    plot_sensors: bool = False
    inputs_on_disk: Mapping[str, Path] = field(default_factory=dict)
    outputs: Path | None = None
    client: Client = "nclient"
    link: Literal["serial", "ideal"] = "serial"
    robot: str = "scout"
    setup: str = ""
    trace: str | None = None
    as_json: bool = False
    quiet: bool = False
    summary: bool | None = None


class _WithProgramArguments(click.Command):
    """A command whose arguments behind `--` belong to the control program."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        if "--" in args:
            own = args[: args.index("--")]
            ctx.meta[_ARGUMENTS] = tuple(args[len(own) + 1 :])
            return super().parse_args(ctx, own)
        try:
            return super().parse_args(ctx, list(args))
        except click.NoSuchOption as error:
            if not any(each.endswith(".c") for each in args):
                raise
            text = f"{error.format_message()} Options of the program itself stand behind --."
            raise click.UsageError(text, ctx) from None


_EXAMPLES: Final = """
\b
Examples:
  crs run wander.c
  crs run wander.c room.xml --max-time 60 --plot path.svg
  crs run main.c turn.c office.xml -I include -D SPEED=80 -- fast 3
  crs run logger.c room.xml --file maps/room.txt --files out
  crs run wander.c room.xml --max-time 5 --json | jq .robots[0].pose
"""


def _time(_ctx: click.Context, _option: click.Parameter, time_s: float | None) -> float | None:
    if time_s is not None and math.isnan(time_s):
        raise click.BadParameter("nan is not a time.")
    return time_s


@click.command(
    cls=_WithProgramArguments,
    epilog=_EXAMPLES,
    short_help="Run C programs in a simulated world.",
    options_metavar="[OPTIONS]",
)
@click.argument("files", nargs=-1, required=True, metavar="PROGRAM.c... [WORLD.xml] [-- ARGS...]")
@click.option(
    "--max-time",
    "max_time_s",
    type=click.FloatRange(min=0, min_open=True),
    callback=_time,
    metavar="S",
    help="Stop at the first timestep that ends at or after S seconds of simulated time; "
    "by default at the world file's duration.",
)
@click.option(
    "--seed",
    type=click.IntRange(min=0),
    metavar="N",
    help="Start of all random numbers: the same seed gives the same run; by default the world "
    "file's, else 0.",
)
@click.option(
    "--plot",
    type=click.Path(dir_okay=False, path_type=Path),
    metavar="FILE.svg",
    help="Draw the world from above with each robot's path.",
)
@click.option(
    "--plot-sensors",
    is_flag=True,
    help="Draw also what sonars and cameras told last.",
)
@click.option(
    "--file",
    "named_files",
    multiple=True,
    metavar="[NAME=]FILE",
    help="Let the programs read a file, under its own path or as NAME; may be given again.",
)
@click.option(
    "--files",
    "outputs",
    type=click.Path(file_okay=False, path_type=Path),
    metavar="DIR",
    help="Keep the files that the programs write; of several robots in DIR/ROBOT.",
)
@click.option(
    "--robot",
    default="scout",
    show_default=True,
    metavar="NAME|FILE.xml",
    help="The kind of robot where the world file says none, such as nomad200.",
)
@click.option(
    "--setup",
    default="",
    metavar="NAME",
    help="Give all robots one of their definition's setups: ideal, or noisy with errors.",
)
@click.option(
    "--link",
    type=click.Choice(["serial", "ideal"]),
    default="serial",
    show_default=True,
    help="Let commands take their time on the line to the robot, or next to none.",
)
@click.option(
    "--client",
    type=click.Choice(["nclient", "ndirect"]),
    default="nclient",
    show_default=True,
    help="Behave like the vendor's library for the simulator, or for the robot itself.",
)
@click.option(
    "--trace",
    type=click.Choice(["requests", "messages"]),
    help="Show the request queue on stderr, a line per robot and timestep; or what becomes of "
    "messages between robots.",
)
@click.option(
    "--json",
    "as_json",
    is_flag=True,
    help="Write the results to stdout as JSON; the programs' own stdout then goes to stderr.",
)
@click.option(
    "--summary/--no-summary",
    default=None,
    help="Show the closing summary on stderr; by default only on a terminal.",
)
@click.option(
    "-q", "--quiet", is_flag=True, help="Say nothing but errors; no warnings, no summary."
)
@click.option("--unchecked", is_flag=True, help="Leave out the checks of memory accesses: faster.")
@click.option(
    "--trap-overflow", is_flag=True, help="Stop a program whose signed arithmetic overflows."
)
@compiler_options
@click.pass_context
def run(
    ctx: click.Context,
    /,
    files: Sequence[str],
    compiler: CompilerOptions,
    *,
    named_files: Sequence[str],
    unchecked: bool,
    **others: Any,
) -> int:
    """Compiles a C control program, and runs it in a simulated world.

    Several C files make one program. In a world with several robots each runs the program that
    the world file names for it, else the one given here. Without a world file there is one robot
    in an empty world. What stands behind -- goes to the program's main.

    The programs read our stdin and write to our stdout and stderr; with several robots each line
    starts with the robot's name. The exit status is the program's own with one robot; with
    several it is 0 if all ended with 0, else 1. A program still running at --max-time counts as 0.
    """
    options = RunOptions(
        inputs=sort_files(files),
        arguments=ctx.meta.get(_ARGUMENTS, ()),
        compiler=compiler,
        checked=not unchecked,
        inputs_on_disk=name_files(named_files),
        **others,
    )
    if options.plot is not None:
        demand_picture(options.plot)
    if options.outputs is not None:
        make_folder(options.outputs)
    from crs_cc.cli.simulate import simulate

    return simulate(options)
