"""`crs serve`: the command and its options; `start_serve` does the work."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any, Final, Literal

import click
from click.core import ParameterSource

from crs_cc.cli.inputs import Inputs, check_recording_path, is_world, make_folder, parse_named_files
from crs_cc.cli.net_address import parse_address
from crs_cc.cli.path_options import written_folder
from crs_cc.cli.program_options import READS, SEED, WRITES, robot_options
from crs_cc.cli.record_options import record_options
from crs_cc.cli.serve_options import ServeOptions
from crs_cc.cli.time_options import MAX_TIME, SPEED
from crs_cc.cli.vendor_options import vendor_options

_EXAMPLES: Final = """
\b
Examples:
  crs serve complex-3r.xml                               for hosts on this machine
  crs serve complex-3r.xml --listen 0.0.0.0:8000 --insecure
  crs serve complex-3r.xml --record run.mcap --max-time 60
  crs serve complex-3r.xml --nserver 7019                for programs linked with Nclient
  crs join robot0 procyon:8000 prog.c                    a robot's program, on any machine
"""


_FOR_HOSTS: Final = ("listen", "tokens", "tls", "tls_cert", "tls_key", "on_loss", "resume")


def _serve_vendor(options: ServeOptions) -> int:
    """Serve programs that are linked with the vendor's libraries; return the exit status.

    Raises:
        click.UsageError: an option is about hosts, which there are none of.
    """
    from crs_cc.cli.start_vendor import start_vendor

    context = click.get_current_context()
    given = {
        name
        for name in (*_FOR_HOSTS, "speed")
        if context.get_parameter_source(name) is not ParameterSource.DEFAULT
    }
    for name in _FOR_HOSTS:
        if name in given:
            option = f"--{name.replace('_', '-')}"
            raise click.UsageError(f"{option} is for programs that join, not for the vendor's.")
    return start_vendor(options if "speed" in given else replace(options, speed=1.0))


def _address(_ctx: click.Context, _option: click.Parameter, text: str) -> tuple[str, int]:
    return parse_address(text)


@click.command(
    epilog=_EXAMPLES,
    short_help="Serve a world to programs that run on other machines.",
    options_metavar="[OPTIONS]",
)
@click.argument("world", metavar="WORLD.xml", type=click.Path(path_type=Path))
@click.option(
    "--listen",
    default="127.0.0.1:8000",
    show_default=True,
    metavar="HOST:PORT",
    callback=_address,
    help="Where hosts and viewers connect; port 0 stands for any that is free. Other machines "
    "reach it at 0.0.0.0.",
)
@click.option(
    "--tokens",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    metavar="FILE",
    help="Who may do what: lines of a role (robot, view or control) and a token. Default: new "
    "tokens, which are printed.",
)
@click.option(
    "--tls",
    is_flag=True,
    help="Encrypt, with a certificate made at start whose fingerprint is printed.",
)
@click.option(
    "--tls-cert",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    metavar="FILE",
    help="Encrypt with this certificate (PEM).",
)
@click.option(
    "--tls-key",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    metavar="FILE",
    help="The key of the certificate (PEM).",
)
@click.option(
    "--insecure",
    is_flag=True,
    help="Listen to other machines without TLS: tokens and programs can be read on the way.",
)
@click.option(
    "--on-loss",
    type=click.Choice(["wait", "stop"]),
    default="wait",
    show_default=True,
    help="When a host is lost: wait for another one, which goes on where it stood, or stop its "
    "programs and hold its robots.",
)
@click.option(
    "--resume",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    metavar="FILE.mcap",
    help="Go on where the recording of an environment ends that was killed: run to there again, "
    "compare the hashes, and go on. Give the other options and programs as before.",
)
@click.option(
    "--view/--no-view",
    "shows",
    default=True,
    help="Let pages look at the run, on the same port (default): crs view HOST:PORT opens one. "
    "Without, timesteps in which nothing happens are skipped.",
)
@vendor_options
@MAX_TIME
@SEED
@SPEED
@READS
@WRITES
@robot_options
@record_options
@written_folder(
    "--csv", "Write poses.csv, sensors.csv, events.csv and messages.csv to DIR.", to="tables"
)
@click.option("--json", "as_json", is_flag=True, help="Write the results to stdout as JSON.")
@click.option(
    "--summary/--no-summary",
    default=None,
    help="Show the closing summary on stderr. Default: only on a terminal.",
)
@click.option("-q", "--quiet", is_flag=True, help="Report errors only; no warnings, no summary.")
def serve(
    world: Path,
    *,
    named_files: tuple[str, ...],
    outputs: Path | None,
    on_loss: Literal["wait", "stop"],
    shows: bool,
    **options: Any,
) -> int:
    """Run a world whose robots' programs are on other machines, or in other processes.

    The run begins when all robots have their programs, by crs join, and is the same as by crs run:
    to the bit, whatever the number of hosts, their speed and the order in which they come. Files
    that programs read and write are here; what they print appears where they run. The exit status
    is that of crs run.

    With --nserver, --serial or --tcp-robot, all robots are driven by programs that are linked with
    the vendor's own client libraries, in real time unless --speed says otherwise.
    """
    if not is_world(world.name):
        raise click.UsageError(f"{world} is not a world file: its name ends with .xml.")
    if outputs is not None:
        make_folder(outputs)
    wanted = ServeOptions(
        inputs=Inputs((), world),
        inputs_on_disk=parse_named_files(named_files),
        outputs=outputs,
        on_loss=on_loss,
        view=0 if shows else None,
        **options,
    )
    if wanted.tables is not None:
        make_folder(wanted.tables)
    if wanted.record is not None:
        check_recording_path(wanted.record)
        if wanted.resume is not None and wanted.record.resolve() == wanted.resume.resolve():
            raise click.UsageError("--record and --resume name the same file.")
    if wanted.vendor:
        return _serve_vendor(wanted)
    from crs_cc.cli.export_run import recorded
    from crs_cc.cli.start_serve import start_serve

    with recorded(wanted) as run:
        return start_serve(run)
