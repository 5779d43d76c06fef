"""What is run, in which world, and how: the arguments and options of every command that runs."""

from __future__ import annotations

import functools
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final, Literal

import click

from crs_cc.cli.compiler_options import CompilerOptions, compiler_options
from crs_cc.cli.inputs import Inputs, make_folder, name_files, sort_files

if TYPE_CHECKING:
    from crs_cc.session.host import Client

_ARGUMENTS: Final = "crs.arguments"


@dataclass(frozen=True, slots=True)
class ProgramOptions:
    """What to run, and how.

    Attributes:
        inputs: the C files and the world.
        arguments: what `main` finds behind `argv[0]`.
        compiler: how to compile.
        checked: with checks of every memory access.
        trap_overflow: stop a program at signed overflow.
        seed: start of all random numbers; None for the world's, else 0.
        inputs_on_disk: files that the programs can read, by the names that they have for them.
        outputs: the folder that takes the files that the programs write; None to drop them.
        client: which of the vendor's client libraries the programs find.
        link: `ideal` for commands that take no time on the line between host and robot.
        robot: the kind of the robots of which the world says none: a name, or a definition file.
        setup: the setup of all robots, such as `noisy`; empty for what the world says.
        quiet: say nothing but errors.
    """

    inputs: Inputs
    arguments: tuple[str, ...] = ()
    compiler: CompilerOptions = field(default_factory=CompilerOptions)
    checked: bool = True
    trap_overflow: bool = False
    seed: int | None = None
    inputs_on_disk: Mapping[str, Path] = field(default_factory=dict)
    outputs: Path | None = None
    client: Client = "nclient"
    link: Literal["serial", "ideal"] = "serial"
    robot: str = "scout"
    setup: str = ""
    quiet: bool = False


class WithProgramArguments(click.Command):
    """A command whose arguments behind `--` belong to the control program."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Set the program's arguments aside, and parses the others."""
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


_FILES: Final = "PROGRAM.c... [WORLD.xml] [-- ARGS...]"

_OPTIONS: Final = (
    click.option(
        "--seed", type=click.IntRange(min=0), metavar="N",
        help="Start of all random numbers: the same seed gives the same run; by default the world "
        "file's, else 0.",
    ),
    click.option(
        "--file", "named_files", multiple=True, metavar="[NAME=]FILE",
        help="Let the programs read a file, under its own path or as NAME; may be given again.",
    ),
    click.option(
        "--files", "outputs", type=click.Path(file_okay=False, path_type=Path), metavar="DIR",
        help="Keep the files that the programs write; of several robots in DIR/ROBOT.",
    ),
    click.option(
        "--robot", default="scout", show_default=True, metavar="NAME|FILE.xml",
        help="The kind of robot where the world file says none, such as nomad200.",
    ),
    click.option(
        "--setup", default="", metavar="NAME",
        help="Give all robots one of their definition's setups: ideal, or noisy with errors.",
    ),
    click.option(
        "--link", type=click.Choice(["serial", "ideal"]), default="serial", show_default=True,
        help="Let commands take their time on the line to the robot, or next to none.",
    ),
    click.option(
        "--client", type=click.Choice(["nclient", "ndirect"]), default="nclient",
        show_default=True,
        help="Behave like the vendor's library for the simulator, or for the robot itself.",
    ),
    click.option(
        "--unchecked", is_flag=True, help="Leave out the checks of memory accesses: faster."
    ),
    click.option(
        "--trap-overflow", is_flag=True, help="Stop a program whose signed arithmetic overflows."
    ),
)  # fmt: skip


def program_options(command: Callable[..., Any], *, needs_files: bool = True) -> Callable[..., Any]:
    """Return a command these arguments and options, which it takes as fields of `ProgramOptions`.

    Args:
        command: the function of a `WithProgramArguments`.
        needs_files: whether at least one file has to be named.
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
        inputs, inputs_on_disk = sort_files(files), name_files(named_files)
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
