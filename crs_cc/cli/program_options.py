"""The arguments and options of every command that runs programs."""

from __future__ import annotations

import functools
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

import click

from crs_cc.cli.compiler_options import CompilerOptions, compiler_options
from crs_cc.cli.gcc_options import CompilerCommand
from crs_cc.cli.inputs import Inputs, make_folder, parse_named_files, sort_files

if TYPE_CHECKING:
    from crs_cc.session.host import Client, Link

_ARGUMENTS: Final = "crs.arguments"


@dataclass(frozen=True, slots=True)
class RobotProgram:
    """The program of one robot.

    Attributes:
        sources: its C files.
        arguments: `argv` after `argv[0]`.
    """

    sources: tuple[Path, ...]
    arguments: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class ProgramOptions:
    """Options of every command that runs a program.

    Attributes:
        inputs: the C files and the world.
        arguments: `argv` after `argv[0]`.
        programs: C files and arguments of robots that have programs of their own, by name.
        compiler: how to compile.
        checked: check every memory access.
        trap_overflow: stop a program at signed overflow.
        seed: random seed; None for the world's, else 0.
        inputs_on_disk: files that the programs can read, by the names that they use.
        outputs: the folder for files that the programs write; None to discard them.
        client: which of the vendor's client libraries to emulate.
        link: `serial` to simulate the serial link's delay, `ideal` for none.
        robot: the default robot model: a name or a definition file.
        setup: the setup of all robots, such as `noisy`; empty for the world's.
        quiet: report errors only.
    """

    inputs: Inputs
    arguments: tuple[str, ...] = ()
    programs: Mapping[str, RobotProgram] = field(default_factory=dict)
    compiler: CompilerOptions = field(default_factory=CompilerOptions)
    checked: bool = True
    trap_overflow: bool = False
    seed: int | None = None
    inputs_on_disk: Mapping[str, Path] = field(default_factory=dict)
    outputs: Path | None = None
    client: Client = "nclient"
    link: Link = "serial"
    robot: str = "scout"
    setup: str = ""
    quiet: bool = False


class WithProgramArguments(CompilerCommand):
    """A command whose arguments after `--` belong to the control program."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Set the program's arguments aside, and parse the others."""
        if "--" in args:
            own = args[: args.index("--")]
            ctx.meta[_ARGUMENTS] = tuple(args[len(own) + 1 :])
            return super().parse_args(ctx, own)
        try:
            return super().parse_args(ctx, list(args))
        except click.NoSuchOption as error:
            if not any(each.endswith(".c") for each in args):
                raise
            text = f"{error.format_message()} Options of the program itself follow --."
            raise click.UsageError(text, ctx) from None


def program_arguments() -> tuple[str, ...]:
    """Return the arguments after `--` of the command that is being run."""
    found: tuple[str, ...] = click.get_current_context().meta.get(_ARGUMENTS, ())
    return found


READS: Final = click.option(
    "--file", "named_files", multiple=True, metavar="[NAME=]FILE",
    help="Make FILE readable by the programs, at its own path or as NAME; may be repeated.",
)  # fmt: skip
"""The option of what programs can read."""

WRITES: Final = click.option(
    "--files", "outputs", type=click.Path(file_okay=False, path_type=Path), metavar="DIR",
    help="Save to DIR the files that the programs write; with several robots, to DIR/ROBOT.",
)  # fmt: skip
"""The option that determines where the files that programs write are kept."""

SEED: Final = click.option(
    "--seed", type=click.IntRange(min=0), metavar="N",
    help="Random seed: the same seed reproduces a run. Default: the world file's, else 0.",
)  # fmt: skip
"""The option of the random seed."""

_ROBOT_OPTIONS: Final = (
    click.option(
        "--robot", default="scout", show_default=True, metavar="NAME|FILE.xml",
        help="Robot model, such as nomad200, for robots whose model the world does not specify.",
    ),
    click.option(
        "--setup", default="", metavar="NAME",
        help="Named set of parameters (setup) to use from each robot definition: ideal (no "
        "errors) or noisy (sensor and odometry errors).",
    ),
    click.option(
        "--link", type=click.Choice(["serial", "ideal"]), default="serial", show_default=True,
        help="Simulate the serial link's delay (serial) or no delay (ideal).",
    ),
    click.option(
        "--client", type=click.Choice(["nclient", "ndirect"]), default="nclient",
        show_default=True,
        help="Nomadic client library to emulate: the one for Nomadic's simulator (nclient) or for "
        "the robot (ndirect).",
    ),
)  # fmt: skip

_FILES: Final = "PROGRAM.c... [WORLD.xml] [-- ARGS...]"

_OPTIONS: Final = (
    SEED,
    READS,
    WRITES,
    *_ROBOT_OPTIONS,
    click.option(
        "--unchecked", is_flag=True, help="Do not check memory accesses; programs run faster."
    ),
    click.option(
        "--trap-overflow", is_flag=True, help="Stop a program on signed integer overflow."
    ),
)  # fmt: skip


def robot_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Add the options for the robots of a run to a command."""
    for option in reversed(_ROBOT_OPTIONS):
        command = option(command)
    return command


def program_options(command: Callable[..., Any], *, needs_files: bool = True) -> Callable[..., Any]:
    """Add these arguments and options to a command, which receives fields of `ProgramOptions`.

    Args:
        command: the function of a `WithProgramArguments`.
        needs_files: whether at least one file is required.
    """

    @functools.wraps(command)
    @click.pass_context
    def with_options(
        ctx: click.Context,
        /,
        files: Sequence[str],
        named_files: Sequence[str],
        *,
        unchecked: bool,
        outputs: Path | None,
        **others: Any,
    ) -> Any:
        inputs, inputs_on_disk = sort_files(files), parse_named_files(named_files)
        if outputs is not None:
            make_folder(outputs)
        return command(
            inputs=inputs,
            arguments=ctx.meta.get(_ARGUMENTS, ()),
            inputs_on_disk=inputs_on_disk,
            checked=not unchecked,
            outputs=outputs,
            **others,
        )

    wrapped = compiler_options(with_options)
    for option in reversed(_OPTIONS):
        wrapped = option(wrapped)
    return click.argument("files", nargs=-1, required=needs_files, metavar=_FILES)(wrapped)
