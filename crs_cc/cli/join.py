"""`crs join`: the command and its options; `run_host` does the work."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Final

import click

from crs_cc.cli.compiler_options import compiler_options
from crs_cc.cli.inputs import is_world, sort_files
from crs_cc.cli.net_address import TOKEN_VARIABLE, hint_of, is_net_address, parse_address
from crs_cc.cli.program_options import WithProgramArguments, program_arguments
from crs_cc.cli.serve_options import JoinOptions

_EXAMPLES: Final = """
\b
Examples:
  crs join robot0 127.0.0.1:8000 wander.c
  crs join robot1,robot2 procyon:8000 convoy.c --token TOKEN -- fast 3
  crs join --all procyon:8000 wander.c             for all robots without a program
"""


@click.command(
    cls=WithProgramArguments,
    epilog=_EXAMPLES,
    short_help="Run a robot's program in a world served by crs serve.",
    options_metavar="[OPTIONS]",
)
@click.argument("words", nargs=-1, metavar="ROBOT[,ROBOT...] HOST:PORT PROGRAM.c... [-- ARGS...]")
@click.option("--all", "every", is_flag=True, help="Run the program for all robots that have none.")
@click.option(
    "--token",
    metavar="TOKEN",
    help="The robot token that crs serve prints. Default: the environment variable "
    f"{TOKEN_VARIABLE}, or the token of your own run on this machine.",
)
@click.option(
    "--tls", is_flag=True, help="Encrypt, and require a certificate that this system trusts."
)
@click.option(
    "--fingerprint",
    default="",
    metavar="HEX",
    help="Encrypt, and require the certificate with this fingerprint, which crs serve prints.",
)
@click.option(
    "--robot",
    "model",
    metavar="NAME|FILE.xml",
    help="Join only if the robots have this definition.",
)
@click.option(
    "--retry",
    "retry_s",
    type=click.FloatRange(min=0.0, max=1e6),
    default=10.0,
    show_default=True,
    metavar="S",
    help="Keep trying to connect for S seconds, initially and after the connection is lost.",
)
@click.option(
    "--threads",
    type=click.IntRange(1, 64),
    metavar="N",
    help="Run programs in N threads. Default: one, or one per processor if they compute for long.",
)
@click.option(
    "--unchecked", is_flag=True, help="Do not check memory accesses; programs run faster."
)
@click.option("--trap-overflow", is_flag=True, help="Stop a program on signed integer overflow.")
@click.option("-q", "--quiet", is_flag=True, help="Report errors only; no warnings.")
@compiler_options
def join(
    *, words: tuple[str, ...], every: bool, unchecked: bool, model: str | None, **options: Any
) -> int:
    """Compile a C control program and run it for a robot in a world served by crs serve.

    The program runs, prints and reads standard input here. If the connection is lost, or another
    host takes the place of this one, the program continues where it left off. The exit status is
    that of the program; with several robots, it is 0 if all exited with 0, otherwise 1.
    """
    if any(map(is_net_address, words[:2])):
        at = next(index for index, word in enumerate(words) if is_net_address(word))
    else:
        named = words[0 if every else 1 :][:1]
        text, hint = (f"{named[0]!r} is not an", hint_of(named[0])) if named else ("no", "")
        raise click.UsageError(f"{text} address HOST:PORT of an environment{hint}.")
    if every == bool(at):
        raise click.UsageError("name the robots before the address, or give --all.")
    names = words[0].split(",") if at else []
    if len(set(names)) < len(names):
        twice = next(name for name in names if names.count(name) > 1)
        raise click.UsageError(f"{twice} is named twice.")
    files = words[at + 1 :]
    if any(map(is_world, files)):
        raise click.UsageError("the world is the environment's: name C files only.")
    if not files:
        raise click.UsageError("no C file.")
    wanted = JoinOptions(
        inputs=sort_files(files),
        arguments=program_arguments(),
        checked=not unchecked,
        address=parse_address(words[at]),
        robots=tuple(names),
        definition=_definition(model),
        **options,
    )
    from crs_cc.cli.run_host import run_host

    return run_host(wanted)


def _definition(model: str | None) -> str:
    if model is None:
        return ""
    from crs_cc.net.handshake import definition_of
    from crs_cc.session.empty_world import empty_world
    from crs_cc.sim.files.known_robots import known_robots

    if model not in known_robots() and not Path(model).is_file():
        names = ", ".join(known_robots())
        raise click.UsageError(f"unknown robot '{model}' (known: {names}, or an .xml file).")
    return definition_of(empty_world("", model).robots[0].model)
